! SPDX-License-Identifier: GPL-3.0-or-later
!> The interaction of the springs as a symmetric matrix: weighted kernel values, or exact integrals where a panel is longer than the kernel is wide.
!>
!> The unknown at node i is sqrt(w_i) q(x_i), so that H_ij = sqrt(w_i w_j) [X(x_i - x_j) + X(x_i + x_j)]/pi is symmetric and 1 + H
!> positive definite. Between panels that are long against the kernel, H_ij is the double integral of the kernel with the panels' Lagrange
!> polynomials, which equals the former where both resolve it: one integral over the difference y of the
!> positions, on the panels of the kernel's table.
module mdrcontact_layered_matrix
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_layered_grid, only: grid_t, is_near
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_rule, only: legendre, rule_t
    implicit none (type, external)
    private
    public :: interaction_matrix, interaction_at

    integer, parameter :: rp = wp
    !> The kernel on an octave is resolved by the rule's fine nodes.
    integer, parameter :: parts_of_octave = 1

contains

    include "matrix.inc"

    !> c = a b^T
    subroutine multiply_transposed(a, b, c)
        real(wp), intent(in) :: a(:, :), b(:, :)
        real(wp), intent(out) :: c(:, :)

        call dgemm("N", "T", size(c, 1), size(c, 2), size(a, 2), 1.0_wp, a, size(a, 1), b, size(b, 1), 0.0_wp, c, size(c, 1))
    end subroutine multiply_transposed

    !> (1/pi) [X(x - s) + X(x + s)] at one position x for many s.
    subroutine interaction_at(kernel, x, s, values)
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: x, s(:)
        !> same size as s
        real(wp), intent(out) :: values(:)
        real(wp) :: other(size(s))

        call kernel%evaluate(abs(x - s), values)
        call kernel%evaluate(x + s, other)
        values = (values + other)/pi
    end subroutine interaction_at

end module mdrcontact_layered_matrix
