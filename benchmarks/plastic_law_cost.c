/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cost of a step of a plastic law against force and slope of the elastic law of the same bodies, one contact at a time and in arrays,
 * and of a million contacts. Prints tables. Fails if a step in arrays takes more than 2.5 times the elastic law in arrays. */
#define _POSIX_C_SOURCE 200809L
#include "mdrcontact/plastic.h"
#include "mdrcontact_plastic_law.h"
#include "measure.h"

enum { POINTS = 4096, REPEATS = 400, MANY = 1000000, TRIES = 5, NUMBERS = 20000 };
static const double E = 200e9, nu = 0.3, Y = 1e9, R = 1e-3, deepest = 10e-6, budget = 2.5;

typedef struct task {
    mdr_law_view elastic;
    mdr_plastic_view plastic;
    const mdr_law *elastic_law;
    const mdr_plastic_law *plastic_law;
    double d[POINTS], shallow[POINTS], zero[POINTS], loaded[POINTS], memory[POINTS], F[POINTS], slope[POINTS];
} task;

/* One contact at a time, by the inline functions. */
static double elastic_one(task *t)
{
    double sum = 0.0, F, slope;
    for (int i = 0; i < POINTS; ++i) {
        mdr_law_view_force_slope(&t->elastic, t->d[i], &F, &slope);
        sum += F + slope;
    }
    return sum;
}

static double one(task *t, const double start[], const double d[])
{
    double sum = 0.0, F, slope;
    memcpy(t->memory, start, sizeof t->memory);
    for (int i = 0; i < POINTS; ++i) {
        mdr_plastic_view_advance(&t->plastic, d[i], &t->memory[i], &F, &slope);
        sum += F + slope;
    }
    return sum;
}

/* In arrays. */
static double elastic_all(task *t)
{
    check(mdr_law_values(t->elastic_law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, t->d, NULL, NULL, t->F, NULL, t->slope, NULL));
    return t->F[7];
}

static double all(task *t, const double start[], const double d[])
{
    memcpy(t->memory, start, sizeof t->memory);
    check(mdr_plastic_law_advance(t->plastic_law, POINTS, d, 0, t->memory, t->F, t->slope, NULL));
    return t->F[7];
}

static double before_yield(task *t) { return one(t, t->zero, t->shallow); }
static double first_loading(task *t) { return one(t, t->zero, t->d); }
static double unloading(task *t) { return one(t, t->loaded, t->d); }
static double before_yield_all(task *t) { return all(t, t->zero, t->shallow); }
static double first_loading_all(task *t) { return all(t, t->zero, t->d); }
static double unloading_all(task *t) { return all(t, t->loaded, t->d); }

static const struct {
    const char *name;
    double (*one)(task *), (*all)(task *);
} measured[] = {
    {"elastic law", elastic_one, elastic_all},
    {"before yield", before_yield, before_yield_all},
    {"first loading", first_loading, first_loading_all},
    {"unloading, reloading", unloading, unloading_all},
};
enum { MEASURED = sizeof measured / sizeof *measured };

static volatile double sink;

/* Least times for one point [ns], by turns, so that what else disturbs disturbs all of them. */
static void costs(task *t, double of_one[MEASURED], double of_all[MEASURED])
{
    for (int j = 0; j < MEASURED; ++j) of_one[j] = of_all[j] = 1e9;
    for (int i = 0; i < REPEATS; ++i) {
        for (int j = 0; j < MEASURED; ++j) {
            const double start = busy();
            sink += measured[j].one(t);
            const double middle = busy();
            sink += measured[j].all(t);
            of_one[j] = least(of_one[j], 1e9 * (middle - start) / POINTS);
            of_all[j] = least(of_all[j], 1e9 * (busy() - middle) / POINTS);
        }
    }
}

