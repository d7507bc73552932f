/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact.h
 * Contact of real, coated, layered and graded bodies, computed in one dimension: the C interface and its manual.
 *
 * A rigid axisymmetric indenter (mdr_profile) is pressed into an elastic half-space (mdr_medium); the two make a contact
 * (mdr_contact), which gives indentation depth d, contact radius a, normal force F and stiffness k from any one of
 * the first three, and the pressure, line load and surface displacement. A structure (mdr_structure) whose moduli vary in
 * all directions gives a medium for each place on it; a compiled law (mdr_law) is a contact for programs that call it
 * millions of times; a fit goes from measured curves back to the moduli. Equation numbers are those of V. L. Popov,
 * "Method of dimensionality reduction in contact mechanics and tribology. Heterogeneous media", Physical
 * Mesomechanics 17 (2014) 50-57; docs/theory.md states the equations and says where they are misprinted.
 *
 * @par Units
 * Any consistent set: choose a unit of length and one of modulus (pressure); forces are then in modulus length^2, stiffnesses
 * and line loads in modulus length, works of adhesion in modulus length. SI (m, Pa, N) is one choice, (um, MPa, uN) and
 * (nm, GPa, nN) are others. In the comments the unit of each number stands in brackets; [1] has none. Angles are in radian.
 *
 * @par Signs
 * Depth, force and surface displacement are positive into the medium, pressure in compression.
 *
 * @par Status
 * Every function that can fail returns MDR_SUCCESS (0) or another value of enum mdr_status; mdr_last_error() then says in
 * words which argument was wrong, what it was and what is allowed. A failed call writes no output and loses no memory.
 * Every function can return MDR_ENULL for a missing pointer, MDR_EINVALID for NaN, infinity, a negative n, a handle of another kind
 * or a value out of its range, MDR_ENOMEMORY, MDR_ENOCONVERGENCE for a result outside the number range, and in long calls
 * MDR_ECANCELLED; only further codes, and further reasons, are listed with the functions.
 *
 * @par Arrays
 * `n` is the number of elements of all arrays of the call; n = 0 is allowed, and then the arrays may be NULL. An
 * output array may be the input array itself; otherwise arrays must not overlap. Error messages count entries from 1,
 * indices in arguments and results begin at 0.
 *
 * @par Structures that grow
 * Options, problems and what the library says of its objects may get more members in later versions. They begin with their size,
 * which the program sets: `mdr_law_options options = MDR_SIZED(mdr_law_options);` - all other members are 0 then, which stands for
 * the default; where 0 is a value, too, a member `..._is_given` says that it is meant. The library reads and writes the members
 * that both it and the program know: a program runs with older and newer libraries than the header it was compiled with.
 * MDR_EINVALID for a size that cannot be, and for members that are not 0 and that the library does not know.
 *
 * @par Handles and their release
 * Functions with an argument `out` make handles; the calling program owns them and frees them by mdr_profile_free() and so on, which
 * also set the caller's pointer to NULL. What a handle was made from may be freed at once: it holds copies (but
 * mdr_structure_callback() keeps the user's function and context). A handle never changes after its creation, but for
 * mdr_friction_history and mdr_wear_history, which must not be used by two threads at a time.
 *
 * @par Rounding
 * Every function that computes does so rounding to nearest, with denormal numbers and without traps of exceptions, and then sets
 * the calling thread's own arithmetic again; flags of exceptions stay set, as after any computation. User functions are called in
 * this arithmetic and leave it as it is. States of laws, which take nanoseconds - mdr_law_force(), mdr_law_at_depth(), mdr_law_at_force(),
 * mdr_law_follow(), mdr_law_from_depth(), mdr_law_from_force(), mdr_law_energy(), mdr_law_conductance() and mdrcontact_law.h -,
 * compute in the caller's: under another rounding mode they differ in the last digits, by 1e-14.
 *
 * @par Threads
 * Any number of threads may use the same handle at the same time; the error text belongs to the thread that failed.
 * Functions of arrays share the work among several threads of their own (OpenMP) where mdr_set_threads() allows it.
 * Only freeing a handle needs the certainty that no other thread uses it. GSL's error handler, which would end the program, is
 * switched off for the process when an object is made; a program with a GSL handler of its own sets it again afterwards.
 *
 * A call takes up to 56 kB of the calling thread's stack, and what user functions take on top. 128 kB, as threads have under musl,
 * are enough, also where the BLAS keeps data of each thread there (OpenBLAS: 60 kB).
 */
#ifndef MDRCONTACT_H
#define MDRCONTACT_H

#include <stddef.h>

/** A structure that grows, `type`, with its size; all else in it is 0. */
#ifdef __cplusplus
template <typename T> inline T mdr_sized()
{
    T made = T();
    made.size = sizeof(T);
    return made;
}
#define MDR_SIZED(type) mdr_sized<type>()
#else
#define MDR_SIZED(type) ((type){.size = sizeof(type)})
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @name Version of this header; mdr_version() gives that of the library. */
/** @{ */
#define MDR_VERSION_MAJOR 0
#define MDR_VERSION_MINOR 1
#define MDR_VERSION_PATCH 0
/** @} */

/* ---- status ------------------------------------------------------------------------------------------------- */

/** What a call has to say. */
enum mdr_status {
    MDR_SUCCESS = 0,        /**< The call did what it says. */
    MDR_ENULL = 1,          /**< A required pointer or handle is NULL. */
    MDR_EINVALID = 2,       /**< An argument has a value that is never allowed (NaN, E <= 0, a table that is not ascending). */
    MDR_EDOMAIN = 3,        /**< A point lies where the object is not defined (r > a, beyond the end of a table). */
    MDR_EUNREACHABLE = 4,   /**< No contact state has the requested depth, force or radius. */
    MDR_ENOCONVERGENCE = 5, /**< An iteration or refinement ended before it met its tolerance, or a result left the number range. */
    MDR_ENOMEMORY = 6,      /**< Memory could not be allocated. */
    MDR_ECALLBACK = 7,      /**< A user function reported a failure or gave NaN or infinity. */
    MDR_EFILE = 8,          /**< A file could not be read or written, or is damaged. */
    MDR_ECANCELLED = 9      /**< The function given to mdr_set_cancel() ended the call. */
};

/** The library's version, 10000 major + 100 minor + patch. Never fails. */
int mdr_version(void);

/** The name of a status code, "MDR_EINVALID" for instance; "unknown status" for any other number. A constant: never freed. */
const char *mdr_status_name(int status);

/**
 * The text of the calling thread's last failure. Successful calls leave it as it is; it is empty before the first failure.
 *
 * Writes at most `length` characters, the closing zero included; what does not fit is cut off.
 * @param buffer  receives the text; NULL: the length only
 * @param length  size of buffer; nothing is written if it is less than 1
 * @return        the full length of the text without its closing zero, at most 1023: length + 1 characters hold all of it
 */
int mdr_last_error(char *buffer, int length);

/** The parts of a failure, for programs that put the words together themselves; mdr_last_error() says "entry 3 of xi = -1 is not
 *  allowed: ..." of the argument "xi", the entry 3 and the text " = -1 is not allowed: ...". */
typedef struct mdr_failure {
    size_t size;         /**< Of this structure; MDR_SIZED sets it. */
    int status;        /**< One of enum mdr_status; MDR_SUCCESS before the first failure. */
    int entry;         /**< Which entry of an array it is about, from 1; 0: none. */
    char argument[64]; /**< The argument that the text begins with; empty if the text stands alone. */
    char text[1024];   /**< What is wrong with it. */
} mdr_failure;

/** The calling thread's last failure, which this call leaves as it is.
 *  @param failure  begun by MDR_SIZED; receives it
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a size that cannot be */
int mdr_last_failure(mdr_failure *failure);

/**
 * How many threads the calling thread's functions of arrays may use from now on: 1 at first. Each thread of a program has its own
 * number.
 *
 * Arrays too small to gain stay on the calling thread: some ten thousand points of a closed form, two states that are solved for;
 * so do structures made by mdr_structure_callback(). Within a parallel region of the caller's all stays on the calling thread. The
 * results are the same to the last bit for every number of threads; where entries fail, the error is that of the first of them. A
 * library built without OpenMP uses one thread.
 * @param threads  at least 1, or 0 for as many as OpenMP offers
 */
int mdr_set_threads(int threads);

/**
 * Called during long calls; its result says whether to stop.
 * @param context  the pointer given with the function
 * @return         0 to go on; anything else to end the call, and then again until it has returned
 */
typedef int (*mdr_cancel)(void *context);

/**
 * From now on all calls of the calling thread that take long - fits, maps, tables, laws, loops, arrays of states - call `cancel`
 * whether to stop: after at most 0.2 s, not more often than every 0.05 s, in this thread. A call that is cancelled returns
 * MDR_ECANCELLED, has written nothing, and leaves every handle as it was. Each thread has its own.
 * @param cancel   NULL: none is called, as at first
 * @param context  passed on to cancel, may be NULL
 */
int mdr_set_cancel(mdr_cancel cancel, void *context);

/**
 * From now on mdr_contact_history() writes to *part, in the calling thread, how far its march through time is. Another thread may
 * read it meanwhile, or the function given to mdr_set_cancel(). Each thread has its own.
 * @param part  [1] receives the number of rounds that are done, each with steps half as long as those of the one before, plus the
 *              part of the path that the present one has behind it; NULL: none is called, as at first
 */
int mdr_set_progress(double part[]);

/** An indenter. Made by mdr_profile_..., freed by mdr_profile_free(). */
typedef struct mdr_profile mdr_profile;
/** What is pressed: an elastic or viscoelastic half-space, or two bodies. Made by mdr_medium_..., freed by mdr_medium_free(). */
typedef struct mdr_medium mdr_medium;
/** An indenter on a medium. Made by mdr_contact_new(), freed by mdr_contact_free(). */
typedef struct mdr_contact mdr_contact;
/** A viscoelastic material, for layers of mdr_medium_stack(). Made by mdr_material_..., freed by mdr_material_free(). */
typedef struct mdr_material mdr_material;
/** The answers of a poroelastic gel. Made by mdr_poroelastic_new(), freed by mdr_poroelastic_free(). */
typedef struct mdr_poroelastic mdr_poroelastic;
/** One or two conductors that touch at a spot. Made by mdr_conduction_new(), freed by mdr_conduction_free(). */
typedef struct mdr_conduction mdr_conduction;
/** A cycle of approach and retraction. Made by mdr_loop_new(), freed by mdr_loop_free(). */
typedef struct mdr_loop mdr_loop;
/** A contact whose work of adhesion depends on the speed of its edge. Made by mdr_rate_new(), freed by mdr_rate_free(). */
typedef struct mdr_rate mdr_rate;

/**
 * A user function y = f(x). It is called only while the object it describes is made, in the thread that makes it.
 * @param x        where
 * @param y        receives the value, which must be finite
 * @param context  the pointer given with the function
 * @return         0, or any other number to report a failure: the creation then ends with MDR_ECALLBACK
 */
typedef int (*mdr_function)(double x, double *y, void *context);

/* ---- indenters: f(r), f(0) = 0, and the one-dimensional g(x), equations (3) and (4) ----------------------------- */

/** Paraboloid f = r^2/(2R), g = x^2/R: a sphere as long as a is small against R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_paraboloid(double radius, mdr_profile **out);

/** Sphere f = R - sqrt(R^2 - r^2), g = (x/2) ln((R + x)/(R - x)). Defined for r <= R; contacts reach a < R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_sphere(double radius, mdr_profile **out);

/** Cone f = r tan(phi), g = (pi/2) x tan(phi). A Berkovich or Vickers tip has the equivalent half-angle 70.30 degrees, a cube
 *  corner 42.28 degrees.
 *  @param inclination  phi, the angle between the face and the surface, pi/2 minus the half-angle, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle */
int mdr_profile_cone(double inclination, mdr_profile **out);

/** Power law f = c r^n, g = kappa_n c x^n with kappa_n = (sqrt(pi)/2) n Gamma(n/2)/Gamma((n+1)/2).
 *  @param exponent     n, 0 < n <= 100 [1]
 *  @param coefficient  c > 0 [length^(1-n)]
 *  @param out          receives the handle */
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out);

/** Flat cylindrical punch: f = g = 0 up to its radius, where it ends in a vertical wall. The contact radius is that radius
 *  at every depth: compute states by depth or force.
 *  @param radius  b > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_flat_punch(double radius, mdr_profile **out);

/** Cone with a flat end: f = (r - b) tan(phi), g = x tan(phi) arccos(b/x) for r, x > b, 0 below.
 *  @param end_radius   b > 0 [length]
 *  @param inclination  phi, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle */
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);

/** Paraboloid with a flat end: f = (r^2 - b^2)/(2R), g = (x/R) sqrt(x^2 - b^2) for r, x > b, 0 below.
 *  @param end_radius  b > 0 [length]
 *  @param radius      R > 0, radius of curvature at the apex that is cut off [length]
 *  @param out         receives the handle */
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);

/** Cone with a rounded tip, a paraboloid that passes into the cone at b without a kink: f = r^2 tan(phi)/(2b) for r <= b,
 *  (r - b/2) tan(phi) beyond.
 *  @param blend_radius  b > 0; the radius of curvature at the tip is b/tan(phi) [length]
 *  @param inclination   phi, 0 < phi < pi/2 [radian]
 *  @param out           receives the handle */
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);

/** Calibrated nanoindenter tip by its area function A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., A = pi r^2
 *  (Oliver, Pharr, J. Mater. Res. 7 (1992) 1564). A must grow from min_height (from 0 without one) to max_height.
 *  @param n             number of coefficients, at least 1
 *  @param coefficients  [n] C0 [1], C1 [length], C2 [length^(3/2)], C3 [length^(7/4)], ...
 *  @param min_height    f below which the fitted A is not to be trusted, 0 if there is none; below it the tip is a paraboloid
 *                       that meets A there [length]
 *  @param max_height    f up to which the tip is used, > min_height [length]
 *  @param out           receives the handle */
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out);

/** Indenter through the points (r, f), interpolated without overshoot; leading zeros of f are a flat end.
 *  @param n    number of points, at least 3
 *  @param r    [n] strictly ascending from r[0] = 0; contacts reach a <= r[n-1] [length]
 *  @param f    [n] from f[0] = 0, never decreasing, not all 0 [length]
 *  @param out  receives the handle */
int mdr_profile_table(int n, const double r[], const double f[], mdr_profile **out);

/** Indenter from a function f(r), smooth but for corners and a power of r at the axis; a feature narrower than 1 % of
 *  largest_radius may go unseen. It is sampled when the handle is made, and compared with f between the nodes. Written without
 *  cancellation, r^2/(R + sqrt(R^2 - r^2)) rather than R - sqrt(R^2 - r^2), f keeps its digits down to the axis. Where its values
 *  scatter there, f is continued by a power series in r that agrees with them within their scatter and is determined by them to
 *  3e-10, or refused.
 *  @param height          f(r) on [0, largest_radius], f(0) = 0, greater than 0 beyond, never decreasing [length]
 *  @param context         passed on to height, may be NULL
 *  @param largest_radius  > 0, up to where contacts reach [length]
 *  @param out             receives the handle
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if f is not smooth enough to be sampled or loses its digits towards the axis */
int mdr_profile_callback(mdr_function height, void *context, double largest_radius, mdr_profile **out);

/** Sum of indenters, f = f1 + f2 + ...: their g add too. It is defined as far as the first of them ends.
 *  @param n      number of terms, at least 1
 *  @param terms  [n] handles; copied
 *  @param out    receives the handle */
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);

/** Indenter whose one-dimensional profile goes through the points (x, g); its f follows from (4).
 *  @param n    number of points, at least 3
 *  @param x    [n] strictly ascending from x[0] = 0 [length]
 *  @param g    [n] from g[0] = 0, never decreasing, not all 0 [length]
 *  @param out  receives the handle */
int mdr_profile_from_mdr_table(int n, const double x[], const double g[], mdr_profile **out);

/** f(r), the height of the indenter's surface above its lowest point [length].
 *  @param p    indenter
 *  @param n    number of radii
 *  @param r    [n] radii >= 0 [length]
 *  @param out  [n] heights [length]
 *  @return also MDR_EDOMAIN beyond the end of the profile */
int mdr_profile_height(const mdr_profile *p, int n, const double r[], double out[]);

/** f'(r) [1]; infinite at the equator of a sphere. Arguments and errors as mdr_profile_height(). */
int mdr_profile_slope(const mdr_profile *p, int n, const double r[], double out[]);

/** g(x), the one-dimensional profile, equation (3) [length]; infinite at the equator of a sphere. Arguments and errors as
 *  mdr_profile_height(), with x [length] in place of r. */
int mdr_profile_mdr(const mdr_profile *p, int n, const double x[], double out[]);

