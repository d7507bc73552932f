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

/** A contact that wears by Archard's law, dh = k p ds. Created by mdr_wear_new(). Immutable. */
typedef struct mdr_wear mdr_wear;

/** Create a contact without adhesion whose two sides wear.
 *  @param c                 contact
 *  @param n                 number of materials of the indenter: its layers from its surface, and the material below them; 1
 *                           without a coating
 *  @param coefficient       [n] k > 0, worn volume per force and sliding distance, of each material [1/modulus]
 *  @param thickness         [n - 1] of the layers, > 0; NULL for n = 1 [length]
 *  @param body_coefficient  k >= 0 of the body [1/modulus]
 *  @param out               receives the handle
 *  @return also MDR_EINVALID with adhesion, because Archard's law is not defined under tension
 *  @code
 *  mdr_wear *worn_pair = NULL;
 *  const double k = 1e-16;
 *  status = mdr_wear_new(contact, 1, &k, NULL, 0.0, &worn_pair);
 *  MDR_FREE(worn_pair);
 *  @endcode
 */
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient,
                 mdr_wear **out);

/** Compute the final state of fretting: a disc of radius c sticks permanently, and the slip zone wears until it carries no load.
 *  The state is exact, also on layered bodies: F = F0(c) + k(c) (d - d0(c)), and the worn profile coincides with the free surface,
 *  f = d - u(r), c < r < b.
 *
 *  The stick radius under a prescribed shift is not computed; on coatings it is not that of the first cycle.
 *  @param w             contact that wears
 *  @param state         a state of its unworn contact, with a radius > 0
 *  @param stick_radius  c, 0 < c <= a [length]
 *  @param given         the constant quantity: MDR_DEPTH or MDR_FORCE
 *  @param reached       receives depth, stick radius, force, stiffness, and the depth relative to the unworn state of radius c
 *  @param outer_radius  receives b, outer radius of the worn area; may be NULL [length]
 *  @param worn_volume   receives int_c^b (f - f0) 2 pi r dr, of both sides together; may be NULL [length^3]
 *  @param out           receives the worn indenter, with the wear of both sides; may be NULL
 *  @return also MDR_EDOMAIN for c > a, if the pressure is negative, and if the indenter ends inside the worn area
 *  @code
 *  mdr_state reached;
 *  double b, volume;
 *  status = mdr_wear_limit(wear, &state, 0.4e-6, MDR_DEPTH, &reached, &b, &volume, NULL);
 *  @endcode
 */
int mdr_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached,
                   double *outer_radius, double *worn_volume, mdr_profile **out);

/** Compute the depth of the wear track that the sliding indenter leaves in the body, h(y) = k N q(y): the total load that passes
 *  over a point is the line load. To first order in h/d.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param passes  N > 0 [1]
 *  @param n       number of positions
 *  @param y       [n] distances from the axis of the track, >= 0 [length]
 *  @param out     [n] depths, 0 beyond the contact radius [length]
 *  @return also MDR_EDOMAIN for a track deeper than a tenth of the depth d, and if the pressure is negative
 *  @code
 *  const double y[2] = {0.0, 0.3e-6};
 *  double h[2];
 *  status = mdr_wear_track(wear, &state, 100.0, 2, y, h);
 *  @endcode
 */
int mdr_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[]);

/** Compute the number of passes to a track of depth h, N = h/(k q(0)), after which a coating of this thickness is worn through.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param depth   h > 0 [length]
 *  @param passes  receives N [1]
 *  @return as mdr_wear_track()
 *  @code
 *  double passes;
 *  status = mdr_wear_passes(wear, &state, 1e-9, &passes);
 *  @endcode
 */
int mdr_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes);

/** Compute the running-in length l of a flat punch. After a few l the deviation of the pressure from the final one (F/(pi a^2) at
 *  constant force, 0 at constant depth) decays as exp(-s/l). On a homogeneous body l is a/(2.060650 k E*) at constant force and
 *  a/(0.578887 k E*) at constant depth. A coated punch counts as worn through to its core.
 *  @param w       contact of a flat punch that wears, on a homogeneous or an exact medium
 *  @param given   the constant quantity: MDR_DEPTH or MDR_FORCE
 *  @param length  receives l, a sliding distance [length]
 *  @return also MDR_EINVALID for other indenters and media
 *  @code
 *  double length;
 *  status = mdr_wear_running_in(punch_wear, MDR_FORCE, &length);
 *  @endcode
 */
int mdr_wear_running_in(const mdr_wear *w, int given, double *length);

/** A sliding contact and its wear. It changes; only one thread may use it at a time. Created by mdr_wear_history_new() or
 *  mdr_wear_history_copy(). */
typedef struct mdr_wear_history mdr_wear_history;

/** The state of a wear history. */
typedef struct mdr_wear_state {
    double sliding;     /**< s, total sliding distance [length]. */
    double depth;       /**< d from the original apex of the indenter [length]. */
    double radius;      /**< a [length]. */
    double force;       /**< F [modulus length^2]. */
    double pressure;    /**< p on the axis [modulus]. */
    double worn_depth;  /**< Worn depth of the indenter on the axis [length]. */
    double worn_volume; /**< Worn volume of the indenter [length^3]. */
    double body_depth;  /**< Worn depth of the body on the axis if the same places rub on each other, otherwise 0 [length]. */
    double body_volume; /**< Worn volume of the body in that case [length^3]. */
    double work;        /**< int F ds [modulus length^3]. */
    double error;       /**< Largest relative error of a, d, F, p and the worn depth, estimated from two resolutions. */
} mdr_wear_state;

/** The counterface of the indenter. */
enum mdr_wear_places {
    MDR_WEAR_FRESH = 2001, /**< The indenter always slides on fresh places of the body: only the indenter changes. */
    MDR_WEAR_SAME = 2002   /**< The same places slide on each other, in oscillations much shorter than a: both sides change. */
};

