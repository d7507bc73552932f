/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Friction: Cattaneo and Mindlin, loops, fields, refusals. */
#include "check.h"

enum { POINTS = 9 };

static const double mu = 0.3, E = 210.0, nu = 0.3;

static mdr_contact *ball_on(mdr_medium *m)
{
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

static mdr_contact *on_half_space(void)
{
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_homogeneous(E, nu, &m));
    return ball_on(m);
}

static void partial_slip(void)
{
    mdr_contact *c = on_half_space();
    mdr_friction *f = NULL;
    mdr_state state;
    mdr_shear_state out[3], by_force;
    double limit, sliding, tau, p, q, line, x = 0.99, shifts[3], shift[POINTS], force[POINTS], dissipated;

    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &(double){1.0}, &state));
    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_ALONG, &sliding, &limit));
    CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_ALONG, NULL, NULL));
    CHECK_CLOSE(limit, mu * state.force, 1e-15);
    CHECK_CLOSE(sliding, mu * state.depth * (2.0 - nu) / (2.0 - 2.0 * nu), 1e-13);
    for (int i = 0; i < 3; i++) shifts[i] = i < 2 ? (0.5 - i) * sliding : 2.0 * sliding;
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 3, shifts, out));
    CHECK_CLOSE(out[0].tangential_force, limit * (1.0 - pow(0.5, 1.5)), 1e-12);
    CHECK_CLOSE(out[1].tangential_force, -out[0].tangential_force, 0.0);
    CHECK_CLOSE(out[0].stick_radius, sqrt(0.5), 1e-12);
    CHECK_CLOSE(out[2].tangential_force, limit, 1e-15);
    CHECK_CLOSE(out[0].sliding + 1.0, out[2].sliding, 0.0);
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_TANGENTIAL_FORCE, 1, &out[0].tangential_force, &by_force));
    CHECK_CLOSE(by_force.shift, 0.5 * sliding, 1e-12);
    CHECK_CLOSE(by_force.dissipated_energy, out[0].dissipated_energy, 1e-11);
    /* in the annulus of slip the traction is mu p, the line load mu q */
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_ALONG, &out[0], MDR_TRACTION, 1, &x, &tau));
    CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, 1, &x, &p));
    CHECK_CLOSE(tau, mu * p, 1e-12);
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_ALONG, &out[0], MDR_TANGENTIAL_LINE_LOAD, 1, &x, &line));
    CHECK_SUCCESS(state_field(c, MDR_LINE_LOAD, &state, 1, &x, &q));
    CHECK_CLOSE(line, mu * q, 1e-12);
    CHECK_SUCCESS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 0.5 * sliding, POINTS, shift, force, &dissipated));
    CHECK_CLOSE(dissipated, 4.0 * out[0].dissipated_energy, 1e-12);
    CHECK_CLOSE(shift[0], 0.5 * sliding, 1e-15);
    CHECK_CLOSE(shift[POINTS / 2], -0.5 * sliding, 1e-15);
    CHECK_CLOSE(force[POINTS / 2], -out[0].tangential_force, 1e-12);
    CHECK_CLOSE(force[POINTS - 1], out[0].tangential_force, 1e-12);
    for (int i = 0; i < POINTS / 2; i++) CHECK_CLOSE(force[i], -force[i + POINTS / 2], 1e-12);
    CHECK_FREE(f);
    CHECK_TRUE(f == NULL);
    CHECK_FREE(f);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(c);
}

