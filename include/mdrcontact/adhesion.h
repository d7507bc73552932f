/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file adhesion.h
 * Rate-dependent adhesion, and adhesion of viscoelastic bodies. Option MDRCONTACT_ADHESION.
 * @since 0.1
 */
#ifndef MDRCONTACT_ADHESION_H
#define MDRCONTACT_ADHESION_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact whose work of adhesion depends on the speed of its edge. Created by mdr_rate_new(). Immutable. */
typedef struct mdr_rate mdr_rate;

/** A work of adhesion that depends on the speed v of the contact edge. Opening, v > 0: G = work (1 + (v/speed)^exponent). Closing:
 *  G = closing_work/(1 + (|v|/closing_speed)^closing_exponent). The edge is at rest while closing_work < G < work (Gent and Schultz
 *  1972, Maugis and Barquins 1978). Initialize with MDR_SIZED. */
typedef struct mdr_rate_options {
    size_t size;                  /**< Size of this structure; MDR_SIZED sets it. */
    double work;                  /**< G of an opening edge at v = 0, > 0 [modulus length]. */
    double speed;                 /**< Speed at which G of an opening edge is twice `work`, > 0 [length/time]. */
    double exponent;              /**< 0 < n <= 2 [1]. */
    double closing_work;          /**< G of a closing edge at v = 0, > 0, at most `work`; default 0: `work` [modulus length]. */
    double closing_speed;         /**< Speed at which G of a closing edge is half of closing_work, > 0; default 0: `speed`
                                       [length/time]. */
    double closing_exponent;      /**< 0 < n <= 2; default 0: `exponent` [1]. */
    const mdr_material *material; /**< Or NULL. Replaces all members above except `work`: the surface layer, which must have a
                                       glassy and a relaxed modulus. G(v) is then that of a steady crack in this material with a
                                       rate-independent cohesive stress: `work` times 1 to E_glassy/E_relaxed, the inverse for
                                       closing. It applies to a contact with the relaxed moduli that is large compared with the
                                       cohesive zone and slow compared with the material (Greenwood, Johnson 1981). */
    double cohesive_stress;       /**< Cohesive stress of that crack, > 0; 0 without a material [modulus]. */
    double largest_radius;        /**< Largest contact radius, > 0 [length]. */
    double smallest_radius;       /**< Radius at which a contact begins and ends. Default 0: 1e-3 of the largest radius, or of the
                                       radius at which adhesion and elasticity are equally important, whichever is less [length]. */
} mdr_rate_options;

/** Create a contact whose edge moves at a finite speed. The elastic contact is sampled over its radius, once for all histories.
 *  @param c        contact, with an indenter without a flat end. Its adhesion rule is used, its work of adhesion is not
 *  @param options  the work of adhesion
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN beyond the end of indenter or medium, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_rate_options options = MDR_SIZED(mdr_rate_options);
 *  mdr_rate *slow = NULL;
 *  options.work = 0.05;
 *  options.speed = 1e-7;
 *  options.exponent = 0.6;
 *  options.largest_radius = 10e-6;
 *  status = mdr_rate_new(sticky, &options, &slow);
 *  MDR_FREE(slow);
 *  @endcode
 */
int mdr_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out);

/** Compute the work of adhesion at speeds of the edge, and for a material the time and length that limit its validity: for an error
 *  of pull-off below 2 %, v time/a must be at most 0.02 and zone/a at most 0.03.
 *  @param options  the work of adhesion; the radii are ignored
 *  @param n        number of speeds
 *  @param v        [n] > 0 for opening [length/time]
 *  @param out      [n] G; `work` at v = 0 [modulus length]
 *  @param time     or NULL: receives the longest retardation time; 0 without a material [time]
 *  @param zone     or NULL: receives the length of the cohesive zone of a crack at rest, pi E* work/(4 cohesive_stress^2); 0
 *                  without a material [length]
 *  @code
 *  const double v[2] = {1e-8, 1e-6};
 *  double G[2];
 *  status = mdr_rate_work(&rate_options, 2, v, G, NULL, NULL);
 *  @endcode
 */
int mdr_rate_work(const mdr_rate_options *options, int n, const double v[], double out[], double *time, double *zone);

/** The state of a history, a record that the calling program keeps and from which a history of the same contact can continue. It
 *  must not be changed. All 0: separated bodies. */
typedef struct mdr_rate_state {
    double radius;        /**< a, 0 for separated bodies [length]. At the start: less than 0 selects equilibrium, G = work, with the
                               first value, in the stable state of largest radius. */
    double depth;         /**< d [length]. */
    double dissipated;    /**< Energy dissipated at the edge, int 2 pi a (G - work) v dt [modulus length^3]. */
    double work;          /**< int F dd [modulus length^3]. */
    double lowest_force;  /**< Lowest force so far, at most 0; pull-off [modulus length^2]. */
    double lowest_time;   /**< Time of the lowest force [time]. */
    double lowest_depth;  /**< Depth at the lowest force [length]. */
    double lowest_radius; /**< Contact radius at the lowest force [length]. */
    double lowest_speed;  /**< Edge speed v at the lowest force [length/time]. */
    double rupture_time;  /**< Time of the last rupture; 0 if there was none [time]. */
    double rupture_depth; /**< d immediately before the last rupture [length]. */
    double ruptures;      /**< Number of ruptures. */
    double force;         /**< F [modulus length^2]. */
    double mark;          /**< Checksum of the other members and of the work of adhesion. 0 at a start that is not the end of a
                               history: the other members except `radius` must then be 0. */
} mdr_rate_state;

