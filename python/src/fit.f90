! SPDX-License-Identifier: GPL-3.0-or-later
! Inversion of measured data, flat for f2py. The arrays codes, reals, objects and table are those of mdrcontact_flat_fit.

!> See mdr_fit_solve. numbers: converged, iterations, evaluations, chi_square, prior_chi_square, degrees_of_freedom, noise,
!> log_likelihood, runs_probability, weakest.
subroutine fit_solve(n, m, r, codes, reals, objects, table, x, y, force, sd, has_sd, values, covariance, at_bound, &
    weakest_direction, fitted, residuals, numbers, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_c_fit, only: fit_parameter_t, fit_summary_t, mdr_fit_solve
    use mdrcontact_flat_fit, only: optional_column, to_parameters, to_problem
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, m, r, has_sd
    integer(c_int), intent(in) :: codes(10)
    real(c_double), intent(in) :: reals(r)
    integer(c_int64_t), intent(in) :: objects(2)
    real(c_double), intent(in) :: table(6, m)
    real(c_double), intent(in) :: x(n), y(n), force(n)
    real(c_double), intent(in), target :: sd(n)
    real(c_double), intent(out) :: values(m), covariance(m, m), weakest_direction(m), fitted(n), residuals(n), numbers(10)
    integer(c_int), intent(out) :: at_bound(m)
    integer(c_int), intent(out) :: status
    type(fit_parameter_t), target :: parameters(m)
    type(fit_summary_t) :: summary

    values = 0.0_c_double
    covariance = 0.0_c_double
    weakest_direction = 0.0_c_double
    fitted = 0.0_c_double
    residuals = 0.0_c_double
    at_bound = 0_c_int
    summary = fit_summary_t(0_c_int, 0_c_int, 0_c_int, 0.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, &
                            0.0_c_double, 0.0_c_double)
    parameters = to_parameters(table)
    status = mdr_fit_solve(to_problem(codes, reals, objects, parameters), n, x, y, force, optional_column(has_sd, sd), values, &
                           covariance, at_bound, weakest_direction, fitted, residuals, summary)
    numbers = [real(summary%converged, c_double), real(summary%iterations, c_double), real(summary%evaluations, c_double), &
               summary%chi_square, summary%prior_chi_square, summary%degrees_of_freedom, summary%noise, &
               summary%log_likelihood, summary%runs_probability, summary%weakest]
end subroutine fit_solve

!> See mdr_fit_predict.
subroutine fit_predict(n, m, r, codes, reals, objects, table, x, y, force, fitted, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_c_fit, only: fit_parameter_t, mdr_fit_predict
    use mdrcontact_flat_fit, only: to_parameters, to_problem
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, m, r
    integer(c_int), intent(in) :: codes(10)
    real(c_double), intent(in) :: reals(r)
    integer(c_int64_t), intent(in) :: objects(2)
    real(c_double), intent(in) :: table(6, m)
    real(c_double), intent(in) :: x(n), y(n), force(n)
    real(c_double), intent(out) :: fitted(n)
    integer(c_int), intent(out) :: status
    type(fit_parameter_t), target :: parameters(m)

    fitted = 0.0_c_double
    parameters = to_parameters(table)
    status = mdr_fit_predict(to_problem(codes, reals, objects, parameters), n, x, y, force, fitted)
end subroutine fit_predict

!> See mdr_fit_interval.
subroutine fit_interval(n, m, r, codes, reals, objects, table, x, y, force, sd, has_sd, position, level, lower, upper, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_c_fit, only: fit_parameter_t, mdr_fit_interval
    use mdrcontact_flat_fit, only: optional_column, to_parameters, to_problem
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, m, r, has_sd, position
    integer(c_int), intent(in) :: codes(10)
    real(c_double), intent(in) :: reals(r), level
    integer(c_int64_t), intent(in) :: objects(2)
    real(c_double), intent(in) :: table(6, m)
    real(c_double), intent(in) :: x(n), y(n), force(n)
    real(c_double), intent(in), target :: sd(n)
    real(c_double), intent(out) :: lower, upper
    integer(c_int), intent(out) :: status
    type(fit_parameter_t), target :: parameters(m)

    lower = 0.0_c_double
    upper = 0.0_c_double
    parameters = to_parameters(table)
    status = mdr_fit_interval(to_problem(codes, reals, objects, parameters), n, x, y, force, optional_column(has_sd, sd), &
                              position, level, lower, upper)
end subroutine fit_interval
