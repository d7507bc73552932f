/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Contacts and their states: refusals, then Hertz, Sneddon, Boussinesq's punch and the source's (24) and (27). */
#include "check.h"

#define SIZE(array) (sizeof(array) / sizeof *(array))

static const double pi = 3.14159265358979323846;

static const int givens[] = {MDR_DEPTH, MDR_FORCE, MDR_RADIUS};

static mdr_contact *new_contact(mdr_profile *p, mdr_medium *m)
{
    mdr_contact *c = NULL;
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_FREE(p); /* the contact holds copies */
    CHECK_FREE(m);
    return c;
}

static void creation_refuses(void)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;

    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    CHECK_STATUS(mdr_contact_new(NULL, m, NULL, &c), MDR_ENULL, "profile is NULL");
    CHECK_STATUS(mdr_contact_new(p, NULL, NULL, &c), MDR_ENULL, "medium is NULL");
    CHECK_STATUS(mdr_contact_new(p, m, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_contact_new((mdr_profile *)(void *)m, m, NULL, &c), MDR_EINVALID, "profile: it is not a handle of type");
    CHECK_STATUS(mdr_contact_new(p, (mdr_medium *)(void *)p, NULL, &c),
                 MDR_EINVALID, "medium: it is not a handle of type mdr_medium");
    options = MDR_SIZED(mdr_contact_options);
    options.zeta_count = -1;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "zeta_count = -1");
    double radius[3] = {0.1, 1.0, 10.0}, zeta[3] = {1.0, 1.1, 1.2};
    options.zeta_count = 3;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_ENULL, "zeta_radius is NULL");
    options.zeta_radius = radius;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_ENULL, "zeta is NULL");
    options.zeta = zeta;
    options.zeta_count = 2;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "too short");
    options.zeta_count = 3;
    zeta[2] = 0.0;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "entry 3 of zeta = 0");
    zeta[2] = NAN;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "entry 3 of zeta = NaN");
    zeta[2] = 1e-3;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "decreases");
    zeta[2] = 1.2;
    radius[0] = 0.0;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "entry 1 of zeta_radius = 0");
    radius[0] = 2.0;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "entry 2 of zeta_radius = 1");
    CHECK_TRUE(c == NULL);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(c);
    CHECK_FREE(p);
    CHECK_FREE(m);
}

static void states_refuse(void)
{
    const double good[2] = {0.1, 0.2}, negative[2] = {0.1, -0.2}, not_a_number[2] = {NAN, 0.1}, infinite[2] = {0.1, INFINITY};
    double d[2], a[2], F[2], k[2];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    mdr_contact *c = new_contact(p, m);
    fill_untouched(2, d), fill_untouched(2, a), fill_untouched(2, F), fill_untouched(2, k);
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    for (size_t i = 0; i < SIZE(givens); i++) {
        const int given = givens[i];
        CHECK_STATUS(columns_of(NULL, given, 2, good, d, a, F, k), MDR_ENULL, "c is NULL");
        CHECK_STATUS(columns_of((mdr_contact *)(void *)m, given, 2, good, d, a, F, k),
                     MDR_EINVALID, "not a handle of type mdr_contact");
        CHECK_STATUS(columns_of(c, given, -1, good, d, a, F, k), MDR_EINVALID, "n = -1");
        CHECK_STATUS(columns_of(c, given, 2, NULL, d, a, F, k), MDR_ENULL, "in is NULL");
        CHECK_STATUS(columns_of(c, given, 2, not_a_number, d, a, F, k), MDR_EINVALID, "entry 1 of ");
        CHECK_STATUS(columns_of(c, given, 2, infinite, d, a, F, k), MDR_EINVALID, "entry 2 of ");
        CHECK_STATUS(columns_of(c, given, 2, negative, d, a, F, k), i == 2 ? MDR_EINVALID : MDR_EUNREACHABLE, "entry 2");
        CHECK_SUCCESS(columns_of(c, given, 0, NULL, NULL, NULL, NULL, NULL));
        CHECK_SUCCESS(columns_of(c, given, 2, good, NULL, NULL, NULL, NULL));
    }
    CHECK_UNTOUCHED(2, d);
    CHECK_UNTOUCHED(2, a);
    CHECK_UNTOUCHED(2, F);
    CHECK_UNTOUCHED(2, k);
    CHECK_FREE(m);
    CHECK_FREE(c);
    CHECK_TRUE(c == NULL);
    CHECK_FREE(c);
}

