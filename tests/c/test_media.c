/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Homogeneous and coated media: refusals, then moduli against the formulas they implement. */
#include "check.h"

#define SIZE(array) (sizeof(array) / sizeof *(array))

static const double bad_moduli[] = {0.0, -1.0, NAN, INFINITY};
static const double bad_poisson[] = {-1.0, -2.0, 0.5000001, NAN, INFINITY};

static void homogeneous_refuses(void)
{
    mdr_medium *m = NULL;
    CHECK_STATUS(mdr_medium_homogeneous(1.0, 0.3, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_contact_modulus(1.0, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_moduli); i++) {
        CHECK_STATUS(mdr_medium_homogeneous(bad_moduli[i], 0.3, &m), MDR_EINVALID, "E = ");
        CHECK_STATUS(mdr_medium_contact_modulus(bad_moduli[i], &m), MDR_EINVALID, "contact_modulus = ");
    }
    for (size_t i = 0; i < SIZE(bad_poisson); i++) {
        CHECK_STATUS(mdr_medium_homogeneous(1.0, bad_poisson[i], &m), MDR_EINVALID, "nu = ");
    }
    CHECK_TRUE(m == NULL);
}

static void coated_refuses(void)
{
    mdr_medium *m = NULL;
    mdr_medium_options options;

    mdr_medium_options_init(&options);
    CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_moduli); i++) {
        CHECK_STATUS(mdr_medium_coated(bad_moduli[i], 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "coating E = ");
        CHECK_STATUS(mdr_medium_coated(2.0, 0.3, bad_moduli[i], 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "thickness = ");
        CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, bad_moduli[i], 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate E = ");
    }
    for (size_t i = 0; i < SIZE(bad_poisson); i++) {
        CHECK_STATUS(mdr_medium_coated(2.0, bad_poisson[i], 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "coating nu = ");
        CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, bad_poisson[i], MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate nu = ");
        options.weight_nu_choice = MDR_WEIGHT_NU_GIVEN;
        options.weight_nu = bad_poisson[i];
        CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, &options, &m), MDR_EINVALID, "weight_nu = ");
    }
    options.weight_nu_choice = 17;
    CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, &options, &m), MDR_EINVALID, "weight_nu_choice");
    CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, 0.3, -1, NULL, &m), MDR_EINVALID, "model = -1");
    CHECK_STATUS(mdr_medium_coated(2.0, 0.3, 0.1, 1.0, 0.3, 1000, NULL, &m), MDR_EINVALID, "model = 1000");
    CHECK_TRUE(m == NULL);
}

typedef int (*evaluation)(const mdr_medium *, int, const double[], double[]);
static const evaluation evaluations[] = {mdr_medium_modulus, mdr_medium_stiffness};

static void evaluations_refuse(void)
{
    const double a[2] = {0.1, 0.2}, zero[2] = {0.1, 0.0}, negative[2] = {-0.1, 0.2}, not_a_number[2] = {0.1, NAN};
    const double infinite[1] = {INFINITY};
    double out[2];
    mdr_medium *m = NULL;
    mdr_profile *p = NULL;

    CHECK_SUCCESS(mdr_medium_homogeneous(1.0, 0.3, &m));
    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    fill_untouched(2, out);
    for (size_t i = 0; i < SIZE(evaluations); i++) {
        evaluation evaluate = evaluations[i];
        CHECK_STATUS(evaluate(NULL, 2, a, out), MDR_ENULL, "m is NULL");
        CHECK_STATUS(evaluate((const mdr_medium *)(void *)p, 2, a, out), MDR_EINVALID, "not an mdr_medium");
        CHECK_STATUS(evaluate(m, -1, a, out), MDR_EINVALID, "n = -1");
        CHECK_STATUS(evaluate(m, 2, NULL, out), MDR_ENULL, "a is NULL");
        CHECK_STATUS(evaluate(m, 2, a, NULL), MDR_ENULL, "out is NULL");
        CHECK_STATUS(evaluate(m, 2, zero, out), MDR_EINVALID, "entry 2 of a = 0");
        CHECK_STATUS(evaluate(m, 2, negative, out), MDR_EINVALID, "entry 1 of a = -0.1");
        CHECK_STATUS(evaluate(m, 2, not_a_number, out), MDR_EINVALID, "entry 2 of a = NaN");
        CHECK_STATUS(evaluate(m, 1, infinite, out), MDR_EINVALID, "entry 1 of a = infinity");
        CHECK_SUCCESS(evaluate(m, 0, NULL, NULL));
    }
    CHECK_UNTOUCHED(2, out);
    CHECK_SUCCESS(mdr_medium_free(NULL));
    CHECK_STATUS(mdr_medium_free((mdr_medium **)(void *)&p), MDR_EINVALID, "not an mdr_medium");
    CHECK_SUCCESS(mdr_profile_free(&p));
    CHECK_SUCCESS(mdr_medium_free(&m));
    CHECK_TRUE(m == NULL);
    CHECK_SUCCESS(mdr_medium_free(&m));
}

