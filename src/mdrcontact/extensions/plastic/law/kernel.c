/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steps of many plastic contacts: the inline functions of mdrcontact_plastic_law.h, called from Fortran.
 */
#include "mdrcontact_plastic_law.h"

int mdrcontact_plastic_view(const double *buffer, mdr_plastic_view *view);
int mdrcontact_plastic_view(const double *buffer, mdr_plastic_view *view) { return mdr_plastic_view_at(buffer, buffer, view); }

/* A function without branches in its loops, for the vectors of the processor, which are found at run time: the bits stay the same. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define FOR_PROCESSORS(type, name, parameters, arguments)                                                                      \
    __attribute__((target("avx2"), flatten)) static type name##_by_four parameters { return name##_plain arguments; }          \
    __attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512"), flatten)) static type name##_by_eight parameters \
    {                                                                                                                          \
        return name##_plain arguments;                                                                                         \
    }                                                                                                                          \
    static type name parameters                                                                                                \
    {                                                                                                                          \
        if (__builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) return name##_by_eight arguments;        \
        return __builtin_cpu_supports("avx2") ? name##_by_four arguments : name##_plain arguments;                             \
    }
#else
#define FOR_PROCESSORS(type, name, parameters, arguments)                                                                      \
    static type name parameters { return name##_plain arguments; }
#endif

/* Whether n steps of contacts with one number of memory certainly have no error, up to a largest depth. */
static inline int possible_plain(double highest, double largest, int n, const double depth[], const double memory[])
{
    int possible = 0;
    for (int i = 0; i < n; ++i) {
        possible += depth[i] <= largest && depth[i] >= -DBL_MAX && memory[i] >= 0.0 && memory[i] <= highest ? 1 : 0;
    }
    return possible == n;
}

FOR_PROCESSORS(int, possible, (double highest, double largest, int n, const double depth[], const double memory[]),
               (highest, largest, n, depth, memory))

int mdrcontact_plastic_possible(const mdr_plastic_view *view, double largest, int n, const double depth[], const double memory[]);
int mdrcontact_plastic_possible(const mdr_plastic_view *view, double largest, int n, const double depth[], const double memory[])
{
    return possible(view->highest, largest, n, depth, memory);
}

/* Contacts that are stepped together; of them those below their largest depth, unless all are. */
enum { BLOCK = 256 };
typedef struct block {
    int place[BLOCK];
    double deepest[BLOCK], d[BLOCK], column[4 * BLOCK], F[BLOCK], slope[BLOCK], a[BLOCK];
} block;

/* What is written lies in the block: outputs may lie on the input. */
static inline void unload(const mdr_plastic_view *view, int n, const double deepest[], const double d[], block *b)
{
    double *restrict const column = b->column, *restrict const F = b->F, *restrict const slope = b->slope, *restrict const a = b->a;
    for (int i = 0; i < n; ++i) mdr_plastic_columns(view, deepest[i], column + 4 * i);
    for (int i = 0; i < n; ++i) {
        const mdr_plastic_imprint imprint = mdr_plastic_imprint_from(view, column + 4 * i);
        mdr_plastic_unload(&imprint, deepest[i] - d[i], &F[i], &slope[i], &a[i]);
    }
}

static inline void deliver(const block *b, int all, int count, const double from[], double to[])
{
    if (!to) return;
    if (count == all) memcpy(to, from, (size_t)count * sizeof *to);
    else
        for (int i = 0; i < count; ++i) to[b->place[i]] = from[i];
}

