/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file medium.h
 * Media: effective contact modulus E_eff(a), stiffness k = 2 a E_eff(a), equation (10).
 * @since 0.1
 */
#ifndef MDRCONTACT_MEDIUM_H
#define MDRCONTACT_MEDIUM_H

#include "material.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What is pressed: an elastic or viscoelastic half-space, or two bodies. Made by mdr_medium_.... */
typedef struct mdr_medium mdr_medium;

/** Models of a coated, layered or graded half-space. h is the thickness, x = a/h, xi = h/a, index 0 the coating, 1 the substrate,
 *  E* = E/(1 - nu^2). */
enum mdr_model {
    MDR_MODEL_GAO = 201,                /**< Gao's weights, moduli in parallel, equations (12)-(16): the source's model. */
    MDR_MODEL_GAO_SERIES = 202,         /**< Gao's weights, 1/G in series: far closer to the exact solution at large contrast. */
    MDR_MODEL_DOERNER_NIX = 203,        /**< 1/E_eff = (1 - e^(-alpha xi))/E*0 + e^(-alpha xi)/E*1, equation (11). */
    MDR_MODEL_WAVE = 204,               /**< Response to a wave of wavenumber q = wave_factor/a, equations (19), (20). */
    MDR_MODEL_MENCIK_EXPONENTIAL = 205, /**< E_eff = E*1 + (E*0 - E*1) e^(-alpha x). */
    MDR_MODEL_MENCIK_RECIPROCAL = 206,  /**< 1/E_eff = 1/E*1 + (1/E*0 - 1/E*1) e^(-alpha x). */
    MDR_MODEL_BEC = 207,                /**< Bec et al. 2006: film and substrate as springs in series. */
    MDR_MODEL_PERRIOT_BARTHEL = 208,    /**< Perriot, Barthel 2004: a fit to their exact solution. */
    MDR_MODEL_HAY_CRAWFORD = 209,       /**< Hay, Crawford 2011: Gao's weights with the film also acting in parallel. */
    MDR_MODEL_DIMITRIADIS = 210,        /**< Dimitriadis et al. 2002: layer with nu = 1/2 on a rigid base, for a paraboloid or a
                                             sphere and a < h; all else is refused. */
    MDR_MODEL_GARCIA = 211,             /**< Garcia, Garcia 2018: the same with their coefficients. */
    MDR_MODEL_EXACT = 212,              /**< The exact solution of the layered half-space. */
    MDR_MODEL_GAO_POWER = 213           /**< Gao's weights, power mean G_eff = [G1^p + (G0^p - G1^p) I0]^(1/p) between the two. */
};

/** Which substrates a model takes. */
enum mdr_model_base {
    MDR_BASE_ELASTIC = 1301, /**< An elastic half-space. */
    MDR_BASE_ANY = 1302,     /**< An elastic half-space or a rigid base. */
    MDR_BASE_RIGID = 1303    /**< A rigid base. */
};

/** What a model takes. */
typedef struct mdr_model_facts {
    size_t size;          /**< Of this structure; MDR_SIZED sets it. */
    double largest_ratio; /**< It is valid up to this a/h; INFINITY where there is no limit. */
    int base;             /**< One of enum mdr_model_base. */
    int takes_layers;     /**< 1: any number of layers; 0: one coating. */
    int takes_graded;     /**< 1: graded half-spaces too. */
    int spherical_only;   /**< 1: it is valid under a paraboloid or a sphere only. */
    char constant[24];    /**< The member of mdr_medium_options that is a number which a fit can find; empty if there is none. */
    char option[24];      /**< Another member that concerns it; empty if there is none. */
    double default_constant; /**< The default of the member that `constant` names; 0 if there is none. */
} mdr_model_facts;

/** What a model takes.
 *  @param model  one of enum mdr_model
 *  @param facts  begun by MDR_SIZED; receives it */
int mdr_model_info(int model, mdr_model_facts *facts);

