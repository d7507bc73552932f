! SPDX-License-Identifier: GPL-3.0-or-later
!> The interaction of the springs as a symmetric matrix: weighted kernel values, or exact integrals where a panel is longer
!> than the kernel is wide.
!>
!> The unknown at node i is sqrt(w_i) q(x_i), so that H_ij = sqrt(w_i w_j) [X(x_i - x_j) + X(x_i + x_j)]/pi is symmetric and 1 + H
!> positive definite. Between panels that are long against the kernel, H_ij is the double integral of the kernel with the
!> panels' Lagrange
!> polynomials, which equals the former where both resolve it: one integral over the difference y of the
!> positions, on the panels of the kernel's table.
module mdrcontact_layered_matrix
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_layered_grid, only: grid_t, longest_panel
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_rule, only: legendre, rule_t
    implicit none (type, external)
    private
    public :: interaction_matrix, interaction_at, interaction_row

    integer, parameter :: rp = wp
    !> The kernel on an octave is resolved by the rule's fine nodes.
    !> Panels nearer to each other than their length over this are integrated; the kernel is smooth on the scale of the gap.
    real(wp), parameter :: nearest = 2.0_wp
    integer, parameter :: parts_of_octave = 1

contains

    include "matrix.inc"

    !> c = a b^T
    subroutine multiply_transposed(a, b, c)
        real(wp), intent(in) :: a(:, :), b(:, :)
        real(wp), intent(out) :: c(:, :)

        call dgemm("N", "T", size(c, 1), size(c, 2), size(a, 2), 1.0_wp, a, size(a, 1), b, size(b, 1), 0.0_wp, c, size(c, 1))
    end subroutine multiply_transposed

    !> Weights at the grid's nodes that integrate (1/pi) [X(x - s) + X(x + s)] times a function of s over the contact, for
    !> one x >= a.
    subroutine interaction_row(kernel, grid, rule, x, row)
        type(kernel_t), intent(in) :: kernel
        type(grid_t), intent(in) :: grid
        !> the rule of the grid
        type(rule_t), intent(in) :: rule
        real(wp), intent(in) :: x
        !> one value per node
        real(wp), intent(out) :: row(:)
        real(wp) :: weights(rule%n), length
        integer :: i, first, last

        call interaction_at(kernel, x, grid%x, row)
        row = row*grid%w
        do i = 1, size(grid%edges) - 1
            first = (i - 1)*rule%n + 1
            last = i*rule%n
            length = grid%edges(i + 1) - grid%edges(i)
            if (length <= nearest*(x - grid%edges(i + 1)) + 2.02_wp*longest_panel) cycle
            call product_weights(kernel, rule, x - grid%edges(i + 1), x - grid%edges(i), rule%nodes, rule%barycentric, weights)
            row(first:last) = weights(rule%n:1:-1)/pi
            call product_weights(kernel, rule, x + grid%edges(i), x + grid%edges(i + 1), rule%nodes, rule%barycentric, weights)
            row(first:last) = row(first:last) + weights/pi
        end do
    end subroutine interaction_row

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
