/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file wear.h
 * Wear by Archard's law. Option MDRCONTACT_WEAR.
 * @since 0.1
 */
#ifndef MDRCONTACT_WEAR_H
#define MDRCONTACT_WEAR_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact that wears by Archard's law, dh = k p ds. Made by mdr_wear_new(). */
typedef struct mdr_wear mdr_wear;

/** A contact without adhesion, and how fast its two sides wear.
 *  @param c                 contact
 *  @param n                 layers of the indenter from its surface, and what lies below them: 1 without a coating
 *  @param coefficient       [n] k > 0, worn volume per force and sliding distance, of each of them [1/modulus]
 *  @param thickness         [n - 1] of the layers, > 0; NULL for n = 1 [length]
 *  @param body_coefficient  k >= 0 of the body [1/modulus]
 *  @param out               receives the handle
 *  @return also MDR_EINVALID with adhesion: there is no law of wear where surfaces pull */
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient,
                 mdr_wear **out);

/** Where fretting ends: a disc of radius c sticks for good, all outside slips and wears until it carries nothing. Exact, on layered
 *  bodies too: F = F0(c) + k(c) (d - d0(c)), and the worn indenter is the free surface, f = d - u(r), c < r < b.
 *
 *  What stick radius a prescribed shift leads to is not computed: on coatings it is not that of the first cycle.
 *  @param w             contact that wears
 *  @param state         a state of its unworn contact, with a radius > 0
 *  @param stick_radius  c, 0 < c <= a [length]
 *  @param given         what is held: MDR_DEPTH or MDR_FORCE
 *  @param reached       receives depth, stick radius, force, stiffness, and the depth beyond that of the unworn state at c
 *  @param outer_radius  receives b, up to where the indenter is worn; may be NULL [length]
 *  @param worn_volume   receives int_c^b (f - f0) 2 pi r dr, of both sides together; may be NULL [length^3]
 *  @param out           receives the worn indenter, with the wear of both sides; may be NULL
 *  @return also MDR_EDOMAIN for c > a, where the pressure would be negative, and where the indenter ends within the scar */
int mdr_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached,
                   double *outer_radius, double *worn_volume, mdr_profile **out);

/** Depth of the track that the sliding indenter leaves in the body, h(y) = k N q(y): the load that passes over a place is the line
 *  load. To first order in h/d.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param passes  N > 0 [1]
 *  @param n       number of places
 *  @param y       [n] distances from the axis of the track, >= 0 [length]
 *  @param out     [n] depths, 0 beyond the contact radius [length]
 *  @return also MDR_EDOMAIN for a track deeper than a tenth of the depth d, and where the pressure would be negative */
int mdr_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[]);

/** Passes until the track is as deep as h, N = h/(k q(0)): a coating of this thickness is then worn through.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param depth   h > 0 [length]
 *  @param passes  receives N [1]
 *  @return as mdr_wear_track() */
int mdr_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes);

/** l: under a flat punch what the pressure still differs by from that at the end - F/(pi a^2) at constant force, 0 at constant depth -
 *  falls as exp(-s/l) after a few l. Of a coated punch that is worn through. a/(2.060650 k E*) at constant force and
 *  a/(0.578887 k E*) at constant depth on a homogeneous body.
 *  @param w       contact of a flat punch that wears, on a homogeneous or an exact medium
 *  @param given   what is constant: MDR_DEPTH or MDR_FORCE
 *  @param length  receives l, a sliding distance [length]
 *  @return also MDR_EINVALID for other indenters and media */
int mdr_wear_running_in(const mdr_wear *w, int given, double *length);

/** A sliding contact and what it has lost so far, which changes; not for two threads at a time. Made by mdr_wear_history_new() or
 *  mdr_wear_history_copy(). */
typedef struct mdr_wear_history mdr_wear_history;

/** What a history of wear has come to. */
typedef struct mdr_wear_state {
    double sliding;     /**< s since the beginning [length]. */
    double depth;       /**< d from the original apex of the indenter [length]. */
    double radius;      /**< a [length]. */
    double force;       /**< F [modulus length^2]. */
    double pressure;    /**< p on the axis [modulus]. */
    double worn_depth;  /**< What the indenter has lost on the axis [length]. */
    double worn_volume; /**< What it has lost as a whole [length^3]. */
    double body_depth;  /**< What the body has lost on the axis, where the same places rub on each other, else 0 [length]. */
    double body_volume; /**< The same as a whole [length^3]. */
    double work;        /**< int F ds [modulus length^3]. */
    double error;       /**< The largest relative error of a, d, F, p and the worn depth: two resolutions differ by so much. */
} mdr_wear_state;

