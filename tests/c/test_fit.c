/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fits through the C API: noise-free data give the truth back, bad input is refused. */
#include "check.h"
#include "mdrcontact/fit.h"

enum { POINTS = 40, NUMBERS = 19 };

static mdr_profile *ball;
static mdr_medium *film, *half_space;

/* An indenter on a medium, a paraboloid on a film under the Gao model where they are NULL; numbers: R; E, nu, h, stress, springs;
   E, nu; the instrument's ten. */
static void fill(mdr_fit_problem *problem, mdr_fit_parameter parameters[NUMBERS], const mdr_profile *profile,
                 const mdr_medium *medium)
{
    *problem = MDR_SIZED(mdr_fit_problem);
    problem->data_kind = MDR_FIT_FORCE_DEPTH;
    problem->profile = profile == NULL ? ball : profile;
    problem->medium = medium == NULL ? film : medium;
    problem->parameters = parameters;
    CHECK_SUCCESS(mdr_fit_parameters(problem, NUMBERS, parameters, &problem->parameter_count));
}

static void truth_comes_back(void)
{
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
    double d[POINTS], F[POINTS], a[POINTS], radii[POINTS], expected[POINTS], values[NUMBERS], covariance[NUMBERS * NUMBERS],
           direction[NUMBERS];
    double fitted[POINTS], residuals[POINTS], lower, upper;
    int at_bound[NUMBERS];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    mdr_contact *contact = NULL;

    fill(&problem, parameters, NULL, NULL);
    CHECK_INT(problem.parameter_count, NUMBERS);
    for (int i = 0; i < POINTS; i++) d[i] = 2.5e-9 * (i + 1), F[i] = 0.0;
    CHECK_INT(mdr_fit_predict(&problem, POINTS, d, d, NULL, F, a), MDR_SUCCESS);
    CHECK_SUCCESS(mdr_fit_predict(&problem, 0, NULL, NULL, NULL, NULL, NULL));

    /* the same curve by way of a contact */
    CHECK_INT(mdr_contact_new(ball, film, NULL, &contact), MDR_SUCCESS);
    CHECK_INT(columns_of(contact, MDR_DEPTH, POINTS, d, NULL, radii, expected, NULL), MDR_SUCCESS);
    for (int i = 0; i < POINTS; i++) {
        CHECK_CLOSE(F[i], expected[i], 1e-9);
        CHECK_CLOSE(a[i], radii[i], 1e-9);
    }

    parameters[1].value = 100e9;
    parameters[1].is_free = 1;
    parameters[3].value = 300e-9;
    parameters[3].is_free = 1;
    CHECK_INT(mdr_fit_solve(&problem, POINTS, d, expected, NULL, NULL, values, covariance, NULL, at_bound, direction, fitted,
                            residuals, &summary), MDR_SUCCESS);
    CHECK_INT(summary.converged, 1);
    CHECK_CLOSE(values[1], 72e9, 1e-6);
    CHECK_CLOSE(values[3], 500e-9, 1e-6);
    CHECK_CLOSE(values[0], 10e-6, 0.0);
    CHECK_CLOSE(covariance[1 * NUMBERS + 3], covariance[3 * NUMBERS + 1], 1e-9);
    CHECK_TRUE(covariance[1 * NUMBERS + 1] > 0.0 && covariance[0] == 0.0);
    CHECK_INT(at_bound[1], 0);

    /* a thickness that is kept from its value lies at its bound; numbers that are given keep their standard error, 0, as it is */
    double widening[NUMBERS];
    parameters[3].upper = 400e-9;
    CHECK_INT(mdr_fit_solve(&problem, POINTS, d, expected, NULL, NULL, values, NULL, widening, at_bound, NULL, NULL, NULL, NULL),
              MDR_SUCCESS);
    CHECK_CLOSE(values[3], 400e-9, 1e-9);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_INT(at_bound[i], i == 3 ? 1 : 0);
        CHECK_TRUE(i == 1 || i == 3 ? widening[i] > 0.0 : widening[i] == 1.0);
    }
    parameters[3].upper = INFINITY;

    /* with a spread of 1 % the interval of E holds the truth and has a width of that order */
    for (int i = 0; i < POINTS; i++) residuals[i] = 0.01 * expected[i];
    CHECK_INT(mdr_fit_interval(&problem, POINTS, d, expected, NULL, residuals, 1, 0.95, &lower, &upper), MDR_SUCCESS);
    CHECK_TRUE(lower < 72e9 && 72e9 < upper);
    CHECK_TRUE(upper - lower > 0.2e9 && upper - lower < 20e9);

    CHECK_INT(mdr_free(contact), MDR_SUCCESS);
}

