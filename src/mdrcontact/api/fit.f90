! SPDX-License-Identifier: GPL-3.0-or-later
!> The inversion of measured data, for C.
module mdrcontact_api_fit
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_fit_problem, only: read_data, read_problem
    use mdrcontact_api_options, only: check_size, write_facts
    use mdrcontact_api_records, only: c_fit_summary_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: error_t
    use mdrcontact_fit, only: fit_result_t, solve_fit
    use mdrcontact_fit_problem, only: fit_data_t, fit_problem_t
    implicit none (type, external)
    private
    public :: mdr_fit_solve

contains

    function mdr_fit_solve(problem, n, x, y, given, sd, values, covariance, widening, at_bound, weakest_direction, fitted, &
                           residuals, summary) &
        result(status) bind(C, name="mdrcontact_entry_fit_solve")
        type(c_ptr), value :: problem
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*), y(*), given(*), sd(*)
        real(c_double), intent(inout), optional :: values(*), covariance(*), widening(*), weakest_direction(*), &
                                                   fitted(*), residuals(*)
        integer(c_int), intent(inout), optional :: at_bound(*)
        type(c_ptr), value :: summary
        integer(c_int) :: status
        type(c_fit_summary_t), target :: made
        integer(c_size_t) :: used
        type(fit_problem_t) :: chosen
        type(c_ptr) :: branch
        type(fit_data_t) :: data
        type(fit_result_t) :: fit
        type(error_t), allocatable :: error
        integer :: i, j, m

        call read_problem(problem, chosen, branch, error)
        if (.not. allocated(error)) call read_data(branch, n, x, y, given, sd, data, error)
        if (c_associated(summary)) call check_size(error, "summary", summary, c_sizeof(made), used)
        if (.not. allocated(error)) call solve_fit(chosen, data, fit, error)
        if (.not. allocated(error)) call check_results(error, fit%fitted)
        if (.not. allocated(error)) call check_results(error, fit%residuals)
        status = status_of(error)
        if (allocated(error)) return
        m = size(fit%values)
        if (present(values)) values(:m) = fit%values
        if (present(fitted)) fitted(:n) = fit%fitted
        if (present(residuals)) residuals(:n) = fit%residuals
        if (present(at_bound)) then
            at_bound(:m) = 0_c_int
            at_bound(fit%free) = int(fit%at_bound, c_int)
        end if
        if (present(weakest_direction)) then
            weakest_direction(:m) = 0.0_c_double
            weakest_direction(fit%free) = fit%weakest_direction
        end if
        if (present(widening)) then
            widening(:m) = 1.0_c_double
            widening(fit%free) = fit%widening
        end if
        if (present(covariance)) then
            covariance(:m*m) = 0.0_c_double
            do j = 1, size(fit%free)
                do i = 1, size(fit%free)
                    covariance((fit%free(j) - 1)*m + fit%free(i)) = fit%covariance(i, j)
                end do
            end do
        end if
        if (c_associated(summary)) then
            made = c_fit_summary_t(used, merge(1_c_int, 0_c_int, fit%converged), int(fit%iterations, c_int), &
                                   int(fit%evaluations, c_int), fit%chi_square, fit%prior_chi_square, fit%degrees_of_freedom, &
                                   fit%noise, fit%log_likelihood, fit%pattern_probability, fit%weakest, fit%lag_correlation)
            call write_facts(summary, c_loc(made), used)
        end if
    end function mdr_fit_solve

end module mdrcontact_api_fit
