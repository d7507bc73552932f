/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact_law.h
 * Compiled laws in inner loops and on devices: inline functions of C99, C++, CUDA, HIP, SYCL and OpenMP that evaluate a law. None
 * calls the library.
 *
 * A view reads the buffer of a law, an array of doubles (mdr_law_buffer()) in the memory of a device, in shared memory or in a
 * mapped file. mdr_law_view_of() returns the view of the buffer that the law owns, mdr_law_view_from() that of a copy,
 * mdr_law_view_at() that of a copy in another memory. A view is a plain structure. It is valid as long as its buffer, may be
 * copied, and any number of threads may use it.
 *
 * The results are those of mdr_law_values(). They are bitwise identical if the compiler does not contract a*b + c
 * (-ffp-contract=off; nvcc: --fmad=false). The functions return MDR_SUCCESS; MDR_EDOMAIN beyond the largest depth, unless the law
 * continues beyond it; or MDR_EINVALID for a depth that is NaN or infinite. After a failure their outputs are NaN. They do not set
 * mdr_last_error(); mdr_law_force() at the same depth does.
 * @since 0.1
 */
#ifndef MDRCONTACT_LAW_INLINE_H
#define MDRCONTACT_LAW_INLINE_H

#include "mdrcontact.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/** The declaration of the functions below. Define it before this header if a compiler needs another one. */
#ifndef MDR_INLINE
#if defined(__CUDACC__) || defined(__HIPCC__) || defined(__CUDA__)
#define MDR_INLINE __host__ __device__ static inline
#else
#define MDR_INLINE static inline
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** A view of a law, read by the inline functions. Its members are private. */
typedef struct mdr_law_view {
    double lowest, highest; /**< Depths between which one interval without a root answers [length]; lowest > highest: nowhere. */
    double scale, offset;   /**< There y = scale d + offset, 1 <= y: its exponent and leading bits number the panel. */
    uint64_t mask, half;    /**< These bits of y, and the bit of the panel's middle. */
    const double *force;    /**< [8] for each panel: F in powers of y less the middle. */
    const double *contact;  /**< [16] for each panel: a and k likewise. */
    const double *energy;   /**< For each panel: U in its middle. */
    const double *buffer;   /**< The whole law: an mdr_law_head, followed by its arrays. */
    int branch;             /**< One of enum mdr_branch. */
    int shift;              /**< Of the bits, to give the panel. */
    double open;            /**< Up to this depth the bodies are separated [length]. */
} mdr_law_view;

/** Return the view of the buffer that a law owns.
 *  @param law     law, which must outlive the view
 *  @param branch  one of enum mdr_branch
 *  @param view    receives the view
 *  @code
 *  mdr_law_view mine;
 *  status = mdr_law_view_of(law, MDR_ON_UNLOADING, &mine);
 *  @endcode
 */
int mdr_law_view_of(const mdr_law *law, int branch, mdr_law_view *view);

/** Check whether a block is sound: the inline functions read no address outside it, at any depth. Views trust their block; check
 *  those of files, messages and shared memory that another program may have written. The check does not tell whether the law is
 *  that of a contact. It reads each number once, and is a function of the library. It does not set mdr_last_error().
 *  @param buffer  the block, aligned to 8 bytes
 *  @param bytes   its size
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a block that is not sound
 *  @code
 *  status = mdr_law_check(view.buffer, (size_t)((const mdr_law_head *)view.buffer)->size * sizeof(double));
 *  @endcode
 */
int mdr_law_check(const double buffer[], size_t bytes);

/* How the buffer begins, and its parts. */
MDR_INLINE const mdr_law_head *mdr_law_head_of(const mdr_law_view *view)
{
    return (const mdr_law_head *)view->buffer;
}

MDR_INLINE const mdr_law_segment *mdr_law_segments_of(const mdr_law_view *view)
{
    return (const mdr_law_segment *)(view->buffer + (size_t)mdr_law_head_of(view)->segments);
}

MDR_INLINE const mdr_law_interval *mdr_law_intervals_of(const mdr_law_view *view)
{
    return (const mdr_law_interval *)(view->buffer + (size_t)mdr_law_head_of(view)->intervals);
}

