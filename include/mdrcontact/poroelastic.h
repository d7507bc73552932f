/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file poroelastic.h
 * Poroelastic gels. Option MDRCONTACT_POROELASTIC.
 * @since 0.1
 */
#ifndef MDRCONTACT_POROELASTIC_H
#define MDRCONTACT_POROELASTIC_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The responses of a poroelastic gel. Created by mdr_poroelastic_new(). Immutable. */
typedef struct mdr_poroelastic mdr_poroelastic;

/** Drainage of the pore fluid at the surface of a gel. There is no default, because no other parameter has a larger effect. */
enum mdr_drainage {
    MDR_DRAINAGE_SURFACE = 1701, /**< The fluid drains everywhere, also under the indenter, which is porous or leaks along the
                                      interface. */
    MDR_DRAINAGE_SEALED = 1702,  /**< No flux through the surface anywhere. */
    MDR_DRAINAGE_INDENTER = 1703 /**< No flux under the indenter; pore pressure 0 outside. */
};

/** Create the responses of a gel in time and frequency: a poroelastic half-space (Biot, incompressible constituents), or a film
 *  bonded to an impermeable rigid base, under a rigid frictionless indenter. The initial response is F = 8 G a d, that of nu = 1/2;
 *  the final response is F = 4 G a d/(1 - nu). The responses are tabulated in some tenths of a second and checked against finer
 *  solutions between the nodes. The table of a half-space applies to all shear moduli, diffusivities, contact radii and times.
 *  @param nu         drained Poisson's ratio, -1 < nu < 1/2; nothing drains at 1/2
 *  @param drainage   one of enum mdr_drainage; MDR_DRAINAGE_INDENTER only for a half-space
 *  @param ratio      contact radius over the thickness of a film, 0 to 4; 0: half-space
 *  @param deviation  or NULL: receives the relative error of the table between its nodes
 *  @param out        receives the handle
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_poroelastic *hydrogel = NULL;
 *  status = mdr_poroelastic_new(0.3, MDR_DRAINAGE_SURFACE, 0.0, NULL, &hydrogel);
 *  MDR_FREE(hydrogel);
 *  @endcode
 */
int mdr_poroelastic_new(double nu, int drainage, double ratio, double *deviation, mdr_poroelastic **out);

/** Compute the response to a step at time 0.
 *  @param p              gel
 *  @param answer         MDR_RELAXATION, MDR_CREEP, MDR_PARABOLOID_RELAXATION, MDR_MEAN_RELAXATION or MDR_MEAN_CREEP
 *  @param shear_modulus  G > 0, drained and undrained [modulus]
 *  @param diffusivity    D > 0: 2 G (1 - nu)/(1 - 2 nu) times permeability over viscosity [length^2/time]
 *  @param radius         contact radius a > 0, on a film `ratio` thicknesses [length]
 *  @param n              number of times
 *  @param time           [n] >= 0; from the table up to D t/a^2 = 1e8, individually solved beyond [time]
 *  @param out            [n] see enum mdr_quantity
 *  @return also MDR_EINVALID
 *  @code
 *  const double t[2] = {1.0, 1000.0};
 *  double K[2];
 *  status = mdr_poroelastic_response(poroelastic, MDR_RELAXATION, 10e3, 1e-10, 100e-6, 2, t, K);
 *  @endcode
 */
int mdr_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity, double radius, int n,
                             const double time[], double out[]);

/** Compute the history of a flat punch: the force for a prescribed depth, or the depth for a prescribed force.
 *
 *  Before the first time the bodies are at rest. The first value is applied as a step, and the path is linear in time between its
 *  entries: F(t) = d(t_0) K(t - t_0) + the sum of D_j (t - t_j) Km(t - t_j) over t_j < t, with the changes D_j of the slope at t_j,
 *  the relaxation K and its mean Km; under a prescribed force with creep and its mean. Tension is possible.
 *  @param p              gel
 *  @param given          MDR_DEPTH or MDR_FORCE: the quantity in `in`
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         radius of the punch > 0, on a film `ratio` thicknesses [length]
 *  @param n              number of times
 *  @param time           [n] strictly ascending [time]
 *  @param in             [n] depths [length] or forces [modulus length^2]
 *  @param out            [n] forces [modulus length^2] or depths [length]
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE
 *  @code
 *  const double t[3] = {0.0, 10.0, 100.0}, d[3] = {0.0, 1e-6, 1e-6};
 *  double F[3];
 *  status = mdr_poroelastic_history(poroelastic, MDR_DEPTH, 10e3, 1e-10, 100e-6, 3, t, d, F);
 *  @endcode
 */
