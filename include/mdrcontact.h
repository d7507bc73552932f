/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact.h
 * Contact of real, coated, layered and graded bodies, computed in one dimension.
 */
#ifndef MDRCONTACT_H
#define MDRCONTACT_H

#ifdef __cplusplus
extern "C" {
#endif

#define MDR_VERSION_MAJOR 0
#define MDR_VERSION_MINOR 1
#define MDR_VERSION_PATCH 0

/* ---- status ------------------------------------------------------------------------------------------------- */
enum mdr_status {
    MDR_SUCCESS = 0,
    MDR_ENULL = 1,
    MDR_EINVALID = 2,
    MDR_EDOMAIN = 3,
    MDR_EUNREACHABLE = 4,
    MDR_ENOCONVERGENCE = 5,
    MDR_ENOMEMORY = 6,
    MDR_ECALLBACK = 7,
    MDR_EFILE = 8
};

int mdr_version(void);                                   /* 10000 major + 100 minor + patch */
const char *mdr_status_name(int status);
int mdr_last_error(char *buffer, int length);            /* thread-local text; returns its full length */

typedef struct mdr_profile mdr_profile;
typedef struct mdr_medium mdr_medium;
typedef struct mdr_contact mdr_contact;

/** A user function y = f(x): writes *y and returns 0, or returns another value to report failure. Called during creation only. */
typedef int (*mdr_function)(double x, double *y, void *context);

/* ---- profiles (theory 1) ------------------------------------------------------------------------------------- */
int mdr_profile_paraboloid(double radius, mdr_profile **out);
int mdr_profile_sphere(double radius, mdr_profile **out);
int mdr_profile_cone(double inclination, mdr_profile **out);
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out);
int mdr_profile_flat_punch(double radius, mdr_profile **out);
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);
/* A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., up to height max_height; below min_height (0: none) A is continued linearly to 0 */
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out);
int mdr_profile_table(int n, const double r[], const double f[], mdr_profile **out);
int mdr_profile_callback(mdr_function height, void *context, double largest_radius, mdr_profile **out);
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);

int mdr_profile_height(const mdr_profile *p, int n, const double r[], double out[]);
int mdr_profile_slope(const mdr_profile *p, int n, const double r[], double out[]);
int mdr_profile_mdr(const mdr_profile *p, int n, const double x[], double out[]);
int mdr_profile_mdr_slope(const mdr_profile *p, int n, const double x[], double out[]);
/* f from sampled g, theory 1, second formula: the profile whose MDR profile is the table g(x) */
int mdr_profile_from_mdr_table(int n, const double x[], const double g[], mdr_profile **out);
int mdr_profile_free(mdr_profile **p);

/* ---- media (theory 3) ---------------------------------------------------------------------------------------- */
enum mdr_model {
    MDR_MODEL_GAO = 0,                 /* Gao weights, moduli in parallel: the source's (12)-(15) */
    MDR_MODEL_GAO_SERIES = 1,          /* Gao weights, compliances in series */
    MDR_MODEL_DOERNER_NIX = 2,
    MDR_MODEL_WAVE = 3,
    MDR_MODEL_MENCIK_EXPONENTIAL = 4,
    MDR_MODEL_MENCIK_RECIPROCAL = 5,
    MDR_MODEL_BEC = 6,
    MDR_MODEL_PERRIOT_BARTHEL = 7,
    MDR_MODEL_HAY_CRAWFORD = 8,
    MDR_MODEL_DIMITRIADIS = 9,         /* rigid base, nu = 1/2, paraboloid */
    MDR_MODEL_GARCIA = 10,             /* rigid base, nu = 1/2, paraboloid */
    MDR_MODEL_EXACT = 11
};
enum mdr_weight_nu {                   /* which Poisson's ratio enters I0 of the Gao weights */
    MDR_WEIGHT_NU_SURFACE = 0,
    MDR_WEIGHT_NU_SUBSTRATE = 1,
    MDR_WEIGHT_NU_EFFECTIVE = 2,
    MDR_WEIGHT_NU_GIVEN = 3
};
typedef struct mdr_medium_options {
    double alpha;                      /* Doerner-Nix, Mencik exponentials: decay constant, default 1 */
    double wave_factor;                /* wave: q = wave_factor/a, default pi/2 */
    int weight_nu_choice;              /* Gao: enum mdr_weight_nu, default MDR_WEIGHT_NU_SURFACE */
    double weight_nu;                  /* Gao: the number for MDR_WEIGHT_NU_GIVEN */
    double tolerance;                  /* exact and sampled media: relative tolerance, default 1e-10 */
} mdr_medium_options;
void mdr_medium_options_init(mdr_medium_options *options);

