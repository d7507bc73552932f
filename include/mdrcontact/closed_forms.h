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

/** F(a) of a paraboloid without adhesion, equation (24), xi = h/a:
 *  (16 a^3/(3R)) [G1 + (G0 - G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)].
 *  @param n                number of radii
 *  @param a                [n] contact radii > 0 [length]
 *  @param radius           R > 0 [length]
 *  @param coating_shear    shear modulus G0 > 0 [modulus]
 *  @param substrate_shear  shear modulus G1 > 0 [modulus]
 *  @param thickness        h > 0 [length]
 *  @param out              [n] forces [modulus length^2] */
int mdr_coated_paraboloid_force(int n, const double a[], double radius, double coating_shear, double substrate_shear,
                                double thickness, double out[]);

/** F(a) of a cone without adhesion, equation (27): 2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)].
 *  @param inclination  phi, 0 < phi < pi/2 [radian]; otherwise as mdr_coated_paraboloid_force() */
int mdr_coated_cone_force(int n, const double a[], double inclination, double coating_shear, double substrate_shear,
                          double thickness, double out[]);

/** d(a) of an adhesive paraboloid by the source's rule, equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)).
 *  @param work_of_adhesion  gamma >= 0 [modulus length]
 *  @param out               [n] indentation depths [length]; otherwise as mdr_coated_paraboloid_force() */
int mdr_coated_paraboloid_adhesive_depth(int n, const double a[], double radius, double coating_shear, double substrate_shear,
                                         double thickness, double work_of_adhesion, double out[]);

/** a_c = (pi gamma R^2/(32 G1))^(1/3), the contact radius at which an uncoated contact breaks under depth control, equation (31).
 *  @param radius            R > 0 [length]
 *  @param substrate_shear   G1 > 0 [modulus]
 *  @param work_of_adhesion  gamma > 0 [modulus length]
 *  @param out               receives a_c [length] */
int mdr_adhesive_radius_scale(double radius, double substrate_shear, double work_of_adhesion, double *out);

/** d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3), minus the depth there, equation (31). Arguments as mdr_adhesive_radius_scale(). */
int mdr_adhesive_depth_scale(double radius, double substrate_shear, double work_of_adhesion, double *out);

/** d/d_c at a/a_c, equation (32): at^2/3 - (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2).
 *  @param n                  number of radii
 *  @param reduced_radius     [n] at = a/a_c > 0 [1]
 *  @param shear_ratio        tau = G0/G1 > 0 [1]
 *  @param reduced_thickness  ht = h/a_c > 0 [1]
 *  @param out                [n] d/d_c [1] */
int mdr_reduced_adhesive_depth(int n, const double reduced_radius[], double shear_ratio, double reduced_thickness, double out[]);

#ifdef __cplusplus
}
#endif

#endif
