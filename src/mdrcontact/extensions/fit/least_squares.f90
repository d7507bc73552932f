! SPDX-License-Identifier: GPL-3.0-or-later
!> Least squares over GSL's trust region (Levenberg-Marquardt steps, scaled after More, solved by QR).
!>
!> The search ends when one more step could lower the sum of squares by a negligible part of its own statistical spread only: an
!> ending that is independent of units. Where the function has no value it is taken to be very large, so the step is refused.
module mdrcontact_fit_least_squares
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int, c_loc, c_null_funptr, c_null_ptr, &
                                           c_ptr, c_size_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_memory, error_t, raise
    use mdrcontact_fit_gsl_multifit, only: gsl_enoprog, gsl_matrix, gsl_multifit_nlinear_alloc, &
                                           gsl_multifit_nlinear_default_parameters, gsl_multifit_nlinear_fdf, &
                                           gsl_multifit_nlinear_free, gsl_multifit_nlinear_init, gsl_multifit_nlinear_iterate, &
                                           gsl_multifit_nlinear_jac, gsl_multifit_nlinear_parameters, &
                                           gsl_multifit_nlinear_position, gsl_multifit_nlinear_residual, &
                                           gsl_multifit_nlinear_solver_qr, gsl_multifit_nlinear_trust, gsl_vector
    use mdrcontact_fit_spectrum, only: newton_decrement
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_success
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: residuals_t, outcome_t, minimize

    !> Half of what one more Newton step would gain, in units of the mean square of the residuals.
    real(wp), parameter :: negligible_gain = 1.0e-8_wp
    !> The same where no step lowers the sum: a twentieth of a standard error from where the derivatives would have the minimum.
    real(wp), parameter :: small_gain = 2.5e-3_wp
    !> Residuals this small against the readings are an exact fit, as far as the model itself is exact: noise-free data.
    real(wp), parameter :: exact_fit = 1.0e-8_wp
    !> Steps in the internal variables for the differences of the Jacobian: far above the model's rounding, far below its curvature.
    real(wp), parameter :: difference_step = 1.0e-5_wp
    !> An unknown is at a bound that is this part of such a step away.
    real(wp), parameter :: at_bound = 0.01_wp
    !> Refused steps in a row are as good as no progress after so many.
    integer, parameter :: most_refusals = 3

    !> r(u), a vector of residuals of a vector of unknowns of order one.
    type, abstract :: residuals_t
        integer :: n = 0, p = 0
        integer :: evaluations = 0
        !> norm of the readings in the units of the residuals
        real(wp) :: readings_norm = 0.0_wp
        !> norm of the residuals at the start; set by minimize
        real(wp) :: start_norm = 0.0_wp
        !> why the last evaluation failed
        type(error_t), allocatable :: error
        !> whether one failed for want of memory, which is no property of the model
        logical :: lacked_memory = .false.
    contains
        procedure :: evaluate_counted
        procedure(residual_vector), deferred :: evaluate
        procedure(neighbours_of), deferred :: neighbours
    end type residuals_t

    abstract interface
        !> Writes r(u) (n); allocates self%error if it does not exist.
        subroutine residual_vector(self, u, r)
            import :: residuals_t, wp
            class(residuals_t), intent(inout) :: self
            real(wp), intent(in) :: u(:)
            real(wp), intent(out) :: r(:)
        end subroutine residual_vector

        !> Two values of unknown i on either side of u(i) for the difference quotient, the same where it cannot move.
        subroutine neighbours_of(self, u, i, step, below, above)
            import :: residuals_t, wp
            class(residuals_t), intent(inout) :: self
            real(wp), intent(in) :: u(:)
            integer, intent(in) :: i
            real(wp), intent(in) :: step
            real(wp), intent(out) :: below, above
        end subroutine neighbours_of
    end interface

    !> Outcome of a search.
    type :: outcome_t
        logical :: converged = .false.
        !> no step lowered the sum of squares
        logical :: is_stuck = .false.
        integer :: iterations = 0
        !> residuals (n) and their derivatives (n, p) at the end
        real(wp), allocatable :: r(:), jacobian(:, :)
    end type outcome_t

    !> Data passed through GSL's `void *params`.
    type :: search_t
        class(residuals_t), pointer :: residuals => null()
        !> the unknowns of the last step and their residuals, from which differences are taken
        real(wp), allocatable :: last_u(:), last_r(:)
        !> residuals at a neighbouring point
        real(wp), allocatable :: moved_r(:)
    end type search_t