int mdr_medium_homogeneous(double E, double nu, mdr_medium **out);
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);
/* substrate_E = INFINITY is a rigid base: MDR_MODEL_EXACT, DIMITRIADIS, GARCIA only */
int mdr_medium_coated(double coating_E, double coating_nu, double thickness, double substrate_E, double substrate_nu,
                      int model, const mdr_medium_options *options, mdr_medium **out);
/* layers from the surface down; model GAO, GAO_SERIES or EXACT */
int mdr_medium_layered(int n, const double E[], const double nu[], const double thickness[],
                       double substrate_E, double substrate_nu, int model, const mdr_medium_options *options, mdr_medium **out);
/* E and nu at ascending depths z[0] = 0 ... z[n-1], linear between them, constant below; model GAO, GAO_SERIES or EXACT */
int mdr_medium_graded(int n, const double z[], const double E[], const double nu[], int model,
                      const mdr_medium_options *options, mdr_medium **out);
/* E(z) and nu(z) as functions on [0, depth], constant below */
int mdr_medium_graded_callback(mdr_function E, mdr_function nu, void *context, double depth, int model,
                               const mdr_medium_options *options, mdr_medium **out);
int mdr_medium_power_graded(double E0, double z0, double exponent, double nu, mdr_medium **out);
int mdr_medium_table(int n, const double a[], const double modulus[], mdr_medium **out);
int mdr_medium_callback(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out);

int mdr_medium_modulus(const mdr_medium *m, int n, const double a[], double out[]);
int mdr_medium_stiffness(const mdr_medium *m, int n, const double a[], double out[]);
int mdr_medium_free(mdr_medium **m);

/* ---- weights (theory 3); xi = z/a >= 0; nu enters phi, i0 and j0 only ---------------------------------------- */
int mdr_weight_phi(int n, const double xi[], double nu, double out[]);   /* dI0/dxi; (18) at nu = 1/2 */
int mdr_weight_i0(int n, const double xi[], double nu, double out[]);
int mdr_weight_i1(int n, const double xi[], double nu, double out[]);
int mdr_weight_j0(int n, const double xi[], double nu, double out[]);    /* 1 - I0 to full relative precision */
int mdr_weight_j1(int n, const double xi[], double nu, double out[]);

/* ---- contact (theory 4) -------------------------------------------------------------------------------------- */
typedef struct mdr_contact_options {
    int zeta_count;                    /* 0: d = g(a); else size of the table zeta(a) of (9), d = zeta(a) g(a) */
    const double *zeta_radius;         /* [zeta_count] ascending */
    const double *zeta;                /* [zeta_count] */
    double work_of_adhesion;           /* gamma >= 0 [modulus length], default 0: no adhesion */
    int adhesion_rule;                 /* enum mdr_adhesion_rule, default MDR_ADHESION_AUTOMATIC */
} mdr_contact_options;
enum mdr_adhesion_rule {
    MDR_ADHESION_AUTOMATIC = 0,        /* the energy balance where the medium is exact, the paper's rule elsewhere */
    MDR_ADHESION_PAPER = 1,            /* (28): dl = sqrt(2 pi a gamma/E_eff) */
    MDR_ADHESION_ENERGY = 2            /* balance of energy: dl = sqrt(2 pi a gamma/(E_eff + a E_eff')) */
};
enum mdr_branch {                      /* which stable state of an adhesive contact */
    MDR_ON_LOADING = 1,                /* the smallest contact, met on approach */
    MDR_ON_UNLOADING = 2               /* the largest contact, kept on retraction: what from_depth and from_force give */
};
enum mdr_control {
    MDR_CONTROL_FORCE = 0,
    MDR_CONTROL_DEPTH = 1,
    MDR_CONTROL_SPRING = 2             /* the far end of a spring; loops only */
};
void mdr_contact_options_init(mdr_contact_options *options);

