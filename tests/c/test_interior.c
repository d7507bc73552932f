/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stresses inside: refusals, Hertz on the axis, an interface, energies that are the work of the indenter. */
#include "check.h"

static mdr_contact *on_film(double work_of_adhesion)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work_of_adhesion;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(new_coated(450.0, 0.25, 1.0, 210.0, 0.3, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

static void refusals(void)
{
    const double r[2] = {0.0, 0.5}, z[2] = {0.1, 0.2}, negative[2] = {0.0, -0.5};
    mdr_interior out[2];
    mdr_contact *c = on_film(0.0), *sticky = on_film(1.0);
    const mdr_state nothing = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    mdr_state state, sticky_state;
    double energy[2], deviation;
    int count = -7;

    fill_untouched(18, &out[0].u_r);
    fill_untouched(2, energy);
    fill_untouched(1, &deviation);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(mdr_contact_states(sticky, MDR_RADIUS, 0, 1, &(double){1.0}, &sticky_state));
    CHECK_STATUS(state_interior(NULL, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, out), MDR_ENULL,
                 "c is NULL");
    CHECK_STATUS(state_interior(c, 3, &state, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, out), MDR_EINVALID, "body = 3");
    CHECK_STATUS(state_interior(c, MDR_BODY_UPPER, &state, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, out), MDR_EINVALID, "rigid");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, NULL, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, out), MDR_ENULL,
                 "state is NULL");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, 0, 0.0, 2, r, z, NULL, out), MDR_EINVALID, "side = 0");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, -0.1, 2, r, z, NULL, out), MDR_EINVALID,
                 "friction");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, NAN, 2, r, z, NULL, out), MDR_EINVALID,
                 "friction");
    CHECK_STATUS(state_interior(sticky, MDR_BODY_LOWER, &sticky_state, MDR_SIDE_BELOW, 0.1, 2, r, z, NULL, out),
                 MDR_EINVALID, "adhesion");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, -1, r, z, NULL, out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, NULL, z, NULL, out), MDR_ENULL,
                 "r is NULL");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, r, NULL, NULL, out), MDR_ENULL,
                 "z is NULL");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, NULL), MDR_ENULL,
                 "out is NULL");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, negative, z, NULL, out), MDR_EINVALID,
                 "-0.5");
    CHECK_STATUS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 2, r, negative, NULL, out), MDR_EINVALID,
                 "-0.5");
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 0, NULL, NULL, NULL, NULL));
    CHECK_UNTOUCHED(18, &out[0].u_r);
    CHECK_STATUS(state_interior_error(NULL, MDR_BODY_LOWER, &state, &deviation), MDR_ENULL, "c is NULL");
    CHECK_STATUS(state_interior_error(c, 3, &state, &deviation), MDR_EINVALID, "body = 3");
    CHECK_STATUS(state_interior_error(c, MDR_BODY_UPPER, &state, &deviation), MDR_EINVALID, "rigid");
    CHECK_STATUS(state_interior_error(c, MDR_BODY_LOWER, NULL, &deviation), MDR_ENULL, "state is NULL");
    CHECK_STATUS(state_interior_error(c, MDR_BODY_LOWER, &nothing, &deviation), MDR_EINVALID, "radius");
    CHECK_STATUS(state_interior_error(c, MDR_BODY_LOWER, &state, NULL), MDR_ENULL, "deviation is NULL");
    CHECK_UNTOUCHED(1, &deviation);
    CHECK_STATUS(state_layer_energies(NULL, MDR_BODY_LOWER, &state, 2, energy, &count), MDR_ENULL, "c is NULL");
    CHECK_STATUS(state_layer_energies(c, MDR_BODY_UPPER, &state, 2, energy, &count), MDR_EINVALID, "rigid");
    CHECK_STATUS(state_layer_energies(c, MDR_BODY_LOWER, NULL, 2, energy, &count), MDR_ENULL, "state is NULL");
    CHECK_STATUS(state_layer_energies(c, MDR_BODY_LOWER, &state, -1, energy, &count), MDR_EINVALID, "capacity = -1");
    CHECK_STATUS(state_layer_energies(c, MDR_BODY_LOWER, &state, 2, NULL, &count), MDR_ENULL, "out is NULL");
    CHECK_STATUS(state_layer_energies(c, MDR_BODY_LOWER, &state, 2, energy, NULL), MDR_ENULL, "count is NULL");
    CHECK_UNTOUCHED(2, energy);
    CHECK_INT(count, -7);
    CHECK_FREE(c);
    CHECK_FREE(sticky);
}

