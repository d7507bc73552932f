/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pressure, displacement and line load: refusals, then Hertz, Sneddon and Boussinesq's punch. */
#include "check.h"

static const double pi = 3.14159265358979323846;

static mdr_contact *paraboloid(double R, double modulus)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

static void refusals(void)
{
    const double r[2] = {0.0, 0.5}, negative[2] = {0.0, -0.5}, not_a_number[2] = {NAN, 0.5}, outside[2] = {0.5, 1.01};
    double out[2];
    mdr_contact *c = paraboloid(1.0, 1.0);
    mdr_profile *p = NULL;
    mdr_state state;

    CHECK_SUCCESS(mdr_profile_cone(0.1, &p));
    fill_untouched(2, out);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, 0, 1, &(double){1.0}, &state));
    for (int field = MDR_PRESSURE; field <= MDR_LINE_LOAD; field++) {
        mdr_state wrong = state;

        CHECK_STATUS(state_field(NULL, field, &state, 2, r, out), MDR_ENULL, "c is NULL");
        CHECK_STATUS(state_field((mdr_contact *)(void *)p, field, &state, 2, r, out),
                     MDR_EINVALID, "not a handle of type mdr_contact");
        CHECK_STATUS(state_field(c, field, NULL, 2, r, out), MDR_ENULL, "state is NULL");
        CHECK_STATUS(state_field(c, field, &state, -1, r, out), MDR_EINVALID, "n = -1");
        CHECK_STATUS(state_field(c, field, &state, 2, NULL, out), MDR_ENULL, "r is NULL");
        CHECK_STATUS(state_field(c, field, &state, 2, r, NULL), MDR_ENULL, "out is NULL");
        wrong.radius = NAN;
        CHECK_STATUS(state_field(c, field, &wrong, 2, r, out), MDR_EINVALID, "there is no contact");
        wrong.radius = 0.0;
        CHECK_STATUS(state_field(c, field, &wrong, 2, r, out), MDR_EINVALID, "there is no contact");
        wrong.radius = INFINITY;
        CHECK_STATUS(state_field(c, field, &wrong, 2, r, out), MDR_EINVALID, "state");
        wrong = state;
        wrong.punch_depth = NAN;
        CHECK_STATUS(state_field(c, field, &wrong, 2, r, out), MDR_EINVALID, "punch_depth");
        CHECK_STATUS(state_field(c, field, &state, 2, negative, out), MDR_EINVALID, " = -0.5");
        CHECK_STATUS(state_field(c, field, &state, 2, not_a_number, out), MDR_EINVALID, " = NaN");
        if (field != MDR_DISPLACEMENT) {
            CHECK_STATUS(state_field(c, field, &state, 2, outside, out), MDR_EDOMAIN, " = 1.01");
        }
        CHECK_SUCCESS(state_field(c, field, &state, 0, NULL, NULL));
    }
    CHECK_STATUS(state_field(c, 0, &state, 2, r, out), MDR_EINVALID, "field = 0");
    CHECK_STATUS(state_field(c, 6, &state, 2, r, out), MDR_EINVALID, "field = 6");
    CHECK_STATUS(state_lowest_pressure(NULL, &state, out, out + 1), MDR_ENULL, "c is NULL");
    CHECK_STATUS(state_lowest_pressure(c, NULL, out, out + 1), MDR_ENULL, "state is NULL");
    CHECK_UNTOUCHED(2, out);
    CHECK_SUCCESS(state_lowest_pressure(c, &state, NULL, NULL));
    CHECK_STATUS(mdr_contact_states(c, 4, MDR_ON_UNLOADING, 1, r, &state), MDR_EINVALID, "given = 4");
    CHECK_STATUS(mdr_contact_states(c, MDR_DEPTH, 3, 1, r, &state), MDR_EINVALID, "branch = 3");
    CHECK_STATUS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 1, r, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 1, NULL, &state), MDR_ENULL, "in is NULL");
    CHECK_SUCCESS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 0, NULL, NULL));
    CHECK_UNTOUCHED(2, out);
    CHECK_SUCCESS(state_lowest_pressure(c, &state, out, out + 1));
    CHECK_TRUE(out[0] == 0.0 && out[1] == state.radius); /* at the edge */
    CHECK_FREE(p);
    CHECK_FREE(c);
}