int mdr_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options, mdr_contact **out);
int mdr_contact_from_depth(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);
int mdr_contact_from_force(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);
int mdr_contact_from_radius(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);
int mdr_contact_from_depth_on(const mdr_contact *c, int branch, int n, const double in[], double d[], double a[], double F[], double k[]);
int mdr_contact_from_force_on(const mdr_contact *c, int branch, int n, const double in[], double d[], double a[], double F[], double k[]);
int mdr_contact_pressure(const mdr_contact *c, double a, int n, const double r[], double out[]);
int mdr_contact_displacement(const mdr_contact *c, double a, int n, const double r[], double out[]);
int mdr_contact_line_load(const mdr_contact *c, double a, int n, const double x[], double out[]);
/* the same at a depth, for indenters whose radius does not determine the state (flat punch) */
int mdr_contact_pressure_at_depth(const mdr_contact *c, double d, int n, const double r[], double out[]);
int mdr_contact_displacement_at_depth(const mdr_contact *c, double d, int n, const double r[], double out[]);
int mdr_contact_line_load_at_depth(const mdr_contact *c, double d, int n, const double x[], double out[]);
int mdr_contact_free(mdr_contact **c);

/* ---- adhesion (theory 5) ------------------------------------------------------------------------------------- */
/* where the contact breaks: lowest force or depth of the whole branch; all 0 without adhesion; NULL outputs are skipped */
int mdr_contact_pull_off(const mdr_contact *c, int control, double *d, double *a, double *F);
/* all ends of stable stretches: the global one first, then the others by radius; *count is their full number, at most capacity are written */
int mdr_contact_pull_offs(const mdr_contact *c, int control, int capacity, double d[], double a[], double F[], int *count);

typedef struct mdr_loop mdr_loop;
/* a cycle of approach to position `largest` and retraction, about `points` points each way; spring_stiffness for MDR_CONTROL_SPRING only */
int mdr_loop_new(const mdr_contact *c, int control, double spring_stiffness, double largest, int points, mdr_loop **out);
int mdr_loop_size(const mdr_loop *l, int *points, int *turning_point, int *jumps);  /* turning_point: index of the last point of the approach */
int mdr_loop_path(const mdr_loop *l, int n, double position[], double d[], double a[], double F[]);  /* the first n points */
int mdr_loop_jumps(const mdr_loop *l, int n, int index[]);                           /* indices of the points just before each jump */
int mdr_loop_dissipated_energy(const mdr_loop *l, double *energy);                   /* [modulus length^3] */
int mdr_loop_free(mdr_loop **l);

/* ---- fit: from measured data to the numbers of indenter, medium and instrument --------------------------------- */
enum mdr_fit_data_kind {               /* what x and y are */
    MDR_FIT_FORCE_DEPTH = 1,           /* indentation depth, force */
    MDR_FIT_STIFFNESS_DEPTH = 2,       /* depth, contact stiffness; with the force of each point (dynamic nanoindentation) */
    MDR_FIT_MODULUS_RADIUS = 3,        /* contact radius, effective contact modulus */
    MDR_FIT_STIFFNESS_RADIUS = 4       /* contact radius, contact stiffness */
};
enum mdr_fit_indenter {                /* its numbers are the arguments of mdr_profile_...; GIVEN: `profile`, no numbers */
    MDR_FIT_INDENTER_GIVEN = 0,
    MDR_FIT_INDENTER_PARABOLOID = 1,
    MDR_FIT_INDENTER_SPHERE = 2,
    MDR_FIT_INDENTER_CONE = 3,
    MDR_FIT_INDENTER_POWER = 4,
    MDR_FIT_INDENTER_FLAT_PUNCH = 5,
    MDR_FIT_INDENTER_FLAT_CONE = 6,
    MDR_FIT_INDENTER_FLAT_PARABOLOID = 7,
    MDR_FIT_INDENTER_ROUNDED_CONE = 8
};
enum mdr_fit_medium {
    MDR_FIT_MEDIUM_GIVEN = 0,          /* `medium_object`, no numbers */
    MDR_FIT_MEDIUM_HOMOGENEOUS = 1,    /* E, nu */
    MDR_FIT_MEDIUM_STACK = 2,          /* E, nu, h of each of `layers` from the surface down; E, nu of the substrate; the model's alpha
                                          or wave factor (1 if it has none) */
    MDR_FIT_MEDIUM_GRADED = 3,         /* z, E, nu at each of `layers` depths */
    MDR_FIT_MEDIUM_POWER_GRADED = 4    /* E0, z0, exponent, nu */
};
enum mdr_fit_instrument {              /* the last seven numbers */
    MDR_FIT_WORK_OF_ADHESION = 0,      /* >= 0; > 0 if free */
    MDR_FIT_DEPTH_OFFSET = 1,          /* what the instrument reads at first contact */
    MDR_FIT_FORCE_OFFSET = 2,
    MDR_FIT_FRAME_COMPLIANCE = 3,
    MDR_FIT_INDENTER_MODULUS = 4,      /* its contact modulus E*_i; INFINITY: rigid. Stiffness and modulus data only */
    MDR_FIT_CONTACT_DEPTH_FACTOR = 5,  /* epsilon of h_c = h - epsilon P/S, 0.75 */
    MDR_FIT_STIFFNESS_FACTOR = 6,      /* beta of S = 2 beta a E_r, 1 */
    MDR_FIT_INSTRUMENT_COUNT = 7
};
enum mdr_fit_loss { MDR_FIT_LINEAR = 0, MDR_FIT_HUBER = 1, MDR_FIT_CAUCHY = 2 };

