/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file medium.h
 * Media: a body, or two, described by the effective contact modulus E_eff(a), with the stiffness k = 2 a E_eff(a), equation (10).
 * @since 0.1
 */
#ifndef MDRCONTACT_MEDIUM_H
#define MDRCONTACT_MEDIUM_H

#include "body.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A medium: a body with a model, or a pair of bodies. Created by mdr_medium_.... Immutable. */
typedef struct mdr_medium mdr_medium;

/** Models of a coated, layered or graded half-space. h is the thickness, x = a/h, xi = h/a, index 0 the coating, 1 the substrate,
 *  E* = E/(1 - nu^2). */
enum mdr_model {
    MDR_MODEL_GAO = 201,                /**< Gao's weights, moduli in parallel, equations (12)-(16); the model of Popov (2014). */
    MDR_MODEL_GAO_SERIES = 202,         /**< Gao's weights, 1/G in series; at large contrast much more accurate. */
    MDR_MODEL_DOERNER_NIX = 203,        /**< 1/E_eff = (1 - e^(-alpha xi))/E*0 + e^(-alpha xi)/E*1, equation (11). alpha is a fitted
                                             constant. */
    MDR_MODEL_WAVE = 204,               /**< Response to a wave of wavenumber q = wave_factor/a, equations (19), (20). Exact for
                                             antiplane shear. */
    MDR_MODEL_MENCIK_EXPONENTIAL = 205, /**< E_eff = E*1 + (E*0 - E*1) e^(-alpha x). alpha is a fitted constant. */
    MDR_MODEL_MENCIK_RECIPROCAL = 206,  /**< 1/E_eff = 1/E*1 + (1/E*0 - 1/E*1) e^(-alpha x). alpha is a fitted constant. */
    MDR_MODEL_BEC = 207,                /**< Bec et al. 2006: film and substrate as springs in series. */
    MDR_MODEL_PERRIOT_BARTHEL = 208,    /**< Perriot, Barthel 2004: a fit to their exact solution. */
    MDR_MODEL_HAY_CRAWFORD = 209,       /**< Hay, Crawford 2011: Gao's weights, with the film also in parallel; E_eff = 2 G_eff/(1 -
                                             nu_eff) with Gao's nu_eff. */
    MDR_MODEL_DIMITRIADIS = 210,        /**< Dimitriadis et al. 2002: layer with nu = 1/2 bonded to a rigid base, under a paraboloid
                                             or a sphere, a < h. Other cases return MDR_EINVALID. */
    MDR_MODEL_GARCIA = 211,             /**< Garcia, Garcia 2018: the same layer with their coefficients. */
    MDR_MODEL_EXACT = 212,              /**< Exact solution of the layered half-space. */
    MDR_MODEL_GAO_POWER = 213           /**< Gao's weights, power mean G_eff = [G1^p + (G0^p - G1^p) I0]^(1/p) of both moduli. */
};

/** Substrates that a model accepts. */
enum mdr_model_base {
    MDR_BASE_ELASTIC = 1301, /**< An elastic half-space. */
    MDR_BASE_ANY = 1302,     /**< An elastic half-space or a rigid base. */
    MDR_BASE_RIGID = 1303    /**< A rigid base. */
};

/** Properties of a model. */
typedef struct mdr_model_facts {
    size_t size;             /**< Size of this structure; MDR_SIZED sets it. */
    double largest_ratio;    /**< Largest valid a/h; INFINITY: no limit. */
    int base;                /**< One of enum mdr_model_base. */
    int takes_layers;        /**< 1: any number of layers; 0: one coating. */
    int takes_graded;        /**< 1: also graded half-spaces. */
    int spherical_only;      /**< 1: valid only under a paraboloid or a sphere. */
    char constant[24];       /**< Name of the member of mdr_medium_options that is a constant of the model, which a fit can
                                  determine; empty if it has none. */
    char option[24];         /**< Name of another member that the model uses; empty if it has none. */
    double default_constant; /**< Default of the member that `constant` names; 0 if it has none. */
} mdr_model_facts;

