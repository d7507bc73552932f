/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laterally heterogeneous structures: refusals, layers against the layered medium, points, lines, voxels, weights. */
#include "check.h"
#include "mdrcontact/lateral.h"

#include <float.h>
#include <limits.h>

static const double nan_free[3] = {0.1, 1.0, 10.0};
static const double zeros[3] = {0.0, 0.0, 0.0};

static int wavy(double x, double y, double z, double *E, double *nu, void *context)
{
    (void)y;
    *E = 3.0 * (1.0 + *(double *)context * cos(x) * exp(-z));
    *nu = 0.5;
    return 0;
}

static int failing(double x, double y, double z, double *E, double *nu, void *context)
{
    (void)x, (void)y, (void)z, (void)E, (void)nu, (void)context;
    return 7;
}

static void refusals(void)
{
    const int kind[1] = {MDR_SHAPE_BALL}, unknown[1] = {6}, size[3] = {1, 1, 1}, label[1] = {0}, wrong_label[1] = {1};
    const double good[7] = {0.0, 0.0, 1.0, 0.5}, bad[7] = {0.0, 0.0, 1.0, -0.5}, E[1] = {2.0}, nu[1] = {0.3}, wrong_nu[1] = {0.6};
    const double spacing[3] = {1.0, 1.0, 1.0}, flat[3] = {1.0, 1.0, 0.0}, negative[3] = {0.1, -1.0, 10.0};
    double out[3];
    mdr_structure *s = NULL;
    mdr_medium *m = NULL;
    mdr_structure_options options;

    fill_untouched(3, out);
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, bad, E, nu, NULL, &s), MDR_EINVALID, "radius = -0.5");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, unknown, good, E, nu, NULL, &s), MDR_EINVALID, "kind = 6");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, wrong_nu, NULL, &s), MDR_EINVALID, "shape 1 nu = 0.6");
    CHECK_STATUS(mdr_structure_shapes(-1.0, 0.3, 1, kind, good, E, nu, NULL, &s), MDR_EINVALID, "E = -1");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, -1, kind, good, E, nu, NULL, &s), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, NULL, good, E, nu, NULL, &s), MDR_ENULL, "kind is NULL");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, nu, NULL, NULL), MDR_ENULL, "out is NULL");
    options = MDR_SIZED(mdr_structure_options);
    options.tolerance = NAN;
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, nu, &options, &s), MDR_EINVALID, "tolerance = NaN");
    options = MDR_SIZED(mdr_structure_options);
    options.reference_nu = 0.7;
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, nu, &options, &s), MDR_EINVALID, "reference_nu = 0.7");
    CHECK_STATUS(mdr_structure_voxels(NULL, label, 1, E, nu, spacing, 1.0, 0.3, NULL, &s), MDR_ENULL, "size is NULL");
    CHECK_STATUS(mdr_structure_voxels((const int[3]){1, 0, 1}, label, 1, E, nu, spacing, 1.0, 0.3, NULL, &s), MDR_EINVALID,
                 "size: each entry must be at least 1");
    CHECK_STATUS(mdr_structure_voxels(size, wrong_label, 1, E, nu, spacing, 1.0, 0.3, NULL, &s), MDR_EINVALID,
                 "of labels = 1: it must be the index of a phase, from 0 to 0");
    CHECK_STATUS(mdr_structure_voxels(size, label, 0, E, nu, spacing, 1.0, 0.3, NULL, &s), MDR_EINVALID, "phases = 0");
    CHECK_STATUS(mdr_structure_voxels(size, label, 1, E, nu, flat, 1.0, 0.3, NULL, &s), MDR_EINVALID, "spacing 3 = 0");
    options = MDR_SIZED(mdr_structure_options);
    options.padded = 1;
    CHECK_STATUS(mdr_structure_voxels(size, label, 1, E, nu, spacing, 1.0, 0.3, &options, &s), MDR_EINVALID, "beside E = 0");
    options = MDR_SIZED(mdr_structure_options);
    options.images = 1000000000;
    CHECK_STATUS(mdr_structure_voxels(size, label, 1, E, nu, spacing, 1.0, 0.3, &options, &s), MDR_EINVALID,
                 "images = 1000000000: it must be from 1 to 100");
    options = MDR_SIZED(mdr_structure_options);
    options.exponent = 1.5;
    CHECK_STATUS(mdr_structure_voxels(size, label, 1, E, nu, spacing, 1.0, 0.3, &options, &s), MDR_EINVALID, "exponent = 1.5");
    CHECK_STATUS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, nu, &options, &s), MDR_EINVALID, "exponent = 1.5");
    CHECK_STATUS(mdr_structure_function(failing, NULL, 0.5, &options, &s), MDR_EINVALID, "exponent = 1.5");
    CHECK_STATUS(mdr_structure_function(NULL, NULL, 0.5, NULL, &s), MDR_ENULL, "field is NULL");
    CHECK_TRUE(s == NULL);

    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, 1, kind, good, E, nu, NULL, &s));
    CHECK_STATUS(mdr_structure_modulus(s, 3, zeros, zeros, negative, out), MDR_EINVALID, "a = -1");
    CHECK_STATUS(mdr_structure_modulus(s, 3, zeros, NULL, nan_free, out), MDR_ENULL, "y is NULL");
    CHECK_STATUS(mdr_structure_modulus(NULL, 3, zeros, zeros, nan_free, out), MDR_ENULL, "s is NULL");
    CHECK_STATUS(mdr_structure_medium(s, 0.0, 0.0, 1.0, 0.5, 10, &m), MDR_EINVALID, "largest_radius = 0.5");
    CHECK_STATUS(mdr_structure_medium(s, 0.0, 0.0, 0.5, 1.0, 2, &m), MDR_EINVALID, "points = 2");
    CHECK_STATUS(mdr_structure_medium(s, 0.0, 0.0, 0.5, 1.0, INT_MAX, &m), MDR_EINVALID, "it must be from 3 to 1000000");
    CHECK_STATUS(mdr_structure_medium(s, NAN, 0.0, 0.5, 1.0, 5, &m), MDR_EINVALID, "x = NaN");
    CHECK_TRUE(m == NULL);
    CHECK_SUCCESS(mdr_structure_modulus(s, 0, NULL, NULL, NULL, NULL));
    CHECK_UNTOUCHED(3, out);
    CHECK_FREE(s);
    CHECK_TRUE(s == NULL);
    CHECK_FREE(s);
    CHECK_SUCCESS(mdr_free(NULL));

    CHECK_SUCCESS(mdr_structure_function(failing, NULL, 0.5, NULL, &s));
    CHECK_STATUS(mdr_structure_modulus(s, 1, zeros, zeros, nan_free, out), MDR_ECALLBACK, "failure 7");
    CHECK_FREE(s);
}