static void hertz(void)
{
    const double R = 2.0, modulus = 3.0, a = 0.25, d = a * a / R, p0 = 2 * modulus * a / (pi * R);
    const double r[4] = {0.0, 0.1, 0.2, 0.2499}, far[3] = {0.3, 0.5, 10.0};
    double by_radius[4], by_depth[4];
    mdr_contact *c = paraboloid(R, modulus);

    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, a, 4, r, by_radius));
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_DEPTH, d, 4, r, by_depth));
    for (int i = 0; i < 4; i++) {
        CHECK_CLOSE(by_radius[i], p0 * sqrt(1 - r[i] * r[i] / (a * a)), 1e-10);
        CHECK_CLOSE(by_depth[i], p0 * sqrt(1 - r[i] * r[i] / (a * a)), 1e-10);
    }
    CHECK_SUCCESS(field_at(c, MDR_LINE_LOAD, MDR_RADIUS, a, 4, r, by_radius));
    CHECK_SUCCESS(field_at(c, MDR_LINE_LOAD, MDR_DEPTH, d, 4, r, by_depth));
    for (int i = 0; i < 4; i++) {
        CHECK_CLOSE(by_radius[i], modulus * (d - r[i] * r[i] / R), 1e-10);
        CHECK_CLOSE(by_depth[i], modulus * (d - r[i] * r[i] / R), 1e-10);
    }
    CHECK_SUCCESS(field_at(c, MDR_DISPLACEMENT, MDR_RADIUS, a, 4, r, by_radius));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(by_radius[i], d - r[i] * r[i] / (2 * R), 1e-12);
    CHECK_SUCCESS(field_at(c, MDR_DISPLACEMENT, MDR_RADIUS, a, 3, far, by_radius));
    CHECK_SUCCESS(field_at(c, MDR_DISPLACEMENT, MDR_DEPTH, d, 3, far, by_depth));
    for (int i = 0; i < 3; i++) {
        const double s = far[i] / a;
        const double u = a * a / (pi * R) * ((2 - s * s) * asin(1 / s) + sqrt(s * s - 1));
        CHECK_CLOSE(by_radius[i], u, 1e-10);
        CHECK_CLOSE(by_depth[i], u, 1e-10);
    }
    CHECK_FREE(c);
}

static void sneddon(void)
{
    const double phi = 0.3, modulus = 1.5, a = 0.7, r[4] = {0.0, 0.1, 0.4, 0.69};
    double out[4];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(mdr_profile_cone(phi, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, a, 4, r, out));
    CHECK_TRUE(isinf(out[0]) && out[0] > 0); /* the cone's apex */
    for (int i = 1; i < 4; i++) CHECK_CLOSE(out[i], 0.5 * modulus * tan(phi) * acosh(a / r[i]), 1e-10);
    CHECK_FREE(p);
    CHECK_FREE(m);
    CHECK_FREE(c);
}

static void boussinesq(void)
{
    const double b = 0.4, modulus = 2.0, d = 0.1, r[4] = {0.0, 0.2, 0.39, 0.4}, far[2] = {0.5, 4.0};
    double out[4];
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(mdr_profile_flat_punch(b, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    fill_untouched(4, out);
    CHECK_STATUS(field_at(c, MDR_PRESSURE, MDR_RADIUS, b, 4, r, out), MDR_EUNREACHABLE, "Give depth or force");
    CHECK_UNTOUCHED(4, out);
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_DEPTH, d, 4, r, out));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(out[i], modulus * d / (pi * sqrt(b * b - r[i] * r[i])), 1e-10);
    CHECK_TRUE(isinf(out[3]) && out[3] > 0);
    CHECK_SUCCESS(field_at(c, MDR_LINE_LOAD, MDR_DEPTH, d, 4, r, out));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(out[i], modulus * d, 1e-12);
    CHECK_SUCCESS(field_at(c, MDR_DISPLACEMENT, MDR_DEPTH, d, 2, far, out));
    for (int i = 0; i < 2; i++) CHECK_CLOSE(out[i], 2 * d / pi * asin(b / far[i]), 1e-10);
    CHECK_FREE(p);
    CHECK_FREE(m);
    CHECK_FREE(c);
}

