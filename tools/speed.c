/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What speed.py cannot time: forces of a compiled law by the header's inline functions. Prints a name and nanoseconds a point. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>

#include "mdrcontact_law.h"
#include "../benchmarks/measure.h"

enum { POINTS = 4096, ROUNDS = 200 };

static mdr_law_view view;
static double d[POINTS], sum = 0.0;

static void force(void)
{
    double F;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force(&view, d[i], &F);
        sum += F;
    }
}

static void force_and_slope(void)
{
    double F, slope;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force_slope(&view, d[i], &F, &slope);
        sum += F + slope;
    }
}

static void report(const char *name, void (*work)(void))
{
    double spent = INFINITY;
    for (int round = 0; round < ROUNDS; ++round) {
        const double start = busy();
        work();
        spent = least(spent, busy() - start);
    }
    printf("%s: %.6g\n", name, 1e9 * spent / POINTS);
}

int main(void)
{
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    check(mdr_profile_paraboloid(1e-4, &ball));
    const mdr_layer coating = mdr_isotropic(400e9, 0.25, 2e-6), base = mdr_isotropic(208e9, 0.3, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &film));
    check(mdr_free(body));
    check(mdr_contact_new(ball, film, NULL, &contact));
    check(mdr_law_new(contact, 3e-7, NULL, &law));
    check(mdr_law_view_of(law, MDR_ON_UNLOADING, &view));
    for (int i = 0; i < POINTS; ++i) d[i] = 3e-7 * pow(10.0, -4.0 * i / POINTS);
    report("force inline", force);
    report("force and slope inline", force_and_slope);
    for (unsigned long long i = 0, seed = 1; i < POINTS; ++i) {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        d[i] = 3e-7 * pow(10.0, -4.0 * (double)(seed >> 11) * 0x1p-53);
    }
    report("force and slope inline, at random", force_and_slope);
    return sum == 0.5;
}
