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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_body_compliance(const mdr_body *body, int load, int n, const double k[], const double omega[], double out[],
        double imaginary[]);
int mdr_body_compliance(const mdr_body *body, int load, int n, const double k[], const double omega[], double out[],
        double imaginary[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !k) return mdrcontact_refuse_null("k");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_compliance(body, load, n, k, omega, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_compliance(body, load, n, k, omega, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_body_compliance_limits(const mdr_body *body, double omega, double out[3], double imaginary[3]);
int mdr_body_compliance_limits(const mdr_body *body, double omega, double out[3], double imaginary[3])
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_body_compliance_limits(body, omega, out, imaginary);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_body_compliance_limits(body, omega, out, imaginary);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_response_new(const mdr_body *body, double tolerance, mdr_response **out);
int mdr_response_new(const mdr_body *body, double tolerance, mdr_response **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_response_new(body, tolerance, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_response_new(body, tolerance, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_response_about(const mdr_response *response, double *tolerance, int *images);
int mdr_response_about(const mdr_response *response, double *tolerance, int *images)
{
    if (!tolerance) return mdrcontact_refuse_null("tolerance");
    if (arithmetic_is_set()) return mdrcontact_entry_response_about(response, tolerance, images);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_response_about(response, tolerance, images);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_response_point(const mdr_response *response, int n, const double r[], double out[]);
int mdr_response_point(const mdr_response *response, int n, const double r[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_response_point(response, n, r, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_response_point(response, n, r, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_response_rectangle(const mdr_response *response, double width, double height, int n, const double x[],
        const double y[], double out[]);
int mdr_response_rectangle(const mdr_response *response, double width, double height, int n, const double x[], const double y[],
        double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !x) return mdrcontact_refuse_null("x");
    if (n > 0 && !y) return mdrcontact_refuse_null("y");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_response_rectangle(response, width, height, n, x, y, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_response_rectangle(response, width, height, n, x, y, out);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !in) return mdrcontact_refuse_null("in");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_states(c, given, branch, n, in, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_states(c, given, branch, n, in, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_slope(const mdr_contact *c, int n, const mdr_state states[], double out[]);
int mdr_contact_slope(const mdr_contact *c, int n, const mdr_state states[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !states) return mdrcontact_refuse_null("states");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_slope(c, n, states, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_slope(c, n, states, out);
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

int mdrcontact_entry_contact_load(const mdr_contact *c, const mdr_state *state, mdr_load **out);
int mdr_contact_load(const mdr_contact *c, const mdr_state *state, mdr_load **out)
{
    if (!state) return mdrcontact_refuse_null("state");
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_contact_load(c, state, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_contact_load(c, state, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_energy(const mdr_load *load, double *lower, double *upper);
int mdr_load_energy(const mdr_load *load, double *lower, double *upper)
{
    if (arithmetic_is_set()) return mdrcontact_entry_load_energy(load, lower, upper);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_energy(load, lower, upper);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_field(const mdr_load *load, int field, int n, const double r[], double out[]);
int mdr_load_field(const mdr_load *load, int field, int n, const double r[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_load_field(load, field, n, r, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_field(load, field, n, r, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_lowest_pressure(const mdr_load *load, double *pressure, double *r);
int mdr_load_lowest_pressure(const mdr_load *load, double *pressure, double *r)
{
    if (arithmetic_is_set()) return mdrcontact_entry_load_lowest_pressure(load, pressure, r);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_lowest_pressure(load, pressure, r);
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

int mdrcontact_entry_load_interior(const mdr_load *load, int body, int side, double friction, int n, const double r[],
        const double z[], const double angle[], mdr_interior out[]);
int mdr_load_interior(const mdr_load *load, int body, int side, double friction, int n, const double r[], const double z[],
        const double angle[], mdr_interior out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !r) return mdrcontact_refuse_null("r");
    if (n > 0 && !z) return mdrcontact_refuse_null("z");
    if (n > 0 && !out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_load_interior(load, body, side, friction, n, r, z, angle, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_interior(load, body, side, friction, n, r, z, angle, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_interior_error(const mdr_load *load, int body, double *deviation);
int mdr_load_interior_error(const mdr_load *load, int body, double *deviation)
{
    if (!deviation) return mdrcontact_refuse_null("deviation");
    if (arithmetic_is_set()) return mdrcontact_entry_load_interior_error(load, body, deviation);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_interior_error(load, body, deviation);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_layer_energies(const mdr_load *load, int body, int capacity, double out[], int *count);
int mdr_load_layer_energies(const mdr_load *load, int body, int capacity, double out[], int *count)
{
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_load_layer_energies(load, body, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_layer_energies(load, body, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_load_critical(const mdr_load *load, int body, double friction, int capacity, mdr_maximum out[], int *count);
int mdr_load_critical(const mdr_load *load, int body, double friction, int capacity, mdr_maximum out[], int *count)
{
    if (capacity < 0) return mdrcontact_refuse_count("capacity", capacity);
    if (capacity > 0 && !out) return mdrcontact_refuse_null("out");
    if (!count) return mdrcontact_refuse_null("count");
    if (arithmetic_is_set()) return mdrcontact_entry_load_critical(load, body, friction, capacity, out, count);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_load_critical(load, body, friction, capacity, out, count);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
        const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count);
int mdr_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
        const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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

int mdrcontact_entry_shear_new(const mdr_friction *f, const mdr_load *load, int direction, mdr_shear **out);
int mdr_shear_new(const mdr_friction *f, const mdr_load *load, int direction, mdr_shear **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_shear_new(f, load, direction, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_shear_new(f, load, direction, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[]);
int mdr_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
    if (n > 0 && !normal) return mdrcontact_refuse_null("normal");
    if (n > 0 && !memory) return mdrcontact_refuse_null("memory");
    if (arithmetic_is_set()) return mdrcontact_entry_law_turn(law, n, normal, spin, memory);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_law_turn(law, n, normal, spin, memory);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}

int mdrcontact_entry_closed_form(int formula, int n, const double x[], const double constants[], double out[]);
int mdr_closed_form(int formula, int n, const double x[], const double constants[], double out[])
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
