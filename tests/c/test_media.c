/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Homogeneous and coated media: refusals, then moduli against the formulas they implement. */
#include "check.h"

#define SIZE(array) (sizeof(array) / sizeof *(array))

static const double bad_moduli[] = {0.0, -1.0, NAN, INFINITY};
static const double bad_poisson[] = {-1.0, -2.0, 0.5000001, NAN, INFINITY};

static void homogeneous_refuses(void)
{
    mdr_medium *m = NULL;
    CHECK_STATUS(new_homogeneous(1.0, 0.3, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_contact_modulus(1.0, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_moduli); i++) {
        CHECK_STATUS(new_homogeneous(bad_moduli[i], 0.3, &m), MDR_EINVALID, "E = ");
        CHECK_STATUS(mdr_medium_contact_modulus(bad_moduli[i], &m), MDR_EINVALID, "contact_modulus = ");
    }
    for (size_t i = 0; i < SIZE(bad_poisson); i++) {
        CHECK_STATUS(new_homogeneous(1.0, bad_poisson[i], &m), MDR_EINVALID, "nu = ");
    }
    CHECK_TRUE(m == NULL);
}

static void coated_refuses(void)
{
    mdr_medium *m = NULL;
    mdr_medium_options options;

    options = MDR_SIZED(mdr_medium_options);
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, NULL), MDR_ENULL, "out is NULL");
    for (size_t i = 0; i < SIZE(bad_moduli); i++) {
        const double bad = bad_moduli[i];
        CHECK_STATUS(new_coated(bad, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "layer 1 E = ");
        CHECK_STATUS(new_coated(2.0, 0.3, bad, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "thickness = ");
        CHECK_STATUS(new_coated(2.0, 0.3, 0.1, bad, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate E = ");
    }
    for (size_t i = 0; i < SIZE(bad_poisson); i++) {
        const double bad = bad_poisson[i];
        CHECK_STATUS(new_coated(2.0, bad, 0.1, 1.0, 0.3, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "layer 1 nu = ");
        CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, bad, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "substrate nu = ");
        options.weight_nu_choice = MDR_WEIGHT_NU_GIVEN;
        options.weight_nu = bad;
        CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, &options, &m), MDR_EINVALID, "weight_nu = ");
    }
    options.weight_nu_choice = 17;
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_GAO, &options, &m), MDR_EINVALID, "weight_nu_choice");
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, -1, NULL, &m), MDR_EINVALID, "model = -1");
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, 1000, NULL, &m), MDR_EINVALID, "model = 1000");
    CHECK_TRUE(m == NULL);
}

static const int quantities[] = {MDR_MODULUS, MDR_STIFFNESS};

static void evaluations_refuse(void)
{
    const double a[2] = {0.1, 0.2}, zero[2] = {0.1, 0.0}, negative[2] = {-0.1, 0.2}, not_a_number[2] = {0.1, NAN};
    const double infinite[1] = {INFINITY};
    double out[2];
    mdr_medium *m = NULL;
    mdr_profile *p = NULL;

    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &m));
    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    fill_untouched(2, out);
    CHECK_STATUS(mdr_medium_values(m, 0, 2, a, out), MDR_EINVALID, "quantity = 0");
    for (size_t i = 0; i < SIZE(quantities); i++) {
        const int of = quantities[i];
        CHECK_STATUS(mdr_medium_values(NULL, of, 2, a, out), MDR_ENULL, "m is NULL");
        CHECK_STATUS(mdr_medium_values((const mdr_medium *)(void *)p, of, 2, a, out),
                     MDR_EINVALID, "not a handle of type mdr_medium");
        CHECK_STATUS(mdr_medium_values(m, of, -1, a, out), MDR_EINVALID, "n = -1");
        CHECK_STATUS(mdr_medium_values(m, of, 2, NULL, out), MDR_ENULL, "a is NULL");
        CHECK_STATUS(mdr_medium_values(m, of, 2, a, NULL), MDR_ENULL, "out is NULL");
        CHECK_STATUS(mdr_medium_values(m, of, 2, zero, out), MDR_EINVALID, "entry 2 of a = 0");
        CHECK_STATUS(mdr_medium_values(m, of, 2, negative, out), MDR_EINVALID, "entry 1 of a = -0.1");
        CHECK_STATUS(mdr_medium_values(m, of, 2, not_a_number, out), MDR_EINVALID, "entry 2 of a = NaN");
        CHECK_STATUS(mdr_medium_values(m, of, 1, infinite, out), MDR_EINVALID, "entry 1 of a = infinity");
        CHECK_SUCCESS(mdr_medium_values(m, of, 0, NULL, NULL));
    }
    CHECK_UNTOUCHED(2, out);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(p);
    CHECK_FREE(m);
    CHECK_TRUE(m == NULL);
    CHECK_FREE(m);
}

