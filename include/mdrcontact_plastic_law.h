/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact_plastic_law.h
 * Plastic laws in inner loops and on devices: inline functions of C99, C++, CUDA, HIP, SYCL and OpenMP that evaluate a law of
 * mdrcontact/plastic.h. None calls the library.
 *
 * A view reads the buffer of a law, an array of doubles (mdr_plastic_law_buffer()) in any memory. It is a plain structure, valid as
 * long as its buffer, may be copied, and any number of threads may use it. The memory of a contact belongs to the calling program.
 *
 * The functions return MDR_SUCCESS; MDR_EDOMAIN beyond the largest depth; or MDR_EINVALID for a depth or a memory that is not one.
 * After a failure their outputs are NaN, and the memory is unchanged.
 * @since 0.1
 */
#ifndef MDRCONTACT_PLASTIC_LAW_INLINE_H
#define MDRCONTACT_PLASTIC_LAW_INLINE_H

#include "mdrcontact_law.h"

#ifdef __cplusplus
extern "C" {
#endif

/** First number of the buffer of a plastic law. */
#define MDR_PLASTIC_FORMAT 1296843602.0

/** Head of the buffer of a plastic law. Counts and places are also doubles. Places are indices from the beginning of the buffer. */
typedef struct mdr_plastic_head {
    double format;  /**< MDR_PLASTIC_FORMAT. */
    double size;    /**< Number of values in the buffer. */
    double elastic; /**< Place of the buffer of the elastic law. */
    double yield;   /**< Depth of first yield [length]. */
    double highest; /**< Largest depth; with adhesion that of the contact without it [length]. */
    double scale;   /**< Beyond yield y = scale (d - yield) + offset, whose exponent and leading bits number the panel. */
    double offset;  /**< See scale. */
    double bits;    /**< Leading bits of y that number a panel. */
    double panels;  /**< Number of panels. */
    double edges;   /**< Place of the ends of the panels, one more than panels; 0: the bits of y number them [length]. */
    double rows;    /**< Place of the polynomials: for each panel and power F, a, a A2/E* (theory/plastic.md (2.4)), 3 F/(4 E*) or 0. */
    double energy;  /**< Place of the work int F dd in the middle of each panel. */
    double tension; /**< With adhesion, place of the polynomials of the work that it takes from the plastic loss; else 0. */
    double modulus; /**< E*, that of the largest depth in laws of coated bodies [modulus]. */
    double line;    /**< 2 pi gamma/E*, gamma the work of adhesion [length]; 0 without adhesion. */
    double radius;  /**< a^2/d of the elastic contact [length]. */
    double touch;   /**< With adhesion, largest depth without it of a contact that has just closed; else 0 [length]. */
    double coated;  /**< 1: E* with which a contact unloads varies with its largest depth; else 0. */
} mdr_plastic_head;

/** A view of a plastic law, read by the inline functions. Its members are private. */
typedef struct mdr_plastic_view {
    mdr_law_view elastic;  /**< The elastic law, up to yield. */
    mdr_law_view virgin;   /**< First loading beyond yield: its panels only. */
    double yield, highest; /**< See mdr_plastic_head [length]. */
    const double *edges;   /**< Ends of the panels, or NULL. */
    const double *rows;    /**< [8][4] for each panel. */
    const double *energy;  /**< [1] for each panel. */
    const double *tension; /**< [8] for each panel, or NULL. */
    double modulus, line;  /**< See mdr_plastic_head. */
    double hertz;          /**< 3/(4 E*) [1/modulus]. */
    double radius, touch;  /**< See mdr_plastic_head [length]. */
    int panels, coated;    /**< See mdr_plastic_head. */
} mdr_plastic_view;

/** State of a plastic contact. */
typedef struct mdr_plastic_point {
    double force;  /**< F [modulus length^2]. */
    double slope;  /**< dF/dd along the path [modulus length]. */
    double radius; /**< a [length]. */
} mdr_plastic_point;

/** Return the view of a buffer that is used at another address, for example on a device.
 *  @param buffer  written by mdr_plastic_law_buffer(); read here
 *  @param there   address of the same numbers where the view is used
 *  @param view    receives the view
 *  @code
 *  mdr_plastic_view plastic_device;
 *  status = mdr_plastic_view_at(plastic_numbers, plastic_numbers, &plastic_device);
 *  @endcode
 */
MDR_INLINE int mdr_plastic_view_at(const double *buffer, const double *there, mdr_plastic_view *view)
{
    const mdr_plastic_head *const head = (const mdr_plastic_head *)buffer;
    if (!buffer || !there || !view) return MDR_ENULL;
    if (head->format != MDR_PLASTIC_FORMAT) return MDR_EINVALID;
    const size_t elastic = (size_t)head->elastic;
    const int status = mdr_law_view_at(buffer + elastic, there + elastic, MDR_ON_UNLOADING, &view->elastic);
    if (status != MDR_SUCCESS) return status;
    view->virgin = view->elastic;
    view->virgin.scale = head->scale;
    view->virgin.offset = head->offset;
    view->virgin.shift = 52 - (int)head->bits;
    view->virgin.half = (uint64_t)1 << (view->virgin.shift - 1);
    view->virgin.mask = ~(2 * view->virgin.half - 1);
    view->yield = head->yield;
    view->highest = head->highest;
    view->edges = head->edges > 0.0 ? there + (size_t)head->edges : NULL;
    view->rows = there + (size_t)head->rows;
    view->energy = there + (size_t)head->energy;
    view->tension = head->tension > 0.0 ? there + (size_t)head->tension : NULL;
    view->modulus = head->modulus;
    view->hertz = 0.75 / head->modulus;
    view->line = head->line;
    view->radius = head->radius;
    view->touch = head->touch;
    view->panels = (int)head->panels;
    view->coated = head->coated != 0.0;
    return MDR_SUCCESS;
}

/** Check whether a block is sound: the inline functions read no address outside it, at any depth and memory, and end. Views trust
 *  their block; check those of files, messages and shared memory that another program may have written. The check does not tell
 *  whether the law is that of a contact. It is a function of the library. It does not set mdr_last_error().
 *  @param buffer  the block, aligned to 8 bytes
 *  @param bytes   its size
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a block that is not sound
 *  @code
 *  double block[20000];
 *  mdr_plastic_law_buffer(plastic_law, 20000, block);
 *  status = mdr_plastic_law_check(block, sizeof block);
 *  @endcode
 */
int mdr_plastic_law_check(const double buffer[], size_t bytes);

/* The panel beyond yield that holds d, the place t in it and dt/dd. */
MDR_INLINE size_t mdr_plastic_panel(const mdr_plastic_view *view, double d, double *t, double *rate)
{
    if (!view->edges) {
        *rate = view->virgin.scale;
        return (size_t)mdr_law_panel(&view->virgin, view->virgin.scale * (d - view->yield) + view->virgin.offset, t);
    }
    int low = 0, high = view->panels - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (d > view->edges[middle + 1]) low = middle + 1;
        else high = middle;
    }
    *rate = 2.0 / (view->edges[low + 1] - view->edges[low]);
    *t = ((d - view->edges[low]) + (d - view->edges[low + 1])) / (view->edges[low + 1] - view->edges[low]);
    return (size_t)low;
}