/* A layer of shapes and one of voxels against the layered medium with Gao weights, at a point, and as the medium of an indenter. */
static void layers(int model, double exponent)
{
    const int kind[1] = {MDR_SHAPE_LAYER}, size[3] = {2, 2, 3}, labels[12] = {0};
    const double layer[7] = {0.0, 0.6}, E[1] = {5.0}, nu[1] = {0.3}, spacing[3] = {0.7, 0.4, 0.2};
    double expected[3], found[3];
    mdr_medium *reference = NULL, *lateral = NULL;
    mdr_structure *shapes = NULL, *voxels = NULL;
    mdr_medium_options mean;
    mdr_structure_options options;

    mean = MDR_SIZED(mdr_medium_options);
    options = MDR_SIZED(mdr_structure_options);
    mean.exponent = options.exponent = exponent;
    mean.exponent_is_given = options.exponent_is_given = 1;
    CHECK_SUCCESS(new_coated(5.0, 0.3, 0.6, 1.0, 0.3, model, &mean, &reference));
    CHECK_SUCCESS(mdr_medium_values(reference, MDR_MODULUS, 3, nan_free, expected));
    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, 1, kind, layer, E, nu, &options, &shapes));
    CHECK_SUCCESS(mdr_structure_voxels(size, labels, 1, E, nu, spacing, 1.0, 0.3, &options, &voxels));
    CHECK_SUCCESS(mdr_structure_modulus(shapes, 3, nan_free, zeros, nan_free, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-6);
    CHECK_SUCCESS(mdr_structure_modulus(voxels, 3, nan_free, zeros, nan_free, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-12);
    CHECK_SUCCESS(mdr_structure_medium(voxels, 0.2, 0.1, 1e-2, 1e2, 33, &lateral));
    CHECK_FREE(voxels);
    CHECK_SUCCESS(mdr_medium_values(lateral, MDR_MODULUS, 3, nan_free, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 2e-3);
    CHECK_FREE(lateral);
    CHECK_FREE(reference);
    CHECK_FREE(shapes);
}

/* Voxels in layers of two materials: labels run along x, then y, then from the surface down. */
static void order_of_voxels(void)
{
    const int kind[2] = {MDR_SHAPE_LAYER, MDR_SHAPE_LAYER}, size[3] = {1, 2, 2}, labels[4] = {0, 0, 1, 1};
    const double layer[14] = {0.0, 0.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.2, 0.4}, E[2] = {5.0, 2.0}, nu[2] = {0.3, 0.3};
    const double spacing[3] = {1.0, 1.0, 0.2};
    double expected[3], found[3];
    mdr_structure *shapes = NULL, *voxels = NULL;

    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, 2, kind, layer, E, nu, NULL, &shapes));
    CHECK_SUCCESS(mdr_structure_voxels(size, labels, 2, E, nu, spacing, 1.0, 0.3, NULL, &voxels));
    CHECK_SUCCESS(mdr_structure_modulus(shapes, 3, nan_free, zeros, nan_free, expected));
    CHECK_SUCCESS(mdr_structure_modulus(voxels, 3, nan_free, zeros, nan_free, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-5);
    CHECK_FREE(voxels);
    CHECK_FREE(shapes);
}

/* A line across a vertical interface: monotone, the mean in the middle, point symmetric. */
static void line(void)
{
    const int kind[1] = {MDR_SHAPE_HALF_SPACE};
    const double interface[7] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}, E[1] = {3.0}, nu[1] = {0.5};
    const double x[5] = {-2.0, -0.5, 0.0, 0.5, 2.0}, a[5] = {1.0, 1.0, 1.0, 1.0, 1.0}, y[5] = {0.0, 0.0, 0.0, 0.0, 0.0};
    double found[5];
    mdr_structure *s = NULL;

    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.5, 1, kind, interface, E, nu, NULL, &s));
    CHECK_SUCCESS(mdr_structure_modulus(s, 5, x, y, a, found));
    for (int i = 1; i < 5; i++) CHECK_TRUE(found[i] > found[i - 1]);
    CHECK_CLOSE(found[2], 2.0 / 0.75, 1e-6);
    CHECK_CLOSE(found[0] + found[4], 4.0 / 0.75, 1e-6);
    CHECK_CLOSE(found[1] + found[3], 4.0 / 0.75, 1e-6);
    CHECK_FREE(s);
}

