/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file weights.h
 * Gao's weights of a depth z, xi = z/a, equations (12)-(15), (18).
 * @since 0.1
 */
#ifndef MDRCONTACT_WEIGHTS_H
#define MDRCONTACT_WEIGHTS_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Which weight of a depth. */
enum mdr_weight_kind {
    MDR_WEIGHT_PHI = 1001,           /**< Phi(xi) = dI0/dxi, the weight of the depth a xi itself; equation (18) at nu = 1/2. */
    MDR_WEIGHT_I0 = 1002,            /**< I0(xi), the weight of the shear modulus above the depth a xi, equations (12)-(15). */
    MDR_WEIGHT_I1 = 1003,            /**< I1(xi), the weight of Poisson's ratio above it; nu is checked but does not enter. */
    MDR_WEIGHT_J0 = 1004,            /**< 1 - I0, the weight of what lies below, to full relative precision. */
    MDR_WEIGHT_J1 = 1005,            /**< 1 - I1, to full relative precision. */
    MDR_WEIGHT_I0_TANGENTIAL = 1006, /**< I0 of a load along the surface, the weight of the shear modulus in the tangential
                                          stiffness, I1 + [xi L - xi/(1 + xi^2)]/(2 pi (2 - nu)) with L = ln(1 + 1/xi^2). Poisson's
                                          ratio keeps the weight I1. */
    MDR_WEIGHT_J0_TANGENTIAL = 1007  /**< 1 less that, to full relative precision. */
};

/** A weight at many depths.
 *  @param weight  one of enum mdr_weight_kind
 *  @param nu      Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param n       number of depths
 *  @param xi      [n] z/a >= 0 [1]
 *  @param out     [n] weights [1] */
int mdr_weight(int weight, double nu, int n, const double xi[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
