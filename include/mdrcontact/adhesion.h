/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file adhesion.h
 * Adhesion that depends on the speed of the edge, adhesion of viscoelastic bodies. Option MDRCONTACT_ADHESION.
 * @since 0.1
 */
#ifndef MDRCONTACT_ADHESION_H
#define MDRCONTACT_ADHESION_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact whose work of adhesion depends on the speed of its edge. Made by mdr_rate_new(). */
typedef struct mdr_rate mdr_rate;

/** A work of adhesion that depends on the speed v of the contact's edge. Opening, v > 0: G = work (1 + (v/speed)^exponent); closing:
 *  G = closing_work/(1 + (|v|/closing_speed)^closing_exponent); the edge stands still while closing_work < G < work (Gent and Schultz
 *  1972, Maugis and Barquins 1978). Begun by MDR_SIZED. */
typedef struct mdr_rate_options {
    size_t size;             /**< Of this structure; MDR_SIZED sets it. */
    double work;             /**< Of an edge that just opens, > 0 [modulus length]. */
    double speed;            /**< At which the work is twice that, > 0 [length/time]. */
    double exponent;         /**< 0 < n <= 2 [1]. */
    double closing_work;     /**< Of an edge that just closes, > 0, at most `work`; default 0: `work` [modulus length]. */
    double closing_speed;    /**< At which it is half that, > 0; default 0: `speed` [length/time]. */
    double closing_exponent; /**< 0 < n <= 2; default 0: `exponent` [1]. */
    const mdr_material *material; /**< Or NULL. In place of all of the above but `work`: the surface layer, with a glassy and a relaxed
                                       modulus. G(v) is then that of a steady crack in it whose cohesion does not depend on speed, from
                                       1 to E_glassy/E_relaxed (closing: its inverse) times `work`, for a contact with the relaxed moduli
                                       that is large against the cohesive zone and slow against the material (Greenwood, Johnson 1981). */
    double cohesive_stress;  /**< Of that crack, > 0; 0 without a material [modulus]. */
    double largest_radius;   /**< Up to which contacts are followed, > 0 [length]. */
    double smallest_radius;  /**< At which a contact begins and ends; default 0: 1e-3 of the largest, or of that at which adhesion
                                  hands over to elasticity, where this is less [length]. */
} mdr_rate_options;

/** The contact whose edge moves at a finite speed. Samples of an elastic contact over its radius, made once, for all histories.
 *  @param c        contact, of any indenter without a flat end; its own work of adhesion is not used, its rule for the opening is
 *  @param options  the work of adhesion
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN beyond the end of indenter or medium, MDR_ENOCONVERGENCE */
int mdr_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out);

/** The work of adhesion at speeds of the edge, and against what a contact must be slow and large where it follows from a material:
 *  v time/a is at most 0.02 and zone/a at most 0.03 where pull-off is to be good to 2 %.
 *  @param options  the work of adhesion; radii are not looked at
 *  @param n        number of speeds
 *  @param v        [n] > 0 where it opens [length/time]
 *  @param out      [n] G; `work` at v = 0 [modulus length]
 *  @param time     or NULL: the longest time of creep; 0 without a material [time]
 *  @param zone     or NULL: length of the cohesive zone of a crack at rest, pi E* work/(4 cohesive_stress^2); 0 without [length] */
int mdr_rate_work(const mdr_rate_options *options, int n, const double v[], double out[], double *time, double *zone);

/** The state of a history: a record that the calling program keeps, and from which the history goes on. All 0: the bodies are apart. */
typedef struct mdr_rate_state {
    double radius;        /**< a, 0 where the bodies are apart; less than 0 at the start: in equilibrium, G = work, with the first
                               value, the largest stable one [length]. */
    double depth;         /**< d [length]. */
    double dissipated;    /**< Energy lost at the edge, int 2 pi a (G - work) v dt [modulus length^3]. */
    double work;          /**< int F dd [modulus length^3]. */
    double lowest_force;  /**< The lowest force so far, at most 0; pull-off [modulus length^2]. */
    double lowest_time;   /**< When [time], */
    double lowest_depth;  /**< where [length], */
    double lowest_radius; /**< how large the contact was [length], */
    double lowest_speed;  /**< and v of its edge [length/time]. */
    double rupture_time;  /**< When the contact broke last; 0 if it never did [time]. */
    double rupture_depth; /**< d just before [length]. */
    double ruptures;      /**< How often it broke. */
} mdr_rate_state;

