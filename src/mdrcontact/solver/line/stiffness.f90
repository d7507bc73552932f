! SPDX-License-Identifier: GPL-3.0-or-later
!> Stiffness of layers with real or complex elastic constants for a rigid motion of the contact: that of a flat punch,
!> d = q + K q with even q, or a twist about the axis, 4 G0 phi x = q + K q with odd q (theory/friction.md (2.8), (5.2)).
!>
!> The matrix 1 + K is symmetric, also where it is complex and made of those of the kernel's two parts. Its real part is positive
!> definite where energy is stored, so that it has a factorization L D L^T without pivoting. As for elastic states, n unknowns are
!> solved for and as many more coefficients taken from one iteration, and the factorization holds those of fewer unknowns.
module mdrcontact_line_stiffness
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: moments_t, new_interaction
    use mdrcontact_line_solve, only: first_unknowns, next_unknowns, raise_missed
    implicit none (type, external)
    private
    public :: relative_stiffness

    integer, parameter :: most_unknowns = 1500
    !> By how many tolerances two values may differ of which the second has a quarter more unknowns: on films what is left falls by
    !> far more than that from one to the next, on fine gradings as a power.
    real(wp), parameter :: on_films = 30.0_wp, on_gradings = 0.3_wp

contains

    !> The stiffness over that of a half-space of the surface material, E_eff/E0* of a flat punch, by two numbers of unknowns that
    !> must agree.
    subroutine relative_stiffness(parts, a, tolerance, twisted, ratio, error)
        !> the kernel, of normal load or of shear across the plane of waves; of a complex chi those of its two parts
        type(kernel_t), intent(in) :: parts(:)
        !> contact radius [length], and relative tolerance
        real(wp), intent(in) :: a, tolerance
        !> about the axis, else pressed
        logical, intent(in) :: twisted
        complex(wp), intent(out) :: ratio
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: ratios(2)
        real(wp) :: reached
        integer :: i, n

        ratio = 1.0_wp
        if (parts(1)%vanishes) return
        n = maxval([(first_unknowns(parts(i), tolerance, a/parts(i)%unit, .false., .false.), i=1, size(parts))])
        do
            call solve_with(parts, a, n, n - max(2, n/5), twisted, ratios, error)
            if (allocated(error)) return
            ratio = ratios(2)
            reached = abs(ratio - ratios(1))/(merge(on_films, on_gradings, all(parts%resolved <= 1.0_wp))*abs(ratio))
            if (reached <= tolerance) return
            if (n >= most_unknowns) exit
            n = min(next_unknowns(n, reached/tolerance), most_unknowns)
        end do
        call raise_missed(error, "a stiffness", tolerance, a, reached)
    end subroutine relative_stiffness

    !> With fewer and with n unknowns: the first coefficient of the solution of (1 + H) c = (1, 0, ...).
    subroutine solve_with(parts, a, n, fewer, twisted, first, error)
        type(kernel_t), intent(in) :: parts(:)
        real(wp), intent(in) :: a
        integer, intent(in) :: n, fewer
        logical, intent(in) :: twisted
        complex(wp), intent(out) :: first(2)
        type(error_t), allocatable, intent(inout) :: error
        type(moments_t) :: moments
        real(wp), allocatable :: h(:, :)
        complex(wp), allocatable :: matrix(:, :)
        complex(wp) :: y(n), before(n), diagonal
        integer :: part, i, j, stat

        first = 0.0_wp
        call check_cancelled(error)
        if (allocated(error)) return
        allocate (matrix(2*n, n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        matrix = 0.0_wp
        diagonal = 0.0_wp
        do part = 1, size(parts)
            call new_interaction(moments, h, parts(part), a, 2*n, n, 4*n + 4, 6*n, error, twisted)
            if (allocated(error)) return
            do j = 1, n
                if (part == 1) matrix(j:, j) = h(j:, j)
                if (part == 2) matrix(j:, j) = matrix(j:, j) + (0.0_wp, 1.0_wp)*h(j:, j)
            end do
            ! one_plus_chi = 1 + chi of both parts
            if (part == 1) diagonal = moments%diagonal
            if (part == 2) diagonal = diagonal + (0.0_wp, 1.0_wp)*(moments%diagonal - 1.0_wp)
        end do
        do j = 1, n
            matrix(j, j) = matrix(j, j) + diagonal
        end do
        ! L has ones on its diagonal, D is kept there
        y = 0.0_wp
        y(1) = 1.0_wp
        do j = 1, n
            if (j == fewer + 1) before = y
            if (.not. real(matrix(j, j), wp) > 0.0_wp) then
                call raise(error, error_no_convergence, "the springs of this body are nearly singular at contact radius "// &
                    to_text(a))
                return
            end if
            do i = j + 1, n
                y(i) = y(i) - matrix(i, j)/matrix(j, j)*y(j)
                matrix(i:n, i) = matrix(i:n, i) - matrix(i, j)/matrix(j, j)*matrix(i:n, j)
            end do
        end do
        first = [first_coefficient(n, fewer, matrix, before), first_coefficient(n, n, matrix, y)]
    end subroutine solve_with

    !> From the first m steps of the elimination: their part, back substitution, and the other rows of the equation.
    pure function first_coefficient(n, m, matrix, eliminated) result(first)
        integer, intent(in) :: n, m
        !> the factor L D in the first n rows
        complex(wp), intent(in) :: matrix(2*n, n)
        !> the right-hand side after m steps
        complex(wp), intent(in) :: eliminated(n)
        complex(wp) :: first
        complex(wp) :: y(m), rest(m + 1:2*n)
        integer :: j

        y = eliminated(:m)
        rest = 0.0_wp
        rest(m + 1:n) = eliminated(m + 1:)
        first = 0.0_wp
        do j = m, 1, -1
            first = first + y(j)**2/matrix(j, j)
            y(j) = (y(j) - sum(matrix(j + 1:m, j)*y(j + 1:)))/matrix(j, j)
            rest(n + 1:) = rest(n + 1:) - matrix(n + 1:, j)*y(j)
        end do
        first = first + sum(rest(m + 1:2*m)**2)
    end function first_coefficient

end module mdrcontact_line_stiffness
