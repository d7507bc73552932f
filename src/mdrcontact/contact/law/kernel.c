/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Many points of a law's view: as the inline functions of mdrcontact_law.h, to the last bit, for two or four points at a time. Which
 * of them the processor can do is found at run time; without vectors of GNU C it is one point at a time.
 */
#include "mdrcontact_law.h"

/* Called from Fortran only. Points outside the view are moved to its ends; outputs that are NULL are skipped. */
void mdrcontact_law_points(const mdr_law_view *view, int n, const double s[], double other[], double slope[], double radius[],
                           double stiffness[]);

/* Of table.f90. */
double mdrcontact_law_power(double base, double exponent);
double mdrcontact_law_power(double base, double exponent) { return mdr_law_power(base, exponent); }

void mdrcontact_law_touch(double lowest, double first, double power, int roots, double d, double *F, double *slope);
void mdrcontact_law_touch(double lowest, double first, double power, int roots, double d, double *F, double *slope)
{
    mdr_law_first_touch(lowest, first, power, roots, d, F, slope);
}

double mdrcontact_law_touch_energy(double lowest, double power, int roots, double d, double F);
double mdrcontact_law_touch_energy(double lowest, double power, int roots, double d, double F)
{
    return mdr_law_first_energy(lowest, power, roots, d, F);
}

static double within(const mdr_law_view *view, double s)
{
    return s > view->highest ? view->highest : s > view->lowest ? s : view->lowest;
}

static void one_by_one(const mdr_law_view *view, int first, int n, const double s[], double other[], double slope[], double radius[],
                       double stiffness[])
{
    for (int i = first; i < n; ++i) {
        double t, rate;
        const uint64_t panel = mdr_law_panel(view, view->scale * within(view, s[i]) + view->offset, &t);
        const double value = mdr_law_polynomial_with_slope(view->force + 8 * panel, t, &rate);
        if (other) other[i] = value;
        if (slope) slope[i] = view->scale * rate;
        if (radius) radius[i] = mdr_law_polynomial(view->contact + 16 * panel, t);
        if (stiffness) stiffness[i] = mdr_law_polynomial(view->contact + 16 * panel + 8, t);
    }
}

#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define HAS_VECTORS
#endif
#endif

#ifdef HAS_VECTORS
#define INSIDE static inline __attribute__((always_inline))

#define LANES 2
#define NAME(part) part##_of_2
#include "lanes.h"
#undef LANES
#undef NAME

static void by_two(const mdr_law_view *view, int n, const double s[], double other[], double slope[], double radius[],
                   double stiffness[])
{
    one_by_one(view, points_of_2(view, n, s, other, slope, radius, stiffness), n, s, other, slope, radius, stiffness);
}

#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
#define LANES 4
#define NAME(part) part##_of_4
#include "lanes.h"
#undef LANES
#undef NAME

static void by_four(const mdr_law_view *view, int n, const double s[], double other[], double slope[], double radius[],
                    double stiffness[])
{
    const int done = points_of_4(view, n, s, other, slope, radius, stiffness);
    __builtin_ia32_vzeroupper(); /* GCC forgets it within a target pragma; without it all that follows is slow */
    one_by_one(view, done, n, s, other, slope, radius, stiffness);
}
#pragma GCC pop_options
#endif
#endif

void mdrcontact_law_points(const mdr_law_view *view, int n, const double s[], double other[], double slope[], double radius[],
                           double stiffness[])
{
#if defined(HAS_VECTORS)
#if defined(__x86_64__) && !defined(__clang__)
    if (__builtin_cpu_supports("avx2")) {
        by_four(view, n, s, other, slope, radius, stiffness);
        return;
    }
#endif
    by_two(view, n, s, other, slope, radius, stiffness);
#else
    one_by_one(view, 0, n, s, other, slope, radius, stiffness);
#endif
}
