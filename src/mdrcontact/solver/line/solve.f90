! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs' equation at one contact radius (theory/exact.md (1.2), (3.2)): (1 + K) q = E0* (d - g) in even Legendre polynomials.
!>
!> n unknowns are solved for, and as many coefficients more come from one iteration of the equation (`remainder`). Under a fine
!> surface layer X is nearly singular at the edge, and its series falls slowly there: its product with g is taken whole, as an
!> integral.
module mdrcontact_line_solve
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: edge_kernel, edge_row, edge_slopes, is_fine, moments_t, new_interaction
    use mdrcontact_line_moments, only: edge_moment, is_smooth, profile_moments
    use mdrcontact_line_remainder, only: new_remainder, remainder_t
    use mdrcontact_numerics_one_thread, only: factorize_positive
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: equation_t, new_equation, solution_t, solve, first_unknowns, next_unknowns, nodes_of_film, factorize, needed, &
              solve_lower, solve_upper, raise_missed

    !> Largest number of unknowns, and the largest at the start for a graded body.
    integer, parameter :: most_unknowns = 1500, first_graded = 16
    !> From this size on LAPACK factorizes: beyond a/h of some thousands. Below it a BLAS with threads of its own would start them
    !> for microseconds of work, which costs many times that where the processors are busy.
    integer, parameter :: large = 300
    !> Moments of a fine kernel beyond this part of the highest order do not show in numbers that depend on them by squares.
    real(wp), parameter :: needed = 0.6_wp
    !> Number of unknowns for the coefficients themselves, relative to that of a state, and limit of the last ones in tolerances.
    real(wp), parameter :: more_of_series = 1.4_wp, loose = 10.0_wp
    !> Rounding of the kernel and its moments, with some to spare.
    real(wp), parameter :: rounding = 14.0_wp*epsilon(1.0_wp)

    !> (1 + K) q = E0* (d - g) at one contact radius by n unknowns, with as many rows as requested.
    type :: equation_t
        type(moments_t) :: moments
        !> the Cholesky factor of the first n rows of 1 + H, and the rows beyond
        real(wp), allocatable :: h(:, :)
        !> right-hand sides: 1, values at the edge (see edge_row), and g less its mean
        real(wp), allocatable :: rhs(:, :)
        !> the mean of g over the contact, and g(a) less that [length]
        real(wp) :: profile_mean = 0.0_wp, edge_above_mean = 0.0_wp
    end type equation_t

    !> The state at one contact radius.
    type :: solution_t
        !> number of unknowns
        integer :: unknowns = 0
        !> E_eff/E0* [1], q_1 at the edge of the contact [1], depth of the non-adhesive state [length], d'(a) [1]
        real(wp) :: modulus = 1.0_wp, punch_edge = 1.0_wp, depth = 0.0_wp, depth_slope = 0.0_wp
        !> force/E0* [length^2]
        real(wp) :: force = 0.0_wp
        !> estimated relative errors of E_eff, q_1 at the edge, d and F
        real(wp) :: errors(4) = 0.0_wp
        !> the part of them that rounding makes
        real(wp) :: rounding = 0.0_wp
    end type solution_t

