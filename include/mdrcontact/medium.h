/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file medium.h
 * Media: effective contact modulus E_eff(a), stiffness k = 2 a E_eff(a), equation (10).
 * @since 0.1
 */
#ifndef MDRCONTACT_MEDIUM_H
#define MDRCONTACT_MEDIUM_H

#include "body.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What is pressed: a body under a model, or two. Made by mdr_medium_.... */
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

/** The model, and what it leaves to choose. Begun by MDR_SIZED; a model looks only at what concerns it. */
typedef struct mdr_medium_options {
    size_t size;          /**< Of this structure; MDR_SIZED sets it. */
    int model;            /**< One of enum mdr_model; default MDR_MODEL_EXACT. */
    double alpha;         /**< Doerner-Nix, Mencik: decay constant > 0 [1]; default 1. */
    double wave_factor;   /**< Wave: q a > 0 [1]; default pi/2. */
    int weight_nu_choice; /**< Gao: one of enum mdr_weight_nu; default MDR_WEIGHT_NU_SURFACE. */
    double weight_nu;     /**< Gao: the number for MDR_WEIGHT_NU_GIVEN, -1 < nu <= 1/2. */
    double tolerance;     /**< Exact: relative tolerance, 1e-12 to 1e-2; default 1e-10. */
    double exponent;      /**< Gao's power mean: p, -1 (series) to 1 (parallel), 0 for the logarithm's; default -0.65. */
    int exponent_is_given; /**< Not 0: an exponent of 0 is meant. */
} mdr_medium_options;

/** Homogeneous half-space of given contact modulus, whatever its E and nu.
 *  @param contact_modulus  E* > 0 [modulus]
 *  @param out              receives the handle */
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);

/** A body under a model. What is not isotropic, bonded and free of stress, and a surface that is not bare, takes MDR_MODEL_EXACT; more than
 *  one layer that, MDR_MODEL_GAO, ..._GAO_SERIES or ..._GAO_POWER; a graded body likewise. MDR_MODEL_DIMITRIADIS and MDR_MODEL_GARCIA
 *  demand a rigid base and nu = 1/2, MDR_MODEL_EXACT allows one, the others refuse it. Half-spaces, bodies of a power of the depth and
 *  rigid ones take MDR_MODEL_EXACT. A tangential contact over a sliding interface is refused, as stresses inside layers under a
 *  prestress are. Contacts with a viscoelastic body answer mdr_contact_history(); everything else returns MDR_EINVALID and says so,
 *  work of adhesion included.
 *  @param body     body; it may be freed afterwards
 *  @param options  NULL for the defaults: the exact solution
 *  @param out      receives the handle */
int mdr_medium_new(const mdr_body *body, const mdr_medium_options *options, mdr_medium **out);

/** Two deformable bodies as one medium: what presses and what is pressed, each homogeneous, coated, layered or graded.
 *
 *  The profile of a contact with it is the gap before contact, the sum of both shapes (1/R = 1/R1 + 1/R2 for paraboloids), its
 *  depth the approach of distant points. Exact where both bodies are homogeneous or solved exactly (1/E0* = 1/E1* + 1/E2* of the
 *  surface materials, and compliances add at every wavelength); otherwise 1/E_eff = 1/E_eff,1 + 1/E_eff,2, which is 0 to 1 % too
 *  stiff, up to 1000 depths of the layers of an exact body, whose E_eff is sampled here. Bodies may be freed afterwards.
 *  @param lower  a medium of one body, or of a rigid one
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
 *  between them: peaks narrower than 0.5 % of the radius may be missed, steps below 1e-10 of the modulus are taken for noise. Adhesion
 *  by the energy balance is refused where the modulus has a kink at a radius of stable contacts: the edge rests there.
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

#ifdef __cplusplus
}
#endif

#endif
