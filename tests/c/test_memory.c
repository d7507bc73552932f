/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * No memory for a large array: MDR_ENOMEMORY, nothing written, nothing lost. This program brings its own malloc, which
 * refuses large requests while a switch is set; everything else goes on to the C library's.
 */
#include "check.h"
#include "mdrcontact/all.h"

void *__libc_malloc(size_t size);

static size_t largest_request = (size_t)-1;

void *malloc(size_t size)
{
    return size > largest_request ? NULL : __libc_malloc(size);
}

enum { COUNT = 200000, LARGE_TEXT = 300000, NUMBERS = 13 };

static double in[COUNT], out[COUNT];
static char large_text[LARGE_TEXT + 1];
#ifdef MDRCONTACT_LATERAL_H
static int labels[100 * 100 * 10];
#endif
static mdr_state states[COUNT];
static mdr_shear_state sheared[COUNT];

static void refuse_large_requests(void)
{
    largest_request = COUNT;
}

static void grant_all_requests(void)
{
    largest_request = (size_t)-1;
}

#ifdef MDRCONTACT_PLASTIC_H
typedef struct plastic {
    mdr_yielding *metal;
    mdr_plastic_law *law;
    mdr_overload *rule;
    mdr_cap *cap;
} plastic;

static void make_plastic(const mdr_profile *p, const mdr_contact *c, plastic *s)
{
    const double strain = 0.0, stress = 1e-2;

    CHECK_SUCCESS(mdr_yielding_new(1.0, 0.3, 1, &strain, &stress, &s->metal));
    CHECK_SUCCESS(mdr_plastic_law_new(p, s->metal, 0.01, NULL, &s->law));
    CHECK_SUCCESS(mdr_overload_new(c, 1, &stress, &s->rule));
    CHECK_SUCCESS(mdr_cap_new(c, 0.03, &s->cap));
}

/* Many points, and objects of many points. Memories stay as they are. */
static void check_plastic(const mdr_medium *m, const plastic *s)
{
    static double memory[COUNT], more[COUNT], force[COUNT];
    mdr_imprint *imprint = NULL;
    mdr_yielding *metal = NULL;
    mdr_plastic_law *law = NULL;
    mdr_overload *rule = NULL;

    for (int i = 0; i < COUNT; i++) {
        more[i] = 1.0;
        force[i] = 1.4 * in[i] * in[i];
    }
    CHECK_STATUS(mdr_imprint_from_pressure(m, COUNT, in, in, 0.0, &imprint), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_yielding_new(1.0, 0.3, COUNT, in, more, &metal), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_plastic_law_from_points(COUNT, in, force, in, memory, more, NULL, &law), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_plastic_law_restitution(s->law, 1.0, COUNT, in, out), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_plastic_law_loading(s->law, COUNT, in, out, more, NULL, NULL), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_plastic_law_energies(s->law, COUNT, in, memory, out, more), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_overload_states(s->rule, MDR_RADIUS, COUNT, in, (mdr_overload_state *)out), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_cap_states(s->cap, MDR_RADIUS, COUNT, in, (mdr_cap_state *)out), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_cap_pressure(s->cap, 0.01, COUNT, in, out, NULL), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_truncated_hertz(0.3, 1.0, 0.5, COUNT, in, out), MDR_ENOMEMORY, "memory");
    CHECK_TRUE(imprint == NULL && metal == NULL && law == NULL && rule == NULL);
    for (int i = 0; i < COUNT; i += 1000) CHECK_TRUE(memory[i] == 0.0);
}

static void free_plastic(plastic *s)
{
    CHECK_FREE(s->cap);
    CHECK_FREE(s->rule);
    CHECK_FREE(s->law);
    CHECK_FREE(s->metal);
}
#endif

int main(void)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_law *law = NULL;
    mdr_body *body = NULL;
    mdr_response *response = NULL;
    const mdr_layer film = mdr_isotropic(2.0, 0.3, 1.0), base = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_friction *friction = NULL;
    mdr_friction_history *path = NULL, *rings = NULL;
    mdr_medium *table = NULL, *relaxing = NULL;
    mdr_material *polymer = NULL;
    mdr_contact *in_time = NULL;
    const double modulus = 2.0, relaxation_time = 0.5;
    mdr_law_options law_options;
#ifdef MDRCONTACT_FIT_H
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
#endif

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    CHECK_SUCCESS(mdr_response_new(body, 1e-8, &response));
    CHECK_SUCCESS(mdr_friction_new(c, 0.3, &friction));
    CHECK_SUCCESS(mdr_friction_history_new(friction, 0.0, 0, &path));
    CHECK_SUCCESS(mdr_friction_history_advance(path, MDR_DEPTH, MDR_SHIFT, 1, &(double){0.01}, &(double){1e-3}, states,
                                               sheared));
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 1, &modulus, &relaxation_time, 0.0, 0.3, 0.0, &polymer));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, polymer, MDR_MODEL_EXACT, NULL, &relaxing));
    CHECK_SUCCESS(mdr_contact_new(p, relaxing, NULL, &in_time));
    for (int i = 0; i < COUNT; i++) in[i] = 1e-6 * (i + 1);
    fill_untouched(COUNT, out);
    memset(large_text, 'x', LARGE_TEXT);
    law_options = MDR_SIZED(mdr_law_options);