/** g'(x) [1]. Arguments and errors as mdr_profile_mdr(). */
int mdr_profile_mdr_slope(const mdr_profile *p, int n, const double x[], double out[]);

/** Frees an indenter and sets *p to NULL. p = NULL and *p = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *p is not an indenter */
int mdr_profile_free(mdr_profile **p);

/* ---- media: effective contact modulus E_eff(a), stiffness k = 2 a E_eff(a), equation (10) ----------------------- */

/** Models of a coated, layered or graded half-space. h is the thickness, x = a/h, xi = h/a, index 0 the coating, 1 the substrate,
 *  E* = E/(1 - nu^2). */
enum mdr_model {
    MDR_MODEL_GAO = 0,                /**< Gao's weights, moduli in parallel, equations (12)-(16): the source's model. */
    MDR_MODEL_GAO_SERIES = 1,         /**< Gao's weights, 1/G in series: far closer to the exact solution at large contrast. */
    MDR_MODEL_DOERNER_NIX = 2,        /**< 1/E_eff = (1 - e^(-alpha xi))/E*0 + e^(-alpha xi)/E*1, equation (11). */
    MDR_MODEL_WAVE = 3,               /**< Response to a wave of wavenumber q = wave_factor/a, equations (19), (20). */
    MDR_MODEL_MENCIK_EXPONENTIAL = 4, /**< E_eff = E*1 + (E*0 - E*1) e^(-alpha x). */
    MDR_MODEL_MENCIK_RECIPROCAL = 5,  /**< 1/E_eff = 1/E*1 + (1/E*0 - 1/E*1) e^(-alpha x). */
    MDR_MODEL_BEC = 6,                /**< Bec et al. 2006: film and substrate as springs in series. */
    MDR_MODEL_PERRIOT_BARTHEL = 7,    /**< Perriot, Barthel 2004: a fit to their exact solution. */
    MDR_MODEL_HAY_CRAWFORD = 8,       /**< Hay, Crawford 2011: Gao's weights with the film also acting in parallel. */
    MDR_MODEL_DIMITRIADIS = 9,        /**< Dimitriadis et al. 2002: layer with nu = 1/2 on a rigid base, for a paraboloid or a
                                           sphere and a < h; all else is refused. */
    MDR_MODEL_GARCIA = 10,            /**< Garcia, Garcia 2018: the same with their coefficients. */
    MDR_MODEL_EXACT = 11,             /**< The exact solution of the layered half-space. */
    MDR_MODEL_GAO_POWER = 12          /**< Gao's weights, power mean G_eff = [G1^p + (G0^p - G1^p) I0]^(1/p) between the two. */
};

/** The name of a model, as Python and problem files write it: "gao-series", "exact", ...
 *  @param model   one of enum mdr_model
 *  @param length  size of name, at least 19
 *  @param name    [length] receives the name and a null character
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a model that does not exist or too short a length */
int mdr_model_name(int model, int length, char *name);

/** The model of a name.
 *  @param name   ended by a null character
 *  @param model  receives one of enum mdr_model
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a name that no model has */
int mdr_model_from_name(const char *name, int *model);

/** Which substrates a model takes. */
enum mdr_model_base {
    MDR_BASE_ELASTIC = 0, /**< An elastic half-space. */
    MDR_BASE_ANY = 1,     /**< An elastic half-space or a rigid base. */
    MDR_BASE_RIGID = 2    /**< A rigid base. */
};

/** What a model takes. */
typedef struct mdr_model_facts {
    size_t size;          /**< Of this structure; MDR_SIZED sets it. */
    double largest_ratio; /**< It is valid up to this a/h; INFINITY where there is no limit. */
    int base;             /**< One of enum mdr_model_base. */
    int takes_layers;     /**< 1: any number of layers; 0: one coating. */
    int takes_graded;     /**< 1: graded half-spaces too. */
    int spherical_only;   /**< 1: it is valid under a paraboloid or a sphere only. */
    char name[24];        /**< Its name. */
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
    MDR_WEIGHT_NU_SURFACE = 0,   /**< That of the surface: the most accurate on average, and the default. */
    MDR_WEIGHT_NU_SUBSTRATE = 1, /**< That of the substrate. */
    MDR_WEIGHT_NU_EFFECTIVE = 2, /**< The effective one at the same a. */
    MDR_WEIGHT_NU_GIVEN = 3      /**< The number weight_nu. */
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
                                 layered elastic bodies take both, a homogeneous one by mdr_medium_stack() with n = 0. Their contacts
                                 answer states, adhesion, fields of the surface and laws, to 1e-9 (cones 1e-8); friction, stresses
                                 inside, energies and pairs return MDR_EINVALID. */
} mdr_medium_options;

/** Homogeneous half-space of one material, equations (1)-(8); E_eff = E/(1 - nu^2).
 *  @param E    Young's modulus > 0 [modulus]
 *  @param nu   Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param out  receives the handle */
int mdr_medium_homogeneous(double E, double nu, mdr_medium **out);

/** Homogeneous half-space of given contact modulus, whatever its E and nu.
 *  @param contact_modulus  E* > 0 [modulus]
 *  @param out              receives the handle */
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);

/** Half-space with one coating.
 *  @param coating_E     E0 > 0 [modulus]
 *  @param coating_nu    -1 < nu0 <= 1/2 [1]; 1/2 for MDR_MODEL_DIMITRIADIS and MDR_MODEL_GARCIA
 *  @param thickness     h > 0 [length]
 *  @param substrate_E   E1 > 0 [modulus]; INFINITY is a rigid base, which MDR_MODEL_DIMITRIADIS and MDR_MODEL_GARCIA
 *                       demand, MDR_MODEL_EXACT allows, and the others refuse
 *  @param substrate_nu  -1 < nu1 <= 1/2 [1]; not looked at for a rigid base
 *  @param model         one of enum mdr_model
 *  @param options       NULL for the defaults
 *  @param out           receives the handle */
int mdr_medium_coated(double coating_E, double coating_nu, double thickness, double substrate_E, double substrate_nu,
                      int model, const mdr_medium_options *options, mdr_medium **out);

/** Stack of layers on a substrate, equation (16) for piecewise constant moduli.
 *  @param n             number of layers, at least 1
 *  @param E             [n] Young's moduli > 0 from the surface down [modulus]
 *  @param nu            [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param thickness     [n] thicknesses > 0 [length]
 *  @param substrate_E   > 0 [modulus]; INFINITY is a rigid base, MDR_MODEL_EXACT only
 *  @param substrate_nu  -1 < nu <= 1/2 [1]; not looked at for a rigid base
 *  @param model         MDR_MODEL_GAO, ..._GAO_SERIES, ..._GAO_POWER or ..._EXACT
 *  @param options       NULL for the defaults
 *  @param out           receives the handle */
int mdr_medium_layered(int n, const double E[], const double nu[], const double thickness[],
                       double substrate_E, double substrate_nu, int model, const mdr_medium_options *options, mdr_medium **out);

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

/** Layers on a substrate, of any kinds of mdr_layer. What is not isotropic, bonded and free of stress takes MDR_MODEL_EXACT; a
 *  tangential contact over a sliding interface is refused, as stresses inside layers under a prestress are.
 *
 *  Where one has a `material` the body is viscoelastic: its layers are isotropic and free of stress, its interfaces do not relax. Its
 *  contacts answer mdr_contact_history(); everything else returns MDR_EINVALID and says so, work of adhesion included.
 *  @param n          number of layers; 0: a half-space
 *  @param layers     [n] from the surface down; with n = 0 it may be NULL
 *  @param substrate  the half-space below; NULL: a rigid base, which holds the last layer by its interface: a sliding one is a
 *                    smooth rigid base
 *  @param model      one of enum mdr_model
 *  @param options    NULL for the defaults
 *  @param out        receives the handle
 *  @return also MDR_EINVALID where compression is beyond that at which the surface wrinkles */
int mdr_medium_stack(int n, const mdr_layer *layers, const mdr_layer *substrate, int model, const mdr_medium_options *options,
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
int mdr_medium_graded_callback(mdr_function E, mdr_function nu, void *context, double depth, int model,
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

/* ---- viscoelastic materials and media: time ----------------------------------------------------------------------- */

/** A linear viscoelastic material whose shear modulus relaxes as G(t) = relaxed_shear_modulus + sum moduli_i exp(-t/times_i) (Prony
 *  series), with a dashpot in parallel (Kelvin-Voigt) where viscosity > 0. Without a relaxed modulus it flows without end.
 *  @param relaxed_shear_modulus  G(infinity) >= 0 [modulus]
 *  @param n                      number of terms; 0 is allowed with a relaxed modulus
 *  @param moduli                 [n] > 0 [modulus]
 *  @param times                  [n] relaxation times > 0 [time]
 *  @param viscosity              >= 0 [modulus time]; 0 with a bulk modulus
 *  @param nu                     Poisson's ratio, constant, -1 < nu <= 1/2; not used with a bulk modulus
 *  @param bulk_modulus           K > 0, elastic: Poisson's ratio then grows in time [modulus]; 0: nu is constant
 *  @param out                    receives the handle */
int mdr_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[], double viscosity,
                              double nu, double bulk_modulus, mdr_material **out);

/** A material whose shear modulus relaxes as a power of time, G(t) = modulus (t/time)^(-exponent).
 *  @param modulus   G at `time`, > 0 [modulus]
 *  @param time      > 0 [time]
 *  @param exponent  > 0 (elastic) and < 1 (viscous) [1]
 *  @param nu        Poisson's ratio, constant, -1 < nu <= 1/2 [1]
 *  @param out       receives the handle */
int mdr_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out);

/** The shear relaxation modulus G(t) [modulus], at t = 0 the glassy one; a dashpot bears nothing at t > 0.
 *  @param m    material
 *  @param n    number of times
 *  @param t    [n] >= 0, and > 0 of a power law or with a dashpot, whose G(0) is infinite [time]
 *  @param out  [n] [modulus] */
int mdr_material_relaxation(const mdr_material *m, int n, const double t[], double out[]);

/** The shear compliance J(t), the strain under a constant stress of 1 [1/modulus]; J(0) = 0 of a power law or with a dashpot.
 *  @param m    material
 *  @param n    number of times
 *  @param t    [n] >= 0 [time]
 *  @param out  [n] [1/modulus] */
int mdr_material_creep(const mdr_material *m, int n, const double t[], double out[]);

/** The complex shear modulus at angular frequencies: storage and loss modulus.
 *  @param m        material
 *  @param n        number of frequencies
 *  @param omega    [n] > 0 [1/time]
 *  @param storage  [n] [modulus]
 *  @param loss     [n] [modulus] */
int mdr_material_complex_modulus(const mdr_material *m, int n, const double omega[], double storage[], double loss[]);

/** The elastic materials that a viscoelastic one is like under sudden and under lasting loads. */
enum mdr_limit {
    MDR_LIMIT_GLASSY = 1, /**< At once. */
    MDR_LIMIT_RELAXED = 2 /**< In the end. */
};

/** E and nu of a limit.
 *  @param m      material
 *  @param limit  one of enum mdr_limit
 *  @param E      or NULL: receives Young's modulus [modulus]
 *  @param nu     or NULL: receives Poisson's ratio [1]
 *  @return also MDR_EINVALID where there is no such limit: power laws, dashpots, liquids */
int mdr_material_limit(const mdr_material *m, int limit, double *E, double *nu);

/** Frees a material and sets *m to NULL. m = NULL and *m = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *m is not a material */
int mdr_material_free(mdr_material **m);

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
int mdr_medium_callback(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out);

/** E_eff(a), the effective contact modulus, equation (10).
 *  @param m    medium
 *  @param n    number of radii
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] E_eff [modulus]
 *  @return also MDR_EINVALID for rigid and viscoelastic media, MDR_EDOMAIN where the medium is not defined, MDR_ENOCONVERGENCE */
int mdr_medium_modulus(const mdr_medium *m, int n, const double a[], double out[]);

/** k = 2 a E_eff(a), the stiffness of a flat punch of radius a, equation (10) [modulus length]. Arguments and errors as
 *  mdr_medium_modulus(). */
int mdr_medium_stiffness(const mdr_medium *m, int n, const double a[], double out[]);

/** G_t(a) = k_t(a)/(2 a), what takes E_eff's place where a contact that sticks all over is displaced along the surface:
 *  4 G/(2 - nu) of a homogeneous body, 1/G_t adds where two bodies touch. The kernel of a layered body is tabulated in each call:
 *  give all radii at once.
 *  @param m    homogeneous with E and nu; coated, layered or graded under the model MDR_MODEL_EXACT, exact but for the displacement
 *              that varies as cos 2 phi around the axis (k_t is low by at most 0.35 %), or by Gao's weights with those of a
 *              tangential load; pairs of these
 *  @param n    number of radii
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] G_t [modulus]
 *  @return also MDR_EINVALID for other media, MDR_EDOMAIN where the medium is not defined, MDR_ENOCONVERGENCE */
int mdr_medium_tangential_modulus(const mdr_medium *m, int n, const double a[], double out[]);

/** The torsional stiffness M/phi of a contact that sticks all over and is twisted about its axis: 16 G a^3/3 of a homogeneous body,
 *  exact for homogeneous media with E and nu, for coated, layered and graded ones under the model MDR_MODEL_EXACT, and for pairs of
 *  these.
 *  @param m    medium
 *  @param n    number of radii
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] stiffnesses [modulus length^3]
 *  @return also MDR_EINVALID for other media, MDR_EDOMAIN where the medium is not defined, MDR_ENOCONVERGENCE */
int mdr_medium_torsional_stiffness(const mdr_medium *m, int n, const double a[], double out[]);

/** Loads of a surface. */
enum mdr_load {
    MDR_LOAD_NORMAL = 1, /**< A pressure. */
    MDR_LOAD_SHEAR = 2,  /**< A traction of one direction along the surface: the mean over the directions of the wave. */
    MDR_LOAD_TWIST = 3   /**< A traction along the surface across the wave, which one around an axis consists of. */
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

/** Frees a medium and sets *m to NULL. m = NULL and *m = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *m is not a medium */
int mdr_medium_free(mdr_medium **m);

/* ---- Gao's weights of a depth z, xi = z/a, equations (12)-(15), (18) -------------------------------------------- */

/** Phi(xi) = dI0/dxi, the weight of the depth a xi itself; equation (18) at nu = 1/2.
 *  @param n    number of depths
 *  @param xi   [n] z/a >= 0 [1]
 *  @param nu   Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param out  [n] weights [1] */
int mdr_weight_phi(int n, const double xi[], double nu, double out[]);

/** I0(xi), the weight of the shear modulus above the depth a xi, equations (12)-(15). Arguments as mdr_weight_phi(). */
int mdr_weight_i0(int n, const double xi[], double nu, double out[]);

/** I1(xi), the weight of Poisson's ratio above the depth a xi, equations (12)-(15). Arguments as mdr_weight_phi(); nu is
 *  checked but does not enter. */
int mdr_weight_i1(int n, const double xi[], double nu, double out[]);

/** J0 = 1 - I0, the weight of what lies below, to full relative precision. Arguments as mdr_weight_phi(). */
int mdr_weight_j0(int n, const double xi[], double nu, double out[]);

/** J1 = 1 - I1, to full relative precision. Arguments as mdr_weight_i1(). */
int mdr_weight_j1(int n, const double xi[], double nu, double out[]);

/** I0(xi) of a load along the surface, the weight of the shear modulus in the tangential stiffness, I1 + [xi L - xi/(1 + xi^2)]/
 *  (2 pi (2 - nu)) with L = ln(1 + 1/xi^2). Poisson's ratio keeps the weight I1. Arguments as mdr_weight_phi(). */
int mdr_weight_i0_tangential(int n, const double xi[], double nu, double out[]);

/** 1 less mdr_weight_i0_tangential(), to full relative precision. Arguments as mdr_weight_phi(). */
int mdr_weight_j0_tangential(int n, const double xi[], double nu, double out[]);

/* ---- contacts (2)-(10), (21)-(32) ------------------------------------------------------------------------------ */

/** The edge opening dl of an adhesive contact: the distance of the springs at the edge from the indenter when they let go. */
enum mdr_adhesion_rule {
    MDR_ADHESION_AUTOMATIC = 0, /**< Energy where the medium meets the balance exactly, the source's rule elsewhere. */
    MDR_ADHESION_PAPER = 1,     /**< dl = sqrt(2 pi a gamma/E_eff), equation (28). */
    MDR_ADHESION_ENERGY = 2     /**< dl = sqrt(4 pi a gamma/k'(a)), the balance of energy. */
};

/** Which stable state is meant where an adhesive contact has several. */
enum mdr_branch {
    MDR_ON_LOADING = 1,  /**< The smallest contact, met when the bodies approach. */
    MDR_ON_UNLOADING = 2 /**< The largest contact, kept when they are drawn apart: what mdr_contact_from_depth() gives. */
};

/** What the machine prescribes. */
enum mdr_control {
    MDR_CONTROL_FORCE = 0, /**< The normal force. */
    MDR_CONTROL_DEPTH = 1, /**< The indentation depth. */
    MDR_CONTROL_SPRING = 2 /**< The far end of a spring that presses the indenter, d + F/stiffness; loops only. */
};

/** What a contact can have beyond indenter and medium. Begun by MDR_SIZED. The arrays are
 *  copied by mdr_contact_new(). */
typedef struct mdr_contact_options {
    size_t size;               /**< Of this structure; MDR_SIZED sets it. */
    int zeta_count;            /**< Size of the table of zeta in (9), d = zeta(a) g(a), at least 3; default 0: zeta = 1. */
    const double *zeta_radius; /**< [zeta_count] contact radii > 0, strictly ascending; contacts reach the last one [length]. */
    const double *zeta;        /**< [zeta_count] zeta > 0 [1]; zeta(a) g(a) must not decrease. */
    double work_of_adhesion;   /**< gamma >= 0 [modulus length]; default 0. */
    int adhesion_rule;         /**< One of enum mdr_adhesion_rule; default MDR_ADHESION_AUTOMATIC. */
    int zeta_is_exact;         /**< Not 0: instead of a table, the zeta of the same coated, layered or graded body solved exactly,
                                    for radii up to 1000 thicknesses, so that E_eff is the only approximation; default 0. */
    double cohesive_stress;    /**< sigma >= 0 [modulus]: adhesion with a range, the Dugdale-Maugis zone, on homogeneous bodies and
                                    under the model exact, pairs included. The surfaces pull on each other with sigma wherever
                                    they are less than work_of_adhesion/sigma apart; default 0: a range of nothing. A zone too
                                    short to change a digit is left out, and mdr_contact_warnings() says so. */
} mdr_contact_options;

/** The contact of an indenter with a medium, both of which are copied.
 *  @param profile  indenter
 *  @param medium   medium
 *  @param options  NULL for the defaults
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN if the indenter's flat end is larger than the medium's largest contact radius */
int mdr_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options, mdr_contact **out);

