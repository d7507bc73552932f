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

/** Phi(xi) = dI0/dxi, the weight of the depth a xi itself; equation (18) at nu = 1/2.
 *  @param n    number of depths
 *  @param xi   [n] z/a >= 0 [1]
 *  @param nu   Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param out  [n] weights [1] */
int mdr_weight_phi(int n, const double xi[], double nu, double out[]);

/** I0(xi), the weight of the shear modulus above the depth a xi, equations (12)-(15). Arguments as mdr_weight_phi(). */
int mdr_weight_i0(int n, const double xi[], double nu, double out[]);

/** I1(xi), the weight of Poisson's ratio above the depth a xi, equations (12)-(15). Arguments as mdr_weight_phi(); nu is
 *  checked but does not enter. */
int mdr_weight_i1(int n, const double xi[], double nu, double out[]);

/** J0 = 1 - I0, the weight of what lies below, to full relative precision. Arguments as mdr_weight_phi(). */
int mdr_weight_j0(int n, const double xi[], double nu, double out[]);

/** J1 = 1 - I1, to full relative precision. Arguments as mdr_weight_i1(). */
int mdr_weight_j1(int n, const double xi[], double nu, double out[]);

/** I0(xi) of a load along the surface, the weight of the shear modulus in the tangential stiffness, I1 + [xi L - xi/(1 + xi^2)]/
 *  (2 pi (2 - nu)) with L = ln(1 + 1/xi^2). Poisson's ratio keeps the weight I1. Arguments as mdr_weight_phi(). */
int mdr_weight_i0_tangential(int n, const double xi[], double nu, double out[]);

/** 1 less mdr_weight_i0_tangential(), to full relative precision. Arguments as mdr_weight_phi(). */
int mdr_weight_j0_tangential(int n, const double xi[], double nu, double out[]);

#ifdef __cplusplus
}
#endif

#endif
