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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_yielding_new(double E, double nu, int n, const double strain[], const double yield_stress[],
        mdr_yielding **out);
int mdr_yielding_new(double E, double nu, int n, const double strain[], const double yield_stress[], mdr_yielding **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !strain) return mdrcontact_refuse_null("strain");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_yielding_new(E, nu, n, strain, yield_stress, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_yielding_new(E, nu, n, strain, yield_stress, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_yield_stress_from_hardness(double E, double nu, double hardness, double radius_ratio, double *yield_stress,
        double *error);
int mdr_yield_stress_from_hardness(double E, double nu, double hardness, double radius_ratio, double *yield_stress, double *error)
{
    if (!yield_stress) return mdrcontact_refuse_null("yield_stress");
    if (!error) return mdrcontact_refuse_null("error");
    if (arithmetic_is_set()) return mdrcontact_entry_yield_stress_from_hardness(E, nu, hardness, radius_ratio, yield_stress, error);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_yield_stress_from_hardness(E, nu, hardness, radius_ratio, yield_stress, error);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_new(const mdr_profile *profile, const mdr_yielding *metal, double largest_depth,
        const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_plastic_law_new(const mdr_profile *profile, const mdr_yielding *metal, double largest_depth,
        const mdr_plastic_law_options *options, mdr_plastic_law **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_new(profile, metal, largest_depth, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_new(profile, metal, largest_depth, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_from_points(int n, const double d[], const double F[], const double a[],
        const double residual_depth[], const double modulus[], const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_plastic_law_from_points(int n, const double d[], const double F[], const double a[], const double residual_depth[],
        const double modulus[], const mdr_plastic_law_options *options, mdr_plastic_law **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !d) return mdrcontact_refuse_null("d");
    if (n > 0 && !F) return mdrcontact_refuse_null("F");
    if (n > 0 && !a) return mdrcontact_refuse_null("a");
    if (n > 0 && !residual_depth) return mdrcontact_refuse_null("residual_depth");
    if (n > 0 && !modulus) return mdrcontact_refuse_null("modulus");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_from_points(n, d, F, a, residual_depth, modulus, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_from_points(n, d, F, a, residual_depth, modulus, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_with_radius(const mdr_plastic_law *law, double radius, mdr_plastic_law **out);
int mdr_plastic_law_with_radius(const mdr_plastic_law *law, double radius, mdr_plastic_law **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_with_radius(law, radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_with_radius(law, radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_about(const mdr_plastic_law *law, mdr_plastic_law_facts *facts);
int mdr_plastic_law_about(const mdr_plastic_law *law, mdr_plastic_law_facts *facts)
{
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_about(law, facts);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_about(law, facts);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_advance(const mdr_plastic_law *law, int n, const double d[], int is_trial, double memory[],
        double F[], double slope[], double a[]);
int mdr_plastic_law_advance(const mdr_plastic_law *law, int n, const double d[], int is_trial, double memory[], double F[],
        double slope[], double a[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !d) return mdrcontact_refuse_null("d");
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_advance(law, n, d, is_trial, memory, F, slope, a);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_advance(law, n, d, is_trial, memory, F, slope, a);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_energies(const mdr_plastic_law *law, int n, const double d[], const double memory[],
        double stored[], double dissipated[]);
int mdr_plastic_law_energies(const mdr_plastic_law *law, int n, const double d[], const double memory[], double stored[],
        double dissipated[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !d) return mdrcontact_refuse_null("d");
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (n > 0 && !stored) return mdrcontact_refuse_null("stored");
    if (n > 0 && !dissipated) return mdrcontact_refuse_null("dissipated");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_energies(law, n, d, memory, stored, dissipated);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_energies(law, n, d, memory, stored, dissipated);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_loading(const mdr_plastic_law *law, int n, const double d[], double F[], double a[],
        double residual[], double work[]);
int mdr_plastic_law_loading(const mdr_plastic_law *law, int n, const double d[], double F[], double a[], double residual[],
        double work[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !d) return mdrcontact_refuse_null("d");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_loading(law, n, d, F, a, residual, work);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_loading(law, n, d, F, a, residual, work);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_restitution(const mdr_plastic_law *law, double mass, int n, const double speed[], double e[]);
int mdr_plastic_law_restitution(const mdr_plastic_law *law, double mass, int n, const double speed[], double e[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !speed) return mdrcontact_refuse_null("speed");
    if (n > 0 && !e) return mdrcontact_refuse_null("e");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_restitution(law, mass, n, speed, e);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_restitution(law, mass, n, speed, e);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_buffer(const mdr_plastic_law *law, int size, double buffer[]);
int mdr_plastic_law_buffer(const mdr_plastic_law *law, int size, double buffer[])
{
    if (size > 0 && !buffer) return mdrcontact_refuse_null("buffer");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_buffer(law, size, buffer);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_buffer(law, size, buffer);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_overload_new(const mdr_contact *c, int n, const double yield_stress[], mdr_overload **out);
int mdr_overload_new(const mdr_contact *c, int n, const double yield_stress[], mdr_overload **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !yield_stress) return mdrcontact_refuse_null("yield_stress");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_overload_new(c, n, yield_stress, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_overload_new(c, n, yield_stress, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_overload_states(const mdr_overload *rule, int given, int n, const double value[], mdr_overload_state out[]);
int mdr_overload_states(const mdr_overload *rule, int given, int n, const double value[], mdr_overload_state out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !value) return mdrcontact_refuse_null("value");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_overload_states(rule, given, n, value, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_overload_states(rule, given, n, value, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_plastic_law_from_overload(const mdr_overload *rule, double largest_depth,
        const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_plastic_law_from_overload(const mdr_overload *rule, double largest_depth, const mdr_plastic_law_options *options,
        mdr_plastic_law **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_plastic_law_from_overload(rule, largest_depth, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_plastic_law_from_overload(rule, largest_depth, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_cap_new(const mdr_contact *c, double hardness, mdr_cap **out);
int mdr_cap_new(const mdr_contact *c, double hardness, mdr_cap **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_cap_new(c, hardness, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_cap_new(c, hardness, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_cap_states(const mdr_cap *cap, int given, int n, const double value[], mdr_cap_state out[]);
int mdr_cap_states(const mdr_cap *cap, int given, int n, const double value[], mdr_cap_state out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !value) return mdrcontact_refuse_null("value");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_cap_states(cap, given, n, value, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_cap_states(cap, given, n, value, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_cap_pressure(const mdr_cap *cap, double radius, int n, const double r[], double pressure[], double residual[]);
int mdr_cap_pressure(const mdr_cap *cap, double radius, int n, const double r[], double pressure[], double residual[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (arithmetic_is_set()) return mdrcontact_entry_cap_pressure(cap, radius, n, r, pressure, residual);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_cap_pressure(cap, radius, n, r, pressure, residual);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_truncated_hertz(double a, double largest, double hardness, int n, const double x[], double out[]);
int mdr_truncated_hertz(double a, double largest, double hardness, int n, const double x[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_truncated_hertz(a, largest, hardness, n, x, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_truncated_hertz(a, largest, hardness, n, x, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
