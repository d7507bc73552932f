/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/lateral.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/lateral.h"
#include "refuse.h"

int mdrcontact_entry_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[],
        const double shape_E[], const double shape_nu[], const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[], const double shape_E[],
        const double shape_nu[], const mdr_structure_options *options, mdr_structure **out)
{
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
    if (n < 0 || n > MDRCONTACT_MOST_ENTRIES) return mdrcontact_refuse_count("n", n);
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
