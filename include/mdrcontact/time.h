/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file time.h
 * Contacts with viscoelastic bodies in time: histories, dynamic stiffness, answers to steps. Option MDRCONTACT_TIME.
 * @since 0.1
 */
#ifndef MDRCONTACT_TIME_H
#define MDRCONTACT_TIME_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The history of a contact with a viscoelastic body: depth, radius and force along a path in time, of which one is prescribed.
 *
 *  Before the first time the bodies are apart and at rest; what is prescribed then is reached in a jump, and is linear in time in
 *  between. Materials that all relax in proportion, each at a constant Poisson's ratio (layers on a rigid base), and homogeneous
 *  bodies follow from elastic curves to rounding: Lee and Radok (1960) while the contact grows, Ting (1966) after the maximum.
 *  Any other body or path, as a contact that shrinks and grows again, is marched through time with the memory of all layers, under
 *  the model exact and unless a dashpot is in parallel at the surface; power laws are sums of exponentials there.
 *  @param c          contact
 *  @param given      MDR_DEPTH, MDR_FORCE or MDR_RADIUS: what `in` holds
 *  @param tolerance  of marching, relative to the largest depth, radius and force; 1e-9 to 1e-2, 1e-5 is a good choice
 *  @param n          number of times
 *  @param time       [n] strictly ascending [time]
 *  @param in         [n] depths, < 0 where the bodies are apart [length], forces >= 0 [modulus length^2] or radii >= 0 [length]
 *  @param d          [n] or NULL: depths [length]
 *  @param a          [n] or NULL: contact radii, 0 where the bodies are apart [length]
 *  @param F          [n] or NULL: forces [modulus length^2]
 *  @return MDR_EINVALID also for elastic bodies, for what can be marched only and is not offered, and where a contact that grows
 *          again would not be one disc; MDR_EUNREACHABLE, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[],
                        double d[], double a[], double F[]);

/** The dynamic stiffness k* = k' + i k'' of a contact with a viscoelastic body that oscillates by little about a contact radius;
 *  the energy lost in a cycle is pi k'' times the amplitude squared. Exact for any materials, power laws included, under the model
 *  exact; under other models for materials that relax in proportion.
 *  @param c        contact; the indenter does not matter
 *  @param n        number of frequencies
 *  @param omega    [n] angular frequencies > 0; equal neighbours cost less [1/time]
 *  @param radius   [n] contact radii > 0 [length]
 *  @param storage  [n] k' [modulus length]
 *  @param loss     [n] k'' [modulus length]
 *  @return MDR_EINVALID also for elastic bodies; MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[], double storage[],
                                  double loss[]);

/** The answer of a viscoelastic body to a step at time 0, the contact radius being held. Bodies as for
 *  mdr_contact_dynamic_stiffness().
 *  @param c       contact; the indenter does not matter
 *  @param step    MDR_RELAXATION or MDR_CREEP: which step
 *  @param radius  contact radius > 0 [length]
 *  @param n       number of times
 *  @param time    [n] > 0 [time]
 *  @param out     [n] see enum mdr_quantity
 *  @return as mdr_contact_dynamic_stiffness() */
int mdr_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
