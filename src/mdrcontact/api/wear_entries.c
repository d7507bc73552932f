/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/wear.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/wear.h"
#include "refuse.h"

int mdrcontact_entry_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[],
        double body_coefficient, mdr_wear **out);
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient,
        mdr_wear **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !coefficient) return mdrcontact_refuse_null("coefficient");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_new(c, n, coefficient, thickness, body_coefficient, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_new(c, n, coefficient, thickness, body_coefficient, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached,
        double *outer_radius, double *worn_volume, mdr_profile **out);
int mdr_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached,
        double *outer_radius, double *worn_volume, mdr_profile **out)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!reached) return mdrcontact_refuse_null("reached");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_limit(w, state, stick_radius, given, reached, outer_radius, worn_volume,
        out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_limit(w, state, stick_radius, given, reached, outer_radius, worn_volume, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[]);
int mdr_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[])
{
    if (!state) return mdrcontact_refuse_null("state");
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_track(w, state, passes, n, y, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_track(w, state, passes, n, y, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes);
int mdr_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!passes) return mdrcontact_refuse_null("passes");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_passes(w, state, depth, passes);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_passes(w, state, depth, passes);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_running_in(const mdr_wear *w, int given, double *length);
int mdr_wear_running_in(const mdr_wear *w, int given, double *length)
{
    if (!length) return mdrcontact_refuse_null("length");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_running_in(w, given, length);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_running_in(w, given, length);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options,
        mdr_wear_history **out);
int mdr_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options, mdr_wear_history **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_new(w, given, value, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_new(w, given, value, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out);
int mdr_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_copy(h, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_copy(h, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[],
        mdr_wear_state out[]);
int mdr_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[],
        mdr_wear_state out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !sliding) return mdrcontact_refuse_null("sliding");
    if (n > 0 && !value) return mdrcontact_refuse_null("value");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_advance(h, given, n, sliding, value, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_advance(h, given, n, sliding, value, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_state(const mdr_wear_history *h, int n, const double r[], mdr_wear_state *out, double pressure[]);
int mdr_wear_history_state(const mdr_wear_history *h, int n, const double r[], mdr_wear_state *out, double pressure[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !pressure) return mdrcontact_refuse_null("pressure");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_state(h, n, r, out, pressure);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_state(h, n, r, out, pressure);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_profile(const mdr_wear_history *h, mdr_profile **out);
int mdr_wear_history_profile(const mdr_wear_history *h, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_profile(h, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_profile(h, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count);
int mdr_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count)
{
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_save(h, capacity, numbers, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_save(h, capacity, numbers, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_history_restore(mdr_wear_history *h, int n, const double numbers[]);
int mdr_wear_history_restore(mdr_wear_history *h, int n, const double numbers[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !numbers) return mdrcontact_refuse_null("numbers");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_restore(h, n, numbers);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_restore(h, n, numbers);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
