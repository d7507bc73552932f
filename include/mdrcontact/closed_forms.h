/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file closed_forms.h
 * Closed forms: paraboloid and cone on an incompressible coating (nu = 1/2), (24), (27), (29), (31), (32).
 * @since 0.1
 */
#ifndef MDRCONTACT_CLOSED_FORMS_H
#define MDRCONTACT_CLOSED_FORMS_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Closed forms of the source, and their constants in order: shear moduli G0 of the coating and G1 of the substrate > 0 [modulus],
 *  thickness h > 0 [length], work of adhesion gamma [modulus length]. xi = h/a. */
enum mdr_formula {
    MDR_FORM_PARABOLOID_FORCE = 1101, /**< R > 0, G0, G1, h: F(a) of a paraboloid without adhesion, equation (24): (16 a^3/(3R)) [G1
                                           + (G0 - G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)]. */
    MDR_FORM_CONE_FORCE = 1102,       /**< phi, 0 < phi < pi/2 [radian], G0, G1, h: F(a) of a cone without adhesion, equation (27):
                                           2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)]. */
    MDR_FORM_ADHESIVE_DEPTH = 1103,   /**< R > 0, G0, G1, h, gamma >= 0: d(a) of an adhesive paraboloid by the source's rule,
                                           equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)). */
    MDR_FORM_REDUCED_DEPTH = 1104,    /**< tau = G0/G1 > 0 [1], ht = h/a_c > 0 [1]: d/d_c at at = a/a_c, equation (32): at^2/3 -
                                           (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2). */
    MDR_FORM_RADIUS_SCALE = 1105,     /**< G1, gamma > 0: a_c = (pi gamma R^2/(32 G1))^(1/3) of R, the contact radius at which an
                                           uncoated contact breaks under depth control, equation (31). */
    MDR_FORM_DEPTH_SCALE = 1106       /**< G1, gamma > 0: d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3) of R, minus the depth there. */
};

/** A closed form at many radii.
 *  @param formula    one of enum mdr_formula
 *  @param n          number of radii
 *  @param x          [n] > 0: contact radii a [length], at [1], or R [length]
 *  @param constants  those of the formula
 *  @param out        [n] forces [modulus length^2], depths [length], d/d_c [1], a_c or d_c [length] */
int mdr_closed_form(int formula, int n, const double x[], const double constants[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
