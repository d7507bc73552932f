/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/adhesion.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/adhesion.h"
#include "refuse.h"

int mdrcontact_entry_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out);
int mdr_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_rate_new(c, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_rate_new(c, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_rate_work(const mdr_rate_options *options, int n, const double v[], double out[], double *time, double *zone);
int mdr_rate_work(const mdr_rate_options *options, int n, const double v[], double out[], double *time, double *zone)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !v) return mdrcontact_refuse_null("v");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_rate_work(options, n, v, out, time, zone);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_rate_work(options, n, v, out, time, zone);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance,
        const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[], double F[], double v[],
        double dissipated[], double work[], mdr_rate_state *end);
int mdr_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n,
        const double time[], const double in[], double d[], double a[], double F[], double v[], double dissipated[], double work[],
        mdr_rate_state *end)
{
    if (!start) return mdrcontact_refuse_null("start");
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (!end) return mdrcontact_refuse_null("end");
    if (arithmetic_is_set()) return mdrcontact_entry_rate_history(r, control, spring_stiffness, tolerance, start, n, time, in, d, a,
        F, v, dissipated, work, end);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_rate_history(r, control, spring_stiffness, tolerance, start, n, time, in, d, a, F, v,
        dissipated, work, end);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance,
        const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[], double zone_radius[],
        double F[], mdr_rate_state *end);
int mdr_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance,
        const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[], double zone_radius[],
        double F[], mdr_rate_state *end)
{
    if (!start) return mdrcontact_refuse_null("start");
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (!end) return mdrcontact_refuse_null("end");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_adhesive_history(c, control, spring_stiffness, tolerance, start, n,
        time, in, d, a, zone_radius, F, end);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_adhesive_history(c, control, spring_stiffness, tolerance, start, n, time, in, d, a,
        zone_radius, F, end);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