static void refusals(void)
{
    mdr_medium *film = NULL, *modulus = NULL, *rigid = NULL;
    mdr_contact *c, *unknown;
    mdr_friction *f = NULL;
    mdr_state state, nowhere = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    mdr_shear_state out[2];
    double a[2] = {0.5, 1.0}, bad[2] = {0.5, NAN}, G[2], shift[POINTS], force[POINTS], dissipated;

    CHECK_SUCCESS(new_coated(700.0, 0.2, 1.0, E, nu, MDR_MODEL_EXACT, NULL, &film));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &modulus));
    CHECK_SUCCESS(rigid_medium(&rigid));
    fill_untouched(2, G);
    CHECK_STATUS(mdr_medium_values(NULL, MDR_TANGENTIAL_MODULUS, 2, a, G), MDR_ENULL, "m is NULL");
    CHECK_STATUS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, -1, a, G), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, 2, bad, G), MDR_EINVALID, "entry 2 of a");
    CHECK_STATUS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, 2, NULL, G), MDR_ENULL, "a is NULL");
    CHECK_STATUS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, 2, a, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_medium_values(modulus, MDR_TANGENTIAL_MODULUS, 2, a, G), MDR_EINVALID, "needs E and nu");
    CHECK_STATUS(mdr_medium_values(rigid, MDR_TANGENTIAL_MODULUS, 2, a, G), MDR_EINVALID, "rigid");
    CHECK_UNTOUCHED(2, G);
    CHECK_SUCCESS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, 0, NULL, NULL));
    CHECK_STATUS(mdr_medium_values(NULL, MDR_TORSIONAL_STIFFNESS, 2, a, G), MDR_ENULL, "m is NULL");
    CHECK_STATUS(mdr_medium_values(modulus, MDR_TORSIONAL_STIFFNESS, 2, a, G), MDR_EINVALID, "needs E and nu");
    CHECK_STATUS(mdr_medium_values(film, MDR_TORSIONAL_STIFFNESS, 2, bad, G), MDR_EINVALID, "entry 2 of a");
    CHECK_STATUS(mdr_medium_values(film, MDR_TORSIONAL_STIFFNESS, 2, a, NULL), MDR_ENULL, "out is NULL");
    CHECK_UNTOUCHED(2, G);
    CHECK_SUCCESS(mdr_medium_values(film, MDR_TORSIONAL_STIFFNESS, 2, a, G));
    /* between film and substrate */
    CHECK_TRUE(G[0] > 16.0 / 3.0 * E / (2.0 + 2.0 * nu) * pow(a[0], 3.0) && G[0] < 16.0 / 3.0 * 700.0 / 2.4 * pow(a[0], 3.0));
    fill_untouched(2, G);
    CHECK_SUCCESS(mdr_medium_values(film, MDR_TANGENTIAL_MODULUS, 2, a, a));
    CHECK_TRUE(a[0] > a[1]);
    CHECK_FREE(rigid);
    c = ball_on(film);
    unknown = ball_on(modulus);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &(double){1.0}, &state));
    CHECK_STATUS(mdr_friction_new(NULL, mu, &f), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_friction_new(c, 0.0, &f), MDR_EINVALID, "coefficient = 0");
    CHECK_STATUS(mdr_friction_new(c, NAN, &f), MDR_EINVALID, "coefficient");
    CHECK_STATUS(mdr_friction_new(c, mu, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_friction_new(unknown, mu, &f), MDR_EINVALID, "needs E and nu");
    CHECK_TRUE(f == NULL);
    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    fill_untouched(12, &out[0].shift);
    a[0] = 0.0;
    CHECK_STATUS(shear_states(c, NULL, &state, MDR_ALONG, 1, 2, a, out), MDR_ENULL, "f is NULL");
    CHECK_STATUS(shear_states(c, (mdr_friction *)c, &state, MDR_ALONG, 1, 2, a, out),
                 MDR_EINVALID, "not a handle of type mdr_friction");
    CHECK_STATUS(shear_states(c, f, NULL, MDR_ALONG, 1, 2, a, out), MDR_ENULL, "state is NULL");
    CHECK_STATUS(shear_states(c, f, &nowhere, MDR_ALONG, 1, 2, a, out), MDR_EINVALID, "contact radius");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, 3, 2, a, out), MDR_EINVALID, "given = 3");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 2, bad, out), MDR_EINVALID, "entry 2 of shift");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, MDR_TANGENTIAL_FORCE, 2, (const double[]){0.0, 1e9}, out), MDR_EUNREACHABLE,
                 "slides");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, -1, a, out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 2, NULL, out), MDR_ENULL, "in is NULL");
    CHECK_STATUS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 2, a, NULL), MDR_ENULL, "out is NULL");
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 0, NULL, NULL));
    CHECK_UNTOUCHED(12, &out[0].shift);
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 2, (const double[]){0.0, 1e-3}, out));
    CHECK_CLOSE(out[0].stick_radius, 1.0, 0.0);
    fill_untouched(2, G);
    CHECK_STATUS(shear_sliding(c, NULL, &state, MDR_ALONG, G, G), MDR_ENULL, "f is NULL");
    CHECK_STATUS(shear_sliding(c, f, NULL, MDR_ALONG, G, G), MDR_ENULL, "state is NULL");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, NULL, MDR_TRACTION, 2, a, G), MDR_ENULL, "at is NULL");
    CHECK_STATUS(shear_field(c, f, NULL, MDR_ALONG, out, 1, 2, a, G), MDR_ENULL, "state is NULL");
    CHECK_STATUS(shear_field(c, NULL, &state, MDR_ALONG, out, 1, 2, a, G), MDR_ENULL, "f is NULL");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, out, 0, 2, a, G), MDR_EINVALID, "field = 0");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, &out[1], MDR_TRACTION, 2, bad, G), MDR_EINVALID, "entry 2 of r");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, &out[1], MDR_TRACTION, 1, &(double){1.1}, G), MDR_EDOMAIN,
                 "at most the contact radius");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, &out[1], MDR_TRACTION, 2, NULL, G), MDR_ENULL, "r is NULL");
    CHECK_STATUS(shear_field(c, f, &state, MDR_ALONG, &out[1], MDR_TRACTION, 2, a, NULL), MDR_ENULL, "out is NULL");
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_ALONG, &out[1], MDR_TRACTION, 0, NULL, NULL));
    CHECK_UNTOUCHED(2, G);
    fill_untouched(POINTS, shift);
    CHECK_STATUS(shear_loop(c, NULL, &state, MDR_ALONG, 1, 1e-3, POINTS, shift, force, &dissipated), MDR_ENULL, "f is NULL");
    CHECK_STATUS(shear_loop(c, f, NULL, MDR_ALONG, 1, 1e-3, POINTS, shift, force, &dissipated), MDR_ENULL, "state is NULL");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, 0, 1e-3, POINTS, shift, force, &dissipated), MDR_EINVALID, "given = 0");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 0.0, POINTS, shift, force, &dissipated), MDR_EINVALID,
                 "amplitude = 0");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_TANGENTIAL_FORCE, 1e9, POINTS, shift, force, &dissipated),
                 MDR_EUNREACHABLE,
                 "slides");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 1e-3, 2, shift, force, &dissipated), MDR_EINVALID, "n = 2");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 1e-3, POINTS, NULL, force, &dissipated), MDR_ENULL,
                 "shift is NULL");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 1e-3, POINTS, shift, NULL, &dissipated), MDR_ENULL,
                 "force is NULL");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_ALONG, MDR_SHIFT, 1e-3, POINTS, shift, force, NULL), MDR_ENULL,
                 "dissipated is NULL");
    CHECK_UNTOUCHED(POINTS, shift);
    CHECK_FREE(f);
    CHECK_FREE(c);
    CHECK_FREE(unknown);
}

