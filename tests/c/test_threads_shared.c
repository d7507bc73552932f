/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One object of every kind, evaluated by several threads at once: the same numbers as one thread alone. */
#include "check.h"
#include "mdrcontact/all.h"

#include <pthread.h>

enum { THREADS = 3, POINTS = 3, MOST_VALUES = 260, CONTACTS = 8, MEDIA = CONTACTS, LAYERS = 2, PHASES = 2, FIT_POINTS = 4 };
enum { NUMBERS = 25 };

typedef struct shared {
    mdr_profile *ball, *cone, *table, *sum;
    mdr_medium *media[MEDIA];
    mdr_contact *contacts[CONTACTS], *adhesive;
    mdr_loop *loop;
    mdr_law *law;
#ifdef MDRCONTACT_LATERAL_H
    mdr_structure *shapes, *voxels;
#endif
#ifdef MDRCONTACT_FIT_H
    mdr_fit_problem fit;
    mdr_fit_parameter parameters[NUMBERS];
#endif
} shared;

typedef struct task {
    const shared *objects;
    int failed_calls, count;
    double values[MOST_VALUES];
} task;

static const double radii[POINTS] = {0.05, 0.3, 0.8};

static double *next(task *t, int n)
{
    double *v = t->values + t->count;
    t->count += n;
    return v;
}

static void record(task *t, int status)
{
    if (status == MDR_SUCCESS) return;
    t->failed_calls++;
    fprintf(stderr, "%s\n", mdr_last_error());
}

static void evaluate_contact(task *t, const mdr_contact *contact)
{
    double depth[1], *F;
    F = next(t, 1);
    record(t, columns_of(contact, MDR_RADIUS, 1, &radii[1], depth, NULL, F, NULL));
    record(t, columns_of(contact, MDR_DEPTH, 1, depth, NULL, next(t, 1), NULL, NULL));
    record(t, columns_of(contact, MDR_FORCE, 1, F, next(t, 1), NULL, NULL, NULL));
    record(t, field_at(contact, MDR_PRESSURE, MDR_RADIUS, 0.31, 1, &radii[0], next(t, 1)));
    record(t, field_at(contact, MDR_DISPLACEMENT, MDR_RADIUS, 0.31, 1, &radii[2], next(t, 1)));
}

#ifdef MDRCONTACT_FIT_H
static void evaluate_fit(task *t, const mdr_fit_problem *problem)
{
    static const double depth[FIT_POINTS] = {0.1, 0.2, 0.3, 0.4};
    double force[FIT_POINTS], values[NUMBERS];
    record(t, mdr_fit_predict(problem, FIT_POINTS, depth, depth, NULL, force, NULL));
    record(t, mdr_fit_solve(problem, FIT_POINTS, depth, force, NULL, NULL, values, NULL, NULL, NULL, NULL, next(t, FIT_POINTS),
                            NULL,
                          NULL));
}
#endif

/* Every evaluation of every object, into t->values. */
static void *evaluate(void *argument)
{
    task *t = argument;
    const shared *s = t->objects;
    int segment = 0;

    record(t, mdr_profile_values(s->table, MDR_HEIGHT, POINTS, radii, next(t, POINTS)));
    record(t, mdr_profile_values(s->sum, MDR_G, POINTS, radii, next(t, POINTS)));
    for (int i = 0; i < MEDIA; i++) record(t, mdr_medium_values(s->media[i], MDR_MODULUS, POINTS, radii, next(t, POINTS)));
    for (int i = 0; i < CONTACTS; i++) evaluate_contact(t, s->contacts[i]);
    evaluate_contact(t, s->adhesive);
    record(t, pull_off_of(s->adhesive, MDR_FORCE, 1, next(t, 1), NULL, NULL, NULL));
    record(t, mdr_loop_points(s->loop, POINTS, (mdr_loop_point *)next(t, POINTS * (int)(sizeof(mdr_loop_point) / sizeof(double))),
                              NULL));
    record(t, mdr_law_force(s->law, MDR_ON_UNLOADING, 0.1, next(t, 1), NULL));
    record(t, mdr_law_follow(s->law, 0.1, &segment, (mdr_law_point *)next(t, sizeof(mdr_law_point) / sizeof(double))));
    record(t, mdr_law_values(s->law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, radii, NULL, NULL, next(t, POINTS), NULL, NULL,
                             NULL));
#ifdef MDRCONTACT_LATERAL_H
    static const double zero[POINTS] = {0.0};
    record(t, mdr_structure_modulus(s->shapes, 1, zero, zero, radii, next(t, 1)));
    record(t, mdr_structure_modulus(s->voxels, 1, zero, zero, radii, next(t, 1)));
#endif
#ifdef MDRCONTACT_FIT_H
    evaluate_fit(t, &s->fit);
#endif
    return NULL;
}

