! SPDX-License-Identifier: GPL-3.0-or-later
!> The fit of the C API.
!> The manual is include/mdrcontact.h; this is its Fortran picture, for the wrappers only.
module mdrcontact_c_fit
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_medium_options, only: medium_options_t
    implicit none (type, external)
    private
    public :: fit_problem_t, fit_parameter_t, fit_summary_t
    public :: mdr_fit_solve, mdr_fit_predict, mdr_fit_interval

    !> struct mdr_fit_parameter
    type, bind(C) :: fit_parameter_t
        real(c_double) :: value
        real(c_double) :: lower
        real(c_double) :: upper
        real(c_double) :: prior
        real(c_double) :: prior_sd
        integer(c_int) :: is_free
    end type fit_parameter_t

    !> struct mdr_fit_problem
    type, bind(C) :: fit_problem_t
        integer(c_int) :: data_kind
        integer(c_int) :: indenter
        type(c_ptr) :: profile
        integer(c_int) :: medium
        type(c_ptr) :: medium_object
        integer(c_int) :: model
        integer(c_int) :: layers
        type(medium_options_t) :: options
        integer(c_int) :: adhesion_rule
        integer(c_int) :: loss
        real(c_double) :: loss_scale
        integer(c_int) :: sd_is_absolute
        integer(c_int) :: max_iterations
        integer(c_int) :: check_units
        integer(c_int) :: parameter_count
        type(c_ptr) :: parameters
    end type fit_problem_t

    !> struct mdr_fit_summary
    type, bind(C) :: fit_summary_t
        integer(c_int) :: converged
        integer(c_int) :: iterations
        integer(c_int) :: evaluations
        real(c_double) :: chi_square
        real(c_double) :: prior_chi_square
        real(c_double) :: degrees_of_freedom
        real(c_double) :: noise
        real(c_double) :: log_likelihood
        real(c_double) :: runs_probability
        real(c_double) :: weakest
    end type fit_summary_t

    interface

        function mdr_fit_solve(problem, n, x, y, force, sd, values, covariance, at_bound, weakest_direction, fitted, residuals, &
            summary) &
            result(status) bind(C)
            import :: c_double, c_int, c_ptr, fit_problem_t, fit_summary_t
            implicit none (type, external)
            type(fit_problem_t), intent(in) :: problem
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*), y(*), force(*)
            type(c_ptr), value :: sd
            real(c_double), intent(inout) :: values(*), covariance(*), weakest_direction(*), fitted(*), residuals(*)
            integer(c_int), intent(inout) :: at_bound(*)
            type(fit_summary_t), intent(inout) :: summary
            integer(c_int) :: status
        end function mdr_fit_solve

        function mdr_fit_predict(problem, n, x, y, force, fitted) result(status) bind(C)
            import :: c_double, c_int, fit_problem_t
            implicit none (type, external)
            type(fit_problem_t), intent(in) :: problem
            integer(c_int), value :: n
            real(c_double), intent(in) :: x(*), y(*), force(*)
            real(c_double), intent(inout) :: fitted(*)
            integer(c_int) :: status
        end function mdr_fit_predict

        function mdr_fit_interval(problem, n, x, y, force, sd, position, level, lower, upper) result(status) bind(C)
            import :: c_double, c_int, c_ptr, fit_problem_t
            implicit none (type, external)
            type(fit_problem_t), intent(in) :: problem
            integer(c_int), value :: n, position
            real(c_double), intent(in) :: x(*), y(*), force(*)
            type(c_ptr), value :: sd
            real(c_double), value :: level
            real(c_double), intent(inout) :: lower, upper
            integer(c_int) :: status
        end function mdr_fit_interval

    end interface

end module mdrcontact_c_fit