static void callback_structure(void)
{
    double contrast = 0.5, a = 0.3, crest = 0.0, trough = 3.14159265358979323846, y = 4.0, high, low;
    mdr_structure *s = NULL;
    mdr_structure_options options;

    options = MDR_SIZED(mdr_structure_options);
    options.tolerance = 1e-4;
    CHECK_SUCCESS(mdr_structure_function(wavy, &contrast, 0.5, &options, &s));
    CHECK_SUCCESS(mdr_structure_modulus(s, 1, &crest, &y, &a, &high));
    CHECK_SUCCESS(mdr_structure_modulus(s, 1, &trough, &y, &a, &low));
    CHECK_CLOSE(high + low, 8.0, 2e-4);
    CHECK_TRUE(high > 4.4 && high < 6.0);
    CHECK_FREE(s);
    options.exponent = -1.0;
    CHECK_SUCCESS(mdr_structure_function(wavy, &contrast, 0.5, &options, &s));
    CHECK_SUCCESS(mdr_structure_modulus(s, 1, &crest, &y, &a, &low));
    CHECK_TRUE(low > 4.4 && low < high);
    CHECK_FREE(s);
}

static void weights(void)
{
    const double lines[3] = {-1e5, 0.25, 1e5}, falling[3] = {0.0, -1.0, 1.0}, rho[2] = {0.5, 3.0}, z[2] = {0.2, 0.1};
    const double depth = 0.4, top = 0.0;
    enum { FINE = 60 };
    double fine_lines[FINE + 1], fine[2][FINE * FINE];
    double shear[4], poisson[4], i0, i1, points[6 * 8 * 3], rule[6 * 8 * 2], total = 0.0;

    CHECK_SUCCESS(mdr_lateral_cells(0.3, 1.0, top, depth, 2, lines, 2, lines, shear, poisson));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, 1, &depth, &i0));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I1, 0.3, 1, &depth, &i1));
    CHECK_CLOSE(shear[0] + shear[1] + shear[2] + shear[3], i0, 1e-6);
    CHECK_CLOSE(poisson[0] + poisson[1] + poisson[2] + poisson[3], i1, 1e-6);
    CHECK_CLOSE(shear[1], shear[2], 1e-9);
    /* lines so close to the axis that their squares are no numbers */
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 2.5e302, 0.25, 0.26, 2, lines, 2, lines, shear, poisson));
    for (int i = 0; i < 4; i++) CHECK_TRUE(isfinite(shear[i]) && isfinite(poisson[i]));
    /* lines so far away that they are no numbers in contact radii */
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 0.34, 0.34, 0.68, 2, (const double[3]){1.0, 1e155, DBL_MAX}, 2,
                                    (const double[3]){-DBL_MAX, 1.0, 3.0}, shear, poisson));
    for (int i = 0; i < 4; i++) CHECK_TRUE(isfinite(shear[i]) && isfinite(poisson[i]));
    CHECK_TRUE(shear[2] > 0.0 && shear[1] == 0.0);
    /* four cells that meet beside the axis have a quarter each, as near as it is */
    for (int i = 1; i <= 323; i++) {
        const double near = pow(10.0, -i), square[3] = {-3.0, near, 3.0};
        CHECK_SUCCESS(mdr_lateral_cells(0.3, 1.0, 0.0, 0.4, 2, square, 2, square, shear, poisson));
        for (int k = 0; k < 4; k++) CHECK_CLOSE(shear[k], 0.0585467, 4.0 * near + 3e-6);
    }
    /* a cell of 17000 contact radii is the sum of small ones */
    fine_lines[0] = 0.3;
    for (int i = 1; i <= FINE; i++) fine_lines[i] = 1.2 * fine_lines[i - 1];
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 1.0, 0.0, 0.4, FINE, fine_lines, FINE, fine_lines, fine[0], fine[1]));
    for (int i = 0; i < FINE * FINE; i++) total += fine[0][i];
    fine_lines[1] = fine_lines[FINE];
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 1.0, 0.0, 0.4, 1, fine_lines, 1, fine_lines, shear, poisson));
    CHECK_CLOSE(shear[0], total, 1e-5);
    total = 0.0;
    /* and a slab so deep that products of its depths are none */
    CHECK_SUCCESS(mdr_lateral_cells(-0.7, 1e-156, 0.17, 0.18, 2, (const double[3]){0.1, 0.2, 0.3}, 2, (const double[3]){0.1, 0.2,
            0.3},
                                    shear, poisson));
    for (int i = 0; i < 4; i++) CHECK_TRUE(isfinite(shear[i]) && isfinite(poisson[i]));
    /* and a face as deep */
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 0.34, 0.0, DBL_MAX, 2, lines, 2, lines, shear, poisson));
    CHECK_CLOSE(shear[0] + shear[1] + shear[2] + shear[3], 1.0, 1e-5);
    CHECK_CLOSE(poisson[0] + poisson[1] + poisson[2] + poisson[3], 1.0, 1e-5);
    CHECK_STATUS(mdr_lateral_cells(0.3, 1.0, top, depth, 2, falling, 2, lines, shear, poisson),
                 MDR_EINVALID, "must be strictly ascending");
    CHECK_STATUS(mdr_lateral_cells(0.3, 1.0, top, depth, 2, lines, 2, (const double[3]){0.0, 0.5, 0.5}, shear, poisson),
                 MDR_EINVALID, "entry 3 of y = 0.5: y must be strictly ascending");
    CHECK_STATUS(mdr_lateral_cells(0.3, 1.0, depth, top, 2, lines, 2, lines, shear, poisson), MDR_EINVALID, "z_bottom = 0");
    CHECK_STATUS(mdr_lateral_cells(0.3, -1.0, top, depth, 2, lines, 2, lines, shear, poisson), MDR_EINVALID, "a = -1");
    CHECK_STATUS(mdr_lateral_cells(0.3, 1.0, top, depth, 0, lines, 2, lines, shear, poisson), MDR_EINVALID, "nx = 0");
    CHECK_STATUS(mdr_lateral_cells(0.3, 1.0, top, depth, INT_MAX, lines, 2, lines, shear, poisson), MDR_EINVALID,
                 "nx = 2147483647");
    CHECK_SUCCESS(mdr_lateral_density(2, rho, z, 0.5, shear, poisson));
    CHECK_TRUE(shear[0] > shear[1] && shear[1] > 0.0);
    CHECK_STATUS(mdr_lateral_density(2, falling, z, 0.5, shear, poisson), MDR_EINVALID, "rho");
    /* infinite at the edge, below all numbers where twice the depth is none */
    CHECK_SUCCESS(mdr_lateral_density(3, (const double[3]){1.0, 1.0, 0.0}, (const double[3]){0.0, 1e-320, 1e308}, -0.52, shear,
                                      poisson));
    CHECK_TRUE(isinf(shear[0]) && isinf(poisson[0]) && isinf(shear[1]) && isinf(poisson[1]));
    CHECK_TRUE(shear[2] == 0.0 && poisson[2] == 0.0);
    CHECK_SUCCESS(mdr_lateral_rule(2, 0.3, points, rule));
    for (int i = 0; i < 6 * 8; i++) total += rule[2 * i];
    CHECK_CLOSE(total, 1.0, 1e-14);
    CHECK_STATUS(mdr_lateral_rule(0, 0.3, points, rule), MDR_EINVALID, "order = 0");
}

int main(void)
{
    refusals();
    layers(MDR_MODEL_GAO, 1.0);
    layers(MDR_MODEL_GAO_SERIES, -1.0);
    layers(MDR_MODEL_GAO_POWER, -0.65);
    layers(MDR_MODEL_GAO_POWER, 0.0);
    order_of_voxels();
    line();
    callback_structure();
    weights();
    return check_report("lateral");
}
