/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layered, graded, tabulated and user-defined media: refusals, then media whose modulus is known. */
#include "check.h"

static const double pi = 3.14159265358979323846;

static void layered_refuses(void)
{
    const double E[2] = {2.0, 3.0}, nu[2] = {0.3, 0.2}, h[2] = {0.1, 0.2};
    const double bad_E[2] = {2.0, -3.0}, bad_nu[2] = {0.3, 0.6}, bad_h[2] = {0.1, 0.0}, bad_first[2] = {NAN, 1.0};
    const mdr_layer base = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_medium *m = NULL;
    mdr_medium_options options;

    CHECK_STATUS(new_layered(2, E, nu, h, 1.0, 0.3, MDR_MODEL_GAO, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(medium_of_layers(2, NULL, &base, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "layers is NULL");
    CHECK_STATUS(new_layered(-2, E, nu, h, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "n = -2");
    CHECK_STATUS(medium_of_layers(0, NULL, NULL, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "a rigid base needs at least one layer");
    CHECK_STATUS(new_layered(2, bad_E, nu, h, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "layer 2 E = -3");
    CHECK_STATUS(new_layered(2, bad_first, nu, h, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "layer 1 E = NaN");
    CHECK_STATUS(new_layered(2, E, bad_nu, h, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "layer 2 nu = 0.6");
    CHECK_STATUS(new_layered(2, E, nu, bad_h, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "entry 2 of thickness = 0");
    CHECK_STATUS(new_layered(2, E, nu, h, 0.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate E = 0");
    CHECK_STATUS(new_layered(2, E, nu, h, 1.0, NAN, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate nu = NaN");
    CHECK_STATUS(new_layered(2, E, nu, h, 1.0, 0.3, MDR_MODEL_WAVE, NULL, &m), MDR_EINVALID, "model = wave");
    options = MDR_SIZED(mdr_medium_options);
    options.weight_nu_choice = -1;
    CHECK_STATUS(new_layered(2, E, nu, h, 1.0, 0.3, MDR_MODEL_GAO, &options, &m), MDR_EINVALID, "weight_nu_choice = -1");
    CHECK_TRUE(m == NULL);
}

static void graded_refuses(void)
{
    const double z[3] = {0.0, 1.0, 2.0}, E[3] = {2.0, 1.5, 1.0}, nu[3] = {0.3, 0.3, 0.3};
    const double late[3] = {0.1, 1.0, 2.0}, repeated[3] = {0.0, 1.0, 1.0}, bad_E[3] = {2.0, 0.0, 1.0}, bad_nu[3] = {0.3, 0.3, 0.7};
    mdr_medium *m = NULL;

    CHECK_STATUS(medium_of_grades(3, z, E, nu, MDR_MODEL_GAO, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(medium_of_grades(3, NULL, E, nu, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "z is NULL");
    CHECK_STATUS(medium_of_grades(3, z, NULL, nu, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "E is NULL");
    CHECK_STATUS(medium_of_grades(3, z, E, NULL, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "nu is NULL");
    CHECK_STATUS(medium_of_grades(-1, z, E, nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "n = -1");
    CHECK_STATUS(medium_of_grades(1, z, E, nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "too short");
    CHECK_STATUS(medium_of_grades(3, late, E, nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "entry 1 of z = 0.1");
    CHECK_STATUS(medium_of_grades(3, repeated, E, nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "entry 3 of z = 1");
    CHECK_STATUS(medium_of_grades(3, z, bad_E, nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "entry 2 of E = 0");
    CHECK_STATUS(medium_of_grades(3, z, E, bad_nu, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "entry 3 of nu = 0.7");
    CHECK_STATUS(medium_of_grades(3, z, E, nu, MDR_MODEL_BEC, NULL, &m), MDR_EINVALID, "model = bec");
    CHECK_TRUE(m == NULL);
}

static int constant(double x, double *y, void *value)
{
    (void)x;
    *y = *(double *)value;
    return 0;
}

static int fails(double x, double *y, void *context)
{
    (void)x, (void)y, (void)context;
    return 7;
}

static int gives_nan(double x, double *y, void *context)
{
    (void)x, (void)context;
    *y = NAN;
    return 0;
}

static int fails_at_the_surface(double z, double *y, void *context)
{
    (void)context;
    *y = 0.3;
    return z > 1e-12 ? 0 : 9;
}

static void callbacks_refuse(void)
{
    double number = 0.3, negative = -1.0;
    mdr_medium *m = NULL;

    CHECK_STATUS(medium_of_functions(constant, constant, &number, 1.0, MDR_MODEL_GAO, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(medium_of_functions(NULL, constant, &number, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "E is NULL");
    CHECK_STATUS(medium_of_functions(constant, NULL, &number, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_ENULL, "nu is NULL");
    CHECK_STATUS(medium_of_functions(constant, constant, &number, 0.0, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "depth = 0");
    CHECK_STATUS(medium_of_functions(constant, constant, &number, 1.0, 99, NULL, &m), MDR_EINVALID, "model = 99");
    CHECK_STATUS(medium_of_functions(fails, constant, &number, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_ECALLBACK,
                 "the function E reported failure 7 at x = ");
    CHECK_STATUS(medium_of_functions(constant, fails_at_the_surface, &number, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_ECALLBACK,
                 "the function nu reported failure 9 at x = ");
    CHECK_STATUS(medium_of_functions(constant, gives_nan, &number, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_ECALLBACK,
                 "the function nu returned NaN at x = ");
    CHECK_STATUS(medium_of_functions(constant, constant, &negative, 1.0, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "E at ");

    CHECK_STATUS(mdr_medium_function(constant, &number, 0.1, 1.0, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_function(NULL, &number, 0.1, 1.0, &m), MDR_ENULL, "modulus is NULL");
    CHECK_STATUS(mdr_medium_function(constant, &number, 0.0, 1.0, &m), MDR_EINVALID, "smallest_radius = 0");
    CHECK_STATUS(mdr_medium_function(constant, &number, 0.1, NAN, &m), MDR_EINVALID, "largest_radius = NaN");
    CHECK_STATUS(mdr_medium_function(constant, &number, 1.0, 0.5, &m), MDR_EINVALID, "largest_radius = 0.5");
    CHECK_STATUS(mdr_medium_function(fails, &number, 0.1, 1.0, &m), MDR_ECALLBACK, "reported failure 7 at x = ");
    CHECK_STATUS(mdr_medium_function(gives_nan, &number, 0.1, 1.0, &m), MDR_ECALLBACK, "returned NaN at x = ");
    CHECK_STATUS(mdr_medium_function(constant, &negative, 0.1, 1.0, &m), MDR_ECALLBACK, "-1");
    CHECK_TRUE(m == NULL);
}

static void table_and_power_refuse(void)
{
    const double a[3] = {0.1, 1.0, 10.0}, E[3] = {2.0, 1.5, 1.0};
    const double zero[3] = {0.0, 1.0, 10.0}, repeated[3] = {0.1, 0.1, 10.0}, bad_E[3] = {2.0, -1.0, 1.0};
    mdr_medium *m = NULL;

    CHECK_STATUS(mdr_medium_table(3, a, E, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_table(3, NULL, E, &m), MDR_ENULL, "a is NULL");
    CHECK_STATUS(mdr_medium_table(3, a, NULL, &m), MDR_ENULL, "moduli is NULL");
    CHECK_STATUS(mdr_medium_table(-3, a, E, &m), MDR_EINVALID, "n = -3");
    CHECK_STATUS(mdr_medium_table(2, a, E, &m), MDR_EINVALID, "too short");
    CHECK_STATUS(mdr_medium_table(3, zero, E, &m), MDR_EINVALID, "entry 1 of a = 0");
    CHECK_STATUS(mdr_medium_table(3, repeated, E, &m), MDR_EINVALID, "entry 2 of a = 0.1");
    CHECK_STATUS(mdr_medium_table(3, a, bad_E, &m), MDR_EINVALID, "entry 2 of moduli = -1");

    CHECK_STATUS(medium_of_power(1.0, 1.0, 0.5, 0.3, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(medium_of_power(0.0, 1.0, 0.5, 0.3, &m), MDR_EINVALID, "E0 = 0");
    CHECK_STATUS(medium_of_power(1.0, -1.0, 0.5, 0.3, &m), MDR_EINVALID, "z0 = -1");
    CHECK_STATUS(medium_of_power(1.0, 1.0, 1.0, 0.3, &m), MDR_EINVALID, "exponent = 1");
    CHECK_STATUS(medium_of_power(1.0, 1.0, -1.0, 0.3, &m), MDR_EINVALID, "exponent = -1");
    CHECK_STATUS(medium_of_power(1.0, 1.0, NAN, 0.3, &m), MDR_EINVALID, "exponent = NaN");
    CHECK_STATUS(medium_of_power(1.0, 1.0, 0.5, 0.6, &m), MDR_EINVALID, "nu = 0.6");
    CHECK_TRUE(m == NULL);
}

/* Bodies that have one solution take no other model; a body serves any number of media, and may be freed before them. */
static void bodies_become_media(void)
{
    const double a = 2.0;
    const mdr_layer film = mdr_isotropic(9.0, 0.3, 1.0), base = mdr_isotropic(1.0, 0.3, 0.0);
    double exact, gao;
    mdr_medium_options options = MDR_SIZED(mdr_medium_options);
    mdr_body *body = NULL;
    mdr_medium *m = NULL, *other = NULL;

    options.model = MDR_MODEL_GAO;
    CHECK_STATUS(mdr_medium_new(NULL, &options, &m), MDR_ENULL, "body is NULL");
    CHECK_SUCCESS(mdr_body_power_graded(1.0, 1.0, 0.5, 0.3, &body));
    CHECK_STATUS(mdr_medium_new(body, &options, &m), MDR_EINVALID, "model = gao: it is not available for rigid and");
    CHECK_STATUS(mdr_medium_new(body, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_FREE(body);
    CHECK_STATUS(mdr_body_rigid(NULL), MDR_ENULL, "out is NULL");
    CHECK_SUCCESS(mdr_body_rigid(&body));
    CHECK_STATUS(mdr_medium_new(body, &options, &m), MDR_EINVALID, "Use exact");
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    CHECK_STATUS(mdr_medium_new((const mdr_body *)(const void *)&film, NULL, &m),
                 MDR_EINVALID, "body: it is not a handle of type mdr_body");
    options.model = MDR_DEPTH;
    CHECK_STATUS(mdr_medium_new(body, &options, &m), MDR_EINVALID, "model = 101 (depth): it is not available");
    CHECK_TRUE(m == NULL);
    options.model = MDR_MODEL_GAO;
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &m));
    CHECK_SUCCESS(mdr_medium_new(body, &options, &other));
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, &a, &exact));
    CHECK_SUCCESS(mdr_medium_values(other, MDR_MODULUS, 1, &a, &gao));
    CHECK_TRUE(gao > 1.1 * exact);
    CHECK_FREE(other);
    CHECK_FREE(m);
}

/* The moduli of two media at radii from far below to far above 1; frees both. */
static void same_modulus(mdr_medium *m, mdr_medium *expected, double tolerance)
{
    const double a[5] = {0.02, 0.2, 0.7, 3.0, 30.0};
    double found[5], wanted[5];
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 5, a, found));
    CHECK_SUCCESS(mdr_medium_values(expected, MDR_MODULUS, 5, a, wanted));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], wanted[i], tolerance);
    CHECK_FREE(m);
    CHECK_FREE(expected);
}

static void layers(void)
{
    for (int model = MDR_MODEL_GAO; model <= MDR_MODEL_GAO_SERIES; model++) {
        const double one_E[1] = {4.0}, one_nu[1] = {0.2}, one_h[1] = {0.6};
        const double same_E[3] = {4.0, 4.0, 4.0}, same_nu[3] = {0.2, 0.2, 0.2}, parts[3] = {0.1, 0.2, 0.3};
        mdr_medium *m = NULL, *expected = NULL;
        CHECK_SUCCESS(new_layered(1, one_E, one_nu, one_h, 1.0, 0.35, model, NULL, &m));
        CHECK_SUCCESS(new_coated(4.0, 0.2, 0.6, 1.0, 0.35, model, NULL, &expected));
        same_modulus(m, expected, 1e-14);
        CHECK_SUCCESS(new_layered(3, same_E, same_nu, parts, 1.0, 0.35, model, NULL, &m));
        CHECK_SUCCESS(new_coated(4.0, 0.2, 0.6, 1.0, 0.35, model, NULL, &expected));
        same_modulus(m, expected, 1e-13);
        CHECK_SUCCESS(new_layered(3, same_E, same_nu, parts, 4.0, 0.2, model, NULL, &m));
        CHECK_SUCCESS(new_homogeneous(4.0, 0.2, &expected));
        same_modulus(m, expected, 1e-13);
    }
}

/* E(z) = 3 G, incompressible, G falling linearly from G0 to G1 over the depth H: with (17) the effective modulus is
 * 4 [G1 + (G0 - G1) (a/H) int_0^(H/a) I0(xi) dxi], the integral being
 * X (2/pi) atan X - (3/(2 pi)) ln(1 + X^2). */
static double linear_gradient(double a, double G0, double G1, double H)
{
    const double X = H / a;
    return 4 * (G1 + (G0 - G1) / X * (2 / pi * X * atan(X) - 1.5 / pi * log1p(X * X)));
}

static int falling_E(double z, double *E, void *context)
{
    (void)context;
    *E = 3 * (5.0 - 4.0 * z / 2.0);
    return 0;
}

static int half(double z, double *nu, void *context)
{
    (void)z, (void)context;
    *nu = 0.5;
    return 0;
}

static void gradients(void)
{
    const double z[2] = {0.0, 2.0}, E[2] = {15.0, 3.0}, nu[2] = {0.5, 0.5}, a[5] = {0.02, 0.2, 0.7, 3.0, 30.0};
    double found[5];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(medium_of_grades(2, z, E, nu, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 5, a, found));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], linear_gradient(a[i], 5.0, 1.0, 2.0), 1e-10);
    CHECK_FREE(m);
    CHECK_SUCCESS(medium_of_functions(falling_E, half, NULL, 2.0, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 5, a, found));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], linear_gradient(a[i], 5.0, 1.0, 2.0), 1e-10);
    CHECK_FREE(m);
}

/* A gradient of exponent 0 is homogeneous; a table of a power law of the radius, straight in ln a, is met at its points. */
static void power_and_table(void)
{
    const double a[4] = {0.1, 1.0, 5.0, 10.0}, E[4] = {1.0, 2.0, 2.5, 3.0};
    double found[4];
    mdr_medium *m = NULL, *expected = NULL;

    CHECK_SUCCESS(medium_of_power(4.0, 1.0, 0.0, 0.2, &m));
    CHECK_SUCCESS(new_homogeneous(4.0, 0.2, &expected));
    same_modulus(m, expected, 1e-13);
    CHECK_SUCCESS(mdr_medium_table(4, a, E, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 4, a, found));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], E[i], 1e-13);
    fill_untouched(4, found);
    CHECK_STATUS(mdr_medium_values(m, MDR_MODULUS, 1, (const double[]){11.0}, found), MDR_EDOMAIN, "up to 10");
    CHECK_UNTOUCHED(4, found);
    CHECK_FREE(m);
}

static int doerner_nix(double a, double *E, void *calls)
{
    ++*(int *)calls;
    *E = 1 / (1 - exp(-1 / a) + 0.25 * exp(-1 / a));
    return 0;
}

static void own_function(void)
{
    const double a[4] = {0.1, 0.9, 4.0, 30.0};
    double found[4];
    int calls = 0;
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_medium_function(doerner_nix, &calls, 0.05, 50.0, &m));
    CHECK_TRUE(calls > 0);
    const int calls_of_creation = calls;
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 4, a, found));
    CHECK_INT(calls, calls_of_creation);
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], 1 / (1 - 0.75 * exp(-1 / a[i])), 1e-11);
    CHECK_FREE(m);
}

int main(void)
{
    layered_refuses();
    graded_refuses();
    callbacks_refuse();
    table_and_power_refuse();
    bodies_become_media();
    layers();
    gradients();
    power_and_table();
    own_function();
    return check_report("media_data");
}