/** A state of a contact: what fields are computed from. */
typedef struct mdr_state {
    double depth;     /**< d, indentation depth, positive into the medium [length]. */
    double radius;    /**< a, contact radius [length]. */
    double force;     /**< F, normal force, positive in compression [modulus length^2]. */
    double stiffness; /**< k = dF/dd at constant a, 2 a E_eff(a) [modulus length]. */
    double excess;    /**< Depth beyond that of the non-adhesive state of this radius: 0 without adhesion, less than 0 with it, the
                           whole depth under a flat punch [length]. */
    double zone_radius; /**< c, outer radius of the cohesive zone: the bodies pull on each other where a < r < c; 0 without a
                             cohesive stress [length]. With radius 0 they attract each other without contact. */
} mdr_state;

/** Which number determines a state. */
enum mdr_given {
    MDR_GIVEN_DEPTH = 1, /**< Indentation depth >= 0, with adhesion down to the pull-off depth [length]. */
    MDR_GIVEN_FORCE = 2, /**< Normal force >= 0, with adhesion down to the pull-off force [modulus length^2]. */
    MDR_GIVEN_RADIUS = 3 /**< Contact radius >= 0, at least that of the indenter's flat end, below its vertical wall [length]. With
                              adhesion the state may be unstable under given depth or force. */
};

/** Fields of a state. */
enum mdr_field_kind {
    MDR_FIELD_PRESSURE = 1,     /**< p(r), the contact pressure, equation (6), 0 <= r <= a [modulus]. Infinite where theory says
                                     so: at the edge of a flat punch or of an adhesive contact, at the apex of a cone. With a
                                     cohesive stress sigma up to zone_radius, finite at a and -sigma from there on. */
    MDR_FIELD_DISPLACEMENT = 2, /**< u(r), the displacement of the surface: d - f(r) for r <= a, where f(r) must be defined; the
                                     free surface beyond; any r >= 0. Of two bodies both together, each into its body [length]. */
    MDR_FIELD_LINE_LOAD = 3,    /**< q(x), the line load of the one-dimensional springs, equations (5), (21), 0 <= x <= a, or to
                                     zone_radius [modulus length]. */
    MDR_FIELD_DISPLACEMENT_LOWER = 4, /**< u(r) of the medium, or of the lower of two bodies, into that body: where its surface was
                                           flat, the shape of the deformed interface for r <= a [length]. */
    MDR_FIELD_DISPLACEMENT_UPPER = 5  /**< u(r) of the upper body, into that body; 0 for a rigid indenter [length]. */
};

/** States from depths, forces or radii.
 *
 *  A coating far stiffer than the body, from 80 times under a cone, from 12 times at the corner of a wide flat end, bends so much
 *  that depth and force fall over some radii. Of several states of one depth or force without adhesion the one with the smallest
 *  radius is given, to which the contact grows from first touch; larger ones would pull (mdr_contact_lowest_pressure()).
 *  @param c       contact
 *  @param given   one of enum mdr_given: what `in` holds
 *  @param branch  one of enum mdr_branch: which state of an adhesive contact; not looked at for radii
 *  @param n       number of states
 *  @param in      [n] depths, forces or radii
 *  @param out     [n] states; depth 0 without adhesion is first touch, all of it 0
 *  @return also MDR_EUNREACHABLE if there is no such state, MDR_EDOMAIN beyond the end of the indenter or the medium,
 *          MDR_ENOCONVERGENCE */
int mdr_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[]);

/** States from indentation depths: mdr_contact_states() on unloading, into loose arrays. Outputs that are NULL are skipped.
 *  @param c    contact
 *  @param n    number of states
 *  @param in   [n] depths, see enum mdr_given [length]
 *  @param d    [n] or NULL: indentation depths [length]
 *  @param a    [n] or NULL: contact radii [length]
 *  @param F    [n] or NULL: normal forces [modulus length^2]
 *  @param k    [n] or NULL: stiffnesses dF/dd at constant a, 2 a E_eff(a) [modulus length]
 *  @return as mdr_contact_states() */
int mdr_contact_from_depth(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);

/** States from normal forces [modulus length^2]. Otherwise as mdr_contact_from_depth(). */
int mdr_contact_from_force(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);

/** States from contact radii [length]. Otherwise as mdr_contact_from_depth(). */
int mdr_contact_from_radius(const mdr_contact *c, int n, const double in[], double d[], double a[], double F[], double k[]);

/** The history of a contact with a viscoelastic body: depth, radius and force along a path in time, of which one is prescribed.
 *
 *  Before the first time the bodies are apart and at rest; what is prescribed then is reached in a jump, and is linear in time in
 *  between. Materials that all relax in proportion, each at a constant Poisson's ratio (layers on a rigid base), and homogeneous
 *  bodies follow from elastic curves to rounding: Lee and Radok (1960) while the contact grows, Ting (1966) after the maximum.
 *  Any other body or path, as a contact that shrinks and grows again, is marched through time with the memory of all layers, under
 *  the model exact and unless a dashpot is in parallel at the surface; power laws are sums of exponentials there.
 *  @param c          contact
 *  @param given      one of enum mdr_given
 *  @param tolerance  of marching, relative to the largest depth, radius and force; 1e-9 to 1e-2, 1e-5 is a good choice
 *  @param n          number of times
 *  @param time       [n] strictly ascending [time]
 *  @param in         [n] depths, < 0 where the bodies are apart [length], forces >= 0 [modulus length^2] or radii >= 0 [length]
 *  @param d          [n] or NULL: depths [length]
 *  @param a          [n] or NULL: contact radii, 0 where the bodies are apart [length]
 *  @param F          [n] or NULL: forces [modulus length^2]
 *  @return MDR_EINVALID also for elastic bodies, for what can be marched only and is not offered, and where a contact that grows
 *          again would not be one disc; MDR_EUNREACHABLE, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[],
                        double d[], double a[], double F[]);

/** The dynamic stiffness k* = k' + i k'' of a contact with a viscoelastic body that oscillates by little about a contact radius;
 *  the energy lost in a cycle is pi k'' times the amplitude squared. Exact for any materials, power laws included, under the model
 *  exact; under other models for materials that relax in proportion.
 *  @param c        contact; the indenter does not matter
 *  @param n        number of frequencies
 *  @param omega    [n] angular frequencies > 0; equal neighbours cost less [1/time]
 *  @param radius   [n] contact radii > 0 [length]
 *  @param storage  [n] k' [modulus length]
 *  @param loss     [n] k'' [modulus length]
 *  @return MDR_EINVALID also for elastic bodies; MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[], double storage[],
                                  double loss[]);

/** What answers a step at constant contact radius, as under a flat punch. */
enum mdr_step {
    MDR_STEP_RELAXATION = 1, /**< Force per depth after a step of the depth [modulus length]. */
    MDR_STEP_CREEP = 2       /**< Depth per force after a step of the force [1/(modulus length)]. */
};

/** The answer of a viscoelastic body to a step at time 0, the contact radius being held. Bodies as for
 *  mdr_contact_dynamic_stiffness().
 *  @param c       contact; the indenter does not matter
 *  @param step    one of enum mdr_step
 *  @param radius  contact radius > 0 [length]
 *  @param n       number of times
 *  @param time    [n] > 0 [time]
 *  @param out     [n] see enum mdr_step
 *  @return as mdr_contact_dynamic_stiffness() */
int mdr_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[]);

/** What the pore fluid may do at the surface of a gel. There is no default: it matters more than anything else. */
enum mdr_drainage {
    MDR_DRAINAGE_SURFACE = 1, /**< It drains everywhere, under the indenter too, which is porous or leaks along the interface. */
    MDR_DRAINAGE_SEALED = 2,  /**< No flux through the surface anywhere. */
    MDR_DRAINAGE_INDENTER = 3 /**< No flux under the indenter, pore pressure 0 beside it. */
};

/** What answers a step at time 0 at constant contact radius. */
enum mdr_poroelastic_answer {
    MDR_POROELASTIC_RELAXATION = 1, /**< Force per depth of a flat punch after a step of its depth [modulus length]. */
    MDR_POROELASTIC_CREEP = 2,      /**< Depth per force of a flat punch after a step of its force [1/(modulus length)]. */
    MDR_POROELASTIC_PARABOLOID = 3, /**< Force per depth of a paraboloid after a step of its depth d, the contact radius
                                         a = sqrt(R d) being held [modulus length]. In a true contact it grows and comes back: by up
                                         to 9 % at MDR_DRAINAGE_INDENTER, where the force is then up to 0.05 of its relaxing part
                                         off; of second order where the whole surface drains or is sealed. */
    MDR_POROELASTIC_MEAN_RELAXATION = 4, /**< Mean of the relaxation from the step on: what answers a ramp of the depth. */
    MDR_POROELASTIC_MEAN_CREEP = 5       /**< Mean of the creep from the step on: what answers a ramp of the force. */
};

/** The answers of a gel in time and under oscillation: a poroelastic half-space (Biot, incompressible constituents), or a film
 *  bonded to a rigid base that lets no fluid through, under a rigid frictionless indenter. One table, about half a second: that of a
 *  half-space serves all shear moduli, diffusivities, contact radii and times. It is compared between its nodes, see
 *  mdr_poroelastic_error(). At once F = 8 G a d as of nu = 1/2, at last F = 4 G a d/(1 - nu).
 *  @param nu        drained Poisson's ratio, -1 < nu < 1/2, at which nothing would drain
 *  @param drainage  one of enum mdr_drainage; MDR_DRAINAGE_INDENTER on a half-space only
 *  @param ratio     contact radius over the thickness of a film, 0 to 4; 0: half-space
 *  @param out       receives the handle
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE */
int mdr_poroelastic_new(double nu, int drainage, double ratio, mdr_poroelastic **out);

/** By how much a table is off between its nodes, relative, as it was compared with finer solutions there.
 *  @param p    gel
 *  @param out  receives the error */
int mdr_poroelastic_error(const mdr_poroelastic *p, double *out);

/** The answer to a step at time 0.
 *  @param p              gel
 *  @param answer         one of enum mdr_poroelastic_answer
 *  @param shear_modulus  G > 0, drained and undrained [modulus]
 *  @param diffusivity    D > 0: 2 G (1 - nu)/(1 - 2 nu) times permeability over viscosity [length^2/time]
 *  @param radius         contact radius a > 0, on a film `ratio` thicknesses [length]
 *  @param n              number of times
 *  @param time           [n] >= 0; from the table up to D t/a^2 = 1e8, solved one by one beyond [time]
 *  @param out            [n] see enum mdr_poroelastic_answer
 *  @return also MDR_EINVALID */
int mdr_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity, double radius, int n,
                             const double time[], double out[]);

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

/** Which pressure under an indenter. */
enum mdr_gel_pressure {
    MDR_POROELASTIC_TOTAL = 1, /**< The total pressure, which the indenter bears. */
    MDR_POROELASTIC_PORE = 2   /**< That of the fluid at the surface; of a film only where it is 0, MDR_DRAINAGE_SURFACE. */
};

/** Pressures under an indenter after a step of its depth at time 0, the contact radius being held; per depth [modulus/length].
 *  @param p              gel
 *  @param kind           one of enum mdr_gel_pressure
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
 *  1/(2 G k) of an incompressible half-space, (1 - nu)/(G k) of one that has drained. See mdr_medium_compliance().
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

/** Frees a gel and sets *p to NULL. p = NULL and *p = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *p is not a gel */
int mdr_poroelastic_free(mdr_poroelastic **p);

/* ---- conduction of heat or current through a circular spot ------------------------------------------------------ */

/** A layer that conducts, and the interface below it. Electrical: conductivities in S/m, potential in V, flux in A; thermal: W/(m K),
 *  K, W. */
typedef struct mdr_conductor {
    double thickness;  /**< h > 0 [length]; not used of a half-space. */
    double sigma;      /**< Conductivity > 0 into the body [conductance/length]. */
    double along;      /**< Conductivity > 0 along the surface [conductance/length]. */
    double capacity;   /**< Heat capacity >= 0 per volume; 0: the layer follows at once. */
    double resistance; /**< Area resistance >= 0 between it and what lies below (Kapitza, oxide) [length^2/conductance]. */
} mdr_conductor;

/** What layers lie on. */
enum mdr_conduction_base {
    MDR_BASE_HALF_SPACE = 1, /**< The last layer is a half-space. */
    MDR_BASE_PERFECT = 2,    /**< A perfect conductor at potential 0. */
    MDR_BASE_INSULATING = 3  /**< No flux: steady states need a sink. */
};

/** One or two bodies whose surfaces meet at a circular spot; beside it no flux passes. Potentials count from those far away.
 *  @param n           number of layers of the lower body, at least 1
 *  @param lower       [n] from the surface down
 *  @param lower_base  one of enum mdr_conduction_base
 *  @param m           number of layers of the upper body; 0: the spot of the lower one is held at a potential
 *  @param upper       [m] from the surface away
 *  @param upper_base  one of enum mdr_conduction_base; not used if m = 0
 *  @param film        area resistance >= 0 in the spot itself [length^2/conductance]
 *  @param sink        radius of the circle at which the flux leaves a body on an insulating base, potential 0 there; more than 8.5
 *                     thicknesses of that body beyond every spot (exact but for exp(-pi distance/thickness)); 0: none, and such a
 *                     body answers in time alone [length]
 *  @param out         receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base,
                       double film, double sink, mdr_conduction **out);

/** The steady conductance G = flux/potential of an equipotential spot, and its slope dG/da: 4 S a of a half-space,
 *  S = sqrt(sigma along). Relative errors below 1e-11, with a film below 1e-10.
 *  @param p            conduction
 *  @param n            number of radii
 *  @param radius       [n] a > 0, up to 1e4 thicknesses of the layers [length]
 *  @param conductance  [n] G; NULL: not wanted [conductance]
 *  @param slope        [n] dG/da; NULL: not wanted [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[]);

/** The same conduction with a table of its conductance between two radii, made once and compared with the solution between its nodes:
 *  mdr_conduction_spot() and mdr_conduction_along() read it there, some hundred nanoseconds a radius, for codes that integrate motion.
 *  @param p          conduction
 *  @param smallest   radius > 0 [length]
 *  @param largest    > smallest [length]
 *  @param tolerance  relative, of G, 1e-10 to 1e-2
 *  @param out        receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance, mdr_conduction **out);

/** A field of the steady spot at potential difference 1. */
enum mdr_conduction_field {
    MDR_CONDUCTION_FLUX = 1,      /**< Flux density through the spot; without a film it is infinite at its edge, 0 <= r < a. */
    MDR_CONDUCTION_POTENTIAL = 2, /**< Potential of a body from its own far field. */
    MDR_CONDUCTION_FLUX_Z = 3,    /**< Flux density into the body. */
    MDR_CONDUCTION_FLUX_R = 4     /**< Flux density away from the axis. */
};

