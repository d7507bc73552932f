/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One case of every kind of call that takes long, from making the objects to freeing them: their numbers go to an array. What must
 * hold for all of them, whatever thread and rounding mode they are called in, is tested by running the list.
 */
#ifndef LONG_CALLS_H
#define LONG_CALLS_H

#include "check.h"
#include "mdrcontact/all.h"

enum { MOST_NUMBERS = 96 };

typedef struct numbers {
    int count;
    double values[MOST_NUMBERS];
} numbers;

typedef struct long_call {
    const char *name;
    void (*run)(numbers *out);
} long_call;

/* Room for n more numbers. */
static double *more(numbers *out, int n)
{
    double *room = out->values + out->count;
    out->count += n;
    if (out->count > MOST_NUMBERS) {
        fprintf(stderr, "MOST_NUMBERS is too small\n");
        exit(EXIT_FAILURE);
    }
    return room;
}

static int bowl(double r, double *y, void *context)
{
    (void)context;
    *y = r * r / (1.0 + sqrt(1.0 + r * r));
    return 0;
}

static int rising(double z, double *y, void *context)
{
    *y = *(const double *)context * (2.0 - exp(-z));
    return 0;
}

static int constant_nu(double z, double *y, void *context)
{
    (void)z;
    (void)context;
    *y = 0.3;
    return 0;
}

#ifdef MDRCONTACT_LATERAL_H
static int inclusion(double x, double y, double z, double *E, double *nu, void *context)
{
    (void)context;
    *E = 1.0 + exp(-x * x - y * y - (z - 1.0) * (z - 1.0));
    *nu = 0.3;
    return 0;
}
#endif

static mdr_medium *coating(double stiffness)
{
    mdr_medium *m = NULL;
    CHECK_SUCCESS(new_coated(stiffness, 0.25, 1.0, 1.0, 0.35, MDR_MODEL_EXACT, NULL, &m));
    return m;
}

static mdr_medium *grading(void)
{
    static const double z[3] = {0.0, 1.0, 2.0}, E[3] = {4.0, 1.0, 2.0}, nu[3] = {0.3, 0.2, 0.3};
    mdr_medium *m = NULL;
    CHECK_SUCCESS(medium_of_grades(3, z, E, nu, MDR_MODEL_EXACT, NULL, &m));
    return m;
}

/* Frees the medium. */
static mdr_contact *ball_on(mdr_medium *m, double work_of_adhesion)
{
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;
    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work_of_adhesion;
    CHECK_SUCCESS(mdr_profile_paraboloid(5.0, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    MDR_FREE(p);
    MDR_FREE(m);
    return c;
}

static mdr_state state_at(const mdr_contact *c, double a)
{
    mdr_state state = {0};
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &a, &state));
    return state;
}

static void profiles(numbers *out)
{
    static const double x[4] = {0.0, 0.3, 1.0, 2.0}, y[4] = {0.0, 0.1, 0.7, 2.0}, tip[3] = {24.5, 0.3, 0.01};
    static const double r[3] = {0.01, 0.4, 0.9};
    mdr_profile *p[5] = {NULL};
    CHECK_SUCCESS(mdr_profile_function(bowl, NULL, 2.0, &p[0]));
    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 4, x, y, &p[1]));
    CHECK_SUCCESS(mdr_profile_table(MDR_G, 4, x, y, &p[2]));
    CHECK_SUCCESS(mdr_profile_area_function(3, tip, 0.0, 1.0, &p[3]));
    CHECK_SUCCESS(mdr_profile_sum(2, (const mdr_profile *const *)p, &p[4]));
    for (int i = 0; i < 5; i++) {
        CHECK_SUCCESS(mdr_profile_values(p[i], MDR_G, 3, r, more(out, 3)));
        CHECK_SUCCESS(mdr_profile_values(p[i], MDR_HEIGHT, 3, r, more(out, 3)));
        MDR_FREE(p[i]);
    }
}

