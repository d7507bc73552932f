/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of one force of a compiled law, as a ratio to one atan plus one log of the C library, measured in the same run; the law's error at a
 * million random depths; what two threads give. Prints name and value, one pair a line. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "mdrcontact.h"

enum { POINTS = 4096, ROUNDS = 2000, REPEATS = 9, MANY = 1000000, BIG = 400000, TRIES = 300, DIRECT = 1000 };

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void check(int status)
{
    char text[512];
    if (status == MDR_SUCCESS) return;
    mdr_last_error(text, sizeof text);
    fprintf(stderr, "%s: %s\n", mdr_status_name(status), text);
    exit(EXIT_FAILURE);
}

static double uniform(unsigned long long *state)
{
    *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(*state >> 11) * 0x1p-53;
}

/* A stiff film on a softer body under a ball; exact = 0: the paper's weights, incompressible, where F(a) is the closed form (24). */
static const double R = 1e-4, h = 2e-6, G0 = 160e9, G1 = 80e9;

static mdr_contact *coated_contact(int exact)
{
    const double nu0 = exact ? 0.25 : 0.5, nu1 = exact ? 0.3 : 0.5;
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    check(mdr_profile_paraboloid(R, &ball));
    check(mdr_medium_coated(2.0 * G0 * (1.0 + nu0), nu0, h, 2.0 * G1 * (1.0 + nu1), nu1,
                            exact ? MDR_MODEL_EXACT : MDR_MODEL_GAO, NULL, &film));
    check(mdr_contact_new(ball, film, NULL, &contact));
    mdr_profile_free(&ball);
    mdr_medium_free(&film);
    return contact;
}

/* Equation (24) of Popov 2014 */
static double closed_form(double a)
{
    const double xi = h / a, pi = acos(-1.0);
    return 16.0 * a * a * a / (3.0 * R)
           * (G1 + (G0 - G1) / (2.0 * pi) * (4.0 * atan(xi) + xi * xi * xi * log1p(1.0 / (xi * xi)) - xi));
}

static double atan_and_log(const double x[])
{
    double sum = 0.0;
    const double start = seconds();
    for (int round = 0; round < ROUNDS; ++round)
        for (int i = 0; i < POINTS; ++i) sum += atan(x[i]) + log(x[i]);
    const double spent = seconds() - start;
    if (sum == 0.5) printf("never\n");
    return spent / ((double)ROUNDS * POINTS);
}

static double one_by_one(const mdr_law *law, const double d[], int with_slope)
{
    double sum = 0.0, force, slope = 0.0;
    const double start = seconds();
    for (int round = 0; round < ROUNDS; ++round)
        for (int i = 0; i < POINTS; ++i) {
            mdr_law_force(law, MDR_ON_UNLOADING, d[i], &force, with_slope ? &slope : NULL);
            sum += force + slope;
        }
    const double spent = seconds() - start;
    if (sum == 0.5) printf("never\n");
    return spent / ((double)ROUNDS * POINTS);
}

static double in_batch(const mdr_law *law, const double d[], double force[])
{
    const double start = seconds();
    for (int round = 0; round < ROUNDS; ++round)
        mdr_law_from_depth(law, MDR_ON_UNLOADING, POINTS, d, force, NULL, NULL, NULL);
    return (seconds() - start) / ((double)ROUNDS * POINTS);
}

static double big_batch(const mdr_law *law, const double d[], double force[], int threads)
{
    mdr_set_threads(threads);
    const double start = seconds();
    mdr_law_from_depth(law, MDR_ON_UNLOADING, BIG, d, force, NULL, NULL, NULL);
    const double taken = seconds() - start;
    mdr_set_threads(1);
    return taken;
}

static double least(double a, double b) { return a < b ? a : b; }

int main(void)
{
    const double deepest = 3e-7;
    static double x[POINTS], d[POINTS], force[POINTS];
    double *depths = malloc(BIG * sizeof *depths), *forces = malloc(BIG * sizeof *forces), *exact = malloc(MANY * sizeof *exact);
    double *many = malloc(MANY * sizeof *many), *found = malloc(MANY * sizeof *found);
    unsigned long long state = 20140101;
    mdr_law *law = NULL, *gao_law = NULL;
    mdr_law_facts facts;
    mdr_contact *contact = coated_contact(1), *gao = coated_contact(0);

    if (!depths || !forces || !exact || !many || !found) return EXIT_FAILURE;
    double start = seconds();
    check(mdr_law_new(contact, deepest, NULL, &law));
    printf("build_seconds %.3g\n", seconds() - start);
    check(mdr_law_info(law, &facts));
    printf("exact_solutions %d\n", facts.solutions);
    printf("verified_error %.2e\n", facts.error);

    for (int i = 0; i < POINTS; ++i) {
        d[i] = deepest * pow(10.0, -4.0 * uniform(&state));
        x[i] = 0.01 + 10.0 * uniform(&state);
    }
    double reference = 1.0, scalar = 1.0, with_slope = 1.0, batch = 1.0;
    for (int repeat = 0; repeat < REPEATS; ++repeat) {
        reference = least(reference, atan_and_log(x));
        scalar = least(scalar, one_by_one(law, d, 0));
        with_slope = least(with_slope, one_by_one(law, d, 1));
        batch = least(batch, in_batch(law, d, force));
    }
    printf("atan_plus_log_ns %.2f\n", 1e9 * reference);
    printf("scalar_ratio %.3f\n", scalar / reference);
    printf("scalar_with_slope_ratio %.3f\n", with_slope / reference);
    printf("batch_ratio %.3f\n", batch / reference);

    for (int i = 0; i < BIG; ++i) depths[i] = deepest * pow(10.0, -4.0 * uniform(&state));
    double one = 1e9, two = 1e9;
    for (int repeat = 0; repeat < TRIES; ++repeat) {
        one = least(one, big_batch(law, depths, forces, 1));
        two = least(two, big_batch(law, depths, forces, 2));
    }
    printf("two_threads_speedup %.2f\n", one / two);

    start = seconds();
    check(mdr_contact_from_depth(gao, DIRECT, depths, NULL, NULL, exact, NULL));
    printf("direct_solve_ratio %.0f\n", (seconds() - start) / DIRECT / reference);
    start = seconds();
    check(mdr_contact_from_depth(contact, DIRECT, depths, NULL, NULL, exact, NULL));
    printf("exact_solve_ratio %.0f\n", (seconds() - start) / DIRECT / reference);

    /* A million random depths, each that of a random contact radius, against the closed form. */
    check(mdr_law_new(gao, deepest, NULL, &gao_law));
    for (int i = 0; i < MANY; ++i) {
        const double a = sqrt(deepest * R) * pow(10.0, -2.0 * uniform(&state));
        many[i] = a * a / R;
        exact[i] = closed_form(a);
    }
    check(mdr_law_from_depth(gao_law, MDR_ON_UNLOADING, MANY, many, found, NULL, NULL, NULL));
    double worst = 0.0;
    for (int i = 0; i < MANY; ++i) worst = fmax(worst, fabs(found[i] / exact[i] - 1.0));
    printf("error_at_1e6_random_depths %.2e\n", worst);

    mdr_law_free(&law);
    mdr_law_free(&gao_law);
    mdr_contact_free(&contact);
    mdr_contact_free(&gao);
    free(depths);
    free(forces);
    free(exact);
    free(many);
    free(found);
    return EXIT_SUCCESS;
}