/** Discretization of a sliding contact. Two resolutions, of n/2 and n intervals, are integrated together and provide the error. */
enum mdr_wear_scheme {
    MDR_WEAR_DISC = 2101, /**< A disc that moves with the contact edge; second order with extrapolation: with 80 intervals the
                               errors of a, d and F are about 1e-4 on bodies of any layers. For contacts that do not shrink; not for
                               a flat punch. */
    MDR_WEAR_RINGS = 2102 /**< Rings fixed to the indenter; first order: with 80 intervals the error of a is some 1e-3, that of p 1e-2,
                               but the worn volume k F s is exact to machine precision. For any path of load and depth, and for
                               a flat punch. */
};

/** Options of mdr_wear_history_new(). Initialize with MDR_SIZED. */
typedef struct mdr_wear_options {
    size_t size;   /**< Size of this structure; MDR_SIZED sets it. */
    int intervals; /**< n, a multiple of 4, 16 to 640; default 0: 80. */
    int places;    /**< Of enum mdr_wear_places; default 0: MDR_WEAR_FRESH. */
    int scheme;    /**< Code of enum mdr_wear_scheme; default 0: MDR_WEAR_DISC. */
} mdr_wear_options;

/** Create a history of a contact that has not slid. A step takes about a millisecond.
 *  @param w        contact that wears, on a homogeneous or an exact medium
 *  @param given    MDR_DEPTH or MDR_FORCE
 *  @param value    initial d [length] or F [modulus length^2], > 0
 *  @param options  NULL: default options
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN if the pressure is negative (MDR_WEAR_DISC; rings open instead), MDR_EINVALID for other media
 *  @code
 *  mdr_wear_history *sliding = NULL;
 *  status = mdr_wear_history_new(wear, MDR_FORCE, 1e-3, NULL, &sliding);
 *  MDR_FREE(sliding);
 *  @endcode
 */
int mdr_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options, mdr_wear_history **out);

/** Copy a history. The copy is independent.
 *  @param h    history
 *  @param out  receives the handle
 *  @code
 *  mdr_wear_history *copy = NULL;
 *  status = mdr_wear_history_copy(wear_history, &copy);
 *  MDR_FREE(copy);
 *  @endcode
 */
int mdr_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out);

/** Continue a history. In each part of the path depth or force changes linearly to its final value. Under constant force the steps
 *  grow with the distance. After a failure the history is unchanged, and can continue with other values: mdr_last_failure() returns
 *  the number of the part that is not possible.
 *  @param h        history
 *  @param given    MDR_DEPTH (from the original apex) or MDR_FORCE
 *  @param n        number of parts
 *  @param sliding  [n] sliding distances, >= 0 [length]
 *  @param value    [n] d [length] or F [modulus length^2] at their ends, > 0
 *  @param out      [n] states at their ends
 *  @return also MDR_EDOMAIN if the contact would shrink (MDR_WEAR_DISC), as under a decreasing load, detach, grow beyond the end of
 *          the indenter, or carry no pressure somewhere, and if a coating of the body would lose more than a quarter of its
 *          thickness
 *  @code
 *  const double sliding = 1e-3, force = 1e-3;
 *  mdr_wear_state reached;
 *  status = mdr_wear_history_advance(wear_history, MDR_FORCE, 1, &sliding, &force, &reached);
 *  @endcode
 */
int mdr_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[],
                             mdr_wear_state out[]);

/** Return the state of a history and its pressure.
 *  @param h         history
 *  @param n         number of positions
 *  @param r         [n] r >= 0 [length]
 *  @param out       or NULL: receives the state
 *  @param pressure  [n] p(r), with the resolution of the intervals, 0 outside the contact [modulus]
 *  @code
 *  const double r[2] = {0.0, 0.3e-6};
 *  double p[2];
 *  mdr_wear_state now;
 *  status = mdr_wear_history_state(wear_history, 2, r, &now, p);
 *  @endcode
 */
int mdr_wear_history_state(const mdr_wear_history *h, int n, const double r[], mdr_wear_state *out, double pressure[]);

/** Create the present indenter; its depth counts from its new apex. If both sides wear, it is the present gap.
 *  @param h    history
 *  @param out  receives the handle of an indenter
 *  @code
 *  mdr_profile *worn = NULL;
 *  status = mdr_wear_history_profile(wear_history, &worn);
 *  MDR_FREE(worn);
 *  @endcode
 */
int mdr_wear_history_profile(const mdr_wear_history *h, mdr_profile **out);

/** Save a history as numbers, from which a history of the same contact continues with bitwise identical results.
 *  @param h         history
 *  @param capacity  size of `numbers`
 *  @param numbers   [capacity] receives the first numbers; may be NULL if capacity is 0
 *  @param count     receives the number of numbers; may be NULL
 *  @code
 *  double numbers[4000];
 *  int count;
 *  status = mdr_wear_history_save(wear_history, 4000, numbers, &count);
 *  @endcode
 */
int mdr_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count);

/** Restore a history from saved numbers.
 *  @param h        history of the same contact, with the same number of intervals
 *  @param n        number of saved numbers
 *  @param numbers  [n] from mdr_wear_history_save()
 *  @return also MDR_EINVALID for numbers of another history
 *  @code
 *  double numbers[4000];
 *  int count;
 *  mdr_wear_history_save(wear_history, 4000, numbers, &count);
 *  status = mdr_wear_history_restore(wear_history, count, numbers);
 *  @endcode
 */
int mdr_wear_history_restore(mdr_wear_history *h, int n, const double numbers[]);

#ifdef __cplusplus
}
#endif

#endif