/** Return the view of a buffer that is used at another address, for example on a device.
 *  @param buffer  written by mdr_law_buffer(); read here
 *  @param there   address of the same numbers where the view is used
 *  @param branch  one of enum mdr_branch
 *  @param view    receives the view
 *  @code
 *  mdr_law_view device;
 *  status = mdr_law_view_at(view.buffer, view.buffer, MDR_ON_UNLOADING, &device);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_at(const double *buffer, const double *there, int branch, mdr_law_view *view)
{
    const mdr_law_head *const head = (const mdr_law_head *)buffer;
    if (!buffer || !there || !view) return MDR_ENULL;
    if (head->format != (double)MDR_LAW_FORMAT || (branch != MDR_ON_LOADING && branch != MDR_ON_UNLOADING)) return MDR_EINVALID;
    view->buffer = there;
    view->force = there + (size_t)head->force;
    view->contact = there + (size_t)head->contact;
    view->energy = there + (size_t)head->energy;
    view->branch = branch;
    view->open = branch == MDR_ON_LOADING ? head->open_loading : head->open_unloading;
    view->lowest = 1.0;
    view->highest = -1.0;
    view->scale = view->offset = 0.0;
    view->mask = view->half = 0;
    view->shift = 0;
    if (head->direct >= 0.0) {
        const mdr_law_interval *const interval =
            (const mdr_law_interval *)(buffer + (size_t)head->intervals) + (size_t)head->direct;
        view->lowest = interval->lowest;
        view->highest = interval->highest;
        view->scale = interval->scale;
        view->offset = interval->offset;
        view->shift = 52 - (int)interval->bits;
        view->half = (uint64_t)1 << (view->shift - 1);
        view->mask = ~(2 * view->half - 1);
    }
    return MDR_SUCCESS;
}

/** Return the view of a buffer that is used at its own address.
 *  @param buffer  written by mdr_law_buffer()
 *  @param branch  one of enum mdr_branch
 *  @param view    receives the view
 *  @code
 *  mdr_law_view copy;
 *  status = mdr_law_view_from(view.buffer, MDR_ON_UNLOADING, &copy);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_from(const double *buffer, int branch, mdr_law_view *view)
{
    return mdr_law_view_at(buffer, buffer, branch, view);
}

/* Whether the bodies are separated at a depth; false if d is not a depth. */
MDR_INLINE int mdr_law_is_open(const mdr_law_view *view, double d)
{
    return d <= view->open && d >= -DBL_MAX;
}

/* The number of the panel of y, and y less its middle. */
MDR_INLINE uint64_t mdr_law_panel(const mdr_law_view *view, double y, double *t)
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
MDR_INLINE double mdr_law_polynomial(const double c[], double t)
{
    const double q = t * t;
    return (c[0] + q * (c[2] + q * (c[4] + q * c[6]))) + t * (c[1] + q * (c[3] + q * (c[5] + q * c[7])));
}

/* The same, and its derivative in one pass. */
MDR_INLINE double mdr_law_polynomial_with_slope(const double c[], double t, double *slope)
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

/* x^p for 0 < x <= 1 and p >= 0, by operations that give bitwise identical results on all processors; within 1e-15 (1 + |ln x^p|).
 * ln m = 2 artanh z between 1/sqrt 2 and sqrt 2, and 2^f, each by its interpolation at Chebyshev's points. */
