! SPDX-License-Identifier: GPL-3.0-or-later
!> Piecewise polynomials whose panel is read off the bits of the abscissa: no search, no logarithm.
!>
!> An interval covers s between two ends by y = scale s + offset, or scale sqrt(side (s - origin)) + offset where the branch has a
!> fold or a break at its origin; y runs from 1 to a little below a power of two times a short fraction. Every octave of y is cut
!> into 2^bits equal panels: exponent and leading mantissa bits of y are the panel's number, and t = y less the panel's middle is
!> the place in it. Panels so shrink proportionally to the distance from the origin, where the laws of contact have their only
!> singularity, and one low degree serves for all of them. Coefficients are those of powers of t.
module mdrcontact_law_interval
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: interval_t, place_t, row_t, new_interval, scale_interval, interval_place, interval_rate
    public :: panel_count, panel_ends, u_of_y, shift_of, in_units_of, contains_ends
    public :: polynomial, polynomial_with_slope, polynomial_moments
    public :: coefficient_count, column_count, most_bits

    !> Coefficients of a polynomial (one cache line), and columns: F or d; a; k.
    integer, parameter :: coefficient_count = 8, column_count = 3
    !> Panels are at least 2^-most_bits of an octave long.
    integer, parameter :: most_bits = 12
    integer, parameter :: mantissa_bits = 52
    !> the bits of 1.0
    integer(int64), parameter :: bits_of_one = shiftl(1023_int64, mantissa_bits)
    !> y stays this far (relatively) within the first and the last panel, more than rounding can move it
    real(wp), parameter :: above_one = 1.0_wp + 8.0_wp*epsilon(1.0_wp), below_one = 1.0_wp - 8.0_wp*epsilon(1.0_wp)

    !> The coefficients of one polynomial.
    type :: row_t
        real(wp) :: c(coefficient_count) = 0.0_wp
    end type row_t

    !> A part of s between two points where the branch is not analytic.
    type :: interval_t
        !> s at both ends
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        real(wp) :: scale = 1.0_wp, offset = 0.0_wp, last_y = 1.0_wp
        !> whether y has a root in it: of the distance from the origin, side = +1 above it and -1 below
        logical :: root = .false.
        real(wp) :: origin = 0.0_wp, side = 1.0_wp
        !> the slope of a root is taken no closer to its origin than this
        real(wp) :: smallest_root = 0.0_wp
        integer :: bits = 2
        !> number of the first panel, counted from 0
        integer :: first_panel = 0
    end type interval_t

    !> Where a point lies: its panel, counted from 1, and its place in it.
    type :: place_t
        integer :: panel = 1
        real(wp) :: t = 0.0_wp
    end type place_t