static void make_media(shared *s)
{
    static const double E[LAYERS] = {3.0, 2.0}, nu[LAYERS] = {0.3, 0.2}, h[LAYERS] = {0.5, 0.2}, z[LAYERS] = {0.0, 1.0};
    static const double a[POINTS] = {0.01, 0.5, 2.0};
    mdr_medium_options loose;

    loose = MDR_SIZED(mdr_medium_options);
    loose.tolerance = 1e-4;
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &s->media[0]));
    CHECK_SUCCESS(new_layered(LAYERS, E, nu, h, 1.0, 0.4, MDR_MODEL_GAO, NULL, &s->media[1]));
    CHECK_SUCCESS(new_layered(LAYERS, E, nu, h, 1.0, 0.4, MDR_MODEL_EXACT, &loose, &s->media[2]));
    CHECK_SUCCESS(medium_of_grades(LAYERS, z, E, nu, MDR_MODEL_GAO_SERIES, NULL, &s->media[3]));
    CHECK_SUCCESS(medium_of_grades(LAYERS, z, E, nu, MDR_MODEL_EXACT, &loose, &s->media[4]));
    CHECK_SUCCESS(medium_of_power(1.0, 1.0, 0.2, 0.3, &s->media[5]));
    CHECK_SUCCESS(mdr_medium_table(POINTS, a, radii, &s->media[6]));
    CHECK_SUCCESS(mdr_medium_pair(s->media[2], s->media[4], &s->media[7])); /* both exact: fields too */
}

#ifdef MDRCONTACT_LATERAL_H
static void make_structures(shared *s)
{
    static const double sphere[7] = {0.0, 0.0, 1.0, 0.5}, spacing[3] = {0.5, 0.5, 0.5};
    static const double E[PHASES] = {1.0, 2.0}, nu[PHASES] = {0.3, 0.2};
    static const int kind[1] = {MDR_SHAPE_BALL}, size[3] = {2, 2, 1}, labels[4] = {0, 1, 1, 0};
    mdr_structure_options loose;

    loose = MDR_SIZED(mdr_structure_options);
    loose.tolerance = 1e-2;
    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, 1, kind, sphere, E + 1, nu + 1, &loose, &s->shapes));
    CHECK_SUCCESS(mdr_structure_voxels(size, labels, PHASES, E, nu, spacing, 1.0, 0.3, NULL, &s->voxels));
}
#endif

#ifdef MDRCONTACT_FIT_H
/* A stack under a paraboloid of free radius, on a rigid and exact instrument. */
static void make_fit(shared *s)
{
    int count = 0;

    s->fit = MDR_SIZED(mdr_fit_problem);
    s->fit.data_kind = MDR_FIT_FORCE_DEPTH;
    s->fit.profile = s->ball;
    s->fit.medium = s->media[1];
    CHECK_SUCCESS(mdr_fit_parameters(&s->fit, NUMBERS, s->parameters, &count));
    CHECK_INT(count, NUMBERS);
    s->parameters[0].is_free = 1;
    s->fit.parameters = s->parameters;
    s->fit.parameter_count = count;
}
#endif

static void make(shared *s)
{
    static const double r[4] = {0.0, 0.5, 1.0, 2.0}, f[4] = {0.0, 0.1, 0.3, 1.0};
    const mdr_profile *terms[2];
    mdr_contact_options sticky;
    mdr_law_options loose;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &s->ball));
    CHECK_SUCCESS(mdr_profile_rounded_cone(0.4, 0.35, &s->cone));
    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 4, r, f, &s->table));
    terms[0] = s->cone;
    terms[1] = s->table;
    CHECK_SUCCESS(mdr_profile_sum(2, terms, &s->sum));
    make_media(s);
    for (int i = 0; i < CONTACTS; i++) CHECK_SUCCESS(mdr_contact_new(s->cone, s->media[i], NULL, &s->contacts[i]));
    sticky = MDR_SIZED(mdr_contact_options);
    sticky.work_of_adhesion = 0.02;
    CHECK_SUCCESS(mdr_contact_new(s->cone, s->media[1], &sticky, &s->adhesive));
    CHECK_SUCCESS(mdr_loop_new(s->adhesive, MDR_DEPTH, 0.3, POINTS, 0.0, &s->loop));
    loose = MDR_SIZED(mdr_law_options);
    loose.tolerance = 1e-4;
    CHECK_SUCCESS(mdr_law_new(s->adhesive, 1.0, &loose, &s->law));
#ifdef MDRCONTACT_LATERAL_H
    make_structures(s);
#endif
#ifdef MDRCONTACT_FIT_H
    make_fit(s);
#endif
}

static void free_all(shared *s)
{
    MDR_FREE(s->ball);
    MDR_FREE(s->cone);
    MDR_FREE(s->table);
    MDR_FREE(s->sum);
    for (int i = 0; i < MEDIA; i++) MDR_FREE(s->media[i]);
    for (int i = 0; i < CONTACTS; i++) MDR_FREE(s->contacts[i]);
    MDR_FREE(s->adhesive);
    MDR_FREE(s->loop);
    MDR_FREE(s->law);
#ifdef MDRCONTACT_LATERAL_H
    MDR_FREE(s->shapes);
    MDR_FREE(s->voxels);
#endif
}

int main(void)
{
    static shared objects;
    static task alone, tasks[THREADS];
    pthread_t threads[THREADS];

    make(&objects);
    alone.objects = &objects;
    for (int i = 0; i < THREADS; i++) tasks[i] = alone;
    evaluate(&alone);
    CHECK_INT(alone.failed_calls, 0);
    CHECK_TRUE(alone.count < MOST_VALUES);
    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_create(&threads[i], NULL, evaluate, &tasks[i]), 0);
    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_join(threads[i], NULL), 0);
    for (int i = 0; i < THREADS; i++) {
        CHECK_INT(tasks[i].failed_calls, 0);
        for (int j = 0; j < alone.count; j++) CHECK_CLOSE(tasks[i].values[j], alone.values[j], 0.0);
    }
    free_all(&objects);
    return check_report("threads that share every kind of object");
}
