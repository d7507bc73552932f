/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file fit.h
 * Fits of measured data: parameters of indenter, medium and instrument; docs/fit.md. Option MDRCONTACT_FIT.
 * @since 0.1
 */
#ifndef MDRCONTACT_FIT_H
#define MDRCONTACT_FIT_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Quantities x and y of the data. */
enum mdr_fit_data_kind {
    MDR_FIT_FORCE_DEPTH = 1501,      /**< Indentation depth [length] and force [modulus length^2]. */
    MDR_FIT_STIFFNESS_DEPTH = 1502,  /**< Indentation depth [length] and contact stiffness > 0 [modulus length]; `given`: force at
                                          each point [modulus length^2] (dynamic nanoindentation). */
    MDR_FIT_MODULUS_RADIUS = 1503,   /**< Contact radius > 0 [length] and effective contact modulus [modulus]. */
    MDR_FIT_STIFFNESS_RADIUS = 1504, /**< Contact radius > 0 [length] and contact stiffness [modulus length]. */
    MDR_FIT_FORCE_TIME = 1505,       /**< Ascending times [time] and force [modulus length^2] of a viscoelastic body; `given`:
                                          indentation depth at each time [length], linear in between, see mdr_contact_history(). */
    MDR_FIT_DEPTH_TIME = 1506,       /**< Ascending times [time] and indentation depth [length]; `given`: force [modulus
                                          length^2]. */
    MDR_FIT_DYNAMIC_STIFFNESS = 1507 /**< Angular frequency > 0 [1/time] and real or imaginary part of the dynamic stiffness
                                          [modulus length], selected for each point by `branch`: MDR_STORAGE or MDR_LOSS; `given`:
                                          contact radius > 0 [length]; see mdr_contact_dynamic_stiffness(). */
};

/** Parameters of the instrument, by their position after those of indenter, medium and counterbody. They are indices, not codes. */
enum mdr_fit_instrument {
    MDR_FIT_WORK_OF_ADHESION = 0,     /**< gamma >= 0; the start value must exceed 0 [modulus length]. */
    MDR_FIT_DEPTH_OFFSET = 1,         /**< Depth reading at initial contact [length]. */
    MDR_FIT_FORCE_OFFSET = 2,         /**< Force reading at initial contact [modulus length^2]. */
    MDR_FIT_FRAME_COMPLIANCE = 3,     /**< Compliance of the instrument frame [1/(modulus length)]. */
    MDR_FIT_INDENTER_MODULUS = 4,     /**< Contact modulus E*_i of the indenter > 0, homogeneous, combined with the medium as in
                                           mdr_medium_pair(); INFINITY: rigid [modulus]. */
    MDR_FIT_CONTACT_DEPTH_FACTOR = 5, /**< epsilon of the contact depth h_c = h - epsilon P/S on a half-space (Oliver, Pharr 1992);
                                           usually 0.75, that of a paraboloid; 0 or less for pile-up. On any other body the sink-in
                                           is that of the same indenter c r^n: (d - f(a)) k/F of the exact contact replaces epsilon
                                           [1]. */
    MDR_FIT_STIFFNESS_FACTOR = 6,     /**< beta of S = 2 beta a E_r; usually 1 [1]. */
    MDR_FIT_CONTACT_DEPTH_SCALE = 7,  /**< Factor of h_c, usually 1; 1.2 with epsilon = 1: Loubet's contact depth [1]. */
    MDR_FIT_AREA_FACTOR = 8,          /**< Ratio of the true to the assumed projected contact area, for all data except force
                                           against depth; usually 1 [1]. */
    MDR_FIT_COHESIVE_STRESS = 9,      /**< sigma_0 >= 0: finite-range adhesion, as in mdr_contact_options; 0: the JKR limit
                                           [modulus]. */
    MDR_FIT_INSTRUMENT_COUNT = 10     /**< Number of parameters of the instrument. */
};