static void film_on_steel(void)
{
    const double r[3] = {0.0, 0.7, 0.7}, z[3] = {0.0, 0.0, 1.0}, angle[3] = {0.0, 0.0, 1.0};
    mdr_interior below[3], above[3];
    mdr_contact *c = on_film(0.0);
    mdr_state state;
    double energy[2], p;
    int count = 0;

    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 3, r, z, NULL, below));
    CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, 1, r, &p));
    CHECK_CLOSE(below[0].s_zz, -p, 1e-9 * p);
    CHECK_CLOSE(below[0].u_z, state.depth, 1e-9);
    /* the table tests/data/stress.csv */
    CHECK_CLOSE(below[1].s_rr, -159.396855810502, 3e-7);
    CHECK_CLOSE(below[1].s_tt, -184.130046715943, 3e-7);
    /* on either side of the interface Hooke's law of its own material gives the hoop strain u_r/r */
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_ABOVE, 0.0, 3, r, z, NULL, above));
    CHECK_CLOSE((above[2].s_tt - 0.25 * (above[2].s_rr + above[2].s_zz)) / 450.0, above[2].u_r / 0.7, 1e-8);
    CHECK_CLOSE((below[2].s_tt - 0.3 * (below[2].s_rr + below[2].s_zz)) / 210.0, below[2].u_r / 0.7, 1e-8);
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.3, 3, r, z, angle, below));
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_ABOVE, 0.3, 3, r, z, angle, above));
    CHECK_CLOSE(above[2].s_tz, below[2].s_tz, 1e-10);
    CHECK_TRUE(fabs(above[2].s_rr - below[2].s_rr) > 1.0);
    CHECK_SUCCESS(state_layer_energies(c, MDR_BODY_LOWER, &state, 2, energy, &count));
    CHECK_INT(count, 2);
    CHECK_CLOSE(energy[0], 111.699225670, 1e-6);
    CHECK_CLOSE(energy[1], 180.488912439, 1e-6);
    CHECK_FREE(c);
}

/* A state whose depth belongs to another one does not fit its surface, by as much. */
static void deviation_from_the_surface(void)
{
    mdr_contact *c = on_film(0.0), *sticky = on_film(1.0);
    mdr_state state;
    double deviation;

    CHECK_SUCCESS(mdr_contact_states(sticky, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(state_interior_error(sticky, MDR_BODY_LOWER, &state, &deviation));
    CHECK_TRUE(deviation < 1e-12);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(state_interior_error(c, MDR_BODY_LOWER, &state, &deviation));
    CHECK_TRUE(deviation < 1e-12);
    state.depth *= 1.001;
    CHECK_SUCCESS(state_interior_error(c, MDR_BODY_LOWER, &state, &deviation));
    CHECK_CLOSE(deviation, 0.001 / 1.001, 1e-9);
    CHECK_FREE(c);
    CHECK_FREE(sticky);
}

/* Two equal bodies: friction drags the upper one the other way, as the lower one seen from the other side. */
static void friction_on_both_bodies(void)
{
    const double r = 0.7, z = 0.2;
    mdr_interior upper, lower, ahead;
    mdr_profile *p = NULL;
    mdr_medium *m = NULL, *both = NULL;
    mdr_contact *c = NULL;
    mdr_state state;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &m));
    CHECK_SUCCESS(mdr_medium_pair(m, m, &both));
    CHECK_SUCCESS(mdr_contact_new(p, both, NULL, &c));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(state_interior(c, MDR_BODY_UPPER, &state, MDR_SIDE_BELOW, 0.3, 1, &r, &z, &(double){0.0}, &upper));
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.3, 1, &r, &z, &(double){acos(-1.0)}, &lower));
    CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.3, 1, &r, &z, &(double){0.0}, &ahead));
    CHECK_CLOSE(upper.s_rr, lower.s_rr, 1e-12);
    CHECK_CLOSE(upper.s_rz, lower.s_rz, 1e-12);
    CHECK_CLOSE(upper.u_r, lower.u_r, 1e-12);
    CHECK_TRUE(fabs(upper.s_rr - ahead.s_rr) > 0.05 * fabs(upper.s_rr));
    CHECK_FREE(c);
    CHECK_FREE(both);
    CHECK_FREE(m);
    CHECK_FREE(p);
}

int main(void)
{
    refusals();
    film_on_steel();
    deviation_from_the_surface();
    friction_on_both_bodies();
    return check_report("interior");
}