/** An imprint, whose line load is (uniform s + hertz s^2) E* / A, s^2 = 1 - (x/A)^2. Its members are private. */
typedef struct mdr_plastic_imprint {
    double radius;  /**< Contact radius A at the largest depth [length]. */
    double uniform; /**< Of the uniform part of the pressure, A A2/E* [length^2]. */
    double hertz;   /**< Of Hertz's part, A A1/E* [length^2]. */
    double modulus; /**< E* [modulus]. */
} mdr_plastic_imprint;

/* c[0] + c[4] t + ... + c[28] t^7: a polynomial of a panel; and its derivative. */
MDR_INLINE double mdr_plastic_polynomial(const double c[], double t)
{
    const double q = t * t;
    return (c[0] + q * (c[8] + q * (c[16] + q * c[24]))) + t * (c[4] + q * (c[12] + q * (c[20] + q * c[28])));
}

MDR_INLINE double mdr_plastic_polynomial_with_slope(const double c[], double t, double *slope)
{
    const double row[8] = {c[0], c[4], c[8], c[12], c[16], c[20], c[24], c[28]};
    return mdr_law_polynomial_with_slope(row, t, slope);
}

/* The columns of a row at a largest depth beyond yield, together. */
MDR_INLINE void mdr_plastic_columns(const mdr_plastic_view *view, double deepest, double column[4])
{
    double t, rate, of[4]; /* which are no others: one vector */
    const double *const row = view->rows + 32 * mdr_plastic_panel(view, deepest, &t, &rate);
    const double q = t * t, q2 = q * q;
    for (int i = 0; i < 4; ++i) {
        of[i] = ((row[i] + t * row[i + 4]) + q * (row[i + 8] + t * row[i + 12]))
                + q2 * ((row[i + 16] + t * row[i + 20]) + q * (row[i + 24] + t * row[i + 28]));
    }
    memcpy(column, of, sizeof of);
}

