/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profiles from area functions, tables, user functions and sums: refusals, then shapes whose answer is known. */
#include "check.h"

#include <time.h>

static const double pi = 3.14159265358979323846;

static void area_function_refuses(void)
{
    const double berkovich[2] = {24.5, 1e-6}, bad[2] = {24.5, NAN}, shrinking[1] = {-1.0};
    mdr_profile *p = NULL;

    CHECK_STATUS(mdr_profile_area_function(2, berkovich, 0.0, 1e-6, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_profile_area_function(2, NULL, 0.0, 1e-6, &p), MDR_ENULL, "coefficients is NULL");
    CHECK_STATUS(mdr_profile_area_function(-1, berkovich, 0.0, 1e-6, &p), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_profile_area_function(0, NULL, 0.0, 1e-6, &p), MDR_EINVALID, "coefficients: the array is empty");
    CHECK_STATUS(mdr_profile_area_function(2, bad, 0.0, 1e-6, &p), MDR_EINVALID, "entry 2 of coefficients");
    CHECK_STATUS(mdr_profile_area_function(2, berkovich, -1.0, 1e-6, &p), MDR_EINVALID, "min_height");
    CHECK_STATUS(mdr_profile_area_function(2, berkovich, NAN, 1e-6, &p), MDR_EINVALID, "min_height");
    CHECK_STATUS(mdr_profile_area_function(2, berkovich, 0.0, 0.0, &p), MDR_EINVALID, "max_height");
    CHECK_STATUS(mdr_profile_area_function(2, berkovich, 0.0, INFINITY, &p), MDR_EINVALID, "max_height");
    CHECK_STATUS(mdr_profile_area_function(2, berkovich, 1e-6, 1e-6, &p), MDR_EINVALID, "max_height");
    CHECK_STATUS(mdr_profile_area_function(1, shrinking, 0.0, 1e-6, &p), MDR_EINVALID, "does not increase");
    CHECK_TRUE(p == NULL);
}

static void table_refuses(int of, const char *x_name, const char *y_name)
{
    const double x[4] = {0.0, 1.0, 2.0, 3.0}, y[4] = {0.0, 0.1, 0.4, 0.9};
    const double repeated[4] = {0.0, 1.0, 1.0, 3.0}, not_a_number[4] = {0.0, NAN, 2.0, 3.0}, late[4] = {0.5, 1.0, 2.0, 3.0};
    const double falling[4] = {0.0, 0.4, 0.1, 0.9}, flat[4] = {0.0, 0.0, 0.0, 0.0}, infinite[4] = {0.0, 0.1, 0.4, INFINITY};
    char text[100];
    mdr_profile *p = NULL;

    CHECK_STATUS(mdr_profile_table(of, 4, x, y, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_profile_table(of, 4, NULL, y, &p), MDR_ENULL, "x is NULL");
    CHECK_STATUS(mdr_profile_table(of, 4, x, NULL, &p), MDR_ENULL, "y is NULL");
    CHECK_STATUS(mdr_profile_table(of, -4, x, y, &p), MDR_EINVALID, "n = -4");
    CHECK_STATUS(mdr_profile_table(of, 0, NULL, NULL, &p), MDR_EINVALID, "too short");
    CHECK_STATUS(mdr_profile_table(of, 1, x, y, &p), MDR_EINVALID, "too short");
    snprintf(text, sizeof text, "entry 3 of %s = 1: ", x_name);
    CHECK_STATUS(mdr_profile_table(of, 4, repeated, y, &p), MDR_EINVALID, text);
    snprintf(text, sizeof text, "entry 2 of %s = NaN", x_name);
    CHECK_STATUS(mdr_profile_table(of, 4, not_a_number, y, &p), MDR_EINVALID, text);
    snprintf(text, sizeof text, "entry 4 of %s = infinity", y_name);
    CHECK_STATUS(mdr_profile_table(of, 4, x, infinite, &p), MDR_EINVALID, text);
    CHECK_STATUS(mdr_profile_table(of, 4, late, y, &p), MDR_EINVALID, "must start at");
    snprintf(text, sizeof text, "entry 3 of %s = 0.1: ", y_name);
    CHECK_STATUS(mdr_profile_table(of, 4, x, falling, &p), MDR_EINVALID, text);
    CHECK_STATUS(mdr_profile_table(of, 4, x, flat, &p), MDR_EINVALID, "0 everywhere");
    CHECK_TRUE(p == NULL);
}

static int parabola(double r, double *f, void *radius)
{
    *f = r * r / (2.0 * *(double *)radius);
    return 0;
}

static int fails_beyond(double r, double *f, void *limit)
{
    if (r > *(double *)limit) return 42;
    *f = r;
    return 0;
}

static int gives_nan(double r, double *f, void *context)
{
    (void)context;
    *f = r > 0.25 ? NAN : r;
    return 0;
}

static int forgets_the_value(double r, double *f, void *context)
{
    (void)r, (void)f, (void)context;
    return 0;
}

static int starts_above(double r, double *f, void *context)
{
    (void)context;
    *f = 1.0 + r;
    return 0;
}

static int falls(double r, double *f, void *context)
{
    (void)context;
    *f = r * (1.5 - r);
    return 0;
}

static void callback_refuses(void)
{
    double number = 0.5;
    mdr_profile *p = NULL;

    CHECK_STATUS(mdr_profile_function(NULL, &number, 1.0, &p), MDR_ENULL, "height is NULL");
    CHECK_STATUS(mdr_profile_function(parabola, &number, 1.0, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_profile_function(parabola, &number, 0.0, &p), MDR_EINVALID, "largest_radius = 0");
    CHECK_STATUS(mdr_profile_function(parabola, &number, NAN, &p), MDR_EINVALID, "largest_radius = NaN");
    CHECK_STATUS(mdr_profile_function(fails_beyond, &number, 1.0, &p), MDR_ECALLBACK, "reported failure 42 at x = ");
    CHECK_STATUS(mdr_profile_function(gives_nan, NULL, 1.0, &p), MDR_ECALLBACK, "the function height returned NaN at x = ");
    CHECK_STATUS(mdr_profile_function(forgets_the_value, NULL, 1.0, &p), MDR_ECALLBACK, "returned NaN at x = ");
    CHECK_STATUS(mdr_profile_function(starts_above, NULL, 1.0, &p), MDR_EINVALID, "f(0) = 1");
    CHECK_STATUS(mdr_profile_function(falls, NULL, 1.0, &p), MDR_EINVALID, "decreases");
    CHECK_TRUE(p == NULL);
}

static void sum_refuses(void)
{
    mdr_profile *p = NULL, *term = NULL;
    mdr_medium *medium = NULL;

    CHECK_SUCCESS(mdr_profile_cone(0.1, &term));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &medium));
    const mdr_profile *good[1] = {term}, *hole[2] = {term, NULL}, *wrong[1] = {(const mdr_profile *)medium};
    CHECK_STATUS(mdr_profile_sum(1, good, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_profile_sum(1, NULL, &p), MDR_ENULL, "terms is NULL");
    CHECK_STATUS(mdr_profile_sum(-1, good, &p), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_profile_sum(0, NULL, &p), MDR_EINVALID, "terms: the array is empty");
    CHECK_STATUS(mdr_profile_sum(2, hole, &p), MDR_ENULL, "entry 2 of terms is NULL");
    CHECK_STATUS(mdr_profile_sum(1, wrong, &p), MDR_EINVALID, "entry 1 of terms: it is not a handle of type mdr_profile");
    CHECK_TRUE(p == NULL);
    CHECK_FREE(term);
    CHECK_FREE(medium);
}

/* Both functions and both slopes of two profiles at a few radii. Frees the first. */
static void same_profile(mdr_profile *p, const mdr_profile *expected, double largest, double tolerance)
{
    const double r[5] = {1e-3 * largest, 0.1 * largest, 0.35 * largest, 0.62 * largest, 0.98 * largest};
    double found[5], wanted[5];

    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 5, r, found));
    CHECK_SUCCESS(mdr_profile_values(expected, MDR_HEIGHT, 5, r, wanted));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], wanted[i], tolerance);
    CHECK_SUCCESS(mdr_profile_values(p, MDR_G, 5, r, found));
    CHECK_SUCCESS(mdr_profile_values(expected, MDR_G, 5, r, wanted));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], wanted[i], tolerance);
    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT_SLOPE, 5, r, found));
    CHECK_SUCCESS(mdr_profile_values(expected, MDR_HEIGHT_SLOPE, 5, r, wanted));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], wanted[i], 100 * tolerance);
    CHECK_SUCCESS(mdr_profile_values(p, MDR_G_SLOPE, 5, r, found));
    CHECK_SUCCESS(mdr_profile_values(expected, MDR_G_SLOPE, 5, r, wanted));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], wanted[i], 100 * tolerance);
    CHECK_FREE(p);
}

