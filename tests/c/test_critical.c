/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest stresses inside and the loads at first failure: Hertz, a film, lists, refusals. */
#include "check.h"

static mdr_contact *ball_on(mdr_medium *m, double work_of_adhesion)
{
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);

    options.work_of_adhesion = work_of_adhesion;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

static mdr_contact *on_steel(void)
{
    mdr_medium *m = NULL;
    CHECK_SUCCESS(new_homogeneous(210.0, 0.3, &m));
    return ball_on(m, 0.0);
}

static mdr_contact *on_film(double work_of_adhesion)
{
    mdr_medium *m = NULL;
    CHECK_SUCCESS(new_coated(450.0, 0.25, 1.0, 210.0, 0.3, MDR_MODEL_EXACT, NULL, &m));
    return ball_on(m, work_of_adhesion);
}

static mdr_state at_radius(const mdr_contact *c, double radius)
{
    mdr_state state;
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &radius, &state));
    return state;
}

/* In units of the largest pressure, at nu = 0.3 (Johnson, Contact Mechanics, 4.2, with more digits). */
static void hertz(void)
{
    mdr_contact *c = on_steel();
    const mdr_state state = at_radius(c, 0.1);
    const double p = 1.5 * state.force / (acos(-1.0) * 0.01);
    mdr_maximum found[4];
    int count;

    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.0, 4, found, &count));
    CHECK_INT(count, 4);
    CHECK_INT(found[0].quantity, MDR_VON_MISES);
    CHECK_CLOSE(found[0].value, 2.0 * 0.3100205020 * p, 1e-9);
    CHECK_INT(found[1].quantity, MDR_TRESCA);
    CHECK_CLOSE(found[1].value, 0.3100205020 * p, 1e-9);
    CHECK_CLOSE(found[1].z, 0.04808645, 1e-4);
    CHECK_CLOSE(found[1].r + 1.0, 1.0, 1e-6);
    CHECK_INT(found[2].quantity, MDR_TENSION);
    CHECK_INT(found[3].quantity, MDR_FREE_SURFACE_TENSION);
    CHECK_CLOSE(found[3].value, 0.4 / 3.0 * p, 1e-12);
    CHECK_CLOSE(found[3].r, 0.1, 1e-12);
    CHECK_CLOSE(found[3].z, 0.0, 0.0);
    CHECK_FREE(c);
}

/* The von Mises stress is Y at p = 1.6129... Y, a = pi p R/(2 E*) and F = (pi p)^3 R^2/(6 E*^2): Hertz's own. */
static void hertz_yields(void)
{
    const double yield = 2.0, p = yield / (2.0 * 0.3100205020), modulus = 210.0 / 0.91;
    const mdr_strength strengths[2] = {{MDR_TRESCA, 0, 1.01}, {MDR_VON_MISES, 0, 2.0}};
    mdr_contact *c = on_steel();
    mdr_failure_load found[2];
    int count = 0;

    CHECK_SUCCESS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 2, strengths, 2, found, &count));
    CHECK_INT(count, 2);
    CHECK_INT(found[0].quantity, MDR_VON_MISES);
    CHECK_CLOSE(found[0].strength, yield, 0.0);
    CHECK_CLOSE(found[0].value, yield, 1e-8);
    CHECK_CLOSE(found[0].radius, acos(-1.0) * p / (2.0 * modulus), 1e-8);
    CHECK_CLOSE(found[0].force, pow(acos(-1.0) * p, 3) / (6.0 * modulus * modulus), 1e-7);
    CHECK_INT(found[1].quantity, MDR_TRESCA);
    CHECK_CLOSE(found[1].force, pow(1.01, 3) * found[0].force, 1e-7);
    /* a strength that is not reached has no entry; what does not fit is left out */
    CHECK_SUCCESS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1e-3, 2, strengths, 2, found, &count));
    CHECK_INT(count, 0);
    fill_untouched(1, &found[1].depth);
    CHECK_SUCCESS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 2, strengths, 1, found, &count));
    CHECK_INT(count, 2);
    CHECK_UNTOUCHED(1, &found[1].depth);
    CHECK_FREE(c);
}

