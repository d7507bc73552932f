/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/conduction.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/conduction.h"
#include "refuse.h"

int mdrcontact_entry_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[],
        int upper_base, double film, double sink, mdr_conduction **out);
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base,
        double film, double sink, mdr_conduction **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !lower) return mdrcontact_refuse_null("lower");
    if (m < 0 || m > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("m", m);
    if (m > 0 && !upper) return mdrcontact_refuse_null("upper");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_new(n, lower, lower_base, m, upper, upper_base, film, sink, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_new(n, lower, lower_base, m, upper, upper_base, film, sink, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[]);
int mdr_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !radius) return mdrcontact_refuse_null("radius");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_spot(p, n, radius, conductance, slope);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_spot(p, n, radius, conductance, slope);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance,
        mdr_conduction **out);
int mdr_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance, mdr_conduction **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_tabulate(p, smallest, largest, tolerance, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_tabulate(p, smallest, largest, tolerance, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, double time, int n,
        const double r[], const double z[], double out[]);
int mdr_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, double time, int n,
        const double r[], const double z[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_field(p, field, radius, body, below, time, n, r, z, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_field(p, field, radius, body, below, time, n, r, z, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_compliance(const mdr_conduction *p, int n, const double k[], const double omega[], double out[],
        double imaginary[]);
int mdr_conduction_compliance(const mdr_conduction *p, int n, const double k[], const double omega[], double out[],
        double imaginary[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_compliance(p, n, k, omega, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_compliance(p, n, k, omega, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[],
        double in_phase[], double ahead[]);
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[],
        double ahead[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !omega) return mdrcontact_refuse_null("omega");
    if (n > 0 && !in_phase) return mdrcontact_refuse_null("in_phase");
    if (n > 0 && !ahead) return mdrcontact_refuse_null("ahead");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_admittance(p, answer, radius, n, omega, in_phase, ahead);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_admittance(p, answer, radius, n, omega, in_phase, ahead);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[],
        const double given[], double out[]);
int mdr_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[], const double given[],
        double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_follow(p, answer, radius, n, time, given, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_follow(p, answer, radius, n, time, given, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa,
        double *out);
int mdr_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa, double *out)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_rough(p, c, state, kappa, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_rough(p, c, state, kappa, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_joint_resistance(const mdr_conduction *p, double roughness, double slope, double hardness,
        double gas, double jump, int n, const double pressure[], double out[]);
int mdr_conduction_joint_resistance(const mdr_conduction *p, double roughness, double slope, double hardness, double gas,
        double jump, int n, const double pressure[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !pressure) return mdrcontact_refuse_null("pressure");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_joint_resistance(p, roughness, slope, hardness, gas, jump, n,
        pressure, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_joint_resistance(p, roughness, slope, hardness, gas, jump, n, pressure, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_joint(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double roughness,
        double slope, double hardness, double gas, double jump, double *out);
int mdr_conduction_joint(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double roughness, double slope,
        double hardness, double gas, double jump, double *out)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_joint(p, c, state, roughness, slope, hardness, gas, jump, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_joint(p, c, state, roughness, slope, hardness, gas, jump, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[],
        double conductance[], double by_force[], double by_depth[]);
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[],
        double by_force[], double by_depth[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !states) return mdrcontact_refuse_null("states");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_along(p, c, n, states, conductance, by_force, by_depth);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_along(p, c, n, states, conductance, by_force, by_depth);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion,
        double strength, double speed, mdr_friction_heat out[]);
int mdr_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion, double strength,
        double speed, mdr_friction_heat out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !states) return mdrcontact_refuse_null("states");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_heat(p, c, n, states, motion, strength, speed, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_heat(p, c, n, states, motion, strength, speed, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion,
        double strength, int body, int below, int n, const double r[], const double z[], double out[]);
int mdr_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion, double strength,
        int body, int below, int n, const double r[], const double z[], double out[])
{
    if (!state) return mdrcontact_refuse_null("state");
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !z) return mdrcontact_refuse_null("z");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_heat_field(p, c, state, motion, strength, body, below, n, r, z,
        out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_heat_field(p, c, state, motion, strength, body, below, n, r, z, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