/** Which Poisson's ratio enters I0 of Gao's weights, which the source leaves open. */
enum mdr_weight_nu {
    MDR_WEIGHT_NU_SURFACE = 1201,   /**< That of the surface: the most accurate on average, and the default. */
    MDR_WEIGHT_NU_SUBSTRATE = 1202, /**< That of the substrate. */
    MDR_WEIGHT_NU_EFFECTIVE = 1203, /**< The effective one at the same a. */
    MDR_WEIGHT_NU_GIVEN = 1204      /**< The number weight_nu. */
};

/** What a model leaves to choose. Begun by MDR_SIZED; a model looks only at what concerns it. */
typedef struct mdr_medium_options {
    size_t size;          /**< Of this structure; MDR_SIZED sets it. */
    double alpha;         /**< Doerner-Nix, Mencik: decay constant > 0 [1]; default 1. */
    double wave_factor;   /**< Wave: q a > 0 [1]; default pi/2. */
    int weight_nu_choice; /**< Gao: one of enum mdr_weight_nu; default MDR_WEIGHT_NU_SURFACE. */
    double weight_nu;     /**< Gao: the number for MDR_WEIGHT_NU_GIVEN, -1 < nu <= 1/2. */
    double tolerance;     /**< Exact: relative tolerance, 1e-12 to 1e-2; default 1e-10. */
    double exponent;      /**< Gao's power mean: p, -1 (series) to 1 (parallel), 0 for the logarithm's; default -0.65. */
    int exponent_is_given; /**< Not 0: an exponent of 0 is meant. */
    double surface_tension; /**< Exact: tau of the surface, 1/C + tau k^2 + B k^4 in place of 1/C(k): the tension of a gel; > 0, or with a
                                 plate greater than 0.95 times the one under which it wrinkles [modulus length]; default 0. */
    double surface_bending; /**< Exact: B >= 0 of a plate that slides on the surface [modulus length^3]; default 0. Coated and
                                 layered elastic bodies take both, a homogeneous one by mdr_medium_layered() with n = 0. Their contacts
                                 answer states, adhesion, fields of the surface and laws, to 1e-9 (cones 1e-8); friction, stresses
                                 inside, energies and pairs return MDR_EINVALID. */
    double surface_stretching; /**< Exact: K_m >= 0, stiffness in its plane of a sheet that is bonded to the surface, E h/(1 - nu^2)
                                 [modulus length]; default 0. Without tension and plate, states have the tolerance of the medium. What
                                 returns MDR_EINVALID under those does so under this one. */
} mdr_medium_options;

/** Homogeneous half-space of given contact modulus, whatever its E and nu.
 *  @param contact_modulus  E* > 0 [modulus]
 *  @param out              receives the handle */
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);

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
    double C11;         /**< Or the stiffness matrix in place of the six above, all 0: not given. C11 > |C12| [modulus]. */
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
                                       those. It may be freed once the medium is made. */
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

/** A half-space, a coating or layers on a substrate, equations (1)-(16): of one material E_eff = E/(1 - nu^2). What is not
 *  isotropic, bonded and free of stress takes MDR_MODEL_EXACT; more than one layer that, MDR_MODEL_GAO, ..._GAO_SERIES or
 *  ..._GAO_POWER. A tangential contact over a sliding interface is refused, as stresses inside layers under a prestress are.
 *
 *  Where one has a `material` the body is viscoelastic: its layers are isotropic and free of stress, its interfaces do not relax. Its
 *  contacts answer mdr_contact_history(); everything else returns MDR_EINVALID and says so, work of adhesion included.
 *  @param n          number of layers; 0: a half-space
 *  @param layers     [n] from the surface down; with n = 0 it may be NULL
 *  @param substrate  the half-space below; NULL: a rigid base, which holds the last layer by its interface: a sliding one is a
 *                    smooth rigid base. MDR_MODEL_DIMITRIADIS and MDR_MODEL_GARCIA demand a rigid base and nu = 1/2,
 *                    MDR_MODEL_EXACT allows one, the others refuse it
 *  @param model      one of enum mdr_model; MDR_MODEL_EXACT for a half-space
 *  @param options    NULL for the defaults
 *  @param out        receives the handle
 *  @return also MDR_EINVALID where compression is beyond that at which the surface wrinkles */
