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
 *  Created by mdr_imprint_two_terms(). */
typedef struct mdr_imprint mdr_imprint;

/** Create the imprint of the pressure p(r) = uniform + hertz sqrt(1 - r^2/A^2), r < A, at the largest load.
 *  @param medium   a homogeneous or an exact medium
 *  @param radius   A > 0, contact radius at the largest load [length]
 *  @param uniform  uniform part of the pressure >= 0 [modulus]
 *  @param hertz    Hertz's part of the pressure [modulus]
 *  @param depth    depth at the largest load [length]
 *  @param out      receives the handle
 *  @code
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_two_terms(medium, 1e-6, 5e9, 2e9, 0.0, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out);

/* ---- Laws of contacts that yield ---- */

/* ---- Pressure caps ---- */

#ifdef __cplusplus
}
#endif

#endif
