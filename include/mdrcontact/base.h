/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file base.h
 * Shared parts of all headers: version, status, errors, threads, sized structures, user functions.
 * @since 0.1
 */
#ifndef MDRCONTACT_BASE_H
#define MDRCONTACT_BASE_H

#include <stddef.h>

/** A sized structure `type` with its size set and all other members 0. */
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

/** Result of a call. */
enum mdr_status {
    MDR_SUCCESS = 0,        /**< The call succeeded. */
    MDR_ENULL = 1,          /**< A required pointer or handle is NULL. */
    MDR_EINVALID = 2,       /**< An argument has a value that is never valid (NaN, E <= 0, a table that is not ascending). */
    MDR_EDOMAIN = 3,        /**< A point lies outside the range in which the object is defined (r > a, beyond the end of a
                                 table). */
    MDR_EUNREACHABLE = 4,   /**< No contact state has the requested depth, force or radius. */
    MDR_ENOCONVERGENCE = 5, /**< An iteration ended before it met its tolerance, or a result exceeds the range of double
                                 precision. */
    MDR_ENOMEMORY = 6,      /**< Data of a size that the caller chose do not fit into memory. */
    MDR_ECALLBACK = 7,      /**< A user function reported a failure or returned NaN or infinity. */
    MDR_EFILE = 8,          /**< A file cannot be read or written, or is damaged. */
    MDR_ECANCELLED = 9      /**< The function set by mdr_set_cancel() cancelled the call. */
};

/** A quantity that is an input or an output: of a contact, an indenter, a medium, a material, a gel or a conducting contact. Each
 *  function lists those it accepts. Codes of all enumerations differ; a code of another enumeration returns MDR_EINVALID. 0 is not
 *  a code; in a structure it selects the default. */
