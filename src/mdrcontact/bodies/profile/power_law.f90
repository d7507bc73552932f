! SPDX-License-Identifier: GPL-3.0-or-later
!> Power-law indenters f(r) = c r^n, with the paraboloid (n = 2) and the cone (n = 1) as their named cases.
module mdrcontact_profile_power_law
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_inclination, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: power_law_t, new_power_law, new_paraboloid, new_cone

    integer, parameter :: by_exponent = 0, by_radius = 1, by_inclination = 2

    !> f(r) = c r^n, g(x) = kappa_n c x^n. Popov 2014, table after equation (4).
    type, extends(profile_t) :: power_law_t
        private
        !> c [length^(1-n)]
        real(wp) :: coefficient = 0.0_wp
        !> n [1]
        real(wp) :: exponent = 0.0_wp
        !> kappa_n c
        real(wp) :: mdr_coefficient = 0.0_wp
        !> which of its procedures made it, and from which one number: R or phi
        integer :: made_by = by_exponent
        real(wp) :: given = 0.0_wp
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: radius_from_mdr
        procedure :: powers
        procedure :: parameters
        procedure :: set
    end type power_law_t

contains

    !> An indenter f(r) = c r^n.
    subroutine new_power_law(self, exponent, coefficient, error)
        type(power_law_t), intent(out) :: self
        !> n > 0, at most 100
        real(wp), intent(in) :: exponent
        !> c > 0 [length^(1-n)]
        real(wp), intent(in) :: coefficient
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "exponent", exponent)
        call check_positive(error, "coefficient", coefficient)
        if (exponent > 100.0_wp) call raise(error, error_invalid, "exponent = "//to_text(exponent)// &
                                            ": it must be at most 100. For larger exponents use a flat punch")
        if (allocated(error)) return

        self%exponent = exponent
        self%coefficient = coefficient
        if (exponent == 2.0_wp) self%paraboloid_radius = 0.5_wp/coefficient
        self%mdr_coefficient = coefficient*0.5_wp*sqrt(pi)*exponent &
                               *exp(log_gamma(0.5_wp*exponent) - log_gamma(0.5_wp*(exponent + 1.0_wp)))
        self%is_made = .not. allocated(error)
    end subroutine new_power_law

    !> A paraboloid f(r) = r^2/(2R): a sphere of radius R in contacts small against R.
    subroutine new_paraboloid(self, radius, error)
        type(power_law_t), intent(out) :: self
        !> radius of curvature R > 0 at the tip [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        self%exponent = 2.0_wp
        self%coefficient = 0.5_wp/radius
        self%paraboloid_radius = 0.5_wp/self%coefficient
        self%mdr_coefficient = 1.0_wp/radius
        self%made_by = by_radius
        self%given = radius
        self%is_made = .not. allocated(error)
    end subroutine new_paraboloid

    !> A cone f(r) = r tan(phi).
    subroutine new_cone(self, inclination, error)
        type(power_law_t), intent(out) :: self
        !> phi, the angle between face and surface, 0 < phi < pi/2 [radian]; pi/2 minus the half-angle
        real(wp), intent(in) :: inclination
        type(error_t), allocatable, intent(out) :: error

        call check_inclination(error, inclination)
        if (allocated(error)) return
        self%exponent = 1.0_wp
        self%coefficient = tan(inclination)
        self%mdr_coefficient = half_pi*self%coefficient
        self%made_by = by_inclination
        self%given = inclination
        self%is_made = .not. allocated(error)
    end subroutine new_cone

    pure subroutine parameters(self, list)
        class(power_law_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        select case (self%made_by)
        case (by_radius); list = [parameter_t("radius", self%given)]
        case (by_inclination); list = [parameter_t("inclination", self%given)]
        case default; list = [parameter_t("exponent", self%exponent), parameter_t("coefficient", self%coefficient)]
        end select
    end subroutine parameters

    subroutine set(self, values, error)
        class(power_law_t), intent(inout) :: self
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        select case (self%made_by)
        case (by_radius); call new_paraboloid(self, values(1), error)
        case (by_inclination); call new_cone(self, values(1), error)
        case default; call new_power_law(self, values(1), values(2), error)
        end select
    end subroutine set

    elemental function height(self, x) result(y)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%coefficient*power(x, self%exponent)
    end function height

    elemental function slope(self, x) result(y)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%coefficient*self%exponent*power(x, self%exponent - 1.0_wp)
    end function slope

    elemental function mdr(self, x) result(y)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%mdr_coefficient*power(x, self%exponent)
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%mdr_coefficient*self%exponent*power(x, self%exponent - 1.0_wp)
    end function mdr_slope

    elemental function mdr_moment(self, x) result(y)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%mdr_coefficient*self%exponent/(self%exponent + 1.0_wp)*power(x, self%exponent)*x
    end function mdr_moment

    pure function radius_from_mdr(self, depth) result(radius)
        class(power_law_t), intent(in) :: self
        real(wp), intent(in) :: depth
        real(wp) :: radius

        if (self%exponent == 2.0_wp) then
            radius = sqrt(depth/self%mdr_coefficient)
        else
            radius = (depth/self%mdr_coefficient)**(1.0_wp/self%exponent)
        end if
    end function radius_from_mdr

    pure subroutine powers(self, exponents, coefficients)
        class(power_law_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: exponents(:), coefficients(:)

        allocate (exponents(1), coefficients(1))
        exponents = self%exponent
        coefficients = self%mdr_coefficient
    end subroutine powers

    !> x**n without the cost of a general power for the cone and the paraboloid.
    elemental function power(x, n) result(y)
        real(wp), intent(in) :: x, n
        real(wp) :: y

        if (n == 1.0_wp) then
            y = x
        else if (n == 2.0_wp) then
            y = x*x
        else if (n == 0.0_wp) then
            y = 1.0_wp
        else
            y = x**n
        end if
    end function power

end module mdrcontact_profile_power_law