/* A ball on a half-space twice as stiff: each surface takes its share of displacement and energy. */
static void two_bodies(void)
{
    const double a = 0.5, r[3] = {0.0, 0.3, 2.0};
    double both[3], lower[3], upper[3], energies[2] = {-1.0, -1.0};
    mdr_profile *p = NULL;
    mdr_medium *half_space = NULL, *ball = NULL, *pair = NULL;
    mdr_contact *c = NULL;
    mdr_state state;

    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &p));
    CHECK_SUCCESS(new_homogeneous(6.0, 0.0, &half_space));
    CHECK_SUCCESS(new_homogeneous(3.0, 0.0, &ball));
    CHECK_SUCCESS(mdr_medium_pair(half_space, ball, &pair));
    CHECK_SUCCESS(mdr_contact_new(p, pair, NULL, &c));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_LOADING, 1, &a, &state));
    CHECK_SUCCESS(state_field(c, MDR_DISPLACEMENT, &state, 3, r, both));
    CHECK_SUCCESS(state_field(c, MDR_DISPLACEMENT_LOWER, &state, 3, r, lower));
    CHECK_SUCCESS(state_field(c, MDR_DISPLACEMENT_UPPER, &state, 3, r, upper));
    for (int i = 0; i < 3; i++) {
        CHECK_CLOSE(lower[i], both[i] / 3, 1e-14);
        CHECK_CLOSE(upper[i], 2 * both[i] / 3, 1e-14);
    }
    CHECK_STATUS(state_energy(c, NULL, &energies[0], &energies[1]), MDR_ENULL, "state is NULL");
    CHECK_TRUE(energies[0] == -1.0 && energies[1] == -1.0);
    CHECK_SUCCESS(state_energy(c, &state, &energies[0], &energies[1]));
    /* Hertz: int F dd = (2/5) F d */
    CHECK_CLOSE(energies[0], 0.4 * state.force * state.depth / 3, 1e-12);
    CHECK_CLOSE(energies[1], 0.8 * state.force * state.depth / 3, 1e-12);
    CHECK_SUCCESS(state_energy(c, &state, NULL, NULL));
    MDR_FREE(p);
    MDR_FREE(half_space);
    MDR_FREE(ball);
    MDR_FREE(pair);
    MDR_FREE(c);
}

/* A cone on a stiff film: the lowest pressure is that of a fine scan, on a ring where neither end of the search is close. */
static void lowest_pressure(void)
{
    enum { SCAN = 2000 };
    const double a = 8.0;
    static double r[SCAN], p[SCAN];
    double lowest, place, scanned = 0.0;
    mdr_profile *cone = NULL;
    mdr_medium *film = NULL;
    mdr_contact *c = NULL;
    mdr_state state;

    CHECK_SUCCESS(mdr_profile_cone(0.1, &cone));
    CHECK_SUCCESS(new_coated(100.0, 0.25, 1.0, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(cone, film, NULL, &c));
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &a, &state));
    for (int i = 0; i < SCAN; i++) r[i] = a * i / SCAN;
    CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, SCAN, r, p));
    for (int i = 0; i < SCAN; i++) scanned = fmin(scanned, p[i]);
    CHECK_SUCCESS(state_lowest_pressure(c, &state, &lowest, &place));
    CHECK_CLOSE(lowest, scanned, 1e-4);
    CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &state, 1, &place, p));
    CHECK_CLOSE(p[0], lowest, 1e-12);
    CHECK_FREE(c);
    CHECK_FREE(film);
    CHECK_FREE(cone);
}

/* An indenter: a cone, one with a flat end, or a table. */
static mdr_profile *tip(int which, double length)
{
    const double r[4] = {0.0, 0.2 * length, 0.5 * length, length}, f[4] = {0.0, 0.01 * length, 0.1 * length, 0.6 * length};
    mdr_profile *p = NULL;

    if (which == 0) CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    if (which == 1) CHECK_SUCCESS(mdr_profile_flat_paraboloid(0.1 * length, length, &p));
    if (which == 2) CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, 4, r, f, &p));
    return p;
}

