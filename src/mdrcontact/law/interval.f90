! SPDX-License-Identifier: GPL-3.0-or-later
!> Piecewise polynomials whose panel is read off the bits of the abscissa: no search, no logarithm.
!>
!> An interval covers s between two ends. From s it takes u = side (s - origin), or the root of it where the branch has a
!> fold or a break at its origin, and y = scale u + offset, which runs from 1 to a little below a power of two times a
!> short fraction. Every octave of y is cut into 2^bits equal panels: exponent and leading mantissa bits of y are the
!> panel's number, the remaining ones the place in it. Panels so shrink in proportion to the distance from the origin,
!> where the laws of contact have their only singularity, and one low degree serves for all of them.
module mdrcontact_law_interval
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: interval_t, place_t, new_interval, scale_interval, interval_place, interval_rate, panel_count, u_of_y, panel_ends
    public :: polynomial, polynomial_slope
    public :: coefficient_count, column_count, most_bits

    !> Coefficients of a polynomial (one cache line), and columns: F or d; a; k.
    integer, parameter :: coefficient_count = 8, column_count = 3
    !> Panels are at least 2^-most_bits of an octave long.
    integer, parameter :: most_bits = 12
    integer, parameter :: mantissa_bits = 52
    integer(int64), parameter :: mantissa_mask = shiftl(1_int64, mantissa_bits) - 1_int64
    !> the bits of 1.0, and of the exponent field of 2^e 2^-e
    integer(int64), parameter :: bits_of_one = shiftl(1023_int64, mantissa_bits)
    integer(int64), parameter :: twice_bias = shiftl(2046_int64, mantissa_bits)
    !> y stays this far (relatively) below the end of the last panel
    real(wp), parameter :: below_one = 1.0_wp - 8.0_wp*epsilon(1.0_wp)

    !> A part of s between two points where the branch is not analytic.
    type :: interval_t
        !> s at both ends
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        real(wp) :: origin = 0.0_wp
        !> +1 where s grows away from the origin, -1 where it falls
        real(wp) :: side = 1.0_wp
        logical :: root = .false.
        real(wp) :: scale = 1.0_wp, offset = 0.0_wp, last_y = 1.0_wp
        !> the slope of a root is taken no closer to its origin than this
        real(wp) :: smallest_root = 0.0_wp
        integer :: bits = 2
        !> number of the first panel, counted from 0, less that of y = 1
        integer :: first_panel = 0
    end type interval_t

    !> Where a point lies: its panel, counted from 1, and its place in it.
    type :: place_t
        integer :: panel = 1
        real(wp) :: t = 0.0_wp
    end type place_t