/* The imprint of these columns. The two terms have the force of first loading: F is continuous. */
MDR_INLINE mdr_plastic_imprint mdr_plastic_imprint_from(const mdr_plastic_view *view, const double column[4])
{
    mdr_plastic_imprint imprint;
    imprint.radius = column[1];
    imprint.uniform = column[2] > 0.0 ? column[2] : 0.0;
    imprint.hertz = (view->coated ? column[3] : view->hertz * column[0]) - 1.1780972450961724 * imprint.uniform; /* 3 pi/8 */
    imprint.modulus = view->coated ? 0.75 * column[0] / column[3] : view->modulus;
    return imprint;
}

MDR_INLINE mdr_plastic_imprint mdr_plastic_imprint_of(const mdr_plastic_view *view, double deepest)
{
    double column[4];
    mdr_plastic_columns(view, deepest, column);
    return mdr_plastic_imprint_from(view, column);
}

/* (theta - sin theta cos theta)/(2 u t), where u = sin theta and t = 1 - cos theta: interpolated at Chebyshev's points of x = 2 t - 1,
 * within 2e-13; even and odd powers of x together. */
MDR_INLINE double mdr_plastic_segment(double t)
{
    const double even[8] = {0.7091995761560778,     0.015332626935539106,   0.0013571087988488734,  0.00012895593938380375,
                            1.2712705522649381e-05, 1.2950133095189356e-06, 1.1839080872960026e-07, 2.1092491610519582e-08};
    const double odd[8] = {0.05440056512511779,    0.004504519998373107,   0.00041581942315712886, 4.035590547187221e-05,
                           4.0290827458097725e-06, 4.1397579345129936e-07, 3.8031184673660666e-08, 6.8235224993021594e-09};
    const double *const c[2] = {even, odd};
    const double x = t - (1.0 - t), q = x * x, q2 = q * q, q4 = q2 * q2;
    double of[2];
    for (int i = 0; i < 2; ++i) {
        of[i] = ((c[i][0] + q * c[i][1]) + q2 * (c[i][2] + q * c[i][3])) + q4 * ((c[i][4] + q * c[i][5]) + q2 * (c[i][6] + q * c[i][7]));
    }
    return of[0] + x * of[1];
}

/* t = 1 - sqrt(1 - u^2) and u = a/A of an imprint without adhesion at y = (largest depth) - d, 0 of an open contact, without a branch:
 * t (B2 + 2 B1 - B1 t) = w, w = A ((largest depth) - (residual depth) - y), theory/plastic.md (2.9). */
MDR_INLINE void mdr_plastic_edge(const mdr_plastic_imprint *imprint, double y, double *t, double *u)
{
    const double left = (imprint->uniform + imprint->hertz) - imprint->radius * y, w = left > 0.0 ? left : 0.0;
    const double b = imprint->uniform + 2.0 * imprint->hertz, root = b * b - 4.0 * imprint->hertz * w;
    const double sum = b + sqrt(root > 0.0 ? root : 0.0), g = 2.0 / sum;
    *t = g * w;
    *u = g * sqrt(w * (sum - w));
}

