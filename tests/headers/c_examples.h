/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The objects that the examples in the headers share, and their creation. */
#ifndef C_EXAMPLES_H
#define C_EXAMPLES_H

#include <mdrcontact/all.h>
#include <mdrcontact_law.h>
#include <mdrcontact_plastic_law.h>

#include <stdio.h>
#include <stdlib.h>

static mdr_profile *ball, *punch;
static mdr_material *gel;
static mdr_layer oxide, silicon, rubber;
static mdr_body *film, *soft, *relaxing_body;
static mdr_response *response;
static mdr_medium *medium, *soft_medium, *relaxing_medium;
static mdr_contact *contact, *sticky, *relaxing, *cohesive, *punch_contact;
static mdr_state state;
static mdr_load *load;
static mdr_loop *loop;
static mdr_friction *friction;
static mdr_shear *shear;
static mdr_friction_history *friction_history;
static mdr_law *law, *friction_law, *conducting_law;
static mdr_law_view view;
static mdr_rate *rate;
static mdr_rate_options rate_options;
static mdr_wear *wear, *punch_wear;
static mdr_imprint *imprint;
static mdr_plastic_law *plastic_law;
static mdr_plastic_view plastic_view;
static double plastic_numbers[20000];
static mdr_overload *rule;
static mdr_cap *cap;
static mdr_wear_history *wear_history;
static mdr_conduction *conduction;
static mdr_poroelastic *poroelastic;
static mdr_structure *structure;
static mdr_fit_problem problem;
static mdr_fit_parameter parameters[40];
static int free_parameter;
static double x[20], y[20];

static int parabola(double r, double *f, void *context)
{
    (void)context;
    *f = r * r / 2e-5;
    return 0;
}

static int stiffness(double z, double *E, void *context)
{
    (void)context;
    *E = 200e9 + 1e16 * z;
    return 0;
}

static int poisson(double z, double *nu, void *context)
{
    (void)z;
    (void)context;
    *nu = 0.3;
    return 0;
}

static int field(double at_x, double at_y, double z, double *E, double *nu, void *context)
{
    (void)at_y;
    (void)z;
    (void)context;
    *E = 3e9 + 1e14 * at_x * at_x / 1e-6;
    *nu = 0.35;
    return 0;
}

/* The contacts. */
static int make_contacts(void)
{
    const double depth = 50e-9, G = 500.0, relaxation = 1.0;
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    mdr_layer slow = MDR_SIZED(mdr_layer);
    mdr_body *half_space = NULL;
    mdr_medium *under = NULL;
    oxide = mdr_isotropic(72e9, 0.17, 500e-9);
    silicon = mdr_isotropic(163e9, 0.22, 0.0);
    rubber = mdr_isotropic(2e6, 0.5, 0.0);
    options.work_of_adhesion = 0.05;
    int failed = mdr_profile_paraboloid(10e-6, &ball) || mdr_profile_flat_punch(5e-6, &punch)
        || mdr_body_layered(1, &oxide, &silicon, NULL, &film) || mdr_medium_new(film, NULL, &medium)
        || mdr_contact_new(ball, medium, NULL, &contact)
        || mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, 1, &depth, &state)
        || mdr_contact_load(contact, &state, &load)
        || mdr_body_layered(0, NULL, &rubber, NULL, &soft) || mdr_medium_new(soft, NULL, &soft_medium)
        || mdr_contact_new(ball, soft_medium, &options, &sticky)
        || mdr_loop_new(sticky, MDR_DEPTH, 1e-6, 20, 0.0, &loop)
        || mdr_contact_new(punch, soft_medium, NULL, &punch_contact)
        || mdr_material_viscoelastic(1e3, 1, &G, &relaxation, 0.0, 0.5, 0.0, &gel);
    slow.thickness = 4e-6;
    slow.material = gel;
    options.work_of_adhesion = 1e-4;
    options.cohesive_stress = 300.0;
    failed = failed || mdr_body_layered(1, &slow, NULL, NULL, &relaxing_body)
        || mdr_medium_new(relaxing_body, NULL, &relaxing_medium) || mdr_contact_new(ball, relaxing_medium, NULL, &relaxing);
    slow.thickness = 0.0;
    failed = failed || mdr_body_layered(0, NULL, &slow, NULL, &half_space) || mdr_medium_new(half_space, NULL, &under)
        || mdr_contact_new(ball, under, &options, &cohesive);
    MDR_FREE(half_space);
    MDR_FREE(under);
    return failed;
}