MDR_INLINE double mdr_law_power(double x, double p)
{
    const double normal = x < DBL_MIN ? x * 18014398509481984.0 : x; /* 2^54 */
    uint64_t bits;
    double m, one;
    memcpy(&bits, &normal, sizeof bits);
    const int64_t above = (int64_t)(bits - UINT64_C(0x3fe6a09e667f3bcd)); /* the bits of 1/sqrt 2 */
    const double e = (double)((above >> 52) - (x < DBL_MIN ? 54 : 0));
    bits -= (uint64_t)above & UINT64_C(0xfff0000000000000);
    memcpy(&m, &bits, sizeof m);
    const double z = (m - 1.0) / (m + 1.0), q = z * z, q2 = q * q;
    const double even = 2.8853900817779268 + q2 * (0.5770780163541355 + q2 * (0.32059873801756367 + q2 * 0.221189987214124));
    const double odd = 0.961796693925976 + q2 * (0.412198583898078 + q2 * (0.2623236397004895 + q2 * 0.21087079476015172));
    const double t = p * (e + z * (even + q * odd)); /* log2 of x^p */
    if (!(t > -1100.0)) return 0.0;
    const int64_t n = (int64_t)(t - 0.5);
    const double f = t - (double)n, g = f * f;
    const double whole = 1.0 + g * (0.24022650695910075 + g * (0.009618129107618665 + g * (0.00015403530424776529
                         + g * (1.3215451633221434e-06 + g * 7.070977866508138e-09))));
    const double part = 0.6931471805599462 + g * (0.05550410866465167 + g * (0.0013333558200794592
                        + g * (1.5252672924850737e-05 + g * 1.0205905413765595e-07)));
    bits = (uint64_t)(n < -1022 ? n + 54 + 1023 : n + 1023) << 52;
    memcpy(&one, &bits, sizeof one);
    return (whole + f * part) * one * (n < -1022 ? 5.5511151231257827e-17 : 1.0); /* 2^-54 */
}

/* The segment, from 1, on which the state of the view's branch lies; 0 if it does not exist. */
MDR_INLINE int mdr_law_segment_at(const mdr_law_view *view, int branch, double d)
{
    const mdr_law_segment *const segments = mdr_law_segments_of(view);
    const int count = (int)mdr_law_head_of(view)->segment_count;
    int found = 0;
    if (branch == MDR_ON_LOADING && d <= mdr_law_head_of(view)->open_loading) return 0;
    for (int i = 0; i < count; ++i) {
        if (d < segments[i].lowest || d > segments[i].highest) continue;
        found = i + 1;
        if (branch == MDR_ON_LOADING) break;
    }
    return found;
}

/* The interval of a segment that holds d. */
MDR_INLINE const mdr_law_interval *mdr_law_interval_at(const mdr_law_view *view, int segment, double d)
{
    const mdr_law_interval *const intervals = mdr_law_intervals_of(view);
    int low = (int)mdr_law_segments_of(view)[segment - 1].first, high = (int)mdr_law_segments_of(view)[segment - 1].last;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (d > intervals[middle].highest) low = middle + 1;
        else high = middle;
    }
    return intervals + low;
}

/* The state at a depth within an interval. */
MDR_INLINE void mdr_law_state_in(const mdr_law_view *view, const mdr_law_interval *interval, double d, mdr_law_point *point)
{
    double from_origin = interval->side * (d - interval->origin), y, middle, t, rate, slope;
    double first = 0.0, second = 0.0; /* the integrals of the polynomial, and of it times t, over t */
    uint64_t bits;
    if (interval->is_root != 0.0) {
        from_origin = sqrt(from_origin > 0.0 ? from_origin : 0.0);
        y = interval->scale * from_origin + interval->offset;
    } else {
        y = interval->scale * d + interval->offset;
    }
    y = y > 1.0 ? y : 1.0;
    y = y < interval->last_y ? y : interval->last_y;
    const int shift = 52 - (int)interval->bits;
    const uint64_t half = (uint64_t)1 << (shift - 1);
    memcpy(&bits, &y, sizeof bits);
    const uint64_t panel = ((bits - UINT64_C(0x3ff0000000000000)) >> shift) + (uint64_t)interval->first_panel;
    bits = (bits & ~(2 * half - 1)) | half;
    memcpy(&middle, &bits, sizeof middle);
    t = y - middle;

    const double *const c = view->force + 8 * panel, *const a_and_k = view->contact + 16 * panel;
    point->depth = d;
    point->force = mdr_law_polynomial_with_slope(c, t, &slope);
    rate = interval->scale;
    if (interval->is_root != 0.0) {
        rate = interval->side * (0.5 * rate / (from_origin > interval->smallest_root ? from_origin : interval->smallest_root));
    }
    point->slope = rate * slope;
    point->radius = mdr_law_polynomial(a_and_k, t);
    point->stiffness = mdr_law_polynomial(a_and_k + 8, t);
    for (int i = 7; i >= 0; --i) {
        first = first * t + c[i] * (1.0 / (i + 1));
        second = second * t + c[i] * (1.0 / (i + 2));
    }
    first = first * t;
    if (interval->is_root != 0.0) {
        second = second * (t * t);
        point->energy = view->energy[panel] + 2.0 * interval->side * ((middle - interval->offset) * first + second)
                        / (interval->scale * interval->scale);
    } else {
        point->energy = view->energy[panel] + first / interval->scale;
    }
    point->beyond = 0.0;
}

