/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arrays on several threads: the same numbers to the last bit and the same error for every number of threads, also where the
 * caller has threads of its own. */
#include "check.h"
#include "mdrcontact/all.h"

#include <pthread.h>
#ifdef _OPENMP
#include <omp.h>
#endif

enum { QUICK = 17000, STATES = 203, EXACT = 24, OUTPUTS = 30, CALLERS = 3 };

typedef struct objects {
    mdr_profile *profile;
    mdr_medium *medium, *exact_medium, *homogeneous;
    mdr_contact *contact, *exact, *quick;
#ifdef MDRCONTACT_LATERAL_H
    mdr_structure *structure;
#endif
} objects;

static double place[QUICK], small_place[STATES];

static void make(objects *o)
{
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = 0.01;
    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &o->profile));
    CHECK_SUCCESS(new_coated(9.0, 0.3, 1.0, 3.0, 0.4, MDR_MODEL_GAO, NULL, &o->medium));
    CHECK_SUCCESS(new_coated(9.0, 0.3, 1.0, 3.0, 0.4, MDR_MODEL_EXACT, NULL, &o->exact_medium));
    CHECK_SUCCESS(new_homogeneous(3.0, 0.4, &o->homogeneous));
    CHECK_SUCCESS(mdr_contact_new(o->profile, o->medium, &options, &o->contact));
    CHECK_SUCCESS(mdr_contact_new(o->profile, o->exact_medium, NULL, &o->exact));
    CHECK_SUCCESS(mdr_contact_new(o->profile, o->homogeneous, NULL, &o->quick));
#ifdef MDRCONTACT_LATERAL_H
    const int kind = MDR_SHAPE_BALL;
    const double sphere[7] = {0.5, 0.0, 1.0, 0.4}, E = 9.0, nu = 0.2;
    CHECK_SUCCESS(mdr_structure_shapes(3.0, 0.4, 1, &kind, sphere, &E, &nu, NULL, &o->structure));
#endif
    for (int i = 0; i < QUICK; i++) place[i] = pow(10.0, -3.0 + 5.0 * i / QUICK);
    for (int i = 0; i < STATES; i++) small_place[i] = 0.999 * i / STATES;
}

static void end(objects *o)
{
#ifdef MDRCONTACT_LATERAL_H
    CHECK_FREE(o->structure);
#endif
    CHECK_FREE(o->quick);
    CHECK_FREE(o->exact);
    CHECK_FREE(o->contact);
    CHECK_FREE(o->homogeneous);
    CHECK_FREE(o->exact_medium);
    CHECK_FREE(o->medium);
    CHECK_FREE(o->profile);
}

/* The states of a batch in one column. */
static int force_on_loading(const mdr_contact *c, double F[])
{
    static const mdr_state none;
    mdr_state states[STATES];
    const int status = mdr_contact_states(c, MDR_DEPTH, MDR_ON_LOADING, STATES, small_place, states);

    for (int i = 0; i < STATES; i++) F[i] = status == MDR_SUCCESS ? states[i].force : none.force;
    return status;
}

/* Every function there is; out: OUTPUTS rows of QUICK numbers. Returns how many calls failed. */
static int evaluate(const objects *o, int threads, double *out)
{
    double *v = out;
    int failed = mdr_set_threads(threads) != MDR_SUCCESS;
#define NEXT (v += QUICK, v - QUICK)
#define CALL(call) (failed += (call) != MDR_SUCCESS)
    for (int i = 0; i < OUTPUTS * QUICK; i++) out[i] = 0.0;
    CALL(mdr_profile_values(o->profile, MDR_HEIGHT, QUICK, place, NEXT));
    CALL(mdr_profile_values(o->profile, MDR_HEIGHT_SLOPE, QUICK, place, NEXT));
    CALL(mdr_profile_values(o->profile, MDR_G, QUICK, place, NEXT));
    CALL(mdr_profile_values(o->profile, MDR_G_SLOPE, QUICK, place, NEXT));
    CALL(mdr_medium_values(o->medium, MDR_MODULUS, QUICK, place, NEXT));
    CALL(mdr_medium_values(o->exact_medium, MDR_STIFFNESS, EXACT, small_place + 1, NEXT));
    CALL(mdr_weight(MDR_WEIGHT_PHI, 0.3, QUICK, place, NEXT));
    CALL(mdr_weight(MDR_WEIGHT_I0, 0.3, QUICK, place, NEXT));
    CALL(mdr_weight(MDR_WEIGHT_I1, 0.3, QUICK, place, NEXT));
    CALL(mdr_weight(MDR_WEIGHT_J0, 0.3, QUICK, place, NEXT));
    CALL(mdr_weight(MDR_WEIGHT_J1, 0.3, QUICK, place, NEXT));
    CALL(force_on_loading(o->contact, NEXT));
    CALL(columns_of(o->contact, MDR_FORCE, STATES, small_place, NULL, NEXT, NULL, NULL));
    CALL(columns_of(o->quick, MDR_DEPTH, QUICK, place, NULL, NULL, NEXT, NULL));
    CALL(columns_of(o->exact, MDR_FORCE, EXACT, small_place, NEXT, NULL, NULL, NULL));
    CALL(columns_of(o->exact, MDR_RADIUS, EXACT, small_place, NULL, NULL, NULL, NEXT));
    CALL(field_at(o->contact, MDR_PRESSURE, MDR_RADIUS, 1.0, STATES, small_place, NEXT));
    CALL(field_at(o->exact, MDR_DISPLACEMENT, MDR_RADIUS, 0.5, STATES, small_place, NEXT));
    CALL(field_at(o->exact, MDR_LINE_LOAD, MDR_RADIUS, 1.0, STATES, small_place, NEXT));
    CALL(field_at(o->quick, MDR_PRESSURE, MDR_DEPTH, 0.6, STATES, small_place, NEXT));
    CALL(field_at(o->contact, MDR_DISPLACEMENT, MDR_DEPTH, 0.1, STATES, small_place, NEXT));
    CALL(field_at(o->contact, MDR_LINE_LOAD, MDR_DEPTH, 0.6, STATES, small_place, NEXT));
    CALL(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, QUICK, place, (const double[]){1.0, 3.0, 1.0, 0.5}, NEXT));
    CALL(mdr_closed_form(MDR_FORM_CONE_FORCE, QUICK, place, (const double[]){0.3, 3.0, 1.0, 0.5}, NEXT));
    CALL(mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, QUICK, place, (const double[]){1.0, 3.0, 1.0, 0.5, 0.1}, NEXT));
    CALL(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, QUICK, place, (const double[]){3.0, 0.5}, NEXT));