/* Each maximum is the stress that the field has at its place. */
static void film_under_friction(void)
{
    enum { MAXIMA = 9 };
    static const int quantities[MAXIMA] = {MDR_VON_MISES, MDR_TRESCA, MDR_TENSION, MDR_VON_MISES, MDR_TRESCA,
                                           MDR_TENSION, MDR_INTERFACE_SHEAR, MDR_INTERFACE_TENSION,
                                           MDR_FREE_SURFACE_TENSION};
    static const int places[MAXIMA] = {0, 0, 0, 1, 1, 1, 0, 0, 0};
    mdr_contact *c = on_film(0.0);
    const mdr_state state = at_radius(c, 1.0);
    mdr_maximum found[MAXIMA];
    int count = 0;

    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.3, 0, NULL, &count));
    CHECK_INT(count, MAXIMA);
    fill_untouched(1, &found[1].value);
    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.3, 1, found, &count));
    CHECK_INT(count, MAXIMA);
    CHECK_UNTOUCHED(1, &found[1].value);
    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.3, MAXIMA, found, &count));
    for (int i = 0; i < MAXIMA; i++) {
        const mdr_maximum *m = &found[i];
        const int side = places[i] ? MDR_SIDE_BELOW : MDR_SIDE_ABOVE;
        mdr_interior f;
        double mean, circle, mises;

        CHECK_INT(m->quantity, quantities[i]);
        CHECK_INT(m->place, places[i]);
        CHECK_SUCCESS(state_interior(c, MDR_BODY_LOWER, &state, side, 0.3, 1, &m->r, &m->z, &m->angle, &f));
        mean = 0.5 * (f.s_rr + f.s_zz);
        circle = hypot(0.5 * (f.s_rr - f.s_zz), f.s_rz);
        mises = sqrt(0.5 * (pow(f.s_rr - f.s_tt, 2) + pow(f.s_tt - f.s_zz, 2) + pow(f.s_zz - f.s_rr, 2)) + 3.0 * f.s_rz * f.s_rz);
        switch (m->quantity) {
        case MDR_VON_MISES: CHECK_CLOSE(m->value, mises, 1e-9); break;
        case MDR_TRESCA:
            CHECK_CLOSE(m->value, 0.5 * (fmax(mean + circle, f.s_tt) - fmin(mean - circle, f.s_tt)), 1e-9);
            break;
        case MDR_INTERFACE_SHEAR: CHECK_CLOSE(m->value, fabs(f.s_rz), 1e-9); break;
        case MDR_INTERFACE_TENSION: CHECK_CLOSE(m->value, f.s_zz, 1e-7); break;
        default: CHECK_CLOSE(m->value, fmax(mean + circle, f.s_tt), 1e-9);
        }
    }
    CHECK_CLOSE(found[6].z, 1.0, 0.0);
    CHECK_FREE(c);
}

/* Two equal bodies: friction drags the upper one the other way, so that its maxima lie on the other side. */
static void both_bodies(void)
{
    mdr_medium *m = NULL, *both = NULL;
    mdr_contact *c;
    mdr_state state;
    mdr_maximum lower[4], upper[4];
    int count = 0;

    CHECK_SUCCESS(new_homogeneous(210.0, 0.3, &m));
    CHECK_SUCCESS(mdr_medium_pair(m, m, &both));
    CHECK_FREE(m);
    c = ball_on(both, 0.0);
    state = at_radius(c, 0.1);
    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.3, 4, lower, &count));
    CHECK_SUCCESS(state_critical(c, MDR_BODY_UPPER, &state, 0.3, 4, upper, &count));
    for (int i = 0; i < 4; i++) {
        CHECK_CLOSE(upper[i].value, lower[i].value, 1e-9);
        CHECK_CLOSE(upper[i].angle + lower[i].angle, acos(-1.0), 1e-15);
    }
    /* tension opens cracks behind the indenter, which drags the lower body along +x */
    CHECK_CLOSE(lower[3].angle, acos(-1.0), 1e-15);
    CHECK_FREE(c);
}

/* The search says how far it is. */
static void progress(void)
{
    mdr_contact *c = on_steel();
    const mdr_state state = at_radius(c, 0.1);
    double part = 0.0;
    mdr_maximum found[4];
    int count;

    CHECK_SUCCESS(mdr_set_progress(&part));
    CHECK_SUCCESS(state_critical(c, MDR_BODY_LOWER, &state, 0.0, 4, found, &count));
    CHECK_CLOSE(part, 1.0, 0.0);
    CHECK_SUCCESS(mdr_set_progress(NULL));
    CHECK_FREE(c);
}