/** Fields of the steady spot at potential difference 1.
 *  @param p       conduction; fields inside are not offered on an insulating base
 *  @param field   one of enum mdr_conduction_field
 *  @param radius  a > 0 [length]
 *  @param body    one of enum mdr_body; not used by MDR_CONDUCTION_FLUX
 *  @param below   at an interface with a resistance: 1 the side below it, 0 the side above
 *  @param n       number of points
 *  @param r       [n] >= 0 [length]
 *  @param z       [n] >= 0, depth below the body's own surface; may be NULL for MDR_CONDUCTION_FLUX [length]
 *  @param out     [n] potential [1], or flux density [conductance/length^2]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, int n, const double r[],
                         const double z[], double out[]);

/** What a spot answers in time. */
enum mdr_conduction_answer {
    MDR_CONDUCTION_CONDUCTANCE = 1, /**< Flux per potential of an equipotential spot [conductance]. */
    MDR_CONDUCTION_RESISTANCE = 2,  /**< Potential per flux of an equipotential spot [1/conductance]. */
    MDR_CONDUCTION_MEAN = 3,        /**< Area mean of the potential per flux under a uniform flux, the film left out. */
    MDR_CONDUCTION_CENTRE = 4,      /**< Potential in the centre per flux under a uniform flux, the film left out. */
    MDR_CONDUCTION_GAUSSIAN = 5     /**< Mean over a Gaussian probe per flux of a Gaussian pump with radii w0 and w1 (1/e^2):
                                         `radius` is sqrt(w0^2 + w1^2). */
};

/** C(k), what the surfaces answer to a wave of flux: potential over flux at wavenumber k, 1/(sqrt(sigma along) k) of a half-space at
 *  rest; of two bodies the sum of both, without the film in the spot. See mdr_medium_compliance().
 *  @param p          conduction
 *  @param omega      angular frequency >= 0, 0: steady [1/time]
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0 [1/length]
 *  @param out        [n] real parts [length/conductance]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0
 *  @return also MDR_EINVALID */
int mdr_conduction_compliance(const mdr_conduction *p, double omega, int n, const double k[], double out[], double imaginary[]);

/** Answers to exp(i omega t): complex, ahead of its cause or behind it.
 *  @param p         conduction
 *  @param answer    one of enum mdr_conduction_answer
 *  @param radius    a > 0 [length]
 *  @param n         number of frequencies
 *  @param omega     [n] angular frequencies >= 0, omega a^2/D <= 1e5 with D = along/capacity of the surface; 0: steady [1/time]
 *  @param in_phase  [n] real part
 *  @param ahead     [n] imaginary part
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[],
                              double ahead[]);

/** Answers to a step at time 0, of potential for MDR_CONDUCTION_CONDUCTANCE, else of flux.
 *  @param p       conduction
 *  @param answer  one of enum mdr_conduction_answer
 *  @param radius  a > 0 [length]
 *  @param n       number of times
 *  @param time    [n] > 0, D t/a^2 >= 1e-4 with D = along/capacity of the surface [time]
 *  @param out     [n] see enum mdr_conduction_answer
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_step(const mdr_conduction *p, int answer, double radius, int n, const double time[], double out[]);

/** Answers to any history of potential, for MDR_CONDUCTION_CONDUCTANCE, else of flux, that goes evenly from one value to the next.
 *  @param p       conduction
 *  @param answer  one of enum mdr_conduction_answer
 *  @param radius  as for mdr_conduction_admittance()
 *  @param n       number of times
 *  @param time    [n] ascending, apart as mdr_conduction_step() takes times [time]
 *  @param given   [n] the history; its first value is 0
 *  @param out     [n] flux, or potential
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[], const double given[],
                          double out[]);

/** The flux density through a spot without a film, a time after a step of its potential to 1.
 *  @param p       conduction
 *  @param radius  a > 0 [length]
 *  @param time    as for mdr_conduction_step() [time]
 *  @param n       number of points
 *  @param r       [n] 0 <= r < a [length]
 *  @param out     [n] flux density [conductance/length^2]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_step_flux(const mdr_conduction *p, double radius, double time, int n, const double r[], double out[]);

/** The steady conductance of a state of contact between rough surfaces, whose area conductance goes with the pressure: a film of
 *  area resistance kappa/p(r) in the spot, by the pressure of the state. Right to 1e-9 under smooth indenters.
 *  @param p      conduction; its own film is left out
 *  @param c      contact
 *  @param state  of that contact, a > 0, whose pressure is nowhere a tension
 *  @param kappa  > 0: area resistance times pressure [modulus length^2/conductance]
 *  @param out    receives the conductance
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa, double *out);

/** The conductance along the loading of a contact: G(a) of each state, and how it grows with the force and the depth there,
 *  dG/dF = G'(a)/F'(a), dG/dd = G'(a)/d'(a): 0 at a vertical wall.
 *  @param p            conduction
 *  @param c            contact, of bodies of the same layers or not
 *  @param n            number of states
 *  @param states       [n] of that contact, a > 0
 *  @param conductance  [n] G; NULL: not wanted [conductance]
 *  @param by_force     [n] dG/dF; NULL: not wanted [conductance/force]
 *  @param by_depth     [n] dG/dd; NULL: not wanted [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[],
                         double by_force[], double by_depth[]);

/** How the heat of friction is made. */
enum mdr_heat_motion {
    MDR_HEAT_SLIDING = 1,  /**< q = mu v p(r), the source resting on both bodies: fretting, or low speeds. */
    MDR_HEAT_SPINNING = 2, /**< q = mu omega r p(r) of a twist about the axis: exact at any speed. */
    MDR_HEAT_MOVING = 3    /**< q = mu v p(r), the source moving over the lower body, v a c/sigma <= 1000, and resting on the
                                upper one. Of two bodies the share is that of equal flux_mean, an approximation. */
};

/** The heat of friction of a state, and temperature rises of the contact over those far away. */
typedef struct mdr_friction_heat {
    double total;     /**< Q = mu v F, or mu omega times the moment of p. */
    double share;     /**< Part of it that the lower body takes: 1 without an upper one. */
    double centre;    /**< Temperature rise at r = 0, for MDR_HEAT_MOVING that of the lower body, as all below. */
    double flux_mean; /**< Its mean weighted with the heat. */
    double area_mean; /**< Its mean over the contact; 0 for MDR_HEAT_MOVING. */
    double largest;   /**< For MDR_HEAT_MOVING the largest rise on the line of motion through the centre; else 0. */
    double behind;    /**< How far behind the centre it is; else 0 [length]. */
} mdr_friction_heat;

/** The heat of friction of states and its temperatures. Two bodies share it so that their temperatures are the same all over the
 *  contact; a film in the spot is not offered then.
 *  @param p         conduction of heat
 *  @param c         contact
 *  @param n         number of states
 *  @param states    [n] of that contact, a > 0
 *  @param motion    one of enum mdr_heat_motion
 *  @param strength  mu v >= 0, heat per normal force; mu omega of MDR_HEAT_SPINNING
 *  @param speed     v > 0 of the source over the lower body, of MDR_HEAT_MOVING alone [length/time]
 *  @param out       [n] results: means as exact as the states, the centre to 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion,
                        double strength, double speed, mdr_friction_heat out[]);

/** The temperature rise that the heat of friction makes at points of a body.
 *  @param p         conduction of heat
 *  @param c         contact
 *  @param state     of that contact, a > 0
 *  @param motion    MDR_HEAT_SLIDING or MDR_HEAT_SPINNING
 *  @param strength  as for mdr_conduction_heat()
 *  @param body      one of enum mdr_body
 *  @param below     at an interface with a resistance: 1 the side below it, 0 the side above
 *  @param n         number of points
 *  @param r         [n] >= 0 [length]
 *  @param z         [n] >= 0, depth below the body's own surface [length]
 *  @param out       [n] temperature rise. At the surface near kinks of the indenter within 2e-3 of the largest, else 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion, double strength,
                              int body, int below, int n, const double r[], const double z[], double out[]);

/** Frees a conduction and sets *p to NULL. p = NULL and *p = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *p is not a conduction */
int mdr_conduction_free(mdr_conduction **p);

/** Elastic energy of either body: together int F dd from first touch, with adhesion int F dd + pi a^2 work_of_adhesion along the
 *  branch [modulus length^3].
 *  @param c      contact
 *  @param state  a state of this contact, with a radius > 0
 *  @param lower  or NULL: receives that of the medium or of the lower body
 *  @param upper  or NULL: receives that of the upper body, 0 for a rigid indenter
 *  @return also MDR_EINVALID for power-law graded media, MDR_ENOCONVERGENCE */
int mdr_contact_energy(const mdr_contact *c, const mdr_state *state, double *lower, double *upper);

/** A field of a state.
 *  @param c      contact
 *  @param field  one of enum mdr_field_kind
 *  @param state  a state of this contact, with a radius > 0
 *  @param n      number of positions
 *  @param r      [n] r or x, see enum mdr_field_kind [length]
 *  @param out    [n] values, see enum mdr_field_kind
 *  @return also MDR_EDOMAIN for a position outside the range of the field, MDR_ENOCONVERGENCE */
int mdr_contact_field(const mdr_contact *c, int field, const mdr_state *state, int n, const double r[], double out[]);

/** The lowest pressure of a state without adhesion. Below 0 the bodies would have to pull on each other: the contact is then not
 *  one disc, its pressure is not that of the true contact, and F(d) is off by up to 0.05 % (cone), 0.6 % (r^4) or 3.5 % (flat
 *  punch) at a ratio of moduli of 100; at larger ones, where the radius jumps, by as much as the force jumps there: under a cone
 *  7 % at 300, 28 % at 1,000. It happens on stiff coatings, solved exactly: from a ratio of moduli of 5 (nu = 1/2) to 7 (nu = 0)
 *  under flat ends, 6 to 10 under r^4, 8 to 12 under r^3, 12 to 20 under r^2.5, 50 to 100 under cones; never under paraboloids.
 *  It can also show outside alone: where the surface beyond the contact, MDR_FIELD_DISPLACEMENT, would pass through the indenter,
 *  u(r) < d - f(r), as under cones from a ratio of 300 on.
 *  @param c         contact without adhesion
 *  @param state     a state of this contact, with a radius > 0
 *  @param pressure  or NULL: the smallest p(r), 0 <= r <= a; 0, at the edge, where no pressure is negative [modulus]
 *  @param r         or NULL: the r that has it [length]
 *  @return also MDR_EINVALID with adhesion, MDR_ENOCONVERGENCE */
int mdr_contact_lowest_pressure(const mdr_contact *c, const mdr_state *state, double *pressure, double *r);

/** Doubts about the numbers of a state; bits of a sum. Linear elasticity gives numbers beyond its range, too. */
enum mdr_warning {
    MDR_WARNING_SLOPE = 1,       /**< The indenter's surface has a slope f'(a) of more than 1.2 at the edge of the contact: 50 degrees,
                                      or a = 1.2 R of a paraboloid, which stands for a sphere at a well below R only. */
    MDR_WARNING_PRESSURE = 2,    /**< The mean pressure is more than 0.6 of E_eff(a) and of the contact modulus of the surface, as under a flat
                                      punch at depths beyond 0.94 a; where the slope is not the reason. */
    MDR_WARNING_COMPRESSION = 4, /**< Layers are compressed by more than half of their thickness: a depth beyond that on a rigid base, and
                                      on an elastic one the depth less F/(a E1*), the most by which the base gives way. */
    MDR_WARNING_CONTRAST = 8,    /**< Young's moduli of one contact are 1e9 apart or more, as GPa beside Pa. */
    MDR_WARNING_SHORT_ZONE = 16, /**< The zone of a cohesive stress is too short to change a digit: adhesion without a range. */
    MDR_WARNING_WETTING = 32     /**< Work of adhesion above 0.05 of the surface tension, or under a plate of B^(1/3) (0.5 E*)^(2/3): the
                                      slope of the surface at the edge is not small. */
};

/** Doubts about the numbers of a state.
 *  @param c         contact
 *  @param state     a state of this contact
 *  @param buffer    receives a line of text for each warning, in the order of the codes; may be NULL if length < 1
 *  @param length    size of buffer, 1000 for all of it; what does not fit is cut off
 *  @param warnings  or NULL: the sum of codes of enum mdr_warning, 0 if there are none
 *  @return also MDR_EINVALID for a state that cannot be one of this contact */
int mdr_contact_warnings(const mdr_contact *c, const mdr_state *state, char *buffer, int length, int *warnings);

/** Which body of a contact. */
enum mdr_body {
    MDR_BODY_LOWER = 1, /**< The medium, or the lower one of two. */
    MDR_BODY_UPPER = 2  /**< The upper one of two deformable bodies; a rigid indenter is none. */
};

/** Which side of an interface between layers: sigma_rr, sigma_tt and sigma_rt jump there. */
enum mdr_side {
    MDR_SIDE_BELOW = 1, /**< That of the larger depth. */
    MDR_SIDE_ABOVE = 2  /**< That of the smaller depth. */
};

/** Displacements and stresses at a point inside a body, in cylinder coordinates (r, t, z); z and u_z point into the body, tension
 *  is positive. */
typedef struct mdr_interior {
    double u_r;  /**< Radial displacement [length]. */
    double u_t;  /**< Displacement along the circumference, 0 without friction [length]. */
    double u_z;  /**< Displacement into the body [length]. */
    double s_rr; /**< Radial stress [modulus]. */
    double s_tt; /**< Circumferential (hoop) stress [modulus]. */
    double s_zz; /**< Stress normal to the surface: -p at the surface [modulus]. */
    double s_rz; /**< Shear stress [modulus]. */
    double s_rt; /**< Shear stress, 0 without friction [modulus]. */
    double s_tz; /**< Shear stress, 0 without friction [modulus]. */
} mdr_interior;

/** Displacements and stresses inside a body of homogeneous, layered or graded material, under the state's pressure.
 *
 *  Points that form a grid of few distinct r and z cost far less than as many scattered ones. Where the load is singular on the
 *  surface (edge of a flat punch or of an adhesive contact, apex of a cone, edge of a flat end) stresses are infinite, with
 *  friction the shear tractions too; the sign is that inside the contact. What jumps there, s_rt across the edge of a flat end,
 *  has its value just below the surface, halfway. Under an approximate model it is the field in the layers under the model's own
 *  pressure, whose surface does not fit the indenter.
 *  @param c         contact
 *  @param body      one of enum mdr_body
 *  @param state     a state of this contact, with a radius > 0
 *  @param side      one of enum mdr_side, for points on an interface
 *  @param friction  f >= 0: the contact slides, with traction f p(r) in +x on the lower body and -f p(r) on the upper one, p that
 *                   of the contact without friction (Goodman). Not with adhesion.
 *  @param n         number of points
 *  @param r         [n] distances from the axis, >= 0 [length]
 *  @param z         [n] depths into the body, >= 0 [length]
 *  @param angle     [n] azimuths from +x [radian], or NULL: 0
 *  @param out       [n] displacements and stresses
 *  @return also MDR_EDOMAIN for points in a rigid base or beyond 1e12 a, MDR_EINVALID for media without E and nu, or with tension
 *          under friction, MDR_ENOCONVERGENCE */
int mdr_contact_interior(const mdr_contact *c, int body, const mdr_state *state, int side, double friction, int n, const double r[],
                         const double z[], const double angle[], mdr_interior out[]);

/** How far the field of mdr_contact_interior() is from what the contact has on its surface, by other equations: at r = 0.31 a, 0.62 a
 *  and 0.9 a s_zz from -p(r), relative to the largest pressure there or the mean one, and u_z from d - f(r), of two bodies from the
 *  body's part of it, relative to d or f(a). Under an approximate model s_zz alone, for its surface does not fit the indenter. Costs
 *  about as much as three points on the surface; one call serves all points of a state.
 *  @param c         contact
 *  @param body      one of enum mdr_body
 *  @param state     a state of this contact, with a radius > 0
 *  @param deviation receives the largest of them [1]: 1e-8 or less is usual with the default tolerance of a medium
 *  @return as mdr_contact_interior() */
int mdr_contact_interior_error(const mdr_contact *c, int body, const mdr_state *state, double *deviation);

/** Elastic energy in each layer of a body without friction, from the surface down, the half-space last (0 for a rigid base).
 *  Together they are the work of the pressure on the surface.
 *  @param c         contact
 *  @param body      one of enum mdr_body
 *  @param state     a state of this contact, with a radius > 0
 *  @param capacity  size of the array, >= 0: at most so many are written
 *  @param out       [capacity] energies [modulus length^3]
 *  @param count     receives how many there are
 *  @return also MDR_EINVALID for graded bodies and media without E and nu, MDR_ENOCONVERGENCE */