/* I0 + J0 = 1, and the value at xi = 1. */
static void weights(void)
{
    const double xi[3] = {0.0, 1.0, 1e9}, pi = acos(-1.0);
    double i0[3], j0[3];

    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0_TANGENTIAL, nu, 3, xi, i0));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_J0_TANGENTIAL, nu, 3, xi, j0));
    CHECK_CLOSE(i0[0], 0.0, 0.0);
    CHECK_CLOSE(i0[1], 0.5 + log(2.0) / pi + (log(2.0) - 0.5) / (2.0 * pi * (2.0 - nu)), 1e-14);
    for (int i = 0; i < 3; i++) CHECK_CLOSE(i0[i] + j0[i], 1.0, 1e-15);
    CHECK_TRUE(j0[2] > 0.0);
    CHECK_STATUS(mdr_weight(MDR_WEIGHT_I0_TANGENTIAL, nu, 3, NULL, i0), MDR_ENULL, "xi is NULL");
    CHECK_STATUS(mdr_weight(MDR_WEIGHT_J0_TANGENTIAL, 0.6, 3, xi, j0), MDR_EINVALID, "nu = 0.6");
}

/* A path is the same in one step and in many, refusals leave it as it is, copies go their own way. */
static void histories(void)
{
    mdr_contact *c = on_half_space();
    mdr_medium *film = NULL;
    mdr_contact *layered;
    mdr_friction *f = NULL, *on_film = NULL;
    mdr_friction_history *h = NULL, *copy = NULL;
    mdr_state states[POINTS];
    mdr_shear_state once, out[POINTS], before;
    double depth[POINTS], shift[POINTS], limit;

    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    CHECK_STATUS(mdr_friction_history_new(NULL, 0.0, 0, &h), MDR_ENULL, "f is NULL");
    CHECK_STATUS(mdr_friction_history_new(f, 0.0, 0, NULL), MDR_ENULL, "out is NULL");
    CHECK_SUCCESS(mdr_friction_history_new(f, 0.0, 0, &h));
    for (int i = 0; i < POINTS; i++) {
        depth[i] = 0.5 * (i + 1) / POINTS;
        shift[i] = 0.1 * (i + 1) / POINTS;
    }
    CHECK_STATUS(mdr_friction_history_copy(NULL, &copy), MDR_ENULL, "h is NULL");
    CHECK_SUCCESS(mdr_friction_history_copy(h, &copy));
    CHECK_SUCCESS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, POINTS, depth, shift, states, out));
    CHECK_SUCCESS(mdr_friction_history_advance(copy, MDR_DEPTH, MDR_SHIFT, 1, &depth[POINTS - 1], &shift[POINTS - 1],
                                               &states[0], &once));
    CHECK_CLOSE(out[POINTS - 1].tangential_force, once.tangential_force, 1e-13);
    CHECK_CLOSE(states[0].force, states[POINTS - 1].force, 1e-15);
    /* G* s while everything sticks from the first touch on: q_t = G* (s/d) (d - g), T = (s/d) (G* over E*) F */
    CHECK_CLOSE(once.tangential_force, 0.2 * states[0].force * (2.0 - 2.0 * nu) / (2.0 - nu), 1e-12);
    CHECK_CLOSE(once.dissipated_energy + 1.0, 1.0, 0.0);
    limit = mu * states[0].force;
    before = once;
    fill_untouched(6, &once.shift);
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_TANGENTIAL_FORCE, 1, depth, &limit, states, &once),
                 MDR_EUNREACHABLE, "slides");
    CHECK_STATUS(mdr_friction_history_advance(h, 3, MDR_SHIFT, 1, depth, shift, states, &once), MDR_EINVALID, "normal_given = 3");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, 0, 1, depth, shift, states, &once), MDR_EINVALID,
                 "tangential_given = 0");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, -1, depth, shift, states, &once), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, NULL, shift, states, &once), MDR_ENULL, "normal is NULL");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, depth, NULL, states, &once), MDR_ENULL,
                 "tangential is NULL");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, depth, shift, NULL, &once), MDR_ENULL, "states is NULL");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, depth, shift, states, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_friction_history_advance(NULL, 1, 1, 1, depth, shift, states, &once), MDR_ENULL, "h is NULL");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, &(double){-1.0}, shift, states, &once),
                 MDR_EUNREACHABLE, "no contact below");
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, depth, &(double){NAN}, states, &once), MDR_EINVALID,
                 "shift");
    CHECK_UNTOUCHED(6, &once.shift);
    CHECK_SUCCESS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 0, NULL, NULL, NULL, NULL));
    /* by forces back to the state it is in */
    CHECK_SUCCESS(mdr_friction_history_advance(h, MDR_FORCE, MDR_TANGENTIAL_FORCE, 1, &states[POINTS - 1].force,
                                               &before.tangential_force, states, &once));
    CHECK_CLOSE(once.shift, before.shift, 1e-10);
    CHECK_FREE(copy);
    CHECK_FREE(h);
    CHECK_TRUE(h == NULL);
    CHECK_SUCCESS(new_coated(700.0, 0.2, 1.0, E, nu, MDR_MODEL_EXACT, NULL, &film));
    layered = ball_on(film);
    CHECK_SUCCESS(mdr_friction_new(layered, mu, &on_film));
    CHECK_STATUS(mdr_friction_history_new(on_film, 0.0, 0, &h), MDR_EINVALID, "largest_depth is missing");
    CHECK_STATUS(mdr_friction_history_new(on_film, -1.0, 0, &h), MDR_EINVALID, "largest_depth = -1");
    CHECK_STATUS(mdr_friction_history_new(on_film, 0.5, 9, &h), MDR_EINVALID, "rings = 9");
    CHECK_SUCCESS(mdr_friction_history_new(on_film, 0.5, 20, &h));
    CHECK_SUCCESS(mdr_friction_history_copy(h, &copy));
    CHECK_SUCCESS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, POINTS, depth, shift, states, out));
    CHECK_TRUE(out[POINTS - 1].tangential_force > 0.0 && out[POINTS - 1].tangential_force <= mu * states[POINTS - 1].force);
    CHECK_SUCCESS(mdr_friction_history_advance(copy, MDR_DEPTH, MDR_TANGENTIAL_FORCE, 1, &depth[POINTS - 1],
                                               &out[POINTS - 1].tangential_force, states, &once));
    CHECK_CLOSE(once.tangential_force, out[POINTS - 1].tangential_force, 1e-9);
    fill_untouched(6, &once.shift);
    CHECK_STATUS(mdr_friction_history_advance(h, MDR_DEPTH, MDR_SHIFT, 1, &(double){0.51}, shift, states, &once), MDR_EDOMAIN,
                 "the rings of this history reach up to");
    CHECK_UNTOUCHED(6, &once.shift);
    CHECK_FREE(copy);
    CHECK_FREE(h);
    CHECK_FREE(on_film);
    CHECK_FREE(layered);
    CHECK_FREE(f);
    CHECK_FREE(c);
}