/* A steel ball of 1 mm that yields, up to 10 um; and models of the coated body that yields. */
static int make_plastic(void)
{
    const double strain = 0.0, Y = 1e9, yield_stress[2] = {1e9, 4e9};
    mdr_yielding *steel = NULL;
    mdr_profile *large = NULL;
    const int failed = mdr_yielding_new(200e9, 0.3, 1, &strain, &Y, &steel) || mdr_profile_paraboloid(1e-3, &large)
        || mdr_plastic_law_new(large, steel, 10e-6, NULL, &plastic_law)
        || mdr_plastic_law_buffer(plastic_law, 20000, plastic_numbers)
        || mdr_plastic_view_at(plastic_numbers, plastic_numbers, &plastic_view)
        || mdr_overload_new(contact, 2, yield_stress, &rule) || mdr_cap_new(contact, 5e9, &cap);
    MDR_FREE(steel);
    MDR_FREE(large);
    return failed;
}

/* What is made of the contacts. */
static int make_others(void)
{
    const double k = 1e-16;
    const mdr_conductor metal = {0.0, 4e7, 4e7, 2.4e6, 0.0};
    mdr_law_options with_friction = MDR_SIZED(mdr_law_options), with_conduction = MDR_SIZED(mdr_law_options);
    int failed = mdr_response_new(film, 1e-8, &response) || mdr_friction_new(contact, 0.3, &friction)
        || mdr_shear_new(friction, load, MDR_ALONG, &shear)
        || mdr_friction_history_new(friction, 50e-9, 20, &friction_history) || mdr_law_new(contact, 50e-9, NULL, &law)
        || mdr_law_view_of(law, MDR_ON_UNLOADING, &view)
        || mdr_conduction_new(1, &metal, MDR_BASE_HALF_SPACE, 0, NULL, MDR_BASE_HALF_SPACE, 0.0, 0.0, &conduction);
    with_friction.friction = friction;
    with_conduction.conduction = conduction;
    rate_options = MDR_SIZED(mdr_rate_options);
    rate_options.work = 0.05;
    rate_options.speed = 1e-7;
    rate_options.exponent = 0.6;
    rate_options.largest_radius = 20e-6;
    return failed || mdr_law_new(contact, 50e-9, &with_friction, &friction_law)
        || mdr_law_new(contact, 50e-9, &with_conduction, &conducting_law) || mdr_rate_new(sticky, &rate_options, &rate)
        || mdr_wear_new(contact, 1, &k, NULL, k, &wear) || mdr_wear_new(punch_contact, 1, &k, NULL, 0.0, &punch_wear)
        || mdr_imprint_two_terms(medium, 1e-6, 5e9, 2e9, 0.0, &imprint)
        || mdr_wear_history_new(wear, MDR_FORCE, 1e-3, NULL, &wear_history)
        || mdr_poroelastic_new(0.3, MDR_DRAINAGE_SURFACE, 0.0, NULL, &poroelastic)
        || mdr_structure_shapes(3e9, 0.35, 0, NULL, NULL, NULL, NULL, NULL, &structure) || make_plastic();
}

/* A fit of the modulus of the film to its own force-depth curve. */
static int make_problem(void)
{
    int count = 0;
    problem = MDR_SIZED(mdr_fit_problem);
    problem.profile = ball;
    problem.medium = medium;
    if (mdr_fit_parameters(&problem, 40, parameters, &count)) return 1;
    problem.parameters = parameters;
    problem.parameter_count = count;
    free_parameter = 1; /* layers[0].E, after indenter.radius */
    for (int i = 0; i < 20; i++) {
        if (mdr_law_force(law, MDR_ON_UNLOADING, 2e-9 * (i + 1), &y[i], NULL)) return 1;
        x[i] = 2e-9 * (i + 1);
        y[i] *= 1.0 + 1e-3 * (i % 3 - 1);
    }
    parameters[free_parameter].is_free = 1;
    return 0;
}

#endif