/** Contribution of a residual r, in standard deviations, to the sum; s is loss_scale. */
enum mdr_fit_loss {
    MDR_FIT_LINEAR = 1601, /**< r^2: least squares. */
    MDR_FIT_HUBER = 1602,  /**< r^2 up to s, linear in r beyond. */
    MDR_FIT_CAUCHY = 1603  /**< s^2 ln(1 + r^2/s^2). */
};

/** A parameter of the problem, in its own unit. */
typedef struct mdr_fit_parameter {
    double value;    /**< The value, or the start value of the search. */
    double lower;    /**< Lower bound of a free parameter; -INFINITY: none. */
    double upper;    /**< Upper bound of a free parameter, > lower; INFINITY: none. */
    double prior;    /**< Mean of the prior. */
    double prior_sd; /**< Standard deviation of the prior >= 0; 0: no prior. */
    int is_free;     /**< 0: fixed; otherwise free. */
    char name[48];   /**< Its name, see mdr_fit_parameters(); ignored on input. */
} mdr_fit_parameter;

/** A fit problem. Initialize with MDR_SIZED. Handles and parameters are read during the call only. The handles are patterns: the
 *  fit uses objects of the same kind, with the same layers, models and options, whose numbers are the parameters. */
typedef struct mdr_fit_problem {
    size_t size;                         /**< Size of this structure; MDR_SIZED sets it. */
    int data_kind;                       /**< One of enum mdr_fit_data_kind; default MDR_FIT_FORCE_DEPTH. */
    const mdr_profile *profile;          /**< The indenter. */
    const mdr_medium *medium;            /**< The medium; a pair has no parameters. */
    const mdr_medium *counterbody;       /**< The upper of two deformable bodies, as in mdr_medium_pair(); NULL (default): the
                                              indenter is rigid, or MDR_FIT_INDENTER_MODULUS gives its modulus. */
    int adhesion_rule;                   /**< One of enum mdr_adhesion_rule; default MDR_ADHESION_AUTOMATIC. */
    int loss;                            /**< One of enum mdr_fit_loss; default MDR_FIT_LINEAR. */
    double loss_scale;                   /**< Number of standard deviations > 0 beyond which a residual contributes less; default
                                              1.345. */
    int sd_is_relative;                  /**< Not 0: only the ratios of the standard deviations of the data are known; default 0. */
    int max_iterations;                  /**< Maximum number of iterations of one search, at least 1; default 100. */
    int any_units;                       /**< 0: data more than 300 times larger or smaller than the model at the start return
                                              MDR_EINVALID; default 0. */
    int parameter_count;                 /**< Number of parameters. */
    const mdr_fit_parameter *parameters; /**< [parameter_count] in the order of mdr_fit_parameters(). */
    int prior_count;                     /**< Number of rows of prior_weights >= 0; default 0. */
    const double *prior_weights;         /**< [prior_count][parameter_count] joint priors: the sum over j of weight j times (value -
                                              prior) of parameter j has mean 0 and variance 1. For a covariance C = L L^T the rows
                                              are those of the inverse of L. NULL: none. */
    const int *branch;                   /**< [n] of enum mdr_branch; NULL: all points on one branch, down to pull-off. It matters
                                              with adhesion: after pull-off the readings are the force offset. In a fit the readings
                                              determine which points are in contact, in mdr_fit_predict() the model does. For
                                              MDR_FIT_DYNAMIC_STIFFNESS MDR_STORAGE or MDR_LOSS. */
    int is_elastic;                      /**< For MDR_FIT_STIFFNESS_DEPTH: 1: nothing has yielded, loading and unloading coincide,
                                              and the sink-in is that of the indenter itself. 0 (default): the sink-in is that of
                                              the smooth indenter that MDR_FIT_CONTACT_DEPTH_FACTOR represents. */
} mdr_fit_problem;