enum { MEMORY = 11 + 4 * 8 };

/* The bits of two records. */
static int same(const double *one, const double *other)
{
    return memcmp(one, other, MEMORY * sizeof *one) == 0;
}

/* Steps of a law with friction: first shear as the contact says, a trial first, nothing is touched after a failure, energies. */
static void laws(void)
{
    mdr_contact *c = on_half_space();
    mdr_friction *f = NULL;
    mdr_law *law = NULL, *none = NULL;
    mdr_profile *ball = NULL;
    mdr_medium *body = NULL;
    mdr_contact *other = NULL;
    mdr_law_options options;
    mdr_state state, deepest;
    mdr_shear_state exact;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double memory[2 * MEMORY] = {0.0}, before[MEMORY], T[6], again[6], tangent[24], stored[2], dissipated[2];
    double shift[6] = {0.0}, force[2], sliding;

    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    options = MDR_SIZED(mdr_law_options);
    options.tolerance = 1e-8;
    options.friction = f;
    CHECK_SUCCESS(mdr_law_new(c, 0.1, &options, &law));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    CHECK_TRUE(facts.first_shear_error < 0.01 && facts.path_error > 1e-3 && facts.path_error < 0.02);
    CHECK_TRUE(facts.coefficient == mu && facts.tolerance == 1e-8 && facts.continue_beyond == 0);
    CHECK_TRUE(facts.sliders == 8 && facts.memory_size == MEMORY);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 1, &(double){0.05}, &state));
    CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_ALONG, &sliding, NULL));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_FORCE, MDR_ON_UNLOADING, 1, &facts.highest_force, &deepest));
    CHECK_TRUE(deepest.depth >= 0.1 && deepest.depth < 0.11);
    CHECK_SUCCESS(shear_sliding(c, f, &deepest, MDR_ALONG, &deepest.depth, NULL));
    CHECK_CLOSE(facts.highest_sliding_shift, deepest.depth, 1e-7);
    force[0] = force[1] = state.force;
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T));
    shift[0] = 0.6 * sliding;
    shift[4] = -2.0 * sliding;
    memcpy(before, memory, sizeof before);
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, shift, 1, tangent, memory, again));
    CHECK_TRUE(same(before, memory));
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T));
    CHECK_TRUE(memcmp(T, again, sizeof T) == 0 && !same(before, memory));
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 1, shift, &exact));
    CHECK_TRUE(fabs(T[0] - exact.tangential_force) < 0.01 * mu * state.force);
    CHECK_CLOSE(tangent[0], exact.stiffness, 0.2);
    CHECK_CLOSE(T[4], -mu * state.force, 1e-14);
    /* what slides does so with the normal force, and resists no further shift along its way */
    CHECK_CLOSE(tangent[19], -mu, 1e-14);
    CHECK_TRUE(fabs(tangent[17]) < 1e-12 * tangent[0] && tangent[12] > 0.0);
    CHECK_SUCCESS(mdr_law_energies(law, 2, memory, stored, dissipated));
    /* of small slip 8 sliders know little */
    CHECK_CLOSE(dissipated[0], exact.dissipated_energy, 0.1);
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 1, &shift[4], &exact));
    CHECK_CLOSE(dissipated[1], exact.dissipated_energy, 0.01);
    CHECK_TRUE(stored[1] > stored[0] && stored[0] > 0.0 && dissipated[1] > dissipated[0] && dissipated[0] > 0.0);
    CHECK_SUCCESS(mdr_law_energies(law, 2, memory, NULL, dissipated));
    CHECK_STATUS(mdr_law_energies(law, 2, NULL, stored, dissipated), MDR_ENULL, "memory is NULL");
    memcpy(before, memory, sizeof before);
    shift[3] = NAN;
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "entry 2 of shift");
    shift[3] = 1e200;
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "at most 1e150");
    shift[3] = 0.0;
    force[1] = 1e9;
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T), MDR_EDOMAIN, "entry 2 of force");
    force[1] = -1.0;
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "entry 2 of force = -1");
    force[1] = 0.0;
    CHECK_STATUS(mdr_law_advance(law, -1, force, shift, 0, NULL, memory, T), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_law_advance(law, 2, NULL, shift, 0, NULL, memory, T), MDR_ENULL, "force is NULL");
    CHECK_STATUS(mdr_law_advance(law, 2, force, NULL, 0, NULL, memory, T), MDR_ENULL, "shift is NULL");
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, NULL, T), MDR_ENULL, "memory is NULL");
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, NULL), MDR_ENULL, "T is NULL");
    CHECK_STATUS(mdr_law_advance(NULL, 2, force, shift, 0, NULL, memory, T), MDR_ENULL, "law is NULL");
    CHECK_STATUS(mdr_law_advance((mdr_law *)f, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "mdr_law");
    /* a record of another law, and one that none left */
    options.sliders = 8;
    CHECK_SUCCESS(mdr_law_new(c, 0.2, &options, &none));
    CHECK_STATUS(mdr_law_advance(none, 1, force, shift, 0, NULL, memory, T), MDR_EINVALID, "entry 1 of memory");
    CHECK_FREE(none);
    memory[MEMORY + 1] = 7e8;
    CHECK_STATUS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "entry 2 of memory");
    CHECK_STATUS(mdr_law_energies(law, 2, memory, stored, dissipated), MDR_EINVALID, "entry 2 of memory");
    CHECK_TRUE(same(before, memory));
    memset(memory + MEMORY, 0, MEMORY * sizeof *memory);
    CHECK_SUCCESS(mdr_law_advance(law, 0, NULL, NULL, 0, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T));
    CHECK_TRUE(T[3] == 0.0 && T[4] == 0.0 && T[0] > 0.0);
    CHECK_STATUS(mdr_law_new(c, 0.1, &options, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_law_new(c, NAN, &options, &none), MDR_EINVALID, "largest_depth");
    options.sliders = 65;
    CHECK_STATUS(mdr_law_new(c, 0.1, &options, &none), MDR_EINVALID, "sliders = 65");
    options.friction = (mdr_friction *)c;
    CHECK_STATUS(mdr_law_new(c, 0.1, &options, &none), MDR_EINVALID, "options.friction: it is not a handle of type mdr_friction");
    /* a law without friction, and friction of another contact */
    options.friction = NULL;
    CHECK_SUCCESS(mdr_law_new(c, 0.1, &options, &none));
    CHECK_STATUS(mdr_law_advance(none, 2, force, shift, 0, NULL, memory, T), MDR_EINVALID, "law: it has no friction");
    CHECK_STATUS(mdr_law_energies(none, 2, memory, stored, dissipated), MDR_EINVALID, "law: it has no friction");
    CHECK_STATUS(mdr_law_turn(none, 2, shift, NULL, memory), MDR_EINVALID, "law: it has no friction");
    CHECK_FREE(none);
    CHECK_SUCCESS(mdr_profile_paraboloid(7.0, &ball));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &body));
    CHECK_SUCCESS(mdr_contact_new(ball, body, NULL, &other));
    options.friction = f;
    options.sliders = 0;
    CHECK_STATUS(mdr_law_new(other, 0.1, &options, &none), MDR_EINVALID, "friction: it must belong to the contact");
    CHECK_FREE(other);
    CHECK_FREE(body);
    CHECK_FREE(ball);
    CHECK_STATUS(mdr_law_about(NULL, &facts), MDR_ENULL, "law is NULL");
    CHECK_STATUS(mdr_law_about(law, NULL), MDR_ENULL, "facts is NULL");
    CHECK_FREE(law);
    CHECK_TRUE(law == NULL);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(f);
    CHECK_FREE(c);
}