static mdr_medium *body(int which, double length, double modulus)
{
    const double h = 0.1 * length;
    mdr_medium *m = NULL;

    if (which == 0) CHECK_SUCCESS(new_homogeneous(modulus, 0.3, &m));
    if (which == 1) CHECK_SUCCESS(new_coated(9.0 * modulus, 0.3, h, modulus, 0.2, MDR_MODEL_GAO, NULL, &m));
    if (which == 2) CHECK_SUCCESS(new_coated(9.0 * modulus, 0.3, h, modulus, 0.2, MDR_MODEL_EXACT, NULL, &m));
    if (which == 3) CHECK_SUCCESS(medium_of_power(modulus, length, 0.3, 0.3, &m));
    return m;
}

enum { PLACES = 8 };

/* In units of the modulus, at contact radius length/2. */
static void pressures(int which_tip, int which_body, double length, double modulus, double p[PLACES])
{
    const double place[PLACES] = {1e-6, 0.01, 0.1, 0.3, 0.5, 0.9, 0.99, 0.9999};
    mdr_profile *indenter = tip(which_tip, length);
    mdr_medium *medium = body(which_body, length, modulus);
    mdr_contact *c = NULL;
    double r[PLACES];

    for (int i = 0; i < PLACES; i++) r[i] = 0.5 * length * place[i];
    CHECK_SUCCESS(mdr_contact_new(indenter, medium, NULL, &c));
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 0.5 * length, PLACES, r, p));
    for (int i = 0; i < PLACES; i++) p[i] /= modulus;
    CHECK_FREE(c);
    CHECK_FREE(medium);
    CHECK_FREE(indenter);
}

/* Metres and pascals, or others: the pressures are the same to rounding. */
static void other_units(void)
{
    double p[PLACES], same[PLACES];

    for (int b = 0; b < 4; b++) {
        for (int t = 0; t < 3; t++) {
            pressures(t, b, 1.0, 1.0, p);
            pressures(t, b, 3.7e-9, 1.3e11, same);
            for (int i = 0; i < PLACES; i++) CHECK_CLOSE(same[i], p[i], 1e-12);
        }
    }
}

/* Under a stiff film on a soft base d is far greater than q/E0*: the integral of q over the contact is F all the same. */
static void line_load_of_a_stiff_film(void)
{
    enum { STEPS = 1000 };
    const double bases[2] = {1e-6, 1e-12}, a[3] = {0.03, 1.0, 9.0};
    static double x[STEPS + 1], q[STEPS + 1];
    mdr_profile *ball = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    for (int b = 0; b < 2; b++) {
        mdr_medium *film = NULL;
        mdr_contact *c = NULL;

        CHECK_SUCCESS(new_coated(1.0, 0.3, 1.0, bases[b], 0.3, MDR_MODEL_EXACT, NULL, &film));
        CHECK_SUCCESS(mdr_contact_new(ball, film, NULL, &c));
        for (int k = 0; k < 3; k++) {
            mdr_state state;
            double sum = 0.0;
            int status;

            CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &a[k], &state));
            for (int i = 0; i <= STEPS; i++) x[i] = a[k] * i / STEPS;
            status = state_field(c, MDR_LINE_LOAD, &state, STEPS + 1, x, q);
            /* there rounding alone is 1e-10 or more, as the processor's sums are ordered: right, or refused */
            if (b == 1 && k == 2 && status == MDR_ENOCONVERGENCE) continue;
            CHECK_SUCCESS(status);
            for (int i = 0; i <= STEPS; i++) sum += q[i] * (i == 0 || i == STEPS ? 1.0 : i % 2 ? 4.0 : 2.0); /* Simpson */
            CHECK_CLOSE(2.0 * sum * a[k] / STEPS / 3.0, state.force, 1e-10);
        }
        CHECK_FREE(c);
        CHECK_FREE(film);
    }
    CHECK_FREE(ball);
}

int main(void)
{
    two_bodies();
    refusals();
    hertz();
    sneddon();
    boussinesq();
    lowest_pressure();
    other_units();
    line_load_of_a_stiff_film();
    return check_report("fields");
}
