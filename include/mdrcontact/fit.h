/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file fit.h
 * Fit: from measured data to the parameters of indenter, medium and instrument; docs/fitting.md. Option
 * MDRCONTACT_FIT.
 * @since 0.1
 */
#ifndef MDRCONTACT_FIT_H
#define MDRCONTACT_FIT_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** What x and y of the data are. */
enum mdr_fit_data_kind {
    MDR_FIT_FORCE_DEPTH = 1501,      /**< Indentation depth [length] and force [modulus length^2]. */
    MDR_FIT_STIFFNESS_DEPTH = 1502,  /**< Indentation depth [length] and contact stiffness > 0 [modulus length]; given the force of
                                          each point [modulus length^2] (dynamic nanoindentation). */
    MDR_FIT_MODULUS_RADIUS = 1503,   /**< Contact radius > 0 [length] and effective contact modulus [modulus]. */
    MDR_FIT_STIFFNESS_RADIUS = 1504, /**< Contact radius > 0 [length] and contact stiffness [modulus length]. */
    MDR_FIT_FORCE_TIME = 1505,       /**< Ascending times [time] and force [modulus length^2] of a viscoelastic body; given the
                                          indentation depth at each time [length], in between linear: mdr_contact_history(). */
    MDR_FIT_DEPTH_TIME = 1506,       /**< Ascending times [time] and indentation depth [length]; given the force [modulus
                                          length^2]. */
    MDR_FIT_DYNAMIC_STIFFNESS = 1507 /**< Angular frequency > 0 [1/time] and, as `branch` says of each point, MDR_STORAGE or
                                          MDR_LOSS, real or imaginary part of the dynamic stiffness [modulus length]; given the
                                          contact radius > 0 [length]: mdr_contact_dynamic_stiffness(). */
};

/** The parameters of the instrument, by their place behind those of indenter, medium and counterbody: indices, not codes. */
enum mdr_fit_instrument {
    MDR_FIT_WORK_OF_ADHESION = 0,     /**< gamma >= 0; the search begins above 0 [modulus length]. */
    MDR_FIT_DEPTH_OFFSET = 1,         /**< Depth that the instrument reads at first contact [length]. */
    MDR_FIT_FORCE_OFFSET = 2,         /**< Force that it reads there [modulus length^2]. */
    MDR_FIT_FRAME_COMPLIANCE = 3,     /**< Of the instrument's frame [1/(modulus length)]. */
    MDR_FIT_INDENTER_MODULUS = 4,     /**< Contact modulus E*_i of the indenter > 0; INFINITY: rigid. Homogeneous, and paired
                                           with the medium as by mdr_medium_pair() [modulus]. */
    MDR_FIT_CONTACT_DEPTH_FACTOR = 5, /**< epsilon of the contact depth h_c = h - epsilon P/S on a half-space (Oliver, Pharr 1992);
                                           usually 0.75, that of a paraboloid; 0 or less where the surface piles up. On any other body
                                           the surface sinks in as under the same indenter c r^n: by (d - f(a)) k/F of the exact
                                           contact in place of epsilon [1]. */
    MDR_FIT_STIFFNESS_FACTOR = 6,     /**< beta of S = 2 beta a E_r; usually 1 [1]. */
    MDR_FIT_CONTACT_DEPTH_SCALE = 7,  /**< Factor of h_c, usually 1; 1.2 with epsilon = 1: Loubet's contact depth [1]. */
    MDR_FIT_AREA_FACTOR = 8,          /**< True over assumed projected contact area, for all data but force against depth; usually
                                           1 [1]. */
    MDR_FIT_COHESIVE_STRESS = 9,      /**< sigma_0 >= 0: adhesion with a range, as in mdr_contact_options; 0: a range of nothing
                                           [modulus]. */
    MDR_FIT_INSTRUMENT_COUNT = 10     /**< How many there are. */
};

/** How residuals r, in standard deviations, count; s is loss_scale. */
enum mdr_fit_loss {
    MDR_FIT_LINEAR = 1601, /**< r^2: least squares. */
    MDR_FIT_HUBER = 1602,  /**< r^2 up to s, then growing in proportion to r. */
    MDR_FIT_CAUCHY = 1603  /**< s^2 ln(1 + r^2/s^2). */
};

/** One parameter of the problem, in its own unit. */
typedef struct mdr_fit_parameter {
    double value;    /**< The value, or where the search begins. */
    double lower;    /**< Lower bound of a free one; -INFINITY for none. */
    double upper;    /**< Upper bound of a free one, > lower; INFINITY for none. */
    double prior;    /**< The value known beforehand. */
    double prior_sd; /**< Standard deviation of the prior >= 0; 0: nothing is known. */
    int is_free;     /**< 0: fixed; else the fit may change it. */
    char name[48];   /**< Its name, see mdr_fit_parameters(); not read. */
} mdr_fit_parameter;