/* The list says what may be varied: as much of it as there is room for, in the objects' own units. */
static void parameters_are_listed(void)
{
    static const char *const names[NUMBERS] = { "indenter.radius", "layers[0].E", "layers[0].nu", "layers[0].thickness",
                                                "layers[0].prestress", "layers[0].interface.normal",
                                                "layers[0].interface.tangential", "substrate.E", "substrate.nu",
                                                "work_of_adhesion", "depth_offset", "force_offset", "frame_compliance",
                                                "indenter_modulus", "contact_depth_factor", "stiffness_factor",
                                                "contact_depth_scale", "area_factor", "cohesive_stress" };
    static const double values[NUMBERS] = { 10e-6, 72e9, 0.17, 500e-9, 0, INFINITY, INFINITY, 163e9, 0.22, 0, 0, 0, 0, INFINITY,
                                            0.75, 1, 1, 1, 0 };
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS], few[3];
    const mdr_fit_parameter *instrument = &parameters[NUMBERS - MDR_FIT_INSTRUMENT_COUNT];
    int count = 0;

    fill(&problem, parameters, NULL, NULL);
    for (int i = 0; i < NUMBERS; i++) {
        CHECK_TRUE(strcmp(parameters[i].name, names[i]) == 0);
        CHECK_TRUE(parameters[i].value == values[i] && parameters[i].is_free == 0 && parameters[i].prior_sd == 0.0);
        CHECK_TRUE(parameters[i].lower == -INFINITY && parameters[i].upper == INFINITY);
    }
    CHECK_TRUE(strcmp(instrument[MDR_FIT_INDENTER_MODULUS].name, "indenter_modulus") == 0);
    CHECK_TRUE(strcmp(instrument[MDR_FIT_COHESIVE_STRESS].name, "cohesive_stress") == 0);
    memset(few, 7, sizeof few);
    CHECK_SUCCESS(mdr_fit_parameters(&problem, 2, few, &count));
    CHECK_INT(count, NUMBERS);
    CHECK_TRUE(few[1].value == 72e9 && ((unsigned char *)&few[2])[0] == 7);
    count = 7;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, 0, NULL, &count));
    CHECK_INT(count, NUMBERS);
    count = 7;
    CHECK_STATUS(mdr_fit_parameters(NULL, 0, NULL, &count), MDR_ENULL, "problem is NULL");
    CHECK_STATUS(mdr_fit_parameters(&problem, 0, NULL, NULL), MDR_ENULL, "count is NULL");
    CHECK_STATUS(mdr_fit_parameters(&problem, 1, NULL, &count), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_fit_parameters(&problem, -1, few, &count), MDR_EINVALID, "capacity = -1");
    problem.profile = NULL;
    CHECK_STATUS(mdr_fit_parameters(&problem, 0, NULL, &count), MDR_ENULL, "profile is NULL");
    problem.profile = ball;
    problem.medium = (const mdr_medium *)ball;
    CHECK_STATUS(mdr_fit_parameters(&problem, 0, NULL, &count), MDR_EINVALID, "medium");
    CHECK_INT(count, 7);
}

