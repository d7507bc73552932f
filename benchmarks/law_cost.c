/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of one force of a compiled law, as a ratio to one atan plus one log of the C library, measured in the same run (the least of
 * many repetitions); the law's error at a million random depths; what two threads give. Prints name and value, one pair a line. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* for the batches of two points at a time, which a processor without AVX2 gets */
#define mdrcontact_law_points law_points
#include "../src/mdrcontact/contact/law/kernel.c"
#include "measure.h"

enum { POINTS = 4096, ROUNDS = 20, REPEATS = 200, LAWS = 1000, MANY = 1000000, BIG = 400000, TRIES = 300, DIRECT = 1000 };
enum { MEMORY = 11 + 4 * 8 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static double uniform(unsigned long long *state)
{
    *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*state >> 11) * 0x1p-53;
}

/* A stiff film on a softer body under a ball; exact = 0: the paper's weights, incompressible, where F(a) is the closed form
 * (24). */
static const double R = 1e-4, h = 2e-6, G0 = 160e9, G1 = 80e9;

static mdr_contact *coated_contact(int exact)
{
    const double nu0 = exact ? 0.25 : 0.5, nu1 = exact ? 0.3 : 0.5;
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_medium_options options = MDR_SIZED(mdr_medium_options);
    check(mdr_profile_paraboloid(R, &ball));
    const mdr_layer coating = mdr_isotropic(2.0 * G0 * (1.0 + nu0), nu0, h), base = mdr_isotropic(2.0 * G1 * (1.0 + nu1), nu1, 0.0);
    options.model = exact ? MDR_MODEL_EXACT : MDR_MODEL_GAO;
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, &options, &film));
    MDR_FREE(body);
    check(mdr_contact_new(ball, film, NULL, &contact));
    MDR_FREE(ball);
    MDR_FREE(film);
    return contact;
}

/* Equation (24) of Popov 2014 */
static double closed_form(double a)
{
    const double xi = h / a, pi = acos(-1.0);
    return 16.0 * a * a * a / (3.0 * R)
           * (G1 + (G0 - G1) / (2.0 * pi) * (4.0 * atan(xi) + xi * xi * xi * log1p(1.0 / (xi * xi)) - xi));
}

/* What is measured: all points once. Returns something that depends on all of them. */
typedef struct task {
    const mdr_law *law;
    mdr_law *laws[LAWS];
    mdr_law_view view, views[LAWS];
    double x[POINTS], d[POINTS], d_of_law[POINTS], F[POINTS], slope[POINTS], a[POINTS], k[POINTS];
    int which[POINTS];
    const mdr_law *friction;
    double memory[POINTS * MEMORY], shift[3 * POINTS], T[3 * POINTS], tangent[12 * POINTS];
    double usual_T[2 * POINTS], usual_F[POINTS], usual_k[POINTS];
} task;

static double atan_and_log(task *t)
{
    double sum = 0.0;
    for (int i = 0; i < POINTS; ++i) sum += atan(t->x[i]) + log(t->x[i]);
    return sum;
}

static double inline_force(task *t)
{
    double sum = 0.0, F;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force(&t->view, t->d[i], &F);
        sum += F;
    }
    return sum;
}

/* Bodies that are apart. */
static double inline_open(task *t)
{
    double sum = 0.0, F;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force(&t->view, -t->d[i], &F);
        sum += F;
    }
    return sum;
}

/* The first bit of depth, below the compiled range. */
static double inline_first_touch(task *t)
{
    double sum = 0.0, F;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force(&t->view, 1e-4 * t->d[i], &F);
        sum += F;
    }
    return sum;
}

static double inline_slope(task *t)
{
    double sum = 0.0, F, slope;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force_slope(&t->view, t->d[i], &F, &slope);
        sum += F + slope;
    }
    return sum;
}

/* The next depth waits for this force, which is too small to change it. */
static double inline_latency(task *t)
{
    double F = 0.0, slope = 0.0;
    for (int i = 0; i < POINTS; ++i) mdr_law_view_force_slope(&t->view, t->d[i] + 1e-100 * (F + slope), &F, &slope);
    return F;
}

static double external_force(task *t)
{
    double sum = 0.0, F;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_force(t->law, MDR_ON_UNLOADING, t->d[i], &F, NULL);
        sum += F;
    }
    return sum;
}

static double external_slope(task *t)
{
    double sum = 0.0, F, slope;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_force(t->law, MDR_ON_UNLOADING, t->d[i], &F, &slope);
        sum += F + slope;
    }
    return sum;
}

static double external_latency(task *t)
{
    double F = 0.0, slope = 0.0;
    for (int i = 0; i < POINTS; ++i) mdr_law_force(t->law, MDR_ON_UNLOADING, t->d[i] + 1e-100 * (F + slope), &F, &slope);
    return F;
}

static double external_state(task *t)
{
    double sum = 0.0, a, F, k, slope, energy;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_values(t->law, MDR_DEPTH, MDR_ON_UNLOADING, 1, &t->d[i], NULL, &a, &F, &k, &slope, &energy);
        sum += energy;
    }
    return sum;
}