/** Statistics of a fit. */
typedef struct mdr_fit_summary {
    size_t size;                /**< Size of this structure; MDR_SIZED sets it. */
    int converged;              /**< 1, or 0: the parameters are the best point found. */
    int iterations;             /**< Steps of the search. */
    int evaluations;            /**< Number of evaluations of the model at all data. */
    double chi_square;          /**< Sum of the squared residuals of the data, in their standard deviations. */
    double prior_chi_square;    /**< The same of the priors. */
    double degrees_of_freedom;  /**< Number of data minus the number of parameters that they determine. */
    double noise;               /**< Factor of the standard deviations of the data: 1 if they are known, otherwise estimated. */
    double log_likelihood;      /**< Log-likelihood of data and priors at the estimates. */
    double pattern_probability; /**< Probability that random residuals form a pattern at least as smooth: Durbin and Watson (1950)
                                     for n < 50 with the linear loss, otherwise Bartels (1982); 1 if they are too few. */
    double weakest;             /**< Smallest eigenvalue of the correlation of the derivatives. 1: the parameters are independent.
                                     0: the data do not determine a combination of them (below 1e-12, the rounding error), and
                                     standard errors are about a thousand times the values. */
    double lag_correlation;     /**< Correlation of neighbouring residuals along the curve; standard errors account for it. */
} mdr_fit_summary;

/** List the parameters of a problem, fixed at the values of its objects: those of the indenter, of the medium and of the
 *  counterbody, then those of an ideal instrument in the order of enum mdr_fit_instrument.
 *
 *  - An indenter has the arguments of its function, "indenter.radius", and of an area function its coefficients, "indenter.C0".
 *    Tables, user functions and sums have none.
 *  - A half-space has "E" and "nu". Layers, top to bottom, each have "layers[0].E" and "layers[0].nu", or the constants of
 *    mdr_layer that were given, then thickness, prestress, interface.normal and interface.tangential, K_n and K_t of the interface
 *    below (INFINITY: bonded; K_t 0: sliding). "substrate.E" and so on follow unless the base is rigid.
 *  - A graded body has "z[0]", "E[0]", "nu[0]" at each depth; a power law E0, z0, exponent, nu.
 *  - A model adds its constant alpha, wave_factor or exponent, a surface that is not bare "surface.tension", "surface.bending" and
 *    "surface.stretching".
 *  - A viscoelastic material has E, nu, or modulus, time, exponent, nu, or relaxed_shear_modulus, "terms[0].modulus" and
 *    "terms[0].time", viscosity, and bulk_modulus or nu.
 *  - Names of a counterbody begin with "upper.".
 *  @param problem   problem; its parameters may be missing
 *  @param capacity  size of `out` >= 0
 *  @param out       [capacity] receives the first parameters; NULL if capacity is 0
 *  @param count     receives the number of parameters
 *  @code
 *  mdr_fit_parameter parameters[20];
 *  int count;
 *  status = mdr_fit_parameters(&problem, 20, parameters, &count);
 *  @endcode
 */
int mdr_fit_parameters(const mdr_fit_problem *problem, int capacity, mdr_fit_parameter out[], int *count);

/** Fit. A search that does not converge is not a failure: the call returns its best point, and sets `converged` of the summary to
 *  0. Outputs that are NULL are skipped; m is parameter_count.
 *  @param problem            problem with at least one free parameter
 *  @param n                  number of points, at least 1 and at least the number of free parameters without a prior; one more
 *                            unless `sd` is known and absolute
 *  @param x                  [n] see enum mdr_fit_data_kind; in any order, not all equal unless one point suffices
 *  @param y                  [n] see enum mdr_fit_data_kind; not all equal unless one point suffices
 *  @param given              [n] a further quantity of each point, see enum mdr_fit_data_kind; NULL if the kind has none
 *  @param sd                 [n] standard deviations of y > 0, in its unit; NULL: equal and unknown
 *  @param values             [m] or NULL: all parameters, each in its unit
 *  @param covariance         [m m] or NULL: their covariance, 0 for fixed ones; symmetric
 *  @param widening           [m] or NULL: factors >= 1 by which standard errors increase because neighbouring residuals are
 *                            correlated; the covariance includes them
 *  @param at_bound           [m] or NULL: -1 or 1 for a parameter at its lower or upper bound, otherwise 0
 *  @param weakest_direction  [m] or NULL: relative change of the free parameters that the data determine least
 *  @param fitted             [n] or NULL: model at the data, in the unit of y
 *  @param residuals          [n] or NULL: (y - model)/standard deviation [1]
 *  @param summary            or NULL; initialize with MDR_SIZED: statistics of the fit
 *  @return MDR_EINVALID also for data in units other than those of the start, or too few; errors of the model at the start
 *  @code
 *  double fitted[20];
 *  mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
 *  status = mdr_fit_solve(&problem, 20, x, y, NULL, NULL, NULL, NULL, NULL, NULL, NULL, fitted, NULL, &summary);
 *  @endcode
 */