static void refusals(void)
{
    mdr_contact *c = on_film(0.0), *sticky = on_film(1.0), *bare = on_steel();
    const mdr_state state = at_radius(c, 1.0), sticky_state = at_radius(sticky, 1.0), nothing = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const mdr_strength good[1] = {{MDR_VON_MISES, 1, 1.0}};
    const mdr_strength bad[7] = {{0, 0, 1.0}, {7, 0, 1.0}, {MDR_VON_MISES, 2, 1.0}, {MDR_INTERFACE_SHEAR, 1, 1.0},
                                 {MDR_VON_MISES, -1, 1.0}, {MDR_VON_MISES, 0, NAN}, {MDR_VON_MISES, 0, 0.0}};
    static const char *const words[7] = {"quantity = 0", "quantity = 7", "number of layers is 2", "number of interfaces is 1",
                                         "place = -1", "value = NaN", "value = 0"};
    mdr_maximum out[9];
    mdr_failure_load found[2];
    int count = -7;

    fill_untouched(1, &out[0].value);
    fill_untouched(1, &found[0].depth);
    CHECK_STATUS(state_critical(NULL, MDR_BODY_LOWER, &state, 0.0, 9, out, &count), MDR_ENULL, "c is NULL");
    CHECK_STATUS(state_critical(c, 3, &state, 0.0, 9, out, &count), MDR_EINVALID, "body = 3");
    CHECK_STATUS(state_critical(c, MDR_BODY_UPPER, &state, 0.0, 9, out, &count), MDR_EINVALID, "rigid");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, NULL, 0.0, 9, out, &count), MDR_ENULL, "state is NULL");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &nothing, 0.0, 9, out, &count), MDR_EINVALID, "radius");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &state, -0.1, 9, out, &count), MDR_EINVALID, "friction = -0.1");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &state, NAN, 9, out, &count), MDR_EINVALID, "friction = NaN");
    CHECK_STATUS(state_critical(sticky, MDR_BODY_LOWER, &sticky_state, 0.1, 9, out, &count), MDR_EINVALID, "adhesion");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &state, 0.0, -1, out, &count), MDR_EINVALID, "capacity = -1");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &state, 0.0, 9, NULL, &count), MDR_ENULL, "out is NULL");
    CHECK_STATUS(state_critical(c, MDR_BODY_LOWER, &state, 0.0, 9, out, NULL), MDR_ENULL, "count is NULL");
    CHECK_STATUS(mdr_contact_first_failure(NULL, MDR_BODY_LOWER, 0.0, 1.0, 1, good, 2, found, &count), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_first_failure(c, 0, 0.0, 1.0, 1, good, 2, found, &count), MDR_EINVALID, "body = 0");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_UPPER, 0.0, 1.0, 1, good, 2, found, &count), MDR_EINVALID, "rigid");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, -0.1, 1.0, 1, good, 2, found, &count), MDR_EINVALID,
                 "friction = -0.1");
    CHECK_STATUS(mdr_contact_first_failure(sticky, MDR_BODY_LOWER, 0.1, 1.0, 1, good, 2, found, &count), MDR_EINVALID, "adhesion");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, -1.0, 1, good, 2, found, &count), MDR_EINVALID,
                 "largest_radius = -1");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, NAN, 1, good, 2, found, &count), MDR_EINVALID,
                 "largest_radius = NaN");
    CHECK_STATUS(mdr_contact_first_failure(bare, MDR_BODY_LOWER, 0.0, 0.0, 1, bad + 6, 2, found, &count), MDR_EINVALID,
                 "value = 0");
    CHECK_STATUS(mdr_contact_first_failure(bare, MDR_BODY_LOWER, 0.0, 0.0, 1, good, 2, found, &count), MDR_EINVALID,
                 "of layers is 1");
    CHECK_STATUS(mdr_contact_first_failure(bare, MDR_BODY_LOWER, 0.0, 0.0, 1, &(mdr_strength){MDR_VON_MISES, 0, 1.0}, 2, found,
                 &count),
                 MDR_EINVALID, "largest_radius");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, -1, good, 2, found, &count), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 0, NULL, 2, found, &count), MDR_EINVALID, "n = 0");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, NULL, 2, found, &count), MDR_ENULL, "strengths is NULL");
    for (int i = 0; i < 7; i++) {
        CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, bad + i, 2, found, &count), MDR_EINVALID, words[i]);
        CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, bad + i, 2, found, &count), MDR_EINVALID,
                     "entry 1 of strengths");
    }
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, good, -1, found, &count), MDR_EINVALID, "capacity = -1");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, good, 2, NULL, &count), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_contact_first_failure(c, MDR_BODY_LOWER, 0.0, 1.0, 1, good, 2, found, NULL), MDR_ENULL, "count is NULL");
    CHECK_UNTOUCHED(1, &out[0].value);
    CHECK_UNTOUCHED(1, &found[0].depth);
    CHECK_INT(count, -7);
    CHECK_FREE(c);
    CHECK_FREE(sticky);
    CHECK_FREE(bare);
}

int main(void)
{
    hertz();
    hertz_yields();
    film_under_friction();
    both_bodies();
    progress();
    refusals();
    return check_report("largest stresses");
}
