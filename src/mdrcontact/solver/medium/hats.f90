! SPDX-License-Identifier: GPL-3.0-or-later
!> Pressures on a disc of radius 1 as sums of hats, and what follows from them on the line (theory/wear.md (5.2), (5.3)).
!>
!> The hats phi_i are linear between the radii u_i = sin(pi/2 (i/n)^m), dense at the edge, and with m = 2 also at the axis,
!> where the pressure under an apex is infinite at first; with m = 0 they are u_i = i/n. Their line loads
!>
!>     Q_i(x) = 2 int_x^1 r phi_i/sqrt(r^2 - x^2) dr
!>
!> have closed forms, and their Legendre coefficients need no quadrature over x: by the addition theorem
!>
!>     int_0^r P_2m(x)/sqrt(r^2 - x^2) dx = (pi/2) P_2m(0) P_2m(sqrt(1 - r^2)).
module mdrcontact_medium_hats
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_one_thread, only: add_product
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: hats_t, new_hats, hat_points, hat_nodes, line_compliance, find_heights

    !> Points of the rule in each interval for integrals over the disc, for line loads, and for Legendre coefficients.
    integer, parameter :: hat_points = 4, line_points = 16, wave_points = 16
    !> An interval is far from x beyond so many times its length: points of its rule.
    real(wp), parameter :: far = 2.0_wp
    integer, parameter :: far_points = 6
    !> Towards the axis, where Q has x^2 ln x, the first interval is divided so often, each time to this part of what is left.
    integer, parameter :: divisions = 12
    real(wp), parameter :: shrinking = 0.25_wp

    !> Everything is in units of the radius of the disc.
    type :: hats_t
        !> number of intervals
        integer :: n = 0
        !> m: 0, 1 or 2
        integer :: power = 1
        !> u_i, 0 ... n
        real(wp), allocatable :: nodes(:)
        !> int_0^1 Q_i Q_j dx, (0 ... n, 0 ... n)
        real(wp), allocatable :: products(:, :)
        !> int_-1^1 s_m P_2m(x) Q_i dx with s_m = sqrt((4 m + 1)/2): (0 ... modes - 1, 0 ... n)
        real(wp), allocatable :: waves(:, :)
        !> int phi_i 2 pi r dr
        real(wp), allocatable :: areas(:)
        !> the rule over the disc: (point, interval), radii, weights times 2 pi r, and the hat that rises in the interval
        real(wp), allocatable :: radii(:, :), weights(:, :), rising(:, :)
    end type hats_t