#ifdef MDRCONTACT_FIT_H
    problem = MDR_SIZED(mdr_fit_problem);
    problem.data_kind = MDR_FIT_FORCE_DEPTH;
    problem.profile = p;
    problem.medium = m;
    problem.parameters = parameters;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, NUMBERS, parameters, &problem.parameter_count));
#endif

#ifdef MDRCONTACT_PLASTIC_H
    plastic yields = {0};
    make_plastic(p, c, &yields);
#endif

    refuse_large_requests();
    void *volatile none = malloc(8 * COUNT); /* volatile: gcc 16 removes a malloc whose memory nobody uses */
    CHECK_TRUE(none == NULL);
    CHECK_STATUS(mdr_medium_values(m, MDR_MODULUS, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_medium_values(m, MDR_STIFFNESS, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, COUNT, in, (mdr_state *)out), MDR_ENOMEMORY,
                 "not enough memory");
    CHECK_STATUS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, COUNT, in, (mdr_state *)out), MDR_ENOMEMORY,
                 "not enough memory");
    CHECK_STATUS(mdr_contact_states(c, MDR_FORCE, MDR_ON_UNLOADING, COUNT, in, (mdr_state *)out), MDR_ENOMEMORY,
                 "not enough memory");
    CHECK_STATUS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 1.0, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(field_at(c, MDR_LINE_LOAD, MDR_RADIUS, 1.0, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(field_at(c, MDR_DISPLACEMENT, MDR_RADIUS, 1.0, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, COUNT, in, NULL, out, NULL), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_response_point(response, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_response_rectangle(response, 1.0, 1.0, COUNT, in, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_profile_values(p, MDR_HEIGHT, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_CONE_FORCE, COUNT, in, (const double[]){0.2, 1.0, 2.0, 1.0}, out), MDR_ENOMEMORY,
                 "not enough memory");
    CHECK_STATUS(mdr_material_values(polymer, MDR_RELAXATION, COUNT, in, out, NULL), MDR_ENOMEMORY, "not enough memory");
#ifdef MDRCONTACT_TIME_H
    CHECK_STATUS(mdr_contact_history(in_time, MDR_DEPTH, 1e-5, COUNT, in, in, NULL, NULL, out), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_contact_dynamic_stiffness(in_time, COUNT, in, in, out, out), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_contact_step_response(in_time, MDR_CREEP, 1.0, COUNT, in, out), MDR_ENOMEMORY, "not enough memory");
#endif
    CHECK_STATUS(shear_states(c, friction, states, MDR_ALONG, MDR_SHIFT, COUNT, in, sheared), MDR_ENOMEMORY, "memory");
    CHECK_STATUS(mdr_friction_history_advance(path, MDR_DEPTH, MDR_SHIFT, COUNT, in, in, states, sheared),
                 MDR_ENOMEMORY, "memory");
    for (int i = 0; i < COUNT; i += 1000) CHECK_CLOSE(out[i], untouched, 0.0);
    /* objects whose size the caller chooses */
    CHECK_STATUS(mdr_law_read(large_text, LARGE_TEXT, &law), MDR_ENOMEMORY, "not enough memory");
    law_options.description = large_text;
    CHECK_STATUS(mdr_law_new(c, 0.1, &law_options, &law), MDR_ENOMEMORY, "not enough memory");
    CHECK_STATUS(mdr_medium_table(COUNT, in, in, &table), MDR_ENOMEMORY, "not enough memory");
#ifdef MDRCONTACT_FIT_H
    CHECK_STATUS(mdr_fit_predict(&problem, COUNT, in, in, NULL, out, NULL), MDR_ENOMEMORY, "not enough memory");
#endif
#ifdef MDRCONTACT_LATERAL_H
    const int size[3] = {100, 100, 10};
    mdr_structure *voxels = NULL;
    CHECK_STATUS(mdr_structure_voxels(size, labels, 1, in + 1, in, in + 1, 1.0, 0.3, NULL, &voxels), MDR_ENOMEMORY, "memory");
    CHECK_TRUE(voxels == NULL);
#endif
#ifdef MDRCONTACT_PLASTIC_H
    check_plastic(m, &yields);
#endif
    CHECK_STATUS(mdr_friction_history_new(friction, 0.1, 1000, &rings), MDR_ENOMEMORY, "memory");
    CHECK_TRUE(rings == NULL && law == NULL && table == NULL);
    /* this needs no memory of the array's size */
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, 0.3, COUNT, in, out));
    grant_all_requests();

    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, COUNT, in, NULL, NULL, out, NULL));
    CHECK_CLOSE(out[COUNT - 1], 4.0 / 3.0 / 0.91 * pow(in[COUNT - 1], 3), 1e-12);
#ifdef MDRCONTACT_PLASTIC_H
    free_plastic(&yields);
#endif
    CHECK_FREE(response);
    CHECK_FREE(body);
    CHECK_FREE(path);
    CHECK_FREE(friction);
    CHECK_FREE(c);
    CHECK_FREE(in_time);
    CHECK_FREE(relaxing);
    CHECK_FREE(polymer);
    CHECK_FREE(m);
    CHECK_FREE(p);
    return check_report("memory");
}
