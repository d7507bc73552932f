/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact.h"
#include "refuse.h"

int mdrcontact_entry_parameters(const void *object, int capacity, mdr_parameter out[], int *count);
int mdr_parameters(const void *object, int capacity, mdr_parameter out[], int *count)
{
    if (!object) return mdrcontact_refuse_null("object");
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_parameters(object, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_parameters(object, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_paraboloid(double radius, mdr_profile **out);
int mdr_profile_paraboloid(double radius, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_paraboloid(radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_paraboloid(radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_sphere(double radius, mdr_profile **out);
int mdr_profile_sphere(double radius, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_sphere(radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_sphere(radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_cone(double inclination, mdr_profile **out);
int mdr_profile_cone(double inclination, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_cone(inclination, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_cone(inclination, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_power(double exponent, double coefficient, mdr_profile **out);
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_power(exponent, coefficient, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_power(exponent, coefficient, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_flat_punch(double radius, mdr_profile **out);
int mdr_profile_flat_punch(double radius, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_flat_punch(radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_flat_punch(radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_flat_cone(end_radius, inclination, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_flat_cone(end_radius, inclination, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_flat_paraboloid(end_radius, radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_flat_paraboloid(end_radius, radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_rounded_cone(blend_radius, inclination, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_rounded_cone(blend_radius, inclination, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_area_function(int n, const double coefficients[], double min_height, double max_height,
        mdr_profile **out);
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !coefficients) return mdrcontact_refuse_null("coefficients");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_area_function(n, coefficients, min_height, max_height, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_area_function(n, coefficients, min_height, max_height, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_table(int quantity, int n, const double x[], const double y[], mdr_profile **out);
int mdr_profile_table(int quantity, int n, const double x[], const double y[], mdr_profile **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_table(quantity, n, x, y, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_table(quantity, n, x, y, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_function(mdr_function height, void *context, double largest_radius, mdr_profile **out);
int mdr_profile_function(mdr_function height, void *context, double largest_radius, mdr_profile **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_function(height, context, largest_radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_function(height, context, largest_radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_sum(n, terms, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_sum(n, terms, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_profile_values(const mdr_profile *p, int quantity, int n, const double x[], double out[]);
int mdr_profile_values(const mdr_profile *p, int quantity, int n, const double x[], double out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_profile_values(p, quantity, n, x, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_profile_values(p, quantity, n, x, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[],
        double viscosity, double nu, double bulk_modulus, mdr_material **out);
int mdr_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[], double viscosity,
        double nu, double bulk_modulus, mdr_material **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !moduli) return mdrcontact_refuse_null("moduli");
    if (n > 0 && !times) return mdrcontact_refuse_null("times");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_material_viscoelastic(relaxed_shear_modulus, n, moduli, times, viscosity, nu,
        bulk_modulus, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_material_viscoelastic(relaxed_shear_modulus, n, moduli, times, viscosity, nu, bulk_modulus,
        out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out);
int mdr_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_material_power_law(modulus, time, exponent, nu, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_material_power_law(modulus, time, exponent, nu, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_material_values(const mdr_material *m, int quantity, int n, const double x[], double out[],
        double imaginary[]);
int mdr_material_values(const mdr_material *m, int quantity, int n, const double x[], double out[], double imaginary[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_material_values(m, quantity, n, x, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_material_values(m, quantity, n, x, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_material_limit(const mdr_material *m, int limit, double *E, double *nu);
int mdr_material_limit(const mdr_material *m, int limit, double *E, double *nu)
{
    if (arithmetic_is_set()) return mdrcontact_entry_material_limit(m, limit, E, nu);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_material_limit(m, limit, E, nu);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, const mdr_surface *surface,
        mdr_body **out);
int mdr_body_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, const mdr_surface *surface, mdr_body **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_layered(n, layers, substrate, surface, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_layered(n, layers, substrate, surface, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_graded(int n, const double z[], const double E[], const double nu[], mdr_body **out);
int mdr_body_graded(int n, const double z[], const double E[], const double nu[], mdr_body **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !z) return mdrcontact_refuse_null("z");
    if (n > 0 && !E) return mdrcontact_refuse_null("E");
    if (n > 0 && !nu) return mdrcontact_refuse_null("nu");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_graded(n, z, E, nu, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_graded(n, z, E, nu, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_graded_function(mdr_function E, mdr_function nu, void *context, double depth, mdr_body **out);
int mdr_body_graded_function(mdr_function E, mdr_function nu, void *context, double depth, mdr_body **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_graded_function(E, nu, context, depth, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_graded_function(E, nu, context, depth, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_power_graded(double E0, double z0, double exponent, double nu, mdr_body **out);
int mdr_body_power_graded(double E0, double z0, double exponent, double nu, mdr_body **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_power_graded(E0, z0, exponent, nu, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_power_graded(E0, z0, exponent, nu, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_rigid(mdr_body **out);
int mdr_body_rigid(mdr_body **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_rigid(out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_rigid(out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_wrinkling(const mdr_body *body, int layer, double *stress, double *wavelength);
int mdr_body_wrinkling(const mdr_body *body, int layer, double *stress, double *wavelength)
{
    if (arithmetic_is_set()) return mdrcontact_entry_body_wrinkling(body, layer, stress, wavelength);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_wrinkling(body, layer, stress, wavelength);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_compliance(const mdr_body *body, int load, double omega, int n, const double k[], double out[],
        double imaginary[]);
int mdr_body_compliance(const mdr_body *body, int load, double omega, int n, const double k[], double out[], double imaginary[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_compliance(body, load, omega, n, k, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_compliance(body, load, omega, n, k, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_contact_modulus(double contact_modulus, mdr_medium **out);
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_contact_modulus(contact_modulus, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_contact_modulus(contact_modulus, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_new(const mdr_body *body, const mdr_medium_options *options, mdr_medium **out);
int mdr_medium_new(const mdr_body *body, const mdr_medium_options *options, mdr_medium **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_new(body, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_new(body, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_pair(const mdr_medium *lower, const mdr_medium *upper, mdr_medium **out);
int mdr_medium_pair(const mdr_medium *lower, const mdr_medium *upper, mdr_medium **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_pair(lower, upper, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_pair(lower, upper, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_table(int n, const double a[], const double moduli[], mdr_medium **out);
int mdr_medium_table(int n, const double a[], const double moduli[], mdr_medium **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !a) return mdrcontact_refuse_null("a");
    if (n > 0 && !moduli) return mdrcontact_refuse_null("moduli");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_table(n, a, moduli, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_table(n, a, moduli, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_function(mdr_function modulus, void *context, double smallest_radius, double largest_radius,
        mdr_medium **out);
int mdr_medium_function(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_function(modulus, context, smallest_radius, largest_radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_function(modulus, context, smallest_radius, largest_radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_medium_values(const mdr_medium *m, int quantity, int n, const double a[], double out[]);
int mdr_medium_values(const mdr_medium *m, int quantity, int n, const double a[], double out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !a) return mdrcontact_refuse_null("a");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_medium_values(m, quantity, n, a, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_medium_values(m, quantity, n, a, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_weight(int weight, double nu, int n, const double xi[], double out[]);
int mdr_weight(int weight, double nu, int n, const double xi[], double out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !xi) return mdrcontact_refuse_null("xi");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_weight(weight, nu, n, xi, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_weight(weight, nu, n, xi, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options,
        mdr_contact **out);
int mdr_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options, mdr_contact **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_new(profile, medium, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_new(profile, medium, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[]);
int mdr_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_states(c, given, branch, n, in, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_states(c, given, branch, n, in, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[],
        const double in[], double d[], double a[], double F[]);
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[],
        double d[], double a[], double F[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !time) return mdrcontact_refuse_null("time");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_step_response(c, step, radius, n, time, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_step_response(c, step, radius, n, time, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_energy(const mdr_contact *c, const mdr_state *state, double *lower, double *upper);
int mdr_contact_energy(const mdr_contact *c, const mdr_state *state, double *lower, double *upper)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_energy(c, state, lower, upper);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_energy(c, state, lower, upper);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_field(const mdr_contact *c, int field, const mdr_state *state, int n, const double r[], double out[]);
int mdr_contact_field(const mdr_contact *c, int field, const mdr_state *state, int n, const double r[], double out[])
{
    if (!state) return mdrcontact_refuse_null("state");
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_field(c, field, state, n, r, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_field(c, field, state, n, r, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_lowest_pressure(const mdr_contact *c, const mdr_state *state, double *pressure, double *r);
int mdr_contact_lowest_pressure(const mdr_contact *c, const mdr_state *state, double *pressure, double *r)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_lowest_pressure(c, state, pressure, r);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_lowest_pressure(c, state, pressure, r);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_warnings(const mdr_contact *c, const mdr_state *state, char *buffer, int length, int *warnings);
int mdr_contact_warnings(const mdr_contact *c, const mdr_state *state, char *buffer, int length, int *warnings)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_warnings(c, state, buffer, length, warnings);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_warnings(c, state, buffer, length, warnings);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_interior(const mdr_contact *c, int body, const mdr_state *state, int side, double friction, int n,
        const double r[], const double z[], const double angle[], mdr_interior out[]);
int mdr_contact_interior(const mdr_contact *c, int body, const mdr_state *state, int side, double friction, int n, const double r[],
        const double z[], const double angle[], mdr_interior out[])
{
    if (!state) return mdrcontact_refuse_null("state");
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !z) return mdrcontact_refuse_null("z");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_interior(c, body, state, side, friction, n, r, z, angle, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_interior(c, body, state, side, friction, n, r, z, angle, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_interior_error(const mdr_contact *c, int body, const mdr_state *state, double *deviation);
int mdr_contact_interior_error(const mdr_contact *c, int body, const mdr_state *state, double *deviation)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!deviation) return mdrcontact_refuse_null("deviation");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_interior_error(c, body, state, deviation);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_interior_error(c, body, state, deviation);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_layer_energies(const mdr_contact *c, int body, const mdr_state *state, int capacity, double out[],
        int *count);
int mdr_contact_layer_energies(const mdr_contact *c, int body, const mdr_state *state, int capacity, double out[], int *count)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_layer_energies(c, body, state, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_layer_energies(c, body, state, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_critical(const mdr_contact *c, int body, const mdr_state *state, double friction, int capacity,
        mdr_maximum out[], int *count);
int mdr_contact_critical(const mdr_contact *c, int body, const mdr_state *state, double friction, int capacity, mdr_maximum out[],
        int *count)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_critical(c, body, state, friction, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_critical(c, body, state, friction, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
        const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count);
int mdr_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
        const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !strengths) return mdrcontact_refuse_null("strengths");
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_first_failure(c, body, friction, largest_radius, n, strengths,
        capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_first_failure(c, body, friction, largest_radius, n, strengths, capacity, out,
        count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_pull_off(const mdr_contact *c, int control, int capacity, mdr_state out[], int *count);
int mdr_contact_pull_off(const mdr_contact *c, int control, int capacity, mdr_state out[], int *count)
{
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (arithmetic_is_set()) return mdrcontact_entry_contact_pull_off(c, control, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_pull_off(c, control, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness,
        mdr_loop **out);
int mdr_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness, mdr_loop **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_loop_new(c, control, largest, points, spring_stiffness, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_loop_new(c, control, largest, points, spring_stiffness, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_loop_about(const mdr_loop *l, mdr_loop_facts *facts);
int mdr_loop_about(const mdr_loop *l, mdr_loop_facts *facts)
{
    if (arithmetic_is_set()) return mdrcontact_entry_loop_about(l, facts);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_loop_about(l, facts);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out);
int mdr_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_friction_new(c, coefficient, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_friction_new(c, coefficient, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_new(const mdr_friction *f, const mdr_state *state, int direction, mdr_shear **out);
int mdr_shear_new(const mdr_friction *f, const mdr_state *state, int direction, mdr_shear **out)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_shear_new(f, state, direction, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_new(f, state, direction, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[]);
int mdr_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_shear_states(s, given, n, in, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_states(s, given, n, in, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_about(const mdr_shear *s, mdr_shear_facts *facts);
int mdr_shear_about(const mdr_shear *s, mdr_shear_facts *facts)
{
    if (arithmetic_is_set()) return mdrcontact_entry_shear_about(s, facts);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_about(s, facts);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_field(const mdr_shear *s, const mdr_shear_state *at, int field, int n, const double r[], double out[]);
int mdr_shear_field(const mdr_shear *s, const mdr_shear_state *at, int field, int n, const double r[], double out[])
{
    if (!at) return mdrcontact_refuse_null("at");
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_shear_field(s, at, field, n, r, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_field(s, at, field, n, r, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_loop(const mdr_shear *s, int given, double amplitude, int n, double shift[], double force[],
        double *dissipated);
int mdr_shear_loop(const mdr_shear *s, int given, double amplitude, int n, double shift[], double force[], double *dissipated)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !shift) return mdrcontact_refuse_null("shift");
    if (n > 0 && !force) return mdrcontact_refuse_null("force");
    if (!dissipated) return mdrcontact_refuse_null("dissipated");
    if (arithmetic_is_set()) return mdrcontact_entry_shear_loop(s, given, amplitude, n, shift, force, dissipated);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_loop(s, given, amplitude, n, shift, force, dissipated);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out);
int mdr_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_friction_history_new(f, largest_depth, rings, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_friction_history_new(f, largest_depth, rings, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out);
int mdr_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_friction_history_copy(h, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_friction_history_copy(h, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n,
        const double normal[], const double tangential[], mdr_state states[], mdr_shear_state out[]);
int mdr_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n, const double normal[],
        const double tangential[], mdr_state states[], mdr_shear_state out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !normal) return mdrcontact_refuse_null("normal");
    if (n > 0 && !tangential) return mdrcontact_refuse_null("tangential");
    if (n > 0 && !states) return mdrcontact_refuse_null("states");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_friction_history_advance(h, normal_given, tangential_given, n, normal,
        tangential, states, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_friction_history_advance(h, normal_given, tangential_given, n, normal, tangential, states,
        out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[],
        double body_coefficient, mdr_wear **out);
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient,
        mdr_wear **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !numbers) return mdrcontact_refuse_null("numbers");
    if (arithmetic_is_set()) return mdrcontact_entry_wear_history_restore(h, n, numbers);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_wear_history_restore(h, n, numbers);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity,
        double radius, int n, const double omega[], double storage[], double loss[]);
int mdr_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity, double radius, int n,
        const double omega[], double storage[], double loss[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
        double omega, int n, const double k[], double out[], double imaginary[]);
int mdr_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity, double omega,
        int n, const double k[], double out[], double imaginary[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity,
        omega, n, k, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_poroelastic_compliance(nu, drainage, thickness, shear_modulus, diffusivity, omega, n, k,
        out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[],
        int upper_base, double film, double sink, mdr_conduction **out);
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base,
        double film, double sink, mdr_conduction **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !lower) return mdrcontact_refuse_null("lower");
    if (m < 0) return mdrcontact_refuse_count("m", m);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_field(p, field, radius, body, below, time, n, r, z, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_field(p, field, radius, body, below, time, n, r, z, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_compliance(const mdr_conduction *p, double omega, int n, const double k[], double out[],
        double imaginary[]);
int mdr_conduction_compliance(const mdr_conduction *p, double omega, int n, const double k[], double out[], double imaginary[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_conduction_compliance(p, omega, n, k, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_conduction_compliance(p, omega, n, k, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[],
        double in_phase[], double ahead[]);
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[],
        double ahead[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[],
        double conductance[], double by_force[], double by_depth[]);
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[],
        double by_force[], double by_depth[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_law_new(const mdr_contact *contact, double largest_depth, const mdr_law_options *options, mdr_law **out);
int mdr_law_new(const mdr_contact *contact, double largest_depth, const mdr_law_options *options, mdr_law **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_law_new(contact, largest_depth, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_new(contact, largest_depth, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_with_radius(const mdr_law *law, double radius, mdr_law **out);
int mdr_law_with_radius(const mdr_law *law, double radius, mdr_law **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_law_with_radius(law, radius, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_with_radius(law, radius, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_about(const mdr_law *law, mdr_law_facts *facts);
int mdr_law_about(const mdr_law *law, mdr_law_facts *facts)
{
    if (arithmetic_is_set()) return mdrcontact_entry_law_about(law, facts);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_about(law, facts);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_buffer(const mdr_law *law, int size, double buffer[]);
int mdr_law_buffer(const mdr_law *law, int size, double buffer[])
{
    if (size > 0 && !buffer) return mdrcontact_refuse_null("buffer");
    if (arithmetic_is_set()) return mdrcontact_entry_law_buffer(law, size, buffer);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_buffer(law, size, buffer);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_save(const mdr_law *law, const char *path);
int mdr_law_save(const mdr_law *law, const char *path)
{
    if (!path) return mdrcontact_refuse_null("path");
    if (arithmetic_is_set()) return mdrcontact_entry_law_save(law, path);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_save(law, path);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_load(const char *path, mdr_law **out);
int mdr_law_load(const char *path, mdr_law **out)
{
    if (!path) return mdrcontact_refuse_null("path");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_law_load(path, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_load(path, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_write(const mdr_law *law, char *buffer, int length, int *full_length);
int mdr_law_write(const mdr_law *law, char *buffer, int length, int *full_length)
{
    if (!full_length) return mdrcontact_refuse_null("full_length");
    if (arithmetic_is_set()) return mdrcontact_entry_law_write(law, buffer, length, full_length);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_write(law, buffer, length, full_length);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_read(const char *buffer, int length, mdr_law **out);
int mdr_law_read(const char *buffer, int length, mdr_law **out)
{
    if (!buffer) return mdrcontact_refuse_null("buffer");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_law_read(buffer, length, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_read(buffer, length, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_advance(const mdr_law *law, int n, const double force[], const double shift[], int is_trial,
        double tangent[], double memory[], double T[]);
int mdr_law_advance(const mdr_law *law, int n, const double force[], const double shift[], int is_trial, double tangent[],
        double memory[], double T[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !force) return mdrcontact_refuse_null("force");
    if (n > 0 && !shift) return mdrcontact_refuse_null("shift");
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (n > 0 && !T) return mdrcontact_refuse_null("T");
    if (arithmetic_is_set()) return mdrcontact_entry_law_advance(law, n, force, shift, is_trial, tangent, memory, T);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_advance(law, n, force, shift, is_trial, tangent, memory, T);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_energies(const mdr_law *law, int n, const double memory[], double stored[], double dissipated[]);
int mdr_law_energies(const mdr_law *law, int n, const double memory[], double stored[], double dissipated[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (arithmetic_is_set()) return mdrcontact_entry_law_energies(law, n, memory, stored, dissipated);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_energies(law, n, memory, stored, dissipated);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_law_turn(const mdr_law *law, int n, const double normal[], const double spin[], double memory[]);
int mdr_law_turn(const mdr_law *law, int n, const double normal[], const double spin[], double memory[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !normal) return mdrcontact_refuse_null("normal");
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (arithmetic_is_set()) return mdrcontact_entry_law_turn(law, n, normal, spin, memory);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_turn(law, n, normal, spin, memory);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[],
        const double shape_E[], const double shape_nu[], const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[], const double shape_E[],
        const double shape_nu[], const mdr_structure_options *options, mdr_structure **out)
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !kind) return mdrcontact_refuse_null("kind");
    if (n > 0 && !parameters) return mdrcontact_refuse_null("parameters");
    if (n > 0 && !shape_E) return mdrcontact_refuse_null("shape_E");
    if (n > 0 && !shape_nu) return mdrcontact_refuse_null("shape_nu");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_structure_shapes(E, nu, n, kind, parameters, shape_E, shape_nu, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_structure_shapes(E, nu, n, kind, parameters, shape_E, shape_nu, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[],
        const double spacing[3], double below_E, double below_nu, const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[],
        const double spacing[3], double below_E, double below_nu, const mdr_structure_options *options, mdr_structure **out)
{
    if (!size) return mdrcontact_refuse_null("size");
    if (!labels) return mdrcontact_refuse_null("labels");
    if (phases > 0 && !E) return mdrcontact_refuse_null("E");
    if (phases > 0 && !nu) return mdrcontact_refuse_null("nu");
    if (!spacing) return mdrcontact_refuse_null("spacing");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_structure_voxels(size, labels, phases, E, nu, spacing, below_E, below_nu,
        options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_structure_voxels(size, labels, phases, E, nu, spacing, below_E, below_nu, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_structure_function(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options,
        mdr_structure **out);
int mdr_structure_function(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options,
        mdr_structure **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_structure_function(field, context, reference_nu, options, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_structure_function(field, context, reference_nu, options, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[],
        double out[]);
int mdr_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[], double out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (n > 0 && !a) return mdrcontact_refuse_null("a");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_structure_modulus(s, n, x, y, a, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_structure_modulus(s, n, x, y, a, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius,
        int points, mdr_medium **out);
int mdr_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius, int points,
        mdr_medium **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_structure_medium(s, x, y, smallest_radius, largest_radius, points, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_structure_medium(s, x, y, smallest_radius, largest_radius, points, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[]);
int mdr_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !rho) return mdrcontact_refuse_null("rho");
    if (n > 0 && !z) return mdrcontact_refuse_null("z");
    if (n > 0 && !shear) return mdrcontact_refuse_null("shear");
    if (n > 0 && !poisson) return mdrcontact_refuse_null("poisson");
    if (arithmetic_is_set()) return mdrcontact_entry_lateral_density(n, rho, z, nu, shear, poisson);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_lateral_density(n, rho, z, nu, shear, poisson);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny,
        const double y[], double shear[], double poisson[]);
int mdr_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny, const double y[],
        double shear[], double poisson[])
{
    if (nx > 0 && !x) return mdrcontact_refuse_null("x");
    if (ny > 0 && !y) return mdrcontact_refuse_null("y");
    if (ny > 0 && !shear) return mdrcontact_refuse_null("shear");
    if (ny > 0 && !poisson) return mdrcontact_refuse_null("poisson");
    if (arithmetic_is_set()) return mdrcontact_entry_lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_lateral_rule(int order, double nu, double points[], double weights[]);
int mdr_lateral_rule(int order, double nu, double points[], double weights[])
{
    if (!points) return mdrcontact_refuse_null("points");
    if (!weights) return mdrcontact_refuse_null("weights");
    if (arithmetic_is_set()) return mdrcontact_entry_lateral_rule(order, nu, points, weights);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_lateral_rule(order, nu, points, weights);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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
    if (n < 0) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_closed_form(int formula, int n, const double x[], const double constants[], double out[]);
int mdr_closed_form(int formula, int n, const double x[], const double constants[], double out[])
{
    if (n < 0) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (!constants) return mdrcontact_refuse_null("constants");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_closed_form(formula, n, x, constants, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_closed_form(formula, n, x, constants, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
