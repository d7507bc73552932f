/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Threads that share every object: the same numbers as one thread alone, and each thread its own error text. */
#include "check.h"
#include "mdrcontact/all.h"

#include <pthread.h>

enum { THREADS = 4, POINTS = 6, ROUNDS = 5, VALUES = 27 * POINTS };

#ifdef MDRCONTACT_PLASTIC_H
typedef struct plastic {
    mdr_profile *ball;
    mdr_medium *body;
    mdr_contact *contact;
    mdr_yielding *metal;
    mdr_plastic_law *law;
    mdr_imprint *imprint;
    mdr_overload *rule;
    mdr_cap *cap;
} plastic;
#endif

typedef struct task {
    const mdr_profile *profile;
    const mdr_medium *medium;
    const mdr_contact *contact;
    const mdr_material *material;
    const mdr_contact *relaxing;
    const mdr_friction *friction;
    const mdr_response *response;
#ifdef MDRCONTACT_POROELASTIC_H
    const mdr_poroelastic *pores;
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    const mdr_conduction *conduction;
#endif
#ifdef MDRCONTACT_PLASTIC_H
    const plastic *yields;
#endif
    int number;
    int failed_calls;
    int wrong_texts;
    double values[VALUES];
} task;

/* A path of a contact with friction, and of a copy that turns back half way, each owned by this thread. */
static int lead(const mdr_friction *friction, double *v)
{
    const double depth[POINTS] = {0.02, 0.05, 0.08, 0.06, 0.1, 0.01}, shift[POINTS] = {0.0, 0.01, 0.005, -0.01, 0.03, 0.0};
    mdr_friction_history *there = NULL, *back = NULL;
    mdr_state states[POINTS];
    mdr_shear_state out[POINTS];
    int failed = 0;

    failed += mdr_friction_history_new(friction, 0.1, 20, &there) != MDR_SUCCESS;
    for (int i = 0; i < POINTS; i++) {
        if (i == 3) failed += mdr_friction_history_copy(there, &back) != MDR_SUCCESS;
        failed += mdr_friction_history_advance(there, MDR_DEPTH, MDR_SHIFT, 1, depth + i, shift + i, states, out + i)
                  != MDR_SUCCESS;
        v[i] = out[i].tangential_force;
        v[POINTS + i] = out[i].dissipated_energy;
    }
    failed += mdr_free(there) != MDR_SUCCESS;
    failed += mdr_friction_history_advance(back, MDR_DEPTH, MDR_SHIFT, 2, depth, shift, states, out) != MDR_SUCCESS;
    failed += mdr_free(back) != MDR_SUCCESS;
    v[2 * POINTS] = out[1].tangential_force;
    v[3 * POINTS] = out[1].dissipated_energy;
    return failed;
}

#ifdef MDRCONTACT_PLASTIC_H
/* A law of all threads, whose memory this one has, and a sticky law of its own. */
static int load(const plastic *s, double *v)
{
    const double depth[POINTS] = {2e-6, 9e-6, 4e-6, 9.5e-6, -1e-6, 9e-6}, speed = 3e-7;
    double memory = 0.0;
    mdr_plastic_law *sticky = NULL, *large = NULL;
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    int failed = 0;

    for (int i = 0; i < POINTS; i++) {
        failed += mdr_plastic_law_advance(s->law, 1, depth + i, 0, &memory, v + i, v + POINTS + i, NULL) != MDR_SUCCESS;
        failed += mdr_plastic_law_energies(s->law, 1, depth + i, &memory, v + 2 * POINTS + i, v + 3 * POINTS + i) != MDR_SUCCESS;
    }
    v += 4 * POINTS;
    options.work_of_adhesion = 1e-15;
    failed += mdr_plastic_law_new(s->ball, s->metal, 1e-5, &options, &sticky) != MDR_SUCCESS;
    failed += mdr_plastic_law_loading(sticky, 2, depth, v, v + 2, NULL, NULL) != MDR_SUCCESS;
    failed += mdr_free(sticky) != MDR_SUCCESS;
    failed += mdr_plastic_law_with_radius(s->law, 2.0, &large) != MDR_SUCCESS;
    failed += mdr_plastic_law_loading(large, 1, depth, v + 4, NULL, NULL, NULL) != MDR_SUCCESS;
    failed += mdr_free(large) != MDR_SUCCESS;
    failed += mdr_plastic_law_restitution(s->law, 1.0, 1, &speed, v + 5) != MDR_SUCCESS;
    return failed;
}

