/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file body.h
 * Bodies: the layers, gradings and surfaces of which media are made (medium.h), and the compliance of a surface.
 * @since 0.1
 */
#ifndef MDRCONTACT_BODY_H
#define MDRCONTACT_BODY_H

#include "material.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A body below a surface. Created by mdr_body_.... Immutable. */
typedef struct mdr_body mdr_body;

/** A layer or a half-space, and the interface below it. The material is isotropic, or transversely isotropic with its axis z along
 *  the normal, and may be under a stress in its plane. Initialize with MDR_SIZED. */
typedef struct mdr_layer {
    size_t size;                  /**< Size of this structure, set by MDR_SIZED. In an array all elements have that of the first. */
    double thickness;             /**< h > 0; ignored in a substrate [length]. */
    double E;                     /**< Young's modulus > 0; of a transversely isotropic material E_t, in the plane [modulus]. */
    double nu;                    /**< Poisson's ratio, -1 < nu <= 1/2; of a transversely isotropic material nu_t, in the plane, -1
                                       < nu_t < 1 [1]. */
    double E_z;                   /**< Young's modulus along z > 0; E_z, nu_tz and G_z all 0: isotropic [modulus]. */
    double nu_tz;                 /**< Minus the strain along z over the strain along t, under a stress along t in the plane; 2
                                       nu_tz^2 E_z/E_t <= 1 - nu_t, equal: incompressible [1]. */
    double G_z;                   /**< Shear modulus of planes that contain z, > 0 [modulus]. */
    double C11;                   /**< The stiffness matrix C11 to C44 may replace the five constants above, which must then be 0;
                                       all 0: not given. C11 > |C12| [modulus]. */
    double C12;                   /**< [modulus] */
    double C13;                   /**< 2 C13^2 < C33 (C11 + C12) [modulus] */
    double C33;                   /**< > 0 [modulus] */
    double C44;                   /**< > 0 [modulus] */
    double prestress;             /**< Equibiaxial stress in the plane, tension > 0. The constants are the tangent moduli of the
                                       stressed state; those of the stress-free state have an error of O(prestress/modulus)
                                       [modulus]. */
    double normal_compliance;     /**< 1/K_n >= 0 of the interface below, finite; 0: bonded; ignored in a substrate
                                       [length/modulus]. */
    double tangential_compliance; /**< 1/K_t >= 0 of the interface below; INFINITY: frictionless sliding [length/modulus]. */
    const mdr_material *material; /**< A viscoelastic material that replaces all constants and the prestress, which must then be 0;
                                       NULL: none. It may be freed when the body has been created. */
} mdr_layer;

/** Return a bonded, stress-free layer of an isotropic material.
 *  @param E          Young's modulus > 0 [modulus]
 *  @param nu         Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param thickness  > 0; ignored in a substrate [length]
 *  @code
 *  const mdr_layer titania = mdr_isotropic(150e9, 0.27, 200e-9);
 *  mdr_body *coated = NULL;
 *  status = mdr_body_layered(1, &titania, &silicon, NULL, &coated);
 *  MDR_FREE(coated);
 *  @endcode
 */
static inline mdr_layer mdr_isotropic(double E, double nu, double thickness)
{
    mdr_layer layer = MDR_SIZED(mdr_layer);
    layer.E = E;
    layer.nu = nu;
    layer.thickness = thickness;
    return layer;
}

/** Surface tension, a plate or a sheet on the surface of a body: 1/C + tension k^2 + bending k^4 replaces 1/C(k), with
 *  MDR_MODEL_EXACT. Contacts return states, adhesion, surface fields and laws, to 1e-9 (cones 1e-8). Friction, subsurface stresses,
 *  energies and pairs of deformable bodies return MDR_EINVALID. Initialize with MDR_SIZED. */