static void homogeneous_values(void)
{
    const double a[3] = {1e-9, 1.0, 1e6};
    double modulus[3], stiffness[3];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_homogeneous(72.0, 0.17, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, modulus));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_STIFFNESS, 3, a, stiffness));
    for (int i = 0; i < 3; i++) {
        CHECK_CLOSE(modulus[i], 72.0 / (1 - 0.17 * 0.17), 1e-15);
        CHECK_CLOSE(stiffness[i], 2 * a[i] * 72.0 / (1 - 0.17 * 0.17), 1e-15);
    }
    CHECK_FREE(m);
    CHECK_SUCCESS(mdr_medium_contact_modulus(3.5, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, modulus));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(modulus[i], 3.5, 0.0);
    CHECK_FREE(m);
}

/* (12)-(15) written out from the weights of the same library's C interface, which have tests of their own. */
static double gao(double E0, double nu0, double h, double E1, double nu1, double a, double weight_nu, int in_series)
{
    const double xi = h / a, G0 = 0.5 * E0 / (1 + nu0), G1 = 0.5 * E1 / (1 + nu1);
    double i0, i1;
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, weight_nu, 1, &xi, &i0));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I1, weight_nu, 1, &xi, &i1));
    const double nu = nu1 + (nu0 - nu1) * i1;
    const double G = in_series ? 1 / (1 / G1 + (1 / G0 - 1 / G1) * i0) : G1 + (G0 - G1) * i0;
    return 2 * G / (1 - nu);
}

static void gao_values(void)
{
    const double E0 = 72.0, nu0 = 0.17, h = 0.5, E1 = 165.0, nu1 = 0.22, a[3] = {0.05, 0.4, 6.0};
    mdr_medium_options options;

    options = MDR_SIZED(mdr_medium_options);
    for (int in_series = 0; in_series < 2; in_series++) {
        const int model = in_series ? MDR_MODEL_GAO_SERIES : MDR_MODEL_GAO;
        for (int choice = 0; choice < 4; choice++) {
            double found[3];
            mdr_medium *m = NULL;
            options.weight_nu_choice = MDR_WEIGHT_NU_SURFACE + choice;
            options.weight_nu = 0.4;
            CHECK_SUCCESS(new_coated(E0, nu0, h, E1, nu1, model, &options, &m));
            CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, found));
            for (int i = 0; i < 3; i++) {
                const double xi = h / a[i];
                double i1;
                CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I1, 0.0, 1, &xi, &i1));
                const double nus[4] = {nu0, nu1, nu1 + (nu0 - nu1) * i1, 0.4};
                CHECK_CLOSE(found[i], gao(E0, nu0, h, E1, nu1, a[i], nus[choice], in_series), 1e-14);
            }
            CHECK_FREE(m);
        }
    }
}

/* NULL options are the defaults, and the default nu of I0 is the coating's. */
static void default_options(void)
{
    const double a[1] = {0.3};
    double found[1];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_coated(2.0, 0.5, 0.2, 1.0, 0.2, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, found));
    CHECK_CLOSE(found[0], gao(2.0, 0.5, 0.2, 1.0, 0.2, a[0], 0.5, 0), 1e-14);
    CHECK_FREE(m);
}

/* a -> 0 sees the coating, a -> infinity the substrate, at contrasts of 1e6 either way: off by about contrast (h/a) ln(a/h). */
static void limits(void)
{
    const double a[2] = {1e-20, 1e20}, contrasts[2] = {1e6, 1e-6};
    for (int i = 0; i < 2; i++) {
        double found[2];
        mdr_medium *m = NULL;
        CHECK_SUCCESS(new_coated(contrasts[i], 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO_SERIES, NULL, &m));
        CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 2, a, found));
        CHECK_CLOSE(found[0], contrasts[i] / 0.91, 1e-12);
        CHECK_CLOSE(found[1], 1 / 0.91, 1e-12);
        CHECK_FREE(m);
    }
}