/** What the indenter rubs on. */
enum mdr_wear_places {
    MDR_WEAR_FRESH = 2001, /**< Fresh places of the body, as a tip that goes its way: the indenter alone changes. */
    MDR_WEAR_SAME = 2002   /**< The same places, as both do that move back and forth by much less than a: both change. */
};

/** How a sliding contact is followed. Two resolutions, of n/2 and n intervals, march side by side; they state the error. */
enum mdr_wear_scheme {
    MDR_WEAR_DISC = 2101, /**< A disc that moves with the edge of the contact, of second order, extrapolated: with 80 intervals a,
                               d, F are good to 1e-4 on bodies of any layers. For contacts that do not shrink, and no flat punch. */
    MDR_WEAR_RINGS = 2102 /**< Rings that stay on the indenter, of first order: some 1e-2 with 80 intervals, but k F s is met to
                               rounding, any path of load and depth can be followed, and a flat punch too. */
};

/** What a history of wear leaves to choose. Begun by MDR_SIZED. */
typedef struct mdr_wear_options {
    size_t size;   /**< Of this structure; MDR_SIZED sets it. */
    int intervals; /**< n, a multiple of 4, 16 to 640; default 0: 80. */
    int places;    /**< Of enum mdr_wear_places; default 0: MDR_WEAR_FRESH. */
    int scheme;    /**< Of enum mdr_wear_scheme; default 0: MDR_WEAR_DISC. */
} mdr_wear_options;

/** A contact that is pressed on and has not slid yet. A step takes about a millisecond.
 *  @param w        contact that wears, on a homogeneous or an exact medium
 *  @param given    MDR_DEPTH or MDR_FORCE
 *  @param value    d [length] or F [modulus length^2] at the beginning, > 0
 *  @param options  see there; NULL: all defaults
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN where the pressure would be negative (MDR_WEAR_DISC; rings open there), MDR_EINVALID for other media */
int mdr_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options, mdr_wear_history **out);

/** An independent copy.
 *  @param h    history
 *  @param out  receives the handle */
int mdr_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out);

/** Slides on: in each part of the path depth or force goes evenly to its value at the end. After a failure the history is as before,
 *  and can go on with other values.
 *  @param h        history
 *  @param given    MDR_DEPTH (from the original apex) or MDR_FORCE
 *  @param n        number of parts
 *  @param sliding  [n] sliding distances, >= 0 [length]
 *  @param value    [n] d [length] or F [modulus length^2] at their ends, > 0
 *  @param out      [n] states at their ends
 *  @return also MDR_EDOMAIN where the contact would shrink (MDR_WEAR_DISC), as it does under a falling load, lift off, grow beyond
 *          the end of the indenter, or carry no pressure somewhere, and where a coating of the body would lose more than a quarter
 *          of its thickness */
int mdr_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[],
                             mdr_wear_state out[]);

/** What it has come to.
 *  @param h         history
 *  @param n         number of positions
 *  @param r         [n] r >= 0 [length]
 *  @param out       or NULL: receives the state
 *  @param pressure  [n] p(r), with the resolution of the intervals, 0 outside the contact [modulus] */
int mdr_wear_history_state(const mdr_wear_history *h, int n, const double r[], mdr_wear_state *out, double pressure[]);

/** The indenter as it is now, whose depth counts from its new apex; of the gap, where both sides wear.
 *  @param h    history
 *  @param out  receives the handle of a profile */
int mdr_wear_history_profile(const mdr_wear_history *h, mdr_profile **out);

/** The past as numbers, from which another history of the same contact goes on with the same bits.
 *  @param h         history
 *  @param capacity  of numbers
 *  @param numbers   [capacity] receives the first of them; may be NULL for capacity 0
 *  @param count     receives how many there are; may be NULL */
int mdr_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count);

/** Goes on from saved numbers.
 *  @param h        history of the same contact, with as many intervals
 *  @param n        as many as mdr_wear_history_save() gives
 *  @param numbers  [n] by mdr_wear_history_save()
 *  @return also MDR_EINVALID for numbers of another history */
int mdr_wear_history_restore(mdr_wear_history *h, int n, const double numbers[]);

#ifdef __cplusplus
}
#endif

#endif
