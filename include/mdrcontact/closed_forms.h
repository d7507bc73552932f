/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file closed_forms.h
 * Closed forms for a paraboloid and a cone on an incompressible coating (nu = 1/2), equations (24), (27), (29), (31), (32).
 * @since 0.1
 */
#ifndef MDRCONTACT_CLOSED_FORMS_H
#define MDRCONTACT_CLOSED_FORMS_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Closed forms of Popov (2014), and their constants in order. Shear moduli G0 of the coating and G1 of the substrate > 0
 *  [modulus], thickness h > 0 [length], work of adhesion gamma [modulus length]; xi = h/a. */
enum mdr_formula {
    MDR_FORM_PARABOLOID_FORCE = 1101, /**< R > 0, G0, G1, h: F(a) of a paraboloid without adhesion, equation (24): (16 a^3/(3R)) [G1
                                           + (G0 - G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)]. */
    MDR_FORM_CONE_FORCE = 1102,       /**< phi, 0 < phi < pi/2 [radian], G0, G1, h: F(a) of a cone without adhesion, equation (27):
                                           2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)]. */
    MDR_FORM_ADHESIVE_DEPTH = 1103,   /**< R > 0, G0, G1, h, gamma >= 0: d(a) of an adhesive paraboloid with the edge condition
                                           (28), equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)). */
    MDR_FORM_REDUCED_DEPTH = 1104,    /**< tau = G0/G1 > 0 [1], ht = h/a_c > 0 [1]: d/d_c at at = a/a_c, equation (32): at^2/3 -
                                           (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2). */
    MDR_FORM_RADIUS_SCALE = 1105,     /**< G1, gamma > 0: a_c = (pi gamma R^2/(32 G1))^(1/3) as a function of R, the contact radius
                                           at pull-off of an uncoated contact under depth control, equation (31). */
    MDR_FORM_DEPTH_SCALE = 1106       /**< G1, gamma > 0: d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3) as a function of R, minus the
                                           depth at that pull-off. */
};

/** Compute a closed form.
 *  @param formula    one of enum mdr_formula
 *  @param n          number of radii
 *  @param x          [n] > 0: contact radii a [length], at = a/a_c [1], or R [length]
 *  @param constants  those of the formula
 *  @param out        [n] forces [modulus length^2], depths [length], d/d_c [1], a_c or d_c [length]
 *  @code
 *  const double a = 1e-6, constants[4] = {10e-6, 1e6, 0.5e6, 2e-6};  // R, G0, G1, h
 *  double F;
 *  status = mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 1, &a, constants, &F);
 *  @endcode
 */
int mdr_closed_form(int formula, int n, const double x[], const double constants[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
