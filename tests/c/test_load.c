/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The load of a state: what is refused, that it outlives its contact, and that threads may share it and free it. */
#include "check.h"

#include <pthread.h>

enum { THREADS = 4, ROUNDS = 200, POINTS = 5 };

static const double places[POINTS] = {0.0, 0.2, 0.5, 0.8, 0.99};

static mdr_contact *on_film(mdr_state *state)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    CHECK_SUCCESS(mdr_profile_rounded_cone(0.3, 0.2, &p));
    CHECK_SUCCESS(new_coated(3.0, 0.3, 1.0, 0.3, 0.5, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &(double){1.0}, state));
    MDR_FREE(p);
    MDR_FREE(m);
    return c;
}

static void refusals(void)
{
    mdr_state state, nowhere = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    mdr_contact *c = on_film(&state);
    mdr_load *load = NULL;
    double out[POINTS], r[1] = {0.5};
    mdr_shear *shear = NULL;
    mdr_friction *f = NULL;
    int count;

    CHECK_STATUS(mdr_contact_load(NULL, &state, &load), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_load(c, NULL, &load), MDR_ENULL, "state is NULL");
    CHECK_STATUS(mdr_contact_load(c, &state, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_contact_load(c, &nowhere, &load), MDR_EINVALID, "there is no contact");
    CHECK_TRUE(load == NULL);
    CHECK_SUCCESS(mdr_contact_load(c, &state, &load));
    CHECK_STATUS(mdr_contact_load((mdr_contact *)(void *)load, &state, &load), MDR_EINVALID, "not a handle of type mdr_contact");
    CHECK_STATUS(mdr_load_field(NULL, MDR_PRESSURE, 1, r, out), MDR_ENULL, "load is NULL");
    CHECK_STATUS(mdr_load_field((mdr_load *)(void *)c, MDR_PRESSURE, 1, r, out), MDR_EINVALID, "not a handle of type mdr_load");
    CHECK_STATUS(mdr_load_energy(NULL, out, out + 1), MDR_ENULL, "load is NULL");
    CHECK_STATUS(mdr_load_lowest_pressure((mdr_load *)(void *)c, out, out + 1), MDR_EINVALID, "not a handle of type mdr_load");
    CHECK_STATUS(mdr_load_interior(NULL, MDR_BODY_LOWER, MDR_SIDE_BELOW, 0.0, 0, NULL, NULL, NULL, NULL), MDR_ENULL,
                 "load is NULL");
    CHECK_STATUS(mdr_load_interior_error((mdr_load *)(void *)c, MDR_BODY_LOWER, out),
                 MDR_EINVALID, "not a handle of type mdr_load");
    CHECK_STATUS(mdr_load_layer_energies(NULL, MDR_BODY_LOWER, POINTS, out, &count), MDR_ENULL, "load is NULL");
    CHECK_STATUS(mdr_load_critical((mdr_load *)(void *)c, MDR_BODY_LOWER, 0.0, 0, NULL, &count),
                 MDR_EINVALID, "not a handle of type mdr_load");
    CHECK_SUCCESS(mdr_friction_new(c, 0.3, &f));
    CHECK_STATUS(mdr_shear_new(f, NULL, MDR_ALONG, &shear), MDR_ENULL, "load is NULL");
    CHECK_STATUS(mdr_shear_new(f, (mdr_load *)(void *)c, MDR_ALONG, &shear), MDR_EINVALID, "not a handle of type mdr_load");
    CHECK_TRUE(shear == NULL);
    CHECK_FREE(f);
    CHECK_FREE(load);
    CHECK_FREE(c);
}

/* Whatever is freed first: contact, or the one or other of its loads. */
static void outlives_its_contact(void)
{
    mdr_state state;
    mdr_contact *c = on_film(&state);
    mdr_load *first = NULL, *second = NULL;
    double before[POINTS], after[POINTS], beyond[2], lower, upper, again;

    CHECK_SUCCESS(mdr_contact_load(c, &state, &first));
    CHECK_SUCCESS(mdr_contact_load(c, &state, &second));
    CHECK_SUCCESS(mdr_load_field(first, MDR_PRESSURE, POINTS, places, before));
    CHECK_SUCCESS(mdr_load_field(first, MDR_DISPLACEMENT, 1, &(double){1.7}, beyond));
    CHECK_SUCCESS(mdr_load_energy(first, &lower, &upper));
    CHECK_FREE(first);
    CHECK_FREE(c);
    CHECK_SUCCESS(mdr_load_field(second, MDR_PRESSURE, POINTS, places, after));
    CHECK_SUCCESS(mdr_load_field(second, MDR_DISPLACEMENT, 1, &(double){1.7}, beyond + 1));
    CHECK_SUCCESS(mdr_load_energy(second, &again, NULL));
    for (int i = 0; i < POINTS; i++) CHECK_CLOSE(after[i], before[i], 0.0);
    CHECK_CLOSE(beyond[1], beyond[0], 0.0);
    CHECK_CLOSE(again, lower, 0.0);
    CHECK_FREE(second);
}

typedef struct task {
    mdr_load *load;
    const mdr_load *shared;
    double sum;
    int failed;
} task;

/* Reads the shared load, and frees its own one, whose contact is freed in another thread. */
static void *read_and_free(void *with)
{
    task *t = with;
    double p[POINTS];
    for (int i = 0; i < ROUNDS; i++) {
        t->failed += mdr_load_field(t->shared, MDR_PRESSURE, POINTS, places, p) != MDR_SUCCESS;
        for (int j = 0; j < POINTS; j++) t->sum += p[j];
    }
    t->failed += mdr_load_field(t->load, MDR_PRESSURE, POINTS, places, p) != MDR_SUCCESS;
    t->failed += mdr_free(t->load) != MDR_SUCCESS;
    return NULL;
}

static void is_shared_by_threads(void)
{
    mdr_state state;
    mdr_contact *c = on_film(&state);
    mdr_load *shared = NULL;
    task tasks[THREADS];
    pthread_t threads[THREADS];

    CHECK_SUCCESS(mdr_contact_load(c, &state, &shared));
    for (int i = 0; i < THREADS; i++) {
        tasks[i] = (task){NULL, shared, 0.0, 0};
        CHECK_SUCCESS(mdr_contact_load(c, &state, &tasks[i].load));
    }
    for (int i = 0; i < THREADS; i++) CHECK_TRUE(pthread_create(&threads[i], NULL, read_and_free, &tasks[i]) == 0);
    CHECK_FREE(c);
    for (int i = 0; i < THREADS; i++) {
        CHECK_TRUE(pthread_join(threads[i], NULL) == 0);
        CHECK_TRUE(tasks[i].failed == 0);
        CHECK_CLOSE(tasks[i].sum, tasks[0].sum, 0.0);
    }
    CHECK_FREE(shared);
}

int main(void)
{
    refusals();
    outlives_its_contact();
    is_shared_by_threads();
    return check_report("load");
}
