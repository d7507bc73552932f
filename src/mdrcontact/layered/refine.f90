! SPDX-License-Identifier: GPL-3.0-or-later
!> Iterative refinement of the springs' equation with residuals in longer numbers.
!>
!> In a thin soft film the springs nearly cancel: the smallest eigenvalues of 1 + H are sigma(1/a), down to (h/a)^3 in an
!> incompressible film,
!> and rounding of the matrix in working precision is amplified by their inverse. The matrix in longer numbers has the digits; its
!> factor in working precision suffices to solve with it.
module mdrcontact_layered_refine
    use mdrcontact_kinds, only: long, wp
    use mdrcontact_lapack, only: dpotrs
    use mdrcontact_layered_grid, only: grid_t
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_matrix_long, only: interaction_matrix
    use mdrcontact_layered_rule_long, only: rule_t
    implicit none (type, external)
    private
    public :: refine

    integer, parameter :: most_steps = 12
    !> Relative size of the last step of a refinement that came to its end.
    real(wp), parameter :: settled = 1.0e-6_wp

contains

    !> Improves `solution` of (1 + H) solution = rhs, the columns in the variable sqrt(w) q. `converged` is false if the
    !> steps do not
    !> shrink to what rounding leaves.
    subroutine refine(kernel, grid, rule, factor, rhs, solution, converged)
        type(kernel_t), intent(in) :: kernel
        type(grid_t), intent(in) :: grid
        !> of the grid's order
        type(rule_t), intent(in) :: rule
        !> Cholesky factor of 1 + H, lower triangle
        real(wp), intent(in) :: factor(:, :)
        real(wp), intent(in) :: rhs(:, :)
        real(wp), intent(inout) :: solution(:, :)
        logical, intent(out) :: converged
        real(long), allocatable :: matrix(:, :), z(:, :), residual(:, :)
        real(wp) :: step(size(rhs, 1), size(rhs, 2)), change, change_before
        integer :: i, n, iteration, info

        n = size(rhs, 1)
        allocate (matrix(n, n), z(n, size(rhs, 2)), residual(n, size(rhs, 2)))
        call interaction_matrix(kernel, grid, rule, matrix)
        do i = 1, n
            matrix(i, i) = matrix(i, i) + (1.0_long + kernel%defect)
            matrix(i, i + 1:) = matrix(i + 1:, i)
        end do
        z = solution
        change_before = huge(1.0_wp)
        converged = .false.
        do iteration = 1, most_steps
            residual = rhs - matmul(matrix, z)
            step = real(residual, wp)
            call dpotrs("L", n, size(step, 2), factor, n, step, n, info)
            z = z + step
            change = maxval(sqrt(sum(step**2, dim=1)/sum(real(z, wp)**2, dim=1)))
            if (change < epsilon(1.0_wp) .or. .not. change < 0.5_wp*change_before) exit
            change_before = change
        end do
        converged = change < settled
        solution = real(z, wp)
    end subroutine refine

end module mdrcontact_layered_refine
