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

/** The answers of a poroelastic gel. Made by mdr_poroelastic_new(). */
typedef struct mdr_poroelastic mdr_poroelastic;

/** What the pore fluid may do at the surface of a gel. There is no default: it matters more than anything else. */
enum mdr_drainage {
    MDR_DRAINAGE_SURFACE = 1701, /**< It drains everywhere, under the indenter too, which is porous or leaks along the interface. */
    MDR_DRAINAGE_SEALED = 1702,  /**< No flux through the surface anywhere. */
    MDR_DRAINAGE_INDENTER = 1703 /**< No flux under the indenter, pore pressure 0 beside it. */
};

/** The answers of a gel in time and under oscillation: a poroelastic half-space (Biot, incompressible constituents), or a film
 *  bonded to a rigid base that lets no fluid through, under a rigid frictionless indenter. One table, about half a second: that of a
 *  half-space serves all shear moduli, diffusivities, contact radii and times. It is compared with finer
 *  solutions between its nodes. At once F = 8 G a d as of nu = 1/2, at last F = 4 G a d/(1 - nu).
 *  @param nu        drained Poisson's ratio, -1 < nu < 1/2, at which nothing would drain
 *  @param drainage  one of enum mdr_drainage; MDR_DRAINAGE_INDENTER on a half-space only
 *  @param ratio     contact radius over the thickness of a film, 0 to 4; 0: half-space
 *  @param deviation or NULL: receives by how much the table is off between its nodes, relative
 *  @param out       receives the handle
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE */
int mdr_poroelastic_new(double nu, int drainage, double ratio, double *deviation, mdr_poroelastic **out);

/** The answer to a step at time 0.
 *  @param p              gel
 *  @param answer         MDR_RELAXATION, MDR_CREEP, MDR_PARABOLOID_RELAXATION, MDR_MEAN_RELAXATION or MDR_MEAN_CREEP
 *  @param shear_modulus  G > 0, drained and undrained [modulus]
 *  @param diffusivity    D > 0: 2 G (1 - nu)/(1 - 2 nu) times permeability over viscosity [length^2/time]
 *  @param radius         contact radius a > 0, on a film `ratio` thicknesses [length]
 *  @param n              number of times
 *  @param time           [n] >= 0; from the table up to D t/a^2 = 1e8, solved one by one beyond [time]
 *  @param out            [n] see enum mdr_quantity
 *  @return also MDR_EINVALID */
int mdr_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity, double radius, int n,
                             const double time[], double out[]);

/** The history of a flat punch: the force along a path of the depth, or the depth along a path of the force.
 *
 *  Before the first time the bodies are at rest. The first value is reached in a jump, and the path is linear in time between its
 *  entries: F(t) = d(t_0) K(t - t_0) + the sum of D_j (t - t_j) Km(t - t_j) over t_j < t, with the changes D_j of the slope at t_j,
 *  K the relaxation and Km its mean; under a prescribed force creep and its mean. Tension is allowed.
 *  @param p              gel
 *  @param given          MDR_DEPTH or MDR_FORCE: what `in` holds
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         radius of the punch > 0, on a film `ratio` thicknesses [length]
 *  @param n              number of times
 *  @param time           [n] strictly ascending [time]
 *  @param in             [n] depths [length] or forces [modulus length^2]
 *  @param out            [n] forces [modulus length^2] or depths [length]
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE */
int mdr_poroelastic_history(const mdr_poroelastic *p, int given, double shear_modulus, double diffusivity, double radius, int n,
                            const double time[], const double in[], double out[]);

/** The dynamic stiffness k* = k' + i k'' of a flat punch, or of any contact that oscillates by little about a contact radius.
 *  @param p              gel
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         contact radius a > 0 [length]
 *  @param n              number of frequencies
 *  @param omega          [n] angular frequencies > 0 [1/time]
 *  @param storage        [n] k' [modulus length]
 *  @param loss           [n] k'' [modulus length]
 *  @return also MDR_EINVALID */
int mdr_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity, double radius, int n,
                                      const double omega[], double storage[], double loss[]);

/** Pressures under an indenter after a step of its depth at time 0, the contact radius being held; per depth [modulus/length].
 *  @param p              gel
 *  @param kind           MDR_TOTAL_PRESSURE or MDR_PORE_PRESSURE
 *  @param is_flat        1: a flat punch, 0: a paraboloid
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param radius         contact radius a > 0 [length]
 *  @param time           > 0, D t/a^2 >= 1e-5 [time]
 *  @param n              number of radii
 *  @param r              [n] 0 <= r < radius [length]
 *  @param out            [n] pressure per depth [modulus/length]; the pore pressure of a sealed surface to 1e-4 of the largest
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE where that is not reached next to the edge */
int mdr_poroelastic_pressure(const mdr_poroelastic *p, int kind, int is_flat, double shear_modulus, double diffusivity,
                             double radius, double time, int n, const double r[], double out[]);

/** C(k), what the surface of a gel answers to a wave of pressure that oscillates: displacement over pressure at wavenumber k,
 *  1/(2 G k) of an incompressible half-space, (1 - nu)/(G k) of one that has drained. See mdr_body_compliance().
 *  @param nu             drained Poisson's ratio, -1 < nu < 1/2
 *  @param drainage       MDR_DRAINAGE_SURFACE or MDR_DRAINAGE_SEALED
 *  @param thickness      > 0 of a film on a rigid base that lets no fluid through; 0: half-space [length]
 *  @param shear_modulus  G > 0 [modulus]
 *  @param diffusivity    D > 0 [length^2/time]
 *  @param omega          angular frequency >= 0; 0: drained [1/time]
 *  @param n              number of wavenumbers
 *  @param k              [n] > 0 [1/length]
 *  @param out            [n] real parts [length/modulus]
 *  @param imaginary      [n] or NULL: imaginary parts, <= 0
 *  @return also MDR_EINVALID */
int mdr_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity, double omega,
                               int n, const double k[], double out[], double imaginary[]);

#ifdef __cplusplus
}
#endif

#endif
