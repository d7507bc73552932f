/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file weights.h
 * Gao's weights at a depth z, xi = z/a, equations (12)-(15), (18).
 * @since 0.1
 */
#ifndef MDRCONTACT_WEIGHTS_H
#define MDRCONTACT_WEIGHTS_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Gao's weights. */
enum mdr_weight_kind {
    MDR_WEIGHT_PHI = 1001,           /**< Phi(xi) = dI0/dxi, weight of the depth a xi; equation (18) at nu = 1/2. */
    MDR_WEIGHT_I0 = 1002,            /**< I0(xi), weight of the shear modulus above the depth a xi, equations (12)-(15). */
    MDR_WEIGHT_I1 = 1003,            /**< I1(xi), weight of Poisson's ratio above the depth a xi; it does not depend on nu, which
                                          must still be valid. */
    MDR_WEIGHT_J0 = 1004,            /**< 1 - I0, weight of the material below, with full relative accuracy. */
    MDR_WEIGHT_J1 = 1005,            /**< 1 - I1, with full relative accuracy. */
    MDR_WEIGHT_I0_TANGENTIAL = 1006, /**< I0 of a tangential load, weight of the shear modulus in the tangential stiffness, I1 + [xi
                                          L - xi/(1 + xi^2)]/(2 pi (2 - nu)) with L = ln(1 + 1/xi^2). The weight of Poisson's ratio
                                          is again I1. */
    MDR_WEIGHT_J0_TANGENTIAL = 1007  /**< 1 - I0 of a tangential load, with full relative accuracy. */
};

/** Compute a weight at depths.
 *  @param weight  one of enum mdr_weight_kind
 *  @param nu      Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param n       number of depths
 *  @param xi      [n] z/a >= 0 [1]
 *  @param out     [n] weights [1]
 *  @code
 *  const double xi[2] = {0.1, 1.0};
 *  double I0[2];
 *  status = mdr_weight(MDR_WEIGHT_I0, 0.3, 2, xi, I0);
 *  @endcode
 */
int mdr_weight(int weight, double nu, int n, const double xi[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