static double many_laws(task *t)
{
    double sum = 0.0, F, slope;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force_slope(&t->views[t->which[i]], t->d_of_law[i], &F, &slope);
        sum += F + slope;
    }
    return sum;
}

static double batch_force(task *t)
{
    mdr_law_values(t->law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, t->d, NULL, NULL, t->F, NULL, NULL, NULL);
    return t->F[7];
}

static double batch_slope(task *t)
{
    mdr_law_values(t->law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, t->d, NULL, NULL, t->F, NULL, t->slope, NULL);
    return t->F[7];
}

static double batch_all(task *t)
{
    mdr_law_values(t->law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, t->d, NULL, t->a, t->F, t->k, t->slope, NULL);
    return t->F[7];
}

static double batch_one(task *t)
{
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_values(t->law, MDR_DEPTH, MDR_ON_UNLOADING, 1, &t->d[i], NULL, NULL, &t->F[i], NULL, &t->slope[i], NULL);
    }
    return t->F[7];
}

static double plain_force(task *t)
{
    by_two(&t->view, POINTS, t->d, t->F, NULL, NULL, NULL);
    return t->F[7];
}

static double plain_slope(task *t)
{
    by_two(&t->view, POINTS, t->d, t->F, t->slope, NULL, NULL);
    return t->F[7];
}

static double plain_all(task *t)
{
    by_two(&t->view, POINTS, t->d, t->F, t->slope, t->a, t->k);
    return t->F[7];
}

static double step_with(task *t, double *tangent)
{
    mdr_law_advance(t->friction, POINTS, t->F, t->shift, 0, tangent, t->memory, t->T);
    for (int i = 0; i < 3 * POINTS; ++i) t->shift[i] = -t->shift[i];
    return t->T[21];
}

/* One step of POINTS contacts with friction, to and fro in partial slip, one slides now and then; F is that of the law. */
static double friction_step(task *t)
{
    return step_with(t, NULL);
}

/* The same with its derivatives. */
static double friction_step_with_tangent(task *t)
{
    return step_with(t, t->tangent);
}

/* The usual rule in place of it: k_t times the shift, rescaled where F falls, cut off at mu F; k_t from the law of the depth. */
static double usual_rule(task *t)
{
    const double mu = 0.3;
    mdr_law_values(t->law, MDR_FORCE, MDR_ON_UNLOADING, POINTS, t->F, NULL, NULL, NULL, t->usual_k, NULL, NULL);
    for (int i = 0; i < POINTS; ++i) {
        const double kept = t->F[i] < t->usual_F[i] ? t->F[i] / t->usual_F[i] : 1.0;
        const double x = kept * t->usual_T[2 * i] + t->usual_k[i] * t->shift[3 * i];
        const double y = kept * t->usual_T[2 * i + 1] + t->usual_k[i] * t->shift[3 * i + 1];
        const double size = sqrt(x * x + y * y), part = size > mu * t->F[i] ? mu * t->F[i] / size : 1.0;
        t->usual_T[2 * i] = part * x;
        t->usual_T[2 * i + 1] = part * y;
        t->usual_F[i] = t->F[i];
    }
    for (int i = 0; i < 3 * POINTS; ++i) t->shift[i] = -t->shift[i];
    return t->usual_T[14];
}

static const struct {
    const char *name;
    double (*run)(task *t);
} measured[] = {
    {"atan_plus_log", atan_and_log},
    {"inline", inline_force},
    {"inline_open", inline_open},
    {"inline_first_touch", inline_first_touch},
    {"inline_with_slope", inline_slope},
    {"inline_with_slope_dependent", inline_latency},
    {"scalar", external_force},
    {"scalar_with_slope", external_slope},
    {"scalar_with_slope_dependent", external_latency},
    {"state", external_state},
    {"many_laws_with_slope", many_laws},
    {"batch", batch_force},
    {"batch_with_slope", batch_slope},
    {"batch_all", batch_all},
    {"batch_of_one_with_slope", batch_one},
    {"batch_plain", plain_force},
    {"batch_plain_with_slope", plain_slope},
    {"batch_plain_all", plain_all},
    {"friction_step", friction_step},
    {"friction_step_with_tangent", friction_step_with_tangent},
    {"friction_usual_rule", usual_rule},
};
enum { MEASURED = sizeof measured / sizeof *measured };

/* Processor seconds a point of each, by turns, so that what else disturbs disturbs all of them. */
static void measure(task *t, double spent[MEASURED])
{
    double sum = 0.0;
    for (int repeat = 0; repeat < REPEATS; ++repeat) {
        for (int j = 0; j < MEASURED; ++j) {
            const double start = busy();
            for (int round = 0; round < ROUNDS; ++round) sum += measured[j].run(t);
            const double one = (busy() - start) / ((double)ROUNDS * POINTS);
            spent[j] = repeat ? least(spent[j], one) : one;
        }
    }
    if (sum == 0.5) printf("never\n");
}

static double big_batch(const mdr_law *law, const double d[], double force[], int threads)
{
    mdr_set_threads(threads);
    const double start = seconds();
    mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, BIG, d, NULL, NULL, force, NULL, NULL, NULL);
    const double taken = seconds() - start;
    mdr_set_threads(1);
    return taken;
}

