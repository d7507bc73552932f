! SPDX-License-Identifier: GPL-3.0-or-later
!> The memory of a viscoelastic body (theory/time.md (5.1), (5.2)): w^(k, t) = c(k, .) * dq^(k, .), with
!>     c(k; s) = 1/E0*(s) + c~(k; s),    1/E0* = J_g + sum J_l/(1 + s th_l),    c~ = X_g(k) + sum R_m(k)/(1 + s th_m).
!>
!> The first part is local in x. The times of the second are common to all k, spread over those of the materials, and R_m(k) are
!> found by least squares from elastic compliances at real s.
module mdrcontact_time_memory
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: normal_load
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgels
    use mdrcontact_material_prony, only: creep_of, creep_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: memory_t, new_memory

    !> Nodes in a panel of wavenumbers, the phase that a panel resolves, and what chi may be beyond the last one.
    integer, parameter :: panel_nodes = 16
    real(wp), parameter :: largest_phase = 8.0_wp, negligible = 1.0e-15_wp
    !> Largest difference of a panel from its halves, relative; panels at most; and at how many s that is seen.
    real(wp), parameter :: allowed_difference = 1.0e-12_wp
    integer, parameter :: most_panels = 400, looks = 8
    !> Beyond all times of all materials.
    real(wp), parameter :: at_once = 1.0e18_wp
    !> Longest panel of x, of so many nodes too, in thicknesses of the first layer.
    real(wp), parameter :: in_thicknesses = 2.0_wp
    !> Numbers of common times to try, and the range beyond them and the density with which the transform is sampled.
    integer, parameter :: counts(*) = [6, 10, 14, 18, 24, 32, 40, 52, 64, 80]
    integer, parameter :: samples_per_time = 4
    real(wp), parameter :: beyond = 30.0_wp
    !> Times longer than the history in these units are merged.
    real(wp), parameter :: slow = 1000.0_wp
    !> Relative error that rounding leaves of the transform.
    real(wp), parameter :: reachable = 1.0e-12_wp
    !> Rounding of chi, the term added to 1: where layers hardly differ, chi is as small, and its misfit is seen against
    !> what leaves `reachable` of rounding.
    real(wp), parameter :: rounding = 1.0e-15_wp, smallest_chi = rounding/reachable

    !> Memory of one body for contacts up to one radius.
    type :: memory_t
        !> local: J_g, J_l and 1/th_l
        type(creep_t) :: local
        !> wavenumbers and weights, 2/pi included; none for a homogeneous body [1/length]
        real(wp), allocatable :: k(:), weights(:)
        !> X_g(k), R_m(k) (size(k), size(time)), and th_m
        real(wp), allocatable :: instant(:), rest(:, :), time(:)
        !> longest panel of x that resolves what the layers do [length]
        real(wp) :: longest_panel = huge(1.0_wp)
        !> shortest time of the body [time]
        real(wp) :: shortest = 1.0_wp
    end type memory_t