contains

    !> An interval from u_low to u_high (before the root, if any) in panels of 2^-bits of an octave. With `margin` the
    !> geometric series of panels ends at margin*(u_high - u_low) before u_low instead of at u = 0.
    pure function new_interval(origin, side, root, u_low, u_high, margin, bits) result(self)
        real(wp), intent(in) :: origin, side, u_low, u_high, margin
        logical, intent(in) :: root
        integer, intent(in) :: bits
        type(interval_t) :: self
        real(wp) :: low, high, ratio, power

        low = u_low
        high = u_high
        if (root) then
            low = sqrt(low)
            high = sqrt(high)
        end if
        self%origin = origin
        self%side = side
        self%root = root
        self%bits = bits
        self%lowest = origin + side*merge(u_low, u_high, side > 0.0_wp)
        self%highest = origin + side*merge(u_high, u_low, side > 0.0_wp)
        if (margin > 0.0_wp) then
            ratio = 1.0_wp + 1.0_wp/margin
        else
            ratio = high/low
        end if
        power = 2.0_wp**exponent(ratio)*0.5_wp
        self%last_y = power*(1.0_wp + ceiling((ratio/power - 1.0_wp)*2.0_wp**bits)*0.5_wp**bits)*below_one
        self%scale = (self%last_y - 1.0_wp)/(high - low)
        self%offset = 1.0_wp - self%scale*low
        self%smallest_root = 1.0e-9_wp*high
    end function new_interval

    !> The interval of factor*s: each value keeps its panel and its place therein.
    pure subroutine scale_interval(self, factor)
        type(interval_t), intent(inout) :: self
        !> > 0
        real(wp), intent(in) :: factor
        real(wp) :: stretch

        stretch = factor
        if (self%root) stretch = sqrt(factor)
        self%lowest = factor*self%lowest
        self%highest = factor*self%highest
        self%origin = factor*self%origin
        self%scale = self%scale/stretch
        self%smallest_root = stretch*self%smallest_root
    end subroutine scale_interval

    !> How many panels an interval has.
    pure function panel_count(self) result(count)
        type(interval_t), intent(in) :: self
        integer :: count

        count = int(shiftr(transfer(self%last_y, 1_int64) - bits_of_one, mantissa_bits - self%bits)) + 1
    end function panel_count

    !> The panel of s and the place in it, -1 <= t <= 1. s outside is moved to the nearer end.
    pure function interval_place(self, s) result(place)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: s
        type(place_t) :: place
        real(wp) :: u
        integer(int64) :: bits

        u = self%side*(s - self%origin)
        if (self%root) u = sqrt(max(u, 0.0_wp))
        bits = transfer(min(max(self%scale*u + self%offset, 1.0_wp), self%last_y), bits)
        place%panel = self%first_panel + int(shiftr(bits - bits_of_one, mantissa_bits - self%bits)) + 1
        bits = ior(iand(shiftl(bits, self%bits), mantissa_mask), bits_of_one)
        place%t = 2.0_wp*transfer(bits, 1.0_wp) - 3.0_wp
    end function interval_place

    !> dt/ds at s.
    pure function interval_rate(self, s) result(rate)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp) :: rate
        real(wp) :: u
        integer(int64) :: bits

        u = self%side*(s - self%origin)
        rate = self%side*self%scale
        if (self%root) then
            u = max(sqrt(max(u, 0.0_wp)), self%smallest_root)
            rate = 0.5_wp*rate/u
        end if
        bits = transfer(min(max(self%scale*u + self%offset, 1.0_wp), self%last_y), bits)
        bits = twice_bias - iand(bits, not(mantissa_mask)) + shiftl(int(self%bits + 1, int64), mantissa_bits)
        rate = rate*transfer(bits, 1.0_wp)
    end function interval_rate

    !> y at both ends of panel i = 1, ..., panel_count(self).
    pure function panel_ends(self, i) result(ends)
        type(interval_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp) :: ends(2)

        ends(1) = transfer(bits_of_one + shiftl(int(i - 1, int64), mantissa_bits - self%bits), 1.0_wp)
        ends(2) = transfer(bits_of_one + shiftl(int(i, int64), mantissa_bits - self%bits), 1.0_wp)
    end function panel_ends

    !> The distance from the origin at y.
    pure function u_of_y(self, y) result(u)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: y
        real(wp) :: u

        u = (y - self%offset)/self%scale
        if (self%root) u = max(u, 0.0_wp)**2
    end function u_of_y

    !> c(1) + c(2) t + ...; even and odd powers apart, which a processor computes side by side.
    pure function polynomial(c, t) result(y)
        real(wp), intent(in) :: c(coefficient_count), t
        real(wp) :: y
        real(wp) :: q

        q = t*t
        y = (c(1) + q*(c(3) + q*(c(5) + q*c(7)))) + t*(c(2) + q*(c(4) + q*(c(6) + q*c(8))))
    end function polynomial

    !> Its derivative with respect to t.
    pure function polynomial_slope(c, t) result(y)
        real(wp), intent(in) :: c(coefficient_count), t
        real(wp) :: y
        real(wp) :: q

        q = t*t
        y = (c(2) + q*(3.0_wp*c(4) + q*(5.0_wp*c(6) + q*(7.0_wp*c(8))))) + t*(2.0_wp*c(3) + q*(4.0_wp*c(5) + q*(6.0_wp*c(7))))
    end function polynomial_slope

end module mdrcontact_law_interval