/* Imprints, their contacts, the overload rule and a pressure cap. */
static int indent(const plastic *s, double *v)
{
    const double r[5] = {0.0, 0.1, 0.2, 0.3, 0.4}, p[5] = {0.9, 0.88, 0.82, 0.7, 0.5}, limit = 1.0, a = 0.2;
    mdr_profile *effective = NULL;
    mdr_contact *unloading = NULL;
    mdr_imprint *left = NULL;
    mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);
    mdr_overload_state loaded = {0};
    mdr_cap_state capped = {0};
    int failed = 0, layer;

    failed += mdr_imprint_profile(s->imprint, &effective) != MDR_SUCCESS;
    failed += mdr_contact_new(effective, s->body, NULL, &unloading) != MDR_SUCCESS;
    failed += columns_of(unloading, MDR_RADIUS, 3, r + 1, NULL, NULL, v, NULL) != MDR_SUCCESS;
    failed += mdr_free(unloading) != MDR_SUCCESS;
    failed += mdr_free(effective) != MDR_SUCCESS;
    failed += mdr_imprint_reverse_yield(s->imprint, 1, &limit, v + 3, &layer) != MDR_SUCCESS;
    failed += mdr_imprint_from_pressure(s->body, 5, r, p, 0.0, &left) != MDR_SUCCESS;
    failed += mdr_imprint_about(left, &facts) != MDR_SUCCESS;
    failed += mdr_free(left) != MDR_SUCCESS;
    v[4] = facts.recovered_work;
    failed += mdr_overload_states(s->rule, MDR_RADIUS, 1, &a, &loaded) != MDR_SUCCESS;
    failed += mdr_cap_states(s->cap, MDR_RADIUS, 1, &a, &capped) != MDR_SUCCESS;
    failed += mdr_cap_pressure(s->cap, a, 2, r, v + 8, v + 10) != MDR_SUCCESS;
    v[5] = loaded.depth;
    v[6] = capped.force;
    v[7] = capped.residual_depth;
    return failed;
}

static void make_plastic(plastic *s)
{
    const double strain = 0.0, stress = 1e-4, limit = 2.0;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &s->ball));
    CHECK_SUCCESS(new_homogeneous(72.0, 0.17, &s->body));
    CHECK_SUCCESS(mdr_contact_new(s->ball, s->body, NULL, &s->contact));
    CHECK_SUCCESS(mdr_yielding_new(1.0, 0.3, 1, &strain, &stress, &s->metal));
    CHECK_SUCCESS(mdr_plastic_law_new(s->ball, s->metal, 1e-5, NULL, &s->law));
    CHECK_SUCCESS(mdr_imprint_two_terms(s->body, 0.4, 0.5, 0.4, 0.0, &s->imprint));
    CHECK_SUCCESS(mdr_overload_new(s->contact, 1, &limit, &s->rule));
    CHECK_SUCCESS(mdr_cap_new(s->contact, 5.0, &s->cap));
}

static void free_plastic(plastic *s)
{
    CHECK_FREE(s->cap);
    CHECK_FREE(s->rule);
    CHECK_FREE(s->imprint);
    CHECK_FREE(s->law);
    CHECK_FREE(s->metal);
    CHECK_FREE(s->contact);
    CHECK_FREE(s->body);
    CHECK_FREE(s->ball);
}
#endif

