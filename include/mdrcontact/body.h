/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file body.h
 * Bodies: what lies below a surface. A medium is a body under a model; what a body's surface answers to a wave needs none.
 * @since 0.1
 */
#ifndef MDRCONTACT_BODY_H
#define MDRCONTACT_BODY_H

#include "material.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What lies below a surface. Made by mdr_body_.... */
typedef struct mdr_body mdr_body;

/** A layer, or a half-space, of an isotropic material or of one that is isotropic in its plane with another stiffness along its
 *  normal z, perhaps under a stress in its plane, and the interface below it. Set all of it with MDR_SIZED first. */
typedef struct mdr_layer {
    size_t size;        /**< sizeof(mdr_layer), as MDR_SIZED sets it; the elements of an array have the size of the first. */
    double thickness;   /**< h > 0; not looked at in a substrate [length]. */
    double E;           /**< Young's modulus > 0, in the plane: E_t [modulus]. */
    double nu;          /**< Poisson's ratio, -1 < nu <= 1/2; in the plane: nu_t, -1 < nu_t < 1 [1]. */
    double E_z;         /**< Young's modulus along z > 0; E_z, nu_tz and G_z all 0: isotropic [modulus]. */
    double nu_tz;       /**< -strain along z over strain along t, under a stress along t in the plane; 2 nu_tz^2 E_z/E_t <= 1 - nu_t,
                             equal: incompressible [1]. */
    double G_z;         /**< Shear modulus of planes that hold z, > 0 [modulus]. */
    double C11;         /**< Or the stiffness matrix in place of the five above, which are then 0; all 0: not given.
                             C11 > |C12| [modulus]. */
    double C12;         /**< [modulus] */
    double C13;         /**< 2 C13^2 < C33 (C11 + C12) [modulus] */
    double C33;         /**< > 0 [modulus] */
    double C44;         /**< > 0 [modulus] */
    double prestress;   /**< Equibiaxial stress in the plane, tension > 0; the constants are the tangent moduli of the stressed state,
                             those of the free state are off by O(prestress/modulus) [modulus]. */
    double normal_compliance;     /**< 1/K_n >= 0 of the interface below, finite; 0: bonded; not looked at in a substrate
                                       [length/modulus]. */
    double tangential_compliance; /**< 1/K_t >= 0 likewise; INFINITY: it slides without friction [length/modulus]. */
    const mdr_material *material; /**< A material that relaxes, in place of all constants and of the prestress, which are 0; NULL:
                                       those. It may be freed once the body is made. */
} mdr_layer;

/** A layer of an isotropic material, bonded and free of stress.
 *  @param E          Young's modulus > 0 [modulus]
 *  @param nu         Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param thickness  > 0; not looked at in a substrate [length] */
static inline mdr_layer mdr_isotropic(double E, double nu, double thickness)
{
    mdr_layer layer = MDR_SIZED(mdr_layer);
    layer.E = E;
    layer.nu = nu;
    layer.thickness = thickness;
    return layer;
}

/** What the surface of a body adds to it: 1/C + tension k^2 + bending k^4 in place of 1/C(k), under MDR_MODEL_EXACT. Contacts
 *  answer states, adhesion, fields of the surface and laws, to 1e-9 (cones 1e-8); friction, stresses inside, energies and pairs of
 *  deformable bodies return MDR_EINVALID. Begun by MDR_SIZED. */
typedef struct mdr_surface {
    size_t size;       /**< Of this structure; MDR_SIZED sets it. */
    double tension;    /**< tau, as of a gel; > 0, or with a plate greater than 0.95 times the one under which it wrinkles; 0: none
                            [modulus length]. */
    double bending;    /**< B >= 0 of a plate that slides on the surface; 0: none [modulus length^3]. */
    double stretching; /**< K_m >= 0, stiffness in its plane of a sheet that is bonded to the surface, E h/(1 - nu^2); 0: none. Without
                            tension and plate, states have the tolerance of the medium [modulus length]. */
} mdr_surface;

/** A half-space, a coating or layers on a substrate, equations (1)-(16): of one material E_eff = E/(1 - nu^2). Where one has a
 *  `material` the body is viscoelastic: its layers are isotropic and free of stress, its interfaces do not relax.
 *  @param n          number of layers; 0: a half-space
 *  @param layers     [n] from the surface down; with n = 0 it may be NULL
 *  @param substrate  the half-space below; NULL: a rigid base, which holds the last layer by its interface: a sliding one is a
 *                    smooth rigid base
 *  @param surface    NULL: bare; not of a viscoelastic body
 *  @param out        receives the handle
 *  @return also MDR_EINVALID where compression is beyond that at which the surface wrinkles */
