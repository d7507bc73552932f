/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Calls that would take seconds to minutes are cancelled at the second question: each calls again before its end, at most
 * once a thread after the answer, writes nothing, and leaves its handles as they were. How long that took is printed, in processor
 * time.
 */
#include "check.h"
#include "mdrcontact/all.h"

#include <time.h>

enum { MANY = 1000000, ROWS = 400, BALLS = 40, POINTS = 400 };

enum { ANSWERED_AT = 2, MOST_AFTER = 2, DEPTHS = 12 };

/* When the function was last called, and cancelled; the longest time without a question; the number of questions. */
static double called, answered, longest_gap;
static int answers_no, questions;

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static int stop(void *context)
{
    const double now = seconds();
    if (now - called > longest_gap) longest_gap = now - called;
    called = now;
    questions++;
    if (*(const int *)context || questions < ANSWERED_AT) return 0;
    if (questions == ANSWERED_AT) answered = now;
    return 1;
}

static double in[MANY], out[MANY], radii[MANY];
static mdr_profile *cone;
static mdr_medium *deeply_graded;
static mdr_contact *exact, *plain, *rough, *sharp, *relaxing, *sticky, *on_film;
static mdr_friction *rubbed, *rubbed_film;
static mdr_friction_history *history, *rings;
#ifdef MDRCONTACT_LATERAL_H
static mdr_structure *balls, *voxels;
#endif
static mdr_medium *medium, *film;
static mdr_state pressed, normal[MANY / 10];
static mdr_shear_state sheared[MANY / 10];
static double sway[MANY], other[MANY], deep[POINTS];
static mdr_law *law;

static int states(void) { return columns_of(exact, MDR_FORCE, MANY, in, NULL, NULL, out, NULL); }
static int formula_states(void) { return columns_of(plain, MDR_FORCE, MANY, in, NULL, NULL, out, NULL); }
static int pressures(void) { return field_at(rough, MDR_PRESSURE, MDR_RADIUS, 1.0, MANY, radii, out); }
static int compiled(void) { return mdr_law_new(sharp, 1.0, NULL, &law); }
#ifdef MDRCONTACT_LATERAL_H
static int place(void) { return mdr_structure_modulus(balls, MANY, in, in, in + 1, out); }
static int cells(void) { return mdr_structure_modulus(voxels, MANY, in, in, in + 1, out); }
static int table(void) { return mdr_structure_medium(balls, 0.0, 0.0, 0.01, 10.0, 100000, &medium); }
#endif
#ifdef MDRCONTACT_POROELASTIC_H
static mdr_poroelastic *gel;
static int table_of_gel(void) { return mdr_poroelastic_new(0.3, MDR_DRAINAGE_SEALED, 4.0, out, &gel); }
#endif
static int torsion(void) { return mdr_medium_values(film, MDR_TORSIONAL_STIFFNESS, MANY, in, out); }
#ifdef MDRCONTACT_TIME_H
static int path(void)
{
    return mdr_contact_history(relaxing, MDR_DEPTH, 1e-9, MANY / 500, in + POINTS, sway, out, NULL, NULL);
}
#endif
#ifdef MDRCONTACT_ADHESION_H
static int sticky_path(void)
{
    const mdr_rate_state apart = {0};
    mdr_rate_state end;
    return mdr_contact_adhesive_history(sticky, MDR_DEPTH, 0.0, 1e-7, &apart, POINTS, in, deep, out, NULL, NULL, NULL,
                                        &end);
}
#endif
#ifdef MDRCONTACT_TIME_H
static int oscillation(void) { return mdr_contact_dynamic_stiffness(relaxing, MANY, in, in, out, other); }
#endif
static int rub(void) { return shear_states(on_film, rubbed_film, &pressed, MDR_ALONG, MDR_SHIFT, MANY / 10, sway, sheared); }
static int rub_in_turn(void) { return shear_loop(on_film, rubbed_film, &pressed, MDR_ALONG, MDR_SHIFT, 1e-3, MANY, out, other,
                                                 other); }
