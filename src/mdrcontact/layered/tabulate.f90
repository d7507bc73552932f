! SPDX-License-Identifier: GPL-3.0-or-later
!> Tabulates the kernel X(y) from the surface compliance chi(k).
!>
!> X(y) = Re int chi(k) exp(iky) dk along a ray k = t exp(i theta) in the sector where chi is analytic: the integrand decays
!> and hardly
!> oscillates, at every y. For y > 0 the constant chi(0) contributes nothing, so that chi(k) - chi(0) may stand for chi(k): X
!> keeps its
!> relative precision in its tail. Wavenumbers and positions both run in octaves, so one small table of
!> exp(iky) serves all pairs of octaves.
module mdrcontact_layered_tabulate
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, long, pi, wp
    use mdrcontact_layered_kernel, only: degree, kernel_t
    use mdrcontact_layered_surface, only: surface_t
    use mdrcontact_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: tabulate_kernel

    !> Nodes in a panel of wavenumbers.
    integer, parameter :: panel_nodes = 20
    !> exp(iky) is 1 to rounding below octave `lowest` of k y; octaves below `negligible` of it contribute nothing.
    integer, parameter :: lowest = -27, negligible = -56
    !> |exp(iky)| beyond which nothing is left: exp(-faded).
    real(wp), parameter :: faded = 45.0_wp
    !> Octaves of y at most.
    integer, parameter :: most_octaves = 128
    !> Rays tried in turn, pi/denominator, and panels in an octave of wavenumbers on each.
    integer, parameter :: ray_denominator(*) = [6, 6, 12, 24], ray_panels(*) = [1, 2, 3, 6]

    !> chi on octaves of a ray, filled downwards as they are needed.
    type :: ray_t
        complex(wp) :: direction
        !> the base octave [1, 2)
        real(wp), allocatable :: nodes(:), weights(:)
        !> what takes values on a panel to its last Legendre coefficients
        real(wp) :: last(panel_nodes, 2) = 0.0_wp
        integer :: top = 0, bottom = 1
        !> weight times chi, and weight times (chi - chi(0)), (node, octave); octaves above top have chi = 0
        complex(wp), allocatable :: weighted_chi(:, :), weighted_change(:, :)
        real(wp) :: chi_zero = 0.0_wp
        !> largest relative size of the highest Legendre coefficients of chi - chi(0) in a panel
        real(wp) :: roughness = 0.0_wp
        !> largest |chi| on the real axis
        real(wp) :: largest = 0.0_wp
    end type ray_t