typedef struct mdr_surface {
    size_t size;       /**< Size of this structure; MDR_SIZED sets it. */
    double tension;    /**< tau, for example of a gel; > 0, or with a plate greater than 0.95 times the tension at which it
                            wrinkles; 0: none [modulus length]. */
    double bending;    /**< B >= 0, bending stiffness of a plate that slides on the surface; 0: none [modulus length^3]. */
    double stretching; /**< K_m >= 0, in-plane stiffness of a sheet bonded to the surface, E h/(1 - nu^2); 0: none. Without tension
                            and plate, states have the tolerance of the medium [modulus length]. */
} mdr_surface;

/** Create a half-space, a coating or layers on a substrate, equations (1)-(16). A single material has E_eff = E/(1 - nu^2). If a
 *  layer has a `material` the body is viscoelastic: its layers must be isotropic and stress-free, and its interfaces do not relax.
 *  @param n          number of layers; 0: a half-space
 *  @param layers     [n] top to bottom; may be NULL if n = 0
 *  @param substrate  the half-space below; NULL: a rigid base, to which the interface of the last layer connects; with a sliding
 *                    interface the base is rigid and smooth
 *  @param surface    NULL: bare; must be NULL for a viscoelastic body
 *  @param out        receives the handle
 *  @return also MDR_EINVALID if the compression exceeds that at which the surface wrinkles
 *  @code
 *  mdr_body *coated = NULL;
 *  status = mdr_body_layered(1, &oxide, &silicon, NULL, &coated);
 *  MDR_FREE(coated);
 *  @endcode
 */
int mdr_body_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, const mdr_surface *surface, mdr_body **out);

/** Create a graded half-space, equation (16): E and nu are linear between the given depths and constant below the last one. A thin
 *  interval represents a step.
 *  @param n    number of depths, at least 2
 *  @param z    [n] depths, strictly ascending from z[0] = 0 [length]
 *  @param E    [n] Young's moduli > 0 [modulus]
 *  @param nu   [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param out  receives the handle
 *  @code
 *  mdr_body *graded = NULL;
 *  const double z[2] = {0, 1e-6}, E[2] = {300e9, 200e9}, nu[2] = {0.25, 0.3};
 *  status = mdr_body_graded(2, z, E, nu, &graded);
 *  MDR_FREE(graded);
 *  @endcode
 */
int mdr_body_graded(int n, const double z[], const double E[], const double nu[], mdr_body **out);

/** Create a graded half-space from smooth functions, equation (16). Peaks narrower than 0.5 % of the depth may be missed.
 *  @param E        Young's modulus E(z) > 0 on 0 < z <= depth [modulus]
 *  @param nu       Poisson's ratio nu(z), -1 < nu <= 1/2 [1]
 *  @param context  passed to both, may be NULL
 *  @param depth    > 0; below it the body is homogeneous [length]
 *  @param out      receives the handle
 *  @return also MDR_ECALLBACK; MDR_ENOCONVERGENCE if a function is not smooth enough
 *  @code
 *  mdr_body *graded = NULL;
 *  status = mdr_body_graded_function(stiffness, poisson, NULL, 2e-6, &graded);
 *  MDR_FREE(graded);
 *  @endcode
 */
int mdr_body_graded_function(mdr_function E, mdr_function nu, void *context, double depth, mdr_body **out);

/** Create a half-space with E(z) = E0 (z/z0)^m and constant nu, which has an exact solution (Hess, Int. J. Eng. Sci. 104 (2016)
 *  20).
 *  @param E0        Young's modulus at depth z0, > 0 [modulus]
 *  @param z0        > 0 [length]
 *  @param exponent  m, -1 < m < 1 [1]
 *  @param nu        -1 < nu <= 1/2 [1]
 *  @param out       receives the handle
 *  @code
 *  mdr_body *graded = NULL;
 *  status = mdr_body_power_graded(10e6, 1e-3, 0.4, 0.3, &graded);
 *  MDR_FREE(graded);
 *  @endcode
 */
int mdr_body_power_graded(double E0, double z0, double exponent, double nu, mdr_body **out);