/* E_eff of the published models, written out once more; index 0 is the coating. */
static double published(int model, double x, double E0, double nu0, double E1, double nu1)
{
    const double pi = 3.14159265358979323846, xi = 1 / x;
    const double M0 = E0 / (1 - nu0 * nu0), M1 = E1 / (1 - nu1 * nu1), G0 = 0.5 * E0 / (1 + nu0), G1 = 0.5 * E1 / (1 + nu1);
    const double i1 = 2 / pi * atan(xi) + xi / pi * log1p(x * x);
    const double i0 = 2 / pi * atan(xi)
        + ((1 - 2 * nu0) * xi * log1p(x * x) - xi / (1 + xi * xi)) / (2 * pi * (1 - nu0));
    const double nu = nu1 + (nu0 - nu1) * i1;
    double e, L, x0;

    switch (model) {
    case MDR_MODEL_DOERNER_NIX:
        e = exp(-xi);
        return 1 / ((1 - nu0) / (2 * G0) * (1 - e) + (1 - nu1) / (2 * G1) * e);
    case MDR_MODEL_WAVE:
        e = exp(-pi * xi);
        return 2 / (1 - nu) * G0 * ((G0 + G1) - (G0 - G1) * e) / ((G0 + G1) + (G0 - G1) * e);
    case MDR_MODEL_MENCIK_EXPONENTIAL:
        return M1 + (M0 - M1) * exp(-x);
    case MDR_MODEL_MENCIK_RECIPROCAL:
        return 1 / (1 / M1 + (1 / M0 - 1 / M1) * exp(-x));
    case MDR_MODEL_BEC: /* h = 1, a = x */
        return 1 / (2 * x * (1 / ((pi * x * x + 2 * x) * M0) + 1 / (2 * (x + 2 / pi) * M1)));
    case MDR_MODEL_PERRIOT_BARTHEL:
        L = log10(M1 / M0);
        x0 = pow(10.0, -0.093 + 0.792 * L + 0.05 * L * L);
        return M0 + (M1 - M0) / (1 + pow(x0 / x, 1.27));
    case MDR_MODEL_HAY_CRAWFORD:
        return 2 / ((1 - nu1) * (1 - nu0) / (1 - (1 - i1) * nu0 - i1 * nu1)) / ((1 - i0) / (G1 + 0.0626 * i0 * G0) + i0 / G0);
    default:
        return NAN;
    }
}

static void published_models(void)
{
    const double h = 0.25, x[4] = {0.03, 0.5, 2.0, 40.0};
    const double a[4] = {0.03 * h, 0.5 * h, 2.0 * h, 40.0 * h};

    for (int model = MDR_MODEL_DOERNER_NIX; model <= MDR_MODEL_HAY_CRAWFORD; model++) {
        double found[4];
        mdr_medium *m = NULL;
        CHECK_SUCCESS(new_coated(400.0, 0.2, h, 70.0, 0.33, model, NULL, &m));
        CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 4, a, found));
        for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], published(model, x[i], 400.0, 0.2, 70.0, 0.33), 1e-13);
        CHECK_FREE(m);
    }
}