static void callback_is_the_parabola(void)
{
    double radius = 2.0;
    mdr_profile *p = NULL, *expected = NULL;

    CHECK_SUCCESS(mdr_profile_function(parabola, &radius, 1.0, &p));
    radius = NAN; /* called during creation only: what becomes of the context later does not matter */
    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &expected));
    same_profile(p, expected, 1.0, 1e-12);
    CHECK_FREE(expected);
}

static int hyperboloid(double r, double *f, void *b)
{
    *f = r * r / (sqrt(r * r + *(double *)b * *(double *)b) + *(double *)b);
    return 0;
}

/* sqrt(r^2 + b^2) - b has g = x arctan(x/b), however far beyond its tip it is given. */
static void callback_keeps_the_tip(void)
{
    double b = 1e-7, x, g;
    mdr_profile *p = NULL;

    for (double largest = b; largest < 2e4 * b; largest *= 10) {
        CHECK_SUCCESS(mdr_profile_function(hyperboloid, &b, largest, &p));
        for (x = 0.9 * largest; x > 1e-9 * b; x *= 0.3) {
            CHECK_SUCCESS(mdr_profile_values(p, MDR_G, 1, &x, &g));
            CHECK_CLOSE(g, x * atan(x / b), 1e-11);
        }
        CHECK_FREE(p);
    }
}