typedef struct mdr_fit_parameter {
    double value;                      /* the value, or where the search begins */
    double lower, upper;               /* bounds of a free one; -INFINITY, INFINITY for none */
    double prior, prior_sd;            /* what is known beforehand, and its standard deviation; 0: nothing */
    int is_free;
} mdr_fit_parameter;

typedef struct mdr_fit_problem {
    int data_kind;                     /* enum mdr_fit_data_kind */
    int indenter;                      /* enum mdr_fit_indenter */
    const mdr_profile *profile;
    int medium;                        /* enum mdr_fit_medium */
    const mdr_medium *medium_object;
    int model;                         /* enum mdr_model, for stacks and graded media */
    int layers;                        /* >= 1 */
    mdr_medium_options options;        /* weight_nu_choice, weight_nu, tolerance; alpha and wave_factor are among the numbers */
    int adhesion_rule;                 /* 0: automatic, 1: the source's (28), 2: energy balance */
    int loss;                          /* enum mdr_fit_loss */
    double loss_scale;                 /* beyond so many standard deviations a residual counts less; 1.345 */
    int sd_is_absolute;                /* 1: the standard deviations of the data are known; 0: their ratios only */
    int max_iterations;                /* 100 */
    int check_units;                   /* 1: data more than 300 times off the model at the start are refused */
    int parameter_count;
    const mdr_fit_parameter *parameters; /* [parameter_count]: indenter, medium, instrument, in this order */
} mdr_fit_problem;
void mdr_fit_problem_init(mdr_fit_problem *problem);

typedef struct mdr_fit_summary {
    int converged;                     /* 0: the best point found is returned all the same */
    int iterations, evaluations;
    double chi_square;                 /* of the data in their standard deviations */
    double prior_chi_square;
    double degrees_of_freedom;         /* data less the parameters they determine */
    double noise;                      /* factor of the standard deviations: 1 if known, else estimated */
    double log_likelihood;
    double runs_probability;           /* of so few or many runs of equal sign, were the residuals random */
    double weakest;                    /* smallest eigenvalue of the derivatives' correlation; 0: a combination is undetermined */
} mdr_fit_summary;

/* how many numbers the kinds of indenter and medium, `layers` and the instrument make together */
int mdr_fit_parameter_count(const mdr_fit_problem *problem, int *count);
/* n points; force[] for MDR_FIT_STIFFNESS_DEPTH only; sd NULL: equal and unknown. Every output may be NULL. m = parameter_count:
   values[m]; covariance[m*m], 0 for fixed numbers; at_bound[m]: -1, 0 or 1; weakest_direction[m]: the change of all free numbers that
   the data notice least; fitted[n]: the model at the data; residuals[n]: (y - model)/standard deviation */
int mdr_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double force[], const double sd[],
                  double values[], double covariance[], int at_bound[], double weakest_direction[], double fitted[],
                  double residuals[], mdr_fit_summary *summary);
/* what the instrument reads where the numbers are the `value`s; y is used where the frame gives way or contact depths follow from it */
int mdr_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double force[],
                    double fitted[]);
/* profile-likelihood interval of the free number at `position` (from 0); an end that does not exist is infinite */
int mdr_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double force[],
                     const double sd[], int position, double level, double *lower, double *upper);

#ifdef __cplusplus
}
#endif

#endif