/** Create a rigid body, for one side of mdr_medium_pair().
 *  @param out  receives the handle
 *  @code
 *  mdr_body *stiff = NULL;
 *  status = mdr_body_rigid(&stiff);
 *  MDR_FREE(stiff);
 *  @endcode
 */
int mdr_body_rigid(mdr_body **out);

/** Compute the compressive stress in one layer, with everything else unchanged, at which the surface wrinkles: the stiffness of one
 *  wavelength vanishes. The prestress of that layer is ignored. The result is exact; the limit of a thin stiff film is that of Chen
 *  and Hutchinson (2004).
 *  @param body        elastic body of at least one layer, with a bare surface
 *  @param layer       index of the layer, from 1 at the surface
 *  @param stress      or NULL: receives the stress, < 0 [modulus]
 *  @param wavelength  or NULL: receives the wavelength of the wrinkles [length]
 *  @return also MDR_EUNREACHABLE if the layer itself becomes unstable first: a constant of the layer, such as C66 + stress, or the
 *          stiffness of a surface of it vanishes, then all short waves lose their stiffness together and no wavelength exists
 *  @code
 *  double stress, wavelength;
 *  const mdr_layer skin = mdr_isotropic(70e9, 0.3, 50e-9), rubber = mdr_isotropic(2e6, 0.5, 0.0);
 *  mdr_body *sheet = NULL;
 *  mdr_body_layered(1, &skin, &rubber, NULL, &sheet);
 *  status = mdr_body_wrinkling(sheet, 1, &stress, &wavelength);
 *  MDR_FREE(sheet);
 *  @endcode
 */
int mdr_body_wrinkling(const mdr_body *body, int layer, double *stress, double *wavelength);

/** Loads of a surface. */
enum mdr_load_kind {
    MDR_LOAD_NORMAL = 901,  /**< Pressure. */
    MDR_LOAD_SHEAR = 902,   /**< Unidirectional traction along the surface, averaged over the directions of the wave. */
    MDR_LOAD_TWIST = 903,   /**< Traction along the surface, normal to the wave vector; a traction around an axis consists of such
                                 waves. */
    MDR_LOAD_COUPLING = 904 /**< Normal displacement per traction along the wave vector, -i C, and displacement along the wave vector
                                 per pressure, i C, of waves exp(i k x); both positive into the body and along x. */
};

/** Compute C(k), the surface displacement per traction of a wave of load with wavenumber k; of two bodies in contact C is the sum.
 *  It is 2/(E* k), (2 - nu)/(2 G k), 1/(G k) and (1 - 2 nu)/(2 G k) on a homogeneous body for the four loads. For a traction parallel
 *  to the wave vector it is twice that of MDR_LOAD_SHEAR minus that of MDR_LOAD_TWIST. With C(k), contact codes based on Fourier
 *  transforms can treat layered bodies. In arrays of 2000 and more wavenumbers, C of graded bodies and of more than four layers is
 *  interpolated in a table with an error of 1e-11, which is checked between its nodes.
 *  @param body       body that is not rigid
 *  @param load       one of enum mdr_load_kind; only MDR_LOAD_NORMAL if the surface is not bare or the body is power-law graded
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0; 0 also if the base is rigid, where C is finite [1/length]
 *  @param omega      [n] angular frequencies for a viscoelastic body, 0: relaxed, or NULL: all 0; C(-omega) is the complex conjugate
 *                    of C(omega), of waves exp(i omega t); ignored for an elastic one [1/time]
 *  @param out        [n] real parts [length/modulus]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0 for omega > 0, except for MDR_LOAD_COUPLING; 0 for elastic bodies
 *  @return also MDR_EINVALID for rigid bodies, MDR_EDOMAIN if C is infinite, as for a fluid at omega = 0
 *  @code
 *  const double k[2] = {1e5, 1e8};
 *  double C[2];
 *  status = mdr_body_compliance(film, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL);
 *  @endcode
 */
int mdr_body_compliance(const mdr_body *body, int load, int n, const double k[], const double omega[], double out[],
                        double imaginary[]);