int mdr_contact_layer_energies(const mdr_contact *c, int body, const mdr_state *state, int capacity, double out[], int *count);

/** Frees a contact and sets *c to NULL. c = NULL and *c = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *c is not a contact */
int mdr_contact_free(mdr_contact **c);

/* ---- friction: partial slip at constant normal force -------------------------------------------------------------- */

/** A contact under Coulomb's law of friction. Made by mdr_friction_new(), freed by mdr_friction_free(). */
typedef struct mdr_friction mdr_friction;

/** A tangential state: a disc of stick inside an annulus of slip. The shift s of the indenter along the surface and the tangential
 *  force T have one sign. */
typedef struct mdr_tangential_state {
    double shift;             /**< s, displacement of the indenter along the surface, of distant points of two bodies [length]. */
    double tangential_force;  /**< T, |T| <= coefficient F [modulus length^2]. */
    double stick_radius;      /**< c, 0 where the contact slides [length]. */
    double stiffness;         /**< dT/ds = k_t(c), that of a contact of radius c that sticks; 0 where it slides [modulus length]. */
    double dissipated_energy; /**< Since s = 0 [modulus length^3]. */
    double sliding;           /**< 1 if the whole contact slides, else 0. */
} mdr_tangential_state;

/** Which number determines a tangential state. */
enum mdr_tangential_given {
    MDR_GIVEN_SHIFT = 1,           /**< The shift s, of either sign [length]. */
    MDR_GIVEN_TANGENTIAL_FORCE = 2 /**< The tangential force T, |T| <= coefficient F; at that bound the state in which sliding
                                        begins [modulus length^2]. */
};

/** Fields of a tangential state. */
enum mdr_tangential_field {
    MDR_FIELD_TRACTION = 1,            /**< tau(r), the shear traction along the shift, of one direction, 0 <= r <= a [modulus]. */
    MDR_FIELD_TANGENTIAL_LINE_LOAD = 2 /**< q_t(x), the line load of the springs along the shift, 0 <= x <= a [modulus length]. */
};

/** Coulomb's law in a contact: slip where the traction reaches coefficient times pressure, stick where it is less.
 *
 *  The normal force is constant; the shear does not change the pressure (as with Cattaneo and Mindlin; T would be 1 to 6 % higher),
 *  and the displacement that varies as cos 2 phi around the axis is left out (at most 0.25 % of T). Else exact on homogeneous and
 *  exact layered media; media with Gao's weights superpose punches.
 *  @param c            contact without adhesion, on a medium of mdr_medium_tangential_modulus()
 *  @param coefficient  of friction, > 0 [1]
 *  @param out          receives the handle
 *  @return also MDR_EINVALID with adhesion (Coulomb's law knows no tension) and for media whose tangential stiffness is not known,
 *          MDR_ENOCONVERGENCE */
int mdr_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out);

/** Tangential states of a normal one, from shifts or tangential forces, each reached from s = 0 in one go.
 *  @param f      contact with friction
 *  @param state  a state of its contact, with a radius > 0
 *  @param given  one of enum mdr_tangential_given: what `in` holds
 *  @param n      number of tangential states
 *  @param in     [n] shifts or tangential forces
 *  @param out    [n] tangential states
 *  @return also MDR_EUNREACHABLE beyond the force of sliding, MDR_EDOMAIN if the pressure would be negative somewhere (see
 *          mdr_contact_lowest_pressure()) or slip would begin inside the contact (a flat punch on a stiff coating),
 *          MDR_ENOCONVERGENCE. Slip that begins inside later, under flat ends and r^4 on stiff coatings, is not refused: there
 *          mdr_friction_field() gives tractions above coefficient times pressure inside the stick radius, and the states are not
 *          those of the true contact; mdr_friction_history_new() with rings gives these */
int mdr_friction_states(const mdr_friction *f, const mdr_state *state, int given, int n, const double in[],
                        mdr_tangential_state out[]);

/** Where sliding begins. Outputs that are NULL are skipped.
 *  @param f      contact with friction
 *  @param state  a state of its contact, with a radius > 0
 *  @param shift  or NULL: s at which the last point begins to slip [length]
 *  @param force  or NULL: coefficient F [modulus length^2]
 *  @return as mdr_friction_states() */
int mdr_friction_sliding(const mdr_friction *f, const mdr_state *state, double *shift, double *force);

/** A field of a tangential state.
 *  @param f      contact with friction
 *  @param state  the normal state, with a radius > 0
 *  @param shear  a tangential state of it
 *  @param field  one of enum mdr_tangential_field
 *  @param n      number of positions
 *  @param r      [n] r or x, 0 <= r <= a [length]
 *  @param out    [n] values
 *  @return also MDR_EDOMAIN for a position outside the contact, and as mdr_friction_states() */
int mdr_friction_field(const mdr_friction *f, const mdr_state *state, const mdr_tangential_state *shear, int field, int n,
                       const double r[], double out[]);

/** The loop of a cycle between +amplitude and -amplitude, by Masing's rule, which is exact here: from each turn the force changes
 *  as twice the first loading of half the way.
 *  @param f           contact with friction
 *  @param state       the normal state, with a radius > 0
 *  @param given       one of enum mdr_tangential_given: what the amplitude is
 *  @param amplitude   > 0, a force below that of sliding [length, or modulus length^2]
 *  @param n           number of points, at least 3: from +amplitude to -amplitude and back, in equal steps of the shift
 *  @param shift       [n] shifts [length]
 *  @param force       [n] tangential forces [modulus length^2]
 *  @param dissipated  energy dissipated in the cycle, the area of the loop, without loss of digits at small amplitudes
 *                     [modulus length^3]
 *  @return as mdr_friction_states() */
int mdr_friction_loop(const mdr_friction *f, const mdr_state *state, int given, double amplitude, int n, double shift[],
                      double force[], double *dissipated);

/** A state of a contact that is twisted about its axis under a constant normal force. */
typedef struct mdr_torsional_state {
    double twist;             /**< phi, angle of the indenter about the axis [radian]. */
    double torque;            /**< M, of the sign of phi [modulus length^3]. */
    double stick_radius;      /**< c, radius of the disc of stick; 0 where the contact slides [length]. */
    double stiffness;         /**< dM/dphi, that of a contact of radius c that sticks all over [modulus length^3]. */
    double dissipated_energy; /**< Energy dissipated since phi = 0 [modulus length^3]. */
    double sliding;           /**< 1 if the disc of stick is smaller than 1e-6 a, which no torque distinguishes from 0; else 0. */
} mdr_torsional_state;

/** Which number determines a torsional state. */
enum mdr_torsional_given {
    MDR_GIVEN_TWIST = 1, /**< The twist phi, of either sign [radian]. */
    MDR_GIVEN_TORQUE = 2 /**< The torque M, smaller than that of sliding [modulus length^3]. */
};

/** Torsional states of a normal one, from twists or torques, each reached from phi = 0 in one go: Lubkin's problem. The axis sticks
 *  at any twist; the disc of stick around it shrinks exponentially.
 *
 *  Pressed first, twisted then. Exact: torsion changes neither the pressure nor anything around the axis.
 *  @param f      contact with friction, on a homogeneous medium with E and nu or a pair of them
 *  @param state  a state of its contact, with a radius > 0
 *  @param given  one of enum mdr_torsional_given: what `in` holds
 *  @param n      number of torsional states
 *  @param in     [n] twists or torques
 *  @param out    [n] torsional states
 *  @return also MDR_EUNREACHABLE from the torque of sliding on, MDR_EINVALID for other media, MDR_ENOCONVERGENCE */
int mdr_torsion_states(const mdr_friction *f, const mdr_state *state, int given, int n, const double in[],
                       mdr_torsional_state out[]);

/** The torque that a growing twist approaches, coefficient times int r p dA: (3 pi/16) coefficient F a under a paraboloid.
 *  @param f       contact with friction
 *  @param state   a state of its contact, with a radius > 0
 *  @param torque  receives it [modulus length^3]
 *  @return as mdr_torsion_states() */
int mdr_torsion_sliding(const mdr_friction *f, const mdr_state *state, double *torque);

/** A field of a torsional state.
 *  @param f        contact with friction
 *  @param state    the normal state, with a radius > 0
 *  @param twisted  a torsional state of it
 *  @param field    MDR_FIELD_TRACTION: tau(r), the shear traction around the axis [modulus], or MDR_FIELD_TANGENTIAL_LINE_LOAD:
 *                  q(x) = 2 x int_x^a tau dr/sqrt(r^2 - x^2) [modulus length]
 *  @param n        number of positions
 *  @param r        [n] r or x, 0 <= r <= a [length]
 *  @param out      [n] values
 *  @return also MDR_EDOMAIN for a position outside the contact, and as mdr_torsion_states() */
int mdr_torsion_field(const mdr_friction *f, const mdr_state *state, const mdr_torsional_state *twisted, int field, int n,
                      const double r[], double out[]);

/** The loop of a cycle between +amplitude and -amplitude, by Masing's rule as mdr_friction_loop().
 *  @param f           contact with friction
 *  @param state       the normal state, with a radius > 0
 *  @param given       one of enum mdr_torsional_given: what the amplitude is
 *  @param amplitude   > 0, a torque below that of sliding [radian, or modulus length^3]
 *  @param n           number of points, at least 3: from +amplitude to -amplitude and back, in equal steps of the twist
 *  @param twist       [n] twists [radian]
 *  @param torque      [n] torques [modulus length^3]
 *  @param dissipated  energy dissipated in the cycle, the area of the loop, without loss of digits at small amplitudes
 *                     [modulus length^3]
 *  @return as mdr_torsion_states() */
int mdr_torsion_loop(const mdr_friction *f, const mdr_state *state, int given, double amplitude, int n, double twist[],
                     double torque[], double *dissipated);

/** A contact with friction and its past, along any path of normal and tangential loading; not for two threads at a time. Made by
 *  mdr_friction_history_new() or mdr_friction_history_copy(), freed by mdr_friction_history_free(). */
typedef struct mdr_friction_history mdr_friction_history;

/** A contact that has not been loaded yet.
 *
 *  Where springs do not interact, on homogeneous bodies, each step is exact, whatever its size. On exact layered bodies, and with
 *  largest_depth > 0 on homogeneous ones, the contact is cut into rings that each obey Coulomb's law: with 100 rings T is good to
 *  2e-4 coefficient F, the stick radius to a third of a ring, the energy to 2e-3. A second history with twice the rings shows the
 *  error, which becomes half of it or less. A step is divided where the edge of the contact comes to a ring's: a long step gives
 *  what many short ones give, and costs as much.
 *  @param f              contact with friction
 *  @param largest_depth  0, or the depth up to which there are rings; needed on layered bodies [length]
 *  @param rings          10 to 1000, or 0: 100
 *  @param out            receives the handle
 *  @return also MDR_EINVALID for media other than homogeneous and exact layered ones, and as mdr_contact_from_depth() */
int mdr_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out);

/** A copy with the same past, which goes its own way from here.
 *  @param h    history
 *  @param out  receives the handle */
int mdr_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out);

/** Goes on along a path of steps in which depth and shift change in proportion. After a failure the history is as before the call.
 *  @param h                 history
 *  @param normal_given      MDR_GIVEN_DEPTH or MDR_GIVEN_FORCE: what `normal` holds
 *  @param tangential_given  one of enum mdr_tangential_given: what `tangential` holds
 *  @param n                 number of steps
 *  @param normal            [n] depths or normal forces at the ends of the steps, >= 0; 0 parts the bodies
 *  @param tangential        [n] shifts or tangential forces there, |T| < coefficient F
 *  @param states            [n] normal states reached
 *  @param out               [n] tangential states reached: stick_radius is where the last step did not slip, dissipated_energy that
 *                           since the beginning
 *  @return also MDR_EUNREACHABLE for a tangential force at which the contact slides, MDR_EDOMAIN beyond the largest depth of rings
 *          or if the pressure would be negative somewhere, MDR_ENOCONVERGENCE, and as mdr_contact_states() */
int mdr_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n, const double normal[],
                                 const double tangential[], mdr_state states[], mdr_tangential_state out[]);

/** Frees a history and sets *h to NULL. h = NULL and *h = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *h is not a history of friction */
int mdr_friction_history_free(mdr_friction_history **h);

/* ---- Wear ---- */

/** A contact that wears by Archard's law, dh = k p ds. Made by mdr_wear_new(), freed by mdr_wear_free(). */
typedef struct mdr_wear mdr_wear;

/** A contact without adhesion, and how fast its two sides wear.
 *  @param c                 contact
 *  @param n                 layers of the indenter from its surface, and what lies below them: 1 without a coating
 *  @param coefficient       [n] k > 0, worn volume per force and sliding distance, of each of them [1/modulus]
 *  @param thickness         [n - 1] of the layers, > 0; NULL for n = 1 [length]
 *  @param body_coefficient  k >= 0 of the body [1/modulus]
 *  @param out               receives the handle
 *  @return also MDR_EINVALID with adhesion: there is no law of wear where surfaces pull */
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient,
                 mdr_wear **out);

/** Where fretting ends: a disc of radius c sticks for good, all outside slips and wears until it carries nothing. Exact, on layered
 *  bodies too: F = F0(c) + k(c) (d - d0(c)), and the worn indenter is the free surface, f = d - u(r), c < r < b.
 *
 *  What stick radius a prescribed shift leads to is not computed: on coatings it is not that of the first cycle.
 *  @param w             contact that wears
 *  @param state         a state of its unworn contact, with a radius > 0
 *  @param stick_radius  c, 0 < c <= a [length]
 *  @param given         what is held: MDR_GIVEN_DEPTH or MDR_GIVEN_FORCE
 *  @param reached       receives depth, stick radius, force, stiffness, and the depth beyond that of the unworn state at c
 *  @param outer_radius  receives b, up to where the indenter is worn; may be NULL [length]
 *  @param worn_volume   receives int_c^b (f - f0) 2 pi r dr, of both sides together; may be NULL [length^3]
 *  @param out           receives the worn indenter, with the wear of both sides; may be NULL
 *  @return also MDR_EDOMAIN for c > a, where the pressure would be negative, and where the indenter ends within the scar */
int mdr_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached,
                   double *outer_radius, double *worn_volume, mdr_profile **out);

/** Depth of the track that the sliding indenter leaves in the body, h(y) = k N q(y): the load that passes over a place is the line
 *  load. To first order in h/d.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param passes  N > 0 [1]
 *  @param n       number of places
 *  @param y       [n] distances from the axis of the track, >= 0 [length]
 *  @param out     [n] depths, 0 beyond the contact radius [length]
 *  @return also MDR_EDOMAIN for a track deeper than a tenth of the depth d, and where the pressure would be negative */
int mdr_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[]);

/** Passes until the track is as deep as h, N = h/(k q(0)): a coating of this thickness is then worn through.
 *  @param w       contact that wears, with body_coefficient > 0
 *  @param state   a state of its contact, with a radius > 0
 *  @param depth   h > 0 [length]
 *  @param passes  receives N [1]
 *  @return as mdr_wear_track() */
int mdr_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes);

/** l: under a flat punch what the pressure still differs by from that at the end - F/(pi a^2) at constant force, 0 at constant depth -
 *  falls as exp(-s/l) after a few l. Of a coated punch that is worn through. a/(2.060650 k E*) at constant force and
 *  a/(0.578887 k E*) at constant depth on a homogeneous body.
 *  @param w       contact of a flat punch that wears, on a homogeneous or an exact medium
 *  @param given   what is constant: MDR_GIVEN_DEPTH or MDR_GIVEN_FORCE
 *  @param length  receives l, a sliding distance [length]
 *  @return also MDR_EINVALID for other indenters and media */
int mdr_wear_running_in(const mdr_wear *w, int given, double *length);

/** Frees it and sets *w to NULL. w = NULL and *w = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *w is not a contact that wears */
int mdr_wear_free(mdr_wear **w);

/** A sliding contact and what it has lost so far; not for two threads at a time. Made by mdr_wear_history_new() or
 *  mdr_wear_history_copy(), freed by mdr_wear_history_free(). */
typedef struct mdr_wear_history mdr_wear_history;

/** What a history of wear has come to. */
typedef struct mdr_wear_state {
    double sliding;     /**< s since the beginning [length]. */
    double depth;       /**< d from the original apex of the indenter [length]. */
    double radius;      /**< a [length]. */
    double force;       /**< F [modulus length^2]. */
    double pressure;    /**< p on the axis [modulus]. */
    double worn_depth;  /**< What the indenter has lost on the axis [length]. */
    double worn_volume; /**< What it has lost as a whole [length^3]. */
    double body_depth;  /**< What the body has lost on the axis, where the same places rub on each other, else 0 [length]. */
    double body_volume; /**< The same as a whole [length^3]. */
    double work;        /**< int F ds [modulus length^3]. */
    double error;       /**< The largest relative error of a, d, F, p and the worn depth: two resolutions differ by so much. */
} mdr_wear_state;