/** Return the properties of a model.
 *  @param model  one of enum mdr_model
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_model_facts facts = MDR_SIZED(mdr_model_facts);
 *  status = mdr_model_info(MDR_MODEL_DIMITRIADIS, &facts);
 *  @endcode
 */
int mdr_model_info(int model, mdr_model_facts *facts);

/** Poisson's ratio in I0 of Gao's weights, which Popov (2014) does not specify. */
enum mdr_weight_nu {
    MDR_WEIGHT_NU_SURFACE = 1201,   /**< That of the surface: the most accurate on average; the default. */
    MDR_WEIGHT_NU_SUBSTRATE = 1202, /**< Poisson's ratio of the substrate. */
    MDR_WEIGHT_NU_EFFECTIVE = 1203, /**< The effective one at the same contact radius. */
    MDR_WEIGHT_NU_GIVEN = 1204      /**< The value of weight_nu. */
};

/** Options of mdr_medium_new(): the model and its constants. A model ignores the members of other models. Initialize with
 *  MDR_SIZED. */
typedef struct mdr_medium_options {
    size_t size;           /**< Size of this structure; MDR_SIZED sets it. */
    int model;             /**< One of enum mdr_model; default MDR_MODEL_EXACT. */
    double alpha;          /**< Doerner-Nix, Mencik: decay constant > 0 [1]; default 1. */
    double wave_factor;    /**< Wave: q a > 0 [1]; default pi/2. */
    int weight_nu_choice;  /**< Gao: one of enum mdr_weight_nu; default MDR_WEIGHT_NU_SURFACE. */
    double weight_nu;      /**< Gao: the value for MDR_WEIGHT_NU_GIVEN, -1 < nu <= 1/2. */
    double tolerance;      /**< Exact: relative tolerance, 1e-12 to 1e-2; default 1e-10. */
    double exponent;       /**< Gao's power mean: p, -1 (series) to 1 (parallel), 0: the geometric mean; default -0.65. */
    int exponent_is_given; /**< Not 0: use an exponent of 0. */
} mdr_medium_options;

/** Create a homogeneous half-space from its contact modulus alone.
 *  @param contact_modulus  E* > 0 [modulus]
 *  @param out              receives the handle
 *  @code
 *  mdr_medium *half_space = NULL;
 *  status = mdr_medium_contact_modulus(80e9, &half_space);
 *  MDR_FREE(half_space);
 *  @endcode
 */
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);

/** Create a medium from a body and a model.
 *
 *  - MDR_MODEL_EXACT accepts every body. Half-spaces, power-law graded and rigid bodies need it, and so do layers that are
 *    anisotropic, prestressed or not bonded, and surfaces that are not bare.
 *  - MDR_MODEL_GAO, MDR_MODEL_GAO_SERIES and MDR_MODEL_GAO_POWER also accept several layers and graded bodies.
 *  - MDR_MODEL_DIMITRIADIS and MDR_MODEL_GARCIA need a rigid base and nu = 1/2. Of the others only MDR_MODEL_EXACT accepts a rigid
 *    base.
 *
 *  Tangential contact over a sliding interface, and subsurface stresses in layers with a prestress, are not available. Contacts
 *  with a viscoelastic body provide mdr_contact_history() and its relatives; all other functions, and a work of adhesion, return
 *  MDR_EINVALID.
 *  @param body     body; it may be freed afterwards
 *  @param options  NULL: default options, the exact solution
 *  @param out      receives the handle
 *  @return also MDR_EINVALID for a body that the model does not accept
 *  @code
 *  mdr_medium_options options = MDR_SIZED(mdr_medium_options);
 *  mdr_medium *approximate = NULL;
 *  options.model = MDR_MODEL_GAO_SERIES;
 *  status = mdr_medium_new(film, &options, &approximate);
 *  MDR_FREE(approximate);
 *  @endcode
 */
int mdr_medium_new(const mdr_body *body, const mdr_medium_options *options, mdr_medium **out);

