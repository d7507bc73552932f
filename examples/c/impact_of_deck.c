/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The impact of examples/legacy/impact.f in C, with damping: the input deck impact.inp names the file of a compiled law, made by
 * `mdrcontact law problem.toml painted_plate.law` or by any program that saves one, and the time loop evaluates it inline.
 *
 * Damping after Hunt and Crossley, F (1 + lambda v), with the coefficient of restitution prescribed: exact for every law
 * (docs/laws.md). SI units.
 */
#include <mdrcontact_law.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
        exit(EXIT_FAILURE);
    }
}

/* lambda v0 for a coefficient of restitution 0 < e < 1: the root of c (1 + e) = ln((1 + c)/(1 - e c)). */
static double damping(double e)
{
    double low = 1e-9, high = 1.0 / e;
    while (high - low > 1e-14 * high) {
        const double c = 0.5 * (low + high);
        if (c * (1.0 + e) > log1p(c) - log1p(-e * c)) {
            low = c;
        } else {
            high = c;
        }
    }
    return low;
}

/* Speed after an impact, by the leap-frog scheme. */
static double rebound(const mdr_law_view *view, double mass, double speed, double step, double e)
{
    const double lambda = damping(e) / speed;
    double d = 0.0, v = speed, F = 0.0;
    do {
        v -= 0.5 * step * F * (1.0 + lambda * v) / mass;
        d += step * v;
        check(mdr_law_view_force(view, d, &F));
        /* this half step is implicit: the damping is that of the new speed */
        v = (v - 0.5 * step * F / mass) / (1.0 + 0.5 * step * F * lambda / mass);
    } while (d > 0.0);
    return -v;
}

int main(void)
{
    char name[256];
    double mass, speed, step, worst = 0.0;
    mdr_law *law = NULL;
    mdr_law_view view;
    FILE *deck = fopen("impact.inp", "r");

    if (!deck || fscanf(deck, "%255s %lf %lf %lf", name, &mass, &speed, &step) != 4) {
        fprintf(stderr, "impact.inp cannot be read\n");
        return EXIT_FAILURE;
    }
    fclose(deck);
    check(mdr_law_load(name, &law));
    check(mdr_law_view_of(law, MDR_ON_UNLOADING, &view));
    for (int i = 1; i < 10; i += 2) {
        const double e = 0.1 * i, found = rebound(&view, mass, speed, step, e) / speed;
        printf("coefficient of restitution: prescribed %.1f, found %.4f\n", e, found);
        worst = fmax(worst, fabs(found - e));
    }
    check(mdr_free(law));
    return worst < 1e-3 ? EXIT_SUCCESS : EXIT_FAILURE;
}