int mdr_medium_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, int model, const mdr_medium_options *options,
                     mdr_medium **out);

/** The compression of one layer, all else as it is, at which the surface wrinkles: some wave then has no stiffness. The stress that
 *  the layer itself was given is not used. Exact; the limit of a thin stiff film is that of Chen and Hutchinson (2004).
 *  @param n           number of layers, at least 1
 *  @param layers      [n] from the surface down
 *  @param substrate   the half-space below, or NULL: a rigid base
 *  @param layer       which layer, 1 to n from the surface down
 *  @param stress      or NULL: receives the stress, < 0 [modulus]
 *  @param wavelength  or NULL: receives the wavelength of the wrinkles [length] */
int mdr_layers_wrinkling(int n, const mdr_layer *layers, const mdr_layer *substrate, int layer, double *stress, double *wavelength);

/** Graded half-space, equation (16): E and nu are linear between the given depths and constant below the last one. A thin
 *  interval makes a step.
 *  @param n        number of depths, at least 2
 *  @param z        [n] depths, strictly ascending from z[0] = 0 [length]
 *  @param E        [n] Young's moduli > 0 [modulus]
 *  @param nu       [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param model    MDR_MODEL_GAO, ..._GAO_SERIES, ..._GAO_POWER or ..._EXACT
 *  @param options  NULL for the defaults
 *  @param out      receives the handle */
int mdr_medium_graded(int n, const double z[], const double E[], const double nu[], int model,
                      const mdr_medium_options *options, mdr_medium **out);

/** Graded half-space from smooth functions, equation (16). Peaks narrower than 0.5 % of the depth may be missed.
 *  @param E        Young's modulus E(z) > 0 on 0 < z <= depth [modulus]
 *  @param nu       Poisson's ratio nu(z), -1 < nu <= 1/2 [1]
 *  @param context  passed on to both, may be NULL
 *  @param depth    > 0, below which the body is homogeneous [length]
 *  @param model    MDR_MODEL_GAO, ..._GAO_SERIES, ..._GAO_POWER or ..._EXACT
 *  @param options  NULL for the defaults
 *  @param out      receives the handle
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if a function is not smooth enough to be sampled */
int mdr_medium_graded_function(mdr_function E, mdr_function nu, void *context, double depth, int model,
                               const mdr_medium_options *options, mdr_medium **out);

/** Half-space with E(z) = E0 (z/z0)^m and constant nu, exactly (Hess, Int. J. Eng. Sci. 104 (2016) 20).
 *  @param E0        Young's modulus at depth z0, > 0 [modulus]
 *  @param z0        > 0 [length]
 *  @param exponent  m, -1 < m < 1 [1]
 *  @param nu        -1 < nu <= 1/2 [1]
 *  @param out       receives the handle */
int mdr_medium_power_graded(double E0, double z0, double exponent, double nu, mdr_medium **out);

/** A rigid body: one body of mdr_medium_pair(), no medium by itself.
 *  @param out  receives the handle */
int mdr_medium_rigid(mdr_medium **out);

/** Two deformable bodies as one medium: what presses and what is pressed, each homogeneous, coated, layered or graded.
 *
 *  The profile of a contact with it is the gap before contact, the sum of both shapes (1/R = 1/R1 + 1/R2 for paraboloids), its
 *  depth the approach of distant points. Exact where both bodies are homogeneous or solved exactly (1/E0* = 1/E1* + 1/E2* of the
 *  surface materials, and compliances add at every wavelength); otherwise 1/E_eff = 1/E_eff,1 + 1/E_eff,2, which is 0 to 1 % too
 *  stiff, up to 1000 depths of the layers of an exact body, whose E_eff is sampled here. Bodies may be freed afterwards.
 *  @param lower  a medium of one body, or a rigid one
 *  @param upper  likewise; not both rigid
 *  @param out    receives the handle
 *  @return also MDR_EINVALID for pairs, and for a power-law graded body with another kind or another exponent: their springs do
 *          not add; MDR_ENOCONVERGENCE */