static void ends_refuse(void)
{
    const double beyond[1] = {1.5}, wall[1] = {0.4}, inside[1] = {0.2}, deep[1] = {1e9};
    double a[1];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    fill_untouched(1, a);
    CHECK_SUCCESS(mdr_profile_sphere(1.0, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    mdr_contact *c = new_contact(p, m);
    CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, beyond, NULL, a, NULL, NULL), MDR_EDOMAIN, "radius = 1.5");
    CHECK_STATUS(columns_of(c, MDR_DEPTH, 1, deep, NULL, a, NULL, NULL), MDR_EUNREACHABLE, "depth = ");
    CHECK_STATUS(columns_of(c, MDR_FORCE, 1, deep, NULL, a, NULL, NULL), MDR_EUNREACHABLE, "force = ");
    CHECK_FREE(c);
    CHECK_SUCCESS(mdr_profile_flat_punch(0.4, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    c = new_contact(p, m);
    CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, inside, NULL, a, NULL, NULL), MDR_EUNREACHABLE, "radius = 0.2");
    CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, wall, NULL, a, NULL, NULL), MDR_EUNREACHABLE, "Give depth or force");
    CHECK_UNTOUCHED(1, a);
    CHECK_FREE(c);
}

/* The same states from radius, depth and force, against d, F and k known at a; frees the contact. */
static void compare(mdr_contact *c, int n, const double a[], const double d[], const double F[], const double k[], double tolerance)
{
    double found[4][8];
    const double *in[3] = {d, F, a};

    CHECK_TRUE(n <= 8);
    for (size_t i = 0; i < SIZE(givens); i++) {
        CHECK_SUCCESS(columns_of(c, givens[i], n, in[i], found[0], found[1], found[2], found[3]));
        for (int j = 0; j < n; j++) {
            CHECK_CLOSE(found[0][j], d[j], tolerance);
            CHECK_CLOSE(found[1][j], a[j], tolerance);
            CHECK_CLOSE(found[2][j], F[j], tolerance);
            CHECK_CLOSE(found[3][j], k[j], tolerance);
        }
    }
    CHECK_FREE(c);
}

static void hertz(void)
{
    const double E = 210e9, nu = 0.3, R = 5e-3, modulus = E / (1 - nu * nu);
    double a[5], d[5], F[5], k[5];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    for (int i = 0; i < 5; i++) {
        a[i] = R * pow(10.0, -8 + 2 * i);
        d[i] = a[i] * a[i] / R;
        F[i] = 4.0 / 3.0 * modulus * sqrt(R) * pow(d[i], 1.5);
        k[i] = 2 * modulus * a[i];
    }
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(new_homogeneous(E, nu, &m));
    compare(new_contact(p, m), 5, a, d, F, k, 1e-12);
}