contains

    !> The memory of a body whose materials have a glassy and a relaxed limit.
    subroutine new_memory(self, medium, radius, span, tolerance, error)
        type(memory_t), intent(out) :: self
        type(viscoelastic_t), intent(in) :: medium
        !> largest contact radius [length], for how long memory is needed [time], and relative error of the common times
        real(wp), intent(in) :: radius, span, tolerance
        type(error_t), allocatable, intent(out) :: error
        type(creep_t) :: creep
        real(wp) :: longest, misfit
        integer :: i

        self%shortest = huge(1.0_wp)
        longest = 0.0_wp
        do i = 1, size(medium%materials)
            associate (material => medium%materials(i))
                creep = creep_of(material%shear)
                if (size(creep%rate) == 0) cycle
                self%shortest = min(self%shortest, 1.0_wp/maxval(material%shear%rate))
                longest = max(longest, 1.0_wp/minval(creep%rate))
            end associate
        end do
        self%local = creep_of(medium%materials(1)%contact_series(1.0_wp, 1.0_wp))
        allocate (self%k(0), self%weights(0))
        if (size(medium%thickness) == 0) then
            allocate (self%instant(0), self%rest(0, 0), self%time(0))
            return
        end if
        self%longest_panel = in_thicknesses*medium%thickness(1)
        call place_waves(self, medium, radius, 1.0_wp/(beyond*min(longest, span)), error)
        if (allocated(error)) return
        do i = 1, size(counts)
            call fit_times(self, medium, counts(i), longest, span, max(tolerance, reachable), misfit, error)
            if (allocated(error) .or. misfit <= max(tolerance, reachable)) return
        end do
        call raise(error, error_no_convergence, "the memory of this body spreads over too many times")
    end subroutine new_memory

    !> chi(k)/E0* at real s.
    subroutine find_compliance(medium, s, k, values, error)
        type(viscoelastic_t), intent(in) :: medium
        real(wp), intent(in) :: s, k(:)
        !> same size as k
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), dimension(size(k)) :: one_plus_chi, chi
        type(chain_t) :: chain

        values = 0.0_wp
        call medium%chain_at(normal_load, cmplx(s, kind=wp), chain, error)
        if (allocated(error)) return
        call chain%chi(cmplx(k, kind=wp), one_plus_chi, chi)
        values = real(chi/chain%scale, wp)
    end subroutine find_compliance

    !> Panels of wavenumbers that grow from where all layers together are seen, and resolve the widest contact. A stiff layer on a
    !> soft one, or on springs, bends in waves much longer than the layers are thick.
    subroutine place_waves(self, medium, radius, slowest, error)
        type(memory_t), intent(inout) :: self
        type(viscoelastic_t), intent(in) :: medium
        !> the largest s is that of the body [1/time]
        real(wp), intent(in) :: radius, slowest
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: low, width, nodes(panel_nodes), weights(panel_nodes), last(1), scale, s
        type(chain_t) :: chains(0:looks)
        integer :: i, panel

        call unit_rule(nodes, weights)
        do i = 0, looks
            s = at_once/self%shortest
            if (i > 0) s = slowest*(beyond/(self%shortest*slowest))**(real(i - 1, wp)/real(looks - 1, wp))
            call medium%chain_at(normal_load, cmplx(s, kind=wp), chains(i), error)
        end do
        low = 0.0_wp
        width = min(0.25_wp/sum(medium%thickness), largest_phase/radius)
        scale = 0.0_wp
        do panel = 1, most_panels
            if (allocated(error)) return
            do i = 1, most_panels
                if (is_resolved(chains, low, width, radius, nodes, weights)) exit
                width = 0.5_wp*width
            end do
            self%k = [self%k, low + width*nodes]
            self%weights = [self%weights, 2.0_wp/pi*width*weights]
            low = low + width
            call find_compliance(medium, 1.0_wp/self%shortest, [low], last, error)
            scale = max(scale, abs(last(1)))
            if (low*medium%thickness(1) > 3.0_wp .and. abs(last(1)) <= negligible*scale) exit
            width = min(low, largest_phase/radius, 2.0_wp/medium%thickness(1))
        end do
        if (panel > most_panels) then
            call raise(error, error_no_convergence, "contacts up to radius "//to_text(radius)//" are too wide for a first "// &
                       "layer of thickness "//to_text(medium%thickness(1)))
        end if
    end subroutine place_waves

    !> Whether a panel gives what its halves give, of chi alone and with the shortest wave of the widest contact.
    function is_resolved(chains, low, width, radius, nodes, weights) result(answer)
        type(chain_t), intent(in) :: chains(:)
        real(wp), intent(in) :: low, width, radius, nodes(:), weights(:)
        logical :: answer
        real(wp) :: k(3*size(nodes)), rule(3*size(nodes)), found(2), size_of
        complex(wp), dimension(3*size(nodes)) :: one_plus_chi, chi
        integer :: i

        k = low + width*[nodes, 0.5_wp*nodes, 0.5_wp + 0.5_wp*nodes]
        rule = [-weights, 0.5_wp*weights, 0.5_wp*weights]
        answer = .true.
        do i = 1, size(chains)
            call chains(i)%chi(cmplx(k, kind=wp), one_plus_chi, chi)
            size_of = sum(abs(rule*chi)) + 1.0_wp/(radius*width)
            found = [sum(rule*real(chi, wp)), sum(rule*real(chi, wp)*cos(2.0_wp*radius*k))]
            answer = answer .and. all(abs(found) <= allowed_difference*size_of)
        end do
    end function is_resolved

    subroutine unit_rule(nodes, weights)
        real(wp), intent(out) :: nodes(:), weights(:)
        type(error_t), allocatable :: error

        call gauss_legendre(nodes, weights, error)
        if (allocated(error)) weights = 0.0_wp
    end subroutine unit_rule

    !> X_g and R_m for so many common times, log-Chebyshev between the shortest and the last that is resolved, and the longest.
    subroutine fit_times(self, medium, count, longest, span, tolerance, misfit, error)
        type(memory_t), intent(inout) :: self
        type(viscoelastic_t), intent(in) :: medium
        integer, intent(in) :: count
        real(wp), intent(in) :: longest, span
        !> of the misfit
        real(wp), intent(in) :: tolerance
        !> largest error of c~ at any s, relative to `size_at` there; between the samples too, where it is within tolerance
        real(wp), intent(out) :: misfit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: matrix(:, :), factor(:, :), values(:, :), wanted(:, :), work(:)
        real(wp) :: s, lowest, highest, last, part
        integer :: i, rows, columns, info

        misfit = 0.0_wp
        rows = samples_per_time*count
        columns = count
        last = min(longest, slow*span)
        if (last < longest) columns = count + 1
        if (allocated(self%time)) deallocate (self%time)
        allocate (self%time(columns))
        self%time(columns) = longest
        do i = 1, count
            part = 0.5_wp*(1.0_wp + cos(pi*(real(i, wp) - 0.5_wp)/real(count, wp)))
            self%time(i) = self%shortest*(last/self%shortest)**part
        end do
        if (allocated(self%instant)) deallocate (self%instant)
        allocate (self%instant(size(self%k)))
        call find_compliance(medium, at_once/self%shortest, self%k, self%instant, error)
        allocate (matrix(rows, columns), values(rows, size(self%k)), work(columns + 32*max(columns, size(self%k))))
        lowest = 1.0_wp/(beyond*min(longest, span))
        highest = beyond/self%shortest
        do i = 1, rows
            s = lowest*(highest/lowest)**(real(i - 1, wp)/real(rows - 1, wp))
            call find_compliance(medium, s, self%k, values(i, :), error)
            if (allocated(error)) return
            part = 1.0_wp/size_at(self, s, values(i, :))
            matrix(i, :) = part/(1.0_wp + s*self%time)
            values(i, :) = part*(values(i, :) - self%instant)
        end do
        allocate (factor, source=matrix)
        allocate (wanted, source=values)
        call dgels("N", rows, columns, size(self%k), factor, rows, values, rows, work, size(work), info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "the memory of this body could not be found")
            return
        end if
        self%rest = transpose(values(:columns, :))
        misfit = maxval(abs(matmul(matrix, values(:columns, :)) - wanted))
        if (misfit <= tolerance) misfit = max(misfit, misfit_between(self, medium, lowest, highest, rows, error))
    end subroutine fit_times

    !> The misfit where the transform was not sampled, once for each time.
    function misfit_between(self, medium, lowest, highest, rows, error) result(misfit)
        type(memory_t), intent(in) :: self
        type(viscoelastic_t), intent(in) :: medium
        !> first and last of so many logarithmic samples
        real(wp), intent(in) :: lowest, highest
        integer, intent(in) :: rows
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: misfit
        real(wp) :: s, values(size(self%k))
        integer :: i

        misfit = 0.0_wp
        do i = 1, rows - 1, samples_per_time
            s = lowest*(highest/lowest)**((real(i, wp) - 0.5_wp)/real(rows - 1, wp))
            call find_compliance(medium, s, self%k, values, error)
            if (allocated(error)) return
            misfit = max(misfit, maxval(abs(self%instant + matmul(self%rest, 1.0_wp/(1.0_wp + s*self%time)) - values)) &
                         /size_at(self, s, values))
        end do
    end function misfit_between

    !> Reference for an error of c~ at s: its largest value there or initially, and no less than `smallest_chi` of 1/E0*.
    pure function size_at(self, s, values) result(size_of)
        type(memory_t), intent(in) :: self
        real(wp), intent(in) :: s, values(:)
        real(wp) :: size_of

        associate (local => self%local)
            size_of = max(maxval(abs(self%instant)), maxval(abs(values)), &
                          smallest_chi*(local%instant + sum(local%weight/(1.0_wp + s/local%rate)) + local%fluidity/s))
        end associate
    end function size_at

end module mdrcontact_time_memory