/* The options reach their models: alpha scales h/a (or a/h), wave_factor the exponent. */
static void options_of_published_models(void)
{
    const double h = 0.25, a[1] = {0.2};
    const double bad[4] = {-0.5, -1.0, NAN, INFINITY};
    const int with_alpha[3] = {MDR_MODEL_DOERNER_NIX, MDR_MODEL_MENCIK_EXPONENTIAL, MDR_MODEL_MENCIK_RECIPROCAL};
    double found[1];
    mdr_medium *m = NULL;
    mdr_medium_options options;

    for (int i = 0; i < 3; i++) {
        options = MDR_SIZED(mdr_medium_options);
        options.alpha = 0.7;
        const double x = with_alpha[i] == MDR_MODEL_DOERNER_NIX ? a[0] / (0.7 * h) : 0.7 * a[0] / h;
        CHECK_SUCCESS(new_coated(400.0, 0.2, h, 70.0, 0.33, with_alpha[i], &options, &m));
        CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, found));
        CHECK_CLOSE(found[0], published(with_alpha[i], x, 400.0, 0.2, 70.0, 0.33), 1e-13);
        CHECK_FREE(m);
        for (int j = 0; j < 4; j++) {
            options.alpha = bad[j];
            CHECK_STATUS(new_coated(400.0, 0.2, h, 70.0, 0.33, with_alpha[i], &options, &m), MDR_EINVALID, "alpha = ");
        }
    }
    options = MDR_SIZED(mdr_medium_options);
    options.wave_factor = 0.4;
    CHECK_SUCCESS(new_coated(3.0 * 5.0, 0.5, h, 3.0 * 2.0, 0.5, MDR_MODEL_WAVE, &options, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, found));
    const double e = exp(-2 * 0.4 * h / a[0]);
    CHECK_CLOSE(found[0], 4 * 5.0 * (7.0 - 3.0 * e) / (7.0 + 3.0 * e), 1e-13);
    CHECK_FREE(m);
    for (int j = 0; j < 4; j++) {
        options.wave_factor = bad[j];
        CHECK_STATUS(new_coated(2.0, 0.5, h, 1.0, 0.5, MDR_MODEL_WAVE, &options, &m), MDR_EINVALID, "wave_factor = ");
    }
    CHECK_TRUE(m == NULL);
}

/* An incompressible layer on a rigid base gives back the published force of a paraboloid. */
static void bottom_effect(void)
{
    const double E = 2.0, h = 0.5, R = 3.0, chi = 0.8;
    const double series[2][5] = {{1, 1.133, 1.283, 0.769, 0.0975}, {1, 1.133, 1.497, 1.469, 0.755}};
    const double depth[1] = {(chi * h) * (chi * h) / R};
    const double too_far[1] = {1.02 * h}, too_deep[1] = {1.04 * h * h / R}, too_much[1] = {100.0};
    const double hertz = 4.0 / 3.0 * E / 0.75 * sqrt(R) * pow(depth[0], 1.5);

    for (int i = 0; i < 2; i++) {
        const int model = i == 0 ? MDR_MODEL_DIMITRIADIS : MDR_MODEL_GARCIA;
        double F[1], expected = 0;
        mdr_profile *p = NULL;
        mdr_medium *m = NULL;
        mdr_contact *c = NULL;
        CHECK_STATUS(new_coated(E, 0.5, h, 1.0, 0.3, model, NULL, &m), MDR_EINVALID, "substrate E = 1:");
        CHECK_STATUS(new_coated(E, 0.5, h, NAN, 0.3, model, NULL, &m), MDR_EINVALID, "substrate E = NaN");
        CHECK_STATUS(new_coated(E, 0.5, h, -INFINITY, 0.3, model, NULL, &m), MDR_EINVALID, "substrate E = -infinity");
        CHECK_STATUS(new_coated(E, 0.4, h, INFINITY, 0.3, model, NULL, &m), MDR_EINVALID, "coating nu = 0.4");
        CHECK_STATUS(new_coated(E, 0.5, 0.0, INFINITY, 0.3, model, NULL, &m), MDR_EINVALID, "thickness = 0");
        CHECK_SUCCESS(new_coated(E, 0.5, h, INFINITY, 0.0, model, NULL, &m));
        CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
        CHECK_STATUS(mdr_contact_new(p, m, NULL, &c), MDR_EINVALID, "apply to a paraboloid or a sphere. For other indenters use");
        CHECK_FREE(p);
        CHECK_SUCCESS(mdr_profile_sphere(R, &p));
        CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
        CHECK_FREE(c);
        CHECK_FREE(p);
        CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
        CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
        CHECK_STATUS(mdr_medium_values(m, MDR_MODULUS, 1, too_far, F), MDR_EDOMAIN,
                     "defined up to 0.5. The models dimitriadis and garcia");
        CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, too_far, NULL, NULL, F, NULL), MDR_EDOMAIN,
                     "defined up to 0.5. The models dimitriadis and garcia are valid for a < h. For larger contacts use the");
        CHECK_STATUS(columns_of(c, MDR_DEPTH, 1, too_deep, NULL, NULL, F, NULL), MDR_EUNREACHABLE, "garcia are valid for a < h");
        CHECK_STATUS(columns_of(c, MDR_FORCE, 1, too_much, F, NULL, NULL, NULL), MDR_EUNREACHABLE, "garcia are valid for a < h");
        CHECK_SUCCESS(columns_of(c, MDR_DEPTH, 1, depth, NULL, NULL, F, NULL));
        for (int k = 4; k >= 0; k--) expected = expected * chi + series[i][k];
        CHECK_CLOSE(F[0], hertz * expected, 1e-10);
        CHECK_FREE(c);
        CHECK_FREE(m);
        CHECK_FREE(p);
    }
}

