! SPDX-License-Identifier: GPL-3.0-or-later
!> The same matrix as in mdrcontact_layered_matrix in longer numbers, for residuals: where the springs nearly cancel, as in a
!> thin soft film,
!> its smallest eigenvalues are of the order of the rounding of its entries.
module mdrcontact_layered_matrix_long
    use mdrcontact_kinds, only: long, wp
    use mdrcontact_layered_grid, only: grid_t, longest_panel
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_rule_long, only: legendre, rule_t
    implicit none (type, external)
    private
    public :: interaction_matrix

    integer, parameter :: rp = long
    !> On half an octave the kernel's table is one polynomial, which the rule's fine nodes integrate exactly.
    !> Panels nearer to each other than their length over this are integrated; the kernel is smooth on the scale of the gap.
    real(wp), parameter :: nearest = 1.0_wp
    integer, parameter :: parts_of_octave = 2

contains

    include "matrix.inc"

    !> c = a b^T
    pure subroutine multiply_transposed(a, b, c)
        real(long), intent(in) :: a(:, :), b(:, :)
        real(long), intent(out) :: c(:, :)
        integer :: i, j, k

        c = 0.0_long
        do k = 1, size(a, 2)
            do j = 1, size(c, 2)
                do i = 1, size(c, 1)
                    c(i, j) = c(i, j) + a(i, k)*b(j, k)
                end do
            end do
        end do
    end subroutine multiply_transposed

end module mdrcontact_layered_matrix_long