/** Compute a history: approach, dwell, retraction, pull-off. The controlled quantity is linear in time between its values.
 *
 *  da/dt = -v(G(a, t)) is integrated by an L-stable method of order 4 with step-size control. Separated bodies touch at depth 0. If
 *  the contact is pressed in faster than its edge can close, it grows instantly to the radius without tension. Under force control
 *  separated bodies stay separated, and their depth is that of the rupture. Outputs that are NULL are skipped.
 *  @param r                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: the quantity in `in`
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], otherwise ignored
 *  @param tolerance         tolerance of ln a in each step, 1e-12 to 1e-3; 0: 1e-9
 *  @param start             state at the first time
 *  @param n                 number of times
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions; separated bodies reach the first value in a step
 *  @param d                 [n] or NULL: indentation depths, for separated bodies those of the bodies [length]
 *  @param a                 [n] or NULL: contact radii, 0 for separated bodies [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param v                 [n] or NULL: speeds of the edge, > 0 for opening [length/time]
 *  @param dissipated        [n] or NULL: energy dissipated at the edge so far [modulus length^3]
 *  @param work              [n] or NULL: int F dd so far [modulus length^3]
 *  @param end               receives the state at the last time
 *  @return also MDR_EDOMAIN if the contact grows beyond largest_radius, MDR_EUNREACHABLE if there is no initial equilibrium,
 *          MDR_ENOCONVERGENCE, MDR_EINVALID for a start that a history of another contact left, or that was changed
 *  @code
 *  const mdr_rate_state start = {0};
 *  const double t[3] = {0.0, 1.0, 2.0}, d[3] = {0.0, 1e-6, -1e-6};
 *  double F[3];
 *  mdr_rate_state end;
 *  status = mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &start, 3, t, d, NULL, NULL, F, NULL, NULL, NULL, &end);
 *  @endcode
 */
int mdr_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n,
                     const double time[], const double in[], double d[], double a[], double F[], double v[], double dissipated[],
                     double work[], mdr_rate_state *end);

/** Compute a history of a viscoelastic half-space with finite-range adhesion: approach, jump-in, dwell, retraction, pull-off. The
 *  contact has a body of mdr_body_layered() without layers, a work_of_adhesion and a cohesive_stress. All dissipation occurs in the
 *  solid.
 *
 *  Each spring of the body has its own memory of the load (Haiat, Phan Huy, Barthel, J. Mech. Phys. Solids 51 (2003) 69), and the
 *  edges of contact and zone are unknowns. The method is of second order with extrapolation; steps are halved until the force
 *  converges. Not supported: layers, because no second solution exists for comparison; materials without a glassy or a relaxed
 *  modulus; flat ends and walls; zones shorter than 1e-3 of the contact radius, for which mdr_rate_new() applies. Outputs that are
 *  NULL are skipped.
 *  @param c                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: the quantity in `in`. Under force control separated bodies stay
 *                           separated
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], otherwise ignored
 *  @param tolerance         tolerance of the force, relative to its largest value, 1e-7 to 1e-2; 0: 1e-4
 *  @param start             all 0: separated bodies; radius < 0: equilibrium with the first value, in the stable state of largest
 *                           radius; other members are ignored
 *  @param n                 number of times
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions, linear in time between the times; separated bodies reach the first
 *                           value in a step
 *  @param d                 [n] or NULL: indentation depths, for separated bodies those of the bodies [length]
 *  @param a                 [n] or NULL: contact radii, 0 without contact [length]
 *  @param zone_radius       [n] or NULL: outer radii of the cohesive zone, 0 if the bodies do not attract each other [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param end               receives the lowest force with its time, the last rupture and int F dd; dissipated is 0, because the
 *                           energy still stored in the body is unknown
 *  @return also MDR_EINVALID for other contacts and if the contact would not be a single contact area, MDR_EUNREACHABLE if there is
 *          no initial stable state, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const mdr_rate_state start = {0};
 *  const double t[3] = {0.0, 1.0, 2.0}, d[3] = {-0.5e-6, 0.5e-6, -0.5e-6};
 *  double F[3];
 *  mdr_rate_state end;
 *  status = mdr_contact_adhesive_history(cohesive, MDR_DEPTH, 0.0, 1e-3, &start, 3, t, d, NULL, NULL, NULL, F, &end);
 *  @endcode
 */
int mdr_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance,
                                 const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[],
                                 double zone_radius[], double F[], mdr_rate_state *end);

#ifdef __cplusplus
}
#endif

#endif
