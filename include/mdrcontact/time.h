/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file time.h
 * Contacts with viscoelastic bodies in time: histories, dynamic stiffness, step responses. Option MDRCONTACT_TIME.
 * @since 0.1
 */
#ifndef MDRCONTACT_TIME_H
#define MDRCONTACT_TIME_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Compute the history of a contact with a viscoelastic body: depth, radius and force in time, one of which is prescribed.
 *
 *  Before the first time the bodies are separated and at rest. The first prescribed value is applied as a step. Between the times
 *  the prescribed quantity is linear. Two methods are used:
 *  - Homogeneous bodies, and layered bodies whose materials all relax proportionally at constant Poisson's ratios (a rigid base is
 *    possible), are computed from the elastic curve to machine precision: by Lee and Radok (1960) while the contact grows, by Ting
 *    (1966) after the maximum.
 *  - Any other body or path, for example a contact that shrinks and grows again, is integrated in time with the memory of all
 *    layers. This needs MDR_MODEL_EXACT and a surface material without a parallel dashpot. Power laws are then represented by sums
 *    of exponentials.
 *  @param c          contact
 *  @param given      MDR_DEPTH, MDR_FORCE or MDR_RADIUS: the quantity in `in`
 *  @param tolerance  tolerance of the time integration, relative to the largest depth, radius and force; 1e-9 to 1e-2, typically
 *                    1e-5
 *  @param n          number of times
 *  @param time       [n] strictly ascending [time]
 *  @param in         [n] depths, < 0 for separated bodies [length], forces >= 0 [modulus length^2] or radii >= 0 [length]
 *  @param d          [n] or NULL: depths [length]
 *  @param a          [n] or NULL: contact radii, 0 for separated bodies [length]
 *  @param F          [n] or NULL: forces [modulus length^2]
 *  @return MDR_EINVALID also for elastic bodies, for cases that the time integration does not support, and if a contact that grows
 *          again would not be a single contact area; MDR_EUNREACHABLE, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double t[3] = {0.0, 1.0, 2.0}, d[3] = {0.0, 200e-9, 200e-9};
 *  double a[3], F[3];
 *  status = mdr_contact_history(relaxing, MDR_DEPTH, 1e-5, 3, t, d, NULL, a, F);
 *  @endcode
 */
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[],
                        double d[], double a[], double F[]);

/** Compute the dynamic stiffness k* = k' + i k'' for small oscillations about a contact radius on a viscoelastic body. The energy
 *  dissipated per cycle is pi k'' times the amplitude squared. With MDR_MODEL_EXACT it is exact for all materials, power laws
 *  included; with other models for proportional relaxation of all materials.
 *  @param c        contact; the shape of the indenter has no influence
 *  @param n        number of frequencies
 *  @param omega    [n] angular frequencies > 0; consecutive equal values save time [1/time]
 *  @param radius   [n] contact radii > 0 [length]
 *  @param storage  [n] k' [modulus length]
 *  @param loss     [n] k'' [modulus length]
 *  @return MDR_EINVALID also for elastic bodies; MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double omega = 10.0, a = 1e-6;
 *  double storage, loss;
 *  status = mdr_contact_dynamic_stiffness(relaxing, 1, &omega, &a, &storage, &loss);
 *  @endcode
 */
int mdr_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[], double storage[],
                                  double loss[]);

/** Compute the response of a viscoelastic body to a step at time 0 at a fixed contact radius. The bodies are those of
 *  mdr_contact_dynamic_stiffness().
 *  @param c       contact; the shape of the indenter has no influence
 *  @param step    MDR_RELAXATION or MDR_CREEP
 *  @param radius  contact radius > 0 [length]
 *  @param n       number of times
 *  @param time    [n] > 0 [time]
 *  @param out     [n] see enum mdr_quantity
 *  @return as mdr_contact_dynamic_stiffness()
 *  @code
 *  const double t[2] = {0.1, 10.0};
 *  double force_per_depth[2];
 *  status = mdr_contact_step_response(relaxing, MDR_RELAXATION, 1e-6, 2, t, force_per_depth);
 *  @endcode
 */
int mdr_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
