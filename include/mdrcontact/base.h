/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file base.h
 * What all of the interface shares: version, status, errors, threads, structures that grow, user functions.
 * @since 0.1
 */
#ifndef MDRCONTACT_BASE_H
#define MDRCONTACT_BASE_H

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

/** What a call has to say. */
enum mdr_status {
    MDR_SUCCESS = 0,        /**< The call did what it says. */
    MDR_ENULL = 1,          /**< A required pointer or handle is NULL. */
    MDR_EINVALID = 2,       /**< An argument has a value that is never allowed (NaN, E <= 0, a table that is not ascending). */
    MDR_EDOMAIN = 3,        /**< A point lies where the object is not defined (r > a, beyond the end of a table). */
    MDR_EUNREACHABLE = 4,   /**< No contact state has the requested depth, force or radius. */
    MDR_ENOCONVERGENCE = 5, /**< An iteration or refinement ended before it met its tolerance, or a result left the number range. */
    MDR_ENOMEMORY = 6,      /**< The caller's data do not fit into memory. */
    MDR_ECALLBACK = 7,      /**< A user function reported a failure or gave NaN or infinity. */
    MDR_EFILE = 8,          /**< A file could not be read or written, or is damaged. */
    MDR_ECANCELLED = 9      /**< The function given to mdr_set_cancel() ended the call. */
};

/** What is given or wanted: of a contact, an indenter, a medium, a material, a gel, a spot that conducts. Each function says which
 *  of them it takes. All codes of the library are different numbers: one of another enumeration is refused. 0 is no code; in a
 *  structure it is the default. */