static int many_rings(void) { return mdr_friction_history_new(rubbed_film, 0.5, 1000, &rings); }
static int rub_along(void)
{
    return mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, MANY / 10, in, sway, normal, sheared);
}
static int inside(void)
{
    const mdr_state state = {0.5, 1.0, 1.0, 2.0, 0.0, 0.0};
    static double angles[MANY];
    static mdr_interior found[MANY];
    return state_interior(exact, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.1, MANY / 10, radii, in, angles, found);
}
static int failure(void)
{
    const mdr_strength strengths[2] = {{MDR_VON_MISES, 1, 1e9}, {MDR_INTERFACE_SHEAR, 0, 1e9}};
    mdr_failure_load found[2];
    int count;
    return mdr_contact_first_failure(on_film, MDR_BODY_LOWER, 0.2, 500.0, 2, strengths, 2, found, &count);
}

#ifdef MDRCONTACT_FIT_H
/* Force against depth of a cone on a graded body, E at three depths free. */
static int fit(void)
{
    enum { NUMBERS = 1 + 3 * DEPTHS + 10 };
    mdr_fit_problem problem;
    mdr_fit_parameter p[NUMBERS];
    double y[POINTS];

    problem = MDR_SIZED(mdr_fit_problem);
    problem.data_kind = MDR_FIT_FORCE_DEPTH;
    problem.profile = cone;
    problem.medium = deeply_graded;
    problem.any_units = 1;
    problem.parameters = p;
    mdr_fit_parameters(&problem, NUMBERS, p, &problem.parameter_count);
    for (int i = 0; i < DEPTHS; i++) p[2 + 3 * i].is_free = 1;
    for (int i = 0; i < POINTS; i++) y[i] = in[i] * in[i] * (3.0 + sin(7.0 * in[i]));
    return mdr_fit_solve(&problem, POINTS, in, y, NULL, NULL, NULL, NULL, NULL, NULL, NULL, out, NULL, NULL);
}
#endif

#ifdef MDRCONTACT_LATERAL_H
/* Many balls, and voxels of three phases. */
static void make_structures(const double E[3], const double nu[3])
{
    static const int size[3] = {ROWS, ROWS, 1};
    static const double spacing[3] = {0.05, 0.05, 0.1};
    static double shapes[7 * BALLS], shape_E[BALLS], shape_nu[BALLS];
    static int labels[ROWS * ROWS], kinds[BALLS];
    for (int i = 0; i < ROWS * ROWS; i++) labels[i] = (i * 7 + i / ROWS) % 3;
    for (int i = 0; i < BALLS; i++) {
        kinds[i] = MDR_SHAPE_BALL;
        shapes[7 * i] = sin(3.0 * i), shapes[7 * i + 1] = cos(5.0 * i), shapes[7 * i + 2] = 0.6 + 0.02 * i, shapes[7 * i + 3] = 0.5;
        shape_E[i] = 1.0 + 0.1 * i, shape_nu[i] = 0.3;
    }
    CHECK_SUCCESS(mdr_structure_shapes(1.0, 0.3, BALLS, kinds, shapes, shape_E, shape_nu, NULL, &balls));
    CHECK_SUCCESS(mdr_structure_voxels(size, labels, 3, E, nu, spacing, 1.0, 0.3, NULL, &voxels));
}
#endif

static void check_cancelled(const char *name, int (*call)(void))
{
    int status;
    fill_untouched(MANY, out);
    answers_no = questions = 0;
    called = seconds();
    answered = longest_gap = 0.0;
    status = call();
    printf("%s: called every %.0f ms at least, ended %.0f ms after the answer\n", name, 1e3 * longest_gap,
           1e3 * (seconds() - answered));
    CHECK_STATUS(status, MDR_ECANCELLED, "cancelled by the caller");
    CHECK_TRUE(questions >= ANSWERED_AT && questions <= ANSWERED_AT + MOST_AFTER);
    CHECK_UNTOUCHED(MANY, out);
}