static void facts_of_models(void)
{
    mdr_model_facts facts = MDR_SIZED(mdr_model_facts);

    for (int i = MDR_MODEL_GAO_POWER; i >= MDR_MODEL_GAO; i--) {
        CHECK_SUCCESS(mdr_model_info(i, &facts));
        CHECK_TRUE(facts.spherical_only == (i == MDR_MODEL_DIMITRIADIS || i == MDR_MODEL_GARCIA));
        CHECK_TRUE(facts.largest_ratio == (facts.spherical_only ? 1.0 : INFINITY));
        CHECK_TRUE(facts.base == (facts.spherical_only ? MDR_BASE_RIGID : i == MDR_MODEL_EXACT ? MDR_BASE_ANY : MDR_BASE_ELASTIC));
    }
    CHECK_SUCCESS(mdr_model_info(MDR_MODEL_GAO_POWER, &facts));
    CHECK_TRUE(strcmp(facts.constant, "exponent") == 0 && strcmp(facts.option, "weight_nu") == 0);
    CHECK_TRUE(facts.takes_layers == 1 && facts.takes_graded == 1);
    CHECK_SUCCESS(mdr_model_info(MDR_MODEL_EXACT, &facts));
    CHECK_TRUE(strcmp(facts.constant, "") == 0 && strcmp(facts.option, "tolerance") == 0);
    CHECK_STATUS(mdr_model_info(-1, &facts), MDR_EINVALID, "model = -1");
    CHECK_STATUS(mdr_model_info(0, NULL), MDR_ENULL, "facts is NULL");
}

/* Two bodies: refusals, and 1/E* = 1/E1* + 1/E2*. Bodies may be freed before the pair. */
static void pairs(void)
{
    const double a = 0.7;
    double modulus = 0.0;
    mdr_medium *film = NULL, *ball = NULL, *rigid = NULL, *pair = NULL, *none = NULL;
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;

    CHECK_STATUS(rigid_medium(NULL), MDR_ENULL, "out is NULL");
    CHECK_SUCCESS(rigid_medium(&rigid));
    CHECK_SUCCESS(new_homogeneous(3.0, 0.0, &film));
    CHECK_SUCCESS(new_homogeneous(6.0, 0.0, &ball));
    CHECK_STATUS(mdr_medium_pair(NULL, ball, &none), MDR_ENULL, "lower is NULL");
    CHECK_STATUS(mdr_medium_pair(film, NULL, &none), MDR_ENULL, "upper is NULL");
    CHECK_STATUS(mdr_medium_pair(film, ball, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_pair(rigid, rigid, &none), MDR_EINVALID, "upper: ");
    CHECK_STATUS(mdr_medium_values(rigid, MDR_MODULUS, 1, &a, &modulus), MDR_EINVALID, "m: it is rigid");
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_STATUS(mdr_contact_new(p, rigid, NULL, &c), MDR_EINVALID, "medium: it is rigid");
    CHECK_SUCCESS(mdr_medium_pair(film, ball, &pair));
    CHECK_STATUS(mdr_medium_pair(pair, ball, &none), MDR_EINVALID, "lower: it is already a pair");
    CHECK_TRUE(none == NULL && c == NULL && modulus == 0.0);
    CHECK_FREE(film);
    CHECK_FREE(ball);
    CHECK_SUCCESS(mdr_medium_values(pair, MDR_MODULUS, 1, &a, &modulus));
    CHECK_CLOSE(modulus, 2.0, 1e-15);
    MDR_FREE(p);
    MDR_FREE(rigid);
    MDR_FREE(pair);
}

int main(void)
{
    pairs();
    facts_of_models();
    homogeneous_refuses();
    coated_refuses();
    published_models();
    options_of_published_models();
    bottom_effect();
    evaluations_refuse();
    homogeneous_values();
    gao_values();
    default_options();
    limits();
    return check_report("media");
}
