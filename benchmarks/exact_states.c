/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What states of exactly solved layers cost, sheared ones, too, in units of one atan + log of the C library measured in the same
 * run, beside the bound that each is held to. Prints a section of tests/data/benchmarks.md; exit status 1 if a bound is missed. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "mdrcontact.h"
#include "mdrcontact/fit.h"
#include "measure.h"

enum { ROUNDS = 9, POINTS = 4096, ARRAY = 200, FIT_POINTS = 500, PROFILES = 4, SHEARED = 5, RADII = 3, FILMS = 3, FEW = 16,
       MANY = 1000, SHIFTS = 100, RINGS = 100, SEGMENTS = 7, STEPS = 40 };

/* Seconds of one atan + log. */
static double unit(void)
{
    double sum = 0.0;
    const double start = busy();
    for (int round = 0; round < 8; ++round) {
        for (int i = 0; i < POINTS; ++i) sum += atan(0.01 + 0.013 * i) + log(0.01 + 0.013 * i);
    }
    if (sum == 0.5) printf("never\n");
    return (busy() - start) / (8.0 * POINTS);
}

/* Seconds that one call of work takes: the least of some rounds; by turns the unit. */
static double time_of(void (*work)(void *), void *with, double *one)
{
    double spent = INFINITY, start = busy();
    work(with);
    const int calls = 1 + (int)(2e-3 / (busy() - start + 1e-9));
    *one = INFINITY;
    for (int round = 0; round < ROUNDS; ++round) {
        start = busy();
        for (int call = 0; call < calls; ++call) work(with);
        spent = least(spent, (busy() - start) / calls);
        *one = least(*one, unit());
    }
    return spent;
}

/* The same in units. */
static double cost(void (*work)(void *), void *with)
{
    double one;
    const double spent = time_of(work, with, &one);
    return spent / one;
}

static int missed = 0;

static void report(const char *what, const char *under, double figure, double bound)
{
    const int held = figure <= bound;
    if (!held) ++missed;
    if (isinf(bound)) {
        printf("| %s | %s | %.2f | - | |\n", what, under, figure);
        return;
    }
    printf(bound < 10.0 ? "| %s | %s | %.2f | %.2f | %s |\n" : "| %s | %s | %.0f | %.0f | %s |\n", what, under, figure, bound,
           held ? "held" : "missed");
    fflush(stdout);
}

/* A contact and the states computed of it. */
typedef struct states {
    const mdr_contact *contact;
    int count;
    double given[ARRAY];
    mdr_state out[ARRAY];
} states;

static void from_radius(void *with)
{
    states *s = with;
    check(mdr_contact_states(s->contact, MDR_RADIUS, MDR_ON_UNLOADING, s->count, s->given, s->out));
}

static void from_depth(void *with)
{
    states *s = with;
    check(mdr_contact_states(s->contact, MDR_DEPTH, MDR_ON_UNLOADING, s->count, s->given, s->out));
}

/* Layers of thickness 1 in all on a substrate, E falling or rising to that of the substrate, 1. */
typedef struct layers {
    int count;
    mdr_layer layer[MANY];
} layers;

static mdr_medium *medium_of_layers(int count, const mdr_layer *from_surface, const mdr_layer *base)
{
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    check(mdr_body_layered(count, from_surface, base, NULL, &body));
    check(mdr_medium_new(body, NULL, &medium));
    MDR_FREE(body);
    return medium;
}

static void make_medium(void *with)
{
    layers *body = with;
    const mdr_layer base = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_medium *medium = medium_of_layers(body->count, body->layer, &base);
    MDR_FREE(medium);
}

static mdr_medium *fill_layers(layers *body, int count, double contrast)
{
    const mdr_layer base = mdr_isotropic(1.0, 0.3, 0.0);
    body->count = count;
    for (int i = 0; i < count; ++i) {
        body->layer[i] = mdr_isotropic(contrast + (1.0 - contrast) * (count > 1 ? (i + 0.5) / count : 0.0), 0.3, 1.0 / count);
    }
    return medium_of_layers(count, body->layer, &base);
}

static const char *const profile_names[SHEARED] = {"paraboloid", "cone", "flat-ended cone", "rounded cone", "r^1.5"};