/* Records turn with their planes. */
static void turning_planes(void)
{
    mdr_contact *c = on_half_space();
    mdr_friction *f = NULL;
    mdr_law *law = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double memory[2 * MEMORY] = {0.0}, before[2 * MEMORY], T[6], turned[6], force[2], normal[6] = {0.0, 0.0, 1.0, 0.0, 0.0, 1.0};
    const double tilted[6] = {0.0, 0.6, 0.8, 0.0, 0.0, 1.0}, spin[2] = {0.0, acos(-1.0)}, still[6] = {0.0};
    double shift[6] = {1e-3, 2e-3, 0.0, 1e-3, 2e-3, 0.0};

    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.friction = f;
    CHECK_SUCCESS(mdr_law_new(c, 0.1, &options, &law));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    force[0] = force[1] = 0.3 * facts.highest_force;
    CHECK_SUCCESS(mdr_law_turn(law, 2, normal, NULL, memory));
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, shift, 0, NULL, memory, T));
    CHECK_SUCCESS(mdr_law_turn(law, 2, tilted, spin, memory));
    CHECK_SUCCESS(mdr_law_advance(law, 2, force, still, 0, NULL, memory, turned));
    CHECK_CLOSE(turned[0], T[0], 1e-14);
    CHECK_CLOSE(turned[1], 0.8 * T[1], 1e-14);
    CHECK_CLOSE(turned[2], -0.6 * T[1], 1e-14);
    CHECK_CLOSE(turned[3], -T[3], 1e-14);
    CHECK_CLOSE(turned[4], -T[4], 1e-14);
    memcpy(before, memory, sizeof before);
    normal[5] = 2.0;
    CHECK_STATUS(mdr_law_turn(law, 2, normal, NULL, memory), MDR_EINVALID, "entry 2 of normal");
    CHECK_STATUS(mdr_law_turn(law, 2, tilted, &(double[2]){0.0, NAN}[0], memory), MDR_EINVALID, "entry 2 of spin");
    CHECK_STATUS(mdr_law_turn(law, 2, NULL, NULL, memory), MDR_ENULL, "normal is NULL");
    CHECK_STATUS(mdr_law_turn(law, 2, tilted, NULL, NULL), MDR_ENULL, "memory is NULL");
    CHECK_STATUS(mdr_law_turn(NULL, 2, tilted, NULL, memory), MDR_ENULL, "law is NULL");
    CHECK_TRUE(memcmp(before, memory, sizeof before) == 0);
    CHECK_SUCCESS(mdr_law_turn(law, 0, NULL, NULL, NULL));
    CHECK_FREE(law);
    CHECK_FREE(f);
    CHECK_FREE(c);
}

