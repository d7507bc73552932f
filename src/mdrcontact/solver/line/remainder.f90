! SPDX-License-Identifier: GPL-3.0-or-later
!> Contribution of coefficients beyond the n unknowns of the springs' equation to products <x, y> = x' (1 + H)^-1 y of its
!> right-hand sides, and its uncertainty (theory/exact.md (3.8), (3.9)).
!>
!> One iteration of the equation gives as many coefficients more, which enter products to second order. The Schur complement of
!> the n unknowns is close to its diagonal, S_i, which the pivots approach geometrically to 1. Sums over fewer terms give the error.
module mdrcontact_line_remainder
    use mdrcontact_kinds, only: half_pi, wp
    implicit none (type, external)
    private
    public :: remainder_t, new_remainder

    !> Safety factor of the estimate, which can be too small by a factor of 2.
    real(wp), parameter :: safety = 4.0_wp

    !> Weights of the terms n + 1 ... m.
    type :: remainder_t
        !> 1/S_i, tapered
        real(wp), allocatable :: inverse(:)
        !> 1/S_i - 1
        real(wp), allocatable, private :: uncertainty(:)
        !> weights that go to 0 over the last quarter and eighth of the terms
        real(wp), allocatable, private :: quarter(:), eighth(:)
    contains
        procedure :: product => product_of
        procedure :: truncation_error
    end type remainder_t

contains

    !> From the factor of the first n rows of 1 + H.
    subroutine new_remainder(self, n, m, h)
        type(remainder_t), intent(out) :: self
        integer, intent(in) :: n, m
        real(wp), intent(in) :: h(m, n)
        real(wp) :: pivot, ratio
        integer :: i

        allocate (self%inverse(m - n), self%uncertainty(m - n), self%quarter(m - n), self%eighth(m - n))
        pivot = h(n, n)**2 - 1.0_wp
        ratio = 0.0_wp
        if (abs(pivot) > epsilon(pivot)) ratio = min(max(pivot/(h(n - 2, n - 2)**2 - 1.0_wp), 0.0_wp), 1.0_wp)
        ratio = sqrt(ratio)
        do i = 1, m - n
            pivot = pivot*ratio
            self%inverse(i) = 1.0_wp/(1.0_wp + pivot)
            self%uncertainty(i) = pivot*self%inverse(i)
        end do
        call taper(max(m/4, 2), self%quarter)
        call taper(max(m/8, 1), self%eighth)
        self%inverse = self%quarter*self%inverse
    end subroutine new_remainder

    !> <x, y>.
    pure function product_of(self, forward_x, forward_y, x, y, known, whole) result(total)
        class(remainder_t), intent(in) :: self
        !> of two right-hand sides, times the inverse of the factor
        real(wp), intent(in) :: forward_x(:), forward_y(:)
        !> what is left of them beyond n
        real(wp), intent(in) :: x(:), y(:)
        !> the main part of the terms beyond n where these fall slowly, and the sum of all of that
        real(wp), intent(in), optional :: known(:), whole
        real(wp) :: total

        if (present(known)) then
            total = sum(forward_x*forward_y) + sum(self%inverse*x*y - self%quarter*known) + whole
        else
            total = sum(forward_x*forward_y) + sum(self%inverse*x*y)
        end if
    end function product_of

    !> The uncertainty of the terms x y of a product, and those left out. Where the last quarter of the terms does not cancel, it
    !> gives how many times the last one these are, whether they fall as a power or as an exponential; where it does, the
    !> sum depends little on how it ends.
    pure subroutine truncation_error(self, n, x, y, terms, error, known)
        class(remainder_t), intent(in) :: self
        !> unknowns
        integer, intent(in) :: n
        real(wp), intent(in) :: x(n + 1:), y(n + 1:)
        !> room
        real(wp), intent(out) :: terms(n + 1:)
        real(wp), intent(out) :: error
        !> the main part of the terms of what y subtracts, whose sum is known
        real(wp), intent(in), optional :: known(n + 1:)
        real(wp) :: first, last, more, partial
        integer :: i, m

        m = ubound(x, 1)
        terms = x*y
        error = 0.0_wp
        partial = 0.0_wp
        do i = n + 1, m
            partial = partial + terms(i)*self%uncertainty(i - n)
            error = max(error, abs(partial))
        end do
        if (present(known)) terms = terms + known
        i = m - max(m/4, 4) + 1
        first = maxval(abs(terms(i:i + 2)))
        last = maxval(abs(terms(m - 2:m)))
        more = real(m, wp)
        if (first > last .and. last > 0.0_wp) more = min(more, real(m - 2 - i, wp)/log(first/last))
        if (last > 0.0_wp) more = more*(sum(terms(i:))/sum(abs(terms(i:))))**2
        error = safety*(error + abs(sum((self%quarter - self%eighth)*terms)) + last*more)
    end subroutine truncation_error

    !> Weights that go to 0 over the last `length` terms of a sum: a profile with a kink makes terms that alternate and fall slowly,
    !> and their sum is close to that of all without end.
    pure subroutine taper(length, weights)
        integer, intent(in) :: length
        real(wp), intent(out) :: weights(:)
        integer :: i

        weights = 1.0_wp
        do i = 1, length
            weights(size(weights) - length + i) = cos(half_pi*real(i, wp)/real(length + 1, wp))**2
        end do
    end subroutine taper

end module mdrcontact_line_remainder
