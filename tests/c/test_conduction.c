/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conduction: closed forms, in place, refusals. */
#include "check.h"
#include "mdrcontact/conduction.h"

static const double PI = 3.14159265358979323846;
static const mdr_conductor HALF_SPACE = {0.0, 2.0, 8.0, 3.0, 0.0};

static void test_half_space(void)
{
    const double radius[2] = {1.5, 3.0}, omega[2] = {0.0, 1.0}, time[2] = {1.0, 1e-3}, r[2] = {0.0, 0.5}, z[2] = {0.0, 0.0};
    double conductance[2], slope[2], out[2], ahead[2];
    mdr_conduction *p = NULL;

    CHECK_SUCCESS(mdr_conduction_new(1, &HALF_SPACE, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, radius, conductance, slope));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(conductance[i], 16.0 * radius[i], 1e-13);
        CHECK_CLOSE(slope[i], 16.0, 1e-13);
    }
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, radius, NULL, NULL));
    memcpy(out, radius, sizeof out);
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, out, out, NULL));
    CHECK_CLOSE(out[1], conductance[1], 1e-15);
    CHECK_SUCCESS(mdr_conduction_field(p, MDR_FLUX, 1.5, MDR_BODY_LOWER, 1, 0.0, 2, r, NULL, out));
    CHECK_CLOSE(out[1], 8.0 / (PI * sqrt(1.5 * 1.5 - 0.25)), 1e-13);
    CHECK_SUCCESS(mdr_conduction_field(p, MDR_POTENTIAL, 1.5, MDR_BODY_LOWER, 1, 0.0, 2, r, z, out));
    CHECK_CLOSE(out[0], 1.0, 1e-13);
    CHECK_CLOSE(out[1], 1.0, 1e-13);
    CHECK_SUCCESS(mdr_conduction_admittance(p, MDR_CONDUCTANCE, 1.5, 2, omega, out, ahead));
    CHECK_CLOSE(out[0], conductance[0], 1e-13);
    CHECK_TRUE(ahead[0] == 0.0 && ahead[1] > 0.0 && out[1] > out[0]);
    CHECK_SUCCESS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, time, NULL, out));
    CHECK_TRUE(out[0] > conductance[0] && out[1] > out[0]);
    CHECK_SUCCESS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, (double[]){1.0, 1.0 + 1e8}, z, out));
    CHECK_TRUE(out[0] == 0.0 && out[1] == 0.0);
    CHECK_SUCCESS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, (double[]){1.0, 1.0 + 1e8}, r, out));
    CHECK_CLOSE(out[1], 0.5 * conductance[0], 1e-2);
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, time, r, out), MDR_EINVALID, "entry 2 of time");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, r, time, out), MDR_EINVALID, "given");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 2, (double[]){0.0, 1e-7}, r, out), MDR_EDOMAIN, "time");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.5, 1, NULL, r, out), MDR_ENULL, "time");
    CHECK_STATUS(mdr_conduction_follow(p, 7, 1.5, 2, (double[]){0.0, 1.0}, r, out), MDR_EINVALID, "answer = 7");
    CHECK_FREE(p);
    CHECK_TRUE(p == NULL);
}

static void test_pair(void)
{
    const double radius[1] = {1.0};
    const mdr_conductor film[2] = {{0.5, 1.0, 1.0, 0.0, 0.1}, {0.0, 5.0, 5.0, 0.0, 0.0}};
    double one, both, slope;
    mdr_conduction *p = NULL;

    CHECK_SUCCESS(mdr_conduction_new(2, film, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 1, radius, &one, &slope));
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_conduction_new(2, film, MDR_BASE_HALF_SPACE, 2, film, MDR_BASE_HALF_SPACE, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 1, radius, &both, &slope));
    CHECK_CLOSE(both, 0.5 * one, 1e-12);
    CHECK_FREE(p);
}