enum mdr_quantity {
    MDR_DEPTH = 101,                 /**< d, indentation depth; with adhesion down to the pull-off depth [length]. */
    MDR_FORCE = 102,                 /**< F, normal force; with adhesion down to the pull-off force [modulus length^2]. */
    MDR_RADIUS = 103,                /**< a, contact radius, at least the radius of the flat end of the indenter and below its
                                          vertical wall [length]. With adhesion, a state of given radius may be unstable under depth
                                          or force control. */
    MDR_SPRING = 104,                /**< Position of the far end of a spring that presses the indenter, d + F/stiffness
                                          [length]. */
    MDR_SHIFT = 105,                 /**< s, displacement of the indenter along the surface, of either sign [length]. */
    MDR_TANGENTIAL_FORCE = 106,      /**< T, |T| <= coefficient F; the bound returns the state in which sliding begins [modulus
                                          length^2]. */
    MDR_TWIST = 107,                 /**< phi, rotation of the indenter about its axis, of either sign [radian]. */
    MDR_TORQUE = 108,                /**< M, less than the torque of sliding [modulus length^3]. */
    MDR_HEIGHT = 111,                /**< f(r), height of the indenter surface above its lowest point [length]. */
    MDR_HEIGHT_SLOPE = 112,          /**< f'(r) [1]; infinite at the equator of a sphere. */
    MDR_G = 113,                     /**< g(x), one-dimensional profile of an indenter, equation (3) [length]; infinite at the
                                          equator of a sphere. */
    MDR_G_SLOPE = 114,               /**< g'(x) [1]. */
    MDR_MODULUS = 121,               /**< E_eff(a), effective contact modulus, equation (10) [modulus]. */
    MDR_STIFFNESS = 122,             /**< k = 2 a E_eff(a), stiffness of a flat punch of radius a, equation (10) [modulus
                                          length]. */
    MDR_TANGENTIAL_MODULUS = 123,    /**< G_t(a) = k_t(a)/(2 a), the modulus that replaces E_eff for a full-stick contact displaced
                                          along the surface [modulus]. 4 G/(2 - nu) of a homogeneous body; 1/G_t adds for two
                                          bodies. Available for homogeneous media with E and nu; for coated, layered or graded ones
                                          with MDR_MODEL_EXACT, exact except for the displacement that varies as cos 2 phi around
                                          the axis (k_t is low by at most 0.35 %), or with Gao's weights of a tangential load; and
                                          for pairs of these. */
    MDR_TORSIONAL_STIFFNESS = 124,   /**< M/phi of a full-stick contact twisted about its axis: 16 G a^3/3 of a homogeneous body
                                          [modulus length^3]. Exact. Available for homogeneous media with E and nu, for coated,
                                          layered and graded ones with MDR_MODEL_EXACT, and for pairs of these. */
    MDR_PRESSURE = 131,              /**< p(r), contact pressure, equation (6), 0 <= r <= a [modulus]. Infinite at the edge of a
                                          flat punch or of an adhesive contact and at the apex of a cone. With a cohesive stress
                                          sigma_0 it extends to zone_radius: finite at a, and -sigma_0 from there on. */
    MDR_DISPLACEMENT = 132,          /**< u(r), surface displacement, any r >= 0: d - f(r) for r <= a, inside the range of f; the
                                          free surface for r > a [length]. For two bodies, the sum, positive into each body. With an
                                          approximate model, each increment of depth moves the free surface as on a homogeneous
                                          body. */
    MDR_LINE_LOAD = 133,             /**< q(x), line load of the one-dimensional springs, equations (5), (21), 0 <= x <= a, or to
                                          zone_radius [modulus length]. */
    MDR_DISPLACEMENT_LOWER = 134,    /**< u(r) of the medium, or of the lower of two bodies, into that body. On an initially flat
                                          surface it is the shape of the deformed interface for r <= a [length]. */
    MDR_DISPLACEMENT_UPPER = 135,    /**< u(r) of the upper body, into that body; 0 for a rigid indenter [length]. */
    MDR_TRACTION = 136,              /**< tau(r), shear traction in the direction of the shift, or around the axis, 0 <= r <= a
                                          [modulus]. */
    MDR_TANGENTIAL_LINE_LOAD = 137,  /**< q_t(x), line load of the springs in the direction of the shift, 0 <= x <= a; under a twist
                                          2 x int_x^a tau dr/sqrt(r^2 - x^2) [modulus length]. */
    MDR_RELAXATION = 141,            /**< Response to a unit step of the deformation at time 0. Of a material: G(t), shear
                                          relaxation modulus [modulus]; at t = 0 the glassy modulus; without the contribution of a
                                          dashpot at t > 0; t >= 0, and t > 0 for a power law or a dashpot, whose G(0) is infinite.
                                          Of a contact: force per depth of a flat punch [modulus length]. */
    MDR_CREEP = 142,                 /**< Response to a unit step of the load at time 0. Of a material: J(t), shear compliance, t >=
                                          0 [1/modulus]; J(0) = 0 for a power law or a dashpot. Of a contact: depth per force of a
                                          flat punch [1/(modulus length)]. */
    MDR_MEAN_RELAXATION = 143,       /**< Time average of the relaxation of a contact since the step, the response to a ramp of the
                                          depth [modulus length]. */
    MDR_MEAN_CREEP = 144,            /**< Time average of the creep of a contact since the step, the response to a ramp of the force
                                          [1/(modulus length)]. */
    MDR_PARABOLOID_RELAXATION = 145, /**< Force per depth of a paraboloid after a step of its depth d, at the fixed contact radius a
                                          = sqrt(R d) [modulus length]. The true contact radius rises and returns, with
                                          MDR_DRAINAGE_INDENTER by up to 9 %; the error of the force is then up to 0.05 of its
                                          relaxing part. If the whole surface drains or is sealed, the error is of second order. */
    MDR_COMPLEX_MODULUS = 146,       /**< Complex shear modulus at angular frequencies omega > 0: storage and loss modulus
                                          [modulus]. */
    MDR_STORAGE = 147,               /**< Real part of a dynamic stiffness [modulus length]. */
    MDR_LOSS = 148,                  /**< Imaginary part of a dynamic stiffness [modulus length]. */
    MDR_TOTAL_PRESSURE = 149,        /**< Of a gel: total pressure on the indenter. */
    MDR_PORE_PRESSURE = 150,         /**< Of a gel: pressure of the fluid at the surface; of a film only with MDR_DRAINAGE_SURFACE,
                                          where it is 0. */
    MDR_FLUX = 161,                  /**< Flux density through the contact area, 0 <= r < a; without a film infinite at the edge. */
    MDR_FLUX_Z = 162,                /**< Flux density into a body. */
    MDR_FLUX_R = 163,                /**< Flux density away from the axis. */
    MDR_POTENTIAL = 164,             /**< Potential relative to the far field of the body. */
    MDR_CONDUCTANCE = 165,           /**< Flux per potential of an equipotential contact area [conductance]. */
    MDR_RESISTANCE = 166,            /**< Potential per flux of an equipotential contact area [1/conductance]. */
    MDR_MEAN_POTENTIAL = 167,        /**< Area mean of the potential per flux under a uniform flux, without the film. */
    MDR_CENTRE_POTENTIAL = 168,      /**< Potential at the centre per flux under a uniform flux, without the film. */
    MDR_GAUSSIAN_POTENTIAL = 169,    /**< Mean potential over a Gaussian probe per flux of a Gaussian pump with radii w0 and w1
                                          (1/e^2): `radius` is sqrt(w0^2 + w1^2). */
    MDR_VON_MISES = 181,             /**< Of a layer: largest von Mises stress; a metal yields at the yield stress. */
    MDR_TRESCA = 182,                /**< Of a layer: largest (s_1 - s_3)/2; by Tresca's criterion a metal yields at half the yield
                                          stress. */
    MDR_TENSION = 183,               /**< Of a layer: largest principal stress s_1. A strength of the first layer applies also to
                                          its free surface. */
    MDR_INTERFACE_SHEAR = 184,       /**< Of an interface: largest sqrt(s_rz^2 + s_tz^2). */
    MDR_INTERFACE_TENSION = 185,     /**< Of an interface: largest s_zz. */
    MDR_FREE_SURFACE_TENSION = 186   /**< Of the free surface, a <= r <= 3 a: largest s_1, which opens ring cracks. */
};