/* F/E* and U/E* of an imprint without adhesion whose contact ends at u = a/A. */
MDR_INLINE double mdr_plastic_force_at(const mdr_plastic_imprint *imprint, double t, double u)
{
    return u * t * (4.0 / 3.0 * imprint->hertz * (2.0 - t) + 2.0 * imprint->uniform * mdr_plastic_segment(t));
}

MDR_INLINE double mdr_plastic_energy_at(const mdr_plastic_imprint *imprint, double t, double u)
{
    const double b1 = imprint->hertz, b2 = imprint->uniform, cube = u * u * u, s = 1.0 - t;
    const double angle = 2.0 * (u * t * mdr_plastic_segment(t)) + u * s;
    const double mixed = 0.125 * (angle * (4.0 * u * u - 1.0) + u * s) - 5.0 / 12.0 * (cube * s);
    return (8.0 / 15.0 * b1 * b1 * (cube * u * u) + 2.0 * b1 * b2 * mixed + b2 * b2 * (u - cube / 3.0 - s * angle)) / imprint->radius;
}

/* First loading without adhesion: F, dF/dd, a and da/dd at a depth up to the largest one; a == NULL: the first two alone. */
MDR_INLINE int mdr_plastic_virgin(const mdr_plastic_view *view, double d, double *F, double *slope, double *a, double *widening)
{
    double t, rate, rise;
    if (d > view->yield) {
        const double *const row = view->rows + 32 * mdr_plastic_panel(view, d, &t, &rate);
        *F = mdr_plastic_polynomial_with_slope(row, t, &rise);
        *slope = rate * rise;
        if (a) {
            *a = mdr_plastic_polynomial_with_slope(row + 1, t, &rise);
            if (widening) *widening = rate * rise;
        }
        return MDR_SUCCESS;
    }
    if (!a) return mdr_law_view_force_slope(&view->elastic, d, F, slope);
    mdr_law_point point;
    const int status = mdr_law_view_state(&view->elastic, d, &point);
    *F = point.force;
    *slope = point.slope;
    *a = point.radius;
    if (widening) *widening = d > 0.0 ? 0.5 * point.radius / d : 0.0;
    return status;
}

/* Work int F dd of first loading without adhesion. */
MDR_INLINE double mdr_plastic_work(const mdr_plastic_view *view, double d)
{
    double t, rate, work = 0.0;
    if (d > view->yield) {
        const size_t panel = mdr_plastic_panel(view, d, &t, &rate);
        const double *const c = view->rows + 32 * panel;
        for (int i = 7; i >= 0; --i) work = work * t + c[4 * i] * (1.0 / (i + 1));
        return view->energy[panel] + work * t / rate;
    }
    mdr_law_point point;
    mdr_law_view_state(&view->elastic, d, &point);
    return point.energy;
}

/* The state of an imprint without adhesion at y = (largest depth) - d. */
MDR_INLINE void mdr_plastic_unload(const mdr_plastic_imprint *imprint, double y, double *F, double *slope, double *a)
{
    double t, u;
    mdr_plastic_edge(imprint, y, &t, &u);
    *F = imprint->modulus * mdr_plastic_force_at(imprint, t, u);
    *a = imprint->radius * u;
    *slope = 2.0 * imprint->modulus * *a;
}

/* Whether a contact without adhesion is below its largest depth, beyond yield; both numbers are then possible. */
MDR_INLINE int mdr_plastic_is_below(const mdr_plastic_view *view, double deepest, double d)
{
    return d < deepest && deepest > view->yield && deepest <= view->highest && d >= -DBL_MAX ? 1 : 0;
}

