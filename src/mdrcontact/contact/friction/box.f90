! SPDX-License-Identifier: GPL-3.0-or-later
!> A convex quadratic program with bounds: t.C t/2 - t.b under |t| <= limit (theory/friction.md (6.2)).
!>
!> Newton's method on what is free, projected into the box, with a line search (D. P. Bertsekas, SIAM J. Control Optim. 20 (1982)
!> 221): each step lowers the objective, and once it is known which bounds hold, it is exact.
module mdrcontact_friction_box
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dpotrs
    use mdrcontact_numerics_one_thread, only: factorize_positive
    implicit none (type, external)
    private
    public :: minimise_in_box

    integer, parameter :: most_steps = 200, most_halvings = 40
    !> Gradients below this part of the largest are rounding.
    real(wp), parameter :: flat = 1.0e-12_wp

contains

    !> The minimum, from a first guess of t.
    subroutine minimise_in_box(c, b, limit, t, error)
        !> symmetric, positive definite
        real(wp), intent(in) :: c(:, :), b(:), limit(:)
        real(wp), intent(inout) :: t(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(size(b)) :: gradient, trial, direction
        logical, dimension(size(b)) :: is_free
        real(wp) :: scale, length, value, next
        integer :: step, halving

        if (size(t) == 0) return
        t = min(max(t, -limit), limit)
        scale = maxval(abs(b)) + maxval(abs(matmul(c, limit)))
        do step = 1, most_steps
            gradient = matmul(c, t) - b
            is_free = .not. ((t >= limit .and. gradient <= 0.0_wp) .or. (t <= -limit .and. gradient >= 0.0_wp))
            is_free = is_free .and. limit > 0.0_wp
            if (.not. any(is_free)) return
            if (all(abs(gradient) <= flat*scale .or. .not. is_free)) return
            call free_direction(c, gradient, is_free, direction, error)
            if (allocated(error)) return
            value = 0.5_wp*dot_product(t, gradient - b)
            length = 1.0_wp
            do halving = 1, most_halvings
                trial = min(max(t + length*direction, -limit), limit)
                next = 0.5_wp*dot_product(trial, matmul(c, trial)) - dot_product(trial, b)
                if (next <= value + 1.0e-4_wp*dot_product(gradient, trial - t)) exit
                length = 0.5_wp*length
            end do
            ! nothing is lower but for rounding
            if (halving > most_halvings .and. value <= huge(value)) return
            t = trial
        end do
        call raise(error, error_no_convergence, "the tractions of a step with friction were not found")
    end subroutine minimise_in_box

    !> Newton's step of the free ones, 0 for the others.
    subroutine free_direction(c, gradient, is_free, direction, error)
        real(wp), intent(in) :: c(:, :), gradient(:)
        logical, intent(in) :: is_free(:)
        real(wp), intent(out) :: direction(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: factor(:, :)
        real(wp) :: step(count(is_free), 1)
        integer :: index(count(is_free))
        integer :: i, j, n, info

        index = pack([(i, i=1, size(is_free))], is_free)
        n = size(index)
        allocate (factor(n, n), stat=info)
        call check_memory(error, info)
        if (allocated(error)) return
        do j = 1, n
            factor(j:, j) = c(index(j:), index(j))
        end do
        step(:, 1) = -gradient(index)
        call factorize_positive(n, n, factor, info)
        if (info == 0) call dpotrs("L", n, 1, factor, n, step, n, info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "rings: they are too narrow. Use fewer rings")
            return
        end if
        direction = 0.0_wp
        direction(index) = step(:, 1)
    end subroutine free_direction

end module mdrcontact_friction_box
