! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of fit that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_fit_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results, make_room
    use mdrcontact_api_fit_problem, only: read_data, read_problem
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_fit, only: fit_result_t, solve_fit
    use mdrcontact_fit_interval, only: interval_quantile, profile_interval
    use mdrcontact_fit_predict, only: predict
    use mdrcontact_fit_problem, only: check_points, fit_data_t, fit_problem_t, values_of
    implicit none (type, external)
    private
    public :: mdr_fit_predict
    public :: mdr_fit_interval
    public :: mdr_fit_quantile

contains

    function mdr_fit_predict(problem, n, x, y, given, fitted, radius) result(status) &
        bind(C, name="mdrcontact_entry_fit_predict")
        type(c_ptr), value :: problem
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*), y(*), given(*)
        real(c_double), intent(inout), optional :: fitted(*), radius(*)
        integer(c_int) :: status
        type(fit_problem_t) :: chosen
        type(fit_data_t) :: data
        type(c_ptr) :: branch
        real(c_double), allocatable :: fitted_values(:), radius_values(:)
        type(error_t), allocatable :: error

        call read_problem(problem, chosen, branch, error)
        if (.not. allocated(error)) call read_data(branch, n, x, y, given, data=data, error=error)
        if (.not. allocated(error)) call check_points(data, chosen, error)
        call make_room(error, n, fitted_values)
        call make_room(error, n, radius_values)
        if (.not. allocated(error)) then
            call predict(chosen, values_of(chosen%parameters), data, fitted_values, error, radius=radius_values)
        end if
        if (.not. allocated(error)) call check_results(error, fitted_values)
        if (.not. allocated(error)) call check_results(error, radius_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(fitted)) fitted(:n) = fitted_values
        if (present(radius)) radius(:n) = radius_values
    end function mdr_fit_predict

    function mdr_fit_interval(problem, n, x, y, given, sd, position, level, lower, upper) result(status) &
        bind(C, name="mdrcontact_entry_fit_interval")
        type(c_ptr), value :: problem
        integer(c_int), value :: n, position
        real(c_double), intent(in), optional :: x(*), y(*), given(*), sd(*)
        real(c_double), value :: level
        real(c_double), intent(inout), optional :: lower, upper
        integer(c_int) :: status
        type(fit_problem_t) :: chosen
        type(fit_data_t) :: data
        type(fit_result_t) :: fit
        type(c_ptr) :: branch
        real(c_double) :: lower_value, upper_value
        type(error_t), allocatable :: error

        call read_problem(problem, chosen, branch, error)
        if (.not. allocated(error)) call read_data(branch, n, x, y, given, sd, data, error)
        if (.not. allocated(error)) then
            if (position < 0 .or. position >= size(chosen%parameters)) call raise(error, error_invalid, "position = "// &
                count_text(position)//": it must be at least 0 and less than "//count_text(size(chosen%parameters)))
        end if
        if (.not. allocated(error)) call solve_fit(chosen, data, fit, error)
        lower_value = 0.0_c_double
        upper_value = 0.0_c_double
        if (.not. allocated(error)) call profile_interval(chosen, data, fit, position + 1, level, lower_value, upper_value, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(lower)) lower = lower_value
        if (present(upper)) upper = upper_value
    end function mdr_fit_interval

    function mdr_fit_quantile(level, degrees_of_freedom, factor) result(status) &
        bind(C, name="mdrcontact_entry_fit_quantile")
        real(c_double), value :: level, degrees_of_freedom
        real(c_double), intent(inout), optional :: factor
        integer(c_int) :: status
        real(c_double) :: factor_value
        type(error_t), allocatable :: error

        factor_value = 0.0_c_double
        call interval_quantile(level, degrees_of_freedom, factor_value, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(factor)) factor = factor_value
    end function mdr_fit_quantile

end module mdrcontact_api_fit_entries