/* Every evaluation there is, into task->values. */
static void evaluate(task *t)
{
    const double a[POINTS] = {1e-3, 0.05, 0.3, 0.8, 1.5, 3.0};
    double *v = t->values, d[POINTS], F[POINTS];
    int failed = 0;

    failed += mdr_profile_values(t->profile, MDR_HEIGHT, POINTS, a, v) != MDR_SUCCESS;
    failed += mdr_profile_values(t->profile, MDR_G, POINTS, a, v + POINTS) != MDR_SUCCESS;
    failed += mdr_medium_values(t->medium, MDR_MODULUS, POINTS, a, v + 2 * POINTS) != MDR_SUCCESS;
    failed += mdr_weight(MDR_WEIGHT_I0, 0.3, POINTS, a, v + 3 * POINTS) != MDR_SUCCESS;
    failed += columns_of(t->contact, MDR_RADIUS, POINTS, a, d, NULL, F, NULL) != MDR_SUCCESS;
    failed += columns_of(t->contact, MDR_DEPTH, POINTS, d, NULL, v + 4 * POINTS, NULL, NULL) != MDR_SUCCESS;
    failed += columns_of(t->contact, MDR_FORCE, POINTS, F, NULL, v + 5 * POINTS, NULL, NULL) != MDR_SUCCESS;
    failed += field_at(t->contact, MDR_PRESSURE, MDR_RADIUS, 3.0, POINTS, a, v + 6 * POINTS) != MDR_SUCCESS;
    failed += field_at(t->contact, MDR_DISPLACEMENT, MDR_RADIUS, 0.3, POINTS, a, v + 7 * POINTS) != MDR_SUCCESS;
    failed += mdr_material_values(t->material, MDR_RELAXATION, POINTS, a, v + 8 * POINTS, NULL) != MDR_SUCCESS;
#ifdef MDRCONTACT_TIME_H
    failed += mdr_contact_history(t->relaxing, MDR_DEPTH, 1e-5, POINTS, a, d, NULL, NULL, v + 9 * POINTS) != MDR_SUCCESS;
    failed += mdr_contact_dynamic_stiffness(t->relaxing, 1, a, a, v + 10 * POINTS, v + 10 * POINTS + 1) != MDR_SUCCESS;
#endif
    failed += lead(t->friction, v + 11 * POINTS);
    failed += mdr_response_point(t->response, POINTS, a, v + 25 * POINTS) != MDR_SUCCESS;
    failed += mdr_response_rectangle(t->response, 0.3, 0.2, POINTS, a, a, v + 26 * POINTS) != MDR_SUCCESS;
#ifdef MDRCONTACT_POROELASTIC_H
    failed += mdr_poroelastic_response(t->pores, MDR_RELAXATION, 1.0, 1.0, 1.0, POINTS, a, v + 15 * POINTS)
              != MDR_SUCCESS;
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    failed += mdr_conduction_spot(t->conduction, POINTS, a, v + 16 * POINTS, NULL) != MDR_SUCCESS;
    failed += mdr_conduction_follow(t->conduction, MDR_CONDUCTANCE, 0.3, 1, a, NULL, v + 17 * POINTS) != MDR_SUCCESS;
#endif
    t->failed_calls += failed;
}

/* What takes long, once for each thread. */
static void evaluate_once(task *t)
{
#ifdef MDRCONTACT_PLASTIC_H
    t->failed_calls += load(t->yields, t->values + 18 * POINTS);
    t->failed_calls += indent(t->yields, t->values + 23 * POINTS);
#else
    (void)t;
#endif
}

/* Fails on purpose with a number of its own and finds that number in its own text. */
static void fail(task *t)
{
    char expected[40];
    mdr_profile *p = NULL;

    snprintf(expected, sizeof expected, "radius = -%d: ", t->number);
    if (mdr_profile_paraboloid(-(double)t->number, &p) != MDR_EINVALID) t->wrong_texts++;
    evaluate(t);
    if (strstr(mdr_last_error(), expected) != mdr_last_error()) t->wrong_texts++;
}

static void *run(void *argument)
{
    task *t = argument;
    if (mdr_last_error()[0] != '\0') t->wrong_texts++; /* a new thread has not failed yet */
    for (int i = 0; i < ROUNDS; i++) fail(t);
    evaluate_once(t);
    return NULL;
}