int mdr_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                  const double sd[], double values[], double covariance[], double widening[], int at_bound[],
                  double weakest_direction[], double fitted[], double residuals[], mdr_fit_summary *summary);

/** Compute the reading of the instrument with each parameter at its `value`. Data as for mdr_fit_solve().
 *  @param problem  problem
 *  @param n        number of points
 *  @param x        [n] see enum mdr_fit_data_kind
 *  @param y        [n] readings; used if the frame compliance is not 0, and for MDR_FIT_STIFFNESS_DEPTH
 *  @param given    [n] or NULL, as for mdr_fit_solve()
 *  @param fitted   [n] the model, in the unit of y
 *  @param radius   [n] or NULL: contact radii, 0 without contact; for MDR_FIT_STIFFNESS_DEPTH those of the tip at the contact
 *                  depth, see MDR_FIT_CONTACT_DEPTH_FACTOR and `is_elastic`, with the area factor [length]
 *  @return also errors of the model: MDR_EUNREACHABLE, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  double fitted[20];
 *  status = mdr_fit_predict(&problem, 20, x, y, NULL, fitted, NULL);
 *  @endcode
 */
int mdr_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                    double fitted[], double radius[]);

/** Compute the profile-likelihood interval of one free parameter: the values at which the weighted sum of squares, minimized over
 *  all other free ones, exceeds its minimum by the quantile of the level (chi-square with one degree of freedom, or F if the noise
 *  is estimated). An end beyond a bound is the bound; an end that does not exist is infinite. Data as for mdr_fit_solve().
 *  @param problem   problem
 *  @param n         number of points
 *  @param x         [n] see enum mdr_fit_data_kind
 *  @param y         [n] see enum mdr_fit_data_kind
 *  @param given     [n] or NULL, as for mdr_fit_solve()
 *  @param sd        [n] or NULL, as for mdr_fit_solve()
 *  @param position  index of the parameter, from 0
 *  @param level     of confidence, 0 < level < 1
 *  @param lower     receives the lower end, in the unit of the parameter
 *  @param upper     receives the upper end, in the unit of the parameter
 *  @return as mdr_fit_solve()
 *  @code
 *  double lower, upper;
 *  status = mdr_fit_interval(&problem, 20, x, y, NULL, NULL, free_parameter, 0.95, &lower, &upper);
 *  @endcode
 */
int mdr_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[],
                     const double sd[], int position, double level, double *lower, double *upper);

/** Compute half the width of a confidence interval in standard errors: the quantile of Student's t, or of the normal distribution
 *  for degrees_of_freedom = INFINITY (known standard deviations of the data).
 *  @param level               of confidence, 0 < level < 1
 *  @param degrees_of_freedom  > 0, see mdr_fit_summary
 *  @param factor              receives the quantile [1]
 *  @return also MDR_ENOCONVERGENCE if the quantile is not found or out of range, near the ends of both ranges
 *  @code
 *  double factor;
 *  status = mdr_fit_quantile(0.95, 8.0, &factor);
 *  @endcode
 */
int mdr_fit_quantile(double level, double degrees_of_freedom, double *factor);

#ifdef __cplusplus
}
#endif

#endif