/* The state of a contact without adhesion whose largest depth so far is `deepest`; *kept becomes the largest depth with this one. */
MDR_INLINE int mdr_plastic_follow(const mdr_plastic_view *view, double deepest, double d, double *kept, double *F, double *slope,
                                  double *a)
{
    if (mdr_plastic_is_below(view, deepest, d)) {
        const mdr_plastic_imprint imprint = mdr_plastic_imprint_of(view, deepest);
        double radius;
        *kept = deepest;
        mdr_plastic_unload(&imprint, deepest - d, F, slope, &radius);
        if (a) *a = radius;
        return MDR_SUCCESS;
    }
    if (!(d <= DBL_MAX && d >= -DBL_MAX && deepest >= 0.0 && deepest <= view->highest)) return MDR_EINVALID;
    if (d > view->highest) return MDR_EDOMAIN;
    *kept = d > deepest ? d : deepest;
    return mdr_plastic_virgin(view, d, F, slope, a, NULL);
}

/* With adhesion: depth by which the edge of a contact of radius a is pulled out. */
MDR_INLINE double mdr_plastic_pull(const mdr_plastic_view *view, double a)
{
    return sqrt(view->line * (a > 0.0 ? a : 0.0));
}

/* The largest depth without adhesion at which first loading with adhesion arrives at d, from the state at `deepest` on; NaN beyond
 * the largest depth. */
MDR_INLINE double mdr_plastic_arrive(const mdr_plastic_view *view, double deepest, double d)
{
    double low = deepest > view->touch ? deepest : view->touch, high = view->highest, x = low, F, slope, a, widening;
    if (!(high > low)) return high == low ? low : (double)NAN;
    mdr_plastic_virgin(view, high, &F, &slope, &a, &widening);
    if (high - mdr_plastic_pull(view, a) < d) return (double)NAN;
    for (int i = 0; i < 60; ++i) {
        mdr_plastic_virgin(view, x, &F, &slope, &a, &widening);
        const double pull = mdr_plastic_pull(view, a), miss = x - pull - d;
        if (miss < 0.0) low = x;
        else high = x;
        double next = x - miss / (1.0 - 0.5 * pull * widening / a);
        if (!(next >= low && next <= high)) next = 0.5 * (low + high);
        if (fabs(next - x) <= 4.5e-16 * x) return next;
        x = next;
    }
    return x;
}

/* The depth at which an open contact closes. */
MDR_INLINE double mdr_plastic_residual(const mdr_plastic_view *view, double deepest)
{
    if (!(deepest > view->yield)) return 0.0;
    const mdr_plastic_imprint imprint = mdr_plastic_imprint_of(view, deepest);
    return deepest - (imprint.uniform + imprint.hertz) / imprint.radius;
}

/* The imprint of any largest depth, yielded or not. */
MDR_INLINE mdr_plastic_imprint mdr_plastic_any_imprint(const mdr_plastic_view *view, double deepest)
{
    mdr_plastic_imprint imprint;
    if (deepest > view->yield) return mdr_plastic_imprint_of(view, deepest);
    imprint.radius = sqrt(view->radius * (deepest > 0.0 ? deepest : 0.0));
    imprint.uniform = 0.0;
    imprint.hertz = imprint.radius * deepest;
    imprint.modulus = view->modulus;
    return imprint;
}

/* A ((largest depth) - d) of an imprint with adhesion whose contact ends at s; pull is A l(A). */
MDR_INLINE double mdr_plastic_recovery(const mdr_plastic_imprint *imprint, double pull, double s)
{
    return s * (imprint->uniform + imprint->hertz * s) + pull * sqrt(sqrt((1.0 - s) * (1.0 + s)));
}

/* The largest s of a stable contact under prescribed depth: pull-off. */
MDR_INLINE double mdr_plastic_last(const mdr_plastic_imprint *imprint, double pull)
{
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60 && high - low > 1e-16; ++i) {
        const double s = 0.5 * (low + high), u = sqrt((1.0 - s) * (1.0 + s));
        if ((imprint->uniform + 2.0 * imprint->hertz * s) * (u * sqrt(u)) > 0.5 * pull * s) low = s;
        else high = s;
    }
    return low;
}