contains

    !> The solution at contact radius a; without a profile for the flat punch alone.
    subroutine solve(kernel, tolerance, a, solution, error, profile, edge, series)
        type(kernel_t), intent(in) :: kernel
        !> relative, of E_eff, d and F
        real(wp), intent(in) :: tolerance
        !> [length]
        real(wp), intent(in) :: a
        type(solution_t), intent(out) :: solution
        type(error_t), allocatable, intent(out) :: error
        class(profile_t), intent(in), optional :: profile
        !> q_1 at the edge, slower to converge on a graded body, meets the tolerance too; default false
        logical, intent(in), optional :: edge
        !> coefficients of s_j P_2j(x/a) of q_1 [1] and of q/E0* without adhesion [length] (term, 2), the last of
        !> which are within 10 tolerances
        real(wp), allocatable, intent(out), optional :: series(:, :)
        real(wp), allocatable :: edge_load
        real(wp) :: reached
        integer :: n, nodes
        logical :: solved, to_edge, is_kinked

        reached = huge(reached)
        to_edge = .false.
        if (present(edge)) to_edge = edge
        is_kinked = .false.
        if (present(profile)) is_kinked = .not. is_smooth(profile)
        n = first_unknowns(kernel, tolerance, a/kernel%unit, is_kinked, to_edge)
        ! Legendre coefficients of a kinked profile fall so slowly that they need more of the kernel
        nodes = ceiling(nodes_of_film(tolerance, a/kernel%unit)*merge(1.4_wp, 1.0_wp, is_kinked))
        if (present(series)) n = ceiling(more_of_series*n)
        do
            call check_cancelled(error)
            if (allocated(error)) return
            call solve_with(kernel, a, n, max(nodes, 2*n), edge_load, solution, solved, error, profile, series)
            if (allocated(error)) return
            if (.not. solved) then
                call raise(error, error_no_convergence, "the springs of this body are nearly singular at contact radius "// &
                           to_text(a)//": rounding errors dominate")
                return
            end if
            reached = maxval(solution%errors, mask=[.true., to_edge, .true., .true.])
            if (present(series)) reached = max(reached, maxval(abs(series(2*n - 1:, 2)))/(loose*norm2(series(:, 2))))
            if (reached <= tolerance) return
            ! more unknowns do not help against rounding
            if (solution%rounding > tolerance) exit
            if (n >= most_unknowns) exit
            n = min(next_unknowns(n, reached/tolerance), most_unknowns)
        end do
        call raise_missed(error, "a state", tolerance, a, reached)
    end subroutine solve

    !> Nodes of the rule that resolves the kernel of a film.
    pure function nodes_of_film(tolerance, a) result(nodes)
        !> relative tolerance, and contact radius [unit]
        real(wp), intent(in) :: tolerance, a
        real(wp) :: nodes

        nodes = min((11.5_wp*sqrt(a) + 10.0_wp)*(1.0_wp - 0.025_wp*log(tolerance/1.0e-10_wp)), 1.0e4_wp)
    end function nodes_of_film

    !> Raises the error of a missed tolerance, with its remedy.
    pure subroutine raise_missed(error, what, tolerance, a, reached)
        type(error_t), allocatable, intent(inout) :: error
        !> the requested quantity
        character(len=*), intent(in) :: what
        !> relative; contact radius [length]; what was reached
        real(wp), intent(in) :: tolerance, a, reached

        call raise(error, error_no_convergence, what//" of the exact layered medium did not reach the relative tolerance "// &
                   to_text(tolerance)//" at contact radius "//to_text(a)//": it reached "//to_text(min(reached, 1.0_wp))// &
                   ". If this suffices, increase the tolerance of the medium")
    end subroutine raise_missed

    !> n such that the estimate meets the tolerance at the first attempt, for films: fitted to what 5 films take.
    pure function first_unknowns(kernel, tolerance, a, is_kinked, to_edge) result(n)
        type(kernel_t), intent(in) :: kernel
        !> relative tolerance, and contact radius [unit]
        real(wp), intent(in) :: tolerance, a
        !> g is not a polynomial in x^2; q_1 at the edge is needed
        logical, intent(in) :: is_kinked, to_edge
        integer :: n
        real(wp) :: contrast, coarse, rate, unknowns

        n = 4
        if (kernel%vanishes) return
        contrast = min(log(max(kernel%one_plus_chi_zero, 0.01_wp)), -log(0.01_wp))
        if (is_kinked) contrast = max(contrast, 0.0_wp)
        rate = max(3.45_wp + 0.22_wp*abs(contrast) - 0.165_wp*log(tolerance/1.0e-10_wp), 0.5_wp)
        if (a >= 0.2_wp) n = max(n, ceiling(min(rate*sqrt(a), real(first_graded, wp))))
        coarse = a/kernel%resolved
        if (coarse < 0.2_wp) return
        unknowns = rate*sqrt(coarse)
        if (is_kinked) then
            unknowns = unknowns*(1.0_wp + 0.21_wp*log(max(coarse, 1.0_wp))) + 3.2_wp
        else if (to_edge) then
            unknowns = 1.3_wp*unknowns + 1.0_wp
        end if
        n = max(n, ceiling(min(unknowns, real(most_unknowns, wp))))
    end function first_unknowns

    !> n that makes errors smaller by a factor: they fall as exp(-c n), c from what brought them down so far.
    pure function next_unknowns(n, factor) result(next)
        integer, intent(in) :: n
        real(wp), intent(in) :: factor
        integer :: next

        next = n + ceiling(n*min(max(0.06_wp*log(max(factor, 1.0_wp)), 0.15_wp), 0.8_wp))
    end function next_unknowns

    !> The equation at contact radius a; without a profile for the flat punch alone.
    subroutine new_equation(self, kernel, a, rows, n, count, order, solved, error, profile)
        type(equation_t), intent(out) :: self
        type(kernel_t), intent(in) :: kernel
        !> [length]
        real(wp), intent(in) :: a
        !> rows, unknowns, and the arguments of new_interaction
        integer, intent(in) :: rows, n, count, order
        !> the matrix was positive definite
        logical, intent(out) :: solved
        type(error_t), allocatable, intent(inout) :: error
        class(profile_t), intent(in), optional :: profile
        integer :: i

        solved = .false.
        call new_interaction(self%moments, self%h, kernel, a, rows, n, count, order, error)
        if (allocated(error)) return
        allocate (self%rhs(rows, 3))
        self%rhs(:, 1) = 0.0_wp
        self%rhs(1, 1) = sqrt(2.0_wp)
        call edge_row(self%moments, self%h(:, 1), self%rhs(:, 2))
        self%rhs(:, 3) = 0.0_wp
        if (present(profile)) then
            call profile_moments(profile, a, self%rhs(:, 3), error)
            if (allocated(error)) return
            self%profile_mean = self%rhs(1, 3)*sqrt(0.5_wp)
            self%rhs(1, 3) = 0.0_wp
            self%edge_above_mean = profile%mdr(a) - self%profile_mean
        end if
        do i = 1, n
            self%h(i, i) = self%h(i, i) + self%moments%diagonal
        end do
        call factorize(n, rows, self%h, solved)
    end subroutine new_equation

    !> The solution by n unknowns, with its errors.
    subroutine solve_with(kernel, a, n, nodes, edge_load, solution, solved, error, profile, series)
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: a
        !> unknowns, and nodes of the rule that resolves the kernel of a film
        integer, intent(in) :: n, nodes
        !> edge_moment of the profile, the same for all n; not allocated: not known yet
        real(wp), allocatable, intent(inout) :: edge_load
        type(solution_t), intent(out) :: solution
        !> the matrix was positive definite
        logical, intent(out) :: solved
        type(error_t), allocatable, intent(inout) :: error
        class(profile_t), intent(in), optional :: profile
        !> as of `solve`
        real(wp), allocatable, intent(out), optional :: series(:, :)
        type(equation_t) :: equation
        real(wp), allocatable :: forward(:, :), rest(:, :), known(:), work(:, :)
        type(remainder_t) :: remainder
        real(wp) :: beyond, whole
        integer :: m, sides

        m = 2*n
        solution%unknowns = n
        sides = merge(3, 2, present(profile))
        call new_equation(equation, kernel, a, m, n, nodes, ceiling(needed*2*(m + n)), solved, error, profile)
        if (allocated(error) .or. .not. solved) return
        allocate (forward(n, 3), rest(m - n, 3), known(m), work(m - n, 3))
        whole = 0.0_wp
        known = 0.0_wp
        associate (moments => equation%moments, h => equation%h, rhs => equation%rhs)
            if (is_fine(kernel, a/kernel%unit, n) .and. any(abs(rhs(n + 1:, 3)) > 0.0_wp)) then
                if (.not. allocated(edge_load)) then
                    allocate (edge_load)
                    call edge_moment(profile, kernel, a, moments%shift, equation%profile_mean, edge_load, error)
                    if (allocated(error)) return
                end if
                call edge_kernel(moments, known)
                known = -known*rhs(:, 3)
                whole = -edge_load - sum(known(:n))
            end if
            forward = rhs(:n, :)
            call solve_lower(n, m, sides, h, forward)
            rest = rhs(n + 1:, :)
            rhs(:n, :) = forward
            call solve_upper(n, m, sides, h, rhs)
            work(:, :sides) = matmul(h(n + 1:, :), rhs(:n, :sides))
            rest(:, :sides) = rest(:, :sides) - work(:, :sides)
            call new_remainder(remainder, n, m, h)
            call add_higher_terms(n, a, equation%profile_mean, equation%edge_above_mean, remainder, forward, rest, &
                          known(n + 1:), whole, solution, &
                          work(:, 1), work(:, 2))
            if (present(profile)) then
                beyond = solution%depth - equation%profile_mean
                rhs(n + 1:, :) = rest
                call edge_slopes(moments, known)
                solution%depth_slope = sum(known*(beyond*rhs(:, 1) - rhs(:, 3)))/kernel%unit
                solution%depth_slope = (profile%mdr_slope(a) + solution%depth_slope)/solution%punch_edge
                if (present(series)) series = reshape([rhs(:, 1), beyond*rhs(:, 1) - rhs(:, 3)], [m, 2])
            end if
            ! a relative error of the kernel changes E_eff by this error times magnitude times E_eff/E0*
            solution%rounding = rounding*(2.0_wp + moments%magnitude*max(1.0_wp, solution%modulus))
            ! stiff layers bend at waves of so many thicknesses, where their compliance is a difference and loses as much
            solution%rounding = solution%rounding + epsilon(1.0_wp)*max(1.0_wp, kernel%one_plus_chi_zero)**(1.0_wp/3.0_wp) &
                                *max(0.0_wp, 1.0_wp - solution%modulus)
        end associate
        solution%errors = solution%errors + solution%rounding
    end subroutine solve_with

    !> The numbers from the factorization with what the coefficients beyond n add to them, and their errors.
    subroutine add_higher_terms(n, a, profile_mean, edge_above_mean, remainder, forward, rest, known, whole, solution, load, terms)
        integer, intent(in) :: n
        !> contact radius, mean of g over the contact and g(a) - mean [length]
        real(wp), intent(in) :: a, profile_mean, edge_above_mean
        type(remainder_t), intent(in) :: remainder
        !> the right-hand sides 1, edge and g, times the inverse of the factor, and what is left of them beyond n
        real(wp), intent(in) :: forward(:, :), rest(:, :)
        !> terms of edge and g, which decrease slowest, and the sum of all of them beyond n
        real(wp), intent(in) :: known(:), whole
        type(solution_t), intent(inout) :: solution
        !> room
        real(wp), intent(out) :: load(:), terms(:)
        real(wp) :: sums(4)
        real(wp) :: beyond, error, error_of_depth

        sums(1) = remainder%product(forward(:, 1), forward(:, 1), rest(:, 1), rest(:, 1))
        sums(2) = remainder%product(forward(:, 1), forward(:, 2), rest(:, 1), rest(:, 2))
        sums(3) = remainder%product(forward(:, 2), forward(:, 3), rest(:, 2), rest(:, 3), known, whole)
        sums(4) = remainder%product(forward(:, 1), forward(:, 3), rest(:, 1), rest(:, 3))
        solution%modulus = 0.5_wp*sums(1)
        solution%punch_edge = sums(2)
        beyond = (edge_above_mean + sums(3))/sums(2)
        solution%depth = profile_mean + beyond
        solution%force = a*(beyond*sums(1) - sums(4))

        load = beyond*rest(:, 1) - rest(:, 3)
        call remainder%truncation_error(n, rest(:, 1), rest(:, 1), terms, error)
        solution%errors(1) = error/sums(1)
        call remainder%truncation_error(n, rest(:, 1), rest(:, 2), terms, error)
        solution%errors(2) = error/abs(sums(2))
        if (solution%depth == 0.0_wp) return
        call remainder%truncation_error(n, rest(:, 2), load, terms, error, known)
        error_of_depth = error/abs(sums(2))
        solution%errors(3) = error_of_depth/solution%depth
        call remainder%truncation_error(n, rest(:, 1), load, terms, error)
        solution%errors(4) = a*(sums(1)*error_of_depth + error)/solution%force
    end subroutine add_higher_terms

    !> Cholesky factor of the first n rows of a, in place, lower triangle.
    subroutine factorize(n, m, a, done)
        integer, intent(in) :: n, m
        real(wp), intent(inout) :: a(m, n)
        logical, intent(out) :: done
        real(wp) :: factor
        integer :: i, j, k, info

        if (n >= large) then
            call factorize_positive(n, m, a, info)
            done = info == 0
            return
        end if
        done = .false.
        do j = 1, n
            if (.not. a(j, j) > 0.0_wp) return
            a(j:n, j) = a(j:n, j)/sqrt(a(j, j))
            do k = j + 1, n
                factor = a(k, j)
                !GCC$ ivdep
                do i = k, n
                    a(i, k) = a(i, k) - factor*a(i, j)
                end do
            end do
        end do
        done = .true.
    end subroutine factorize

    !> Replaces x by inv(L) x, L the lower triangle that factorize left in a.
    pure subroutine solve_lower(n, m, sides, a, x)
        integer, intent(in) :: n, m, sides
        real(wp), intent(in) :: a(m, n)
        real(wp), intent(inout) :: x(n, sides)
        integer :: i, j

        do j = 1, n
            do i = 1, sides
                x(j, i) = x(j, i)/a(j, j)
                x(j + 1:n, i) = x(j + 1:n, i) - x(j, i)*a(j + 1:n, j)
            end do
        end do
    end subroutine solve_lower

    !> Replaces x by inv(transpose(L)) x.
    pure subroutine solve_upper(n, m, sides, a, x)
        integer, intent(in) :: n, m, sides
        real(wp), intent(in) :: a(m, n)
        real(wp), intent(inout) :: x(m, sides)
        integer :: i, j

        do j = n, 1, -1
            do i = 1, sides
                x(j, i) = (x(j, i) - sum(a(j + 1:n, j)*x(j + 1:n, i)))/a(j, j)
            end do
        end do
    end subroutine solve_upper

end module mdrcontact_line_solve