static mdr_plastic_law *make(task *t)
{
    static double numbers[NUMBERS];
    const double strain = 0.0;
    mdr_profile *ball = NULL;
    mdr_yielding *steel = NULL;
    mdr_plastic_law *law = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_law *elastic = NULL;
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    const mdr_layer base = mdr_isotropic(E, nu, 0.0);
    check(mdr_profile_paraboloid(R, &ball));
    check(mdr_yielding_new(E, nu, 1, &strain, &Y, &steel));
    check(mdr_plastic_law_new(ball, steel, deepest, NULL, &law));
    check(mdr_plastic_law_buffer(law, NUMBERS, numbers));
    check(mdr_plastic_view_at(numbers, numbers, &t->plastic));
    check(mdr_plastic_law_about(law, &facts));
    check(mdr_body_layered(0, NULL, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &medium));
    check(mdr_contact_new(ball, medium, NULL, &contact));
    check(mdr_law_new(contact, deepest, NULL, &elastic));
    check(mdr_law_view_of(elastic, MDR_ON_UNLOADING, &t->elastic)); /* lives as long as the program */
    t->elastic_law = elastic;
    t->plastic_law = law;
    unsigned long long state = 1;
    for (int i = 0; i < POINTS; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double x = (double)(state >> 11) * 0x1p-53;
        double left;
        t->d[i] = facts.yield_depth + (0.98 * deepest - facts.yield_depth) * x;
        t->shallow[i] = facts.yield_depth * (0.05 + 0.9 * x);
        t->zero[i] = 0.0;
        /* closed on unloading: the largest depth a little beyond */
        t->loaded[i] = t->d[i] * 1.02;
        check(mdr_plastic_law_loading(law, 1, &t->loaded[i], NULL, NULL, &left, NULL));
        t->d[i] = left + 0.7 * (t->loaded[i] - left) > facts.yield_depth ? left + 0.7 * (t->loaded[i] - left) : t->d[i];
    }
    return law;
}

/* Time of a step of a million contacts in arrays [s]. */
static double arrays(const mdr_plastic_law *law, const double d[], double memory[], double F[], double slope[], double a[])
{
    double best = 1e9;
    for (int i = 0; i < TRIES; ++i) {
        const double start = busy();
        check(mdr_plastic_law_advance(law, MANY, d, 0, memory, F, slope, a));
        best = least(best, busy() - start);
    }
    return best;
}

int main(void)
{
    static task t;
    mdr_plastic_law *law = make(&t);
    double *d = malloc(5 * MANY * sizeof *d), of_one[MEASURED], of_all[MEASURED];
    int late = 0;
    if (!d) return EXIT_FAILURE;
    check(mdr_set_threads(1));
    costs(&t, of_one, of_all);
    puts("## Laws of bodies that yield\n\nForce and slope of a step, one thread.\n");
    puts("| step | one at a time [ns] | over the elastic law | in arrays [ns] | over the elastic law, budget 2.5 |\n|---|---|---|---|---|");
    for (int i = 0; i < MEASURED; ++i) {
        printf("| %s | %.1f | %.2f | %.1f | %.2f |\n", measured[i].name, of_one[i], of_one[i] / of_one[0], of_all[i],
               of_all[i] / of_all[0]);
        late = late || of_all[i] > budget * of_all[0];
    }
    double *memory = d + MANY, *F = d + 2 * MANY, *slope = d + 3 * MANY, *a = d + 4 * MANY;
    for (int i = 0; i < MANY; ++i) {
        d[i] = t.d[i % POINTS];
        memory[i] = 0.0;
    }
    const double loading = arrays(law, d, memory, F, slope, a);
    for (int i = 0; i < MANY; ++i) memory[i] = t.loaded[i % POINTS];
    const double back = arrays(law, d, memory, F, slope, a);
    printf("\n| a million contacts in arrays: force, slope, radius | time [ms] |\n|---|---|\n");
    printf("| first loading | %.1f |\n| unloading | %.1f |\n", 1e3 * loading, 1e3 * back);
    free(d);
    MDR_FREE(law);
    return late ? EXIT_FAILURE : EXIT_SUCCESS;
}
