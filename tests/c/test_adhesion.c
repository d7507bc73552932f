/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Adhesive contacts: refusals, then JKR: F = 4 E* a^3/(3R) - sqrt(8 pi a^3 gamma E*), d = a^2/R - sqrt(2 pi a gamma/E*). */
#include "check.h"

static const double pi = 3.14159265358979323846;

static const double R = 2.0, modulus = 3.0, work = 0.05;

static int new_contact(const mdr_contact_options *options, mdr_contact **out)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    const int status = mdr_contact_new(p, m, options, out);
    CHECK_FREE(p);
    CHECK_FREE(m);
    return status;
}

static void options_refuse(void)
{
    const double bad[4] = {-1.0, NAN, INFINITY, -INFINITY};
    mdr_contact *c = NULL;
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    for (int i = 0; i < 4; i++) {
        options.work_of_adhesion = bad[i];
        CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "work_of_adhesion = ");
    }
    options.work_of_adhesion = work;
    for (int i = 0; i < 4; i++) {
        options.cohesive_stress = bad[i];
        CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "cohesive_stress = ");
    }
    options.cohesive_stress = 1.0;
    options.work_of_adhesion = 0.0;
    CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "it needs a work_of_adhesion");
    options.work_of_adhesion = work;
    options.adhesion_rule = MDR_ADHESION_PAPER;
    CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "paper");
    options.cohesive_stress = 0.0;
    options.adhesion_rule = 3;
    CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "adhesion_rule = 3");
    options.adhesion_rule = -1;
    CHECK_STATUS(new_contact(&options, &c), MDR_EINVALID, "adhesion_rule = -1");
    CHECK_TRUE(c == NULL);
}

static void branches_refuse(const mdr_contact *c, int given)
{
    const double good[1] = {0.1}, not_a_number[1] = {NAN}, far[1] = {-100.0};
    mdr_state out = {untouched, untouched, untouched, untouched, untouched, untouched};

    CHECK_STATUS(mdr_contact_states(NULL, given, MDR_ON_LOADING, 1, good, &out), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_states(c, given, MDR_ON_LOADING, -1, good, &out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_contact_states(c, given, MDR_ON_LOADING, 1, NULL, &out), MDR_ENULL, "in is NULL");
    CHECK_STATUS(mdr_contact_states(c, given, 0, 1, good, &out), MDR_EINVALID, "branch = 0");
    CHECK_STATUS(mdr_contact_states(c, given, 3, 1, good, &out), MDR_EINVALID, "branch = 3");
    CHECK_STATUS(mdr_contact_states(c, given, MDR_ON_UNLOADING, 1, not_a_number, &out), MDR_EINVALID, "NaN");
    CHECK_STATUS(mdr_contact_states(c, given, MDR_ON_UNLOADING, 1, far, &out), MDR_EUNREACHABLE, "-100");
    CHECK_CLOSE(out.depth, untouched, 0.0);
    CHECK_CLOSE(out.punch_depth, untouched, 0.0);
    CHECK_SUCCESS(mdr_contact_states(c, given, MDR_ON_LOADING, 0, NULL, NULL));
}

static void jkr(const mdr_contact *c)
{
    /* stable under force control: a above that of pull-off, a^3 = 9 pi gamma R^2/(8 E*) */
    const double a_pull_off = cbrt(9 * pi * work * R * R / (8 * modulus));
    double a[4], d[4], F[4], found[4];
    mdr_state states[4];

    for (int i = 0; i < 4; i++) {
        a[i] = a_pull_off * (1.1 + i);
        d[i] = a[i] * a[i] / R - sqrt(2 * pi * a[i] * work / modulus);
        F[i] = 4 * modulus * pow(a[i], 3) / (3 * R) - sqrt(8 * pi * pow(a[i], 3) * work * modulus);
    }
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 4, a, found, NULL, NULL, NULL));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], d[i], 1e-11);
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 4, a, NULL, NULL, found, NULL));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], F[i], 1e-11);
    CHECK_SUCCESS(columns_of(c, MDR_DEPTH, 4, d, NULL, found, NULL, NULL));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], a[i], 1e-10);
    CHECK_SUCCESS(columns_of(c, MDR_FORCE, 4, F, NULL, found, NULL, NULL));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(found[i], a[i], 1e-10);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_FORCE, MDR_ON_UNLOADING, 4, F, states));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(states[i].radius, a[i], 1e-10);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 4, d, states));
    for (int i = 0; i < 4; i++) {
        CHECK_CLOSE(states[i].radius, a[i], 1e-10);
        CHECK_CLOSE(states[i].depth, d[i], 1e-12);
        CHECK_CLOSE(states[i].force, F[i], 1e-9);
        CHECK_CLOSE(states[i].stiffness, 2 * modulus * a[i], 1e-9);
        CHECK_CLOSE(states[i].punch_depth, d[i] - a[i] * a[i] / R, 1e-9);
    }
}