int mdr_body_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, const mdr_surface *surface, mdr_body **out);

/** Graded half-space, equation (16): E and nu are linear between the given depths and constant below the last one. A thin
 *  interval makes a step.
 *  @param n    number of depths, at least 2
 *  @param z    [n] depths, strictly ascending from z[0] = 0 [length]
 *  @param E    [n] Young's moduli > 0 [modulus]
 *  @param nu   [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param out  receives the handle */
int mdr_body_graded(int n, const double z[], const double E[], const double nu[], mdr_body **out);

/** Graded half-space from smooth functions, equation (16). Peaks narrower than 0.5 % of the depth may be missed.
 *  @param E        Young's modulus E(z) > 0 on 0 < z <= depth [modulus]
 *  @param nu       Poisson's ratio nu(z), -1 < nu <= 1/2 [1]
 *  @param context  passed on to both, may be NULL
 *  @param depth    > 0, below which the body is homogeneous [length]
 *  @param out      receives the handle
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if a function is not smooth enough to be sampled */
int mdr_body_graded_function(mdr_function E, mdr_function nu, void *context, double depth, mdr_body **out);

/** Half-space with E(z) = E0 (z/z0)^m and constant nu, solved exactly (Hess, Int. J. Eng. Sci. 104 (2016) 20).
 *  @param E0        Young's modulus at depth z0, > 0 [modulus]
 *  @param z0        > 0 [length]
 *  @param exponent  m, -1 < m < 1 [1]
 *  @param nu        -1 < nu <= 1/2 [1]
 *  @param out       receives the handle */
int mdr_body_power_graded(double E0, double z0, double exponent, double nu, mdr_body **out);

/** A rigid body, for one side of mdr_medium_pair().
 *  @param out  receives the handle */
int mdr_body_rigid(mdr_body **out);

/** The compression of one layer, all else as it is, at which the surface wrinkles: some wave then has no stiffness. The stress that
 *  the layer itself was given is not used. Exact; the limit of a thin stiff film is that of Chen and Hutchinson (2004). Where a
 *  constant of the layer, as C66 + stress, or the stiffness of a surface of it vanishes first, all short waves lose their stiffness
 *  at once, and there is no wavelength.
 *  @param body        elastic body of at least one layer, whose surface is bare
 *  @param layer       which layer, from 1 at the surface down
 *  @param stress      or NULL: receives the stress, < 0 [modulus]
 *  @param wavelength  or NULL: receives the wavelength of the wrinkles [length]
 *  @return also MDR_EUNREACHABLE if the layer itself gives way first */
int mdr_body_wrinkling(const mdr_body *body, int layer, double *stress, double *wavelength);

/** Loads of a surface. */
enum mdr_load_kind {
    MDR_LOAD_NORMAL = 901, /**< A pressure. */
    MDR_LOAD_SHEAR = 902,  /**< A traction of one direction along the surface: the mean over the directions of the wave. */
    MDR_LOAD_TWIST = 903   /**< A traction along the surface across the wave, which one around an axis consists of. */
};

/** C(k), what the surface answers to a wave of load: displacement over traction at wavenumber k; of two bodies that touch the sum of
 *  both. 2/(E* k), (2 - nu)/(2 G k) and 1/(G k) of a homogeneous body. Under a traction along the wave it is twice that of
 *  MDR_LOAD_SHEAR less that of MDR_LOAD_TWIST. It makes codes that solve contacts by Fourier transforms layered.
 *  @param body       body, not rigid and not of a power of the depth
 *  @param load       one of enum mdr_load_kind; MDR_LOAD_NORMAL of a surface that is not bare
 *  @param omega      angular frequency at which a viscoelastic body is taken, 0 for its relaxed one; else it does not matter
 *                    [1/time]
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0 [1/length]
 *  @param out        [n] real parts [length/modulus]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0; 0 of elastic bodies
 *  @return also MDR_EINVALID for other bodies, MDR_EDOMAIN where C is infinite, as that of a fluid at omega = 0 */
int mdr_body_compliance(const mdr_body *body, int load, double omega, int n, const double k[], double out[], double imaginary[]);

#ifdef __cplusplus
}
#endif

#endif