static int sphere_of_differences(double r, double *f, void *radius)
{
    const double R = *(double *)radius;
    *f = R - sqrt(R * R - r * r);
    return 0;
}

static void callback_says_what_is_lost(void)
{
    double radius = 1e-5;
    mdr_profile *p = NULL, *expected = NULL;

    CHECK_SUCCESS(mdr_profile_function(sphere_of_differences, &radius, 1e-6, &p));
    CHECK_SUCCESS(mdr_profile_sphere(radius, &expected));
    same_profile(p, expected, 1e-6, 1e-10);
    CHECK_FREE(expected);
    p = NULL;
    CHECK_STATUS(mdr_profile_function(sphere_of_differences, &radius, 1e-9, &p), MDR_ENOCONVERGENCE, "is inaccurate near the axis");
    CHECK_TRUE(p == NULL);
}

/* A(f) = C0 f^2 alone is a cone: pi r^2 = C0 f^2. */
static void area_function_is_the_cone(void)
{
    const double C0[1] = {24.5};
    const double largest = 1e-6 * sqrt(C0[0] / pi);
    mdr_profile *p = NULL, *expected = NULL;

    CHECK_SUCCESS(mdr_profile_area_function(1, C0, 0.0, 1e-6, &p));
    CHECK_SUCCESS(mdr_profile_cone(atan(sqrt(pi / C0[0])), &expected));
    same_profile(p, expected, largest, 1e-11);
    CHECK_FREE(expected);
}

/* Interpolation follows straight lines exactly: a table of a cone is the cone, g of a cone likewise. */
static void tables_are_the_cone(void)
{
    const double phi = 0.3;
    double r[9], f[9], g[9];
    mdr_profile *p = NULL, *expected = NULL;

    for (int i = 0; i < 9; i++) {
        r[i] = 0.125 * i;
        f[i] = r[i] * tan(phi);
        g[i] = 0.5 * pi * f[i];
    }
    CHECK_SUCCESS(mdr_profile_cone(phi, &expected));
    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 9, r, f, &p));
    same_profile(p, expected, 1.0, 1e-11);
    CHECK_SUCCESS(mdr_profile_table(MDR_G, 9, r, g, &p));
    same_profile(p, expected, 1.0, 1e-11);
    CHECK_FREE(expected);
}

static void sum_adds(void)
{
    const double x[2] = {0.2, 0.8};
    double height[2], mdr[2];
    mdr_profile *cone = NULL, *parabola_profile = NULL, *sum = NULL;

    CHECK_SUCCESS(mdr_profile_cone(0.2, &cone));
    CHECK_SUCCESS(mdr_profile_paraboloid(1.5, &parabola_profile));
    const mdr_profile *terms[3] = {cone, parabola_profile, cone};
    CHECK_SUCCESS(mdr_profile_sum(3, terms, &sum));
    CHECK_FREE(cone); /* the sum holds copies */
    CHECK_FREE(parabola_profile);
    CHECK_SUCCESS(mdr_profile_values(sum, MDR_HEIGHT, 2, x, height));
    CHECK_SUCCESS(mdr_profile_values(sum, MDR_G, 2, x, mdr));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(height[i], 2 * x[i] * tan(0.2) + x[i] * x[i] / 3.0, 1e-15);
        CHECK_CLOSE(mdr[i], pi * x[i] * tan(0.2) + x[i] * x[i] / 1.5, 1e-15);
    }
    CHECK_FREE(sum);
}