/** A path in time: approach, dwell, retraction, pull-off. What is controlled is linear in time between its values.
 *
 *  da/dt = -v(G(a, t)) by an L-stable method of order 4 with steps that keep to the tolerance. Bodies that are apart touch at depth 0.
 *  Where the contact is pressed in faster than its edge can close, it grows at once to the radius without tension. Under a force bodies
 *  that have come apart stay so, and their depth is that of the rupture. Outputs that are NULL are skipped.
 *  @param r                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: what `in` holds
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], not looked at otherwise
 *  @param tolerance         of ln a in each step, 1e-12 to 1e-3; 0: 1e-9
 *  @param start             at the first time
 *  @param n                 number of samples
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions; the first is reached in a jump where `start` is apart
 *  @param d                 [n] or NULL: indentation depths, those of the bodies where they are apart [length]
 *  @param a                 [n] or NULL: contact radii, 0 where they are apart [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param v                 [n] or NULL: speeds of the edge, > 0 where it opens [length/time]
 *  @param dissipated        [n] or NULL: energy lost at the edge so far [modulus length^3]
 *  @param work              [n] or NULL: int F dd so far [modulus length^3]
 *  @param end               receives what is remembered at the last time
 *  @return also MDR_EDOMAIN if the contact grows beyond largest_radius, MDR_EUNREACHABLE without an equilibrium to begin with,
 *          MDR_ENOCONVERGENCE */
int mdr_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n,
                     const double time[], const double in[], double d[], double a[], double F[], double v[], double dissipated[],
                     double work[], mdr_rate_state *end);

/** A path in time of a viscoelastic half-space whose surface the indenter attracts: a contact with a body of mdr_body_layered()
 *  without layers, with a work_of_adhesion and a cohesive_stress. Approach, jump-in, dwell, retraction, pull-off; all loss is in the solid.
 *
 *  Each spring of the body remembers its own load (Haiat, Phan Huy, Barthel, J. Mech. Phys. Solids 51 (2003) 69), and the edges of
 *  contact and zone follow. Steps are halved until the force does not change any more; second order, extrapolated. Layers are refused
 *  (no second solution to compare with), and materials without a glassy or a relaxed modulus, flat ends, walls, and zones shorter than
 *  1e-3 of the contact radius: there mdr_rate_new() holds. Outputs that are NULL are skipped.
 *  @param c                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: what `in` holds. Under a force bodies that have come apart stay so
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], not looked at otherwise
 *  @param tolerance         of the force, relative to its largest, 1e-7 to 1e-2; 0: 1e-4
 *  @param start             all 0: the bodies are apart; radius < 0: the contact is in equilibrium with the first value, in the largest
 *                           stable state; nothing else is looked at
 *  @param n                 number of samples
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions, linear in time in between; the first is reached in a jump where the
 *                           bodies are apart
 *  @param d                 [n] or NULL: indentation depths, those of the bodies where they are apart [length]
 *  @param a                 [n] or NULL: contact radii, 0 without contact [length]
 *  @param zone_radius       [n] or NULL: outer radii of the cohesive zone, 0 where the bodies do not attract each other [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param end               receives the lowest force with its time, the last rupture and int F dd; dissipated is 0: it is not known
 *                           what the body still stores
 *  @return also MDR_EINVALID for other contacts and where the contact would not be one disc, MDR_EUNREACHABLE without a stable state
 *          to begin with, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance,
                                 const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[],
                                 double zone_radius[], double F[], mdr_rate_state *end);

#ifdef __cplusplus
}
#endif

#endif