/* Depths over four decades, and laws of many radii. */
static void prepare(task *t, double deepest, unsigned long long *state)
{
    check(mdr_law_view_of(t->law, MDR_ON_UNLOADING, &t->view));
    for (int i = 0; i < LAWS; ++i) {
        check(mdr_law_with_radius(t->law, R * (0.5 + uniform(state)), &t->laws[i]));
        check(mdr_law_view_of(t->laws[i], MDR_ON_UNLOADING, &t->views[i]));
    }
    for (int i = 0; i < POINTS; ++i) {
        t->d[i] = deepest * pow(10.0, -4.0 * uniform(state));
        t->x[i] = 0.01 + 10.0 * uniform(state);
        t->which[i] = (int)(LAWS * uniform(state));
        t->shift[3 * i] = 0.3 * (uniform(state) - 0.5) * t->d[i];
        t->d_of_law[i] = t->views[t->which[i]].highest * pow(10.0, -4.0 * uniform(state));
    }
}

int main(void)
{
    const double deepest = 3e-7;
    mdr_state *states = malloc(DIRECT * sizeof *states);
    double *depths = malloc(BIG * sizeof *depths), *forces = malloc(BIG * sizeof *forces), *exact = malloc(MANY * sizeof *exact);
    double *many = malloc(MANY * sizeof *many), *found = malloc(MANY * sizeof *found);
    unsigned long long state = 20140101;
    mdr_law *law = NULL, *gao_law = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr_contact *contact = coated_contact(1), *gao = coated_contact(0);

    if (!depths || !forces || !exact || !many || !found) return EXIT_FAILURE;
    double start, build = 1.0;
    for (int repeat = 0; repeat < REPEATS; ++repeat) {
        MDR_FREE(law);
        start = busy();
        check(mdr_law_new(contact, deepest, NULL, &law));
        build = least(build, busy() - start);
    }
    printf("build_seconds %.3g\n", build);
    check(mdr_law_about(law, &facts));
    printf("exact_solutions %d\n", facts.solutions);
    printf("verified_error %.2e\n", facts.error);

    static task todo;
    double spent[MEASURED];
    mdr_friction *friction = NULL;
    mdr_law *sheared = NULL;
    check(mdr_friction_new(contact, 0.3, &friction));
    start = busy();
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.friction = friction;
    check(mdr_law_new(contact, deepest, &options, &sheared));
    printf("friction_build_seconds %.3g\n", busy() - start);
    todo.law = law;
    todo.friction = sheared;
    prepare(&todo, deepest, &state);
    measure(&todo, spent);
    const double reference = spent[0];
    printf("atan_plus_log_ns %.2f\n", 1e9 * reference);
    for (int j = 1; j < MEASURED; ++j) printf("%s_ratio %.3f\n", measured[j].name, spent[j] / reference);

    for (int i = 0; i < BIG; ++i) depths[i] = deepest * pow(10.0, -4.0 * uniform(&state));
    double one = 1e9, two = 1e9;
    for (int repeat = 0; repeat < TRIES; ++repeat) {
        one = least(one, big_batch(law, depths, forces, 1));
        two = least(two, big_batch(law, depths, forces, 2));
    }
    printf("two_threads_speedup %.2f\n", one / two);

    start = busy();
    check(mdr_contact_states(gao, MDR_DEPTH, MDR_ON_UNLOADING, DIRECT, depths, states));
    for (int i = 0; i < DIRECT; ++i) exact[i] = states[i].force;
    printf("direct_solve_ratio %.0f\n", (busy() - start) / DIRECT / reference);
    start = busy();
    check(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, DIRECT, depths, states));
    for (int i = 0; i < DIRECT; ++i) exact[i] = states[i].force;
    printf("exact_solve_ratio %.0f\n", (busy() - start) / DIRECT / reference);

    /* A million random depths, each that of a random contact radius, against the closed form. */
    check(mdr_law_new(gao, deepest, NULL, &gao_law));
    for (int i = 0; i < MANY; ++i) {
        const double a = sqrt(deepest * R) * pow(10.0, -2.0 * uniform(&state));
        many[i] = a * a / R;
        exact[i] = closed_form(a);
    }
    check(mdr_law_values(gao_law, MDR_DEPTH, MDR_ON_UNLOADING, MANY, many, NULL, NULL, found, NULL, NULL, NULL));
    double worst = 0.0;
    for (int i = 0; i < MANY; ++i) worst = fmax(worst, fabs(found[i] / exact[i] - 1.0));
    printf("error_at_1e6_random_depths %.2e\n", worst);

    for (int i = 0; i < LAWS; ++i) MDR_FREE(todo.laws[i]);
    MDR_FREE(sheared);
    MDR_FREE(friction);
    MDR_FREE(law);
    MDR_FREE(gao_law);
    MDR_FREE(contact);
    MDR_FREE(gao);
    free(depths);
    free(forces);
    free(exact);
    free(many);
    free(found);
    return EXIT_SUCCESS;
}