/* Seconds of the processor that a table of n points takes; what it costs must grow with n, not with its square. */
static double time_of_table(int n, int from_mdr)
{
    double *x = malloc(sizeof(double) * (size_t)n), *y = malloc(sizeof(double) * (size_t)n), found;
    mdr_profile *p = NULL;
    const double half = 0.5;

    for (int i = 0; i < n; i++) {
        x[i] = i / (n - 1.0);
        y[i] = x[i] * x[i];
    }
    const clock_t start = clock();
    if (from_mdr) {
        CHECK_SUCCESS(mdr_profile_table(MDR_G, n, x, y, &p));
    } else {
        CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, n, x, y, &p));
    }
    const double seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    /* r^2 <-> 2 x^2 */
    if (from_mdr) {
        CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 1, &half, &found));
        CHECK_CLOSE(found, 0.125, 1e-10);
    } else {
        CHECK_SUCCESS(mdr_profile_values(p, MDR_G, 1, &half, &found));
        CHECK_CLOSE(found, 0.5, 1e-10);
    }
    CHECK_FREE(p);
    free(x);
    free(y);
    return seconds;
}

static void test_long_tables(void)
{
    for (int from_mdr = 0; from_mdr <= 1; from_mdr++) {
        const double few = time_of_table(1001, from_mdr), many = time_of_table(8001, from_mdr);
        CHECK_TRUE(many < 24.0 * few + 0.1);
    }
}

/* Behind a knot, where f'' jumps, g' rises as the root of the distance: four times the distance, twice the rise. */
static void roots_start_at_knots(void)
{
    const double r[4] = {0.0, 1.0, 2.0, 3.0}, f[4] = {0.0, 0.1, 0.9, 1.3};
    mdr_profile *p = NULL;

    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 4, r, f, &p));
    for (int i = 1; i < 3; i++) {
        const double x[3] = {r[i], r[i] * (1.0 + 1e-7), r[i] * (1.0 + 4e-7)};
        double slope[3] = {0.0, 0.0, 0.0};
        CHECK_SUCCESS(mdr_profile_values(p, MDR_G_SLOPE, 3, x, slope));
        CHECK_CLOSE((slope[2] - slope[0]) / (slope[1] - slope[0]), 2.0, 0.02);
    }
    CHECK_FREE(p);
}

static int step(double r, double *f, void *height)
{
    *f = r > 0.0 ? *(double *)height : 0.0;
    return 0;
}

/* Where f is level its slope is 0 and not the rounding of samples: all along a step at the axis, and as a table comes level. */
static void level_places_have_no_negative_slope(void)
{
    const double r[4] = {0.0, 1.0, 2.0, 3.0}, f[4] = {0.0, 1.0, 1.0, 1.7};
    mdr_profile *p = NULL;

    for (int i = 0; i < 200; i++) {
        double height = 1e-4 * (1.0 + 0.037 * i), x = 1e-4, slope;
        CHECK_SUCCESS(mdr_profile_function(step, &height, x, &p));
        CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT_SLOPE, 1, &x, &slope));
        CHECK_TRUE(slope == 0.0);
        CHECK_FREE(p);
    }
    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 4, r, f, &p));
    for (int i = 0; i < 200; i++) {
        const double x = 1.0 - 0x1p-53 * i;
        double slope;
        CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT_SLOPE, 1, &x, &slope));
        CHECK_TRUE(slope >= 0.0);
        CHECK_TRUE(slope < 1e-12);
    }
    CHECK_FREE(p);
}

int main(void)
{
    level_places_have_no_negative_slope();
    roots_start_at_knots();
    area_function_refuses();
    table_refuses(MDR_HEIGHT, "r", "f");
    table_refuses(MDR_G, "x", "g");
    callback_refuses();
    sum_refuses();
    callback_is_the_parabola();
    callback_keeps_the_tip();
    callback_says_what_is_lost();
    area_function_is_the_cone();
    tables_are_the_cone();
    sum_adds();
    test_long_tables();
    return check_report("profile_data");
}
