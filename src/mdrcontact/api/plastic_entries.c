/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/plastic.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/plastic.h"
#include "refuse.h"

int mdrcontact_entry_imprint_new(const mdr_medium *medium, double radius, double force, double residual_depth, double depth,
        mdr_imprint **out);
int mdr_imprint_new(const mdr_medium *medium, double radius, double force, double residual_depth, double depth, mdr_imprint **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_new(medium, radius, force, residual_depth, depth, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_new(medium, radius, force, residual_depth, depth, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth,
        mdr_imprint **out);
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_two_terms(medium, radius, uniform, hertz, depth, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_two_terms(medium, radius, uniform, hertz, depth, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_imprint_from_pressure(const mdr_medium *medium, int n, const double r[], const double p[], double depth,
        mdr_imprint **out);
int mdr_imprint_from_pressure(const mdr_medium *medium, int n, const double r[], const double p[], double depth, mdr_imprint **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !p) return mdrcontact_refuse_null("p");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_from_pressure(medium, n, r, p, depth, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_from_pressure(medium, n, r, p, depth, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_imprint_profile(const mdr_imprint *i, mdr_profile **out);
int mdr_imprint_profile(const mdr_imprint *i, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_profile(i, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_profile(i, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_imprint_about(const mdr_imprint *i, mdr_imprint_facts *facts);
int mdr_imprint_about(const mdr_imprint *i, mdr_imprint_facts *facts)
{
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_about(i, facts);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_about(i, facts);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_imprint_reverse_yield(const mdr_imprint *i, int n, const double yield_stress[], double *ratio, int *layer);
int mdr_imprint_reverse_yield(const mdr_imprint *i, int n, const double yield_stress[], double *ratio, int *layer)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !yield_stress) return mdrcontact_refuse_null("yield_stress");
    if (!ratio) return mdrcontact_refuse_null("ratio");
    if (!layer) return mdrcontact_refuse_null("layer");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_reverse_yield(i, n, yield_stress, ratio, layer);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_reverse_yield(i, n, yield_stress, ratio, layer);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