/** What the indenter rubs on. */
enum mdr_wear_places {
    MDR_WEAR_FRESH = 1, /**< Fresh places of the body, as a tip that goes its way: the indenter alone changes. */
    MDR_WEAR_SAME = 2   /**< The same places, as both do that move back and forth by much less than a: both change. */
};

/** How a sliding contact is followed. Two resolutions, of n/2 and n intervals, march side by side; they state the error. */
enum mdr_wear_scheme {
    MDR_WEAR_DISC = 1, /**< A disc that moves with the edge of the contact, of second order, extrapolated: with 80 intervals a, d, F
                            are good to 1e-4 on bodies of any layers. For contacts that do not shrink, and no flat punch. */
    MDR_WEAR_RINGS = 2 /**< Rings that stay on the indenter, of first order: some 1e-2 with 80 intervals, but k F s is met to
                            rounding, any path of load and depth can be followed, and a flat punch too. */
};

/** What a history of wear leaves to choose. Begun by MDR_SIZED. */
typedef struct mdr_wear_options {
    size_t size;   /**< Of this structure; MDR_SIZED sets it. */
    int intervals; /**< n, a multiple of 4, 16 to 640; default 0: 80. */
    int places;    /**< Of enum mdr_wear_places; default 0: MDR_WEAR_FRESH. */
    int scheme;    /**< Of enum mdr_wear_scheme; default 0: MDR_WEAR_DISC. */
} mdr_wear_options;

/** A contact that is pressed on and has not slid yet. A step takes about a millisecond.
 *  @param w        contact that wears, on a homogeneous or an exact medium
 *  @param given    MDR_GIVEN_DEPTH or MDR_GIVEN_FORCE
 *  @param value    d [length] or F [modulus length^2] at the beginning, > 0
 *  @param options  see there; NULL: all defaults
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN where the pressure would be negative (MDR_WEAR_DISC; rings open there), MDR_EINVALID for other media */
int mdr_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options, mdr_wear_history **out);

/** An independent copy.
 *  @param h    history
 *  @param out  receives the handle */
int mdr_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out);

/** Slides on: in each part of the path depth or force goes evenly to its value at the end. After a failure the history is as before,
 *  and can go on with other values.
 *  @param h        history
 *  @param given    MDR_GIVEN_DEPTH (from the original apex) or MDR_GIVEN_FORCE
 *  @param n        number of parts
 *  @param sliding  [n] sliding distances, >= 0 [length]
 *  @param value    [n] d [length] or F [modulus length^2] at their ends, > 0
 *  @param out      [n] states at their ends
 *  @return also MDR_EDOMAIN where the contact would shrink (MDR_WEAR_DISC), as it does under a falling load, lift off, grow beyond
 *          the end of the indenter, or carry no pressure somewhere, and where a coating of the body would lose more than a quarter
 *          of its thickness */
int mdr_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[],
                             mdr_wear_state out[]);

/** What it has come to.
 *  @param h    history
 *  @param out  receives it */
int mdr_wear_history_state(const mdr_wear_history *h, mdr_wear_state *out);

/** p(r), with the resolution of the intervals.
 *  @param h    history
 *  @param n    number of positions
 *  @param r    [n] r >= 0 [length]
 *  @param out  [n] pressures, 0 outside the contact [modulus] */
int mdr_wear_history_pressure(const mdr_wear_history *h, int n, const double r[], double out[]);

/** The indenter as it is now, whose depth counts from its new apex; of the gap, where both sides wear.
 *  @param h    history
 *  @param out  receives the handle of a profile */
int mdr_wear_history_profile(const mdr_wear_history *h, mdr_profile **out);

/** The past as numbers, from which another history of the same contact goes on with the same bits.
 *  @param h         history
 *  @param capacity  of numbers
 *  @param numbers   [capacity] receives the first of them; may be NULL for capacity 0
 *  @param count     receives how many there are; may be NULL */
int mdr_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count);

/** Goes on from saved numbers.
 *  @param h        history of the same contact, with as many intervals
 *  @param n        as many as mdr_wear_history_save() gives
 *  @param numbers  [n] by mdr_wear_history_save()
 *  @return also MDR_EINVALID for numbers of another history */
int mdr_wear_history_restore(mdr_wear_history *h, int n, const double numbers[]);

/** Frees a history and sets *h to NULL. h = NULL and *h = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *h is not a history of wear */
int mdr_wear_history_free(mdr_wear_history **h);

/** Frees a contact with friction and sets *f to NULL. f = NULL and *f = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *f is not a contact with friction */
int mdr_friction_free(mdr_friction **f);

/* ---- adhesion: pull-off and loops, (28)-(32) --------------------------------------------------------------------- */

/** Where an adhesive contact breaks: first the lowest force, or depth, of all its stable states, then, by radius, where each other
 *  stable segment ends: a coated body can have several. The first is 0 without adhesion. Outputs that are NULL are skipped.
 *  @param c         contact
 *  @param control   MDR_CONTROL_FORCE or MDR_CONTROL_DEPTH
 *  @param capacity  size of the arrays, >= 0: at most so many are written; 1 for the pull-off alone
 *  @param d         [capacity] or NULL: indentation depths [length]
 *  @param a         [capacity] or NULL: contact radii [length]
 *  @param F         [capacity] or NULL: normal forces [modulus length^2]
 *  @param count     or NULL: how many there are, 0 without adhesion
 *  @return also MDR_EUNREACHABLE if no state is stable under this control, MDR_EDOMAIN if the contact is still stable at the
 *          smallest radius for which the medium is defined, MDR_ENOCONVERGENCE */
int mdr_contact_pull_off(const mdr_contact *c, int control, int capacity, double d[], double a[], double F[], int *count);

/** A cycle: approach from afar, jump into contact, press to `largest`, retract until the bodies are apart again.
 *  @param c                 contact
 *  @param control           one of enum mdr_control: what the positions of the loop are
 *  @param largest           position where the motion turns back, > 0 [length, or modulus length^2 under force control]
 *  @param points            points on each way, 2 to 1000000; jumps and their ends come on top
 *  @param spring_stiffness  > 0 for MDR_CONTROL_SPRING [modulus length], not looked at otherwise
 *  @param out               receives the handle
 *  @return also MDR_EUNREACHABLE if `largest` cannot be reached or the bodies do not stick when they touch,
 *          MDR_ENOCONVERGENCE */
int mdr_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness, mdr_loop **out);

/** The sizes of a loop. Outputs that are NULL are skipped.
 *  @param l              loop
 *  @param points         or NULL: number of points of the path
 *  @param turning_point  or NULL: index, from 0, of the last point of the approach
 *  @param jumps          or NULL: number of jumps */
int mdr_loop_size(const mdr_loop *l, int *points, int *turning_point, int *jumps);

/** The first n points of the path, or all if there are fewer. Outputs that are NULL are skipped.
 *  @param l         loop
 *  @param n         size of the arrays
 *  @param position  [n] or NULL: what is prescribed, see mdr_loop_new()
 *  @param d         [n] or NULL: indentation depths, negative where the bodies are apart [length]
 *  @param a         [n] or NULL: contact radii, 0 where they are apart [length]
 *  @param F         [n] or NULL: normal forces [modulus length^2] */
int mdr_loop_path(const mdr_loop *l, int n, double position[], double d[], double a[], double F[]);

/** Where the path jumps.
 *  @param l      loop
 *  @param n      size of the array; at most so many are written
 *  @param index  [n] indices, from 0, of the points just before each jump */
int mdr_loop_jumps(const mdr_loop *l, int n, int index[]);

/** The energy lost in the cycle, the area of the loop; under a prescribed force up to pull-off, for how far the bodies then fly apart
 *  under it is not known.
 *  @param l       loop
 *  @param energy  receives it [modulus length^3] */
int mdr_loop_dissipated_energy(const mdr_loop *l, double *energy);

/** Frees a loop and sets *l to NULL. l = NULL and *l = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *l is not a loop */
int mdr_loop_free(mdr_loop **l);

/** A work of adhesion that depends on the speed v of the contact's edge. Opening, v > 0: G = work (1 + (v/speed)^exponent); closing:
 *  G = closing_work/(1 + (|v|/closing_speed)^closing_exponent); the edge stands still while closing_work < G < work (Gent and Schultz
 *  1972, Maugis and Barquins 1978). Begun by MDR_SIZED. */
typedef struct mdr_rate_options {
    size_t size;             /**< Of this structure; MDR_SIZED sets it. */
    double work;             /**< Of an edge that just opens, > 0 [modulus length]. */
    double speed;            /**< At which the work is twice that, > 0 [length/time]. */
    double exponent;         /**< 0 < n <= 2 [1]. */
    double closing_work;     /**< Of an edge that just closes, > 0, at most `work`; default 0: `work` [modulus length]. */
    double closing_speed;    /**< At which it is half that, > 0; default 0: `speed` [length/time]. */
    double closing_exponent; /**< 0 < n <= 2; default 0: `exponent` [1]. */
    const mdr_material *material; /**< Or NULL. In place of all of the above but `work`: the surface layer, with a glassy and a relaxed
                                       modulus. G(v) is then that of a steady crack in it whose cohesion does not depend on speed, from
                                       1 to E_glassy/E_relaxed (closing: its inverse) times `work`, for a contact with the relaxed moduli
                                       that is large against the cohesive zone and slow against the material (Greenwood, Johnson 1981). */
    double cohesive_stress;  /**< Of that crack, > 0 [modulus]. */
    double largest_radius;   /**< Up to which contacts are followed, > 0 [length]. */
    double smallest_radius;  /**< At which a contact begins and ends; default 0: 1e-3 of the largest, or of that at which adhesion
                                  hands over to elasticity, where this is less [length]. */
} mdr_rate_options;

/** The contact whose edge moves at a finite speed. Samples of an elastic contact over its radius, made once, for all histories.
 *  @param c        contact, of any indenter without a flat end; its own work of adhesion is not used, its rule for the opening is
 *  @param options  the work of adhesion
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN beyond the end of indenter or medium, MDR_ENOCONVERGENCE */
int mdr_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out);

/** The work of adhesion at speeds of the edge.
 *  @param options  the work of adhesion; radii are not looked at
 *  @param n        number of speeds
 *  @param v        [n] > 0 where it opens [length/time]
 *  @param out      [n] G; `work` at v = 0 [modulus length] */
int mdr_rate_work(const mdr_rate_options *options, int n, const double v[], double out[]);

/** Against what a contact must be slow and large where the work of adhesion follows from a material: v time/a is at most 0.02 and
 *  zone/a at most 0.03 where pull-off is to be good to 2 %. Outputs that are NULL are skipped.
 *  @param options  the work of adhesion; radii are not looked at
 *  @param time     or NULL: the longest time of creep; 0 without a material [time]
 *  @param zone     or NULL: length of the cohesive zone of a crack at rest, pi E* work/(4 cohesive_stress^2); 0 without [length] */
int mdr_rate_scales(const mdr_rate_options *options, double *time, double *zone);

/** The state of a history: a record that the calling program keeps, and from which the history goes on. All 0: the bodies are apart. */
typedef struct mdr_rate_state {
    double radius;        /**< a, 0 where the bodies are apart; less than 0 at the start: in equilibrium, G = work, with the first
                               value, the largest stable one [length]. */
    double depth;         /**< d [length]. */
    double dissipated;    /**< Energy lost at the edge, int 2 pi a (G - work) v dt [modulus length^3]. */
    double work;          /**< int F dd [modulus length^3]. */
    double lowest_force;  /**< The lowest force so far, at most 0; pull-off [modulus length^2]. */
    double lowest_time;   /**< When [time], */
    double lowest_depth;  /**< where [length], */
    double lowest_radius; /**< how large the contact was [length], */
    double lowest_speed;  /**< and v of its edge [length/time]. */
    double rupture_time;  /**< When the contact broke last; 0 if it never did [time]. */
    double rupture_depth; /**< d just before [length]. */
    double ruptures;      /**< How often it broke. */
} mdr_rate_state;

/** A path in time: approach, dwell, retraction, pull-off. What is controlled is linear in time between its values.
 *
 *  da/dt = -v(G(a, t)) by an L-stable method of order 4 with steps that keep to the tolerance. Bodies that are apart touch at depth 0.
 *  Where the contact is pressed in faster than its edge can close, it grows at once to the radius without tension. Under a force bodies
 *  that have come apart stay so, and their depth is that of the rupture. Outputs that are NULL are skipped.
 *  @param r                 contact
 *  @param control           one of enum mdr_control: what `in` holds; MDR_CONTROL_SPRING: the far end of a spring, d + F/stiffness
 *  @param spring_stiffness  > 0 for MDR_CONTROL_SPRING [modulus length], not looked at otherwise
 *  @param tolerance         of ln a in each step, 1e-12 to 1e-3; 0: 1e-9
 *  @param start             at the first time
 *  @param n                 number of samples
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions; the first is reached in a jump where `start` is apart
 *  @param d                 [n] or NULL: indentation depths, those of the bodies where they are apart [length]
 *  @param a                 [n] or NULL: contact radii, 0 where they are apart [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param v                 [n] or NULL: speeds of the edge, > 0 where it opens [length/time]
 *  @param dissipated        [n] or NULL: energy lost at the edge so far [modulus length^3]
 *  @param work              [n] or NULL: int F dd so far [modulus length^3]
 *  @param end               receives what is remembered at the last time
 *  @return also MDR_EDOMAIN if the contact grows beyond largest_radius, MDR_EUNREACHABLE without an equilibrium to begin with,
 *          MDR_ENOCONVERGENCE */
int mdr_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n,
                     const double time[], const double in[], double d[], double a[], double F[], double v[], double dissipated[],
                     double work[], mdr_rate_state *end);

/** A path in time of a viscoelastic half-space whose surface the indenter attracts: a contact with a body of mdr_medium_stack() without
 *  layers, with a work_of_adhesion and a cohesive_stress. Approach, jump-in, dwell, retraction, pull-off; all loss is in the solid.
 *
 *  Each spring of the body remembers its own load (Haiat, Phan Huy, Barthel, J. Mech. Phys. Solids 51 (2003) 69), and the edges of
 *  contact and zone follow. Steps are halved until the force does not change any more; second order, extrapolated. Layers are refused
 *  (no second solution to compare with), and materials without a glassy or a relaxed modulus, flat ends, walls, and zones shorter than
 *  1e-3 of the contact radius: there mdr_rate_new() holds. Outputs that are NULL are skipped.
 *  @param c                 contact
 *  @param control           one of enum mdr_control: what `in` holds; MDR_CONTROL_SPRING: the far end of a spring, d + F/stiffness.
 *                           Under a force bodies that have come apart stay so
 *  @param spring_stiffness  > 0 for MDR_CONTROL_SPRING [modulus length], not looked at otherwise
 *  @param tolerance         of the force, relative to its largest, 1e-7 to 1e-2; 0: 1e-4
 *  @param start             all 0: the bodies are apart; radius < 0: the contact is in equilibrium with the first value, in the largest
 *                           stable state; nothing else is looked at
 *  @param n                 number of samples
 *  @param time              [n] strictly ascending [time]
 *  @param in                [n] depths, forces or positions, linear in time in between; the first is reached in a jump where the
 *                           bodies are apart
 *  @param d                 [n] or NULL: indentation depths, those of the bodies where they are apart [length]
 *  @param a                 [n] or NULL: contact radii, 0 without contact [length]
 *  @param zone_radius       [n] or NULL: outer radii of the cohesive zone, 0 where the bodies do not attract each other [length]
 *  @param F                 [n] or NULL: normal forces [modulus length^2]
 *  @param end               receives the lowest force with its time, the last rupture and int F dd; dissipated is 0: it is not known
 *                           what the body still stores
 *  @return also MDR_EINVALID for other contacts and where the contact would not be one disc, MDR_EUNREACHABLE without a stable state
 *          to begin with, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance,
                                 const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[],
                                 double zone_radius[], double F[], mdr_rate_state *end);

/** Frees a contact with a rate and sets *r to NULL. r = NULL and *r = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *r is not one */
int mdr_rate_free(mdr_rate **r);

/* ---- closed forms: paraboloid and cone on an incompressible coating (nu = 1/2), (24), (27), (29), (31), (32) ------- */

