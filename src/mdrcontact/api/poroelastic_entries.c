/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/poroelastic.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/poroelastic.h"
#include "refuse.h"

int mdrcontact_entry_poroelastic_new(double nu, int drainage, double ratio, double *deviation, mdr_poroelastic **out);
int mdr_poroelastic_new(double nu, int drainage, double ratio, double *deviation, mdr_poroelastic **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_new(nu, drainage, ratio, deviation, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_new(nu, drainage, ratio, deviation, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity,
        double radius, int n, const double time[], double out[]);
int mdr_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity, double radius, int n,
        const double time[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_response(p, answer, shear_modulus, diffusivity, radius, n, time,
        out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_response(p, answer, shear_modulus, diffusivity, radius, n, time, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_poroelastic_history(const mdr_poroelastic *p, int given, double shear_modulus, double diffusivity,
        double radius, int n, const double time[], const double in[], double out[]);
int mdr_poroelastic_history(const mdr_poroelastic *p, int given, double shear_modulus, double diffusivity, double radius, int n,
        const double time[], const double in[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_history(p, given, shear_modulus, diffusivity, radius, n, time, in,
        out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_history(p, given, shear_modulus, diffusivity, radius, n, time, in, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity,
        double radius, int n, const double omega[], double storage[], double loss[]);
int mdr_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity, double radius, int n,
        const double omega[], double storage[], double loss[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !omega) return mdrcontact_refuse_null("omega");
    if (n > 0 && !storage) return mdrcontact_refuse_null("storage");
    if (n > 0 && !loss) return mdrcontact_refuse_null("loss");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_dynamic_stiffness(p, shear_modulus, diffusivity, radius, n, omega,
        storage, loss);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_dynamic_stiffness(p, shear_modulus, diffusivity, radius, n, omega, storage,
        loss);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_poroelastic_pressure(const mdr_poroelastic *p, int kind, int is_flat, double shear_modulus, double diffusivity,
        double radius, double time, int n, const double r[], double out[]);
int mdr_poroelastic_pressure(const mdr_poroelastic *p, int kind, int is_flat, double shear_modulus, double diffusivity,
        double radius, double time, int n, const double r[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_pressure(p, kind, is_flat, shear_modulus, diffusivity, radius,
        time, n, r, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_pressure(p, kind, is_flat, shear_modulus, diffusivity, radius, time, n, r, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity,
        int n, const double k[], const double omega[], double out[], double imaginary[]);
int mdr_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity, int n,
        const double k[], const double omega[], double out[], double imaginary[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, n,
        k, omega, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, n, k, omega,
        out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