/* With an argument: the exact medium instead of Gao's. */
int main(int argc, char **argv)
{
    const int model = argc > 1 ? MDR_MODEL_EXACT : MDR_MODEL_GAO;
    mdr_profile *profile = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL, *relaxing = NULL, *sheared = NULL;
    mdr_medium *film = NULL;
    mdr_friction *friction = NULL;
    const mdr_layer coating = mdr_isotropic(72.0, 0.17, 0.5), base = mdr_isotropic(165.0, 0.22, 0.0);
    mdr_body *body = NULL;
    mdr_response *response = NULL;
    mdr_material *material = NULL;
    mdr_medium *gel = NULL;
#ifdef MDRCONTACT_POROELASTIC_H
    mdr_poroelastic *pores = NULL;
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    mdr_conduction *conduction = NULL;
    const mdr_conductor layers[2] = {{0.5, 2.0, 2.0, 1.0, 0.1}, {0.0, 1.0, 1.0, 3.0, 0.0}};
#endif
    const double modulus = 2.0, relaxation_time = 0.5, thickness = 0.5;
    task alone = {0}, tasks[THREADS] = {{0}};
    pthread_t threads[THREADS];

    CHECK_SUCCESS(mdr_profile_rounded_cone(0.4, 0.35, &profile));
    CHECK_SUCCESS(new_coated(72.0, 0.17, 0.5, 165.0, 0.22, model, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(profile, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 1, &modulus, &relaxation_time, 0.0, 0.3, 0.0, &material));
    CHECK_SUCCESS(relaxing_medium(1, (const mdr_material *const[]){material}, &thickness, NULL, MDR_MODEL_EXACT, NULL,
                                          &gel));
    CHECK_SUCCESS(mdr_contact_new(profile, gel, NULL, &relaxing));
    CHECK_SUCCESS(new_coated(72.0, 0.17, 0.5, 165.0, 0.22, MDR_MODEL_EXACT, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(profile, film, NULL, &sheared));
    CHECK_SUCCESS(mdr_friction_new(sheared, 0.3, &friction));
    CHECK_SUCCESS(mdr_body_layered(1, &coating, &base, NULL, &body));
    CHECK_SUCCESS(mdr_response_new(body, 1e-8, &response));
    alone.response = response;
#ifdef MDRCONTACT_POROELASTIC_H
    CHECK_SUCCESS(mdr_poroelastic_new(0.2, MDR_DRAINAGE_SURFACE, 0.0, NULL, &pores));
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    CHECK_SUCCESS(mdr_conduction_new(2, layers, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &conduction));
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    alone.conduction = conduction;
#endif
#ifdef MDRCONTACT_PLASTIC_H
    plastic yields = {0};
    make_plastic(&yields);
    alone.yields = &yields;
#endif
    alone.friction = friction;
#ifdef MDRCONTACT_POROELASTIC_H
    alone.pores = pores;
#endif
    alone.material = material;
    alone.relaxing = relaxing;
    alone.profile = profile;
    alone.medium = medium;
    alone.contact = contact;
    for (int i = 0; i < THREADS; i++) {
        tasks[i] = alone;
        tasks[i].number = i + 1;
    }
    evaluate(&alone);
    evaluate_once(&alone);
    CHECK_INT(alone.failed_calls, 0);
    CHECK_TRUE(alone.values[13 * POINTS - 1] > 0.0);
    CHECK_STATUS(mdr_profile_paraboloid(-77.0, &profile), MDR_EINVALID, "radius = -77");

    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_create(&threads[i], NULL, run, &tasks[i]), 0);
    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_join(threads[i], NULL), 0);
    for (int i = 0; i < THREADS; i++) {
        CHECK_INT(tasks[i].failed_calls, 0);
        CHECK_INT(tasks[i].wrong_texts, 0);
        for (int j = 0; j < VALUES; j++) CHECK_CLOSE(tasks[i].values[j], alone.values[j], 0.0);
    }
    CHECK_FREE(response);
    CHECK_FREE(body);
    CHECK_FREE(contact);
    CHECK_FREE(relaxing);
#ifdef MDRCONTACT_POROELASTIC_H
    CHECK_FREE(pores);
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    CHECK_FREE(conduction);
#endif
#ifdef MDRCONTACT_PLASTIC_H
    free_plastic(&yields);
#endif
    CHECK_FREE(friction);
    CHECK_FREE(sheared);
    CHECK_FREE(film);
    CHECK_FREE(gel);
    CHECK_FREE(material);
    CHECK_FREE(medium);
    CHECK_FREE(profile);
    (void)argv;
    return check_report(argc > 1 ? "threads, exact medium" : "threads");
}
