! SPDX-License-Identifier: GPL-3.0-or-later
!> Products and inverses of 2 x 2 matrices, without the memory and the calls of the general ones.
module mdrcontact_numerics_small_matrices
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: times_matrix, times_vector, inverse

contains

    !> a b.
    pure function times_matrix(a, b) result(c)
        real(wp), intent(in) :: a(2, 2), b(2, 2)
        real(wp) :: c(2, 2)

        c(:, 1) = a(:, 1)*b(1, 1) + a(:, 2)*b(2, 1)
        c(:, 2) = a(:, 1)*b(1, 2) + a(:, 2)*b(2, 2)
    end function times_matrix

    !> a b.
    pure function times_vector(a, b) result(c)
        real(wp), intent(in) :: a(2, 2), b(2)
        real(wp) :: c(2)

        c = a(:, 1)*b(1) + a(:, 2)*b(2)
    end function times_vector

    !> The inverse of m, whose determinant is not 0.
    pure function inverse(m) result(other)
        real(wp), intent(in) :: m(2, 2)
        real(wp) :: other(2, 2)

        other(:, 1) = [m(2, 2), -m(2, 1)]
        other(:, 2) = [-m(1, 2), m(1, 1)]
        other = other/(m(1, 1)*m(2, 2) - m(1, 2)*m(2, 1))
    end function inverse

end module mdrcontact_numerics_small_matrices