/** Return the version of the library, 10000 major + 100 minor + patch. It cannot fail.
 *  @code
 *  if (mdr_version() < 100) puts("mdrcontact 0.1 or later is needed");
 *  @endcode
 */
int mdr_version(void);

/** Return the name of a code: "force" for MDR_FORCE, "gao-series" for MDR_MODEL_GAO_SERIES, "invalid" for MDR_EINVALID. All
 *  languages and problem files use these names. The result for a number that is not a code is "unknown". The text is constant: do
 *  not free it.
 *  @param code  of any enumeration except enum mdr_warning, whose members are bits, and enum mdr_fit_instrument, whose members are
 *               indices
 *  @code
 *  printf("%s\n", mdr_name_of(MDR_MODEL_GAO_SERIES));
 *  @endcode
 */
const char *mdr_name_of(int code);

/** Return the code of a name, the inverse of mdr_name_of() within one enumeration.
 *  @param enumeration  any code of the enumeration, for example MDR_MODEL_EXACT for a model
 *  @param name         null-terminated
 *  @param code         receives the code
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a number that is not a code and for a name that the enumeration does not
 *          contain; the error text lists the nearest name and all names
 *  @code
 *  int model;
 *  status = mdr_code_of(MDR_MODEL_EXACT, "gao-series", &model);
 *  @endcode
 */
int mdr_code_of(int enumeration, const char *name, int *code);

/** Return the text of the last failure of the calling thread, at most 1023 characters. It stays until the next failure of the
 *  thread; successful calls leave it unchanged. It is empty before the first failure, never NULL, and must not be freed.
 *  @code
 *  mdr_profile *none = NULL;
 *  if (mdr_profile_sphere(-1.0, &none)) puts(mdr_last_error());
 *  @endcode
 */
const char *mdr_last_error(void);

/** The parts of a failure, for programs that compose their own message. For the text "entry 3 of xi = -1: ...", `argument` is "xi",
 *  `entry` is 3, and `text` is " = -1: ...". */
typedef struct mdr_failure {
    size_t size;       /**< Size of this structure; MDR_SIZED sets it. */
    int status;        /**< One of enum mdr_status; MDR_SUCCESS before the first failure. */
    int entry;         /**< Entry of the array argument, from 1; 0: none. */
    char argument[64]; /**< Argument with which the text begins; empty if the text is complete. */
    char text[1024];   /**< The value of the argument and the rule that it violates. */
} mdr_failure;

/** Return the last failure of the calling thread in parts. The call leaves it unchanged.
 *  @param failure  initialize with MDR_SIZED; receives the failure
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for an impossible size: less than 8, more than 4096, not a multiple of 4
 *  @code
 *  mdr_failure failure = MDR_SIZED(mdr_failure);
 *  status = mdr_last_failure(&failure);
 *  @endcode
 */
int mdr_last_failure(mdr_failure *failure);