/* All but the padding between the members, which is not written. */
static int same_facts(const mdr_law_facts *a, const mdr_law_facts *b)
{
    return a->lowest_depth == b->lowest_depth && a->highest_depth == b->highest_depth && a->lowest_force == b->lowest_force
           && a->highest_force == b->highest_force && a->tolerance == b->tolerance && a->error == b->error
           && a->solutions == b->solutions && a->adhesive == b->adhesive && a->segments == b->segments
           && strcmp(a->description, b->description) == 0 && a->continue_beyond == b->continue_beyond
           && a->sliders == b->sliders && a->memory_size == b->memory_size && a->coefficient == b->coefficient
           && a->highest_sliding_shift == b->highest_sliding_shift && a->first_shear_error == b->first_shear_error
           && a->path_error == b->path_error;
}

/* The same law from its file and from memory; files of laws with friction of earlier versions are refused by name. */
static void law_files(void)
{
    static const char *const path = "friction.mdrlaw", *const former = "mdrcontact compiled friction law, format 3\n";
    mdr_contact *c = on_half_space();
    mdr_friction *f = NULL;
    mdr_law *law = NULL, *again = NULL;
    mdr_law_options options;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts), other = MDR_SIZED(mdr_law_facts);
    double memory[2 * MEMORY] = {0.0}, T[3], shift[3] = {0.0}, force = 0.02;
    char *content;
    int length = 0, second = 0;

    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    options = MDR_SIZED(mdr_law_options);
    options.description = "a ball on steel";
    options.continue_beyond = 1;
    options.friction = f;
    CHECK_SUCCESS(mdr_law_new(c, 0.1, &options, &law));
    CHECK_SUCCESS(mdr_law_save(law, path));
    CHECK_SUCCESS(mdr_law_load(path, &again));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    CHECK_SUCCESS(mdr_law_about(again, &other));
    CHECK_TRUE(same_facts(&facts, &other) && facts.continue_beyond == 1);
    CHECK_TEXT(other.description, "a ball on steel");
    for (int i = 0; i < 5; i++) {
        CHECK_SUCCESS(mdr_law_advance(law, 1, &force, shift, 0, NULL, &memory[0], T));
        CHECK_SUCCESS(mdr_law_advance(again, 1, &force, shift, 0, NULL, &memory[MEMORY], T));
        shift[i % 2] = i < 3 ? 2e-3 : -1e-3;
        force *= 1.2;
    }
    CHECK_TRUE(T[0] > 0.0 && same(&memory[0], &memory[MEMORY]));
    CHECK_FREE(again);
    CHECK_SUCCESS(mdr_law_write(law, NULL, 0, &length));
    content = malloc((size_t)length);
    CHECK_SUCCESS(mdr_law_write(law, content, length, &length));
    CHECK_SUCCESS(mdr_law_read(content, length, &again));
    CHECK_SUCCESS(mdr_law_write(again, NULL, 0, &second));
    CHECK_TRUE(second == length);
    CHECK_FREE(again);
    content[length / 2] ^= 1;
    CHECK_STATUS(mdr_law_read(content, length, &again), MDR_EFILE, "damaged");
    CHECK_STATUS(mdr_law_read(content, length - 1, &again), MDR_EFILE, "truncated");
    CHECK_STATUS(mdr_law_read(content, -1, &again), MDR_EINVALID, "length");
    CHECK_STATUS(mdr_law_read(NULL, length, &again), MDR_ENULL, "buffer is NULL");
    CHECK_STATUS(mdr_law_write(law, NULL, length, &length), MDR_ENULL, "buffer is NULL");
    CHECK_STATUS(mdr_law_write(law, content, length, NULL), MDR_ENULL, "full_length is NULL");
    CHECK_STATUS(mdr_law_save(law, NULL), MDR_ENULL, "path is NULL");
    CHECK_STATUS(mdr_law_load(NULL, &again), MDR_ENULL, "path is NULL");
    CHECK_STATUS(mdr_law_save(NULL, path), MDR_ENULL, "law is NULL");
    CHECK_STATUS(mdr_law_read(former, (int)strlen(former), &again), MDR_EFILE, "earlier version of the library. Create it again");
    CHECK_TRUE(again == NULL);
    remove(path);
    free(content);
    CHECK_FREE(law);
    CHECK_FREE(f);
    CHECK_FREE(c);
}