static void test_of_contact(void)
{
    const double E = 3.0, nu = 0.25, radius[1] = {0.3}, one = 1.0;
    double conductance, by_force, by_depth, rough, out[2], r[2] = {0.0, 0.1}, z[2] = {0.0, 0.2};
    mdr_conduction *p = NULL, *table = NULL;
    mdr_profile *ball = NULL;
    mdr_medium *body = NULL;
    mdr_contact *c = NULL;
    mdr_state state;
    mdr_friction_heat heat = {7.0, 7.0, 7.0, 7.0, 7.0, 7.0, 7.0};

    CHECK_SUCCESS(mdr_conduction_new(1, &HALF_SPACE, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &ball));
    CHECK_SUCCESS(new_homogeneous(E, nu, &body));
    CHECK_SUCCESS(mdr_contact_new(ball, body, NULL, &c));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, radius, &state));
    CHECK_SUCCESS(mdr_conduction_along(p, c, 1, &state, &conductance, &by_force, &by_depth));
    /* Barber: G = k 2 S/E*; d = a^2/R, F ~ a^3 */
    CHECK_CLOSE(conductance, state.stiffness * 8.0 * (1.0 - nu * nu) / E, 1e-10);
    CHECK_CLOSE(by_force, conductance / (3.0 * state.force), 1e-10);
    CHECK_CLOSE(by_depth, conductance / (2.0 * state.depth), 1e-10);
    CHECK_SUCCESS(mdr_conduction_heat(p, c, 1, &state, MDR_HEAT_SLIDING, 0.5, 0.0, &heat));
    CHECK_CLOSE(heat.total, 0.5 * state.force, 1e-10);
    CHECK_SUCCESS(mdr_conduction_heat(p, c, 0, NULL, MDR_HEAT_SLIDING, 0.5, 0.0, NULL));
    CHECK_STATUS(mdr_conduction_heat(p, c, -1, &state, MDR_HEAT_SLIDING, 0.5, 0.0, &heat), MDR_EINVALID, "n = -1");
    CHECK_CLOSE(heat.centre, 3.0 * heat.total / (8.0 * 4.0 * 0.3), 1e-10);
    CHECK_SUCCESS(mdr_conduction_heat_field(p, c, &state, MDR_HEAT_SLIDING, 0.5, MDR_BODY_LOWER, 1, 2, r, z, out));
    CHECK_CLOSE(out[0], heat.centre, 1e-8);
    CHECK_TRUE(out[1] > 0.0 && out[1] < out[0]);
    CHECK_SUCCESS(mdr_conduction_rough(p, c, &state, 1e3, &rough));
    /* so large a resistance lets everything through by itself: int p dA/kappa */
    CHECK_CLOSE(rough, state.force / 1e3, 1e-2);
    CHECK_SUCCESS(mdr_conduction_field(p, MDR_FLUX, 0.3, MDR_BODY_LOWER, 0, 1.0, 2, r, NULL, out));
    CHECK_TRUE(out[1] > out[0] && out[0] > 0.0);
    CHECK_SUCCESS(mdr_conduction_tabulate(p, 0.1, 0.5, 1e-8, &table));
    CHECK_SUCCESS(mdr_conduction_spot(table, 1, radius, out, out + 1));
    CHECK_CLOSE(out[0], conductance, 1e-8);
    CHECK_CLOSE(out[1], 16.0, 1e-6);
    CHECK_FREE(table);
    CHECK_STATUS(mdr_conduction_tabulate(p, 0.5, 0.1, 1e-8, &table), MDR_EINVALID, "largest_radius");
    CHECK_STATUS(mdr_conduction_tabulate(p, 0.1, 0.5, 1.0, &table), MDR_EINVALID, "tolerance");
    CHECK_STATUS(mdr_conduction_tabulate(p, 0.1, 0.5, 1e-8, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_conduction_along(p, c, 1, NULL, &conductance, NULL, NULL), MDR_ENULL, "states");
    CHECK_STATUS(mdr_conduction_along(p, NULL, 1, &state, &conductance, NULL, NULL), MDR_ENULL, "c");
    CHECK_STATUS(mdr_conduction_heat(p, c, 1, &state, 4, 0.5, 0.0, &heat), MDR_EINVALID, "motion = 4");
    CHECK_STATUS(mdr_conduction_heat(p, c, 1, &state, MDR_HEAT_MOVING, 0.5, 0.0, &heat), MDR_EINVALID, "speed = 0");
    CHECK_STATUS(mdr_conduction_heat(p, c, 1, &state, MDR_HEAT_SLIDING, -0.5, 0.0, &heat), MDR_EINVALID, "strength");
    CHECK_STATUS(mdr_conduction_heat(p, c, 1, NULL, MDR_HEAT_SLIDING, 0.5, 0.0, &heat), MDR_ENULL, "states");
    CHECK_STATUS(mdr_conduction_heat(p, c, 1, &state, MDR_HEAT_SLIDING, 0.5, 0.0, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_conduction_rough(p, c, &state, 0.0, &rough), MDR_EINVALID, "kappa = 0");
    /* k_s = 2 S under a perfect conductor, in a vacuum */
    CHECK_SUCCESS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 10.0, 0.0, 0.0, 1, &one, out));
    CHECK_CLOSE(out[0], 0.5 / (1.25 * 2.0 * 4.0 * 0.1 * pow(0.1, 0.95)), 1e-12);
    CHECK_SUCCESS(mdr_conduction_joint(p, c, &state, 1e4, 0.1, 10.0, 1e-3, 0.0, &rough));
    CHECK_TRUE(rough > 0.0 && rough < 1e-5 * conductance);
    CHECK_SUCCESS(mdr_conduction_joint(p, c, &state, 1e-13, 0.1, 10.0, 1e-3, 1e-13, &rough));
    CHECK_CLOSE(rough, conductance, 1e-7);
    CHECK_SUCCESS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 10.0, 0.0, 0.0, 0, NULL, NULL));
    CHECK_STATUS(mdr_conduction_joint_resistance(p, 1e-320, 0.1, 1e9, 0.0, 0.0, 1, &one, out), MDR_EDOMAIN, "double precision");
    CHECK_STATUS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 10.0, 0.0, 0.0, -1, &one, out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 10.0, 0.0, 0.0, 1, NULL, out), MDR_ENULL, "pressure");
    CHECK_STATUS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 2.0, 0.0, 0.0, 1, &one, out), MDR_EDOMAIN, "hardness = 2");
    CHECK_STATUS(mdr_conduction_joint_resistance(p, 0.5, 0.1, 10.0, 0.0, 1.0, 1, &one, out), MDR_EINVALID, "jump = 1");
    rough = 7.0;
    CHECK_STATUS(mdr_conduction_joint(p, c, &state, 0.5, 0.1, 1e-3, 0.0, 0.0, &rough), MDR_EDOMAIN, "hardness = 0.001");
    CHECK_STATUS(mdr_conduction_joint(p, c, &state, -0.5, 0.1, 10.0, 0.0, 0.0, &rough), MDR_EINVALID, "roughness = -0.5");
    CHECK_STATUS(mdr_conduction_joint(p, c, NULL, 0.5, 0.1, 10.0, 0.0, 0.0, &rough), MDR_ENULL, "state");
    CHECK_STATUS(mdr_conduction_joint(p, c, &state, 0.5, 0.1, 10.0, 0.0, 0.0, NULL), MDR_ENULL, "out");
    CHECK_CLOSE(rough, 7.0, 0.0);
    CHECK_STATUS(mdr_conduction_field(p, MDR_FLUX, 0.05, MDR_BODY_LOWER, 0, 1.0, 2, r, NULL, out), MDR_EDOMAIN,
                 "entry 2 of r");
    CHECK_STATUS(mdr_conduction_heat_field(p, c, &state, MDR_HEAT_SLIDING, 0.5, MDR_BODY_UPPER, 1, 2, r, z, out), MDR_EINVALID,
                 "body = 402 (upper): it must be 401 (lower)");
    CHECK_FREE(c);
    CHECK_FREE(body);
    CHECK_FREE(ball);
    CHECK_FREE(p);
}