/** F(a) of a paraboloid without adhesion, equation (24), xi = h/a:
 *  (16 a^3/(3R)) [G1 + (G0 - G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)].
 *  @param n                number of radii
 *  @param a                [n] contact radii > 0 [length]
 *  @param radius           R > 0 [length]
 *  @param coating_shear    shear modulus G0 > 0 [modulus]
 *  @param substrate_shear  shear modulus G1 > 0 [modulus]
 *  @param thickness        h > 0 [length]
 *  @param out              [n] forces [modulus length^2] */
int mdr_coated_paraboloid_force(int n, const double a[], double radius, double coating_shear, double substrate_shear,
                                double thickness, double out[]);

/** F(a) of a cone without adhesion, equation (27): 2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)].
 *  @param inclination  phi, 0 < phi < pi/2 [radian]; otherwise as mdr_coated_paraboloid_force() */
int mdr_coated_cone_force(int n, const double a[], double inclination, double coating_shear, double substrate_shear,
                          double thickness, double out[]);

/** d(a) of an adhesive paraboloid by the source's rule, equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)).
 *  @param work_of_adhesion  gamma >= 0 [modulus length]
 *  @param out               [n] indentation depths [length]; otherwise as mdr_coated_paraboloid_force() */
int mdr_coated_paraboloid_adhesive_depth(int n, const double a[], double radius, double coating_shear, double substrate_shear,
                                         double thickness, double work_of_adhesion, double out[]);

/** a_c = (pi gamma R^2/(32 G1))^(1/3), the contact radius at which an uncoated contact breaks under depth control, equation (31).
 *  @param radius            R > 0 [length]
 *  @param substrate_shear   G1 > 0 [modulus]
 *  @param work_of_adhesion  gamma > 0 [modulus length]
 *  @param out               receives a_c [length] */
int mdr_adhesive_radius_scale(double radius, double substrate_shear, double work_of_adhesion, double *out);

/** d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3), minus the depth there, equation (31). Arguments as mdr_adhesive_radius_scale(). */
int mdr_adhesive_depth_scale(double radius, double substrate_shear, double work_of_adhesion, double *out);

/** d/d_c at a/a_c, equation (32): at^2/3 - (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2).
 *  @param n                  number of radii
 *  @param reduced_radius     [n] at = a/a_c > 0 [1]
 *  @param shear_ratio        tau = G0/G1 > 0 [1]
 *  @param reduced_thickness  ht = h/a_c > 0 [1]
 *  @param out                [n] d/d_c [1] */
int mdr_reduced_adhesive_depth(int n, const double reduced_radius[], double shear_ratio, double reduced_thickness, double out[]);

/* ---- laterally heterogeneous structures: E_eff(a, x, y), equation (33); docs/lateral.md ------------------------------- */

/** A half-space z > 0 whose moduli vary in all directions. Made by mdr_structure_shapes(), mdr_structure_voxels() or
 *  mdr_structure_callback(), freed by mdr_structure_free(). */
typedef struct mdr_structure mdr_structure;

/**
 * A user's structure. Unlike an mdr_function it is kept, and called in every evaluation, in the thread that evaluates.
 * @param x        position along the surface [length]
 * @param y        position along the surface [length]
 * @param z        depth > 0 [length]
 * @param E        receives Young's modulus > 0 [modulus]
 * @param nu       receives Poisson's ratio, -1 < nu <= 1/2 [1]
 * @param context  the pointer given with the function
 * @return         0, or any other number to report a failure: the evaluation then ends with MDR_ECALLBACK
 */
typedef int (*mdr_field)(double x, double y, double z, double *E, double *nu, void *context);

/** Shapes of bodies in a half-space, with their parameters in order; all but directions are [length]. */
enum mdr_shape {
    MDR_SHAPE_LAYER = 0,      /**< z_top, z_bottom > z_top; INFINITY is allowed. */
    MDR_SHAPE_HALF_SPACE = 1, /**< x, y, z of a point on the interface; x, y, z of the normal, of any length, into the material. */
    MDR_SHAPE_BALL = 2,       /**< x, y, z of the centre; radius > 0. */
    MDR_SHAPE_FIBRE = 3,      /**< Endless round cylinder: x, y, z of a point on the axis; x, y, z of its direction, of any
                                   length; radius > 0. */
    MDR_SHAPE_PILLAR = 4,     /**< Upright round cylinder: x, y of the axis; radius > 0; z_top, z_bottom > z_top; INFINITY is
                                   allowed. */
    MDR_SHAPE_BOX = 5         /**< x_low, x_high, y_low, y_high, z_top, z_bottom, ascending in pairs. */
};

/** What a structure leaves to choose. Begun by MDR_SIZED; a structure looks only at what concerns
 *  it. */
typedef struct mdr_structure_options {
    size_t size;         /**< Of this structure; MDR_SIZED sets it. */
    double reference_nu; /**< Poisson's ratio of the weights, -1 < nu <= 1/2 [1]; default: that of the background, or the mean
                              over all voxels. */
    double tolerance;    /**< Shapes, functions: relative error of G_eff and nu_eff, 1e-10 to 0.1; default 1e-5. */
    int padded;          /**< Voxels: 0: the array repeats itself in x and y (default); else one material lies beside it. */
    int images;          /**< Voxels that repeat: periods that count cell by cell, 1 to 100; beyond them each slice counts with its
                              mean; default 1. */
    double beside_E;     /**< Padded voxels: Young's modulus of what lies beside, > 0 [modulus]. */
    double beside_nu;    /**< Padded voxels: its Poisson's ratio, -1 < nu <= 1/2 [1]. */
    double origin[2];    /**< Voxels: x and y of the array's lower corner; default 0 [length]. */
    double exponent;     /**< p of the power mean G_eff = [sum w G^p]^(1/p): -1 (series) to 1 (parallel, the default), 0 for the
                              logarithm's. At one Poisson's ratio the exact E_eff lies between those of -1 and 1. */
    int reference_nu_is_given; /**< Not 0: a reference_nu of 0 is meant. */
    int exponent_is_given;     /**< Not 0: an exponent of 0 is meant. */
} mdr_structure_options;

/** Bodies in a background; where they overlap, the later one is there. What lies above the surface z = 0 does not count.
 *  @param E           Young's modulus of the background > 0 [modulus]
 *  @param nu          its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param n           number of bodies
 *  @param kind        [n] one of enum mdr_shape each
 *  @param parameters  [7 n] seven numbers for each body, those of its shape first; the rest is not looked at
 *  @param shape_E     [n] Young's moduli > 0 [modulus]
 *  @param shape_nu    [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param options     NULL for the defaults
 *  @param out         receives the handle */
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[],
                         const double shape_E[], const double shape_nu[], const mdr_structure_options *options,
                         mdr_structure **out);

/** An array of cells of one phase each, on a half-space. Cell (i, j, k) fills origin + (i ... i+1) spacing[0] in x, (j ... j+1)
 *  spacing[1] in y, and the depths k spacing[2] ... (k+1) spacing[2].
 *  @param size      [3] number of cells in x, y and z, each at least 1
 *  @param labels    [size[0] size[1] size[2]] phase of cell (i, j, k), 0 ... phases - 1, at (k size[1] + j) size[0] + i
 *  @param phases    number of phases, at least 1
 *  @param E         [phases] Young's moduli > 0 [modulus]
 *  @param nu        [phases] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param spacing   [3] edge lengths of a cell in x, y and z > 0 [length]
 *  @param below_E   Young's modulus of the half-space under the array > 0 [modulus]
 *  @param below_nu  its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param options   NULL for the defaults
 *  @param out       receives the handle */
int mdr_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[],
                         const double spacing[3], double below_E, double below_nu,
                         const mdr_structure_options *options, mdr_structure **out);

/** A structure of smooth functions of position; for those with jumps shapes or voxels are the better description.
 *  @param field         E and nu at a point; it and its context must live as long as the structure
 *  @param context       passed on to field, may be NULL
 *  @param reference_nu  Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param options       tolerance and exponent; NULL for the defaults
 *  @param out           receives the handle */
int mdr_structure_callback(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options,
                           mdr_structure **out);

/** E_eff(a, x, y) = 2 G_eff/(1 - nu_eff), to first order in the contrast of the moduli, equation (33).
 *  @param s    structure
 *  @param n    number of contacts
 *  @param x    [n] centres of the contacts [length]
 *  @param y    [n] centres of the contacts [length]
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] E_eff [modulus]
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE where the tolerance is not met */
int mdr_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[], double out[]);

/** The medium that an indenter meets at (x, y): a table of E_eff(a, x, y) as mdr_medium_table() takes it.
 *  @param s                structure
 *  @param x                centre of the contact [length]
 *  @param y                centre of the contact [length]
 *  @param smallest_radius  > 0 [length]
 *  @param largest_radius   > smallest_radius [length]
 *  @param points           number of radii, evenly spaced in ln a, 3 to 1000000
 *  @param out              receives the handle
 *  @return also as mdr_structure_modulus() */
int mdr_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius, int points,
                         mdr_medium **out);

/** Frees a structure and sets *s to NULL. s = NULL and *s = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *s is not a structure */
int mdr_structure_free(mdr_structure **s);

/** The weights with which shear modulus and Poisson's ratio at a point enter G_eff and nu_eff: densities whose integral over the
 *  half-space is 1, in units of a. Both are infinite at the edge of the contact, rho = 1, z = 0.
 *  @param n        number of points
 *  @param rho      [n] distances from the contact's axis >= 0, in units of a [1]
 *  @param z        [n] depths >= 0, in units of a [1]
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param shear    [n] weights of the shear modulus [1]
 *  @param poisson  [n] weights of Poisson's ratio [1] */
int mdr_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[]);

/** The weights integrated over the cells between lines, relative to the contact's axis, and two depths.
 *  @param nu        Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param a         contact radius > 0 [length]
 *  @param z_top     >= 0 [length]
 *  @param z_bottom  > z_top [length]
 *  @param nx        number of cells in x, at least 1
 *  @param x         [nx + 1] lines, strictly ascending [length]
 *  @param ny        number of cells in y, at least 1
 *  @param y         [ny + 1] lines, strictly ascending [length]
 *  @param shear     [ny nx] weights of the shear modulus, that of cell (i, j) at j nx + i [1]
 *  @param poisson   [ny nx] weights of Poisson's ratio, in the same order [1] */
int mdr_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny, const double y[],
                      double shear[], double poisson[]);

/** Points and weights for sums over smooth structures, G_eff = sum of weight * G(x + a point): what mdr_structure_callback()
 *  uses.
 *  @param order    1 to 200; the rule has N = 6 order^3 points
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param points   [3 N] x, y, z of each point, relative to the contact's centre and in units of a [1]
 *  @param weights  [2 N] weights of the shear modulus and of Poisson's ratio at each point, with sum 1 each [1]
 *  @return MDR_ECANCELLED leaves part of a rule in both arrays */
int mdr_lateral_rule(int order, double nu, double points[], double weights[]);

/* ---- compiled laws: F(d), a(d), k(d) and their inverses for the price of a short polynomial; docs/laws.md ------------ */

/** The law of one contact over a range of depths, made once, verified against the contact, then evaluated in nanoseconds.
 *  Unlike a contact it has an answer for bodies that are apart: 0. Made by mdr_law_new(), mdr_law_with_radius(), mdr_law_load() or
 *  mdr_law_read(), freed by mdr_law_free(). */
typedef struct mdr_law mdr_law;

/** What a law is made with. Begun by MDR_SIZED. */
typedef struct mdr_law_options {
    size_t size;             /**< Of this structure; MDR_SIZED sets it. */
    double smallest_depth;   /**< Without adhesion: depth > 0 from which on the tolerance holds, at most half the largest; nearer
                                  to first touch the law follows a power of d. Default 0: 1e-4 of the largest [length]. */
    double tolerance;        /**< Of F, a and k, relative, 1e-12 to 1e-2; with adhesion relative to |F| + |d dF/dd|;
                                  default 1e-9. */
    const char *description; /**< The problem in words, kept in the file; default NULL: none. */
    int continue_beyond;     /**< Not 0: beyond the largest depth and force the law answers too, along the tangent there, and says
                                  so in mdr_law_point.beyond: one hard collision does not end a run. Default 0: it refuses. */
    const mdr_friction *friction; /**< Of the contact that the law is made from: the law has tangential forces too,
                                       mdr_law_advance(). Default NULL: none. */
    int sliders;             /**< With friction: vector sliders for the springs of a contact, 4 to 64; errors fall about as
                                  sliders^-1.6, time and records grow in proportion. 16 for finite elements. Default 0: 8. */
    double shear_strength;   /**< > 0, in place of friction: the contact slips where its shear traction reaches this constant, as
                                  smooth dry contacts with adhesion do; on homogeneous bodies, with or without adhesion. What
                                  mdr_law_advance() takes is then the contact radius in place of the normal force. Default 0: none
                                  [modulus]. */
    const mdr_conduction *conduction; /**< Of the same bodies: the law has their conductance too, mdr_law_conductance(), within the
                                           tolerance. Default NULL: none. */
    int twist;               /**< With friction, not 0: the sliders bear the twist of the contact about its normal in place of the
                                  shift. What mdr_law_advance() takes and gives is then the twist phi [1] and the torque M
                                  [modulus length^3], in the first of three components; the others are 0. For paraboloids on
                                  homogeneous bodies. A contact that shifts and twists has two laws and two records, which do not
                                  know of each other: what the traction of one leaves to the other is neglected. Default 0. */
} mdr_law_options;

/** A state of a law. */
typedef struct mdr_law_point {
    double depth;     /**< d [length]. All others are 0 where the bodies are apart. */
    double force;     /**< F [modulus length^2]. */
    double slope;     /**< dF/dd along the branch, which implicit codes need; k without adhesion [modulus length]. */
    double radius;    /**< a [length]. */
    double stiffness; /**< k, dF/dd at constant a [modulus length]. */
    double energy;    /**< U = int F dd along the branch, from first touch on (elastic energy), with adhesion from pull-off on
                           [modulus length^3]. */
    double beyond;    /**< How far d lies beyond the largest depth, where the numbers are those of a tangent and no longer those of
                           the contact; 0 within the range [length]. */
} mdr_law_point;

/** Compiles the law of a contact.
 *  @param contact        contact, with or without adhesion
 *  @param largest_depth  > 0 [length]
 *  @param options        NULL for the defaults
 *  @param out            receives the handle
 *  @return also as mdr_contact_from_depth() and mdr_contact_pull_off(); MDR_ENOCONVERGENCE if the tolerance is not met; with
 *          friction also as mdr_friction_states(), and MDR_EINVALID if it is of another contact */
int mdr_law_new(const mdr_contact *contact, double largest_depth, const mdr_law_options *options, mdr_law **out);

/** The law of the same bodies for a paraboloid of another radius R, from the law for R0, without adhesion: on any linear bodies
 *  F(d; R) = (R0/R) F0(d R/R0) with the same a and k, up to the largest depth times R0/R.
 *  @param law     law
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle
 *  @return also MDR_EINVALID for adhesive laws (they hold for other radii only where work of adhesion times R^2 stays the same),
 *          for indenters other than paraboloids, and for laws of files that do not hold the radius. Friction is kept; records are
 *          those of one law */
int mdr_law_with_radius(const mdr_law *law, double radius, mdr_law **out);

/** The force at one depth. In inner loops see mdrcontact_law.h, which has the same inline.
 *  @param law     law
 *  @param branch  one of enum mdr_branch
 *  @param d       indentation depth up to the largest one; F and slope are 0 where the bodies are apart [length]
 *  @param F       or NULL: normal force [modulus length^2]
 *  @param slope   or NULL: dF/dd along the branch [modulus length]
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope);

/** The state at one depth.
 *  @param law     law
 *  @param branch  one of enum mdr_branch
 *  @param d       indentation depth up to the largest one [length]
 *  @param point   receives the state
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_at_depth(const mdr_law *law, int branch, double d, mdr_law_point *point);

/** The state under one normal force.
 *  @param law     law
 *  @param branch  one of enum mdr_branch
 *  @param F       force >= 0, with adhesion on unloading down to the pull-off force [modulus length^2]
 *  @param point   receives the state
 *  @return also MDR_EUNREACHABLE below the lowest force, MDR_EDOMAIN beyond the largest */
int mdr_law_at_force(const mdr_law *law, int branch, double F, mdr_law_point *point);