/* Flat and rounded ends to 0.4 a. */
static mdr_profile *new_profile(int which, double a)
{
    mdr_profile *profile = NULL;
    check(which == 0   ? mdr_profile_paraboloid(1.0, &profile)
          : which == 1 ? mdr_profile_cone(0.1, &profile)
          : which == 2 ? mdr_profile_flat_cone(0.4 * a, 0.1, &profile)
          : which == 3 ? mdr_profile_rounded_cone(0.4 * a, 0.1, &profile)
                       : mdr_profile_power(0.5, 1.5, &profile));
    return profile;
}

/* One film: a state from its radius, the same from its depth, and an array of depths against the radii that it finds. */
static void film_states(double contrast)
{
    static const double radii[RADII] = {1.0, 10.0, 100.0};
    static const double of_radius[RADII] = {200.0, 800.0, 4000.0}, of_depth[RADII] = {600.0, 2000.0, 10000.0};
    static layers body;
    mdr_medium *film = fill_layers(&body, 1, contrast);

    for (int which = 0; which < PROFILES; ++which) {
        /* g is not smooth */
        const double kinked = which > 0 ? 3.0 : 1.0;
        for (int i = 0; i < RADII; ++i) {
            char under[80];
            states one = {.count = 1}, all = {.count = ARRAY};
            mdr_profile *profile = new_profile(which, radii[i]);
            mdr_contact *contact = NULL;
            check(mdr_contact_new(profile, film, NULL, &contact));
            snprintf(under, sizeof under, "%s, E0/E1 = %g, a/h = %g", profile_names[which], contrast, radii[i]);
            one.contact = all.contact = contact;
            one.given[0] = radii[i];
            report("from a radius", under, cost(from_radius, &one), kinked * of_radius[i]);
            one.given[0] = one.out[0].depth;
            report("from a depth", under, cost(from_depth, &one), kinked * of_depth[i]);
            for (int j = 0; j < ARRAY; ++j) all.given[j] = one.given[0] * (0.5 + 0.5 * (j + 1.0) / ARRAY);
            const double depths = cost(from_depth, &all);
            for (int j = 0; j < ARRAY; ++j) all.given[j] = all.out[j].radius;
            report("200 depths against their radii", under, depths / cost(from_radius, &all), 1.5);
            MDR_FREE(contact);
            MDR_FREE(profile);
        }
    }
    MDR_FREE(film);
}

/* First shear of a normal state at some shifts. */
typedef struct shear {
    const mdr_contact *contact;
    const mdr_friction *friction;
    mdr_state state;
    int count;
    double shift[SHIFTS];
    mdr_shear_state out[SHIFTS];
} shear;

static void partial_slip(void *with)
{
    shear *s = with;
    mdr_load *load = NULL;
    mdr_shear *sheared = NULL;
    check(mdr_contact_load(s->contact, &s->state, &load));
    check(mdr_shear_new(s->friction, load, MDR_ALONG, &sheared));
    MDR_FREE(load);
    check(mdr_shear_states(sheared, MDR_SHIFT, s->count, s->shift, s->out));
    MDR_FREE(sheared);
}

/* The load of a state, solved once, and what is read from it. */
typedef struct reading {
    const mdr_contact *contact;
    const mdr_friction *friction;
    mdr_state state;
    mdr_load *load;
    double place, shift;
} reading;

static void read_pressure(void *with)
{
    reading *s = with;
    double p;
    check(mdr_load_field(s->load, MDR_PRESSURE, 1, &s->place, &p));
}

static void solve_and_read(void *with)
{
    reading *s = with;
    check(mdr_contact_load(s->contact, &s->state, &s->load));
    read_pressure(s);
    MDR_FREE(s->load);
}

static void shear_ready(void *with)
{
    reading *s = with;
    mdr_shear *sheared = NULL;
    mdr_shear_state out;
    check(mdr_shear_new(s->friction, s->load, MDR_ALONG, &sheared));
    check(mdr_shear_states(sheared, MDR_SHIFT, 1, &s->shift, &out));
    MDR_FREE(sheared);
}