int main(void)
{
    const double z[3] = {0.0, 0.5, 2.0}, E[3] = {1.0, 2.0, 5.0}, nu[3] = {0.3, 0.25, 0.2};
    double once;
    mdr_profile *p = NULL;
    double depths[DEPTHS], rising_E[DEPTHS], same_nu[DEPTHS];
    mdr_medium *graded = NULL, *half_space = NULL, *weighted = NULL, *soft = NULL, *rubber = NULL;
    mdr_contact_options ranged = MDR_SIZED(mdr_contact_options);
    mdr_material *fast = NULL, *slow = NULL;
    const mdr_material *layers[1];

    for (int i = 0; i < MANY; i++) in[i] = 0.001 + 2.0 * i / MANY;
    for (int i = 0; i < POINTS; i++) in[i] = 0.01 * (i + 1);
    for (int i = 0; i < MANY; i++) radii[i] = (double)i / MANY;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(mdr_profile_cone(0.3, &cone));
    CHECK_SUCCESS(medium_of_grades(3, z, E, nu, MDR_MODEL_EXACT, NULL, &graded));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &half_space));
    for (int i = 0; i < DEPTHS; i++) depths[i] = 0.3 * i, rising_E[i] = 1.0 + 0.3 * i, same_nu[i] = 0.3;
    CHECK_SUCCESS(medium_of_grades(DEPTHS, depths, rising_E, same_nu, MDR_MODEL_EXACT, NULL, &deeply_graded));
    CHECK_SUCCESS(medium_of_grades(3, z, E, nu, MDR_MODEL_GAO, NULL, &weighted));
    CHECK_SUCCESS(mdr_contact_new(p, graded, NULL, &exact));
    CHECK_SUCCESS(mdr_contact_new(p, half_space, NULL, &plain));
    CHECK_SUCCESS(mdr_contact_new(cone, weighted, NULL, &rough));
    CHECK_SUCCESS(mdr_contact_new(cone, graded, NULL, &sharp));
#ifdef MDRCONTACT_LATERAL_H
    make_structures(E, nu);