static void media(numbers *out)
{
    static const double a[3] = {0.05, 1.0, 20.0};
    double scale = 2.0;
    mdr_medium *m[5] = {coating(10.0), coating(0.1), grading(), NULL, NULL};
    CHECK_SUCCESS(medium_of_functions(rising, constant_nu, &scale, 4.0, MDR_MODEL_GAO_SERIES, NULL, &m[3]));
    CHECK_SUCCESS(mdr_medium_pair(m[0], m[2], &m[4]));
    for (int i = 0; i < 5; i++) {
        CHECK_SUCCESS(mdr_medium_values(m[i], MDR_MODULUS, 3, a, more(out, 3)));
        CHECK_SUCCESS(mdr_medium_values(m[i], MDR_TANGENTIAL_MODULUS, 3, a, more(out, 3)));
        if (i < 3) CHECK_SUCCESS(mdr_medium_values(m[i], MDR_TORSIONAL_STIFFNESS, 3, a, more(out, 3)));
    }
    for (int i = 0; i < 5; i++) MDR_FREE(m[i]);
}

/* Up to radii at which a state takes a thousand unknowns, which LAPACK solves for. */
static void states(numbers *out)
{
    static const double a[3] = {0.1, 30.0, 9000.0}, F[2] = {0.1, 50.0}, r[2] = {0.0, 0.99};
    for (int i = 0; i < 4; i++) {
        mdr_contact *c = ball_on(i < 2 ? coating(i == 0 ? 30.0 : 0.03) : i == 2 ? grading() : coating(2.0), 0.0);
        const int n = i < 2 ? 3 : 2;
        CHECK_SUCCESS(columns_of(c, MDR_RADIUS, n, a, NULL, NULL, more(out, n), NULL));
        CHECK_SUCCESS(columns_of(c, MDR_FORCE, 2, F, more(out, 2), NULL, NULL, NULL));
        const mdr_state state = state_at(c, 1.0);
        CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, 2, r, more(out, 2)));
        CHECK_SUCCESS(state_field(c, MDR_DISPLACEMENT, &state, 1, (const double[1]){2.5}, more(out, 1)));
        CHECK_SUCCESS(state_energy(c, &state, more(out, 1), NULL));
        CHECK_SUCCESS(state_lowest_pressure(c, &state, more(out, 1), NULL));
        MDR_FREE(c);
    }
}

static void interior(numbers *out)
{
    static const double r[2] = {0.3, 1.2}, z[2] = {0.5, 1.5};
    for (int i = 0; i < 3; i++) {
        mdr_contact *c = ball_on(i < 2 ? coating(i == 0 ? 30.0 : 0.1) : grading(), 0.0);
        const mdr_state state = state_at(c, 1.0);
        mdr_interior *points = (mdr_interior *)more(out, 2 * (int)(sizeof(mdr_interior) / sizeof(double)));
        CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.2, 2, r, z, NULL, points));
        if (i < 2) CHECK_SUCCESS(state_layer_energies(c, MDR_BODY_LOWER, &state, 2, more(out, 2), &(int){0}));
        MDR_FREE(c);
    }
}

#ifdef MDRCONTACT_TIME_H
static const double moduli[2] = {2.0, 0.5}, times[2] = {0.3, 3.0};

static mdr_contact *ball_on_polymer(int i)
{
    const double h = 1.0;
    mdr_material *polymer = NULL, *base = NULL;
    mdr_medium *m = NULL;
    CHECK_SUCCESS(i == 3 ? mdr_material_power_law(1.0, 1.0, 0.2, 0.5, &polymer)
                         : mdr_material_viscoelastic(1.0, 2, moduli, times, 0.0, 0.4, 0.0, &polymer));
    CHECK_SUCCESS(mdr_material_viscoelastic(10.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &base));
    CHECK_SUCCESS(relaxing_medium(i > 0, (const mdr_material *const[1]){polymer}, &h,
                                          i == 0 ? polymer : i == 1 ? NULL : base, MDR_MODEL_EXACT, NULL, &m));
    MDR_FREE(polymer);
    MDR_FREE(base);
    return ball_on(m, 0.0);
}

