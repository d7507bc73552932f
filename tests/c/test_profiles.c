/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Profiles with closed forms: refusals of every constructor and every evaluation, then the table of closed forms. */
#include "check.h"

static const double pi = 3.14159265358979323846;

typedef int (*one_number)(double, mdr_profile **);
typedef int (*two_numbers)(double, double, mdr_profile **);

static const double bad_lengths[] = {0.0, -1.0, NAN, INFINITY, -INFINITY};
static const double bad_inclinations[] = {0.0, -0.1, 1.5707963267948966, 2.0, NAN, INFINITY};

#define SIZE(array) (sizeof(array) / sizeof *(array))

static void refuses_length(one_number make, const char *name)
{
    mdr_profile *p = NULL;
    CHECK_STATUS(make(1.0, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_lengths); i++) CHECK_STATUS(make(bad_lengths[i], &p), MDR_EINVALID, name);
    CHECK_TRUE(p == NULL);
}

static void refuses_two(two_numbers make, const char *first, const char *second, int second_is_inclination)
{
    const double *bad = second_is_inclination ? bad_inclinations : bad_lengths;
    const size_t bad_count = second_is_inclination ? SIZE(bad_inclinations) : SIZE(bad_lengths);
    mdr_profile *p = NULL;
    CHECK_STATUS(make(0.5, 0.5, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_lengths); i++) CHECK_STATUS(make(bad_lengths[i], 0.5, &p), MDR_EINVALID, first);
    for (size_t i = 0; i < bad_count; i++) CHECK_STATUS(make(0.5, bad[i], &p), MDR_EINVALID, second);
    CHECK_TRUE(p == NULL);
}

static void constructors_refuse(void)
{
    mdr_profile *p = NULL;
    refuses_length(mdr_profile_paraboloid, "radius = ");
    refuses_length(mdr_profile_sphere, "radius = ");
    refuses_length(mdr_profile_flat_punch, "radius = ");
    CHECK_STATUS(mdr_profile_cone(0.3, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_inclinations); i++) {
        CHECK_STATUS(mdr_profile_cone(bad_inclinations[i], &p), MDR_EINVALID, "inclination = ");
    }
    CHECK_TRUE(p == NULL);
    refuses_two(mdr_profile_power, "exponent = ", "coefficient = ", 0);
    CHECK_STATUS(mdr_profile_power(101.0, 1.0, &p), MDR_EINVALID, "exponent = 101");
    refuses_two(mdr_profile_flat_cone, "end_radius = ", "inclination = ", 1);
    refuses_two(mdr_profile_flat_paraboloid, "end_radius = ", "radius = ", 0);
    refuses_two(mdr_profile_rounded_cone, "blend_radius = ", "inclination = ", 1);
}

static const int quantities[] = {MDR_HEIGHT, MDR_HEIGHT_SLOPE, MDR_G, MDR_G_SLOPE};

static void evaluations_refuse(void)
{
    const double r[2] = {0.1, 0.2}, negative[2] = {0.1, -0.2}, not_a_number[2] = {NAN, 0.2}, beyond[2] = {0.5, 1.5};
    const double infinite[1] = {INFINITY};
    double out[2];
    mdr_profile *p = NULL, *sphere = NULL;
    mdr_medium *medium = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(mdr_profile_sphere(1.0, &sphere));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &medium));
    fill_untouched(2, out);
    CHECK_STATUS(mdr_profile_values(p, 0, 2, r, out), MDR_EINVALID, "quantity = 0");
    for (size_t i = 0; i < SIZE(quantities); i++) {
        const int of = quantities[i];
        const char *name = i < 2 ? " of r" : " of x";
        CHECK_STATUS(mdr_profile_values(NULL, of, 2, r, out), MDR_ENULL, "p is NULL");
        CHECK_STATUS(mdr_profile_values((const mdr_profile *)medium, of, 2, r, out),
                     MDR_EINVALID, "not a handle of type mdr_profile");
        CHECK_STATUS(mdr_profile_values(p, of, -2, r, out), MDR_EINVALID, "n = -2");
        CHECK_STATUS(mdr_profile_values(p, of, 2, NULL, out), MDR_ENULL, "x is NULL");
        CHECK_STATUS(mdr_profile_values(p, of, 2, r, NULL), MDR_ENULL, "out is NULL");
        CHECK_STATUS(mdr_profile_values(p, of, 2, negative, out), MDR_EINVALID, name);
        CHECK_STATUS(mdr_profile_values(p, of, 2, not_a_number, out), MDR_EINVALID, name);
        CHECK_STATUS(mdr_profile_values(p, of, 1, infinite, out), MDR_EINVALID, name);
        CHECK_STATUS(mdr_profile_values(sphere, of, 2, beyond, out), MDR_EDOMAIN, "= 1.5: ");
        CHECK_SUCCESS(mdr_profile_values(p, of, 0, NULL, NULL));
    }
    CHECK_UNTOUCHED(2, out);
    CHECK_FREE(p);
    CHECK_FREE(sphere);
    CHECK_FREE(medium);
}