/* s of the stable contact at y = (largest depth) - d between those at s = 0 and at `last`. */
MDR_INLINE double mdr_plastic_peel(const mdr_plastic_imprint *imprint, double pull, double last, double y)
{
    double low = 0.0, high = last, s = 0.5 * last;
    for (int i = 0; i < 80; ++i) {
        const double u = sqrt((1.0 - s) * (1.0 + s)), miss = mdr_plastic_recovery(imprint, pull, s) - y;
        const double rise = imprint->uniform + 2.0 * imprint->hertz * s - 0.5 * pull * s / (u * sqrt(u));
        if (miss < 0.0) low = s;
        else high = s;
        double next = s - miss / rise;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (fabs(next - s) <= 2.3e-16 * s || high - low <= 2.3e-16 * high) return next;
        s = next;
    }
    return s;
}

/** A contact with adhesion. Its members are private. */
typedef struct mdr_plastic_sticky {
    double deepest; /**< Largest depth, of the contact without adhesion [length]. */
    double s;       /**< sqrt(1 - (a/A)^2) of its edge; 0 on first loading [1]. */
    double lost;    /**< Energy that jumps have lost [modulus length^3]. */
    int closed;     /**< 1 while the bodies touch. */
} mdr_plastic_sticky;

/* Energy of a closed contact with adhesion against separated bodies. */
MDR_INLINE double mdr_plastic_sticky_energy(const mdr_plastic_view *view, const mdr_plastic_sticky *contact)
{
    const mdr_plastic_imprint imprint = mdr_plastic_any_imprint(view, contact->deepest);
    const double s = contact->s, u = sqrt((1.0 - s) * (1.0 + s)), a = imprint.radius * u;
    if (!contact->closed) return 0.0;
    return view->modulus
           * (mdr_plastic_energy_at(&imprint, 1.0 - s, u) - mdr_plastic_force_at(&imprint, 1.0 - s, u) * mdr_plastic_pull(view, a)
              + 0.5 * view->line * a * a);
}

/* Energy that plastic flow has taken on first loading to a largest depth. */
MDR_INLINE double mdr_plastic_loss(const mdr_plastic_view *view, double deepest)
{
    double t, rate, tension = 0.0;
    if (!(deepest > view->yield)) return 0.0;
    const mdr_plastic_imprint imprint = mdr_plastic_imprint_of(view, deepest);
    if (view->tension) {
        const size_t panel = mdr_plastic_panel(view, deepest, &t, &rate);
        tension = mdr_law_polynomial(view->tension + 8 * panel, t);
    }
    return mdr_plastic_work(view, deepest) - imprint.modulus * mdr_plastic_energy_at(&imprint, 1.0, 1.0) - tension;
}

/* Moves a closed contact with adhesion to d, where it may detach. */
MDR_INLINE int mdr_plastic_move(const mdr_plastic_view *view, double d, mdr_plastic_sticky *contact)
{
    const mdr_plastic_imprint imprint = mdr_plastic_any_imprint(view, contact->deepest);
    const double pull = imprint.radius * mdr_plastic_pull(view, imprint.radius), y = imprint.radius * (contact->deepest - d);
    contact->s = 0.0;
    if (y <= pull) {
        const double reached = mdr_plastic_arrive(view, contact->deepest, d);
        if (!(reached >= 0.0)) return MDR_EDOMAIN;
        contact->deepest = reached > contact->deepest ? reached : contact->deepest;
        return MDR_SUCCESS;
    }
    const double last = mdr_plastic_last(&imprint, pull);
    if (y > mdr_plastic_recovery(&imprint, pull, last)) {
        contact->s = last;
        contact->lost += mdr_plastic_sticky_energy(view, contact);
        contact->closed = 0;
        contact->s = 0.0;
        return MDR_SUCCESS;
    }
    contact->s = mdr_plastic_peel(&imprint, pull, last, y);
    return MDR_SUCCESS;
}

/* A contact with adhesion, by its memory: the largest depth, negative while the contact is closed, and what jumps have lost, which
 * no contact exceeds. */
