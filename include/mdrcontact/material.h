/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file material.h
 * Viscoelastic materials: functions of time.
 * @since 0.1
 */
#ifndef MDRCONTACT_MATERIAL_H
#define MDRCONTACT_MATERIAL_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A viscoelastic material, for layers of mdr_body_layered(). Made by mdr_material_.... */
typedef struct mdr_material mdr_material;

/** A linear viscoelastic material whose shear modulus relaxes as G(t) = relaxed_shear_modulus + sum moduli_i exp(-t/times_i) (Prony
 *  series), with a dashpot in parallel (Kelvin-Voigt) where viscosity > 0. Without a relaxed modulus it flows without end.
 *  @param relaxed_shear_modulus  G(infinity) >= 0 [modulus]
 *  @param n                      number of terms; 0 is allowed with a relaxed modulus
 *  @param moduli                 [n] > 0 [modulus]
 *  @param times                  [n] relaxation times > 0 [time]
 *  @param viscosity              >= 0 [modulus time]; 0 with a bulk modulus
 *  @param nu                     Poisson's ratio, constant, -1 < nu <= 1/2; not used with a bulk modulus
 *  @param bulk_modulus           K > 0, elastic: Poisson's ratio then grows in time [modulus]; 0: nu is constant
 *  @param out                    receives the handle */
int mdr_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[], double viscosity,
                              double nu, double bulk_modulus, mdr_material **out);

/** A material whose shear modulus relaxes as a power of time, G(t) = modulus (t/time)^(-exponent).
 *  @param modulus   G at `time`, > 0 [modulus]
 *  @param time      > 0 [time]
 *  @param exponent  > 0 (elastic) and < 1 (viscous) [1]
 *  @param nu        Poisson's ratio, constant, -1 < nu <= 1/2 [1]
 *  @param out       receives the handle */
int mdr_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out);

/** A quantity of a viscoelastic material.
 *  @param m          material
 *  @param quantity   MDR_RELAXATION, MDR_CREEP or MDR_COMPLEX_MODULUS
 *  @param n          number of times or frequencies
 *  @param x          [n] t [time] or omega [1/time]
 *  @param out        [n] values, of the complex modulus real parts
 *  @param imaginary  [n] or NULL: imaginary parts of the complex modulus, else 0 */
int mdr_material_values(const mdr_material *m, int quantity, int n, const double x[], double out[], double imaginary[]);

/** The elastic materials that a viscoelastic one is like under sudden and under lasting loads. */
enum mdr_limit {
    MDR_LIMIT_GLASSY = 701, /**< At once. */
    MDR_LIMIT_RELAXED = 702 /**< In the end. */
};

/** E and nu of a limit.
 *  @param m      material
 *  @param limit  one of enum mdr_limit
 *  @param E      or NULL: receives Young's modulus [modulus]
 *  @param nu     or NULL: receives Poisson's ratio [1]
 *  @return also MDR_EINVALID where there is no such limit: power laws, dashpots, liquids */
int mdr_material_limit(const mdr_material *m, int limit, double *E, double *nu);

#ifdef __cplusplus
}
#endif

#endif
