/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file plastic.h
 * Bodies that yield: imprints, laws, pressure caps. Option MDRCONTACT_PLASTIC.
 * @since 0.1
 */
#ifndef MDRCONTACT_PLASTIC_H
#define MDRCONTACT_PLASTIC_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Imprints ---- */

/** The imprint of a plastic contact: a body, and the profile that unloading and reloading are elastic contacts of. Immutable.
 *  Created by mdr_imprint_new(), mdr_imprint_two_terms() or mdr_imprint_from_pressure(). */
typedef struct mdr_imprint mdr_imprint;

/** Create an imprint from radius, force and depths of an indentation. The pressure at the largest load is assumed to have two terms,
 *  p(r) = uniform + hertz sqrt(1 - r^2/A^2), which force and recovery determine (theory/plastic.md (2.2)).
 *
 *  While nothing yields, unloading and reloading are exactly those of an elastic contact of mdr_imprint_profile() on the same body.
 *  mdr_imprint_reverse_yield() tells whether something does.
 *  @param medium          a homogeneous or an exact medium
 *  @param radius          A > 0, contact radius at the largest load [length]
 *  @param force           F > 0 at the largest load [modulus length^2]
 *  @param residual_depth  depth at which unloading ends the contact, 0 <= residual_depth < depth [length]
 *  @param depth           depth at the largest load, from initial contact [length]
 *  @param out             receives the handle
 *  @return also MDR_EINVALID if the pressure would fall towards the edge by more than Hertz's, or rise so much that the line load
 *          does; MDR_EDOMAIN if the contact would end in a ring, as on very stiff layers
 *  @code
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_new(medium, 1e-6, 0.018, 60e-9, 95e-9, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_new(const mdr_medium *medium, double radius, double force, double residual_depth, double depth, mdr_imprint **out);

/** Create the imprint of the pressure p(r) = uniform + hertz sqrt(1 - r^2/A^2), r < A, at the largest load.
 *  @param medium   a homogeneous or an exact medium
 *  @param radius   A > 0, contact radius at the largest load [length]
 *  @param uniform  uniform part of the pressure >= 0 [modulus]
 *  @param hertz    Hertz's part of the pressure, greater than -(2/pi) uniform [modulus]
 *  @param depth    depth at the largest load [length]; 0: depths count from there
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN if the contact would end in a ring
 *  @code
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_two_terms(medium, 1e-6, 5e9, 2e9, 0.0, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out);

/** Create the imprint of a pressure known at points, such as that of finite elements. It is represented by a polynomial of degree 1
 *  to 8 in sqrt(1 - r^2/A^2), by least squares; mdr_imprint_about() returns its misfit.
 *  @param medium  a homogeneous or an exact medium
 *  @param n       number of points, at least 4
 *  @param r       [n] radii >= 0, ascending; the last one is A, the edge of the contact [length]
 *  @param p       [n] pressure >= 0 at the largest load [modulus]
 *  @param depth   depth at the largest load [length]; 0: depths count from there
 *  @param out     receives the handle
 *  @return also MDR_EINVALID if the polynomial misses the largest pressure by more than 5 %, MDR_EDOMAIN if the contact would end in
 *          a ring
 *  @code
 *  const double r[5] = {0.0, 0.25e-6, 0.5e-6, 0.75e-6, 1e-6};
 *  const double p[5] = {7e9, 6.94e9, 6.73e9, 6.32e9, 5e9};
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_from_pressure(medium, 5, r, p, 0.0, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_from_pressure(const mdr_medium *medium, int n, const double r[], const double p[], double depth, mdr_imprint **out);

/** Create the indenter whose elastic contact with the body of an imprint is its unloading and reloading. It ends at A, the radius of
 *  the largest load. Its depths count from the end of contact: they are those of the imprint less its residual depth. With adhesion
 *  the edge rests at A until the work of adhesion detaches it (theory/plastic.md (3.2)).
 *  @param i    imprint
 *  @param out  receives the handle
 *  @code
 *  mdr_profile *effective = NULL;
 *  status = mdr_imprint_profile(imprint, &effective);
 *  MDR_FREE(effective);
 *  @endcode
 */
int mdr_imprint_profile(const mdr_imprint *i, mdr_profile **out);

/** Properties of an imprint. */
typedef struct mdr_imprint_facts {
    size_t size;           /**< Size of this structure; MDR_SIZED sets it. */
    double radius;         /**< A, contact radius at the largest load [length]. */
    double force;          /**< F at the largest load [modulus length^2]. */
    double depth;          /**< Depth at the largest load [length]. */
    double residual_depth; /**< Depth at which unloading ends the contact [length]. */
    double recovered_work; /**< Work that unloading from the largest load gives back [modulus length^3]. */
    double uniform;        /**< Uniform part of the pressure [modulus]; 0 unless the pressure has two terms. */
    double hertz;          /**< Hertz's part of the pressure [modulus]; 0 unless the pressure has two terms. */
    double misfit;         /**< mdr_imprint_new(): part of F/A by which force and depths need a uniform part below 0, taken as 0, at
                                most 0.005; mdr_imprint_from_pressure(): largest difference at the points relative to the largest
                                pressure [1]. */
} mdr_imprint_facts;

/** Return the properties of an imprint.
 *  @param i      imprint
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);
 *  status = mdr_imprint_about(imprint, &facts);
 *  @endcode
 */
int mdr_imprint_about(const mdr_imprint *i, mdr_imprint_facts *facts);

/** Compute R_Y, the largest ratio over the layers of the von Mises stress under the pressure at the largest load and of the yield
 *  stress. It tells whether unloading is elastic (theory/plastic.md (1.6)): below 1.7 it is; from 1.7 to 2 the force is accurate to
 *  1e-3 of the largest one; from 2 to 3 its error is 0.1 % to 2.5 %; above 3 the imprint does not hold.
 *  @param i             imprint
 *  @param n             number of layers with the half-space
 *  @param yield_stress  [n] of each layer top to bottom, > 0, infinite for one that does not yield [modulus]
 *  @param ratio         receives R_Y [1]
 *  @param layer         receives the layer where it is, 0 the first
 *  @return also MDR_EDOMAIN for R_Y > 3, MDR_EINVALID for graded bodies
 *  @code
 *  const double yield_stress[2] = {3e9, 7e9};
 *  double ratio;
 *  int layer;
 *  status = mdr_imprint_reverse_yield(imprint, 2, yield_stress, &ratio, &layer);
 *  @endcode
 */
int mdr_imprint_reverse_yield(const mdr_imprint *i, int n, const double yield_stress[], double *ratio, int *layer);

/* ---- Laws of contacts that yield ---- */

/* ---- Pressure caps ---- */

#ifdef __cplusplus
}
#endif

#endif
