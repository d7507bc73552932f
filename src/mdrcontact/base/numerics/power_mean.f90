! SPDX-License-Identifier: GPL-3.0-or-later
!> Weighted power means of positive numbers, [sum w_i x_i^p]^(1/p) with sum w_i = 1: arithmetic for p = 1, harmonic for p = -1,
!> geometric as p -> 0.
!>
!> The weighted sum is of transformed numbers phi(x), the mean is phi's inverse of it. Where x^p hardly varies, phi is
!> ((x/r)^p - 1)/p with a reference r, which goes over into ln(x/r) and loses no digits.
module mdrcontact_numerics_power_mean
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: power_mean_t, new_power_mean

    !> The mean of exponent p for numbers of a known range.
    type :: power_mean_t
        private
        real(wp) :: exponent = 1.0_wp
        !> r
        real(wp) :: reference = 1.0_wp
        !> whether x^p hardly varies
        logical :: is_flat = .false.
    contains
        !> phi(x)
        procedure :: transformed
        !> the mean that belongs to a weighted sum of phi, and its derivative with respect to this sum
        procedure :: mean
        procedure :: mean_slope
        !> the change of the sum that belongs to a relative change of the mean
        procedure :: relative_unit
    end type power_mean_t

    interface

        pure function expm1(x) result(value) bind(C)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: value
        end function expm1

        pure function log1p(x) result(value) bind(C)
            import :: c_double
            real(c_double), value :: x
            real(c_double) :: value
        end function log1p

    end interface

contains

    !> The mean of exponent p for numbers between the smallest and the largest of `x` > 0.
    pure subroutine new_power_mean(self, exponent, x, error)
        type(power_mean_t), intent(out) :: self
        !> -1 <= p <= 1
        real(wp), intent(in) :: exponent
        real(wp), intent(in) :: x(:)
        type(error_t), allocatable, intent(inout) :: error

        if (.not. abs(exponent) <= 1.0_wp) then
            call raise(error, error_invalid, "exponent = "//to_text(exponent)//": the exponent of a power mean must lie in "// &
                       "[-1, 1], from series to parallel")
            return
        end if
        self%exponent = exponent
        if (abs(exponent) == 1.0_wp) return
        self%reference = sqrt(minval(x))*sqrt(maxval(x))
        self%is_flat = abs(exponent)*log(maxval(x)/minval(x)) < 1.0_wp
    end subroutine new_power_mean

    elemental function transformed(self, x) result(phi)
        class(power_mean_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: phi

        if (self%exponent == 1.0_wp) then
            phi = x
        else if (self%exponent == -1.0_wp) then
            phi = 1.0_wp/x
        else if (.not. self%is_flat) then
            phi = (x/self%reference)**self%exponent
        else
            phi = log(x/self%reference)
            if (self%exponent /= 0.0_wp) phi = expm1(self%exponent*phi)/self%exponent
        end if
    end function transformed

    elemental function mean(self, phi) result(x)
        class(power_mean_t), intent(in) :: self
        real(wp), intent(in) :: phi
        real(wp) :: x

        if (self%exponent == 1.0_wp) then
            x = phi
        else if (self%exponent == -1.0_wp) then
            x = 1.0_wp/phi
        else if (.not. self%is_flat) then
            x = self%reference*phi**(1.0_wp/self%exponent)
        else if (self%exponent /= 0.0_wp) then
            x = self%reference*exp(log1p(self%exponent*phi)/self%exponent)
        else
            x = self%reference*exp(phi)
        end if
    end function mean

    elemental function mean_slope(self, phi) result(slope)
        class(power_mean_t), intent(in) :: self
        real(wp), intent(in) :: phi
        real(wp) :: slope
        real(wp) :: x

        x = self%mean(phi)
        if (self%exponent == 1.0_wp) then
            slope = 1.0_wp
        else if (self%exponent == -1.0_wp) then
            slope = -x**2
        else if (.not. self%is_flat) then
            slope = x/(self%exponent*phi)
        else
            slope = x/(1.0_wp + self%exponent*phi)
        end if
    end function mean_slope

    !> |dphi/d ln x| > 0 as a function of phi; what is not greater than 0 belongs to no mean.
    elemental function relative_unit(self, phi) result(unit)
        class(power_mean_t), intent(in) :: self
        real(wp), intent(in) :: phi
        real(wp) :: unit

        if (abs(self%exponent) == 1.0_wp) then
            unit = phi
        else if (.not. self%is_flat) then
            unit = abs(self%exponent)*phi
        else
            unit = 1.0_wp + self%exponent*phi
        end if
    end function relative_unit

end module mdrcontact_numerics_power_mean