enum mdr_quantity {
    MDR_DEPTH = 101,                 /**< d, indentation depth; of a contact with adhesion down to the pull-off depth [length]. */
    MDR_FORCE = 102,                 /**< F, normal force; with adhesion down to the pull-off force [modulus length^2]. */
    MDR_RADIUS = 103,                /**< a, contact radius, at least that of the indenter's flat end, below its vertical wall
                                          [length]. With adhesion a state of given radius may be unstable under given depth or
                                          force. */
    MDR_SPRING = 104,                /**< Position of the far end of a spring that presses the indenter, d + F/stiffness
                                          [length]. */
    MDR_SHIFT = 105,                 /**< s, displacement of the indenter along the surface, of either sign [length]. */
    MDR_TANGENTIAL_FORCE = 106,      /**< T, |T| <= coefficient F; at that bound the state in which sliding begins [modulus
                                          length^2]. */
    MDR_TWIST = 107,                 /**< phi, angle of the indenter about its axis, of either sign [radian]. */
    MDR_TORQUE = 108,                /**< M, smaller than that of sliding [modulus length^3]. */
    MDR_HEIGHT = 111,                /**< f(r), the height of an indenter's surface above its lowest point [length]. */
    MDR_HEIGHT_SLOPE = 112,          /**< f'(r) [1]; infinite at the equator of a sphere. */
    MDR_G = 113,                     /**< g(x), the one-dimensional profile of an indenter, equation (3) [length]; infinite at the
                                          equator of a sphere. */
    MDR_G_SLOPE = 114,               /**< g'(x) [1]. */
    MDR_MODULUS = 121,               /**< E_eff(a), the effective contact modulus, equation (10) [modulus]. */
    MDR_STIFFNESS = 122,             /**< k = 2 a E_eff(a), the stiffness of a flat punch of radius a, equation (10) [modulus
                                          length]. */
    MDR_TANGENTIAL_MODULUS = 123,    /**< G_t(a) = k_t(a)/(2 a), what takes E_eff's place where a contact that sticks all over is
                                          displaced along the surface: 4 G/(2 - nu) of a homogeneous body, 1/G_t adds where two
                                          bodies touch [modulus]. Homogeneous media with E and nu; coated, layered or graded ones
                                          under the model MDR_MODEL_EXACT, exact but for the displacement that varies as cos 2 phi
                                          around the axis (k_t is low by at most 0.35 %), or by Gao's weights with those of a
                                          tangential load; pairs of these. */
    MDR_TORSIONAL_STIFFNESS = 124,   /**< M/phi of a contact that sticks all over and is twisted about its axis: 16 G a^3/3 of a
                                          homogeneous body [modulus length^3]. Exact for homogeneous media with E and nu, for
                                          coated, layered and graded ones under the model MDR_MODEL_EXACT, and for pairs of
                                          these. */
    MDR_PRESSURE = 131,              /**< p(r), the contact pressure, equation (6), 0 <= r <= a [modulus]. Infinite where theory
                                          says so: at the edge of a flat punch or of an adhesive contact, at the apex of a cone.
                                          With a cohesive stress sigma_0 up to zone_radius, finite at a and -sigma_0 from there on. */
    MDR_DISPLACEMENT = 132,          /**< u(r), the displacement of the surface: d - f(r) for r <= a, where f(r) must be defined;
                                          the free surface beyond; any r >= 0. Of two bodies both together, each into its body
                                          [length]. */
    MDR_LINE_LOAD = 133,             /**< q(x), the line load of the one-dimensional springs, equations (5), (21), 0 <= x <= a, or
                                          to zone_radius [modulus length]. */
    MDR_DISPLACEMENT_LOWER = 134,    /**< u(r) of the medium, or of the lower of two bodies, into that body: where its surface was
                                          flat, the shape of the deformed interface for r <= a [length]. */
    MDR_DISPLACEMENT_UPPER = 135,    /**< u(r) of the upper body, into that body; 0 for a rigid indenter [length]. */
    MDR_TRACTION = 136,              /**< tau(r), the shear traction along the shift, of one direction, or around the axis, 0 <= r
                                          <= a [modulus]. */
    MDR_TANGENTIAL_LINE_LOAD = 137,  /**< q_t(x), the line load of the springs along the shift, 0 <= x <= a; or 2 x int_x^a tau
                                          dr/sqrt(r^2 - x^2) [modulus length]. */
    MDR_RELAXATION = 141,            /**< What a step of the deformation at time 0 meets: of a material G(t), the shear relaxation
                                          modulus [modulus], at t = 0 the glassy one; a dashpot bears nothing at t > 0; t >= 0, and
                                          > 0 of a power law or with a dashpot, whose G(0) is infinite. Of a contact force per depth
                                          of a flat punch after a step of its depth [modulus length]. */
    MDR_CREEP = 142,                 /**< What a step of the load at time 0 makes: of a material J(t), the shear compliance, the
                                          strain under a constant stress of 1 [1/modulus]; J(0) = 0 of a power law or with a
                                          dashpot; t >= 0. Of a contact depth per force of a flat punch after a step of its force
                                          [1/(modulus length)]. */
    MDR_MEAN_RELAXATION = 143,       /**< Mean of the relaxation of a contact from the step on: what answers a ramp of the depth
                                          [modulus length]. */
    MDR_MEAN_CREEP = 144,            /**< Mean of the creep of a contact from the step on: what answers a ramp of the force
                                          [1/(modulus length)]. */
    MDR_PARABOLOID_RELAXATION = 145, /**< Force per depth of a paraboloid after a step of its depth d, the contact radius a = sqrt(R
                                          d) being held [modulus length]. In a true contact it grows and comes back: by up to 9 % at
                                          MDR_DRAINAGE_INDENTER, where the force is then up to 0.05 of its relaxing part off; of
                                          second order where the whole surface drains or is sealed. */
    MDR_COMPLEX_MODULUS = 146,       /**< The complex shear modulus at angular frequencies omega > 0, storage and loss modulus
                                          [modulus]. */
    MDR_STORAGE = 147,               /**< The real part of a dynamic stiffness [modulus length]. */
    MDR_LOSS = 148,                  /**< Its imaginary part [modulus length]. */
    MDR_TOTAL_PRESSURE = 149,        /**< Of a gel: the total pressure, which the indenter bears. */
    MDR_PORE_PRESSURE = 150,         /**< Of a gel: that of the fluid at the surface; of a film only where it is 0,
                                          MDR_DRAINAGE_SURFACE. */
    MDR_FLUX = 161,                  /**< Flux density through a spot; without a film it is infinite at its edge, 0 <= r < a. */
    MDR_FLUX_Z = 162,                /**< Flux density into a body. */
    MDR_FLUX_R = 163,                /**< Flux density away from the axis. */
    MDR_POTENTIAL = 164,             /**< Potential of a body from its own far field. */
    MDR_CONDUCTANCE = 165,           /**< Flux per potential of an equipotential spot [conductance]. */
    MDR_RESISTANCE = 166,            /**< Potential per flux of an equipotential spot [1/conductance]. */
    MDR_MEAN_POTENTIAL = 167,        /**< Area mean of the potential per flux under a uniform flux, the film left out. */
    MDR_CENTRE_POTENTIAL = 168,      /**< Potential in the centre per flux under a uniform flux, the film left out. */
    MDR_GAUSSIAN_POTENTIAL = 169,    /**< Mean over a Gaussian probe per flux of a Gaussian pump with radii w0 and w1 (1/e^2):
                                          `radius` is sqrt(w0^2 + w1^2). */
    MDR_VON_MISES = 181,             /**< Largest stress of a layer: the von Mises stress; a metal yields at the yield stress. */
    MDR_TRESCA = 182,                /**< Of a layer: (s_1 - s_3)/2; by Tresca a metal yields at half the yield stress. */
    MDR_TENSION = 183,               /**< Of a layer: the largest principal stress s_1. A strength of the first layer is one of its
                                          free surface, too. */
    MDR_INTERFACE_SHEAR = 184,       /**< Of an interface: sqrt(s_rz^2 + s_tz^2). */
    MDR_INTERFACE_TENSION = 185,     /**< Of an interface: s_zz. */
    MDR_FREE_SURFACE_TENSION = 186   /**< Of the free surface, a <= r <= 3 a: s_1, which opens ring cracks. */
};