/** Create a medium from two deformable bodies, each homogeneous, coated, layered or graded.
 *
 *  The profile of a contact with a pair is the gap before contact, the sum of both shapes (1/R = 1/R1 + 1/R2 for paraboloids). Its
 *  depth is the approach of distant points. The pair is exact if both bodies are homogeneous or have MDR_MODEL_EXACT (1/E0* = 1/E1*
 *  + 1/E2* of the surface materials, and compliances add at every wavelength). Otherwise 1/E_eff = 1/E_eff,1 + 1/E_eff,2, which is
 *  0 to 1 % too stiff, up to 1000 depths of the layers of an exact body, whose E_eff is sampled here. The media may be freed
 *  afterwards.
 *  @param lower  a medium of one body, which may be rigid
 *  @param upper  likewise; not both rigid
 *  @param out    receives the handle
 *  @return also MDR_EINVALID for pairs, and for a power-law graded body with another kind of body or another exponent, whose
 *          springs do not add; MDR_ENOCONVERGENCE
 *  @code
 *  mdr_medium *pair = NULL;
 *  status = mdr_medium_pair(medium, medium, &pair);
 *  MDR_FREE(pair);
 *  @endcode
 */
int mdr_medium_pair(const mdr_medium *lower, const mdr_medium *upper, mdr_medium **out);

/** Create a medium from a table of the effective modulus, interpolated in ln a without overshoot. Contacts reach from a[0] to
 *  a[n-1]. Below a[0] the integration of forces uses a constant modulus.
 *  @param n       number of radii, at least 3
 *  @param a       [n] contact radii > 0, strictly ascending [length]
 *  @param moduli  [n] E_eff(a) > 0 [modulus]
 *  @param out     receives the handle
 *  @code
 *  mdr_medium *measured = NULL;
 *  const double a[3] = {1e-8, 1e-7, 1e-6}, E_eff[3] = {80e9, 100e9, 150e9};
 *  status = mdr_medium_table(3, a, E_eff, &measured);
 *  MDR_FREE(measured);
 *  @endcode
 */
int mdr_medium_table(int n, const double a[], const double moduli[], mdr_medium **out);

/** Create a medium from a smooth function E_eff(a). The function is sampled when the handle is created, and the samples are checked
 *  between the nodes. Peaks narrower than 0.5 % of the radius may be missed; steps below 1e-10 of the modulus are treated as noise.
 *  @param modulus          E_eff(a) > 0 [modulus]
 *  @param context          passed to modulus, may be NULL
 *  @param smallest_radius  > 0; below it the integration of forces uses a constant modulus [length]
 *  @param largest_radius   > smallest_radius [length]; contacts reach from the smallest to the largest radius
 *  @param out              receives the handle
 *  @return also MDR_ECALLBACK; MDR_ENOCONVERGENCE if the function is not smooth enough. A contact with adhesion by the energy
 *          balance returns MDR_EINVALID if the modulus has a kink at a radius of stable states, because the edge rests there
 *  @code
 *  mdr_medium *own = NULL;
 *  status = mdr_medium_function(stiffness, NULL, 1e-8, 2e-6, &own);
 *  MDR_FREE(own);
 *  @endcode
 */
int mdr_medium_function(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out);

/** Compute a quantity of a medium at contact radii. For MDR_TANGENTIAL_MODULUS and MDR_TORSIONAL_STIFFNESS each call tabulates the
 *  kernel of a layered body, so pass all radii in one call.
 *  @param m         medium
 *  @param quantity  MDR_MODULUS, MDR_STIFFNESS, MDR_TANGENTIAL_MODULUS or MDR_TORSIONAL_STIFFNESS
 *  @param n         number of radii
 *  @param a         [n] contact radii > 0 [length]
 *  @param out       [n] values
 *  @return also MDR_EINVALID for rigid and viscoelastic media and if the quantity is not available, MDR_EDOMAIN outside the range
 *          of the medium, MDR_ENOCONVERGENCE
 *  @code
 *  const double a[2] = {1e-7, 1e-6};
 *  double E_eff[2];
 *  status = mdr_medium_values(medium, MDR_MODULUS, 2, a, E_eff);
 *  @endcode
 */
int mdr_medium_values(const mdr_medium *m, int quantity, int n, const double a[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
