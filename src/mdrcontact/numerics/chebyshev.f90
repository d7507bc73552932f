! SPDX-License-Identifier: GPL-3.0-or-later
!> Chebyshev series of several functions (rows) side by side on [-1, 1], from their values at as many points, or from values and
!> slopes at half as many.
module mdrcontact_numerics_chebyshev
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: terms, half, node, series_of_values, series_of_slopes, series_value

    !> Terms of a series, and half of them.
    integer, parameter :: terms = 16, half = terms/2

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

end module mdrcontact_numerics_chebyshev
