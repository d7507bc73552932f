! SPDX-License-Identifier: GPL-3.0-or-later
!> The Hankel transform of a pressure, p_hat(k) = int_0^a p J0(kr) r dr = (1/pi) int_0^a q cos kx dx, at many wavenumbers
!> (theory/stress.md (1.1), (1.6)).
!>
!> By parts it is (1/(pi k)) [q(a) sin ka - int_0^a q' sin kx dx]. A Gauss rule integrates q' sin kx on a panel of few waves; on one
!> of many waves q' is a sum of Legendre polynomials, and int_-1^1 P_n(t) exp(i w t) dt = 2 i^n j_n(w): a wavenumber costs what the
!> panels of q' cost, however short the waves are.
module mdrcontact_inside_transform
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_medium_load, only: load_t, panel_t
    use mdrcontact_numerics_waves, only: block => panel_nodes
    use mdrcontact_gsl, only: gsl_sort_index
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: add_times
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    implicit none (type, external)
    private
    public :: hankel_transform

    !> Nodes of a panel of positions, and the largest k times its length for which they hold q' sin kx.
    integer, parameter :: nodes = 16
    real(wp), parameter :: longest_phase = 15.0_wp

    !> -q' of a load on panels, the shortest first.
    type :: slopes_t
        integer :: panels = 0
        real(wp), allocatable :: length(:)
        !> -q' dx at the nodes of all panels
        real(wp), allocatable :: part(:)
        !> (n, panel): the factor of j_n in the integrals over a panel
        real(wp), allocatable :: series(:, :)
        !> where sines are needed: nodes of all panels, centres of all panels, halves of their lengths
        real(wp), allocatable :: x(:)
    end type slopes_t

    !> cos and sin of x times the wavenumbers of a panel of wave_rule, from those of the first one and of the distances from it.
    type :: waves_t
        !> distances from the first wavenumber
        real(wp) :: distance(block) = -1.0_wp
        !> (position, wavenumber): of the distances
        real(wp), allocatable :: cosine(:, :), sine(:, :)
        !> of the first wavenumber
        real(wp), allocatable :: first_cosine(:), first_sine(:)
    end type waves_t

contains

    !> p_hat(k) [modulus length^2].
    subroutine hankel_transform(load, k, values, error)
        class(load_t), intent(in) :: load
        !> wavenumbers > 0, ascending [1/length]: fast in panels of 16, equal ones one after the other
        real(wp), intent(in) :: k(:)
        !> same size as k
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(slopes_t) :: slopes
        type(waves_t) :: waves
        integer :: i, last, short

        call new_slopes(slopes, load, k(size(k)), error)
        if (allocated(error)) return
        call new_waves(waves, (nodes + 2)*slopes%panels, error)
        if (allocated(error)) return
        short = slopes%panels
        do i = 1, size(k), block
            call check_cancelled(error)
            if (allocated(error)) return
            last = min(i + block - 1, size(k))
            do while (short > 0)
                if (slopes%length(short)*k(last) <= longest_phase) exit
                short = short - 1
            end do
            call move(waves, slopes%x, nodes*short, nodes*slopes%panels, k(i:last))
            values(i:last) = load%edge*sin(k(i:last)*load%radius)
            call add_short(waves, slopes%part(:nodes*short), values(i:last))
            call add_long(waves, slopes, short, k(i:last), values(i:last))
        end do
        values = values/(pi*k)
    end subroutine hankel_transform

    !> The slopes of a load, for waves up to k.
    subroutine new_slopes(self, load, k, error)
        type(slopes_t), intent(out) :: self
        class(load_t), intent(in) :: load
        real(wp), intent(in) :: k
        type(error_t), allocatable, intent(inout) :: error
        type(panel_t), allocatable :: panels(:)
        integer(c_size_t), allocatable :: order(:)
        real(wp) :: node(nodes), weight(nodes), polynomials(nodes, 0:nodes - 1), distance(nodes), dx(nodes), slope(nodes)
        integer :: i, n, stat

        call gauss_legendre(node, weight, error)
        ! next to a kink x = b + s^2 doubles the phase
        call load%panels(0.5_wp*longest_phase/k, panels, error)
        if (allocated(error)) return
        self%panels = size(panels)
        associate (count => self%panels)
            allocate (order(count), self%length(count), self%part(nodes*count), self%series(0:nodes - 1, count), &
                      self%x((nodes + 2)*count), stat=stat)
        end associate
        call check_memory(error, stat)
        if (stat /= 0) return
        call gsl_sort_index(order, [(panels(i)%length, i=1, size(panels))], 1_c_size_t, int(self%panels, c_size_t))
        polynomials = legendre(nodes, 2.0_wp*node - 1.0_wp)
        do i = 1, self%panels
            associate (panel => panels(order(i) + 1))
                call panel%place_nodes(node, weight, distance, dx)
                slope = -load%slope(panel%start, distance)
                self%length(i) = panel%length
                self%x(nodes*(i - 1) + 1:nodes*i) = panel%start + distance
                self%part(nodes*(i - 1) + 1:nodes*i) = slope*dx
                self%x(nodes*self%panels + i) = panel%start + panel%low + 0.5_wp*panel%length
                self%x((nodes + 1)*self%panels + i) = 0.5_wp*panel%length
                ! (2 n + 1) times the mean of slope P_n, times the length and i^n
                do n = 0, nodes - 1
                    self%series(n, i) = real((2*n + 1)*(1 - 2*mod(n/2, 2)), wp)*panel%length &
                                        *sum(weight*slope*polynomials(:, n))
                end do
            end associate
        end do
    end subroutine new_slopes

    subroutine new_waves(self, positions, error)
        type(waves_t), intent(out) :: self
        integer, intent(in) :: positions
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        allocate (self%cosine(positions, block), self%sine(positions, block), self%first_cosine(positions), &
                  self%first_sine(positions), stat=stat)
        call check_memory(error, stat)
    end subroutine new_waves

    !> Advance to the next wavenumbers, at positions up to `before` and beyond `after`; their spacing usually equals the previous
    !> one.
    pure subroutine move(self, x, before, after, k)
        type(waves_t), intent(inout) :: self
        real(wp), intent(in) :: x(size(self%first_sine)), k(:)
        integer, intent(in) :: before, after
        integer :: j

        self%first_cosine(:before) = cos(k(1)*x(:before))
        self%first_sine(:before) = sin(k(1)*x(:before))
        self%first_cosine(after + 1:) = cos(k(1)*x(after + 1:))
        self%first_sine(after + 1:) = sin(k(1)*x(after + 1:))
        associate (distance => self%distance(:size(k)))
            if (all(abs(k - k(1) - distance) <= 8.0_wp*epsilon(1.0_wp)*k(size(k)))) return
            distance = k - k(1)
            do j = 1, size(k)
                self%cosine(:, j) = cos(distance(j)*x)
                self%sine(:, j) = sin(distance(j)*x)
            end do
        end associate
    end subroutine move

    !> Adds the integrals over panels of few waves, the first ones.
    subroutine add_short(waves, part, values)
        type(waves_t), intent(in) :: waves
        real(wp), intent(in) :: part(:)
        real(wp), intent(inout) :: values(:)
        integer :: n

        n = size(part)
        if (n == 0) return
        call add_times("T", n, size(values), 1.0_wp, waves%cosine, size(waves%cosine, 1), part*waves%first_sine(:n), values)
        call add_times("T", n, size(values), 1.0_wp, waves%sine, size(waves%sine, 1), part*waves%first_cosine(:n), values)
    end subroutine add_short

    !> Adds the integrals over panels of many waves, those after the short ones. j_n comes from those before it: rounding grows
    !> only where n exceeds w = k length/2, which is 7 at least.
    pure subroutine add_long(waves, slopes, short, k, values)
        type(waves_t), intent(in) :: waves
        type(slopes_t), intent(in) :: slopes
        integer, intent(in) :: short
        real(wp), intent(in) :: k(:)
        real(wp), intent(inout) :: values(:)
        real(wp), dimension(size(k)) :: sine, cosine, over, below, here, next, even, odd
        integer :: i, n

        do i = short + 1, slopes%panels
            call sines(waves, (nodes + 1)*slopes%panels + i, sine, cosine)
            over = 2.0_wp/(k*slopes%length(i))
            below = sine*over
            here = (below - cosine)*over
            even = slopes%series(0, i)*below
            odd = slopes%series(1, i)*here
            do n = 2, nodes - 1
                next = real(2*n - 1, wp)*over*here - below
                below = here
                here = next
                if (mod(n, 2) == 0) then
                    even = even + slopes%series(n, i)*here
                else
                    odd = odd + slopes%series(n, i)*here
                end if
            end do
            call sines(waves, nodes*slopes%panels + i, sine, cosine)
            values = values + sine*even + cosine*odd
        end do
    end subroutine add_long

    !> sin kx and cos kx at a position, for all wavenumbers.
    pure subroutine sines(self, position, sine, cosine)
        type(waves_t), intent(in) :: self
        integer, intent(in) :: position
        real(wp), intent(out) :: sine(:), cosine(:)
        integer :: n

        n = size(sine)
        associate (s => self%first_sine(position), c => self%first_cosine(position))
            sine = s*self%cosine(position, :n) + c*self%sine(position, :n)
            cosine = c*self%cosine(position, :n) - s*self%sine(position, :n)
        end associate
    end subroutine sines

end module mdrcontact_inside_transform