contains

    !> An interval from u_low to u_high, distances from the origin, in panels of 2^-bits of an octave. With `margin` the
    !> geometric series of panels ends at margin*(u_high - u_low) before u_low instead of at u = 0.
    pure function new_interval(origin, side, root, u_low, u_high, margin, bits) result(self)
        !> side = 1 without a root
        real(wp), intent(in) :: origin, side, u_low, u_high, margin
        logical, intent(in) :: root
        integer, intent(in) :: bits
        type(interval_t) :: self
        real(wp) :: low, high, ratio, power

        self%bits = bits
        self%root = root
        self%lowest = origin + side*merge(u_low, u_high, side > 0.0_wp)
        self%highest = origin + side*merge(u_high, u_low, side > 0.0_wp)
        if (root) then
            self%origin = origin
            self%side = side
            low = sqrt(u_low)
            high = sqrt(u_high)
        else
            low = self%lowest
            high = self%highest
        end if
        if (margin > 0.0_wp) then
            ratio = 1.0_wp + 1.0_wp/margin
        else
            ratio = high/low
        end if
        power = 2.0_wp**exponent(ratio)*0.5_wp
        self%last_y = power*(1.0_wp + ceiling((ratio/power - 1.0_wp)*2.0_wp**bits)*0.5_wp**bits)*below_one
        self%scale = (self%last_y - above_one)/(high - low)
        self%offset = above_one - self%scale*low
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

    !> By how many bits y is shifted to give its panel.
    pure function shift_of(self) result(shift)
        type(interval_t), intent(in) :: self
        integer :: shift

        shift = mantissa_bits - self%bits
    end function shift_of

    !> Number of panels of an interval.
    pure function panel_count(self) result(count)
        type(interval_t), intent(in) :: self
        integer :: count

        count = panel_of(self, self%last_y)
    end function panel_count

    !> The panel of the interval's own in which y lies, from 1; less for y < 1.
    pure function panel_of(self, y) result(panel)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: y
        integer :: panel

        panel = int(shifta(transfer(y, 1_int64) - bits_of_one, shift_of(self))) + 1
    end function panel_of

    !> Whether the ends of an interval without a root lie in its panels, and hence all that is between: needed where callers do not
    !> move y there.
    pure function contains_ends(self) result(within)
        type(interval_t), intent(in) :: self
        logical :: within
        real(wp) :: y(2)

        y = self%scale*[self%lowest, self%highest] + self%offset
        within = .not. self%root .and. self%scale > 0.0_wp .and. y(1) >= 1.0_wp .and. panel_of(self, y(2)) <= panel_count(self)
    end function contains_ends

    !> y at s; where s lies outside, at the nearer end.
    pure function y_of(self, s) result(y)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp) :: y

        if (self%root) then
            y = self%scale*sqrt(max(self%side*(s - self%origin), 0.0_wp)) + self%offset
        else
            y = self%scale*s + self%offset
        end if
        y = min(max(y, 1.0_wp), self%last_y)
    end function y_of

    !> The panel of s and the place in it. s outside is moved to the nearer end.
    pure function interval_place(self, s) result(place)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: s
        type(place_t) :: place
        real(wp) :: y
        integer(int64) :: bits, half

        y = y_of(self, s)
        bits = transfer(y, bits)
        half = shiftl(1_int64, shift_of(self) - 1)
        place%panel = self%first_panel + panel_of(self, y)
        place%t = y - transfer(ior(iand(bits, not(2_int64*half - 1_int64)), half), 1.0_wp)
    end function interval_place

    !> dt/ds at s.
    pure function interval_rate(self, s) result(rate)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp) :: rate

        rate = self%scale
        if (self%root) then
            rate = self%side*(0.5_wp*rate/max(sqrt(max(self%side*(s - self%origin), 0.0_wp)), self%smallest_root))
        end if
    end function interval_rate

    !> y at both ends of panel i = 1, ..., panel_count(self).
    pure function panel_ends(self, i) result(ends)
        type(interval_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp) :: ends(2)

        ends(1) = transfer(bits_of_one + shiftl(int(i - 1, int64), shift_of(self)), 1.0_wp)
        ends(2) = transfer(bits_of_one + shiftl(int(i, int64), shift_of(self)), 1.0_wp)
    end function panel_ends

    !> The coefficients of this polynomial in powers of unit*t, where unit is a power of two: no bit is lost.
    pure function in_units_of(c, unit) result(scaled)
        real(wp), intent(in) :: c(coefficient_count), unit
        real(wp) :: scaled(coefficient_count)
        integer :: i

        do i = 1, coefficient_count
            scaled(i) = c(i)/unit**(i - 1)
        end do
    end function in_units_of

    !> s, or with a root its distance from the origin, at y.
    pure function u_of_y(self, y) result(u)
        type(interval_t), intent(in) :: self
        real(wp), intent(in) :: y
        real(wp) :: u

        u = (y - self%offset)/self%scale
        if (self%root) u = max(u, 0.0_wp)**2
    end function u_of_y

    !> c(1) + c(2) t + ...; even and odd powers apart, which a processor computes side by side. The same operations in the same
    !> order as in include/mdrcontact_law.h: bitwise identical results.
    pure function polynomial(c, t) result(y)
        real(wp), intent(in) :: c(coefficient_count), t
        real(wp) :: y
        real(wp) :: q

        q = t*t
        y = (c(1) + q*(c(3) + q*(c(5) + q*c(7)))) + t*(c(2) + q*(c(4) + q*(c(6) + q*c(8))))
    end function polynomial

    !> The same and its derivative with respect to t in one pass.
    pure subroutine polynomial_with_slope(c, t, y, slope)
        real(wp), intent(in) :: c(coefficient_count), t
        real(wp), intent(out) :: y, slope
        real(wp) :: q, even, odd, even_slope, odd_slope

        q = t*t
        even = c(5) + q*c(7)
        odd = c(6) + q*c(8)
        even_slope = even + q*c(7)
        odd_slope = odd + q*c(8)
        even = c(3) + q*even
        odd = c(4) + q*odd
        even_slope = even + q*even_slope
        odd_slope = odd + q*odd_slope
        even = c(1) + q*even
        odd = c(2) + q*odd
        y = even + t*odd
        slope = odd + (t + t)*(even_slope + t*odd_slope)
    end subroutine polynomial_with_slope

    !> The integrals of the polynomial, and of it times its argument, from 0 to t.
    pure function polynomial_moments(c, t) result(moments)
        real(wp), intent(in) :: c(coefficient_count), t
        real(wp) :: moments(2)
        integer :: i
        real(wp), parameter :: parts(2, coefficient_count) = reshape([(1.0_wp/i, 1.0_wp/(i + 1), i=1, coefficient_count)], &
                                                                     [2, coefficient_count])

        moments = 0.0_wp
        do i = coefficient_count, 1, -1
            moments = moments*t + c(i)*parts(:, i)
        end do
        moments = moments*[t, t*t]
    end function polynomial_moments

end module mdrcontact_law_interval