/* The pressure of a ready state at its first and at each further place, and its first sheared state, in states. */
static void load_cost(double contrast, int which, double a)
{
    static layers body;
    char under[80];
    mdr_medium *film = fill_layers(&body, 1, contrast);
    mdr_profile *profile = new_profile(which, a);
    mdr_contact *contact = NULL;
    reading ready = {.place = 0.3 * a};
    states one = {.count = 1, .given = {a}};
    check(mdr_contact_new(profile, film, NULL, &contact));
    mdr_friction *friction = NULL;
    check(mdr_friction_new(contact, 0.3, &friction));
    one.contact = ready.contact = contact;
    ready.friction = friction;
    const double from_its_radius = cost(from_radius, &one);
    ready.state = one.out[0];
    ready.shift = 0.01 * ready.state.depth;
    one.given[0] = ready.state.depth;
    const double from_its_depth = cost(from_depth, &one);
    const double first = cost(solve_and_read, &ready);
    check(mdr_contact_load(contact, &ready.state, &ready.load));
    const double next = cost(read_pressure, &ready), sheared = cost(shear_ready, &ready);
    MDR_FREE(ready.load);
    for (int by_depth = 1; by_depth >= 0; --by_depth) {
        const double state = by_depth ? from_its_depth : from_its_radius;
        snprintf(under, sizeof under, "%s, E0/E1 = %g, a/h = %g, in states from a %s", profile_names[which], contrast, a,
                 by_depth ? "depth" : "radius");
        report("first pressure of a state", under, first / state, 1.5);
        report("each further one", under, next / state, INFINITY);
        report("first sheared state of a load", under, sheared / state, 8.0);
    }
    MDR_FREE(friction);
    MDR_FREE(contact);
    MDR_FREE(profile);
    MDR_FREE(film);
}

/* Partial slip at a = h, the mean over all shifts below sliding, against a normal state from its depth. */
static void partial_slip_cost(double contrast)
{
    static layers body;
    mdr_medium *film = fill_layers(&body, 1, contrast);

    for (int which = 0; which < SHEARED; ++which) {
        char under[80];
        mdr_shear_facts facts = MDR_SIZED(mdr_shear_facts);
        mdr_load *load = NULL;
        mdr_shear *sheared = NULL;
        states one = {.count = 1, .given = {1.0}};
        shear first = {.count = 1}, all = {.count = SHIFTS};
        mdr_profile *profile = new_profile(which, 1.0);
        mdr_contact *contact = NULL;
        mdr_friction *friction = NULL;
        check(mdr_contact_new(profile, film, NULL, &contact));
        check(mdr_friction_new(contact, 0.3, &friction));
        one.contact = contact;
        from_radius(&one);
        all.contact = contact;
        all.friction = friction;
        check(mdr_contact_states(contact, MDR_RADIUS, MDR_ON_UNLOADING, 1, one.given, &all.state));
        check(mdr_contact_load(contact, &all.state, &load));
        check(mdr_shear_new(friction, load, MDR_ALONG, &sheared));
        MDR_FREE(load);
        check(mdr_shear_about(sheared, &facts));
        MDR_FREE(sheared);
        for (int i = 0; i < SHIFTS; ++i) all.shift[i] = facts.sliding_shift * (i + 0.5) / SHIFTS;
        first.contact = contact;
        first.friction = friction;
        first.state = all.state;
        first.shift[0] = 0.5 * facts.sliding_shift;
        one.given[0] = one.out[0].depth;
        snprintf(under, sizeof under, "%s, E0/E1 = %g, a/h = 1", profile_names[which], contrast);
        const double normal = cost(from_depth, &one);
        report("partial slip, in states from a depth", under, cost(partial_slip, &all) / (SHIFTS * normal), 5.0);
        report("the first of a normal state, in the same", under, cost(partial_slip, &first) / normal, INFINITY);
        MDR_FREE(friction);
        MDR_FREE(contact);
        MDR_FREE(profile);
    }
    MDR_FREE(film);
}

/* A history by rings along a path of straight segments in depth and shift. */
typedef struct path {
    const mdr_friction *friction;
    double depth[SEGMENTS * STEPS], shift[SEGMENTS * STEPS], deepest;
    mdr_state states[SEGMENTS * STEPS];
    mdr_shear_state out[SEGMENTS * STEPS];
} path;

static void new_history(void *with)
{
    path *p = with;
    mdr_friction_history *history = NULL;
    check(mdr_friction_history_new(p->friction, p->deepest, RINGS, &history));
    MDR_FREE(history);
}

static void follow(void *with)
{
    path *p = with;
    mdr_friction_history *history = NULL;
    check(mdr_friction_history_new(p->friction, p->deepest, RINGS, &history));
    check(mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, SEGMENTS * STEPS, p->depth, p->shift, p->states,
                                       p->out));
    MDR_FREE(history);
}

