/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The sliders of one step, motion.f90: with vectors of GNU C four or two at a time, as the processor can, else one by one. Sums are
 * those of four lanes in any case, so that the bits are the same.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

enum { MOST = 388 };
enum { GROWS = 1, TANGENT = 2, GENERAL = 4 };

/* Numbers of larger size are refused: their squares are none. */
#define LARGEST 1.0e150

/* Places in a record, as of record.f90 but for counting from 0. */
enum { AT_NEXT = 1, AT_USED, AT_SHIFT, AT_TOP, AT_LOST = 7, HEAD = 11 };

/* motion_t of motion.f90 */
typedef struct motion {
    int32_t used, before, cell, first_share, of_radius, at_once, grows, is_settled;
    double top[3], old, way[3], total[3], lost;
    int32_t level[MOST];
    double stiffness[MOST], beyond[MOST], strength[MOST], factor[MOST], borne[3][MOST];
    double slope[MOST], newborn[MOST], newborn_slope[MOST];
} motion;

/* place_t of strengths.f90 */
typedef struct place {
    double force, shift, stiffness, rate, load;
} place;

/* Of levels_t; the force that counts as 0. */
typedef struct given {
    const double *row, *share;
    double strength, nothing;
    int32_t count, sliders;
} given;

/* Steps of many contacts, as of contact_steps_t; S and dS/dF at the end of each. */
typedef struct steps {
    const double *force, *level, *compliance, *shift;
    double *memory, *traction, *tangent;
    int32_t n, is_trial;
} steps;

/* Called from Fortran only: motion.f90. */
void mdrcontact_sliders_step(const double row[], const double share[], int32_t count, int32_t sliders, double strength,
                             const place *at, const double t[], motion *m, double tangent[]);
int32_t mdrcontact_sliders_steps(const double row[], const double share[], int32_t count, int32_t sliders, double strength,
                                 double nothing, int32_t n, int32_t is_trial, const double force[], const double level[],
                                 const double compliance[], const double shift[], double memory[], double traction[],
                                 double tangent[]);
int32_t mdrcontact_sliders_sound(const double row[], int32_t count, int32_t sliders, double mark, double highest, int32_t n,
                                 const double force[], const double shift[], const double memory[]);
int32_t mdrcontact_record_begun(int32_t count, int32_t sliders, double mark, const double record[]);

/* A slider that came to its limit in the step before is within it, whatever rounding says. */
#define WITHIN (1.0 + 16.0 * DBL_EPSILON)
#define SLIPS (1.0 / WITHIN)

/* No slip takes more energy, and none where there is no stiffness. */
#define MOST_LOST 1.0e150

/* g, what springs that touch bear for each unit of A; its derivatives by ds, (one I - turned e e^T), and by F. */
typedef struct growth {
    double g[3], by_force[3], e[3], one, turned;
} growth;

/* Springs that touch at constant shear strength respond immediately to the shear. */
static growth growth_of(const motion *m, const place *at, double mu)
{
    growth of = {{0.0}, {0.0}, {0.0}, 0.0, 0.0};
    const double *way = m->way, grown = at->shift - m->old;
    /* of shifts whose squares are lost the largest component */
    const double length = fmax(sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]),
                               fmax(fabs(way[0]), fmax(fabs(way[1]), fabs(way[2]))));
    const int is_slow = m->at_once || length <= mu * grown;
    of.one = is_slow ? 1.0 / grown : mu / length;
    if (!is_slow) of.turned = of.one;
    for (int j = 0; j < 3; ++j) {
        of.g[j] = way[j] / (is_slow ? grown : fmax(grown, length / mu));
        if (is_slow) of.by_force[j] = -at->rate / grown * of.g[j];
        if (!is_slow) of.e[j] = way[j] / length;
    }
    return of;
}

/* What loads were above their limits before sliders moved: the energy of that. */
static double weakening(const given *of, const motion *m, const double t[])
{
    double lost = 0.0;
    for (int i = 0; i < m->before; ++i) {
        const double x = t[i], y = t[of->sliders + i], z = t[2 * of->sliders + i];
        const double above = sqrt(x * x + y * y + z * z) - m->strength[i];
        if (m->stiffness[i] > 0.0 && above > 0.0) lost += above * above / (2.0 * m->stiffness[i]);
    }
    return lost;
}

/* What is left of no springs at a flat end is rounding, and shares have errors of their own: T <= mu F does not. */
static void settle(motion *m)
{
    m->is_settled = 1;
    for (int i = m->used - 1; i > 0; --i) {
        const double above = i + 1 < m->used ? m->beyond[i + 1] : 0.0;
        m->beyond[i] = fmin(fmax(m->beyond[i], above), m->beyond[0]);
    }
}

/* Shares are those between the level below S and the next. */
static inline void find_shares(const given *of, double S, motion *m)
{
    if (!of->share) return;
    while (m->cell > 0 && !(of->row[4 * m->cell] < S)) --m->cell;
    m->first_share = m->cell * (m->cell + 3) / 2;
}