static void freeing(void)
{
    mdr_profile *p = NULL;
    mdr_medium *medium = NULL;
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &medium));
    long long none[8] = {0};
    CHECK_STATUS(mdr_free(none), MDR_EINVALID, "handle: it is not a handle");
    CHECK_TRUE(medium != NULL);
    CHECK_FREE(medium);
    CHECK_SUCCESS(mdr_profile_cone(0.2, &p));
    CHECK_FREE(p);
    CHECK_TRUE(p == NULL);
    CHECK_FREE(p);
}

/* f and g at one radius against the closed forms, their slopes against central differences; frees the profile. */
static void compare(mdr_profile *p, double x, double f, double g)
{
    const double step = 1e-4 * x;
    const double at[1] = {x}, around[4] = {x - 2 * step, x - step, x + step, x + 2 * step};
    double height[4], mdr[4], slope[1], mdr_slope[1];

    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 1, at, height));
    CHECK_SUCCESS(mdr_profile_values(p, MDR_G, 1, at, mdr));
    CHECK_CLOSE(height[0], f, 1e-12);
    CHECK_CLOSE(mdr[0], g, 1e-12);
    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT_SLOPE, 1, at, slope));
    CHECK_SUCCESS(mdr_profile_values(p, MDR_G_SLOPE, 1, at, mdr_slope));
    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 4, around, height));
    CHECK_SUCCESS(mdr_profile_values(p, MDR_G, 4, around, mdr));
    /* fourth order: 1e-16 of the step's powers, 1e-12 of rounding over the step */
    CHECK_CLOSE(slope[0], (height[0] - 8 * height[1] + 8 * height[2] - height[3]) / (12 * step), 1e-9);
    CHECK_CLOSE(mdr_slope[0], (mdr[0] - 8 * mdr[1] + 8 * mdr[2] - mdr[3]) / (12 * step), 1e-9);
    CHECK_FREE(p);
}

static void closed_forms(void)
{
    const double R = 1.3, b = 0.4, phi = 0.35, t = tan(phi), x = 0.7;
    mdr_profile *p = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    compare(p, x, x * x / (2 * R), x * x / R);
    CHECK_SUCCESS(mdr_profile_sphere(R, &p));
    compare(p, x, R - sqrt(R * R - x * x), 0.5 * x * log((R + x) / (R - x)));
    CHECK_SUCCESS(mdr_profile_cone(phi, &p));
    compare(p, x, x * t, 0.5 * pi * x * t);
    CHECK_SUCCESS(mdr_profile_power(3.5, 2.0, &p));
    compare(p, x, 2 * pow(x, 3.5), 2 * pow(x, 3.5) * 0.5 * sqrt(pi) * 3.5 * tgamma(1.75) / tgamma(2.25));
    CHECK_SUCCESS(mdr_profile_flat_cone(b, phi, &p));
    compare(p, x, (x - b) * t, x * t * acos(b / x));
    CHECK_SUCCESS(mdr_profile_flat_paraboloid(b, R, &p));
    compare(p, x, (x * x - b * b) / (2 * R), x / R * sqrt(x * x - b * b));
    CHECK_SUCCESS(mdr_profile_rounded_cone(b, phi, &p));
    compare(p, x, (x - 0.5 * b) * t, x * t / b * (x - (sqrt(x * x - b * b) - b * acos(b / x))));
    CHECK_SUCCESS(mdr_profile_rounded_cone(b, phi, &p));
    compare(p, 0.3, 0.3 * 0.3 * t / (2 * b), 0.3 * 0.3 * t / b);
}

static void flat_ends(void)
{
    const double r[3] = {0.0, 0.2, 0.4};
    double out[3];
    mdr_profile *p = NULL;

    CHECK_SUCCESS(mdr_profile_flat_punch(0.4, &p));
    for (size_t i = 0; i < SIZE(quantities); i++) {
        fill_untouched(3, out);
        CHECK_SUCCESS(mdr_profile_values(p, quantities[i], 3, r, out));
        for (int j = 0; j < 3; j++) CHECK_CLOSE(out[j], 0.0, 0.0);
    }
    CHECK_STATUS(mdr_profile_values(p, MDR_HEIGHT, 1, (const double[]){0.41}, out), MDR_EDOMAIN, "up to 0.4");
    CHECK_FREE(p);
}

int main(void)
{
    constructors_refuse();
    evaluations_refuse();
    freeing();
    closed_forms();
    flat_ends();
    return check_report("profiles");
}