static void sneddon(void)
{
    const double phi = 0.3439, modulus = 1.5;
    double a[4] = {1e-9, 1e-3, 1.0, 1e6}, d[4], F[4], k[4];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    for (int i = 0; i < 4; i++) {
        d[i] = 0.5 * pi * a[i] * tan(phi);
        F[i] = 2 * modulus * d[i] * d[i] / (pi * tan(phi));
        k[i] = 2 * modulus * a[i];
    }
    CHECK_SUCCESS(mdr_profile_cone(phi, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    compare(new_contact(p, m), 4, a, d, F, k, 1e-12);
}

static void flat_punch(void)
{
    const double b = 0.4, modulus = 2.5, depth[2] = {0.01, 3.0};
    double d[2], a[2], F[2], k[2];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_profile_flat_punch(b, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    mdr_contact *c = new_contact(p, m);
    CHECK_SUCCESS(columns_of(c, MDR_DEPTH, 2, depth, d, a, F, k));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(a[i], b, 1e-12);
        CHECK_CLOSE(F[i], 2 * b * modulus * depth[i], 1e-12);
        CHECK_CLOSE(k[i], 2 * b * modulus, 1e-12);
    }
    CHECK_SUCCESS(columns_of(c, MDR_FORCE, 2, F, d, a, NULL, NULL));
    for (int i = 0; i < 2; i++) CHECK_CLOSE(d[i], depth[i], 1e-12);
    CHECK_FREE(c);
}

/* (24) and (27), incompressible coating and substrate, with the corrected constants of the printed (24). */
static void coated_closed_forms(void)
{
    const double G0 = 5.0, G1 = 0.2, h = 1.7, R = 30.0, phi = 0.2, D = G0 - G1;
    const double a[6] = {1e-6, 1e-2, 0.5, 1.7, 20.0, 1e4};
    double d[6], F[6], k[6];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    for (int i = 0; i < 6; i++) {
        const double xi = h / a[i];
        const double i0 = 2 / pi * atan(xi) - xi / (pi * (1 + xi * xi));
        /* xi^3 ln(1 + xi^-2) - xi cancels for large xi: its series there */
        const double last = xi < 30 ? xi * xi * xi * log1p(1 / (xi * xi)) - xi
                                    : -1 / (2 * xi) + 1 / (3 * pow(xi, 3)) - 1 / (4 * pow(xi, 5)) + 1 / (5 * pow(xi, 7));
        d[i] = a[i] * a[i] / R;
        F[i] = 16 * pow(a[i], 3) / (3 * R) * (G1 + D / (2 * pi) * (4 * atan(xi) + last));
        k[i] = 2 * a[i] * 4 * (G1 + D * i0);
    }
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(new_coated(3 * G0, 0.5, h, 3 * G1, 0.5, MDR_MODEL_GAO, NULL, &m));
    compare(new_contact(p, m), 6, a, d, F, k, 1e-10);

    for (int i = 0; i < 6; i++) {
        d[i] = 0.5 * pi * a[i] * tan(phi);
        F[i] = 2 * pi * a[i] * a[i] * tan(phi) * (G1 + D * 2 / pi * atan(h / a[i]));
    }
    CHECK_SUCCESS(mdr_profile_cone(phi, &p));
    CHECK_SUCCESS(new_coated(3 * G0, 0.5, h, 3 * G1, 0.5, MDR_MODEL_GAO, NULL, &m));
    compare(new_contact(p, m), 6, a, d, F, k, 1e-10);
}

/* Zero depth is first touch: everything is zero. In and out may be the same array. */
static void first_touch_and_in_place(void)
{
    double values[3] = {0.0, 0.5, 2.0}, F[3];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    mdr_contact *c = new_contact(p, m);
    CHECK_SUCCESS(columns_of(c, MDR_DEPTH, 3, values, NULL, values, F, NULL));
    CHECK_CLOSE(values[0], 0.0, 0.0);
    CHECK_CLOSE(F[0], 0.0, 0.0);
    CHECK_CLOSE(values[1], 1.0, 1e-12);
    CHECK_CLOSE(values[2], 2.0, 1e-12);
    CHECK_CLOSE(F[2], 4.0 / 3.0 * sqrt(2.0) * pow(2.0, 1.5), 1e-12);
    CHECK_FREE(c);
}

/* A constant zeta multiplies d and F of (9) and leaves a and k. */
static void zeta_scales_the_depth(void)
{
    const double R = 2.0, modulus = 1.5, radius[3] = {1e-3, 1.0, 100.0}, zeta[3] = {1.25, 1.25, 1.25}, a[2] = {0.1, 3.0};
    double d[2], F[2], k[2];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    options.zeta_count = 3;
    options.zeta_radius = radius;
    options.zeta = zeta;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(new_coated(1.5, 0.0, 0.3, 1.5, 0.0, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 2, a, d, NULL, F, k));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(d[i], 1.25 * a[i] * a[i] / R, 1e-12);
        CHECK_CLOSE(F[i], 1.25 * 4.0 / 3.0 * modulus * pow(a[i], 3) / R, 1e-10);
        CHECK_CLOSE(k[i], 2 * modulus * a[i], 1e-12);
    }
    CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, (const double[]){101.0}, d, NULL, NULL, NULL), MDR_EDOMAIN, "up to 100");
    CHECK_FREE(c);
    CHECK_FREE(p);
    CHECK_FREE(m);
}

int main(void)
{
    zeta_scales_the_depth();
    creation_refuses();
    states_refuse();
    ends_refuse();
    hertz();
    sneddon();
    flat_punch();
    coated_closed_forms();
    first_touch_and_in_place();
    return check_report("contact");
}