/* The upper body of two: its numbers stand between those of the lower one and of the instrument. */
static void counterbody(void)
{
    enum { COUNT = NUMBERS + 2 };
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[COUNT];
    mdr_medium *diamond = NULL;
    const double a[2] = { 1e-7, 1e-6 }, y[2] = { 1e11, 1e11 };
    double paired[2], apart[2];
    const double stiff = 1141e9 / (1.0 - 0.07 * 0.07);

    CHECK_SUCCESS(new_homogeneous(1000e9, 0.07, &diamond));
    fill(&problem, parameters, NULL, NULL);
    problem.data_kind = MDR_FIT_MODULUS_RADIUS;
    CHECK_SUCCESS(mdr_fit_predict(&problem, 2, a, y, NULL, apart, NULL));
    problem.counterbody = diamond;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, COUNT, parameters, &problem.parameter_count));
    CHECK_INT(problem.parameter_count, COUNT);
    CHECK_TRUE(strcmp(parameters[9].name, "upper.E") == 0);
    parameters[9].value = 1141e9;
    CHECK_SUCCESS(mdr_fit_predict(&problem, 2, a, y, NULL, paired, NULL));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(paired[i], 1.0 / (1.0 / apart[i] + 1.0 / stiff), 1e-12);
    }
    problem.counterbody = (const mdr_medium *)ball;
    CHECK_STATUS(mdr_fit_predict(&problem, 2, a, y, NULL, paired, NULL), MDR_EINVALID, "counterbody");
    CHECK_FREE(diamond);
}

