! SPDX-License-Identifier: GPL-3.0-or-later
!> Description of an indenter for a contact of layered bodies: the even Legendre coefficients of g on the contact (theory/exact.md
!> (3.6)), G_j = int_-1^1 g(a |u|) s_j P_2j(u) du.
!>
!> Powers of x, and indenters with piecewise linear f', have closed forms. Elsewhere g is integrated between the radii where it is
!> not analytic, with room for the square roots that start there.
module mdrcontact_line_moments
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_piecewise, only: piecewise_moments
    use mdrcontact_line_rule, only: largest_rule, new_rule, rule_t
    use mdrcontact_line_series, only: add_projections
    use mdrcontact_line_slip_profile, only: slip_profile_t
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: edge_moment, is_smooth, profile_moments

    !> Towards the axis, where g may be any power, and towards a singular end, intervals shrink by this factor.
    real(wp), parameter :: shrinking = 0.25_wp
    !> Contribution relative to g(a) below which nothing towards the axis counts.
    real(wp), parameter :: negligible = 1.0e-18_wp
    integer, parameter :: most_intervals = 40
    !> So many nodes, and one for each polynomial of degree 2 j, take a half wave or less of it each.
    integer, parameter :: nodes_by_angle = 24

contains

    !> G_0 ... G_(m-1) [length].
    recursive subroutine profile_moments(profile, a, g, error)
        class(profile_t), intent(in), target :: profile
        !> contact radius [length]
        real(wp), intent(in) :: a
        real(wp), intent(out) :: g(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: exponents(:), coefficients(:), radii(:), slopes(:), curvatures(:)
        class(profile_t), pointer :: base
        real(wp) :: pieces(size(g))
        integer :: i

        select type (profile)
        type is (slip_profile_t)
            call profile_moments(profile%base, a, g, error)
            if (.not. allocated(error)) call profile%moments(a, g, error)
            return
        end select
        g = 0.0_wp
        call profile%powers(exponents, coefficients)
        if (size(exponents) == 0) then
            call profile%linear_pieces(radii, slopes, curvatures, base)
            if (size(radii) > 0) then
                if (associated(base)) call profile_moments(base, a, g, error)
                call piecewise_moments(radii, slopes, curvatures, a, pieces)
                g = g + pieces*normalisation(size(g))
                return
            end if
            if (profile%sharp_radius > 0.0_wp) then
                call integrate_by_angle(profile, a, g, error)
            else
                call integrate(profile, a, g, error)
            end if
        end if
        do i = 1, size(exponents)
            call add_power(exponents(i), coefficients(i)*a**exponents(i), g)
        end do
        g = g*normalisation(size(g))
    end subroutine profile_moments

    !> Whether g is a polynomial in x^2, with few coefficients, or a sphere's, which is close to one unless a is close to R.
    pure recursive function is_smooth(profile) result(answer)
        class(profile_t), intent(in) :: profile
        logical :: answer
        real(wp), allocatable :: exponents(:), coefficients(:)

        select type (profile)
        type is (slip_profile_t)
            answer = is_smooth(profile%base)
            return
        end select
        answer = profile%is_spherical()
        if (answer) return
        call profile%powers(exponents, coefficients)
        answer = size(exponents) > 0 .and. all(modulo(exponents, 2.0_wp) == 0.0_wp)
    end function is_smooth

    !> int_-1^1 |u|^s P_2j(u) du = 2 t_j, t_(j+1) = t_j (s - 2j)/(s + 2j + 3).
    pure subroutine add_power(exponent, coefficient, g)
        real(wp), intent(in) :: exponent, coefficient
        real(wp), intent(inout) :: g(0:)
        real(wp) :: t
        integer :: j

        t = 2.0_wp*coefficient/(exponent + 1.0_wp)
        do j = 0, ubound(g, 1)
            g(j) = g(j) + t
            t = t*(exponent - 2.0_wp*j)/(exponent + 2.0_wp*j + 3.0_wp)
        end do
    end subroutine add_power

    subroutine integrate(profile, a, g, error)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(inout) :: g(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)
        real(wp) :: low, high, ends
        integer :: i, k

        call profile%add_breaks(breaks, error)
        if (allocated(error)) return
        breaks = [breaks(:count(breaks < a)), a]
        low = 0.0_wp
        do i = 1, size(breaks)
            high = breaks(i)
            if (high <= profile%end_radius) then
                low = high
                cycle
            end if
            if (i == 1 .and. .not. profile%is_spherical()) then
                ! intervals towards the axis, from the lowest
                ends = high
                do k = 1, most_intervals
                    if (.not. profile%mdr(ends)*ends > negligible*profile%mdr(a)*a) exit
                    ends = shrinking*ends
                end do
                do k = k - 1, 1, -1
                    call add_interval(profile, a, shrinking**k*high, shrinking**(k - 1)*high, .false., g, error)
                end do
            else
                do k = 1, most_intervals
                    ! no interval longer than three times its distance from a singular end
                    ends = high
                    if ((high - low)/3.0_wp > profile%singular_radius - high) then
                        ends = low + 0.75_wp*(profile%singular_radius - low)
                    end if
                    ends = min(ends, high)
                    call add_interval(profile, a, low, ends, k == 1 .and. i > 1, g, error)
                    low = ends
                    if (low >= high) exit
                end do
            end if
            if (allocated(error)) return
            low = high
        end do
    end subroutine integrate

    !> Under an imprint g is an entire function of phi, x = A sin(phi), up to its sharp end.
    subroutine integrate_by_angle(profile, a, g, error)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(inout) :: g(:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable, dimension(:) :: angle, u, w
        real(wp) :: largest
        integer :: i, parts, n

        largest = asin(min(a/profile%sharp_radius, 1.0_wp))
        n = nodes_by_angle + size(g)
        parts = 1 + (n - 1)/largest_rule
        call new_rule(rule, 1 + (n - 1)/parts, error)
        if (allocated(error)) return
        do i = 1, parts
            angle = largest*(real(i - 1, wp) + 0.5_wp*rule%distance)/real(parts, wp)
            u = min(sin(angle)*(profile%sharp_radius/a), 1.0_wp)
            w = rule%weights*cos(angle)*(profile%sharp_radius/a*largest/parts)*profile%mdr_at(a*u)
            call add_projections(size(u), u, w, g)
        end do
    end subroutine integrate_by_angle

    !> (a/pi) int_-1^1 X(a (1 - u)) (g(a |u|) - mean) du, what g adds to K g at the edge of the contact.
    subroutine edge_moment(profile, kernel, a, shift, mean, total, error)
        class(profile_t), intent(in) :: profile
        type(kernel_t), intent(in) :: kernel
        !> contact radius [length]
        real(wp), intent(in) :: a
        !> a constant taken off X [1/unit], which adds nothing where `mean` is that of g [length]
        real(wp), intent(in) :: shift, mean
        real(wp), intent(out) :: total
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable, dimension(:) :: x, weights, near, far, breaks

        ! X varies at the scale of the distance from the edge, down to the unit
        call profile%add_breaks(breaks, error)
        call graded_rule(smallest_panel_ratio*a, a, breaks, a + 0.1_wp*kernel%unit, x, weights, error)
        total = 0.0_wp
        if (allocated(error)) return
        allocate (near, far, mold=x)
        call kernel%evaluate(max(a - x, 0.0_wp)/kernel%unit, shift, near)
        call kernel%evaluate((a + x)/kernel%unit, shift, far)
        total = sum(weights*(near + far)*(profile%mdr_at(x) - mean))/(pi*kernel%unit)
    end subroutine edge_moment

    !> Adds 2 int P_2j(x/a) g(x) dx/a over one interval, x = low + (high - low) t^2 where a root starts at its lower end.
    subroutine add_interval(profile, a, low, high, has_root, g, error)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, low, high
        logical, intent(in) :: has_root
        real(wp), intent(inout) :: g(0:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable, dimension(:) :: t, x, w
        integer :: i, n, parts

        ! P_2j runs through 2j/pi half waves as acos(x/a) goes through a right angle
        n = 16 + ceiling(real(size(g), wp)*(acos(low/a) - acos(min(high/a, 1.0_wp)))*merge(1.3_wp, 1.0_wp, has_root))
        ! and is a polynomial of degree 2j
        n = min(n, 20 + size(g)*merge(2, 1, has_root))
        parts = 1 + (n - 1)/largest_rule
        call new_rule(rule, 1 + (n - 1)/parts, error)
        if (allocated(error)) return
        do i = 1, parts
            t = (real(i - 1, wp) + 0.5_wp*rule%distance)/real(parts, wp)
            w = rule%weights*((high - low)/(a*parts))
            if (has_root) then
                w = 2.0_wp*t*w
                t = t**2
            end if
            x = min(low + (high - low)*t, high)
            w = w*profile%mdr(x)
            call add_projections(size(x), x/a, w, g)
        end do
    end subroutine add_interval

end module mdrcontact_line_moments