/* Homogeneous and on a rigid base, which relax in proportion, and two that are marched. */
static void histories(numbers *out)
{
    static const double t[4] = {0.0, 0.5, 1.0, 4.0}, d[4] = {0.0, 0.2, 0.1, 0.05}, again[4] = {0.0, 0.2, 0.1, 0.2};
    for (int i = 0; i < 4; i++) {
        mdr_contact *c = ball_on_polymer(i);
        CHECK_SUCCESS(mdr_contact_history(c, MDR_DEPTH, 1e-4, 4, t, d, NULL, more(out, 4), more(out, 4)));
        if (i == 2) CHECK_SUCCESS(mdr_contact_history(c, MDR_DEPTH, 1e-4, 4, t, again, NULL, NULL, more(out, 4)));
        if (i == 0) CHECK_SUCCESS(mdr_contact_history(c, MDR_FORCE, 1e-4, 4, t, d, more(out, 4), NULL, NULL));
        MDR_FREE(c);
    }
}

static void responses(numbers *out)
{
    static const double omega[3] = {0.1, 1.0, 10.0}, a[3] = {0.2, 1.0, 4.0};
    for (int i = 0; i < 4; i++) {
        mdr_contact *c = ball_on_polymer(i);
        CHECK_SUCCESS(mdr_contact_dynamic_stiffness(c, 3, omega, a, more(out, 3), more(out, 3)));
        CHECK_SUCCESS(mdr_contact_step_response(c, MDR_CREEP, 0.7, 2, omega, more(out, 2)));
        MDR_FREE(c);
    }
}
#endif

static void loops(numbers *out)
{
    mdr_contact *c = ball_on(coating(10.0), 0.02);
    mdr_loop *loop = NULL;
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    CHECK_SUCCESS(pull_off_of(c, MDR_FORCE, 1, more(out, 1), more(out, 1), more(out, 1), NULL));
    CHECK_SUCCESS(mdr_loop_new(c, MDR_DEPTH, 0.1, 5, 0.0, &loop));
    CHECK_SUCCESS(mdr_loop_points(loop, 8, (mdr_loop_point *)more(out, 8 * (int)(sizeof(mdr_loop_point) / sizeof(double))), NULL));
    CHECK_SUCCESS(mdr_loop_about(loop, &facts));
    *more(out, 1) = facts.dissipated_energy;
    MDR_FREE(loop);
    MDR_FREE(c);
}

static void friction(numbers *out)
{
    static const double depth[3] = {0.05, 0.1, 0.08}, shift[3] = {0.0, 0.005, -0.005};
    for (int i = 0; i < 2; i++) {
        mdr_contact *c = ball_on(coating(i == 0 ? 1.0 : 5.0), 0.0);
        mdr_friction *f = NULL;
        mdr_friction_history *h = NULL;
        mdr_shear_state sheared[3];
        mdr_state reached[3];
        const mdr_state state = state_at(c, 0.7);
        CHECK_SUCCESS(mdr_friction_new(c, 0.3, &f));
        CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_ALONG, more(out, 1), NULL));
        CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 1, shift + 1, sheared));
        *more(out, 1) = sheared[0].tangential_force;
        CHECK_SUCCESS(shear_field(c, f, &state, MDR_ALONG, sheared, MDR_TRACTION, 1, (const double[1]){0.3}, more(out, 1)));
        CHECK_SUCCESS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 0.004, 5, more(out, 5), more(out, 5), more(out, 1)));
        CHECK_SUCCESS(mdr_friction_history_new(f, 0.12, 20, &h));
        CHECK_SUCCESS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 3, depth, shift, reached, sheared));
        for (int j = 0; j < 3; j++) *more(out, 1) = sheared[j].tangential_force;
        MDR_FREE(h);
        MDR_FREE(f);
        MDR_FREE(c);
    }
}