int mdr_poroelastic_history(const mdr_poroelastic *p, int given, double shear_modulus, double diffusivity, double radius, int n,
                            const double time[], const double in[], double out[]);

/** Compute the dynamic stiffness k* = k' + i k'' of a flat punch, or of any contact for small oscillations about a contact radius.
 *  @param p              gel
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         contact radius a > 0 [length]
 *  @param n              number of frequencies
 *  @param omega          [n] angular frequencies > 0 [1/time]
 *  @param storage        [n] k' [modulus length]
 *  @param loss           [n] k'' [modulus length]
 *  @return also MDR_EINVALID
 *  @code
 *  const double omega = 0.1;
 *  double storage, loss;
 *  status = mdr_poroelastic_dynamic_stiffness(poroelastic, 10e3, 1e-10, 100e-6, 1, &omega, &storage, &loss);
 *  @endcode
 */
int mdr_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity, double radius, int n,
                                      const double omega[], double storage[], double loss[]);

/** Compute pressures under an indenter after a step of its depth at time 0, at a fixed contact radius, per depth.
 *  @param p              gel
 *  @param kind           MDR_TOTAL_PRESSURE or MDR_PORE_PRESSURE
 *  @param is_flat        1: a flat punch, 0: a paraboloid
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         contact radius a > 0 [length]
 *  @param time           > 0, D t/a^2 >= 1e-5 [time]
 *  @param n              number of radii
 *  @param r              [n] 0 <= r < radius [length]
 *  @param out            [n] pressure per depth [modulus/length]; the error of the pore pressure of a sealed surface is 1e-4 of the
 *                        largest value
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE if this accuracy is not reached next to the edge
 *  @code
 *  const double r = 20e-6;
 *  double p;
 *  status = mdr_poroelastic_pressure(poroelastic, MDR_TOTAL_PRESSURE, 1, 10e3, 1e-10, 100e-6, 10.0, 1, &r, &p);
 *  @endcode
 */
int mdr_poroelastic_pressure(const mdr_poroelastic *p, int kind, int is_flat, double shear_modulus, double diffusivity,
                             double radius, double time, int n, const double r[], double out[]);

/** Compute C(k), the displacement of the surface of a gel per pressure of an oscillating wave with wavenumber k: 1/(2 G k) of an
 *  incompressible half-space, (1 - nu)/(G k) of a drained one. Compare mdr_body_compliance().
 *  @param nu             drained Poisson's ratio, -1 < nu < 1/2
 *  @param drainage       MDR_DRAINAGE_SURFACE or MDR_DRAINAGE_SEALED
 *  @param thickness      > 0 of a film on an impermeable rigid base; 0: half-space [length]
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param n              number of wavenumbers
 *  @param k              [n] > 0 [1/length]
 *  @param omega          [n] angular frequencies, 0: drained, or NULL: all 0; C(-omega) is the complex conjugate of C(omega) [1/time]
 *  @param out            [n] real parts [length/modulus]
 *  @param imaginary      [n] or NULL: imaginary parts, <= 0 for omega > 0
 *  @return also MDR_EINVALID
 *  @code
 *  const double k = 1e5, omega = 0.1;
 *  double C;
 *  status = mdr_poroelastic_compliance(0.3, MDR_DRAINAGE_SURFACE, 0.0, 10e3, 1e-10, 1, &k, &omega, &C, NULL);
 *  @endcode
 */
int mdr_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity, int n,
                               const double k[], const double omega[], double out[], double imaginary[]);

#ifdef __cplusplus
}
#endif

#endif