MDR_INLINE int mdr_plastic_follow_sticky(const mdr_plastic_view *view, const double memory[2], double d, mdr_plastic_sticky *contact)
{
    contact->deepest = fabs(memory[0]);
    contact->closed = memory[0] < 0.0;
    contact->lost = memory[1];
    contact->s = 0.0;
    if (!(d <= DBL_MAX && d >= -DBL_MAX && contact->deepest <= view->highest && contact->lost >= 0.0 && contact->lost <= 1e150)) {
        return MDR_EINVALID;
    }
    if (!contact->closed) {
        const double touch = mdr_plastic_residual(view, contact->deepest), before = mdr_plastic_loss(view, contact->deepest);
        if (d < touch) return MDR_SUCCESS;
        contact->closed = 1;
        const int status = mdr_plastic_move(view, touch, contact);
        if (status != MDR_SUCCESS) return status;
        contact->lost += before - mdr_plastic_loss(view, contact->deepest) - mdr_plastic_sticky_energy(view, contact);
    }
    return mdr_plastic_move(view, d, contact);
}

/* The same with the force, its slope and the radius. */
MDR_INLINE int mdr_plastic_sticky_state(const mdr_plastic_view *view, const double memory[2], double d, mdr_plastic_sticky *contact,
                                        double *F, double *slope, double *a)
{
    double force, rise, radius, widening;
    const int status = mdr_plastic_follow_sticky(view, memory, d, contact);
    if (status != MDR_SUCCESS) return status;
    *F = *slope = 0.0;
    if (a) *a = 0.0;
    if (!contact->closed) return MDR_SUCCESS;
    if (contact->s > 0.0) {
        const mdr_plastic_imprint imprint = mdr_plastic_any_imprint(view, contact->deepest);
        const double s = contact->s, u = sqrt((1.0 - s) * (1.0 + s));
        radius = imprint.radius * u;
        const double pull = mdr_plastic_pull(view, radius), steep = (imprint.uniform + 2.0 * imprint.hertz * s) * (u * u);
        const double bend = imprint.radius * pull * s;
        *F = view->modulus * (mdr_plastic_force_at(&imprint, 1.0 - s, u) - 2.0 * radius * pull);
        *slope = 2.0 * view->modulus * radius * (steep - 1.5 * bend) / (steep - 0.5 * bend);
    } else {
        const int found = mdr_plastic_virgin(view, contact->deepest, &force, &rise, &radius, &widening);
        const double pull = mdr_plastic_pull(view, radius);
        if (found != MDR_SUCCESS) return found;
        *F = force - 2.0 * view->modulus * radius * pull;
        *slope = (rise - 3.0 * view->modulus * pull * widening) / (1.0 - 0.5 * pull * widening / radius);
    }
    if (a) *a = radius;
    return MDR_SUCCESS;
}

/* Length of the memory of a contact. */
MDR_INLINE size_t mdr_plastic_memory_size(const mdr_plastic_view *view)
{
    return view->line > 0.0 ? 2 : 1;
}

/* Copies the memory of a contact. */
MDR_INLINE void mdr_plastic_keep(const mdr_plastic_view *view, const double from[], double memory[])
{
    memory[0] = from[0];
    if (view->line > 0.0) memory[1] = from[1];
}

/* A step of one contact from its memory to the one after it: F, dF/dd and a; a == NULL: the first two alone. */
MDR_INLINE int mdr_plastic_step(const mdr_plastic_view *view, double d, const double memory[], double after[], double *F, double *slope,
                                double *a)
{
    mdr_plastic_sticky contact;
    if (!(view->line > 0.0)) {
        after[1] = 0.0;
        return mdr_plastic_follow(view, memory[0], d, &after[0], F, slope, a);
    }
    const int status = mdr_plastic_sticky_state(view, memory, d, &contact, F, slope, a);
    after[0] = contact.closed ? -contact.deepest : contact.deepest;
    after[1] = contact.lost;
    return status;
}