int mdr_medium_pair(const mdr_medium *lower, const mdr_medium *upper, mdr_medium **out);

/** Medium whose effective modulus is a table, interpolated in ln a without overshoot. States are offered from a[0] to a[n-1];
 *  below a[0] the modulus is taken as constant when forces are integrated.
 *  @param n        number of radii, at least 3
 *  @param a        [n] contact radii > 0, strictly ascending [length]
 *  @param moduli   [n] E_eff(a) > 0 [modulus]
 *  @param out      receives the handle */
int mdr_medium_table(int n, const double a[], const double moduli[], mdr_medium **out);

/** Medium whose effective modulus is a smooth function. It is sampled when the handle is made, and the samples compared with it
 *  between them: peaks narrower than 0.5 % of the radius may be missed.
 *  @param modulus          E_eff(a) > 0 [modulus]
 *  @param context          passed on to modulus, may be NULL
 *  @param smallest_radius  > 0; below it the modulus is taken as constant when forces are integrated [length]
 *  @param largest_radius   > smallest_radius [length]; states are offered between the two
 *  @param out              receives the handle
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if the function is not smooth enough to be sampled */
int mdr_medium_function(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out);

/** A quantity of a medium at many contact radii. Kernels of layered bodies are tabulated in each call for MDR_TANGENTIAL_MODULUS and
 *  MDR_TORSIONAL_STIFFNESS: give all radii at once.
 *  @param m         medium
 *  @param quantity  MDR_MODULUS, MDR_STIFFNESS, MDR_TANGENTIAL_MODULUS or MDR_TORSIONAL_STIFFNESS
 *  @param n         number of radii
 *  @param a         [n] contact radii > 0 [length]
 *  @param out       [n] values
 *  @return also MDR_EINVALID for rigid and viscoelastic media and where the quantity is not known, MDR_EDOMAIN where the medium is
 *          not defined, MDR_ENOCONVERGENCE */
int mdr_medium_values(const mdr_medium *m, int quantity, int n, const double a[], double out[]);

/** Loads of a surface. */
enum mdr_load {
    MDR_LOAD_NORMAL = 901, /**< A pressure. */
    MDR_LOAD_SHEAR = 902,  /**< A traction of one direction along the surface: the mean over the directions of the wave. */
    MDR_LOAD_TWIST = 903   /**< A traction along the surface across the wave, which one around an axis consists of. */
};

/** C(k), what the surface answers to a wave of load: displacement over traction at wavenumber k, of a pair the sum over both bodies.
 *  2/(E* k), (2 - nu)/(2 G k) and 1/(G k) of a homogeneous body. Under a traction along the wave it is twice that of MDR_LOAD_SHEAR
 *  less that of MDR_LOAD_TWIST. It makes codes that solve contacts by Fourier transforms layered. The model by which the medium
 *  solves its contacts does not matter.
 *  @param m          medium of known layers: not one given by its modulus alone, of a power of the depth, or rigid
 *  @param load       one of enum mdr_load
 *  @param omega      angular frequency at which a viscoelastic medium is taken, 0 for its relaxed one; else it does not matter
 *                    [1/time]
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0 [1/length]
 *  @param out        [n] real parts [length/modulus]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0; 0 of elastic media
 *  @return also MDR_EINVALID for other media, MDR_EDOMAIN where C is infinite, as that of a fluid at omega = 0 */
int mdr_medium_compliance(const mdr_medium *m, int load, double omega, int n, const double k[], double out[], double imaginary[]);

#ifdef __cplusplus
}
#endif

#endif