static void torsion(numbers *out)
{
    mdr_medium *m = NULL;
    mdr_friction *f = NULL;
    mdr_shear_state twisted;
    CHECK_SUCCESS(new_homogeneous(2.0, 0.3, &m));
    mdr_contact *c = ball_on(m, 0.0);
    const mdr_state state = state_at(c, 0.7);
    CHECK_SUCCESS(mdr_friction_new(c, 0.3, &f));
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 1, (const double[1]){0.01}, &twisted));
    *more(out, 1) = twisted.tangential_force;
    CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_AROUND, NULL, more(out, 1)));
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_AROUND, &twisted, MDR_TRACTION, 1, (const double[1]){0.3}, more(out, 1)));
    CHECK_SUCCESS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, 0.01, 5, more(out, 5), more(out, 5), more(out, 1)));
    MDR_FREE(f);
    MDR_FREE(c);
}

static void laws(numbers *out)
{
    for (int i = 0; i < 3; i++) {
        mdr_contact *c = ball_on(i < 2 ? coating(10.0) : grading(), i == 1 ? 0.02 : 0.0);
        mdr_law *law = NULL, *copy = NULL;
        char *content = NULL;
        int length = 0, sum = 0;
        mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
        CHECK_SUCCESS(mdr_law_new(c, 0.2, NULL, &law));
        CHECK_SUCCESS(mdr_law_write(law, NULL, 0, &length));
        content = malloc((size_t)length);
        CHECK_SUCCESS(mdr_law_write(law, content, length, &length));
        CHECK_SUCCESS(mdr_law_read(content, length, &copy));
        for (int j = 0; j < length; j++) sum += (unsigned char)content[j];
        *more(out, 1) = sum;
        free(content);
        CHECK_SUCCESS(mdr_law_about(copy, &facts));
        *more(out, 1) = facts.error;
        *more(out, 1) = facts.lowest_force;
        MDR_FREE(copy);
        MDR_FREE(law);
        MDR_FREE(c);
    }
}

static void friction_laws(numbers *out)
{
    mdr_contact *c = ball_on(coating(5.0), 0.0);
    mdr_friction *f = NULL;
    mdr_law *law = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double memory[43] = {0.0}, T[3];
    CHECK_SUCCESS(mdr_friction_new(c, 0.3, &f));
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.friction = f;
    CHECK_SUCCESS(mdr_law_new(c, 0.2, &options, &law));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    *more(out, 1) = facts.highest_sliding_shift;
    CHECK_INT(facts.memory_size, 43);
    CHECK_SUCCESS(mdr_law_advance(law, 1, (const double[1]){0.1}, (const double[3]){0.002, 0.001, 0.0}, 0, NULL, memory, T));
    for (int i = 0; i < 3; i++) *more(out, 1) = T[i];
    MDR_FREE(law);
    MDR_FREE(f);
    MDR_FREE(c);
}

#ifdef MDRCONTACT_FIT_H
/* E of a film, from what it was predicted with. Nothing is computed here: the caller may round otherwise. */
static void fits(numbers *out)
{
    enum { POINTS = 6, MOST = 20 };
    static const double d[POINTS] = {0.02, 0.04, 0.06, 0.08, 0.1, 0.12}, sd[POINTS] = {0.1, 0.1, 0.1, 0.1, 0.1, 0.1};
    double F[POINTS], values[MOST];
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[MOST];
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    int count = 0;

    CHECK_SUCCESS(mdr_profile_paraboloid(5.0, &ball));
    CHECK_SUCCESS(new_coated(5.0, 0.25, 1.0, 1.0, 0.35, MDR_MODEL_EXACT, NULL, &film));
    problem = MDR_SIZED(mdr_fit_problem);
    problem.profile = ball;
    problem.medium = film;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, MOST, parameters, &count));
    CHECK_INT(count, 19);
    parameters[1].is_free = 1;
    problem.parameter_count = count;
    problem.parameters = parameters;
    CHECK_SUCCESS(mdr_fit_predict(&problem, POINTS, d, d, NULL, F, NULL));
    parameters[1].value = 4.0;
    CHECK_SUCCESS(mdr_fit_solve(&problem, POINTS, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, more(out, POINTS), NULL, NULL));
    *more(out, 1) = values[1];
    CHECK_SUCCESS(mdr_fit_interval(&problem, POINTS, d, F, NULL, sd, 1, 0.9, more(out, 1), more(out, 1)));
    CHECK_SUCCESS(mdr_fit_quantile(0.9, 5.0, more(out, 1)));
    MDR_FREE(ball);
    MDR_FREE(film);
}
#endif