static void test_refusals(void)
{
    const mdr_conductor bad = {1.0, -1.0, 1.0, 0.0, 0.0}, layer = {1.0, 1.0, 1.0, 1.0, 0.0};
    const double one[2] = {1.0, -1.0}, infinite[1] = {INFINITY};
    double out[2] = {7.0, 7.0}, more[2] = {7.0, 7.0};
    mdr_conduction *p = NULL;
    mdr_material *other = NULL;

    CHECK_STATUS(mdr_conduction_new(1, &bad, MDR_BASE_PERFECT, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "sigma = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_PERFECT, 1, &bad, MDR_BASE_HALF_SPACE, 0.0, 0.0, &p), MDR_EINVALID,
                 "sigma = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 4, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "base = 4");
    CHECK_STATUS(mdr_conduction_new(0, NULL, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "no layer");
    CHECK_STATUS(mdr_conduction_new(-1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_conduction_new(1, NULL, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p), MDR_ENULL, "lower");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 1, NULL, MDR_BASE_HALF_SPACE, 0.0, 0.0, &p), MDR_ENULL,
                 "upper");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, -1.0, 0.0, &p), MDR_EINVALID, "film = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, NAN, &p), MDR_EINVALID, "sink");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_INSULATING, 0, NULL, 0, 0.0, 2.0, &p), MDR_EDOMAIN, "sink = 2");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, NULL), MDR_ENULL, "out");
    CHECK_TRUE(p == NULL);
    CHECK_SUCCESS(mdr_conduction_new(1, &layer, MDR_BASE_INSULATING, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_STATUS(mdr_conduction_spot(p, 1, one, out, more), MDR_EINVALID, "sink");
    CHECK_STATUS(mdr_conduction_admittance(p, MDR_CONDUCTANCE, 1.0, 2, one, out, more), MDR_EINVALID, "entry 2 of omega");
    CHECK_STATUS(mdr_conduction_compliance(p, 1, one, infinite, out, more), MDR_EINVALID, "omega");
    CHECK_STATUS(mdr_conduction_compliance(p, 1, NULL, NULL, out, more), MDR_ENULL, "k");
    CHECK_STATUS(mdr_conduction_compliance(NULL, 1, one, NULL, out, more), MDR_ENULL, "p");
    CHECK_SUCCESS(mdr_conduction_compliance(p, 0, NULL, NULL, NULL, NULL));
    CHECK_STATUS(mdr_conduction_admittance(p, 6, 1.0, 1, one, out, more), MDR_EINVALID, "answer = 6");
    CHECK_STATUS(mdr_conduction_admittance(p, MDR_CONDUCTANCE, 1e4, 1, one, out, more), MDR_EDOMAIN, "omega");
    CHECK_STATUS(mdr_conduction_admittance(p, MDR_CONDUCTANCE, 1.0, 1, one, NULL, more), MDR_ENULL, "in_phase");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1e3, 1, one, NULL, out), MDR_EDOMAIN, "time");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.0, 2, one, NULL, out), MDR_EINVALID, "entry 2 of time");
    CHECK_STATUS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.0, 1, NULL, NULL, out), MDR_ENULL, "time");
    CHECK_SUCCESS(mdr_conduction_follow(p, MDR_CONDUCTANCE, 1.0, 0, NULL, NULL, NULL));
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_STATUS(mdr_conduction_spot(p, 2, one, out, more), MDR_EINVALID, "radius = -1");
    CHECK_STATUS(mdr_conduction_spot(p, -1, one, out, more), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_conduction_spot(NULL, 1, one, out, more), MDR_ENULL, "p");
    CHECK_STATUS(mdr_conduction_field(p, MDR_FLUX, 1.0, MDR_BODY_LOWER, 1, 0.0, 1, one, NULL, out), MDR_EDOMAIN, "r = 1");
    CHECK_STATUS(mdr_conduction_field(p, MDR_POTENTIAL, 1.0, MDR_BODY_LOWER, 1, 0.0, 1, one, NULL, out), MDR_ENULL, "z");
    CHECK_STATUS(mdr_conduction_field(p, 5, 1.0, MDR_BODY_LOWER, 1, 0.0, 1, one, one, out), MDR_EINVALID, "field = 5");
    CHECK_STATUS(mdr_conduction_field(p, MDR_POTENTIAL, 1.0, MDR_BODY_UPPER, 1, 0.0, 1, one, one, out), MDR_EINVALID,
                 "body = 402 (upper): it must be 401 (lower)");
    CHECK_STATUS(mdr_conduction_field(p, MDR_POTENTIAL, 1.0, MDR_BODY_LOWER, 2, 0.0, 1, one, one, out), MDR_EINVALID, "below = 2");
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &other));
    CHECK_STATUS(mdr_conduction_spot((mdr_conduction *)other, 1, one, out, more), MDR_EINVALID, "mdr_conduction");
    CHECK_FREE(other);
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_TRUE(out[0] == 7.0 && out[1] == 7.0 && more[0] == 7.0);
}

/* A conductance in time needs as many polynomials and waves as the radius has thicknesses. */
static void thin_surface_layer(void)
{
    const mdr_conductor film = {.thickness = 1e-3, .sigma = 2.0, .along = 2.0, .capacity = 1.0};
    const mdr_conductor film_and_base[2] = {film, HALF_SPACE};
    const double time = 10.0;
    double out = 7.0;
    mdr_conduction *p = NULL;

    CHECK_SUCCESS(mdr_conduction_new(2, film_and_base, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_STATUS(mdr_conduction_follow(p, MDR_RESISTANCE, 3.0, 1, &time, NULL, &out), MDR_EDOMAIN, "3000 thicknesses");
    CHECK_TRUE(out == 7.0);
    CHECK_SUCCESS(mdr_conduction_follow(p, MDR_RESISTANCE, 0.1, 1, &time, NULL, &out));
    CHECK_FREE(p);
}

int main(void)
{
    test_half_space();
    test_pair();
    test_of_contact();
    test_refusals();
    thin_surface_layer();
    return check_report("conduction");
}