/** The question of a fit. Begun by MDR_SIZED. Handles and parameters are only read, during the call. The handles are patterns: the
 *  fit takes objects of their kind, with the same layers, models and options, whose numbers are the parameters. */
typedef struct mdr_fit_problem {
    size_t size;                         /**< Of this structure; MDR_SIZED sets it. */
    int data_kind;                       /**< One of enum mdr_fit_data_kind; default MDR_FIT_FORCE_DEPTH. */
    const mdr_profile *profile;          /**< The indenter. */
    const mdr_medium *medium;            /**< What it presses on; a pair has no parameters. */
    const mdr_medium *counterbody;       /**< The upper one of two deformable bodies, as in mdr_medium_pair(); NULL (default): the
                                              indenter is rigid, or MDR_FIT_INDENTER_MODULUS says how stiff. */
    int adhesion_rule;                   /**< One of enum mdr_adhesion_rule; default MDR_ADHESION_AUTOMATIC. */
    int loss;                            /**< One of enum mdr_fit_loss; default MDR_FIT_LINEAR. */
    double loss_scale;                   /**< Standard deviations > 0 beyond which a residual counts less; default 1.345. */
    int sd_is_relative;                  /**< Not 0: of the standard deviations of the data only the ratios are known; default 0. */
    int max_iterations;                  /**< Of one search, at least 1; default 100. */
    int any_units;                       /**< 0: data more than 300 times larger or smaller than the model at the start are refused;
                                              default 0. */
    int parameter_count;                 /**< How many parameters there are. */
    const mdr_fit_parameter *parameters; /**< [parameter_count] in the order of mdr_fit_parameters(). */
    int prior_count;                     /**< Rows of prior_weights >= 0; default 0. */
    const double *prior_weights;         /**< [prior_count][parameter_count] what is known of several parameters together: the sum
                                              over j of weight j times (value - prior) of parameter j has mean 0 and variance 1. For
                                              a covariance C = L L^T the rows are those of the inverse of L. NULL: none. */
    const int *branch;                   /**< [n] of enum mdr_branch; NULL: all points on one branch, down to pull-off. Matters
                                              with adhesion, where the bodies part at pull-off and read the force offset from there.
                                              In a fit the readings say which points are in contact, in mdr_fit_predict() the
                                              model does. For MDR_FIT_DYNAMIC_STIFFNESS MDR_STORAGE or MDR_LOSS. */
    int is_elastic;                      /**< Of MDR_FIT_STIFFNESS_DEPTH: 1: nothing has yielded, loading and unloading are one curve,
                                              and the surface sinks in as under the indenter itself; 0 (default): it sinks in as
                                              under the smooth indenter that MDR_FIT_CONTACT_DEPTH_FACTOR stands for. */
} mdr_fit_problem;

/** What supports a fit or makes it doubtful. */
typedef struct mdr_fit_summary {
    size_t size;               /**< Of this structure; MDR_SIZED sets it. */
    int converged;             /**< 1, or 0: the parameters are the best point found. */
    int iterations;            /**< Steps of the search. */
    int evaluations;           /**< How often the model was computed at all data. */
    double chi_square;         /**< Sum of the squared residuals of the data, in their standard deviations. */
    double prior_chi_square;   /**< The same of the priors. */
    double degrees_of_freedom; /**< Number of data less that of the parameters they determine. */
    double noise;              /**< Factor of the standard deviations of the data: 1 if they are known, else estimated. */
    double log_likelihood;     /**< Of the data and the priors, at the estimates. */
    double pattern_probability; /**< Probability that random residuals follow each other as smoothly (Bartels 1982); 1 for n < 8. */
    double weakest;            /**< Smallest eigenvalue of the correlation of the derivatives: 1: the parameters are independent;
                                    0: the data do not determine a combination of them (below 1e-12: rounding), and its
                                    variance is beyond all measure: standard errors of about a thousand times the values. */
    double lag_correlation;    /**< Correlation of neighbouring residuals along the curve; standard errors allow for it. */
} mdr_fit_summary;

/** The parameters of a problem, fixed at the values that its objects have: those of the indenter, of the medium and of the
 *  counterbody, and then, by enum mdr_fit_instrument, those of an instrument that reads what is.
 *
 *  An indenter has the arguments of its function, "indenter.radius", of an area function its coefficients, "indenter.C0"; tables,
 *  callbacks and sums have none. An elastic half-space has "E", "nu"; layers from the surface down each "layers[0].E" and
 *  "layers[0].nu", or the constants of mdr_layer as they were given, then thickness, prestress, interface.normal and
 *  interface.tangential, K_n and K_t of the interface below (INFINITY: bonded; K_t 0: it slides); "substrate.E" and so on unless
 *  the base is rigid; a graded body "z[0]", "E[0]", "nu[0]" at each depth, a power law E0, z0, exponent, nu; then alpha, wave_factor
 *  or exponent of a model that has one; then "surface.tension", "surface.bending" and "surface.stretching" where the surface is not
 *  bare. Of a viscoelastic material E, nu, or modulus, time, exponent, nu, or relaxed_shear_modulus, "terms[0].modulus" and
 *  "terms[0].time", viscosity, and bulk_modulus or nu. Names of a counterbody begin with "upper.".
 *  @param problem   problem; its parameters need not be there yet
 *  @param capacity  room in `out` >= 0
 *  @param out       [capacity] receives the first of them; NULL where capacity is 0
 *  @param count     receives how many there are */