/** Set the number of threads that functions of arrays may use when called from this thread. The initial number is 1. Each thread
 *  has its own number.
 *
 *  Small arrays use the calling thread only: up to about 10,000 points of a closed form, or two states of an iterative solution.
 *  Structures made of user functions, and calls inside a parallel region, also use the calling thread only. Results are bitwise
 *  identical for every number of threads. If several entries fail, the error is that of the first one. A library built without
 *  OpenMP uses one thread.
 *  @param threads  at least 1; or 0 for the number that OpenMP offers, used only from where the rest of an iterative solution takes
 *                  longer than about 0.3 s: threads that are started for less cost more processor time than they save
 *  @code
 *  status = mdr_set_threads(4);
 *  @endcode
 */
int mdr_set_threads(int threads);

/** A function that decides whether a long call continues.
 *  @param context  the pointer given with the function
 *  @return 0 to continue; any other value to cancel the call. After that the function may be called again until the call has
 *          returned. It must return: leave it neither by longjmp() nor by an exception. It must not make long calls itself, which
 *          return MDR_EINVALID */
typedef int (*mdr_cancel)(void *context);

/** Set a function that may cancel long calls of the calling thread: fits, maps, tables, laws, loops, arrays of states. They call it
 *  at most 0.2 s after they begin, and then at intervals of at least 0.05 s, in the calling thread. A cancelled call returns
 *  MDR_ECANCELLED, writes no output and leaves every handle unchanged. Each thread has its own function. The function runs in the
 *  floating-point arithmetic of the program, not in that of the library.
 *  @param cancel   NULL: none, the initial state
 *  @param context  passed to cancel, may be NULL
 *  @code
 *  status = mdr_set_cancel(NULL, NULL);
 *  @endcode
 */
int mdr_set_cancel(mdr_cancel cancel, void *context);

/** Set a number to which long calls of the calling thread write their progress: the time integration of mdr_contact_history(),
 *  the searches of mdr_load_critical() and mdr_contact_first_failure(), and the equilibria that mdr_contact_new() and mdr_law_new()
 *  sample for a cohesive stress. Another thread, or the function set by mdr_set_cancel(), may read it meanwhile. Each thread has
 *  its own number.
 *  @param part  [1] receives the progress. Of a time integration: the number of completed rounds, each with half the step of the
 *               previous one, plus the completed part of the path in the current round. Of a search or of equilibria: the
 *               completed part. NULL: none, the initial state
 *  @code
 *  static double progress[1];
 *  status = mdr_set_progress(progress);
 *  mdr_set_progress(NULL);
 *  @endcode
 */
int mdr_set_progress(double part[]);

/** Free the object of a handle: an indenter, a medium, a contact, a law and so on.
 *  @param handle  handle, or NULL: no effect
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if it is not a handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  mdr_profile_cone(0.3, &tip);
 *  status = mdr_free(tip);
 *  @endcode
 */
int mdr_free(void *handle);

/** Frees the object of the variable `handle` and sets the variable to NULL. */
#define MDR_FREE(handle) ((void)mdr_free(handle), (void)((handle) = NULL))

/** A parameter of an object. */
typedef struct mdr_parameter {
    char name[48]; /**< Name, see mdr_fit_parameters(). */
    double value;  /**< Value, in the unit of the parameter. */
} mdr_parameter;

/** List the parameters from which an indenter, a material, a body or a medium was made, under the names that fits use. A medium has
 *  those of its body, then the constant of its model if it has one, then tension, bending and stretching of its surface unless it
 *  is bare. Pairs, rigid bodies and objects made of functions or tables have none; graded bodies given by depths have theirs.
 *  @param object    an mdr_profile, mdr_material, mdr_body or mdr_medium
 *  @param capacity  size of `out`, >= 0
 *  @param out       [capacity] receives the first `capacity` parameters
 *  @param count     receives the number of parameters
 *  @code
 *  mdr_parameter list[8];
 *  int count;
 *  status = mdr_parameters(medium, 8, list, &count);
 *  @endcode
 */
int mdr_parameters(const void *object, int capacity, mdr_parameter out[], int *count);

/** A user function y = f(x). It is called only while the object that it describes is created, in the calling thread, in the
 *  floating-point arithmetic of the library. It must return: leave it neither by longjmp() nor by an exception.
 *  @param x        argument
 *  @param y        receives the value, which must be finite
 *  @param context  the pointer given with the function
 *  @return 0, or any other number to report a failure: the creation then returns MDR_ECALLBACK */
typedef int (*mdr_function)(double x, double *y, void *context);

#ifdef __cplusplus
}
#endif

#endif