/** The library's version, 10000 major + 100 minor + patch. Never fails. */
int mdr_version(void);

/** The word of a code, as all languages and problem files write it: "force" of MDR_FORCE, "gao-series" of MDR_MODEL_GAO_SERIES,
 *  "invalid" of MDR_EINVALID. "unknown" for a number that is no code. A constant: never freed.
 *  @param code  of any enumeration but the bits of enum mdr_warning and the places of enum mdr_fit_instrument */
const char *mdr_name_of(int code);

/** The code of a word: mdr_name_of() the other way, within one enumeration.
 *  @param enumeration  any code of the enumeration: MDR_MODEL_EXACT for a model
 *  @param name         ended by a null character
 *  @param code         receives the code
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a number that is no code and for a word that the enumeration does not have: the
 *          error names the nearest one, and all of them */
int mdr_code_of(int enumeration, const char *name, int *code);

/** The text of the calling thread's last failure, of at most 1023 characters. It stays until the thread's next failure: successful
 *  calls leave it as it is. Empty before the first one; never NULL, never freed. */
const char *mdr_last_error(void);

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
 * so do structures made of functions. Within a parallel region of the caller's all stays on the calling thread. The
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
 * From now on mdr_contact_history() writes to *part, in the calling thread, how far its march through time is, and
 * mdr_load_critical() and mdr_contact_first_failure() how far their search is. Another thread may read it meanwhile, or the
 * function given to mdr_set_cancel(). Each thread has its own.
 * @param part  [1] receives the number of rounds that are done, each with steps half as long as those of the one before, plus the
 *              part of the path that the present one has behind it; of a search the part that is done; NULL: none is called, as
 *              at first
 */
int mdr_set_progress(double part[]);

/** Frees what any handle of the library stands for: an indenter, a medium, a contact, a law and so on.
 *  @param handle  handle, or NULL: nothing
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if it is no handle */
int mdr_free(void *handle);

/** Frees what a variable `handle` stands for, and sets it to NULL. */
#define MDR_FREE(handle) ((void)mdr_free(handle), (void)((handle) = NULL))

/** A number of an object. */
typedef struct mdr_parameter {
    char name[48]; /**< Its name, see mdr_fit_parameters(). */
    double value;  /**< In its own unit. */
} mdr_parameter;

/** The numbers that an indenter, a material, a body or a medium was made of, by the names that fits have. A medium has those of its
 *  body, then the constant of a model that has one, and tension, bending and stretching of a surface that is not bare. Pairs, rigid
 *  bodies and what is made of functions or tables have none, but for graded bodies given by depths.
 *  @param object    an mdr_profile, mdr_material, mdr_body or mdr_medium
 *  @param capacity  room in `out` >= 0
 *  @param out       [capacity] receives the first of them
 *  @param count     receives how many there are */
int mdr_parameters(const void *object, int capacity, mdr_parameter out[], int *count);

/**
 * A user function y = f(x). It is called only while the object it describes is made, in the thread that makes it.
 * @param x        where
 * @param y        receives the value, which must be finite
 * @param context  the pointer given with the function
 * @return         0, or any other number to report a failure: the creation then ends with MDR_ECALLBACK
 */
typedef int (*mdr_function)(double x, double *y, void *context);

#ifdef __cplusplus
}
#endif

#endif