/* The path of tests/data/friction_history.csv, there and here to 2e-4 of the friction force (ctest -R test_friction_history). */
static void history_cost(double contrast)
{
    static const double radius[SEGMENTS] = {1.2, 1.2, 1.2, 0.8, 0.8, 1.4, 1.0};
    static const double shift[SEGMENTS] = {0.2, 0.35, -0.2, -0.2, 0.1, 0.3, 0.0};
    static layers body;
    static path p;
    char under[80];
    mdr_medium *film = fill_layers(&body, 1, contrast);
    mdr_profile *profile = new_profile(0, 1.0);
    mdr_contact *contact = NULL;
    mdr_friction *friction = NULL;
    mdr_state reached[SEGMENTS];
    double depth[SEGMENTS], last_depth = 0.0, last_shift = 0.0, one;
    check(mdr_contact_new(profile, film, NULL, &contact));
    check(mdr_friction_new(contact, 0.3, &friction));
    check(mdr_contact_states(contact, MDR_RADIUS, MDR_ON_UNLOADING, SEGMENTS, radius, reached));
    for (int i = 0; i < SEGMENTS; ++i) depth[i] = reached[i].depth;
    p.friction = friction;
    p.deepest = 0.0;
    for (int i = 0; i < SEGMENTS; ++i) {
        for (int j = 0; j < STEPS; ++j) {
            const double part = (j + 1.0) / STEPS;
            p.depth[i * STEPS + j] = last_depth + part * (depth[i] - last_depth);
            p.shift[i * STEPS + j] = last_shift + part * (shift[i] - last_shift);
        }
        last_depth = depth[i];
        last_shift = shift[i];
        p.deepest = fmax(p.deepest, 1.000001 * depth[i]);
    }
    snprintf(under, sizeof under, "paraboloid, E0/E1 = %g, %d rings, %d steps", contrast, RINGS, SEGMENTS * STEPS);
    const double made = time_of(new_history, &p, &one), followed = time_of(follow, &p, &one);
    report("a step of a history with friction, in ms", under, 1e3 * (followed - made) / (SEGMENTS * STEPS), 1.0);
    MDR_FREE(friction);
    MDR_FREE(contact);
    MDR_FREE(profile);
    MDR_FREE(film);
}

static void medium_cost(double contrast)
{
    static layers body;
    char under[80];
    mdr_medium *film = fill_layers(&body, 1, contrast);
    MDR_FREE(film);
    snprintf(under, sizeof under, "one film, E0/E1 = %g", contrast);
    report("making the medium", under, cost(make_medium, &body), 30000.0);
}

/* What a cohesive zone costs at one contact radius, in states of the same radius without a range. */
static void zone_cost(double contrast)
{
    static layers body;
    static const double radii[] = {0.1, 1.0, 5.0}, stresses[] = {0.2, 5.0};
    mdr_medium *film = fill_layers(&body, 1, contrast);
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = 0.2;
    for (int which = 0; which < 2; ++which) {
        mdr_profile *profile = new_profile(which, 1.0);
        mdr_contact *sticky = NULL, *ranged = NULL;
        options.cohesive_stress = 0.0;
        check(mdr_contact_new(profile, film, &options, &sticky));
        for (int j = 0; j < 2; ++j) {
            options.cohesive_stress = stresses[j];
            check(mdr_contact_new(profile, film, &options, &ranged));
            for (int i = 0; i < 3; ++i) {
                char under[100];
                states with = {.contact = ranged, .count = 1, .given = {radii[i]}};
                states without = {.contact = sticky, .count = 1, .given = {radii[i]}};
                snprintf(under, sizeof under, "%s, E0/E1 = %g, a/h = %g, sigma = %g", profile_names[which], contrast, radii[i],
                         stresses[j]);
                report("a cohesive zone, in states without", under, cost(from_radius, &with) / cost(from_radius, &without), 4.0);
            }
            MDR_FREE(ranged);
        }
        MDR_FREE(sticky);
        MDR_FREE(profile);
    }
    MDR_FREE(film);
}