/* Whether the sliders of a record remain the same in a step: it has begun, passes no level and leaves none; then it is `m`. */
static inline int keeps_sliders(const given *of, const place *at, const double record[], int is_trial, motion *m)
{
    const int next = (int)record[AT_NEXT], used = (int)record[AT_USED];
    if (next < 1 || of->row[4 * next] < at->shift || !(at->force > of->nothing)) return 0;
    memcpy(m->top, record + AT_TOP, sizeof m->top);
    m->grows = at->shift > m->top[0];
    if (!m->grows && !is_trial) {
        if (used < of->sliders - 1) return 0;
        if (used > 1 && !(at->shift > of->row[4 * (int)record[HEAD + used - 1]])) return 0;
    }
    m->used = m->before = used;
    m->old = record[AT_SHIFT];
    m->is_settled = 0;
    m->cell = next;
    for (int i = 0; i < used; ++i) m->level[i] = (int32_t)record[HEAD + i];
    /* sliders behind the last have the row that no S reaches */
    for (int i = used; i & 3; ++i) m->level[i] = of->count + 1;
    find_shares(of, at->shift, m);
    return 1;
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define HAS_VECTORS
#endif
#endif

#define INSIDE static inline __attribute__((always_inline))
#define UNROLLED _Pragma("GCC unroll 6")
#ifdef HAS_VECTORS
#define LANES 2
#define NAME(part) part##_of_2
#include "step_lanes.h"
#undef LANES
#undef NAME
#if defined(__x86_64__) && !defined(__clang__)
#define HAS_FOUR
#pragma GCC push_options
#pragma GCC target("avx2")
#define LANES 4
#define NAME(part) part##_of_4
#include "step_lanes.h"
#undef LANES
#undef NAME

/* GCC forgets to empty the upper halves within a target pragma; else all that follows is slow. */
static void one_by_four(const given *of, const place *at, motion *m, const double t[], double tangent[])
{
    one_of_4(of, at, m, t, tangent);
    __builtin_ia32_vzeroupper();
}

static int many_by_four(const given *of, const steps *these)
{
    const int done = many_of_4(of, these);
    __builtin_ia32_vzeroupper();
    return done;
}

static int sound_by_four(const given *of, double mark, double highest, int n, const double force[], const double shift[],
                         const double memory[])
{
    const int sound = sound_of_4(of, mark, highest, n, force, shift, memory);
    __builtin_ia32_vzeroupper();
    return sound;
}

static int begun_by_four(const given *of, double mark, const double record[])
{
    const int begun = begun_of_4(of, mark, record);
    __builtin_ia32_vzeroupper();
    return begun;
}
#pragma GCC pop_options
#endif
#define NARROW(part) part##_of_2
#else
#undef INSIDE
#undef UNROLLED
#define INSIDE static inline
#define UNROLLED
#define LANES 1
#define NAME(part) part##_of_1
#include "step_lanes.h"
#undef LANES
#undef NAME
#define NARROW(part) part##_of_1
#endif

#ifdef HAS_FOUR
#define WIDEST(wide, narrow) (__builtin_cpu_supports("avx2") ? (wide) : (narrow))
#else
#define WIDEST(wide, narrow) (narrow)
#endif

void mdrcontact_sliders_step(const double row[], const double share[], int32_t count, int32_t sliders, double strength,
                             const place *at, const double t[], motion *m, double tangent[])
{
    const given of = {row, share, strength, 0.0, count, sliders};
    find_shares(&of, at->shift, m);
    WIDEST(one_by_four(&of, at, m, t, tangent), NARROW(one)(&of, at, m, t, tangent));
}

int32_t mdrcontact_sliders_steps(const double row[], const double share[], int32_t count, int32_t sliders, double strength,
                                 double nothing, int32_t n, int32_t is_trial, const double force[], const double level[],
                                 const double compliance[], const double shift[], double memory[], double traction[],
                                 double tangent[])
{
    const given of = {row, share, strength, nothing, count, sliders};
    const steps these = {force, level, compliance, shift, memory, traction, tangent, n, is_trial};
    return WIDEST(many_by_four(&of, &these), NARROW(many)(&of, &these));
}

int32_t mdrcontact_sliders_sound(const double row[], int32_t count, int32_t sliders, double mark, double highest, int32_t n,
                                 const double force[], const double shift[], const double memory[])
{
    const given of = {row, NULL, 0.0, 0.0, count, sliders};
    return WIDEST(sound_by_four(&of, mark, highest, n, force, shift, memory),
                  NARROW(sound)(&of, mark, highest, n, force, shift, memory));
}

int32_t mdrcontact_record_begun(int32_t count, int32_t sliders, double mark, const double record[])
{
    const given of = {NULL, NULL, 0.0, 0.0, count, sliders};
    return WIDEST(begun_by_four(&of, mark, record), NARROW(begun)(&of, mark, record));
}