/* F and dF/dd at a depth between initial contact and the lowest of the compiled range, without adhesion, from first_force,
 * force_power and force_roots of the head. */
MDR_INLINE void mdr_law_first_touch(double lowest, double first, double power, int roots, double d, double *F, double *slope)
{
    const double share = d / lowest;
    if (roots == 0) {
        *F = first * mdr_law_power(share, power);
        *slope = power * *F / d;
        return;
    }
    const double root = sqrt(share), bend = 2.0 * power - roots, straight = 1.0 - bend, tilt = bend * root;
    double rise = roots & 1 ? first * root : first;
    for (int m = roots & ~1; m > 2; m -= 2) rise *= share;
    *F = rise * share * (straight + tilt);
    *slope = rise / lowest * (0.5 * roots * straight + (0.5 * roots + 0.5) * tilt);
}

/* The integral of F from initial contact to such a depth, where F is known. */
MDR_INLINE double mdr_law_first_energy(double lowest, double power, int roots, double d, double F)
{
    const double bend = 2.0 * power - roots, straight = 1.0 - bend, tilt = bend * sqrt(d / lowest);
    if (roots == 0) return F * d / (1.0 + power);
    return F * d * (straight / (1.0 + 0.5 * roots) + tilt / (1.5 + 0.5 * roots)) / (straight + tilt);
}

/* The same between initial contact and the compiled range, without adhesion. */
MDR_INLINE void mdr_law_state_below(const mdr_law_view *view, double d, mdr_law_point *point)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    const int roots = (int)head->force_roots;
    point->depth = d;
    mdr_law_first_touch(head->lowest, head->first_force, head->force_power, roots, d, &point->force, &point->slope);
    point->radius = head->end_radius + head->first_radius * mdr_law_power(d / head->lowest, head->radius_power);
    point->stiffness = point->slope;
    point->energy = mdr_law_first_energy(head->lowest, head->force_power, roots, d, point->force);
    point->beyond = 0.0;
}

/* The same for separated bodies. */
MDR_INLINE void mdr_law_state_open(double d, mdr_law_point *point)
{
    point->force = point->slope = point->radius = point->stiffness = point->energy = point->beyond = 0.0;
    point->depth = d;
}

/* From the largest depth on along the tangent. */
MDR_INLINE void mdr_law_go_beyond(double by, double d, mdr_law_point *point)
{
    point->energy = point->energy + (point->force + 0.5 * point->slope * by) * by;
    point->force = point->force + point->slope * by;
    point->depth = d;
    point->beyond = by > 0.0 ? by : 0.0;
}

/* Whether a law has an answer at a depth. */
MDR_INLINE int mdr_law_check_depth(const mdr_law_view *view, double d)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    if (!(d >= -DBL_MAX && d <= DBL_MAX)) return MDR_EINVALID;
    return d > head->highest && head->continues == 0.0 ? MDR_EDOMAIN : MDR_SUCCESS;
}

/* The state at a depth on a segment, 0 for open. */
MDR_INLINE void mdr_law_state_on(const mdr_law_view *view, int segment, double d, mdr_law_point *point)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    const double within = d < head->highest ? d : head->highest;
    if (segment > 0 && within >= head->lowest) {
        mdr_law_state_in(view, mdr_law_interval_at(view, segment, within), within, point);
        if (d > within) mdr_law_go_beyond(d - within, d, point);
    } else if (head->adhesive == 0.0 && within > 0.0) {
        mdr_law_state_below(view, d, point);
    } else {
        mdr_law_state_open(d, point);
    }
}

