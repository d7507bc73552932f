/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/fit.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/fit.h"
#include "refuse.h"

int mdrcontact_entry_fit_parameters(const mdr_fit_problem *problem, int capacity, mdr_fit_parameter out[], int *count);
int mdr_fit_parameters(const mdr_fit_problem *problem, int capacity, mdr_fit_parameter out[], int *count)
{
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_fit_parameters(problem, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_fit_parameters(problem, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        const double sd[], double values[], double covariance[], double widening[], int at_bound[], double weakest_direction[],
        double fitted[], double residuals[], mdr_fit_summary *summary);
int mdr_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        const double sd[], double values[], double covariance[], double widening[], int at_bound[], double weakest_direction[],
        double fitted[], double residuals[], mdr_fit_summary *summary)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (arithmetic_is_set()) return mdrcontact_entry_fit_solve(problem, n, x, y, given, sd, values, covariance, widening, at_bound,
        weakest_direction, fitted, residuals, summary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_fit_solve(problem, n, x, y, given, sd, values, covariance, widening, at_bound,
        weakest_direction, fitted, residuals, summary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        double fitted[], double radius[]);
int mdr_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        double fitted[], double radius[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (n > 0 && !fitted) return mdrcontact_refuse_null("fitted");
    if (arithmetic_is_set()) return mdrcontact_entry_fit_predict(problem, n, x, y, given, fitted, radius);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_fit_predict(problem, n, x, y, given, fitted, radius);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        const double sd[], int position, double level, double *lower, double *upper);
int mdr_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
        const double sd[], int position, double level, double *lower, double *upper)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (!lower) return mdrcontact_refuse_null("lower");
    if (!upper) return mdrcontact_refuse_null("upper");
    if (arithmetic_is_set()) return mdrcontact_entry_fit_interval(problem, n, x, y, given, sd, position, level, lower, upper);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_fit_interval(problem, n, x, y, given, sd, position, level, lower, upper);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_fit_quantile(double level, double degrees_of_freedom, double *factor);
int mdr_fit_quantile(double level, double degrees_of_freedom, double *factor)
{
    if (!factor) return mdrcontact_refuse_null("factor");
    if (arithmetic_is_set()) return mdrcontact_entry_fit_quantile(level, degrees_of_freedom, factor);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_fit_quantile(level, degrees_of_freedom, factor);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
