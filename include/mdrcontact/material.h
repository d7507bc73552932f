/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file material.h
 * Viscoelastic materials.
 * @since 0.1
 */
#ifndef MDRCONTACT_MATERIAL_H
#define MDRCONTACT_MATERIAL_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A viscoelastic material, for layers of mdr_body_layered(). Created by mdr_material_.... Immutable. */
typedef struct mdr_material mdr_material;

/** Create a linear viscoelastic material with the shear relaxation modulus G(t) = relaxed_shear_modulus + sum moduli_i
 *  exp(-t/times_i) (Prony series) and a parallel dashpot (Kelvin-Voigt) if viscosity > 0. Without a relaxed modulus the material is
 *  a liquid.
 *  @param relaxed_shear_modulus  G(infinity) >= 0 [modulus]
 *  @param n                      number of terms; may be 0 with a relaxed modulus
 *  @param moduli                 [n] > 0 [modulus]
 *  @param times                  [n] relaxation times > 0 [time]
 *  @param viscosity              >= 0 [modulus time]; 0 with a bulk modulus
 *  @param nu                     constant Poisson's ratio, -1 < nu <= 1/2 [1]; not used with a bulk modulus
 *  @param bulk_modulus           K > 0, elastic: Poisson's ratio then increases with time [modulus]; 0: nu is constant
 *  @param out                    receives the handle
 *  @code
 *  mdr_material *polymer = NULL;
 *  const double G = 0.8e9, tau = 5.0;
 *  status = mdr_material_viscoelastic(0.2e9, 1, &G, &tau, 0.0, 0.0, 4e9, &polymer);
 *  MDR_FREE(polymer);
 *  @endcode
 */
int mdr_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[], double viscosity,
                              double nu, double bulk_modulus, mdr_material **out);

/** Create a material with the shear relaxation modulus G(t) = modulus (t/time)^(-exponent).
 *  @param modulus   G at `time`, > 0 [modulus]
 *  @param time      > 0 [time]
 *  @param exponent  > 0 (elastic) and < 1 (viscous) [1]
 *  @param nu        constant Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param out       receives the handle
 *  @code
 *  mdr_material *cell = NULL;
 *  status = mdr_material_power_law(500.0, 1.0, 0.2, 0.5, &cell);
 *  MDR_FREE(cell);
 *  @endcode
 */
int mdr_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out);

/** Compute a quantity of a viscoelastic material.
 *  @param m          material
 *  @param quantity   MDR_RELAXATION, MDR_CREEP or MDR_COMPLEX_MODULUS
 *  @param n          number of times or frequencies
 *  @param x          [n] t [time] or omega [1/time]
 *  @param out        [n] values; real parts of the complex modulus
 *  @param imaginary  [n] or NULL: imaginary parts of the complex modulus, otherwise 0
 *  @code
 *  const double t[2] = {0.1, 10.0};
 *  double G[2];
 *  status = mdr_material_values(gel, MDR_RELAXATION, 2, t, G, NULL);
 *  @endcode
 */
int mdr_material_values(const mdr_material *m, int quantity, int n, const double x[], double out[], double imaginary[]);

/** The elastic limits of a viscoelastic material. */
enum mdr_limit {
    MDR_LIMIT_GLASSY = 701, /**< The instantaneous response. */
    MDR_LIMIT_RELAXED = 702 /**< The long-time response. */
};

/** Return E and nu of an elastic limit.
 *  @param m      material
 *  @param limit  one of enum mdr_limit
 *  @param E      or NULL: receives Young's modulus [modulus]
 *  @param nu     or NULL: receives Poisson's ratio [1]
 *  @return also MDR_EINVALID if the material has no such limit: power laws, dashpots, liquids
 *  @code
 *  double E, nu;
 *  status = mdr_material_limit(gel, MDR_LIMIT_RELAXED, &E, &nu);
 *  @endcode
 */
int mdr_material_limit(const mdr_material *m, int limit, double *E, double *nu);

#ifdef __cplusplus
}
#endif

#endif