/* The state if it does not exist. */
MDR_INLINE int mdr_law_refuse(int status, mdr_law_point *point)
{
    point->force = point->slope = point->radius = point->stiffness = point->energy = point->beyond = point->depth = (double)NAN;
    return status;
}

/* The state at any depth. */
MDR_INLINE int mdr_law_state_anywhere(const mdr_law_view *view, double d, mdr_law_point *point)
{
    const double highest = mdr_law_head_of(view)->highest;
    const int status = mdr_law_check_depth(view, d);
    if (status != MDR_SUCCESS) return mdr_law_refuse(status, point);
    mdr_law_state_on(view, mdr_law_segment_at(view, view->branch, d < highest ? d : highest), d, point);
    return MDR_SUCCESS;
}

/* F and its slope where the direct interval does not answer. */
MDR_INLINE int mdr_law_force_elsewhere(const mdr_law_view *view, double d, double *F, double *slope)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    mdr_law_point point;
    if (mdr_law_is_open(view, d)) {
        *F = 0.0;
        *slope = 0.0;
        return MDR_SUCCESS;
    }
    if (head->adhesive == 0.0 && d < head->lowest && d > 0.0) {
        mdr_law_first_touch(head->lowest, head->first_force, head->force_power, (int)head->force_roots, d, F, slope);
        return MDR_SUCCESS;
    }
    const int status = mdr_law_state_anywhere(view, d, &point);
    *F = point.force;
    *slope = point.slope;
    return status;
}

/** Compute F at one depth, as mdr_law_force().
 *  @param view  view of a law
 *  @param d     indentation depth [length]
 *  @param F     receives the normal force [modulus length^2]
 *  @code
 *  double F;
 *  status = mdr_law_view_force(&view, 40e-9, &F);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_force(const mdr_law_view *view, double d, double *F)
{
    double t, slope;
    if (!(d >= view->lowest && d <= view->highest)) return mdr_law_force_elsewhere(view, d, F, &slope);
    const uint64_t panel = mdr_law_panel(view, view->scale * d + view->offset, &t);
    *F = mdr_law_polynomial(view->force + 8 * panel, t);
    return MDR_SUCCESS;
}

/** Compute F and dF/dd at one depth, as mdr_law_force().
 *  @param view   view of a law
 *  @param d      indentation depth [length]
 *  @param F      receives the normal force [modulus length^2]
 *  @param slope  receives dF/dd along the branch [modulus length]
 *  @code
 *  double F, slope;
 *  status = mdr_law_view_force_slope(&view, 40e-9, &F, &slope);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_force_slope(const mdr_law_view *view, double d, double *F, double *slope)
{
    double t, rate;
    if (!(d >= view->lowest && d <= view->highest)) return mdr_law_force_elsewhere(view, d, F, slope);
    const uint64_t panel = mdr_law_panel(view, view->scale * d + view->offset, &t);
    *F = mdr_law_polynomial_with_slope(view->force + 8 * panel, t, &rate);
    *slope = view->scale * rate;
    return MDR_SUCCESS;
}

/** Compute the state at one depth, as mdr_law_values().
 *  @param view   view of a law
 *  @param d      indentation depth [length]
 *  @param point  receives the state
 *  @code
 *  mdr_law_point point;
 *  status = mdr_law_view_state(&view, 40e-9, &point);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_state(const mdr_law_view *view, double d, mdr_law_point *point)
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
        mdr_law_state_open(d, point);
        return MDR_SUCCESS;
    }
    return mdr_law_state_anywhere(view, d, point);
}

/* The next segment beyond the end of one, upwards or downwards; 0 if it does not exist. */
MDR_INLINE int mdr_law_next_segment(const mdr_law_view *view, int segment, double d)
{
    const mdr_law_segment *const segments = mdr_law_segments_of(view);
    const int count = (int)mdr_law_head_of(view)->segment_count;
    if (d > segments[segment - 1].highest) {
        if (segment == count) return segment;
        for (++segment; segment < count; ++segment) {
            if (d >= segments[segment - 1].lowest && d <= segments[segment - 1].highest) break;
        }
    } else if (d < segments[segment - 1].lowest) {
        for (--segment; segment > 0; --segment) {
            if (d >= segments[segment - 1].lowest && d <= segments[segment - 1].highest) break;
        }
    }
    return segment;
}

