! SPDX-License-Identifier: GPL-3.0-or-later
!> The flat punch on layers with complex elastic constants: E_eff/E0* from the springs' equation with a complex kernel.
!>
!> The matrix 1 + K is complex symmetric and made of those of the kernel's two parts. Its real part is positive definite where
!> energy is stored, so that it has a factorization L D L^T without pivoting. As for the elastic body, n unknowns are solved for and
!> as many more coefficients taken from one iteration.
module mdrcontact_layered_oscillation
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_legendre, only: moments_t, new_interaction
    use mdrcontact_layered_solve, only: first_unknowns
    implicit none (type, external)
    private
    public :: complex_modulus

    integer, parameter :: most_unknowns = 1500

contains

    !> E_eff/E0* at contact radius a, by two numbers of unknowns that must agree.
    subroutine complex_modulus(parts, a, tolerance, modulus, error)
        !> kernels of the real and the imaginary part of chi
        type(kernel_t), intent(in) :: parts(2)
        !> contact radius [length], and relative tolerance
        real(wp), intent(in) :: a, tolerance
        complex(wp), intent(out) :: modulus
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: before
        integer :: n

        modulus = 1.0_wp
        if (parts(1)%vanishes) return
        n = max(first_unknowns(parts(1), tolerance, a/parts(1)%unit, .false., .false.), &
                first_unknowns(parts(2), tolerance, a/parts(2)%unit, .false., .false.))
        call solve_with(parts, a, n, before, error)
        do
            if (allocated(error)) return
            n = n + max(2, n/4)
            if (n > most_unknowns) exit
            call solve_with(parts, a, n, modulus, error)
            ! what is left falls by far more than this from one to the next
            if (abs(modulus - before) <= 30.0_wp*tolerance*abs(modulus)) return
            before = modulus
        end do
        call raise(error, error_no_convergence, "the stiffness at contact radius "//to_text(a)//" did not reach the relative "// &
                   "tolerance "//to_text(tolerance))
    end subroutine complex_modulus

    subroutine solve_with(parts, a, n, modulus, error)
        type(kernel_t), intent(in) :: parts(2)
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        complex(wp), intent(out) :: modulus
        type(error_t), allocatable, intent(inout) :: error
        type(moments_t) :: moments
        real(wp), allocatable :: h(:, :)
        complex(wp), allocatable :: matrix(:, :)
        complex(wp) :: y(n), rest(2*n), diagonal
        integer :: part, i, j, stat

        modulus = 0.0_wp
        allocate (matrix(2*n, n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        matrix = 0.0_wp
        diagonal = 0.0_wp
        do part = 1, 2
            call new_interaction(moments, h, parts(part), a, 2*n, n, 4*n + 4, 6*n, error)
            if (allocated(error)) return
            do j = 1, n
                if (part == 1) matrix(j:, j) = h(j:, j)
                if (part == 2) matrix(j:, j) = matrix(j:, j) + (0.0_wp, 1.0_wp)*h(j:, j)
            end do
            ! sigma = 1 + chi of both parts
            if (part == 1) diagonal = moments%diagonal
            if (part == 2) diagonal = diagonal + (0.0_wp, 1.0_wp)*(moments%diagonal - 1.0_wp)
        end do
        do j = 1, n
            matrix(j, j) = matrix(j, j) + diagonal
        end do
        ! the right-hand side is (sqrt 2, 0, ...); L has ones on its diagonal, D is kept there
        y = 0.0_wp
        y(1) = sqrt(2.0_wp)
        do j = 1, n
            do i = j + 1, n
                y(i) = y(i) - matrix(i, j)/matrix(j, j)*y(j)
                matrix(i:n, i) = matrix(i:n, i) - matrix(i, j)/matrix(j, j)*matrix(i:n, j)
            end do
        end do
        do j = 1, n
            modulus = modulus + y(j)**2/matrix(j, j)
        end do
        ! back, and what the equation's other rows say
        rest = 0.0_wp
        do j = n, 1, -1
            y(j) = (y(j) - sum(matrix(j + 1:n, j)*y(j + 1:)))/matrix(j, j)
            rest(n + 1:) = rest(n + 1:) - matrix(n + 1:, j)*y(j)
        end do
        modulus = 0.5_wp*(modulus + sum(rest(n + 1:)**2))
    end subroutine solve_with

end module mdrcontact_layered_oscillation