contains

    !> The table of X for a body.
    subroutine tabulate_kernel(kernel, surface, error)
        type(kernel_t), intent(out) :: kernel
        class(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(out) :: error
        type(ray_t) :: ray
        integer :: attempt
        logical :: holds

        kernel%vanishes = .not. surface%first_depth() > 0.0_wp
        if (kernel%vanishes) return
        kernel%unit = surface%first_depth()
        do attempt = 1, size(ray_panels)
            call start_ray(ray, surface, kernel%unit, pi/real(ray_denominator(attempt), wp), ray_panels(attempt))
            call check_path(ray, surface, kernel%unit, holds)
            if (.not. holds) cycle
            call fill_table(kernel, ray, surface)
            kernel%defect = defect_of(kernel, surface%long_wave_limit())
            if (ray%roughness < 3.0e-8_wp .and. abs(kernel%defect) < 1.0e-10_wp*(1.0_wp + ray%largest)) return
        end do
        call raise(error, error_no_convergence, "the surface compliance of this body could not be integrated over all wavelengths")
    end subroutine tabulate_kernel

    !> Fills the octaves that the shortest positions need.
    subroutine start_ray(ray, surface, unit, angle, panels)
        type(ray_t), intent(out) :: ray
        class(surface_t), intent(in) :: surface
        real(wp), intent(in) :: unit, angle
        integer, intent(in) :: panels
        real(wp) :: x(panel_nodes), w(panel_nodes)
        integer :: i
        complex(wp) :: sigma, chi

        ray%direction = cmplx(cos(angle), sin(angle), wp)
        ray%chi_zero = surface%long_wave_limit() - 1.0_wp
        call gauss_legendre(x, w)
        call last_coefficients(x, w, ray%last)
        allocate (ray%nodes(panels*panel_nodes), ray%weights(panels*panel_nodes))
        do i = 1, panels
            ray%nodes((i - 1)*panel_nodes + 1:i*panel_nodes) = 1.0_wp + (real(i - 1, wp) + x)/real(panels, wp)
            ray%weights((i - 1)*panel_nodes + 1:i*panel_nodes) = w/real(panels, wp)
        end do
        do i = -2, 1000
            call surface%response(ray%direction*(scale(1.0_wp, i)/unit), sigma, chi)
            if (abs(chi)*scale(1.0_wp, i) < 1.0e-20_wp) exit
        end do
        ray%top = i
        ray%bottom = i + 1
        allocate (ray%weighted_chi(size(ray%nodes), negligible - most_octaves:ray%top), &
                  ray%weighted_change(size(ray%nodes), negligible - most_octaves:ray%top))
        call extend_ray(ray, surface, unit, negligible)
    end subroutine start_ray

    !> Fills octaves down to `bottom`.
    subroutine extend_ray(ray, surface, unit, bottom)
        type(ray_t), intent(inout) :: ray
        class(surface_t), intent(in) :: surface
        real(wp), intent(in) :: unit
        integer, intent(in) :: bottom
        complex(wp) :: sigma, chi, change(size(ray%nodes))
        real(wp) :: k, sigma_zero
        integer :: i, octave

        sigma_zero = surface%long_wave_limit()
        do octave = ray%bottom - 1, bottom, -1
            do i = 1, size(ray%nodes)
                k = scale(ray%nodes(i), octave)
                call surface%response(ray%direction*(k/unit), sigma, chi)
                change(i) = sigma - sigma_zero
                ray%weighted_chi(i, octave) = scale(ray%weights(i), octave)*ray%direction*chi
                ray%weighted_change(i, octave) = scale(ray%weights(i), octave)*ray%direction*change(i)
            end do
            if (octave >= -30) ray%roughness = max(ray%roughness, roughness_of(change, ray%last, sigma_zero))
        end do
        ray%bottom = min(ray%bottom, bottom)
    end subroutine extend_ray

    !> The two highest Legendre polynomials that the panels' nodes resolve, times weights and normalisation: what takes
    !> values on a panel
    !> to its two last Legendre coefficients.
    pure subroutine last_coefficients(nodes, weights, matrix)
        !> on [0, 1]
        real(wp), intent(in) :: nodes(:), weights(:)
        real(wp), intent(out) :: matrix(:, :)
        real(wp), dimension(size(nodes)) :: x, before, here, next
        integer :: n

        x = 2.0_wp*nodes - 1.0_wp
        before = 1.0_wp
        here = x
        do n = 1, size(nodes) - 2
            next = (real(2*n + 1, wp)*x*here - real(n, wp)*before)/real(n + 1, wp)
            before = here
            here = next
        end do
        n = size(nodes)
        matrix(:, 1) = real(2*n - 3, wp)*weights*before
        matrix(:, 2) = real(2*n - 1, wp)*weights*here
    end subroutine last_coefficients

    !> How far values on an octave are from being resolved: the larger of their two last Legendre coefficients on any
    !> panel, relative to the largest value, or to what rounding of sigma leaves of it.
    pure function roughness_of(values, last, sigma_zero) result(roughness)
        complex(wp), intent(in) :: values(:)
        real(wp), intent(in) :: last(:, :), sigma_zero
        real(wp) :: roughness
        integer :: first

        roughness = 0.0_wp
        do first = 1, size(values), panel_nodes
            associate (on_panel => values(first:first + panel_nodes - 1))
                roughness = max(roughness, abs(sum(last(:, 1)*on_panel)), abs(sum(last(:, 2)*on_panel)))
            end associate
        end do
        roughness = roughness/max(maxval(abs(values)), 1.0e-4_wp*sigma_zero, tiny(1.0_wp))
    end function roughness_of

    !> Whether the integral of chi along the ray equals that along the real axis: no pole lies between them.
    subroutine check_path(ray, surface, unit, holds)
        type(ray_t), intent(inout) :: ray
        class(surface_t), intent(in) :: surface
        real(wp), intent(in) :: unit
        logical, intent(out) :: holds
        complex(wp) :: sigma, chi, along_ray
        real(wp) :: along_axis, magnitude, k, term
        integer :: i, octave

        along_ray = sum(ray%weighted_chi(:, ray%bottom:ray%top)) + ray%chi_zero*scale(1.0_wp, ray%bottom)*ray%direction
        along_axis = ray%chi_zero*scale(1.0_wp, ray%bottom)
        magnitude = 0.0_wp
        do octave = ray%bottom, ray%top
            do i = 1, size(ray%nodes)
                k = scale(ray%nodes(i), octave)
                call surface%response(cmplx(k/unit, 0.0_wp, wp), sigma, chi)
                term = scale(ray%weights(i), octave)*real(chi, wp)
                along_axis = along_axis + term
                magnitude = magnitude + abs(term)
                ray%largest = max(ray%largest, abs(real(chi, wp)))
            end do
        end do
        holds = abs(along_ray - along_axis) <= 1.0e-12_wp*magnitude + 1.0e-13_wp
    end subroutine check_path

    subroutine fill_table(kernel, ray, surface)
        type(kernel_t), intent(inout) :: kernel
        type(ray_t), intent(inout) :: ray
        class(surface_t), intent(in) :: surface
        integer, parameter :: n = degree + 1
        real(wp) :: chebyshev(n), y(2*n), x(2*n), coefficients(0:degree, 0:2*most_octaves)
        real(wp), allocatable :: waves(:, :, :, :)
        integer :: i, octave, highest
        real(wp) :: level, spread

        do i = 1, n
            chebyshev(i) = cos((real(i, wp) - 0.5_wp)*pi/real(n, wp))
        end do
        x(:n) = near_values(ray, sqrt(0.5_wp*(1.0_wp + chebyshev)))
        coefficients(:, 0) = powers_from_values(x(:n))

        y = [1.25_wp + 0.25_wp*chebyshev, 1.75_wp + 0.25_wp*chebyshev]
        highest = ceiling(log(faded/aimag(ray%direction))/log(2.0_wp)) - 1
        call tabulate_waves(ray, y, highest, waves)
        do octave = 0, most_octaves - 1
            call extend_ray(ray, surface, kernel%unit, negligible - octave)
            call far_values(ray, octave, highest, waves, x)
            coefficients(:, 1 + 2*octave) = powers_from_values(x(:n))
            coefficients(:, 2 + 2*octave) = powers_from_values(x(n + 1:))
            x = x*y**2
            level = sum(x)/real(size(x), wp)
            spread = maxval(abs(x - level))
            kernel%tail = level*scale(1.0_wp, 2*octave)
            if (spread <= 1.0e-13_wp*abs(level) .or. spread <= 1.0e-14_wp*scale(surface%long_wave_limit(), -octave)) exit
        end do
        octave = min(octave, most_octaves - 1)
        if (allocated(kernel%coefficients)) deallocate (kernel%coefficients)
        allocate (kernel%coefficients(0:degree, 0:2*octave + 2))
        kernel%coefficients = coefficients(:, :2*octave + 2)
    end subroutine fill_table

    !> X at y <= 1, from chi itself.
    pure function near_values(ray, y) result(x)
        type(ray_t), intent(in) :: ray
        real(wp), intent(in) :: y(:)
        real(wp) :: x(size(y))
        real(wp) :: waves(size(y), 2)
        complex(wp) :: rest
        integer :: i, octave

        rest = ray%chi_zero*scale(1.0_wp, negligible)*ray%direction
        do octave = negligible, lowest - 1
            rest = rest + sum(ray%weighted_chi(:, octave))
        end do
        x = real(rest, wp)
        do octave = lowest, ray%top
            do i = 1, size(ray%nodes)
                call waves_at(ray%direction, scale(ray%nodes(i), octave)*y, waves)
                x = x + real(ray%weighted_chi(i, octave), wp)*waves(:, 1) - aimag(ray%weighted_chi(i, octave))*waves(:, 2)
            end do
        end do
    end function near_values

    !> exp(iky) for every octave of k y that matters.
    pure subroutine tabulate_waves(ray, y, highest, waves)
        type(ray_t), intent(in) :: ray
        real(wp), intent(in) :: y(:)
        integer, intent(in) :: highest
        !> (position, real and imaginary part, wavenumber, octave of k y)
        real(wp), allocatable, intent(out) :: waves(:, :, :, :)
        integer :: i, octave

        allocate (waves(size(y), 2, size(ray%nodes), lowest:highest))
        do octave = lowest, highest
            do i = 1, size(ray%nodes)
                call waves_at(ray%direction, scale(ray%nodes(i), octave)*y, waves(:, :, i, octave))
            end do
        end do
    end subroutine tabulate_waves

    !> X on one octave of y >= 1, from chi - chi(0).
    pure subroutine far_values(ray, octave, highest, waves, x)
        type(ray_t), intent(in) :: ray
        integer, intent(in) :: octave, highest
        real(wp), intent(in) :: waves(:, :, :, lowest:)
        real(wp), intent(out) :: x(:)
        complex(wp) :: factor, rest
        integer :: i, m

        rest = 0.0_wp
        do m = negligible, lowest - 1
            rest = rest + sum(ray%weighted_change(:, m - octave))
        end do
        x = real(rest, wp)
        do m = lowest, highest
            do i = 1, size(ray%nodes)
                if (m - octave > ray%top) then
                    factor = -ray%chi_zero*scale(ray%weights(i), m - octave)*ray%direction
                else
                    factor = ray%weighted_change(i, m - octave)
                end if
                x = x + real(factor, wp)*waves(:, 1, i, m) - aimag(factor)*waves(:, 2, i, m)
            end do
        end do
    end subroutine far_values

    !> Real and imaginary parts of exp(i t exp(i theta)); by its power series where all t are small.
    pure subroutine waves_at(direction, t, waves)
        complex(wp), intent(in) :: direction
        real(wp), intent(in) :: t(:)
        !> (size(t), 2)
        real(wp), intent(out) :: waves(:, :)
        integer, parameter :: order = 7
        complex(wp) :: power(0:order)
        integer :: n

        if (maxval(t) < 1.0_wp/64.0_wp) then
            power(0) = 1.0_wp
            do n = 1, order
                power(n) = power(n - 1)*direction*(0.0_wp, 1.0_wp)/real(n, wp)
            end do
            waves(:, 1) = real(power(order), wp)
            waves(:, 2) = aimag(power(order))
            do n = order - 1, 0, -1
                waves(:, 1) = waves(:, 1)*t + real(power(n), wp)
                waves(:, 2) = waves(:, 2)*t + aimag(power(n))
            end do
        else
            waves(:, 1) = exp(-t*aimag(direction))
            waves(:, 2) = waves(:, 1)*sin(t*real(direction, wp))
            waves(:, 1) = waves(:, 1)*cos(t*real(direction, wp))
        end if
    end subroutine waves_at

    !> Coefficients of powers of u from values at the Chebyshev points. By way of Chebyshev coefficients: those of high
    !> degree are small,
    !> and so are the rounding errors of the powers that they make.
    pure function powers_from_values(values) result(powers)
        real(wp), intent(in) :: values(0:)
        real(wp) :: powers(0:degree)
        real(wp) :: coefficients(0:degree), before(0:degree), here(0:degree), next(0:degree)
        integer :: i, j

        do j = 0, degree
            coefficients(j) = 0.0_wp
            do i = 0, degree
                coefficients(j) = coefficients(j) + values(i)*cos(real(j*(2*i + 1), wp)*half_pi/real(degree + 1, wp))
            end do
        end do
        coefficients = coefficients*(2.0_wp/real(degree + 1, wp))
        before = 0.0_wp
        before(0) = 1.0_wp
        here = 0.0_wp
        here(1) = 1.0_wp
        powers = 0.5_wp*coefficients(0)*before + coefficients(1)*here
        do j = 2, degree
            next(0) = -before(0)
            next(1:) = 2.0_wp*here(:degree - 1) - before(1:)
            powers = powers + coefficients(j)*next
            before = here
            here = next
        end do
    end function powers_from_values

    !> chi(0) - (2/pi) int_0^inf X dy of the table as it stands, in higher precision: it is of the order of rounding.
    pure function defect_of(kernel, sigma_zero) result(defect)
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: sigma_zero
        real(wp) :: defect
        real(long) :: total, part, moment
        integer :: j, panel

        total = real(kernel%tail, long)/2.0_long**kernel%octaves()
        do panel = 2*kernel%octaves(), 1, -1
            part = 0.0_long
            do j = 0, degree, 2
                part = part + real(kernel%coefficients(j, panel), long)/real(j + 1, long)
            end do
            total = total + part*2.0_long**((panel - 1)/2 - 1)
        end do
        ! moment: int_0^1 (2 y^2 - 1)^j dy
        moment = 1.0_long
        do j = 0, degree
            if (j > 0) moment = (1.0_long - real(2*j, long)*moment)/real(2*j + 1, long)
            total = total + real(kernel%coefficients(j, 0), long)*moment
        end do
        defect = real((real(sigma_zero, long) - 1.0_long) - total*(2.0_long/acos(-1.0_long)), wp)
    end function defect_of

end module mdrcontact_layered_tabulate