contains

    !> n hats, and those with line loads in Legendre polynomials.
    subroutine new_hats(self, n, power, modes, error)
        type(hats_t), intent(out) :: self
        !> intervals, m, and polynomials: 0 for none
        integer, intent(in) :: n, power, modes
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        self%n = n
        self%power = power
        allocate (self%nodes(0:n), self%products(0:n, 0:n), self%waves(0:modes - 1, 0:n), self%areas(0:n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%nodes = hat_nodes(n, power)
        call set_rule(self, error)
        if (.not. allocated(error)) call set_products(self, error)
        if (.not. allocated(error)) call set_waves(self, modes, error)
    end subroutine new_hats

    !> u_i, 0 ... n.
    pure function hat_nodes(n, power) result(u)
        integer, intent(in) :: n, power
        real(wp) :: u(0:n)
        integer :: i

        u = [(real(i, wp)/real(n, wp), i=0, n)]
        if (power > 0) u = sin(half_pi*u**power)
        u(n) = 1.0_wp
    end function hat_nodes

    subroutine set_rule(self, error)
        type(hats_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(hat_points), weights(hat_points), width
        integer :: i

        allocate (self%radii(hat_points, self%n), self%weights(hat_points, self%n), self%rising(hat_points, self%n))
        call gauss_legendre(t, weights, error)
        self%areas = 0.0_wp
        do i = 1, self%n
            width = self%nodes(i) - self%nodes(i - 1)
            self%radii(:, i) = self%nodes(i - 1) + width*t
            self%weights(:, i) = 2.0_wp*pi*width*weights*self%radii(:, i)
            self%rising(:, i) = t
            self%areas(i - 1) = self%areas(i - 1) + sum(self%weights(:, i)*(1.0_wp - t))
            self%areas(i) = self%areas(i) + sum(self%weights(:, i)*t)
        end do
    end subroutine set_rule

    !> By Gauss's rule in t, x = end - (end - start) t^2, as line loads fall towards a node as the power 3/2 of the distance.
    subroutine set_products(self, error)
        type(hats_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: loads(:, :)
        real(wp) :: t(line_points), weights(line_points), far_t(far_points), far_weights(far_points), width
        real(wp), dimension(self%n + divisions) :: starts, ends
        integer :: i, k, row, rows, stat

        call gauss_legendre(t, weights, error)
        call gauss_legendre(far_t, far_weights, error)
        rows = line_points*(self%n + divisions)
        allocate (loads(rows, 0:self%n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        starts(:divisions) = [(self%nodes(1)*shrinking**i, i=1, divisions)]
        ends(:divisions) = [(self%nodes(1)*shrinking**(i - 1), i=1, divisions)]
        starts(divisions + 1:) = self%nodes(:self%n - 1)
        ends(divisions + 1:) = self%nodes(1:)
        ends(divisions + 1) = starts(divisions)
        row = 0
        do i = 1, size(starts)
            width = ends(i) - starts(i)
            do k = 1, line_points
                row = row + 1
                call line_loads(self%nodes, far_t, far_weights, ends(i) - width*t(k)**2, loads(row, :))
                loads(row, :) = sqrt(2.0_wp*weights(k)*t(k)*width)*loads(row, :)
            end do
        end do
        call add_product("T", "N", self%n + 1, self%n + 1, rows, 1.0_wp, loads, rows, loads, rows, 0.0_wp, self%products, &
                         self%n + 1)
    end subroutine set_products

    !> Q_i(x), 0 < x < 1.
    pure subroutine line_loads(nodes, t, weights, x, loads)
        real(wp), intent(in) :: nodes(0:)
        !> Gauss's rule on [0, 1]
        real(wp), intent(in) :: t(:), weights(:)
        real(wp), intent(in) :: x
        real(wp), intent(out) :: loads(0:)
        real(wp) :: falling, rising
        integer :: i

        loads = 0.0_wp
        do i = ubound(nodes, 1), 1, -1
            if (nodes(i) <= x) exit
            if (nodes(i - 1) - x > far*(nodes(i) - nodes(i - 1))) then
                call far_interval(nodes(i - 1), nodes(i), t, weights, x, falling, rising)
            else
                call near_interval(nodes(i - 1), nodes(i), x, falling, rising)
            end if
            loads(i - 1) = loads(i - 1) + falling
            loads(i) = loads(i) + rising
        end do
    end subroutine line_loads

    !> 2 int r phi/sqrt(r^2 - x^2) dr over an interval for the hats that fall and rise in it, by quadrature, as closed forms would
    !> cancel.
    pure subroutine far_interval(from, to, t, weights, x, falling, rising)
        real(wp), intent(in) :: from, to, t(:), weights(:), x
        real(wp), intent(out) :: falling, rising
        real(wp) :: r, part
        integer :: k

        falling = 0.0_wp
        rising = 0.0_wp
        do k = 1, size(t)
            r = from + (to - from)*t(k)
            part = 2.0_wp*(to - from)*weights(k)*r/sqrt((r - x)*(r + x))
            falling = falling + part*(1.0_wp - t(k))
            rising = rising + part*t(k)
        end do
    end subroutine far_interval

    !> The same for an interval close to x or around it: int r/sqrt = sqrt(r^2 - x^2), int r^2/sqrt = [r sqrt(r^2 - x^2)
    !> + x^2 arcosh(r/x)]/2.
    pure subroutine near_interval(from, to, x, falling, rising)
        real(wp), intent(in) :: from, to, x
        real(wp), intent(out) :: falling, rising
        real(wp) :: roots(2), squares(2), ends(2)

        ends = max([from, to], x)
        roots = sqrt((ends - x)*(ends + x))
        squares = ends*roots + x**2*log((ends + roots)/x)
        rising = (squares(2) - squares(1) - 2.0_wp*from*(roots(2) - roots(1)))/(to - from)
        falling = 2.0_wp*(roots(2) - roots(1)) - rising
    end subroutine near_interval

    subroutine set_waves(self, modes, error)
        type(hats_t), intent(inout) :: self
        integer, intent(in) :: modes
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(wave_points), weights(wave_points), width, factor
        real(wp), allocatable :: p(:, :), r(:)
        integer :: i, m

        if (modes == 0) return
        call gauss_legendre(t, weights, error)
        self%waves = 0.0_wp
        do i = 1, self%n
            width = self%nodes(i) - self%nodes(i - 1)
            ! r = end - width (1 - t)^2 keeps sqrt(1 - r^2) smooth in the last interval
            r = self%nodes(i) - width*(1.0_wp - t)**2
            p = legendre(2*modes - 1, sqrt((1.0_wp - r)*(1.0_wp + r)))
            do m = 0, modes - 1
                associate (part => 2.0_wp*width*weights*(1.0_wp - t)*r*p(:, 2*m + 1))
                    self%waves(m, i - 1) = self%waves(m, i - 1) + sum(part*(1.0_wp - t)**2)
                    self%waves(m, i) = self%waves(m, i) + sum(part*(1.0_wp - (1.0_wp - t)**2))
                end associate
            end do
        end do
        factor = 2.0_wp*pi
        do m = 0, modes - 1
            self%waves(m, :) = factor*sqrt(0.5_wp*real(4*m + 1, wp))*self%waves(m, :)
            factor = -factor*real(2*m + 1, wp)/real(2*m + 2, wp)
        end do
    end subroutine set_waves

    !> int phi_i S phi_j 2 pi r dr = (2/E0*) int_0^a Q_i (Q_j + K Q_j) dx.
    subroutine line_compliance(hats, solver, a, matrix, modulus, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        real(wp), intent(in) :: a
        real(wp), intent(out), contiguous :: matrix(0:, 0:)
        !> E0* [modulus]
        real(wp), intent(out) :: modulus
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: interaction(:, :), coupled(:, :)
        integer :: m, n, stat

        n = hats%n + 1
        modulus = solver%springs%modulus
        call solver%springs%interaction(a, size(hats%waves, 1), interaction, error)
        if (allocated(error)) return
        matrix = hats%products
        m = size(interaction, 1)
        if (m > 0) then
            allocate (coupled(m, 0:hats%n), stat=stat)
            call check_memory(error, stat)
            if (allocated(error)) return
            call add_product("N", "N", m, n, m, 0.5_wp, interaction, m, hats%waves, size(hats%waves, 1), 0.0_wp, coupled, m)
            call add_product("T", "N", n, n, m, 1.0_wp, hats%waves, size(hats%waves, 1), coupled, m, 1.0_wp, matrix, n)
        end if
        matrix = (2.0_wp*a**3/modulus)*matrix
    end subroutine line_compliance

    !> int phi_i f 2 pi r dr, and which rings lie on the indenter.
    pure subroutine find_heights(hats, profile, extent, heights, reachable)
        type(hats_t), intent(in) :: hats
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: extent
        real(wp), intent(out) :: heights(0:)
        logical, intent(out) :: reachable(0:)
        integer :: c

        heights = 0.0_wp
        reachable = .true.
        do c = 1, hats%n
            if (extent*hats%nodes(c) > profile%largest_radius*(1.0_wp + epsilon(1.0_wp))) then
                reachable(c - 1:) = .false.
                exit
            end if
            associate (part => hats%weights(:, c)*extent**2*profile%height(extent*hats%radii(:, c)))
                heights(c - 1) = heights(c - 1) + sum(part*(1.0_wp - hats%rising(:, c)))
                heights(c) = heights(c) + sum(part*hats%rising(:, c))
            end associate
        end do
    end subroutine find_heights

end module mdrcontact_medium_hats