/* Torsion: Lubkin's torque of sliding, full stick, a loop, and what is refused. */
static void torsion(void)
{
    enum { POINTS = 5 };
    mdr_contact *c = on_half_space();
    mdr_friction *f = NULL;
    mdr_state state;
    mdr_shear_state out[2], again[2];
    double twists[2] = {1e-9, 0.02}, torques[2], limit = 0.0, phi[POINTS], M[POINTS], lost, r[2] = {0.0, 0.0}, tau[2];
    const double G = E/(2.0*(1.0 + nu));

    CHECK_SUCCESS(mdr_friction_new(c, mu, &f));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 1, &(double){0.05}, &state));
    CHECK_SUCCESS(shear_sliding(c, f, &state, MDR_AROUND, NULL, &limit));
    CHECK_CLOSE(limit, 3.0 * 3.14159265358979324 / 16.0 * mu * state.force * state.radius, 1e-14);
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 2, twists, out));
    CHECK_CLOSE(out[0].tangential_force, 16.0 / 3.0 * G * pow(state.radius, 3) * twists[0], 1e-6);
    CHECK_CLOSE(out[1].stiffness, 16.0 / 3.0 * G * pow(out[1].stick_radius, 3), 1e-13);
    CHECK_TRUE(out[1].tangential_force < limit && out[1].sliding == 0.0 && out[1].dissipated_energy > 0.0);
    torques[0] = -out[0].tangential_force, torques[1] = out[1].tangential_force;
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_AROUND, MDR_TORQUE, 2, torques, again));
    CHECK_CLOSE(again[0].shift, -twists[0], 1e-9);
    CHECK_CLOSE(again[1].shift, twists[1], 1e-9);
    CHECK_SUCCESS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, twists[1], POINTS, phi, M, &lost));
    CHECK_CLOSE(lost, 4.0 * out[1].dissipated_energy, 1e-14);
    CHECK_CLOSE(M[0], out[1].tangential_force, 1e-14);
    CHECK_CLOSE(M[2], -out[1].tangential_force, 1e-14);
    CHECK_CLOSE(M[1], -M[3], 1e-14);
    r[1] = 0.5 * (out[1].stick_radius + state.radius);
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_AROUND, &out[1], MDR_TRACTION, 2, r, tau));
    CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, 1, &r[1], &lost));
    CHECK_TRUE(tau[0] == 0.0);
    CHECK_CLOSE(tau[1], mu * lost, 1e-12);
    CHECK_SUCCESS(shear_field(c, f, &state, MDR_AROUND, &out[1], MDR_TANGENTIAL_LINE_LOAD, 1, &out[1].stick_radius, tau));
    CHECK_CLOSE(tau[0], 4.0 * G * twists[1] * out[1].stick_radius, 1e-9);
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, MDR_TORQUE, 1, &limit, again),
                 MDR_EUNREACHABLE, "less than the torque of sliding");
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, 3, 1, twists, again), MDR_EINVALID, "given = 3");
    twists[1] = NAN;
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 2, twists, again), MDR_EINVALID, "entry 2");
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, -1, twists, again), MDR_EINVALID, "n = -1");
    CHECK_SUCCESS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 0, NULL, NULL));
    CHECK_STATUS(shear_states(c, NULL, &state, MDR_AROUND, MDR_TWIST, 1, twists, again), MDR_ENULL, "f is NULL");
    CHECK_STATUS(shear_states(c, f, NULL, MDR_AROUND, MDR_TWIST, 1, twists, again), MDR_ENULL, "state is NULL");
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 1, NULL, again), MDR_ENULL, "in is NULL");
    CHECK_STATUS(shear_states(c, f, &state, MDR_AROUND, MDR_TWIST, 1, twists, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(shear_field(c, f, &state, MDR_AROUND, NULL, MDR_TRACTION, 1, r, tau), MDR_ENULL, "at is NULL");
    CHECK_STATUS(shear_field(c, f, &state, MDR_AROUND, out, 3, 1, r, tau), MDR_EINVALID, "field = 3");
    r[0] = 2.0 * state.radius;
    CHECK_STATUS(shear_field(c, f, &state, MDR_AROUND, out, MDR_TRACTION, 1, r, tau), MDR_EDOMAIN, "r");
    out[0].shift = NAN;
    CHECK_STATUS(shear_field(c, f, &state, MDR_AROUND, out, MDR_TRACTION, 1, &r[1], tau), MDR_EINVALID,
                 "twist of the torsional state");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, 0.0, POINTS, phi, M, &lost), MDR_EINVALID, "amplitude");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, 0.1, 2, phi, M, &lost), MDR_EINVALID, "n = 2");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, 0.1, POINTS, NULL, M, &lost), MDR_ENULL, "shift is NULL");
    CHECK_STATUS(shear_loop(c, f, &state, MDR_AROUND, MDR_TWIST, 0.1, POINTS, phi, M, NULL), MDR_ENULL, "dissipated is NULL");
    CHECK_FREE(f);
    CHECK_FREE(c);
}

int main(void)
{
    weights();
    torsion();
    laws();
    turning_planes();
    law_files();
    histories();
    partial_slip();
    refusals();
    return check_report("friction");
}