static void bad_input_is_refused(void)
{
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
    double d[3] = { 1e-8, 2e-8, 3e-8 }, F[3] = { 1e-4, 3e-4, 5e-4 }, values[NUMBERS] = { 7 }, lower = 7, upper;

    fill(&problem, parameters, NULL, NULL);
    CHECK_INT(mdr_fit_solve(NULL, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_ENULL);
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    parameters[1].is_free = 1;
    CHECK_INT(mdr_fit_solve(&problem, 3, NULL, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_ENULL);
    CHECK_INT(mdr_fit_solve(&problem, -1, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    CHECK_INT(mdr_fit_solve(&problem, 1, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    F[1] = NAN;
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    F[1] = 3e-4;
    parameters[1].lower = 80e9;
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    parameters[1].lower = -INFINITY;
    problem.parameter_count = NUMBERS - 1;
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    problem.parameter_count = NUMBERS;
    problem.data_kind = MDR_FIT_STIFFNESS_DEPTH; /* needs forces */
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    problem.data_kind = 9;
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID);
    problem.data_kind = MDR_FIT_FORCE_DEPTH;
    CHECK_STATUS(mdr_fit_quantile(1.0, 5.0, &upper), MDR_EINVALID, "level = 1:");
    CHECK_STATUS(mdr_fit_quantile(0.5, 0.0, &upper), MDR_EINVALID, "degrees_of_freedom = 0:");
    CHECK_STATUS(mdr_fit_quantile(0.5, 5.0, NULL), MDR_ENULL, "factor is NULL");
    /* Cauchy's tan(pi level/2); sqrt(2 p^2/(1 - p^2)) of two degrees; the normal distribution */
    CHECK_SUCCESS(mdr_fit_quantile(0.9, 1.0, &upper));
    CHECK_CLOSE(upper, tan(0.45 * acos(-1.0)), 1e-12);
    CHECK_SUCCESS(mdr_fit_quantile(0.9, 2.0, &upper));
    CHECK_CLOSE(upper, sqrt(2.0 * 0.81 / 0.19), 1e-12);
    CHECK_SUCCESS(mdr_fit_quantile(0.95, INFINITY, &upper));
    CHECK_CLOSE(upper, 1.9599639845400545, 1e-12);
    /* where GSL finds none, or infinity, and would end the process unless set otherwise */
    upper = 7.0;
    CHECK_INT(mdr_fit_quantile(1e-3, 1e-300, &upper), MDR_ENOCONVERGENCE);
    CHECK_INT(mdr_fit_quantile(1e-150, 1e-4, &upper), MDR_ENOCONVERGENCE); /* -4e-15 */
    CHECK_INT(mdr_fit_quantile(1.0 - 0x1p-53, INFINITY, &upper), MDR_ENOCONVERGENCE);
    CHECK_CLOSE(upper, 7.0, 0.0);
    CHECK_INT(mdr_fit_interval(&problem, 3, d, F, NULL, NULL, 0, 0.95, &lower, &upper), MDR_EINVALID); /* fixed */
    CHECK_INT(mdr_fit_interval(&problem, 3, d, F, NULL, NULL, 99, 0.95, &lower, &upper), MDR_EINVALID);
    CHECK_INT(mdr_fit_interval(&problem, 3, d, F, NULL, NULL, 1, 1.5, &lower, &upper), MDR_EINVALID);
    problem.profile = NULL;
    CHECK_INT(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_ENULL);
    CHECK_CLOSE(values[0], 7.0, 0.0);
    CHECK_CLOSE(lower, 7.0, 0.0);
}

/* One of three readings is in contact, and F ~ E sqrt(R): neither is known, whatever noise the others show. */
static void one_reading_does_not_determine_two_numbers(void)
{
    static const int losses[3] = { MDR_FIT_LINEAR, MDR_FIT_HUBER, MDR_FIT_CAUCHY };
    enum { COUNT = 13 };
    const double d[3] = { -2e-8, -1e-8, 1e-8 };
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    double values[COUNT], covariance[COUNT * COUNT];

    fill(&problem, parameters, NULL, half_space);
    CHECK_INT(problem.parameter_count, COUNT);
    parameters[0].is_free = parameters[1].is_free = 1;
    for (int i = 0; i < 60; i++) {
        const double F[3] = { 0.0, 0.0, 3e-4 * (1.0 + 0.01 * i) };
        problem.loss = losses[i % 3];
        CHECK_SUCCESS(mdr_fit_solve(&problem, 3, d, F, NULL, NULL, values, covariance, NULL, NULL, NULL, NULL, NULL, &summary));
        CHECK_TRUE(summary.weakest == 0.0);
        CHECK_TRUE(covariance[0] > 1e3 * values[0] * values[0] && covariance[COUNT + 1] > 1e3 * values[1] * values[1]);
        CHECK_TRUE(covariance[1] < 0.0);
        CHECK_CLOSE(covariance[1], covariance[COUNT], 1e-12);
    }
    /* each alone is */
    parameters[0].is_free = 0;
    CHECK_SUCCESS(mdr_fit_solve(&problem, 3, d, (double[]){ 0.0, 0.0, 3e-4 }, NULL, NULL, values, covariance, NULL, NULL, NULL,
                                NULL,
                                NULL, &summary));
    CHECK_CLOSE(summary.weakest, 1.0, 1e-12);
    CHECK_TRUE(covariance[COUNT + 1] >= 0.0 && covariance[COUNT + 1] < 1e-6 * values[1] * values[1]);
}

/* Depth, force and stiffness of an elastic contact with a cone: its radii come back where the contact is said to be elastic; a
   paraboloid's sink-in leaves less depth than the cone's, and makes them smaller. */
static void elastic_contact_depths(void)
{
    static const double angle = 0.35;
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
    double d[POINTS], a[POINTS], F[POINTS], k[POINTS], fitted[POINTS], found[POINTS];
    mdr_profile *profile = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;

    CHECK_SUCCESS(mdr_profile_cone(angle, &profile));
    CHECK_SUCCESS(new_coated(72e9, 0.17, 500e-9, 163e9, 0.22, MDR_MODEL_EXACT, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(profile, medium, NULL, &contact));
    for (int i = 0; i < POINTS; i++) d[i] = 4e-9 * (i + 1);
    CHECK_SUCCESS(columns_of(contact, MDR_DEPTH, POINTS, d, NULL, a, F, k));
    fill(&problem, parameters, profile, medium);
    CHECK_INT(problem.is_elastic, 0);
    problem.data_kind = MDR_FIT_STIFFNESS_DEPTH;
    problem.is_elastic = 1;
    CHECK_SUCCESS(mdr_fit_predict(&problem, POINTS, d, k, F, fitted, found));
    for (int i = 0; i < POINTS; i++) {
        CHECK_CLOSE(found[i], a[i], 1e-8);
        CHECK_CLOSE(fitted[i], k[i], 1e-8);
    }
    problem.is_elastic = 0;
    CHECK_SUCCESS(mdr_fit_predict(&problem, POINTS, d, k, F, fitted, found));
    for (int i = 0; i < POINTS; i++) CHECK_TRUE(found[i] > 0.95 * a[i] && found[i] < 0.995 * a[i]);
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(profile);
}

/* A crystalline film, held by springs, on silicon: C44 and K_n come back from curves of the same body; a pair stays as it is. */
static void a_body_is_a_pattern(void)
{
    enum { COUNT = 1 + 9 + 2 + 10, C12 = 2, C44 = 5, STRESS = 7, NORMAL = 8, TANGENTIAL = 9 };
    static const int sought[3] = { C44, NORMAL, STRESS };
    mdr_layer film = MDR_SIZED(mdr_layer), silicon = MDR_SIZED(mdr_layer);
    mdr_fit_problem problem = MDR_SIZED(mdr_fit_problem);
    mdr_fit_parameter parameters[COUNT];
    mdr_profile *profile = NULL;
    mdr_medium *medium = NULL, *pair = NULL;
    mdr_contact *contact = NULL;
    double d[POINTS], F[POINTS], fitted[POINTS], values[COUNT], covariance[COUNT * COUNT];
    int count = 0;

    film.C11 = 390e9, film.C12 = 145e9, film.C13 = 106e9, film.C33 = 398e9, film.C44 = 105e9;
    film.thickness = 1e-6, film.normal_compliance = 1.0 / 2e17;
    silicon.E = 163e9, silicon.nu = 0.22;
    CHECK_SUCCESS(mdr_profile_paraboloid(5e-6, &profile));
    CHECK_SUCCESS(medium_of_layers(1, &film, &silicon, MDR_MODEL_EXACT, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(profile, medium, NULL, &contact));
    for (int i = 0; i < POINTS; i++) d[i] = 1e-8 * (i + 1);
    CHECK_SUCCESS(columns_of(contact, MDR_DEPTH, POINTS, d, NULL, NULL, F, NULL));

    problem.profile = profile;
    problem.medium = medium;
    problem.parameters = parameters;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, COUNT, parameters, &problem.parameter_count));
    CHECK_INT(problem.parameter_count, COUNT);
    CHECK_SUCCESS(mdr_fit_predict(&problem, POINTS, d, F, NULL, fitted, NULL));
    for (int i = 0; i < POINTS; i++) CHECK_CLOSE(fitted[i], F[i], 1e-9);
    for (int i = 0; i < 3; i++) {
        const int j = sought[i];
        const mdr_fit_parameter kept = parameters[j];
        parameters[j].is_free = 1;
        parameters[j].value = j == STRESS ? 1e9 : 0.7 * kept.value;
        CHECK_SUCCESS(mdr_fit_solve(&problem, POINTS, d, F, NULL, NULL, values, covariance, NULL, NULL, NULL, NULL, NULL, NULL));
        CHECK_TRUE(fabs(values[j] - kept.value) < 1e-5 * (j == STRESS ? 100e9 : kept.value));
        parameters[j] = kept;
    }
    /* no reading depends on C12; a bonded interface has no stiffness to begin from */
    parameters[C12].is_free = 1;
    CHECK_STATUS(mdr_fit_solve(&problem, POINTS, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID,
                 "it must not be free, because the readings do not depend on it");
    parameters[C12].is_free = 0;
    parameters[TANGENTIAL].is_free = 1;
    CHECK_STATUS(mdr_fit_solve(&problem, POINTS, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, NULL), MDR_EINVALID,
                 "the value of a free parameter");
    CHECK_SUCCESS(mdr_medium_pair(medium, medium, &pair));
    problem.medium = pair;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, COUNT, parameters, &count));
    CHECK_INT(count, 1 + 10);
    CHECK_FREE(contact);
    CHECK_FREE(pair);
    CHECK_FREE(medium);
    CHECK_FREE(profile);
}

int main(void)
{
    CHECK_SUCCESS(mdr_profile_paraboloid(10e-6, &ball));
    CHECK_SUCCESS(new_coated(72e9, 0.17, 500e-9, 163e9, 0.22, MDR_MODEL_GAO, NULL, &film));
    CHECK_SUCCESS(new_homogeneous(72e9, 0.17, &half_space));
    parameters_are_listed();
    a_body_is_a_pattern();
    elastic_contact_depths();
    one_reading_does_not_determine_two_numbers();
    truth_comes_back();
    counterbody();
    bad_input_is_refused();
    CHECK_FREE(ball);
    CHECK_FREE(film);
    CHECK_FREE(half_space);
    return check_report("fit");
}