/** Compute the force of one contact at a depth, and change its memory; as mdr_plastic_law_advance() for one contact.
 *  @param view    view of a law
 *  @param d       indentation depth at the end of the step [length]
 *  @param memory  of the contact: one number, with adhesion two, all 0 before the first step
 *  @param F       receives the normal force [modulus length^2]
 *  @param slope   receives dF/dd along the path [modulus length]
 *  @code
 *  double memory[1] = {0}, F, slope;
 *  status = mdr_plastic_view_advance(&plastic_view, 5e-6, memory, &F, &slope);
 *  @endcode
 */
MDR_INLINE int mdr_plastic_view_advance(const mdr_plastic_view *view, double d, double memory[], double *F, double *slope)
{
    double after[2];
    const int status = mdr_plastic_step(view, d, memory, after, F, slope, NULL);
    if (status == MDR_SUCCESS) mdr_plastic_keep(view, after, memory);
    else *F = *slope = (double)NAN;
    return status;
}

/** Compute the state of one contact at a depth without a change of its memory.
 *  @param view    view of a law
 *  @param d       indentation depth at the end of the step [length]
 *  @param memory  of the contact, as in mdr_plastic_view_advance()
 *  @param after   or NULL: receives the memory that mdr_plastic_view_advance() would leave
 *  @param point   receives the state
 *  @code
 *  const double memory[1] = {6e-6};
 *  mdr_plastic_point point;
 *  status = mdr_plastic_view_try(&plastic_view, 5.5e-6, memory, NULL, &point);
 *  @endcode
 */
MDR_INLINE int mdr_plastic_view_try(const mdr_plastic_view *view, double d, const double memory[], double after[],
                                        mdr_plastic_point *point)
{
    double kept[2];
    const int status = mdr_plastic_step(view, d, memory, kept, &point->force, &point->slope, &point->radius);
    if (status != MDR_SUCCESS) point->force = point->slope = point->radius = (double)NAN;
    else if (after) mdr_plastic_keep(view, kept, after);
    return status;
}

/** Compute the energies of one contact at a depth.
 *  @param view        view of a law
 *  @param d           indentation depth [length]
 *  @param memory      of the contact, as in mdr_plastic_view_advance(); a step to d is taken without a change of it
 *  @param stored      receives the work that the contact gives back, less with adhesion that of its surfaces [modulus length^3]
 *  @param dissipated  receives what plastic flow and jumps have taken since the first step [modulus length^3]
 *  @code
 *  const double memory[1] = {6e-6};
 *  double stored, dissipated;
 *  status = mdr_plastic_view_energies(&plastic_view, 5.5e-6, memory, &stored, &dissipated);
 *  @endcode
 */
MDR_INLINE int mdr_plastic_view_energies(const mdr_plastic_view *view, double d, const double memory[], double *stored,
                                         double *dissipated)
{
    mdr_plastic_sticky contact = {0.0, 0.0, 0.0, 0};
    int status;
    *stored = *dissipated = (double)NAN;
    if (view->line > 0.0) {
        status = mdr_plastic_follow_sticky(view, memory, d, &contact);
        if (status == MDR_SUCCESS) *stored = mdr_plastic_sticky_energy(view, &contact);
    } else {
        double F, slope, t, u;
        status = mdr_plastic_follow(view, memory[0], d, &contact.deepest, &F, &slope, NULL);
        if (status == MDR_SUCCESS) {
            *stored = 0.0;
            if (contact.deepest <= view->yield) {
                *stored = mdr_plastic_work(view, d);
            } else {
                const mdr_plastic_imprint imprint = mdr_plastic_imprint_of(view, contact.deepest);
                mdr_plastic_edge(&imprint, contact.deepest - d, &t, &u);
                *stored = imprint.modulus * mdr_plastic_energy_at(&imprint, t, u);
            }
        }
    }
    if (status == MDR_SUCCESS) *dissipated = mdr_plastic_loss(view, contact.deepest) + contact.lost;
    return status;
}

#ifdef __cplusplus
}
#endif

#endif