int mdr_fit_parameters(const mdr_fit_problem *problem, int capacity, mdr_fit_parameter out[], int *count);

/** Fits. A search that does not converge is no failure: it returns its best point, and says so in the summary. Outputs that are
 *  NULL are skipped; m is parameter_count.
 *  @param problem            problem; at least one parameter is free
 *  @param n                  number of points, at least 1 and as many as free parameters without a prior; one more if `sd` is not
 *                            known and absolute
 *  @param x                  [n] see enum mdr_fit_data_kind; in any order, not all equal unless one point is enough
 *  @param y                  [n] see enum mdr_fit_data_kind; not all equal unless one point is enough
 *  @param given              [n] what else is known of each point, see enum mdr_fit_data_kind; NULL where nothing is
 *  @param sd                 [n] standard deviations of y > 0, in its unit; NULL: equal and unknown
 *  @param values             [m] or NULL: all parameters, each in its unit
 *  @param covariance         [m m] or NULL: their covariance, 0 for fixed ones; symmetric
 *  @param widening           [m] or NULL: how much larger their standard errors are because neighbouring residuals are correlated,
 *                            at least 1; the covariance holds it already
 *  @param at_bound           [m] or NULL: -1 or 1 for a parameter at its lower or upper bound, else 0
 *  @param weakest_direction  [m] or NULL: the relative change of the free parameters that the data determine least
 *  @param fitted             [n] or NULL: the model at the data, in the unit of y
 *  @param residuals          [n] or NULL: (y - model)/standard deviation [1]
 *  @param summary            or NULL; begun by MDR_SIZED: what supports the fit or makes it doubtful
 *  @return MDR_EINVALID also for data in other units than the start, or too few; what the model answers at the start */
int mdr_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                  const double sd[], double values[], double covariance[], double widening[], int at_bound[],
                  double weakest_direction[], double fitted[], double residuals[], mdr_fit_summary *summary);

/** What the instrument reads if each parameter is its `value`. Data as for mdr_fit_solve().
 *  @param problem  problem
 *  @param n        number of points
 *  @param x        [n] see enum mdr_fit_data_kind
 *  @param y        [n] readings; they enter where the frame compliance is not 0, and for MDR_FIT_STIFFNESS_DEPTH
 *  @param given    [n] or NULL, as for mdr_fit_solve()
 *  @param fitted   [n] the model, in the unit of y
 *  @param radius   [n] or NULL: the contact radii, 0 out of contact; for MDR_FIT_STIFFNESS_DEPTH those of the tip at the contact
 *                  depth, see MDR_FIT_CONTACT_DEPTH_FACTOR and `is_elastic`, with the area factor [length]
 *  @return also what the model answers: MDR_EUNREACHABLE, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                    double fitted[], double radius[]);

/** Profile-likelihood interval of one free parameter: the values at which the weighted sum of squares, minimal over all other free
 *  ones, exceeds its minimum by the quantile of that level (chi-square with one degree of freedom, or F where the noise is
 *  estimated). An end beyond a bound is the bound; one that does not exist is infinite. Data as for mdr_fit_solve().
 *  @param problem   problem
 *  @param n         number of points
 *  @param x         [n] see enum mdr_fit_data_kind
 *  @param y         [n] see enum mdr_fit_data_kind
 *  @param given     [n] or NULL, as for mdr_fit_solve()
 *  @param sd        [n] or NULL, as for mdr_fit_solve()
 *  @param position  index among the parameters, from 0
 *  @param level     of confidence, 0 < level < 1
 *  @param lower     receives the lower end, in the parameter's unit
 *  @param upper     receives the upper end, in the parameter's unit
 *  @return as mdr_fit_solve() */
int mdr_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                     const double sd[], int position, double level, double *lower, double *upper);

/** Half the width of a confidence interval in standard errors: the quantile of Student's t, of the normal distribution for
 *  degrees_of_freedom = INFINITY (known standard deviations of the data).
 *  @param level               of confidence, 0 < level < 1
 *  @param degrees_of_freedom  > 0, see mdr_fit_summary
 *  @param factor              receives it [1]
 *  @return also MDR_ENOCONVERGENCE where it is not found or beyond all numbers, near the ends of both ranges */
int mdr_fit_quantile(double level, double degrees_of_freedom, double *factor);

#ifdef __cplusplus
}
#endif

#endif
