! SPDX-License-Identifier: GPL-3.0-or-later
!> The profile in the basis of the Galerkin system: g_j = int_0^pi g(a cos theta) cos 2 j theta d theta, and its slope over a
!> (theory/surfaces.md (6.5), (6.10)).
module mdrcontact_tension_moments
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_grid, only: order_for
    implicit none (type, external)
    private
    public :: profile_moments

    !> Nodes of a panel without waves, and more of them for each cosine.
    integer, parameter :: fewest = 20, per_wave = 2
    !> Step of the difference that makes the couple's slope, where g is no power [a].
    real(wp), parameter :: step = 0.02_wp

contains

    !> g_j and g_j'; before them, with a plate, those of the ring couple, -a g_0'.
    subroutine profile_moments(profile, a, couple, moments, slopes, error)
        class(profile_t), intent(in) :: profile
        !> contact radius [length]
        real(wp), intent(in) :: a
        !> 1 with a plate, else 0
        integer, intent(in) :: couple
        !> same sizes [length] and [1]
        real(wp), intent(out) :: moments(:), slopes(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: exponents(:), coefficients(:)
        integer :: i, n

        n = size(moments)
        call profile%powers(exponents, coefficients)
        moments = 0.0_wp
        slopes = 0.0_wp
        if (a <= profile%end_radius) return
        if (size(exponents) == 0) then
            call integrate(profile, a, moments(couple + 1:), slopes(couple + 1:), error)
            if (couple == 1 .and. .not. allocated(error)) call difference(profile, a, slopes(2), moments(1), slopes(1), error)
            return
        end if
        do i = 1, size(exponents)
            associate (of_power => coefficients(i)*a**exponents(i)*power_moments(exponents(i), n - couple))
                moments(couple + 1:) = moments(couple + 1:) + of_power
                slopes(couple + 1:) = slopes(couple + 1:) + exponents(i)/a*of_power
                if (couple == 0) cycle
                moments(1) = moments(1) - exponents(i)*of_power(1)
                slopes(1) = slopes(1) - exponents(i)**2/a*of_power(1)
            end associate
        end do
    end subroutine profile_moments

    !> int_0^pi |cos|^s cos 2 j theta d theta.
    pure function power_moments(s, n) result(values)
        real(wp), intent(in) :: s
        integer, intent(in) :: n
        real(wp) :: values(n)
        integer :: j

        values(1) = sqrt(pi)*exp(log_gamma(0.5_wp*(s + 1.0_wp)) - log_gamma(0.5_wp*s + 1.0_wp))
        do j = 1, n - 1
            values(j + 1) = values(j)*(0.5_wp*s - real(j - 1, wp))/(0.5_wp*s + real(j, wp))
        end do
    end function power_moments

    !> By panels in phi = arcsin(x/a), graded towards the axis and where g is not analytic.
    subroutine integrate(profile, a, moments, slopes, error)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: moments(:), slopes(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: radii(:), phi(:), weight(:), x(:), height(:), rise(:), wave(:)
        integer :: j

        call profile%add_breaks(radii, error)
        if (allocated(error)) return
        call graded_rule(half_pi*smallest_panel_ratio, half_pi, asin(radii(:count(radii < a))/a), huge(1.0_wp), phi, weight, &
                         error, per_panel=order_for(fewest + per_wave*size(moments)))
        if (allocated(error)) return
        x = min(a*sin(phi), a)
        height = 2.0_wp*weight*profile%mdr_at(x)
        rise = 2.0_wp*weight*x*profile%mdr_slope(x)/a
        where (x <= profile%end_radius) rise = 0.0_wp
        do j = 0, size(moments) - 1
            wave = (-1)**j*cos(2.0_wp*j*phi)
            moments(j + 1) = dot_product(height, wave)
            slopes(j + 1) = dot_product(rise, wave)
        end do
    end subroutine integrate

    !> The couple's -a b_0' and its slope over a, by differences of the sixth order.
    subroutine difference(profile, a, slope, moment, rate, error)
        class(profile_t), intent(in) :: profile
        !> and b_0'
        real(wp), intent(in) :: a, slope
        real(wp), intent(out) :: moment, rate
        type(error_t), allocatable, intent(inout) :: error
        real(wp), parameter :: factors(3) = [0.75_wp, -0.15_wp, 1.0_wp/60.0_wp]
        real(wp), allocatable :: radii(:)
        real(wp) :: unused(1), above(1), below(1)
        integer :: i

        moment = -a*slope
        rate = 0.0_wp
        call profile%add_breaks(radii, error)
        if (allocated(error)) return
        if (size(radii) > 0 .or. (1.0_wp + 3.0_wp*step)*a > profile%largest_radius) then
            call raise(error, error_invalid, "surface bending: a plate needs a smooth indenter and contacts well inside its "// &
                       "largest radius. This one has a corner, a flat end or an end there")
            return
        end if
        do i = 1, size(factors)
            call integrate(profile, a*(1.0_wp + i*step), unused, above, error)
            if (.not. allocated(error)) call integrate(profile, a*(1.0_wp - i*step), unused, below, error)
            if (allocated(error)) return
            rate = rate - factors(i)*((1.0_wp + i*step)*above(1) - (1.0_wp - i*step)*below(1))/step
        end do
    end subroutine difference

end module mdrcontact_tension_moments