/** Compute the limits of the compliance under a pressure: k C/2 of very short and of very long waves, and what the layers add to the
 *  half-space of the base.
 *  @param body         body that is neither rigid nor power-law graded
 *  @param omega        angular frequency for a viscoelastic body, 0: relaxed; ignored for an elastic one [1/time]
 *  @param out          [3] 1/E0* of the surface, 0 under a surface with tension or a plate [1/modulus]; 1/E* of the base, 0 if it is
 *                      rigid [1/modulus]; C - 2/(E* k) with this E* at k = 0, which is C itself if the base is rigid
 *                      [length/modulus]
 *  @param imaginary    [3] or NULL: imaginary parts; 0 for elastic bodies
 *  @return also MDR_EINVALID for other bodies, MDR_EDOMAIN as of mdr_body_compliance()
 *  @code
 *  double limits[3];
 *  status = mdr_body_compliance_limits(film, 0.0, limits, NULL);
 *  @endcode
 */
int mdr_body_compliance_limits(const mdr_body *body, double omega, double out[3], double imaginary[3]);

/** The displacement of a surface in space. Created by mdr_response_new(). Immutable. */
typedef struct mdr_response mdr_response;

/** Fit k C(k)/2 of a body by 1/E0* + sum a_i exp(-z_i k), whose displacements in space are elementary. It takes 60, 120 or 240
 *  exponentials. The error is checked between the wavenumbers of the fit and beyond them. Create it once for a body.
 *  @param body       body that is neither rigid nor power-law graded; a viscoelastic body has relaxed
 *  @param tolerance  largest error of k C/2 over its largest value, > 0 [1]
 *  @param out        receives the handle
 *  @return also MDR_ENOCONVERGENCE if the fit misses the tolerance, MDR_EINVALID for other bodies
 *  @code
 *  mdr_response *surface = NULL;
 *  status = mdr_response_new(film, 1e-8, &surface);
 *  MDR_FREE(surface);
 *  @endcode
 */
int mdr_response_new(const mdr_body *body, double tolerance, mdr_response **out);

/** Query the error of the fit and the number of its exponentials.
 *  @param response   response of a surface
 *  @param tolerance  receives the largest error of k C/2 over its largest value [1]
 *  @param images     or NULL: receives the number of exponentials; 0 for a half-space
 *  @code
 *  double error;
 *  status = mdr_response_about(response, &error, NULL);
 *  @endcode
 */
int mdr_response_about(const mdr_response *response, double *tolerance, int *images);

/** Compute the normal displacement of the surface under a unit point force, 1/(pi E* r) on a homogeneous body.
 *  @param response  response of a surface
 *  @param n         number of distances
 *  @param r         [n] distances from the force > 0 [length]
 *  @param out       [n] displacements per force [1/(modulus length)]
 *  @code
 *  const double r[2] = {1e-7, 1e-6};
 *  double u[2];
 *  status = mdr_response_point(response, 2, r, u);
 *  @endcode
 */
int mdr_response_point(const mdr_response *response, int n, const double r[], double out[]);

/** Compute the normal displacement of the surface under a unit pressure on a rectangle, which is exact for the fit at every size of
 *  the rectangle. Boundary-element codes on a free domain need it for one pixel.
 *  @param response  response of a surface
 *  @param width     side along x > 0 [length]
 *  @param height    side along y > 0 [length]
 *  @param n         number of points
 *  @param x         [n] from the centre of the rectangle [length]
 *  @param y         [n] [length]
 *  @param out       [n] displacements per pressure [length/modulus]
 *  @code
 *  const double x[2] = {0.0, 1e-6}, y[2] = {0.0, 0.0};
 *  double u[2];
 *  status = mdr_response_rectangle(response, 1e-7, 1e-7, 2, x, y, u);
 *  @endcode
 */
int mdr_response_rectangle(const mdr_response *response, double width, double height, int n, const double x[], const double y[],
                           double out[]);

#ifdef __cplusplus
}
#endif

#endif