static void homogeneous_values(void)
{
    const double a[3] = {1e-9, 1.0, 1e6};
    double modulus[3], stiffness[3];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_medium_homogeneous(72.0, 0.17, &m));
    CHECK_SUCCESS(mdr_medium_modulus(m, 3, a, modulus));
    CHECK_SUCCESS(mdr_medium_stiffness(m, 3, a, stiffness));
    for (int i = 0; i < 3; i++) {
        CHECK_CLOSE(modulus[i], 72.0 / (1 - 0.17 * 0.17), 1e-15);
        CHECK_CLOSE(stiffness[i], 2 * a[i] * 72.0 / (1 - 0.17 * 0.17), 1e-15);
    }
    CHECK_SUCCESS(mdr_medium_free(&m));
    CHECK_SUCCESS(mdr_medium_contact_modulus(3.5, &m));
    CHECK_SUCCESS(mdr_medium_modulus(m, 3, a, modulus));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(modulus[i], 3.5, 0.0);
    CHECK_SUCCESS(mdr_medium_free(&m));
}

/* (12)-(15) written out from the weights of the same library's C interface, which have tests of their own. */
static double gao(double E0, double nu0, double h, double E1, double nu1, double a, double weight_nu, int in_series)
{
    const double xi = h / a, G0 = 0.5 * E0 / (1 + nu0), G1 = 0.5 * E1 / (1 + nu1);
    double i0, i1;
    CHECK_SUCCESS(mdr_weight_i0(1, &xi, weight_nu, &i0));
    CHECK_SUCCESS(mdr_weight_i1(1, &xi, weight_nu, &i1));
    const double nu = nu1 + (nu0 - nu1) * i1;
    const double G = in_series ? 1 / (1 / G1 + (1 / G0 - 1 / G1) * i0) : G1 + (G0 - G1) * i0;
    return 2 * G / (1 - nu);
}

static void gao_values(void)
{
    const double E0 = 72.0, nu0 = 0.17, h = 0.5, E1 = 165.0, nu1 = 0.22, a[3] = {0.05, 0.4, 6.0};
    mdr_medium_options options;

    mdr_medium_options_init(&options);
    for (int in_series = 0; in_series < 2; in_series++) {
        const int model = in_series ? MDR_MODEL_GAO_SERIES : MDR_MODEL_GAO;
        for (int choice = 0; choice < 4; choice++) {
            double found[3];
            mdr_medium *m = NULL;
            options.weight_nu_choice = choice;
            options.weight_nu = 0.4;
            CHECK_SUCCESS(mdr_medium_coated(E0, nu0, h, E1, nu1, model, &options, &m));
            CHECK_SUCCESS(mdr_medium_modulus(m, 3, a, found));
            for (int i = 0; i < 3; i++) {
                const double xi = h / a[i];
                double i1;
                CHECK_SUCCESS(mdr_weight_i1(1, &xi, 0.0, &i1));
                const double nus[4] = {nu0, nu1, nu1 + (nu0 - nu1) * i1, 0.4};
                CHECK_CLOSE(found[i], gao(E0, nu0, h, E1, nu1, a[i], nus[choice], in_series), 1e-14);
            }
            CHECK_SUCCESS(mdr_medium_free(&m));
        }
    }
}

/* NULL options are the defaults, and the default nu of I0 is the coating's. */
static void default_options(void)
{
    const double a[1] = {0.3};
    double found[1];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(mdr_medium_coated(2.0, 0.5, 0.2, 1.0, 0.2, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_medium_modulus(m, 1, a, found));
    CHECK_CLOSE(found[0], gao(2.0, 0.5, 0.2, 1.0, 0.2, a[0], 0.5, 0), 1e-14);
    CHECK_SUCCESS(mdr_medium_free(&m));
}

/* a -> 0 sees the coating, a -> infinity the substrate, at contrasts of 1e6 either way: off by about contrast (h/a) ln(a/h). */
static void limits(void)
{
    const double a[2] = {1e-20, 1e20}, contrasts[2] = {1e6, 1e-6};
    for (int i = 0; i < 2; i++) {
        double found[2];
        mdr_medium *m = NULL;
        CHECK_SUCCESS(mdr_medium_coated(contrasts[i], 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO_SERIES, NULL, &m));
        CHECK_SUCCESS(mdr_medium_modulus(m, 2, a, found));
        CHECK_CLOSE(found[0], contrasts[i] / 0.91, 1e-12);
        CHECK_CLOSE(found[1], 1 / 0.91, 1e-12);
        CHECK_SUCCESS(mdr_medium_free(&m));
    }
}

int main(void)
{
    homogeneous_refuses();
    coated_refuses();
    evaluations_refuse();
    homogeneous_values();
    gao_values();
    default_options();
    limits();
    return check_report("media");
}