/** Compute the state at one depth of a contact with a history, as mdr_law_follow(). The branch of the view is ignored.
 *  @param view     view of a law
 *  @param d        indentation depth [length]
 *  @param segment  segment of the contact: 0 (open) before the first call, then the value of the last call
 *  @param point    receives the state
 *  @code
 *  int segment = 0;
 *  mdr_law_point point;
 *  status = mdr_law_view_follow(&view, 40e-9, &segment, &point);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_follow(const mdr_law_view *view, double d, int *segment, mdr_law_point *point)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    const int status = mdr_law_check_depth(view, d);
    const double within = d < head->highest ? d : head->highest;
    if (*segment < 0 || *segment > (int)head->segment_count) return mdr_law_refuse(MDR_EINVALID, point);
    if (status != MDR_SUCCESS) return mdr_law_refuse(status, point);
    if (head->adhesive == 0.0) *segment = within > 0.0;
    else if (*segment == 0) *segment = mdr_law_segment_at(view, MDR_ON_LOADING, within);
    else *segment = mdr_law_next_segment(view, *segment, within);
    mdr_law_state_on(view, *segment, d, point);
    return MDR_SUCCESS;
}

/* The coefficients of G, NULL in a law that does not conduct. */
MDR_INLINE const double *mdr_law_conductance_of(const mdr_law_view *view)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    const size_t place = ((size_t)head->energy + (size_t)head->panel_count + 7) / 8 * 8;
    return (size_t)head->size >= place + 8 * (size_t)head->panel_count ? view->buffer + place : NULL;
}

/** Compute the conductance G and dG/dd at one depth, as mdr_law_conductance().
 *  @param view         view of a law that was made with a conduction; other laws return MDR_EINVALID
 *  @param d            indentation depth [length]
 *  @param conductance  receives G [conductance]
 *  @param slope        receives dG/dd along the branch [conductance/length]
 *  @code
 *  mdr_law_view conducting;
 *  double G, slope;
 *  mdr_law_view_of(conducting_law, MDR_ON_UNLOADING, &conducting);
 *  status = mdr_law_view_conductance(&conducting, 40e-9, &G, &slope);
 *  @endcode
 */
MDR_INLINE int mdr_law_view_conductance(const mdr_law_view *view, double d, double *conductance, double *slope)
{
    const mdr_law_head *const head = mdr_law_head_of(view);
    const double *const rows = mdr_law_conductance_of(view);
    const double highest = head->highest, within = d < highest ? d : highest, at = within > head->lowest ? within : head->lowest;
    int segment, status = mdr_law_check_depth(view, d);
    mdr_law_view of_conductance = *view;
    *conductance = *slope = (double)NAN;
    if (status != MDR_SUCCESS) return status;
    if (!rows) return MDR_EINVALID;
    *conductance = *slope = 0.0;
    if (mdr_law_is_open(view, d)) return MDR_SUCCESS;
    segment = mdr_law_segment_at(view, view->branch, within);
    if (head->adhesive == 0.0) segment = within > 0.0;
    if (segment == 0) return MDR_SUCCESS;
    mdr_law_point point;
    of_conductance.force = rows;
    mdr_law_state_in(&of_conductance, mdr_law_interval_at(view, segment, at), at, &point);
    *conductance = point.force;
    *slope = d > within ? 0.0 : point.slope;
    if (within < at && point.force > 0.0) {
        const double power = (point.slope > 0.0 ? point.slope : 0.0) * at / point.force;
        *conductance = point.force * mdr_law_power(d / at, power);
        *slope = power * *conductance / d;
    }
    return MDR_SUCCESS;
}

#ifdef __cplusplus
}
#endif

#endif