static void layers_cost(int count, double bound)
{
    static layers body;
    char under[80];
    states one = {.count = 1, .given = {1.0}};
    mdr_medium *medium = fill_layers(&body, count, 10.0);
    mdr_profile *profile = new_profile(0, 1.0);
    mdr_contact *contact = NULL;
    check(mdr_contact_new(profile, medium, NULL, &contact));
    one.contact = contact;
    snprintf(under, sizeof under, "paraboloid, %d layers, a = all of them", count);
    report("from a radius", under, cost(from_radius, &one), bound);
    MDR_FREE(contact);
    MDR_FREE(profile);
    MDR_FREE(medium);
}

/* A force-depth curve of a film, with noise of 1 %, from which its modulus and thickness are found again. */
typedef struct curve {
    double depth[FIT_POINTS], force[FIT_POINTS], sd[FIT_POINTS];
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[64];
} curve;

static void solve_fit(void *with)
{
    curve *c = with;
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    check(mdr_fit_solve(&c->problem, FIT_POINTS, c->depth, c->force, NULL, c->sd, NULL, NULL, NULL, NULL, NULL, NULL, NULL,
                        &summary));
}

static void fit_cost(void)
{
    static curve c;
    unsigned long long state = 20140101;
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    check(mdr_profile_paraboloid(10e-6, &ball));
    const mdr_layer coating = mdr_isotropic(72e9, 0.17, 500e-9), base = mdr_isotropic(163e9, 0.22, 0.0);
    film = medium_of_layers(1, &coating, &base);
    c.problem = MDR_SIZED(mdr_fit_problem);
    c.problem.profile = ball;
    c.problem.medium = film;
    c.problem.parameters = c.parameters;
    check(mdr_fit_parameters(&c.problem, 64, c.parameters, &c.problem.parameter_count));
    for (int i = 0; i < FIT_POINTS; ++i) c.depth[i] = 0.2e-9 + 99.8e-9 * i / (FIT_POINTS - 1);
    check(mdr_fit_predict(&c.problem, FIT_POINTS, c.depth, c.depth, NULL, c.force, NULL));
    for (int i = 0; i < FIT_POINTS; ++i) {
        /* a sum of uniform numbers, of standard deviation 1 */
        double noise = -6.0;
        for (int j = 0; j < 12; ++j) {
            state = state * 6364136223846793005ULL + 1442695040888963407ULL;
            noise += (double)(state >> 11) * 0x1p-53;
        }
        c.sd[i] = 0.01 * c.force[i];
        c.force[i] += c.sd[i] * noise;
    }
    c.parameters[1] = (mdr_fit_parameter){.value = 60e9, .lower = 1e9, .upper = 1e12, .is_free = 1};
    c.parameters[3] = (mdr_fit_parameter){.value = 450e-9, .lower = 1e-9, .upper = 1e-5, .is_free = 1};
    report("fit of 500 points", "E and h of a film under a paraboloid", cost(solve_fit, &c), 345000.0);
    MDR_FREE(film);
    MDR_FREE(ball);
}

int main(void)
{
    static const double contrasts[FILMS] = {0.01, 2.0, 100.0};
    double one = INFINITY;
    for (int i = 0; i < 100; ++i) one = least(one, unit());
    printf("\n## States of exactly solved layers\n\n"
           "Made by `benchmarks/exact_states.c`, all in one run; processor time of one thread in units of one atan + log of this\n"
           "run, %.1f ns, unless the row says otherwise. Flat and rounded ends reach to 0.4 a. Partial slip: the mean over 100\n"
           "shifts of one normal state, whose line load and lowest pressure they share; a first state has to find those, too.\n"
           "Histories: by 100 rings, at which T is good to 2e-4 of the friction force.\n\n",
           1e9 * one);
    printf("| what | under what | figure | bound | |\n|---|---|---|---|---|\n");
    for (int i = 0; i < FILMS; ++i) film_states(contrasts[i]);
    for (int i = 0; i < 2; ++i) partial_slip_cost(contrasts[i]);
    for (int which = 0; which < PROFILES; which += PROFILES - 1) {
        load_cost(2.0, which, 1.0);
        load_cost(2.0, which, 10.0);
    }
    history_cost(0.1);
    history_cost(2.0);
    for (int i = 0; i < FILMS; ++i) medium_cost(contrasts[i]);
    for (int i = 0; i < FILMS; i += 2) zone_cost(contrasts[i]);
    layers_cost(FEW, 1500.0);
    layers_cost(MANY, 15000.0);
    fit_cost();
    if (missed) fprintf(stderr, "%d bounds are missed\n", missed);
    return missed ? EXIT_FAILURE : EXIT_SUCCESS;
}