#ifdef MDRCONTACT_LATERAL_H
    CALL(mdr_structure_modulus(o->structure, EXACT, small_place, small_place, place, NEXT));
    CALL(mdr_lateral_density(QUICK, place, place, 0.3, v, v + QUICK));
#endif
    return failed + (mdr_set_threads(1) != MDR_SUCCESS);
}

static double *rows(void)
{
    double *space = malloc(sizeof(double) * OUTPUTS * QUICK);
    if (space == NULL) exit(EXIT_FAILURE);
    return space;
}

static void test_every_number_of_threads(const objects *o, const double *alone)
{
    const int counts[] = {2, 3, 0, 1000000};
    double *found = rows();

    for (int i = 0; i < 4; i++) {
        CHECK_INT(evaluate(o, counts[i], found), 0);
        CHECK_INT(memcmp(found, alone, sizeof(double) * OUTPUTS * QUICK), 0);
    }
    free(found);
}

/* Single points give these numbers too. */
static void test_one_by_one(const objects *o, const double *alone)
{
    double one, all[STATES];

    for (int i = 0; i < QUICK; i += 997) {
        CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, 1, &place[i], &one));
        CHECK_CLOSE(one, alone[7 * QUICK + i], 0.0);
        CHECK_SUCCESS(mdr_profile_values(o->profile, MDR_G, 1, &place[i], &one));
        CHECK_CLOSE(one, alone[2 * QUICK + i], 0.0);
        CHECK_SUCCESS(mdr_medium_values(o->medium, MDR_MODULUS, 1, &place[i], &one));
        CHECK_CLOSE(one, alone[4 * QUICK + i], 0.0);
    }
    /* in place */
    for (int i = 0; i < STATES; i++) all[i] = small_place[i];
    CHECK_SUCCESS(mdr_set_threads(2));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, STATES, all, all));
    CHECK_SUCCESS(mdr_set_threads(1));
    for (int i = 0; i < STATES; i++) {
        CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, 1, &small_place[i], &one));
        CHECK_CLOSE(all[i], one, 0.0);
    }
    CHECK_CLOSE(all[0], 0.0, 0.0);
    CHECK_SUCCESS(force_on_loading(o->contact, all));
    CHECK_INT(memcmp(all, alone + 11 * QUICK, sizeof all), 0);
    CHECK_SUCCESS(field_at(o->contact, MDR_PRESSURE, MDR_RADIUS, 1.0, STATES, small_place, all));
    CHECK_INT(memcmp(all, alone + 16 * QUICK, sizeof all), 0);
}