contains

    !> Lowers |r(u)|^2 from the given u, which is overwritten with the best point found.
    subroutine minimize(residuals, u, max_iterations, outcome, error)
        class(residuals_t), intent(inout), target :: residuals
        real(wp), intent(inout), target :: u(:)
        integer, intent(in) :: max_iterations
        type(outcome_t), intent(out) :: outcome
        type(error_t), allocatable, intent(out) :: error
        type(search_t), target :: search
        type(gsl_multifit_nlinear_fdf), target :: fdf
        type(gsl_multifit_nlinear_parameters) :: parameters
        type(gsl_vector) :: start
        type(c_ptr) :: workspace
        integer :: stat

        call disable_gsl_abort()
        allocate (search%last_r(residuals%n), search%moved_r(residuals%n), outcome%r(residuals%n), &
                  outcome%jacobian(residuals%n, residuals%p), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        search%residuals => residuals
        search%last_u = u
        call residuals%evaluate_counted(u, search%last_r)
        if (allocated(residuals%error)) then
            error = residuals%error
            return
        end if
        residuals%start_norm = norm2(search%last_r)
        parameters = gsl_multifit_nlinear_default_parameters()
        parameters%solver = gsl_multifit_nlinear_solver_qr
        workspace = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, parameters, int(residuals%n, c_size_t), &
                                               int(residuals%p, c_size_t))
        if (.not. c_associated(workspace)) then
            call raise(error, error_memory, "not enough memory for a fit")
            return
        end if
        fdf = gsl_multifit_nlinear_fdf(c_funloc(residual_callback), c_funloc(jacobian_callback), c_null_funptr, &
                                       int(residuals%n, c_size_t), int(residuals%p, c_size_t), c_loc(search), 0, 0, 0)
        start = gsl_vector(int(residuals%p, c_size_t), 1_c_size_t, c_loc(u), c_null_ptr, 0_c_int)
        if (gsl_multifit_nlinear_init(start, c_loc(fdf), workspace) == gsl_success) then
            call iterate(search, workspace, max_iterations, (exact_fit*residuals%readings_norm)**2, outcome)
        else
            outcome%r(:) = search%last_r
            outcome%jacobian(:, :) = 0.0_wp
        end if
        call read_vector(gsl_multifit_nlinear_position(workspace), u)
        if (outcome%is_stuck .and. .not. outcome%converged) call use_central_differences(search, u, outcome)
        call gsl_multifit_nlinear_free(workspace)
        if (allocated(residuals%error)) deallocate (residuals%error)
        ! a model that was not computed to its end was a rejected step
        call check_cancelled(error)
        if (residuals%lacked_memory) call raise(error, error_memory, "not enough memory for a fit")
    end subroutine minimize

    subroutine iterate(search, workspace, max_iterations, exact_sum, outcome)
        type(search_t), intent(inout) :: search
        type(c_ptr), intent(in) :: workspace
        integer, intent(in) :: max_iterations
        !> a sum of squares that is an exact fit
        real(wp), intent(in) :: exact_sum
        type(outcome_t), intent(inout) :: outcome
        real(wp) :: sum_of_squares, u(size(outcome%jacobian, 2))
        integer(c_int) :: status
        integer :: refusals

        call read_state(workspace, outcome)
        refusals = 0
        do
            sum_of_squares = sum(outcome%r**2)
            call read_vector(gsl_multifit_nlinear_position(workspace), u)
            outcome%converged = possible_gain(search%residuals, u, outcome) <= negligible_gain*sum_of_squares/size(outcome%r) &
                                .or. sum_of_squares <= exact_sum
            if (outcome%converged .or. outcome%iterations >= max_iterations) return
            status = gsl_multifit_nlinear_iterate(workspace)
            outcome%iterations = outcome%iterations + 1
            call read_state(workspace, outcome)
            if (status /= gsl_success) then
                ! no step lowers the sum: at the minimum but for rounding, or stuck
                sum_of_squares = sum(outcome%r**2)
                call read_vector(gsl_multifit_nlinear_position(workspace), u)
                outcome%converged = possible_gain(search%residuals, u, outcome) <= small_gain*sum_of_squares/size(outcome%r) &
                                    .or. sum_of_squares <= exact_sum
                outcome%is_stuck = status == gsl_enoprog .or. refusals >= most_refusals
                if (outcome%is_stuck) return
                refusals = refusals + 1
            end if
        end do
    end subroutine iterate

    !> Whether a search that is stuck is at the minimum by differences to both sides: those to one side hold half of the step times
    !> the curvature, which is large where readings next to first contact all lie on one side of the model.
    subroutine use_central_differences(search, u, outcome)
        type(search_t), intent(inout) :: search
        !> where it is
        real(wp), intent(in) :: u(:)
        type(outcome_t), intent(inout) :: outcome
        real(wp), allocatable :: central(:, :)
        real(wp) :: below, above, v(size(u))
        integer :: i, stat

        allocate (central(size(outcome%jacobian, 1), size(u)), stat=stat)
        if (stat /= 0) return
        associate (residuals => search%residuals)
            do i = 1, size(u)
                call residuals%neighbours(u, i, difference_step, below, above)
                v = u
                v(i) = above
                call residuals%evaluate_counted(v, central(:, i))
                if (allocated(residuals%error) .or. .not. above > below) return
                v(i) = below
                call residuals%evaluate_counted(v, search%moved_r)
                if (allocated(residuals%error)) return
                central(:, i) = (central(:, i) - search%moved_r)/(above - below)
            end do
        end associate
        outcome%jacobian(:, :) = central
        outcome%converged = possible_gain(search%residuals, u, outcome) <= small_gain*sum(outcome%r**2)/size(outcome%r)
    end subroutine use_central_differences

    !> Half of what a Newton step would gain in which no unknown at its bound moves beyond it.
    function possible_gain(residuals, u, outcome) result(gain)
        class(residuals_t), intent(inout) :: residuals
        !> where the outcome is
        real(wp), intent(in) :: u(:)
        type(outcome_t), intent(in) :: outcome
        real(wp) :: gain
        real(wp) :: below, above, slope
        logical :: is_held(size(u))
        integer :: i

        do i = 1, size(u)
            call residuals%neighbours(u, i, difference_step, below, above)
            slope = dot_product(outcome%jacobian(:, i), outcome%r)
            is_held(i) = merge(u(i) - below, above - u(i), slope > 0.0_wp) < at_bound*difference_step
        end do
        gain = newton_decrement(outcome%jacobian, outcome%r, is_held)
    end function possible_gain

    subroutine read_state(workspace, outcome)
        type(c_ptr), intent(in) :: workspace
        type(outcome_t), intent(inout) :: outcome
        type(gsl_matrix), pointer :: matrix
        real(c_double), pointer :: rows(:, :)
        integer :: i

        call c_f_pointer(gsl_multifit_nlinear_jac(workspace), matrix)
        call c_f_pointer(matrix%data, rows, [matrix%tda, matrix%size1])
        do i = 1, size(outcome%jacobian, 2)
            outcome%jacobian(:, i) = rows(i, :)
        end do
        call read_vector(gsl_multifit_nlinear_residual(workspace), outcome%r)
    end subroutine read_state

    subroutine read_vector(pointer, values)
        type(c_ptr), intent(in) :: pointer
        real(wp), intent(out) :: values(:)
        type(gsl_vector), pointer :: vector
        real(c_double), pointer :: entries(:)

        call c_f_pointer(pointer, vector)
        call c_f_pointer(vector%data, entries, [vector%stride*vector%size])
        values = entries(::vector%stride)
    end subroutine read_vector

    !> Without a binding label, like all callbacks: under its own name the linker would take a client's function of that name.
    function residual_callback(x, params, f) result(status) bind(C, name="")
        type(gsl_vector), intent(in) :: x
        type(c_ptr), value :: params
        type(gsl_vector), intent(in) :: f
        integer(c_int) :: status
        type(search_t), pointer :: search
        real(c_double), pointer :: u(:), r(:)
        integer :: i

        call c_f_pointer(params, search)
        call c_f_pointer(x%data, u, [x%stride*x%size])
        call c_f_pointer(f%data, r, [f%stride*f%size])
        call go_to(search, u(::x%stride))
        ! by a section gfortran would copy, for pointers may overlap
        do i = 1, search%residuals%n
            r(1 + (i - 1)*f%stride) = search%last_r(i)
        end do
        status = gsl_success
    end function residual_callback

    !> Makes u the last point: its residuals, or where there are none, values that no step would accept.
    subroutine go_to(search, u)
        type(search_t), intent(inout) :: search
        real(wp), intent(in) :: u(:)

        if (all(search%last_u == u)) return
        call search%residuals%evaluate_counted(u, search%last_r)
        if (allocated(search%residuals%error)) search%last_r(:) = 1.0e3_wp*(search%residuals%start_norm + 1.0_wp)
        search%last_u = u
    end subroutine go_to

    function jacobian_callback(x, params, j) result(status) bind(C, name="")
        type(gsl_vector), intent(in) :: x
        type(c_ptr), value :: params
        type(gsl_matrix), intent(in) :: j
        integer(c_int) :: status
        type(search_t), pointer :: search
        real(c_double), pointer :: u(:), rows(:, :)

        call c_f_pointer(params, search)
        call c_f_pointer(x%data, u, [x%stride*x%size])
        call c_f_pointer(j%data, rows, [j%tda, j%size1])
        call differences(search, u(::x%stride), rows)
        status = gsl_success
    end function jacobian_callback

    !> Forward differences from the residuals of the step just taken; backward at a bound or where the model has no value ahead.
    subroutine differences(search, u, rows)
        type(search_t), intent(inout) :: search
        real(wp), intent(in) :: u(:)
        !> one for each unknown
        real(wp), intent(inout) :: rows(:, :)
        real(wp) :: v(size(u)), below, above
        integer :: i

        call go_to(search, u)
        associate (residuals => search%residuals)
            do i = 1, size(u)
                rows(i, :) = 0.0_wp
                call residuals%neighbours(u, i, difference_step, below, above)
                v = u
                v(i) = above
                if (above > u(i)) call residuals%evaluate_counted(v, search%moved_r)
                if (.not. above > u(i) .or. allocated(residuals%error)) then
                    v(i) = below
                    if (.not. below < u(i)) cycle
                    call residuals%evaluate_counted(v, search%moved_r)
                    if (allocated(residuals%error)) cycle
                end if
                rows(i, :) = (search%moved_r - search%last_r)/(v(i) - u(i))
            end do
        end associate
    end subroutine differences

    !> One evaluation, with a clean slate.
    subroutine evaluate_counted(self, u, r)
        class(residuals_t), intent(inout) :: self
        real(wp), intent(in) :: u(:)
        real(wp), intent(out) :: r(:)

        if (allocated(self%error)) deallocate (self%error)
        r = 0.0_wp
        call check_cancelled(self%error)
        if (.not. allocated(self%error)) call self%evaluate(u, r)
        if (allocated(self%error)) self%lacked_memory = self%lacked_memory .or. self%error%code == error_memory
        self%evaluations = self%evaluations + 1
    end subroutine evaluate_counted

end module mdrcontact_fit_least_squares
