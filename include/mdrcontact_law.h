/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact_law.h
 * Compiled laws in inner loops: force and slope as inline functions of C and C++, for the price of their polynomial.
 *
 * A view is a plain structure that points into a law: made once by mdr_law_view_of(), valid as long as the law, to be copied freely
 * and used by any number of threads. The functions below compute by themselves where the bodies are apart, and where a contact without adhesion is closed and
 * its indenter smooth: at depths between view.lowest and view.highest. Everywhere else (near first touch, adhesion, behind a break
 * of the indenter, beyond the largest depth, NaN) they call the library. Either way the results are those of
 * mdr_law_at_depth(), to the last bit unless the compiler makes one operation of a*b + c (-ffp-contract=off prevents it).
 */
#ifndef MDRCONTACT_LAW_H
#define MDRCONTACT_LAW_H

#include "mdrcontact.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the inline functions read. */
typedef struct mdr_law_view {
    double lowest, highest; /**< Depths between which they compute [length]; lowest > highest: nowhere. */
    double scale, offset;   /**< y = scale d + offset, 1 <= y: its exponent and leading bits number the panel. */
    uint64_t mask, half;    /**< These bits of y, and the bit of the panel's middle. */
    const double *force;    /**< [8] for each panel: F in powers of y less the middle. */
    const double *contact;  /**< [16] for each panel: a and k likewise. */
    const double *energy;   /**< For each panel: U in its middle. */
    const mdr_law *law;     /**< Called everywhere else. */
    int branch;             /**< The same; one of enum mdr_branch. */
    int shift;              /**< Of the bits, to give the panel. */
    double open;            /**< Up to this depth the bodies are apart [length]. */
    double first;           /**< From there to this depth F = at_first (d/first)^power, in the library; -infinity: nowhere. */
    double at_first, power; /**< See first. */
} mdr_law_view;

/** The view of a law.
 *  @param law     law, which must outlive the view
 *  @param branch  one of enum mdr_branch
 *  @param view    receives the view */
int mdr_law_view_of(const mdr_law *law, int branch, mdr_law_view *view);

/* Whether the bodies are apart at a depth; false of what is no depth. */
static inline int mdr_law_is_open(const mdr_law_view *view, double d)
{
    return d <= view->open && d >= -DBL_MAX;
}

/* The number of the panel of y, and y less its middle. */
static inline uint64_t mdr_law_panel(const mdr_law_view *view, double y, double *t)
{
    uint64_t bits;
    double middle;
    memcpy(&bits, &y, sizeof bits);
    const uint64_t panel = (bits - UINT64_C(0x3ff0000000000000)) >> view->shift;
    bits = (bits & view->mask) | view->half;
    memcpy(&middle, &bits, sizeof middle);
    *t = y - middle;
    return panel;
}

/* c[0] + c[1] t + ... + c[7] t^7 */
static inline double mdr_law_polynomial(const double c[], double t)
{
    const double q = t * t;
    return (c[0] + q * (c[2] + q * (c[4] + q * c[6]))) + t * (c[1] + q * (c[3] + q * (c[5] + q * c[7])));
}

/* The same, and its derivative in one pass. */
static inline double mdr_law_polynomial_with_slope(const double c[], double t, double *slope)
{
    const double q = t * t;
    double even = c[4] + q * c[6], odd = c[5] + q * c[7];
    double even_slope = even + q * c[6], odd_slope = odd + q * c[7];
    even = c[2] + q * even;
    odd = c[3] + q * odd;
    even_slope = even + q * even_slope;
    odd_slope = odd + q * odd_slope;
    even = c[0] + q * even;
    odd = c[1] + q * odd;
    *slope = odd + (t + t) * (even_slope + t * odd_slope);
    return even + t * odd;
}

/** F at one depth, as mdr_law_force().
 *  @param view  view of a law
 *  @param d     indentation depth [length]
 *  @param F     receives the normal force [modulus length^2] */
static inline int mdr_law_view_force(const mdr_law_view *view, double d, double *F)
{
    if (d >= view->lowest && d <= view->highest) {
        double t;
        const uint64_t panel = mdr_law_panel(view, view->scale * d + view->offset, &t);
        *F = mdr_law_polynomial(view->force + 8 * panel, t);
        return MDR_SUCCESS;
    }
    if (mdr_law_is_open(view, d)) {
        *F = 0.0;
        return MDR_SUCCESS;
    }
    return mdr_law_force(view->law, view->branch, d, F, NULL);
}

/** F and dF/dd at one depth, as mdr_law_force().
 *  @param view   view of a law
 *  @param d      indentation depth [length]
 *  @param F      receives the normal force [modulus length^2]
 *  @param slope  receives dF/dd along the branch [modulus length] */
static inline int mdr_law_view_force_slope(const mdr_law_view *view, double d, double *F, double *slope)
{
    if (d >= view->lowest && d <= view->highest) {
        double t, rate;
        const uint64_t panel = mdr_law_panel(view, view->scale * d + view->offset, &t);
        *F = mdr_law_polynomial_with_slope(view->force + 8 * panel, t, &rate);
        *slope = view->scale * rate;
        return MDR_SUCCESS;
    }
    if (mdr_law_is_open(view, d)) {
        *F = 0.0;
        *slope = 0.0;
        return MDR_SUCCESS;
    }
    return mdr_law_force(view->law, view->branch, d, F, slope);
}

/** All of the state at one depth, as mdr_law_at_depth().
 *  @param view   view of a law
 *  @param d      indentation depth [length]
 *  @param point  receives the state */
static inline int mdr_law_view_state(const mdr_law_view *view, double d, mdr_law_point *point)
{
    if (d >= view->lowest && d <= view->highest) {
        double t, rate, work = 0.0;
        const uint64_t panel = mdr_law_panel(view, view->scale * d + view->offset, &t);
        const double *const c = view->force + 8 * panel, *const a_and_k = view->contact + 16 * panel;
        point->depth = d;
        point->force = mdr_law_polynomial_with_slope(c, t, &rate);
        point->slope = view->scale * rate;
        point->radius = mdr_law_polynomial(a_and_k, t);
        point->stiffness = mdr_law_polynomial(a_and_k + 8, t);
        for (int i = 7; i >= 0; --i) work = work * t + c[i] * (1.0 / (i + 1)); /* of F from the middle to t */
        point->energy = view->energy[panel] + work * t / view->scale;
        point->beyond = 0.0;
        return MDR_SUCCESS;
    }
    if (mdr_law_is_open(view, d)) {
        point->force = point->slope = point->radius = point->stiffness = point->energy = point->beyond = 0.0;
        point->depth = d;
        return MDR_SUCCESS;
    }
    return mdr_law_at_depth(view->law, view->branch, d, point);
}

#ifdef __cplusplus
}
#endif

#endif