/* (5.4) with k = 2 E* a, d0 = a^2/R and dl as the root of a: dF/dd = k - 2 E* dl/(2 a/R - dl/(2 a)). */
static void slopes(const mdr_contact *c)
{
    const double radii[3] = {0.2, 0.5, 2.0}, none[1] = {0.0};
    double found[3] = {untouched, untouched, untouched};
    mdr_state states[3];

    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 3, radii, states));
    CHECK_SUCCESS(mdr_contact_slope(c, 3, states, found));
    for (int i = 0; i < 3; i++) {
        const double a = radii[i], dl = sqrt(2 * pi * a * work / modulus);
        CHECK_CLOSE(found[i], 2 * modulus * a - 2 * modulus * dl / (2 * a / R - dl / (2 * a)), 1e-9 * fabs(found[i]));
    }
    CHECK_SUCCESS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_UNLOADING, 1, none, states));
    CHECK_SUCCESS(mdr_contact_slope(c, 1, states, found));
    CHECK_CLOSE(found[0], states[0].stiffness / 3, 1e-9);
    states[0].radius = 0.0;
    CHECK_SUCCESS(mdr_contact_slope(c, 1, states, found));
    CHECK_TRUE(found[0] == 0.0);
}

static void slopes_refuse(const mdr_contact *c)
{
    double found[2] = {untouched, untouched};
    mdr_state states[2];

    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 2, (const double[]){0.5, 0.6}, states));
    states[1].radius = INFINITY;
    CHECK_STATUS(mdr_contact_slope(c, 2, states, found), MDR_EINVALID, "contact radius of the state");
    CHECK_STATUS(mdr_contact_slope(NULL, 1, states, found), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_slope(c, -1, states, found), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_contact_slope(c, 1, NULL, found), MDR_ENULL, "states is NULL");
    CHECK_STATUS(mdr_contact_slope(c, 1, states, NULL), MDR_ENULL, "out is NULL");
    CHECK_UNTOUCHED(2, found);
    CHECK_SUCCESS(mdr_contact_slope(c, 0, NULL, NULL));
}

/* Pull-off at (3/2) pi gamma R under force control: a state just before, none just after. On approach none before touching. */
static void pull_off(const mdr_contact *c)
{
    const double pull_off_force = -1.5 * pi * work * R;
    const double before[1] = {0.999999 * pull_off_force}, after[1] = {1.000001 * pull_off_force};
    double a[1];
    mdr_state state;

    CHECK_SUCCESS(columns_of(c, MDR_FORCE, 1, before, NULL, a, NULL, NULL));
    CHECK_CLOSE(a[0], cbrt(9 * pi * work * R * R / (8 * modulus)), 3e-3);
    CHECK_STATUS(columns_of(c, MDR_FORCE, 1, after, NULL, a, NULL, NULL), MDR_EUNREACHABLE, "force = ");
    CHECK_STATUS(mdr_contact_states(c, MDR_DEPTH, MDR_ON_LOADING, 1, (const double[]){-0.01}, &state), MDR_EUNREACHABLE,
                 "depth = ");
}

/* Maugis 1992: with m = c/a, h(c) = (a^2/(pi R)) [(m^2 - 2) arcsec m + sqrt(m^2 - 1)]
 * + (4 sigma a/(pi E*)) [sqrt(m^2 - 1) arcsec m - m + 1] = gamma/sigma. */
static void maugis(double sigma)
{
    mdr_contact *c = NULL;
    mdr_state states[3];
    double part = 0.0;
    const double radii[3] = {0.1, 0.3, 1.0};
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work;
    options.cohesive_stress = sigma;
    CHECK_SUCCESS(mdr_set_progress(&part));
    CHECK_SUCCESS(new_contact(&options, &c));
    CHECK_SUCCESS(mdr_set_progress(NULL));
    CHECK_CLOSE(part, 1.0, 0.0);
    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 3, radii, states));
    for (int i = 0; i < 3; i++) {
        const double a = states[i].radius, m = states[i].zone_radius / a, root = sqrt(m * m - 1), angle = acos(1 / m);
        const double gap = a * a / (pi * R) * ((m * m - 2) * angle + root) + 4 * sigma * a / (pi * modulus) * (root * angle - m + 1);
        CHECK_CLOSE(gap, work / sigma, 1e-11 * work / sigma);
        CHECK_CLOSE(states[i].depth, a * a / R - 2 * sigma / modulus * a * root, 1e-13);
        CHECK_CLOSE(states[i].force, 4 * modulus * a * a * a / (3 * R) - 2 * sigma * a * a * (root + m * m * angle), 1e-12);
        double pressure = 0.0;
        CHECK_SUCCESS(state_field(c, MDR_PRESSURE, &states[i], 1, &states[i].zone_radius, &pressure));
        CHECK_CLOSE(pressure, -sigma, 1e-15);
    }
    CHECK_FREE(c);
}

int main(void)
{
    options_refuse();
    maugis(0.05);
    maugis(0.5);
    maugis(5.0);
    for (int rule = MDR_ADHESION_AUTOMATIC; rule <= MDR_ADHESION_ENERGY; rule++) {
        mdr_contact *c = NULL;
        mdr_contact_options options;
        options = MDR_SIZED(mdr_contact_options);
        options.work_of_adhesion = work;
        options.adhesion_rule = rule;
        CHECK_SUCCESS(new_contact(&options, &c));
        branches_refuse(c, MDR_DEPTH);
        branches_refuse(c, MDR_FORCE);
        jkr(c);
        slopes(c);
        slopes_refuse(c);
        pull_off(c);
        CHECK_FREE(c);
    }
    return check_report("adhesion");
}