/* Of several bad entries the first is named, whichever thread meets one first; nothing is written. */
static void test_errors(const objects *o)
{
    double bad[STATES], out[STATES], x[STATES];

    for (int i = 0; i < STATES; i++) {
        bad[i] = i % 2 ? -1.0 - i : 0.5;
        x[i] = small_place[i];
    }
    bad[1] = 0.25;
    x[40] = 3.0;
    x[41] = 4.0;
    x[200] = -5.0;
    fill_untouched(STATES, out);
    for (int threads = 5; threads >= 0; threads--) {
        mdr_state states[STATES];

        CHECK_SUCCESS(mdr_set_threads(threads));
        CHECK_STATUS(columns_of(o->exact, MDR_DEPTH, STATES, bad, out, NULL, NULL, NULL), MDR_EUNREACHABLE,
                     "entry 4 of depth = -4");
        CHECK_STATUS(mdr_contact_states(o->contact, MDR_FORCE, MDR_ON_LOADING, STATES, bad, states), MDR_EUNREACHABLE,
                     "entry 4 of force = -4");
        CHECK_STATUS(field_at(o->exact, MDR_PRESSURE, MDR_RADIUS, 1.0, STATES, x, out), MDR_EDOMAIN, "r = 3:");
        CHECK_STATUS(mdr_weight(MDR_WEIGHT_I0, 0.3, STATES, bad, out), MDR_EINVALID, "entry 4 of xi");
#ifdef MDRCONTACT_LATERAL_H
        CHECK_STATUS(mdr_structure_modulus(o->structure, EXACT, x, x, bad, out), MDR_EINVALID, "a = -4:");
#endif
        CHECK_STATUS(mdr_set_threads(-1), MDR_EINVALID, "threads = -1: it must be");
    }
    CHECK_SUCCESS(mdr_set_threads(1));
    CHECK_UNTOUCHED(STATES, out);
}

typedef struct caller {
    const objects *o;
    int threads, failed;
    double *found;
} caller;

static void *call(void *argument)
{
    caller *c = argument;
    c->failed = evaluate(c->o, c->threads, c->found);
    return NULL;
}

static void test_callers_with_threads(const objects *o, const double *alone, int threads)
{
    pthread_t id[CALLERS];
    caller callers[CALLERS];

    for (int i = 0; i < CALLERS; i++) {
        callers[i] = (caller){o, threads, -1, rows()};
        CHECK_INT(pthread_create(&id[i], NULL, call, &callers[i]), 0);
    }
    for (int i = 0; i < CALLERS; i++) {
        CHECK_INT(pthread_join(id[i], NULL), 0);
        CHECK_INT(callers[i].failed, 0);
        CHECK_INT(memcmp(callers[i].found, alone, sizeof(double) * OUTPUTS * QUICK), 0);
        free(callers[i].found);
    }
}

#ifdef _OPENMP
#ifdef MDRCONTACT_LATERAL_H
/* A structure's function records on which thread and at which level it is called. */
static int material(double x, double y, double z, double *E, double *nu, void *context)
{
    (void)x, (void)y, (void)z;
    if (omp_get_thread_num() != *(int *)context || omp_get_level() > 1) return 1;
    *E = 3.0;
    *nu = 0.3;
    return 0;
}
#endif

/* Within a parallel region nothing is shared out again, whatever is set and even where the runtime would allow it. */
static void test_callers_with_openmp(const objects *o, const double *alone)
{
    int failed = 0, different = 0;

    omp_set_max_active_levels(3);
#pragma omp parallel num_threads(CALLERS) reduction(+ : failed, different)
    {
        double *found = rows();
        failed += evaluate(o, 4, found);
        different += memcmp(found, alone, sizeof(double) * OUTPUTS * QUICK) != 0;
        free(found);
    }
    omp_set_max_active_levels(1);
    CHECK_INT(failed, 0);
    CHECK_INT(different, 0);
#ifdef MDRCONTACT_LATERAL_H
    /* a user's function is called on the caller's thread */
    int one = 0;
    double E[4], a[4] = {1.0, 2.0, 3.0, 4.0};
    mdr_structure *field = NULL;
    CHECK_SUCCESS(mdr_structure_function(material, &one, 0.3, NULL, &field));
    CHECK_SUCCESS(mdr_set_threads(4));
    CHECK_SUCCESS(mdr_structure_modulus(field, 4, a, a, a, E));
    CHECK_SUCCESS(mdr_set_threads(1));
    CHECK_CLOSE(E[3], 3.0 / (1.0 - 0.09), 1e-9);
    CHECK_FREE(field);
#endif
}
#endif

/* With an argument: callers with threads of their own alone, each call on one, for checkers that do not know OpenMP. */
int main(int argc, char **argv)
{
    objects o = {0};
    double *alone = rows();

    (void)argv;
    make(&o);
    CHECK_INT(evaluate(&o, 1, alone), 0);
    if (argc > 1) {
        test_callers_with_threads(&o, alone, 1);
    } else {
        test_every_number_of_threads(&o, alone);
        test_one_by_one(&o, alone);
        test_errors(&o);
#ifdef _OPENMP
        test_callers_with_openmp(&o, alone);
#endif
        /* last: OpenMP's threads, which stay, would take over the stacks of these, which then look lost to valgrind */
        test_callers_with_threads(&o, alone, 2);
    }
    end(&o);
    free(alone);
    return check_report("batches");
}