#endif

    for (int i = 0; i < MANY; i++) sway[i] = 1e-3 * sin(7.0 * i) * sin(7.0 * i);
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 1, (double[]){2.0}, (double[]){0.5}, 0.0, 0.5, 0.0, &fast));
    CHECK_SUCCESS(mdr_material_viscoelastic(0.6, 1, (double[]){0.4}, (double[]){2.0}, 0.0, 0.3, 0.0, &slow));
    layers[0] = fast;
    CHECK_SUCCESS(relaxing_medium(1, layers, (double[]){1.0}, slow, MDR_MODEL_EXACT, NULL, &soft));
    CHECK_SUCCESS(mdr_contact_new(p, soft, NULL, &relaxing));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, fast, MDR_MODEL_EXACT, NULL, &rubber));
    ranged.work_of_adhesion = 0.02, ranged.cohesive_stress = 0.5;
    CHECK_SUCCESS(mdr_contact_new(p, rubber, &ranged, &sticky));
    for (int i = 0; i < POINTS; i++) deep[i] = 0.3 * sin(in[i]);
    CHECK_SUCCESS(new_coated(2.0, 0.3, 0.5, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(p, film, NULL, &on_film));
    CHECK_SUCCESS(mdr_friction_new(plain, 0.3, &rubbed));
    CHECK_SUCCESS(mdr_friction_new(on_film, 0.3, &rubbed_film));
    CHECK_SUCCESS(mdr_friction_history_new(rubbed, 0.0, 0, &history));
    CHECK_SUCCESS(mdr_contact_states(on_film, MDR_DEPTH, MDR_ON_UNLOADING, 1, (double[]){0.3}, &pressed));

    CHECK_INT(mdr_set_cancel(stop, &answers_no), MDR_SUCCESS);
    check_cancelled("states", states);
    check_cancelled("states by formula", formula_states);
    check_cancelled("pressures", pressures);
    check_cancelled("law", compiled);
#ifdef MDRCONTACT_LATERAL_H
    check_cancelled("shapes", place);
    check_cancelled("voxels", cells);
    check_cancelled("table", table);
#endif
    check_cancelled("stresses", inside);
#ifdef MDRCONTACT_FIT_H
    check_cancelled("fit", fit);
#endif
    check_cancelled("torsion", torsion);
#ifdef MDRCONTACT_POROELASTIC_H
    check_cancelled("table of a gel", table_of_gel);
#endif
#ifdef MDRCONTACT_TIME_H
    check_cancelled("path in time", path);
#endif
#ifdef MDRCONTACT_ADHESION_H
    check_cancelled("path in time with a cohesive zone", sticky_path);
#endif
#ifdef MDRCONTACT_TIME_H
    check_cancelled("oscillations", oscillation);
#endif
    check_cancelled("first failure", failure);
    check_cancelled("tangential states", rub);
    check_cancelled("tangential loop", rub_in_turn);
    check_cancelled("rings", many_rings);
    check_cancelled("path with friction", rub_along);
    CHECK_TRUE(law == NULL && medium == NULL && rings == NULL);

    /* on two threads too; the handles are sound */
    CHECK_SUCCESS(mdr_set_threads(2));
    check_cancelled("states, two threads", states);
#ifdef MDRCONTACT_LATERAL_H
    check_cancelled("shapes, two threads", place);
#endif
#ifdef MDRCONTACT_POROELASTIC_H
    check_cancelled("table of a gel, two threads", table_of_gel);
    CHECK_TRUE(gel == NULL);
#endif
    CHECK_SUCCESS(mdr_set_threads(1));
    answers_no = 1;
    CHECK_SUCCESS(columns_of(exact, MDR_DEPTH, 1, in, NULL, NULL, out, NULL));
    once = out[0];
    CHECK_SUCCESS(mdr_set_cancel(NULL, NULL));
    CHECK_SUCCESS(columns_of(exact, MDR_DEPTH, 1, in, NULL, NULL, out, NULL));
    CHECK_CLOSE(out[0], once, 0.0);

    /* the contact with friction has not been loaded yet */
    CHECK_SUCCESS(mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, 1, (double[]){0.1}, (double[]){1e-3},
                                               normal, sheared));
    once = sheared[0].tangential_force;
    CHECK_FREE(history);
    CHECK_SUCCESS(mdr_friction_history_new(rubbed, 0.0, 0, &history));
    CHECK_SUCCESS(mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, 1, (double[]){0.1}, (double[]){1e-3},
                                               normal, sheared));
    CHECK_CLOSE(sheared[0].tangential_force, once, 0.0);

    CHECK_FREE(history);
    CHECK_FREE(rubbed_film);
    CHECK_FREE(rubbed);
    CHECK_FREE(on_film);
    CHECK_FREE(sticky);
    CHECK_FREE(relaxing);
    CHECK_FREE(rubber);
    CHECK_FREE(film);
    CHECK_FREE(soft);
    CHECK_FREE(slow);
    CHECK_FREE(fast);
#ifdef MDRCONTACT_LATERAL_H
    CHECK_FREE(voxels);
    CHECK_FREE(balls);
#endif
    CHECK_FREE(sharp);
    CHECK_FREE(rough);
    CHECK_FREE(plain);
    CHECK_FREE(exact);
    CHECK_FREE(weighted);
    CHECK_FREE(deeply_graded);
    CHECK_FREE(half_space);
    CHECK_FREE(graded);
    CHECK_FREE(cone);
    CHECK_FREE(p);
    return check_report("cancelled calls");
}
