! SPDX-License-Identifier: GPL-3.0-or-later
!> Chebyshev series c(1) T_0(z) + c(2) T_1(z) + ..., -1 <= z <= 1: of several functions (rows) side by side, from their values at as
!> many points, or from values and slopes at half as many; and of one function, of any length.
module mdrcontact_numerics_chebyshev
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: terms, half, node, series_of_values, series_of_slopes, series_value
    public :: chebyshev_sum, chebyshev_sums, cosine_transform, differentiate

    !> Terms of a series, and half of them.
    integer, parameter :: terms = 16, half = terms/2
    !> Points of one function that are evaluated side by side.
    integer, parameter :: block = 8

contains

    !> Point i of `count`, descending.
    elemental function node(i, count) result(z)
        integer, intent(in) :: i, count
        real(wp) :: z

        z = cos(pi*(i - 0.5_wp)/count)
    end function node

    !> The series with these values at the points of `terms`.
    pure function series_of_values(values) result(coefficients)
        !> (rows, terms)
        real(wp), intent(in) :: values(:, :)
        real(wp) :: coefficients(size(values, 1), terms)
        integer :: i, j
        !> (i, j): T_(j-1) at point i, times its weight
        real(wp), parameter :: cosines(terms, terms) = &
                               reshape([((cos(pi*(j - 1)*(i - 0.5_wp)/terms)*merge(1.0_wp, 2.0_wp, j == 1)/terms, &
                                          i=1, terms), j=1, terms)], [terms, terms])

        coefficients = matmul(values, cosines)
    end function series_of_values

    !> The series with these values and slopes at the points of `half`: A + T_half B, where A has the values, and as T_half vanishes
    !> at the points, B what A's slopes lack. Slopes that do not belong to the values show in the last coefficients.
    pure function series_of_slopes(values, slopes) result(coefficients)
        !> (rows, half)
        real(wp), intent(in) :: values(:, :), slopes(:, :)
        real(wp) :: coefficients(size(values, 1), terms)
        real(wp), dimension(size(values, 1), half) :: a, b
        integer :: i, j
        real(wp), parameter :: cosines(half, half) = &
                               reshape([((cos(pi*(j - 1)*(i - 0.5_wp)/half)*merge(1.0_wp, 2.0_wp, j == 1)/half, &
                                          i=1, half), j=1, half)], [half, half])
        !> (j, i): slope of T_(j-1) at point i, and 1 over that of T_half
        real(wp), parameter :: rates(half, half) = &
                               reshape([(((j - 1)*sin(pi*(j - 1)*(i - 0.5_wp)/half)/sin(pi*(i - 0.5_wp)/half), &
                                          j=1, half), i=1, half)], [half, half]), &
                               inverse(half) = [((-1)**(i - 1)*sin(pi*(i - 0.5_wp)/half)/half, i=1, half)]

        a = matmul(values, cosines)
        b = slopes - matmul(a, rates)
        do i = 1, half
            b(:, i) = b(:, i)*inverse(i)
        end do
        b = matmul(b, cosines)
        coefficients(:, :half) = a
        coefficients(:, half + 1) = b(:, 1)
        do j = 1, half - 1
            coefficients(:, half + 1 + j) = 0.5_wp*b(:, j + 1)
            coefficients(:, half + 1 - j) = coefficients(:, half + 1 - j) + 0.5_wp*b(:, j + 1)
        end do
    end function series_of_slopes

    !> The two functions of a series at z, by Clenshaw's recurrence.
    pure function series_value(c, z) result(values)
        real(wp), intent(in) :: c(2, terms), z
        real(wp) :: values(2)
        real(wp) :: b(2), b1(2), b2(2)
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        do j = terms, 2, -1
            b = 2.0_wp*z*b1 - b2 + c(:, j)
            b2 = b1
            b1 = b
        end do
        values = z*b1 - b2 + c(:, 1)
    end function series_value

    !> The matrix from the values at Chebyshev's n nodes to the coefficients; column 2 holds 2/n times the nodes.
    pure subroutine cosine_transform(cosines)
        !> (n, n)
        real(wp), intent(out) :: cosines(:, :)
        integer :: i, j, n

        n = size(cosines, 1)
        do j = 1, n
            do i = 1, n
                cosines(i, j) = (2.0_wp/n)*cosine((j - 1)*(2*i - 1), 2*n)
            end do
        end do
        cosines(:, 1) = 0.5_wp*cosines(:, 1)

    contains

        !> cos(pi k/m), m even, from an angle below pi/4: rounding errors of large ones would look like coefficients.
        pure function cosine(k, m) result(value)
            integer, intent(in) :: k, m
            real(wp) :: value
            integer :: rest

            rest = modulo(k, 2*m)
            rest = min(rest, 2*m - rest)
            value = real(merge(1, -1, 2*rest <= m), wp)
            rest = min(rest, m - rest)
            if (4*rest <= m) then
                value = value*cos(pi*rest/m)
            else
                value = value*sin(pi*(m/2 - rest)/m)
            end if
        end function cosine

    end subroutine cosine_transform

    !> Clenshaw's sum of a series at z.
    pure function chebyshev_sum(c, z) result(y)
        real(wp), intent(in) :: c(:), z
        real(wp) :: y
        real(wp) :: b1, b2, b3
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        do j = size(c), 2, -1
            b3 = b2
            b2 = b1
            b1 = 2.0_wp*z*b2 - b3 + c(j)
        end do
        y = z*b1 - b2 + c(1)
    end function chebyshev_sum

    !> The same at several points x, of which left has z = -1 and right z = 1.
    pure subroutine chebyshev_sums(c, left, right, x, y)
        real(wp), intent(in) :: c(:), left, right, x(:)
        real(wp), intent(out) :: y(:)
        real(wp) :: z(block), b1(block), b2(block), b3(block)
        integer :: first, j, n

        do first = 0, size(x) - 1, block
            n = min(block, size(x) - first)
            ! as many as a block has, also of the last points
            z = left
            do j = 1, n
                z(j) = x(first + j)
            end do
            z = 2.0_wp*(z - left)*(1.0_wp/(right - left)) - 1.0_wp
            b1 = 0.0_wp
            b2 = 0.0_wp
            do j = size(c), 2, -1
                b3 = 2.0_wp*z*b1 - b2 + c(j)
                b2 = b1
                b1 = b3
            end do
            z = z*b1 - b2 + c(1)
            do j = 1, n
                y(first + j) = z(j)
            end do
        end do
    end subroutine chebyshev_sums

    !> Coefficients of the derivative.
    pure subroutine differentiate(c, derivative)
        real(wp), intent(in) :: c(:)
        !> same size as c
        real(wp), intent(out) :: derivative(:)
        integer :: j, nodes

        nodes = size(c)
        derivative(nodes) = 0.0_wp
        derivative(nodes - 1) = 2.0_wp*(nodes - 1)*c(nodes)
        do j = nodes - 2, 1, -1
            derivative(j) = derivative(j + 2) + 2.0_wp*j*c(j + 1)
        end do
        derivative(1) = 0.5_wp*derivative(1)
    end subroutine differentiate

end module mdrcontact_numerics_chebyshev
