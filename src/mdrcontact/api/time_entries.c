/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/time.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/time.h"
#include "refuse.h"

int mdrcontact_entry_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[],
        const double in[], double d[], double a[], double F[]);
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[],
        double d[], double a[], double F[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_history(c, given, tolerance, n, time, in, d, a, F);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_history(c, given, tolerance, n, time, in, d, a, F);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[],
        double storage[], double loss[]);
int mdr_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[], double storage[],
        double loss[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !omega) return mdrcontact_refuse_null("omega");
    if (n > 0 && !radius) return mdrcontact_refuse_null("radius");
    if (n > 0 && !storage) return mdrcontact_refuse_null("storage");
    if (n > 0 && !loss) return mdrcontact_refuse_null("loss");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_dynamic_stiffness(c, n, omega, radius, storage, loss);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_dynamic_stiffness(c, n, omega, radius, storage, loss);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[]);
int mdr_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_step_response(c, step, radius, n, time, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_step_response(c, step, radius, n, time, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
