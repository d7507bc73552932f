! SPDX-License-Identifier: GPL-3.0-or-later
!> Series in even Legendre polynomials, at many places side by side.
module mdrcontact_line_series
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: add_even_sum, add_projections, even_slope, even_sum, weigh_even

    !> Number of places in a block, whose memory is fixed.
    integer, parameter :: together = 256

contains

    !> w P_2j(u), j = 0 ...
    pure subroutine weigh_even(u, w, values)
        real(wp), intent(in) :: u(:), w(:)
        !> (place, polynomial)
        real(wp), intent(out) :: values(:, 0:)
        real(wp), dimension(size(u)) :: even, odd
        integer :: j

        even = w
        odd = w*u
        do j = 0, ubound(values, 2)
            values(:, j) = even
            even = (real(4*j + 3, wp)*u*odd - real(2*j + 1, wp)*even)/real(2*j + 2, wp)
            odd = (real(4*j + 5, wp)*u*even - real(2*j + 2, wp)*odd)/real(2*j + 3, wp)
        end do
    end subroutine weigh_even

    !> sum of c_j P_2j(u), j = 0 ...
    pure function even_sum(c, u) result(total)
        real(wp), intent(in) :: c(0:)
        real(wp), intent(in), contiguous :: u(:)
        real(wp) :: total(size(u))
        real(wp), dimension(size(u)) :: even, odd
        real(wp) :: two(2)
        integer :: j

        even = 1.0_wp
        odd = u
        total = c(0)
        do j = 1, ubound(c, 1)
            two = [real(4*j - 1, wp), real(1 - 2*j, wp)]/real(2*j, wp)
            even = two(1)*u*odd + two(2)*even
            two = [real(4*j + 1, wp), real(-2*j, wp)]/real(2*j + 1, wp)
            odd = two(1)*u*even + two(2)*odd
            total = total + c(j)*even
        end do
    end function even_sum

    !> sum of c_j P'_2j(u): P'_(n+1) = P'_(n-1) + (2 n + 1) P_n.
    pure function even_slope(c, u) result(total)
        real(wp), intent(in) :: c(0:), u(:)
        real(wp) :: total(size(u))
        real(wp), dimension(size(u)) :: even, odd, rise
        real(wp) :: over
        integer :: j

        total = 0.0_wp
        even = 1.0_wp
        odd = u
        rise = 0.0_wp
        do j = 0, ubound(c, 1)
            total = total + c(j)*rise
            rise = rise + real(4*j + 3, wp)*odd
            over = 1.0_wp/real(2*j + 2, wp)
            even = (over*real(4*j + 3, wp))*u*odd - (over*real(2*j + 1, wp))*even
            over = 1.0_wp/real(2*j + 3, wp)
            odd = (over*real(4*j + 5, wp))*u*even - (over*real(2*j + 2, wp))*odd
        end do
    end function even_slope

    !> Adds factor times the sum of c_j P_2j(x/a), j = 0 ..., at any number of places.
    pure subroutine add_even_sum(c, x, a, factor, values)
        real(wp), intent(in) :: c(0:)
        real(wp), intent(in) :: x(:), a, factor
        !> same size as x
        real(wp), intent(inout) :: values(:)
        integer :: first, last

        do first = 1, size(x), together
            last = min(first + together - 1, size(x))
            values(first:last) = values(first:last) + factor*even_sum(c, x(first:last)/a)
        end do
    end subroutine add_even_sum

    !> Adds sum w P_2j(u), j = 0 ..., to g.
    pure subroutine add_projections(n, u, w, g)
        integer, intent(in) :: n
        real(wp), intent(in) :: u(n), w(n)
        real(wp), intent(inout) :: g(0:)
        real(wp) :: even(n), odd(n), two(2)
        integer :: j

        even = w
        odd = u*w
        do j = 0, ubound(g, 1)
            g(j) = g(j) + sum(even)
            two = [real(4*j + 3, wp), real(-2*j - 1, wp)]/real(2*j + 2, wp)
            even = two(1)*u*odd + two(2)*even
            two = [real(4*j + 5, wp), real(-2*j - 2, wp)]/real(2*j + 3, wp)
            odd = two(1)*u*even + two(2)*odd
        end do
    end subroutine add_projections

end module mdrcontact_line_series