#ifdef MDRCONTACT_LATERAL_H
static void lateral(numbers *out)
{
    static const double ball[7] = {0.0, 0.0, 1.0, 0.5}, spacing[3] = {0.5, 0.5, 0.5}, E[2] = {1.0, 2.0}, nu[2] = {0.3, 0.2};
    static const double x[3] = {-1.0, 0.0, 0.5}, zero[1] = {0.0}, a[1] = {0.7};
    static const int kind[1] = {MDR_SHAPE_BALL}, size[3] = {2, 2, 1}, labels[4] = {0, 1, 1, 0};
    mdr_structure *s[3] = {NULL};
    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, 1, kind, ball, E + 1, nu + 1, NULL, &s[0]));
    CHECK_SUCCESS(mdr_structure_voxels(size, labels, 2, E, nu, spacing, 1.0, 0.3, NULL, &s[1]));
    CHECK_SUCCESS(mdr_structure_function(inclusion, NULL, 0.3, NULL, &s[2]));
    for (int i = 0; i < 3; i++) {
        mdr_medium *m = NULL;
        CHECK_SUCCESS(mdr_structure_modulus(s[i], 1, zero, zero, a, more(out, 1)));
        if (i == 0) CHECK_SUCCESS(mdr_structure_medium(s[i], 0.0, 0.0, 0.1, 1.0, 5, &m));
        if (i == 0) CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, more(out, 1)));
        MDR_FREE(m);
        MDR_FREE(s[i]);
    }
    CHECK_SUCCESS(mdr_lateral_cells(0.3, 1.0, 0.1, 0.6, 2, x, 2, x, more(out, 4), more(out, 4)));
    CHECK_SUCCESS(mdr_lateral_rule(1, 0.3, more(out, 18), more(out, 12)));
}
#endif

static void closed_forms(numbers *out)
{
    static const double a[3] = {0.1, 1.0, 10.0};
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){5.0, 2.0, 1.0, 1.0}, more(out, 3)));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_CONE_FORCE, 3, a, (const double[]){0.3, 2.0, 1.0, 1.0}, more(out, 3)));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, 3, a, (const double[]){5.0, 2.0, 1.0, 1.0, 0.1}, more(out, 3)));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, 3, a, (const double[]){2.0, 1.0}, more(out, 3)));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){5.0}, (const double[]){1.0, 0.1}, more(out, 1)));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, 3, a, more(out, 3)));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_J1, 0.3, 3, a, more(out, 3)));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_J0_TANGENTIAL, 0.3, 3, a, more(out, 3)));
}

static const long_call long_calls[] = {
    {"profiles", profiles},
    {"media", media},
    {"states", states},
    {"interior", interior},
    {"loops", loops},
    {"friction", friction},
    {"torsion", torsion},
    {"laws", laws},
    {"friction laws", friction_laws},
    {"closed forms", closed_forms},
#ifdef MDRCONTACT_TIME_H
    {"histories", histories},
    {"responses", responses},
#endif
#ifdef MDRCONTACT_LATERAL_H
    {"lateral", lateral},
#endif
#ifdef MDRCONTACT_FIT_H
    {"fits", fits},
#endif
};

enum { LONG_CALLS = sizeof long_calls / sizeof *long_calls };

#endif