/** The state at one depth of a contact with a history: an open contact closes at d >= 0, a closed one stays on its stable
 *  segment until that ends, by pull-off or by a jump to another one.
 *  @param law      law
 *  @param d        indentation depth up to the largest one [length]
 *  @param segment  where the contact is: 0 for open before the first call, then what the last call left there
 *  @param point    receives the state
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_follow(const mdr_law *law, double d, int *segment, mdr_law_point *point);

/** States from indentation depths. Outputs that are NULL are skipped.
 *  @param law      law
 *  @param branch   one of enum mdr_branch
 *  @param n        number of states
 *  @param d        [n] depths up to the largest one; all outputs are 0 where the bodies are apart [length]
 *  @param F        [n] or NULL: normal forces [modulus length^2]
 *  @param slope    [n] or NULL: dF/dd along the branch [modulus length]
 *  @param a        [n] or NULL: contact radii [length]
 *  @param k        [n] or NULL: stiffnesses dF/dd at constant a [modulus length]
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_from_depth(const mdr_law *law, int branch, int n, const double d[], double F[], double slope[], double a[],
                       double k[]);

/** States from normal forces. Outputs that are NULL are skipped.
 *  @param law         law
 *  @param branch      one of enum mdr_branch
 *  @param n           number of states
 *  @param F           [n] forces >= 0, with adhesion on unloading down to the pull-off force [modulus length^2]
 *  @param d           [n] or NULL: indentation depths [length]
 *  @param compliance  [n] or NULL: dd/dF along the branch [1/(modulus length)]
 *  @param a           [n] or NULL: contact radii [length]
 *  @param k           [n] or NULL: stiffnesses dF/dd at constant a [modulus length]
 *  @return also MDR_EUNREACHABLE below the lowest force, MDR_EDOMAIN beyond the largest */
int mdr_law_from_force(const mdr_law *law, int branch, int n, const double F[], double d[], double compliance[], double a[],
                       double k[]);

/** Energies U = int F dd along the branch, as in mdr_law_point.
 *  @param law     law
 *  @param branch  one of enum mdr_branch
 *  @param n       number of states
 *  @param d       [n] depths up to the largest one [length]
 *  @param U       [n] energies; 0 where the bodies are apart [modulus length^3]
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_energy(const mdr_law *law, int branch, int n, const double d[], double U[]);

/** Conductances G of a law that was made with a conduction, and dG/dd along the branch. Outputs that are NULL are skipped. Beyond
 *  the largest depth of a law that goes on there G is that at its end, as a and k are.
 *  @param law          law with options.conduction
 *  @param branch       one of enum mdr_branch
 *  @param n            number of states
 *  @param d            [n] depths up to the largest one; G is 0 where the bodies are apart [length]
 *  @param conductance  [n] or NULL: G [conductance]
 *  @param slope        [n] or NULL: dG/dd [conductance/length]
 *  @return also MDR_EDOMAIN beyond the largest depth, MDR_EINVALID for other laws */
int mdr_law_conductance(const mdr_law *law, int branch, int n, const double d[], double conductance[], double slope[]);

/** What a law is. */
typedef struct mdr_law_facts {
    size_t size;            /**< Of this structure; MDR_SIZED sets it. */
    double lowest_depth;    /**< The compiled range begins here: at pull-off with adhesion [length]. */
    double highest_depth;   /**< The compiled range ends here [length]. */
    double lowest_force;    /**< The same for the force [modulus length^2]. */
    double highest_force;   /**< The same for the force [modulus length^2]. */
    double tolerance;       /**< The tolerance that was set, relative. */
    double error;           /**< The largest relative error found when the law was verified against the contact. */
    int solutions;          /**< Contact states computed to make and verify the law. */
    int adhesive;           /**< 1 with adhesion, else 0. */
    int segments;           /**< Number of stable segments under depth control. */
    int description_length; /**< Of the description, without its closing zero. */
    int continue_beyond;    /**< 1 if it answers beyond its range too, else 0. */
    int sliders;            /**< How many vector sliders stand for the springs of a contact; 0 in a law without friction. */
    int memory_size;        /**< How many numbers the record of a contact has, 11 + 4 sliders; 0 in a law without friction. */
    double coefficient;     /**< Of friction; 0 in a law without it [1]. */
    double highest_sliding_shift; /**< The shift of first shear at which the contact slides under the highest force [length]. */
    double first_shear_error; /**< The largest error of T found in first shear at constant F, relative to coefficient F: near 2 %
                                   with 8 sliders at most, 0.6 % with 16. */
    double path_error;      /**< The largest error of T found along cycles of depth and shift against the exact history, relative to
                                 the largest coefficient F; -1 on bodies other than homogeneous ones. */
    int buffer_size;        /**< How many numbers mdr_law_buffer() writes. */
    double shear_strength;  /**< Where that is constant: coefficient and path_error are then 0 and -1, first_shear_error is relative
                                 to T in sliding, and highest_sliding_shift is that of the largest contact radius; else 0
                                 [modulus]. */
    int conducts;           /**< 1 if it was made with a conduction, else 0. */
    int twists;             /**< 1 if its sliders bear a twist: first_shear_error is then relative to the torque of sliding,
                                 highest_sliding_shift 0, for the axis sticks at any twist, and path_error -1; else 0. */
} mdr_law_facts;

/** What a law is.
 *  @param law    law
 *  @param facts  begun by MDR_SIZED; receives it */
int mdr_law_info(const mdr_law *law, mdr_law_facts *facts);

/** What the first number of a law's buffer is. */
enum mdr_law_format { MDR_LAW_FORMAT = 1296843313 /**< This version. */ };

/** How the buffer of a law begins. Counts, places and flags are doubles too; places count numbers from the beginning. */
typedef struct mdr_law_head {
    double format;         /**< MDR_LAW_FORMAT. */
    double size;           /**< How many numbers the buffer has. */
    double adhesive;       /**< 1 with adhesion, else 0. */
    double continues;      /**< 1 if the law answers beyond its largest depth, along the tangent there; else 0. */
    double end_radius;     /**< Radius of the indenter's flat end [length]. */
    double lowest;         /**< The compiled range begins here [length]. */
    double highest;        /**< The compiled range ends here [length]. */
    double open_loading;   /**< Up to this depth the bodies are apart on loading [length]. */
    double open_unloading; /**< The same on unloading [length]. */
    double first_force;    /**< Without adhesion, from depth 0 to the lowest: F = first_force (d/lowest)^force_power
                                [modulus length^2]. */
    double first_radius;   /**< There a = end_radius + first_radius (d/lowest)^radius_power [length]. */
    double force_power;    /**< See first_force. */
    double radius_power;   /**< See first_radius. */
    double direct;         /**< The number of the interval that answers without search; -1: none. */
    double segment_count;  /**< Stable segments of the branch, by ascending radius. */
    double segments;       /**< Place of the first mdr_law_segment. */
    double interval_count; /**< Intervals, those of a segment one after the other. */
    double intervals;      /**< Place of the first mdr_law_interval. */
    double panel_count;    /**< Panels, those of an interval one after the other. */
    double force;          /**< Place of the coefficients of F, [8] for each panel; a multiple of 8. */
    double contact;        /**< Place of those of a and k, [8] and [8] for each panel. */
    double energy;         /**< Place of U in the middle of each panel. Of a law that conducts the coefficients of G, [8] for each
                                panel, begin at the next multiple of 8 behind: size shows whether they are there. */
} mdr_law_head;

/** A stable segment of a law. */
typedef struct mdr_law_segment {
    double lowest;  /**< It begins at this depth [length]. */
    double highest; /**< It ends at this depth [length]. */
    double first;   /**< Its first interval, counted from 0. */
    double last;    /**< Its last interval. */
} mdr_law_segment;

/** An interval of a law, cut into panels: each octave of y = scale d + offset, or with a root scale sqrt(side (d - origin)) + offset,
 *  into 2^bits of one length, from y = 1 on. In a panel F, a and k are polynomials of degree 7 of y less the panel's middle. */
typedef struct mdr_law_interval {
    double lowest;        /**< It begins at this depth [length]. */
    double highest;       /**< It ends at this depth [length]. */
    double scale;         /**< Of y [1/length, with a root its square root]. */
    double offset;        /**< Of y. */
    double last_y;        /**< y is at least 1 and at most this. */
    double is_root;       /**< 1 with a root, else 0. */
    double origin;        /**< Where the root begins [length]. */
    double side;          /**< 1 above the origin, -1 below. */
    double smallest_root; /**< dy/dd is taken with a root of at least this [square root of a length]. */
    double bits;          /**< Panels in an octave, as a power of 2. */
    double first_panel;   /**< The number of its first panel, counted from 0. */
} mdr_law_interval;

/** A law as one array of numbers without addresses: for the memory of a device, memory that processes share, a file that they map.
 *  The inline functions of mdrcontact_law.h evaluate it where it lies, with the same bits; friction is not in it. It begins with an
 *  mdr_law_head.
 *  @param law     law
 *  @param size    how many numbers the buffer takes: at least buffer_size of mdr_law_facts
 *  @param buffer  [size] receives the numbers; for speed at a multiple of 64 bytes */
int mdr_law_buffer(const mdr_law *law, int size, double buffer[]);

/** The problem a law was made from, in the words of the options.
 *  @param law     law
 *  @param buffer  receives the text; may be NULL if length < 1
 *  @param length  size of buffer, description_length + 1 for all of it; what does not fit is cut off */
int mdr_law_description(const mdr_law *law, char *buffer, int length);

/** Writes a law to a file, which it replaces: a text with version, description and checksum, for any machine. The file is complete
 *  or as it was before, also while other threads read it. A symbolic link is followed.
 *  @param law   law
 *  @param path  name of the file; what exists under it must be a regular file
 *  @return also MDR_EFILE if it cannot be written */
int mdr_law_save(const mdr_law *law, const char *path);

/** Reads a law that was saved from any of the library's languages.
 *  @param path  name of the file
 *  @param out   receives the handle
 *  @return also MDR_EFILE if the file cannot be read, is damaged, or is none of a law */
int mdr_law_load(const char *path, mdr_law **out);

/** The content of a law's file, in memory.
 *  @param law          law
 *  @param buffer       receives the content, if it fits; may be NULL if length < 1
 *  @param length       size of buffer
 *  @param full_length  receives the number of bytes of the content */
int mdr_law_write(const mdr_law *law, char *buffer, int length, int *full_length);

/** A law from the content of its file.
 *  @param buffer  the content
 *  @param length  number of bytes
 *  @param out     receives the handle
 *  @return also MDR_EFILE if the content is damaged, or is none of a law */
int mdr_law_read(const char *buffer, int length, mdr_law **out);

/** Frees a law and sets *law to NULL. law = NULL and *law = NULL are allowed.
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if *law is not a law */
int mdr_law_free(mdr_law **law);

/* ---- the tangential force of compiled laws with friction ----------------------------------------------------------- */

/* The tangential force T of contacts in codes that integrate motion, step by step, along any path of the shift in the plane and of
 * the normal force: stick, partial slip, sliding, and what earlier slip left behind. The springs of the contact are divided among
 * a few vector sliders; no path yields energy, T is continuous, and each step has a derivative. How far it can be trusted:
 * docs/laws.md.
 *
 * The memory of a contact is a record that the calling program keeps: memory_size numbers (of mdr_law_facts), all 0 before the first step. It may
 * be copied and stored; what stands in it is the library's. Records of n contacts follow each other in one array. Records of
 * another law are refused, and so are laws without friction: MDR_EINVALID. */

/** One step of n contacts, straight in shift and S = int dF/k_t; errors are of first order in how far the shift turns in a step: a
 *  step that turns aside should be no longer than 0.2 of the shift of sliding. Any number of threads may call it with different
 *  records. A failed call advances none of the contacts.
 *  @param law      law with friction
 *  @param n        number of contacts
 *  @param force    [n] normal forces F at the end of the step, >= 0 [modulus length^2]; where the shear strength is constant the
 *                  contact radii a in their place [length]. 0 parts the bodies
 *  @param shift    [3 n] x, y, z of the shift of each contact in this step, in its tangent plane [length]
 *  @param tangent  receives [12 n]: of each contact, for each component i of T, dT_i/dx, dT_i/dy, dT_i/dz by the shift of the step
 *                  [modulus length] and dT_i/dF [1], or dT_i/da [modulus length]; or NULL
 *  @param memory   [memory_size n] the records
 *  @param T        receives [3 n] the tangential forces on the medium [modulus length^2]
 *  @return also MDR_EDOMAIN beyond the largest force, unless the law continues beyond it */
int mdr_law_advance(const mdr_law *law, int n, const double force[], const double shift[], double tangent[], double memory[],
                    double T[]);

/** What mdr_law_advance() would give; the records stay as they are. For Newton's method, and for steps that may have to be
 *  taken back. Arguments as there. */
int mdr_law_try(const mdr_law *law, int n, const double force[], const double shift[], double tangent[], const double memory[],
                double T[]);

/** Energies of n contacts under shear, stored by the springs and taken by slip, slider by slider. Together they are the work of T,
 *  up to terms of the order of a step squared; along a line under constant F they do not depend on the steps. What is dissipated
 *  never falls. Work of F is not contained: it does not depend on the shift.
 *  @param law         law with friction
 *  @param n           number of contacts
 *  @param memory      [memory_size n] the records
 *  @param stored      receives [n] what the springs hold; or NULL [modulus length^3]
 *  @param dissipated  receives [n] what slip has taken since the first step, also of contacts lost since; or NULL
 *                     [modulus length^3]
 *  @return also MDR_EINVALID for a record of another law */
int mdr_law_energies(const mdr_law *law, int n, const double memory[], double stored[], double dissipated[]);

/** Turns records with their tangent planes, by the least rotation from the old normal to the new one and by an angle about that:
 *  before the steps of bodies that roll or turn. Energies stay. The first turn makes the normal known: contacts whose planes turn
 *  are turned before their first step too. Not needed where the plane stays, or where shifts are given in coordinates that turn
 *  with the contact.
 *  @param law     law with friction
 *  @param n       number of contacts
 *  @param normal  [3 n] x, y, z of the normal of each plane, of length 1
 *  @param spin    [n] angles by which the bodies have turned about the normals since the last turn, the mean of both; or NULL: 0
 *  @param memory  [memory_size n] the records */
int mdr_law_turn(const mdr_law *law, int n, const double normal[], const double spin[], double memory[]);

/* ---- fit: from measured data to the parameters of indenter, medium and instrument; docs/fitting.md ----------------- */

/** What x and y of the data are. */
enum mdr_fit_data_kind {
    MDR_FIT_FORCE_DEPTH = 1,      /**< Indentation depth [length] and force [modulus length^2]. */
    MDR_FIT_STIFFNESS_DEPTH = 2,  /**< Indentation depth [length] and contact stiffness > 0 [modulus length]; given the force of
                                       each point [modulus length^2] (dynamic nanoindentation). */
    MDR_FIT_MODULUS_RADIUS = 3,   /**< Contact radius > 0 [length] and effective contact modulus [modulus]. */
    MDR_FIT_STIFFNESS_RADIUS = 4, /**< Contact radius > 0 [length] and contact stiffness [modulus length]. */
    MDR_FIT_FORCE_TIME = 5,       /**< Ascending times [time] and force [modulus length^2] of a viscoelastic body; given the
                                       indentation depth at each time [length], in between linear: mdr_contact_history(). */
    MDR_FIT_DEPTH_TIME = 6,       /**< Ascending times [time] and indentation depth [length]; given the force [modulus length^2]. */
    MDR_FIT_DYNAMIC_STIFFNESS = 7 /**< Angular frequency > 0 [1/time] and, as `branch` says of each point, MDR_FIT_STORAGE or
                                       MDR_FIT_LOSS, real or imaginary part of the dynamic stiffness [modulus length]; given the
                                       contact radius > 0 [length]: mdr_contact_dynamic_stiffness(). */
};

/** What a point of MDR_FIT_DYNAMIC_STIFFNESS is: the real or the imaginary part. */
enum mdr_fit_part { MDR_FIT_STORAGE = 1, MDR_FIT_LOSS = 2 };

/** The parameters of the instrument, by their place behind those of indenter, medium and counterbody. */
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
    MDR_FIT_COHESIVE_STRESS = 9,      /**< sigma >= 0: adhesion with a range, as in mdr_contact_options; 0: a range of nothing
                                           [modulus]. */
    MDR_FIT_INSTRUMENT_COUNT = 10     /**< How many there are. */
};

/** How residuals r, in standard deviations, count; s is loss_scale. */
enum mdr_fit_loss {
    MDR_FIT_LINEAR = 0, /**< r^2: least squares. */
    MDR_FIT_HUBER = 1,  /**< r^2 up to s, then growing in proportion to r. */
    MDR_FIT_CAUCHY = 2  /**< s^2 ln(1 + r^2/s^2). */
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
                                              model does. For MDR_FIT_DYNAMIC_STIFFNESS of enum mdr_fit_part. */
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
 *  or exponent of a model that has one; then "surface.tension" and "surface.bending" where the surface is not bare. Of a
 *  viscoelastic material E, nu, or modulus, time, exponent, nu, or relaxed_shear_modulus, "terms[0].modulus" and "terms[0].time",
 *  viscosity, and bulk_modulus or nu. Names of a counterbody begin with "upper.".
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