/* Steps of those of n contacts without adhesion that are below their largest depth; their number. */
static inline int unload_block_plain(const mdr_plastic_view *of, block *b, int n, const double d[], const double memory[], double F[],
                                     double slope[], double a[])
{
    const mdr_plastic_view view = *of; /* a copy: what is written cannot change it */
    int all = 0, count = 0;
    for (int i = 0; i < n; ++i) all += mdr_plastic_is_below(&view, memory[i], d[i]);
    if (all == n) {
        unload(&view, n, memory, d, b);
    } else {
        for (int i = 0; count < all; ++i) {
            b->place[count] = i;
            b->deepest[count] = memory[i];
            b->d[count] = d[i];
            count += mdr_plastic_is_below(&view, memory[i], d[i]);
        }
        unload(&view, all, b->deepest, b->d, b);
    }
    deliver(b, n, all, b->F, F);
    deliver(b, n, all, b->slope, slope);
    deliver(b, n, all, b->a, a);
    return all;
}

FOR_PROCESSORS(int, unload_block,
               (const mdr_plastic_view *of, block *b, int n, const double d[], const double memory[], double F[], double slope[],
                double a[]),
               (of, b, n, d, memory, F, slope, a))

/* Steps of the other ones of n contacts, up to the first that fails; its index, or n. */
static int step_others(const mdr_plastic_view *view, const int below[], int count, int n, const double d[], int is_trial,
                       double memory[], double F[], double slope[], double a[])
{
    const size_t size = mdr_plastic_memory_size(view);
    for (int i = 0, next = 0; i < n; ++i) {
        double after[2], force, rise, radius = 0.0;
        double *const mine = memory + size * (size_t)i;
        if (next < count && below[next] == i) {
            ++next;
            continue;
        }
        if (mdr_plastic_step(view, d[i], mine, after, &force, &rise, a ? &radius : NULL) != MDR_SUCCESS) return i;
        if (!is_trial) mdr_plastic_keep(view, after, mine);
        if (F) F[i] = force;
        if (slope) slope[i] = rise;
        if (a) a[i] = radius;
    }
    return n;
}

static double *from(double array[], int i) { return array ? array + i : NULL; }

/* Steps of n contacts, up to the first that fails; its index, or n. Trials leave the memory. Outputs may be NULL. */
int mdrcontact_plastic_steps(const mdr_plastic_view *view, int n, const double depth[], int is_trial, double memory[], double force[],
                             double slope[], double radius[]);
int mdrcontact_plastic_steps(const mdr_plastic_view *view, int n, const double depth[], int is_trial, double memory[], double force[],
                             double slope[], double radius[])
{
    const size_t size = mdr_plastic_memory_size(view);
    block b;
    for (int first = 0; first < n; first += BLOCK) {
        const int count = n - first < BLOCK ? n - first : BLOCK;
        const double *const d = depth + first;
        double *const mine = memory + size * (size_t)first;
        double *const F = from(force, first), *const rise = from(slope, first), *const a = from(radius, first);
        const int below = size == 1 ? unload_block(view, &b, count, d, mine, F, rise, a) : 0;
        if (below == count) continue;
        const int done = step_others(view, b.place, below, count, d, is_trial, mine, F, rise, a);
        if (done < count) return first + done;
    }
    return n;
}

/* Energies of n contacts at depths, up to the first that fails; its index, or n. */
int mdrcontact_plastic_energies(const mdr_plastic_view *view, int n, const double depth[], const double memory[], double stored[],
                                double dissipated[]);
int mdrcontact_plastic_energies(const mdr_plastic_view *view, int n, const double depth[], const double memory[], double stored[],
                                double dissipated[])
{
    const size_t size = mdr_plastic_memory_size(view);
    for (int i = 0; i < n; ++i) {
        if (mdr_plastic_view_energies(view, depth[i], memory + size * (size_t)i, &stored[i], &dissipated[i]) != MDR_SUCCESS) return i;
    }
    return n;
}

/* The depth at which an unloading without adhesion from a largest depth of the range opens the contact. */
double mdrcontact_plastic_residual(const mdr_plastic_view *view, double deepest);
double mdrcontact_plastic_residual(const mdr_plastic_view *view, double deepest) { return mdr_plastic_residual(view, deepest); }

double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest);
double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest) { return mdr_plastic_loss(view, deepest); }
