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

contains

    !> The lower triangle of H.
    subroutine interaction_matrix(kernel, grid, rule, matrix)
        type(kernel_t), intent(in) :: kernel
        type(grid_t), intent(in) :: grid
        type(rule_t), intent(in) :: rule
        real(wp), intent(out) :: matrix(:, :)
        real(wp) :: root(size(grid%x)), block(rule%n, rule%n)
        integer :: i, j, n, row, column, k, l
        logical :: near(2)

        n = rule%n
        root = sqrt(grid%w)
        do j = 1, size(grid%edges) - 1
            column = (j - 1)*n
            do i = j, size(grid%edges) - 1
                row = (i - 1)*n
                associate (low => grid%edges(j:j + 1), high => grid%edges(i:i + 1))
                    near(1) = is_near(high(2) - high(1), low(2) - low(1), max(high(1) - low(2), 0.0_wp))
                    near(2) = is_near(high(2) - high(1), low(2) - low(1), high(1) + low(1))
                    call pointwise_block(kernel, grid%x(row + 1:row + n), grid%x(column + 1:column + n), near, i == j, block)
                    do l = 1, n
                        do k = 1, n
                            matrix(row + k, column + l) = root(row + k)*root(column + l)*block(k, l)
                        end do
                    end do
                    if (near(1)) call add_integrals(kernel, rule, high, low, 1, &
                                                    matrix(row + 1:row + n, column + 1:column + n))
                    if (near(2)) call add_integrals(kernel, rule, high, -low(2:1:-1), -1, &
                                                    matrix(row + 1:row + n, column + 1:column + n))
                end associate
            end do
        end do
        matrix = matrix/pi
    end subroutine interaction_matrix

    !> X(x - s) + X(x + s) at the nodes of two panels, without the terms that are near.
    subroutine pointwise_block(kernel, x, s, near, same, block)
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: x(:), s(:)
        logical, intent(in) :: near(2), same
        real(wp), intent(out) :: block(:, :)
        real(wp), dimension(2*size(x)*size(s)) :: y, values
        integer :: i, j, count, first

        count = 0
        do j = 1, size(s)
            first = merge(j, 1, same)
            do i = first, size(x)
                count = count + 2
                y(count - 1) = abs(x(i) - s(j))
                y(count) = x(i) + s(j)
            end do
        end do
        if (any(.not. near)) call kernel%evaluate(y(:count), values(:count))
        if (near(1)) values(1:count:2) = 0.0_wp
        if (near(2)) values(2:count:2) = 0.0_wp
        count = 0
        do j = 1, size(s)
            first = merge(j, 1, same)
            do i = first, size(x)
                count = count + 2
                block(i, j) = values(count - 1) + values(count)
                if (same) block(j, i) = block(i, j)
            end do
        end do
    end subroutine pointwise_block

    !> Adds the integrals of X(x - s) times Lagrange polynomials of x on one panel and of s on the other, over the roots of the weights.
    subroutine add_integrals(kernel, rule, one, other, direction, block)
        type(kernel_t), intent(in) :: kernel
        type(rule_t), intent(in) :: rule
        !> ends of the panels; `other` may be a mirrored one at negative positions, its nodes in descending order (direction -1)
        real(wp), intent(in) :: one(2), other(2)
        integer, intent(in) :: direction
        real(wp), intent(inout) :: block(:, :)
        real(wp), allocatable :: y(:), dy(:), x(:), left(:, :), right(:, :), values(:)
        real(wp) :: length(2), low, high, moments(rule%n, rule%n), half(rule%n, rule%n), nodal(rule%n, rule%n)
        integer :: i, j, n, first, last

        n = rule%n
        length = [one(2) - one(1), other(2) - other(1)]
        call difference_rule(kernel, rule, one, other, y, dy)
        allocate (values(size(y)), x(n), left(n, n*size(y)), right(n, n*size(y)))
        call kernel%evaluate(abs(y), values)
        do i = 1, size(y)
            low = max(one(1), other(1) + y(i))
            high = min(one(2), other(2) + y(i))
            x = low + (high - low)*rule%nodes
            first = (i - 1)*n + 1
            last = i*n
            call legendre((x - one(1))/length(1), left(:, first:last))
            call legendre((x - y(i) - other(1))/length(2), right(:, first:last))
            do j = 1, n
                left(:, first + j - 1) = (values(i)*dy(i)*(high - low)*rule%weights(j))*left(:, first + j - 1)
            end do
        end do
        call dgemm("N", "T", n, n, size(left, 2), 1.0_wp, left, n, right, n, 0.0_wp, moments, n)
        if (direction < 0) moments(:, 2::2) = -moments(:, 2::2)
        call dgemm("T", "N", n, n, n, 1.0_wp, rule%to_legendre, n, moments, n, 0.0_wp, half, n)
        call dgemm("N", "N", n, n, n, 1.0_wp, half, n, rule%to_legendre, n, 0.0_wp, nodal, n)
        do j = 1, n
            do i = 1, n
                block(i, j) = block(i, j) + nodal(i, j)/sqrt(length(1)*rule%weights(i)*length(2)*rule%weights(j))
            end do
        end do
    end subroutine add_integrals

    !> Nodes and weights for integrals over y = x - s, split where the overlap of the panels has a kink and at the kernel's octaves.
    subroutine difference_rule(kernel, rule, one, other, y, dy)
        type(kernel_t), intent(in) :: kernel
        type(rule_t), intent(in) :: rule
        real(wp), intent(in) :: one(2), other(2)
        real(wp), allocatable, intent(out) :: y(:), dy(:)
        real(wp) :: ends(2*kernel%octaves() + 8), low, high
        integer :: i, j, n, count, octave

        low = one(1) - other(2)
        high = one(2) - other(1)
        count = 0
        call insert(one(1) - other(2))
        call insert(one(2) - other(1))
        call insert(one(1) - other(1))
        call insert(one(2) - other(2))
        call insert(0.0_wp)
        do octave = 0, kernel%octaves()
            if (scale(1.0_wp, octave) >= max(abs(low), abs(high))) exit
            call insert(scale(1.0_wp, octave))
            call insert(-scale(1.0_wp, octave))
        end do
        n = size(rule%fine_nodes)
        allocate (y((count - 1)*n), dy((count - 1)*n))
        do i = 1, count - 1
            do j = 1, n
                y((i - 1)*n + j) = ends(i) + (ends(i + 1) - ends(i))*rule%fine_nodes(j)
                dy((i - 1)*n + j) = (ends(i + 1) - ends(i))*rule%fine_weights(j)
            end do
        end do

    contains

        !> Inserts a point into the ascending ends if it lies in [low, high] and is not there yet.
        subroutine insert(point)
            real(wp), intent(in) :: point
            integer :: k

            if (point < low .or. point > high) return
            if (any(abs(ends(:count) - point) <= 8.0_wp*epsilon(1.0_wp)*max(abs(low), abs(high)))) return
            k = count
            do while (k > 0)
                if (ends(k) < point) exit
                ends(k + 1) = ends(k)
                k = k - 1
            end do
            ends(k + 1) = point
            count = count + 1
        end subroutine insert

    end subroutine difference_rule

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
