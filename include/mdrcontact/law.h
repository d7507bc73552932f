/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file law.h
 * Compiled laws: F(d), a(d), k(d) and their inverses at the cost of a short polynomial, and the tangential force; docs/laws.md.
 *
 * Some functions advance the tangential force T of contacts in codes that integrate motion, step by step, along any path of the
 * shift in the plane and of the normal force: stick, partial slip, sliding and their history. A few vector sliders represent the
 * springs of the contact. No path produces energy, T is continuous, and each step has a derivative. docs/laws.md lists the errors.
 *
 * The calling program keeps a record for each contact: memory_size numbers (mdr_law_facts), all 0 before the first step. It may
 * copy and store records; their content is private to the library. Records of n contacts are consecutive in one array. Records of
 * another law, and laws without friction, return MDR_EINVALID.
 * @since 0.1
 */
#ifndef MDRCONTACT_LAW_H
#define MDRCONTACT_LAW_H

#include "friction.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The compiled law of one contact over a range of depths, verified against the contact when it is created. Unlike a contact it
 *  also covers separated bodies: the force is 0. Created by mdr_law_new(), mdr_law_with_radius(), mdr_law_load() or mdr_law_read().
 *  Immutable. */
typedef struct mdr_law mdr_law;

/** Options of mdr_law_new(). Initialize with MDR_SIZED. */
typedef struct mdr_law_options {
    size_t size;                             /**< Size of this structure; MDR_SIZED sets it. */
    double smallest_depth;                   /**< Without adhesion: depth > 0 above which the tolerance holds, at most half the
                                                  largest depth. Closer to initial contact the law continues value and slope.
                                                  Default 0: 1e-4 of the largest depth, or the start of the medium [length]. */
    double tolerance;                        /**< Relative tolerance of F, a and k, 1e-12 to 1e-2; with adhesion relative to |F| +
                                                  |d dF/dd|; default 1e-9. */
    const char *description;                 /**< Text that is kept in the file; default NULL: none. */
    int continue_beyond;                     /**< Not 0: beyond the largest depth and force the law continues along its tangent and
                                                  sets mdr_law_point.beyond, so that one hard collision does not stop a run. Default
                                                  0: MDR_EDOMAIN. */
    const mdr_friction *friction;            /**< Friction of the contact of this law: adds tangential forces, mdr_law_advance().
                                                  Default NULL: none. */
    int sliders;                             /**< With friction: number of vector sliders that represent the springs of a contact, 4
                                                  to 64. Errors decrease about as sliders^-1.6; time and size of records increase
                                                  proportionally. 16 for finite elements. Default 0: 8. */
    double shear_strength;                   /**< > 0, instead of friction: the contact slips where its shear traction reaches this
                                                  constant, as in smooth dry contacts with adhesion. Homogeneous bodies, with or
                                                  without adhesion. mdr_law_advance() then takes the contact radius instead of the
                                                  normal force. Default 0: none [modulus]. */
    const struct mdr_conduction *conduction; /**< Conduction of the same bodies, see mdr_conduction_new() in conduction.h: adds the
                                                  conductance, within the tolerance. Default NULL: none. */
    int twist;                               /**< With friction, not 0: the sliders represent the twist of the contact about its
                                                  normal instead of the shift. mdr_law_advance() then takes the twist phi [1] and
                                                  returns the torque M [modulus length^3] in the first of three components; the
                                                  others are 0. Paraboloids on homogeneous bodies. A contact that shifts and twists
                                                  needs two laws and two records. They are independent: the influence of one
                                                  traction on the slip of the other is neglected. Default 0. */
} mdr_law_options;

/** A state of a law. */
typedef struct mdr_law_point {
    double depth;     /**< d [length]. All other members are 0 for separated bodies. */
    double force;     /**< F [modulus length^2]. */
    double slope;     /**< dF/dd along the branch, for implicit codes; k without adhesion [modulus length]. */
    double radius;    /**< a [length]. */
    double stiffness; /**< k, dF/dd at constant a [modulus length]. */
    double energy;    /**< U = int F dd along the branch, from initial contact (elastic energy); with adhesion from pull-off, with a
                           cohesive stress from separated bodies [modulus length^3]. */
    double beyond;    /**< d minus the largest depth if the state lies on the tangent beyond it; 0 within the range [length]. */
} mdr_law_point;

/** Compile the law of a contact.
 *  @param contact        contact, with or without adhesion
 *  @param largest_depth  > 0 [length]. The law of an adhesive contact that jumps extends further, until no deeper state can unload
 *                        to a depth or force of the law; see mdr_law_about()
 *  @param options        NULL: default options
 *  @param out            receives the handle
 *  @return also as mdr_contact_states() and mdr_contact_pull_off(); MDR_ENOCONVERGENCE if the tolerance is not met; with friction
 *          also as mdr_shear_new(), and MDR_EINVALID for friction of another contact
 *  @code
 *  mdr_law *compiled = NULL;
 *  status = mdr_law_new(contact, 100e-9, NULL, &compiled);
 *  MDR_FREE(compiled);
 *  @endcode
 */
int mdr_law_new(const mdr_contact *contact, double largest_depth, const mdr_law_options *options, mdr_law **out);

/** Create the law of the same bodies under a paraboloid of another radius R, from the law for R0, without adhesion. On any linear
 *  bodies F(d; R) = (R0/R) F0(d R/R0) with the same a and k. The largest depth is multiplied by R0/R.
 *  @param law     law of a paraboloid without adhesion
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle
 *  @return also MDR_EINVALID for adhesive laws, which scale only at constant work of adhesion times R^2, for other indenters, and
 *          for laws of files that do not contain the radius. Friction is kept; records belong to one law
 *  @code
 *  mdr_law *larger = NULL;
 *  status = mdr_law_with_radius(law, 20e-6, &larger);
 *  MDR_FREE(larger);
 *  @endcode
 */
int mdr_law_with_radius(const mdr_law *law, double radius, mdr_law **out);

/** Compute the force at one depth. mdrcontact_law.h has inline versions for inner loops.
 *  @param law     law
 *  @param branch  one of enum mdr_branch
 *  @param d       indentation depth up to the largest one; F and slope are 0 for separated bodies [length]
 *  @param F       or NULL: receives the normal force [modulus length^2]
 *  @param slope   or NULL: receives dF/dd along the branch [modulus length]
 *  @return also MDR_EDOMAIN beyond the largest depth
 *  @code
 *  double F, slope;
 *  status = mdr_law_force(law, MDR_ON_UNLOADING, 40e-9, &F, &slope);
 *  @endcode
 */
int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope);

/** Compute the state at one depth of a contact with a history. An open contact closes at d >= 0, with a cohesive stress at the
 *  first attraction. A closed contact stays on its stable segment until the end of the segment, where it detaches or jumps to
 *  another one.
 *  @param law      law
 *  @param d        indentation depth up to the largest one [length]
 *  @param segment  segment of the contact: 0 (open) before the first call, then the value of the last call
 *  @param point    receives the state
 *  @return also MDR_EDOMAIN beyond the largest depth
 *  @code
 *  int segment = 0;
 *  mdr_law_point point;
 *  status = mdr_law_follow(law, 40e-9, &segment, &point);
 *  @endcode
 */
int mdr_law_follow(const mdr_law *law, double d, int *segment, mdr_law_point *point);

/** Compute states. Outputs that are NULL are skipped and have no cost.
 *  @param law     law
 *  @param given   MDR_DEPTH or MDR_FORCE: the quantity in `in`
 *  @param branch  one of enum mdr_branch
 *  @param n       number of states
 *  @param in      [n] depths up to the largest one; all outputs are 0 for separated bodies [length]; or forces >= 0, with adhesion
 *                 on unloading down to the pull-off force [modulus length^2]
 *  @param d       [n] or NULL: indentation depths [length]
 *  @param a       [n] or NULL: contact radii [length]
 *  @param F       [n] or NULL: normal forces [modulus length^2]
 *  @param k       [n] or NULL: stiffnesses dF/dd at constant a [modulus length]
 *  @param slope   [n] or NULL: dF/dd along the branch [modulus length]; dd/dF if forces are given [1/(modulus length)]
 *  @param energy  [n] or NULL: U as in mdr_law_point [modulus length^3]
 *  @return also MDR_EUNREACHABLE below the lowest force, MDR_EDOMAIN beyond the largest depth or force
 *  @code
 *  const double depths[3] = {10e-9, 20e-9, 30e-9};
 *  double F[3];
 *  status = mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 3, depths, NULL, NULL, F, NULL, NULL, NULL);
 *  @endcode
 */
int mdr_law_values(const mdr_law *law, int given, int branch, int n, const double in[], double d[], double a[], double F[],
                   double k[], double slope[], double energy[]);

/** Properties of a law. */
typedef struct mdr_law_facts {
    size_t size;                  /**< Size of this structure; MDR_SIZED sets it. */
    double lowest_depth;          /**< Lower end of the compiled range; with adhesion pull-off [length]. */
    double highest_depth;         /**< Upper end of the compiled range [length]. */
    double lowest_force;          /**< Force at the lower end [modulus length^2]. */
    double highest_force;         /**< Force at the upper end [modulus length^2]. */
    double tolerance;             /**< The requested relative tolerance. */
    double error;                 /**< Largest relative error found in the verification against the contact. */
    int solutions;                /**< Number of contact states computed to compile and verify the law. */
    int adhesive;                 /**< 1 with adhesion, otherwise 0. */
    int segments;                 /**< Number of stable segments under depth control. */
    const char *description;      /**< The description of the options; valid as long as the law. */
    int continue_beyond;          /**< 1 if the law continues beyond its range, otherwise 0. */
    int sliders;                  /**< Number of vector sliders; 0 without friction. */
    int memory_size;              /**< Number of values in the record of a contact, 11 + 4 sliders; 0 without friction. */
    double coefficient;           /**< Coefficient of friction; 0 without friction [1]. */
    double highest_sliding_shift; /**< Shift of first loading at which the contact slides under the highest force [length]. */
    double first_shear_error;     /**< Largest error of T in first loading at constant F, relative to coefficient F: at most about 2
                                       % with 8 sliders, 0.6 % with 16. */
    double path_error;            /**< Largest error of T along cycles of depth and shift compared with the exact history, relative
                                       to the largest coefficient F; -1 on inhomogeneous bodies. */
    int buffer_size;              /**< Number of values that mdr_law_buffer() writes. */
    double shear_strength;        /**< Constant shear strength, otherwise 0 [modulus]. If it is set, coefficient is 0, path_error is
                                       -1, first_shear_error is relative to T in sliding, and highest_sliding_shift belongs to the
                                       largest contact radius. */
    int conducts;                 /**< 1 if the law was made with a conduction, otherwise 0. */
    int twists;                   /**< 1 if the sliders represent a twist, otherwise 0. If it is set, first_shear_error is relative
                                       to the torque of sliding, path_error is -1, and highest_sliding_shift is 0 because the axis
                                       sticks at any twist. */
} mdr_law_facts;

/** Return the properties of a law.
 *  @param law    law
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
 *  status = mdr_law_about(law, &facts);
 *  @endcode
 */
int mdr_law_about(const mdr_law *law, mdr_law_facts *facts);

/** First number of the buffer of a law. */
enum mdr_law_format { MDR_LAW_FORMAT = 1296843314 /**< This version. */ };

/** Head of the buffer of a law. Counts, places and flags are also doubles. Places are indices from the beginning of the buffer. */
typedef struct mdr_law_head {
    double format;         /**< MDR_LAW_FORMAT. */
    double size;           /**< Number of values in the buffer. */
    double adhesive;       /**< 1 with adhesion, otherwise 0. */
    double continues;      /**< 1 if the law continues beyond its largest depth along its tangent, otherwise 0. */
    double end_radius;     /**< Radius of the flat end of the indenter [length]. */
    double lowest;         /**< Lower end of the compiled range [length]. */
    double highest;        /**< Upper end of the compiled range [length]. */
    double open_loading;   /**< The bodies are separated up to this depth on loading [length]. */
    double open_unloading; /**< The bodies are separated up to this depth on unloading [length]. */
    double first_force;    /**< F at the lowest depth, without adhesion [modulus length^2]. For 0 <= d < lowest, with x = d/lowest,
                                p = force_power, m = force_roots and b = 2 p - m: F = first_force x^p if m = 0, otherwise F =
                                first_force x^(m/2) (1 - b + b x^(1/2)). */
    double first_radius;   /**< In the same range a = end_radius + first_radius (d/lowest)^radius_power [length]. */
    double force_power;    /**< See first_force. */
    double radius_power;   /**< See first_radius. */
    double force_roots;    /**< See first_force: 0 or 2 to 12. */
    double direct;         /**< Index of the interval that needs no search; -1: none. */
    double segment_count;  /**< Number of stable segments, by ascending radius. */
    double segments;       /**< Place of the first mdr_law_segment. */
    double interval_count; /**< Number of intervals, grouped by segment. */
    double intervals;      /**< Place of the first mdr_law_interval. */
    double panel_count;    /**< Number of panels, grouped by interval. */
    double force;          /**< Place of the coefficients of F, [8] for each panel; a multiple of 8. */
    double contact;        /**< Place of the coefficients of a and k, [8] and [8] for each panel. */
    double energy;         /**< Place of U at the midpoint of each panel. The coefficients of the conductance G, [8] for each panel,
                                follow at the next multiple of 8 if the law has one; `size` shows whether it has. */
} mdr_law_head;

/** A stable segment of a law. */
typedef struct mdr_law_segment {
    double lowest;  /**< Lower end [length]. */
    double highest; /**< Upper end [length]. */
    double first;   /**< Index of its first interval, from 0. */
    double last;    /**< Index of its last interval. */
} mdr_law_segment;

/** An interval of a law. Each octave of y is divided into 2^bits panels of equal length, from y = 1; y = scale d + offset, or with
 *  a root y = scale sqrt(side (d - origin)) + offset. In a panel F, a and k are polynomials of degree 7 in y minus its midpoint. */
typedef struct mdr_law_interval {
    double lowest;        /**< Lower end [length]. */
    double highest;       /**< Upper end [length]. */
    double scale;         /**< Of y [1/length, with a root its square root]. */
    double offset;        /**< Offset of y. */
    double last_y;        /**< Largest y; the smallest is 1. */
    double is_root;       /**< 1 with a root, otherwise 0. */
    double origin;        /**< Origin of the root [length]. */
    double side;          /**< 1 above the origin, -1 below. */
    double smallest_root; /**< Smallest root used in dy/dd [square root of a length]. */
    double bits;          /**< Number of panels in an octave, as a power of 2. */
    double first_panel;   /**< Index of its first panel, from 0. */
} mdr_law_interval;

/** Write a law to one array of numbers without addresses, for device memory, shared memory or a mapped file. The inline functions
 *  of mdrcontact_law.h evaluate the array in place, with bitwise identical results. It begins with an mdr_law_head and does not
 *  contain friction.
 *  @param law     law
 *  @param size    size of the buffer: at least buffer_size of mdr_law_facts
 *  @param buffer  [size] receives the numbers; for speed, align it to 64 bytes
 *  @code
 *  mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
 *  mdr_law_about(law, &facts);
 *  double *numbers = malloc(facts.buffer_size * sizeof *numbers);
 *  status = mdr_law_buffer(law, facts.buffer_size, numbers);
 *  free(numbers);
 *  @endcode
 */
int mdr_law_buffer(const mdr_law *law, int size, double buffer[]);

/** Write a law to a file, replacing it: a portable text with version, description and checksum. The file is either complete or
 *  unchanged, also for concurrent readers. A symbolic link is followed.
 *  @param law   law
 *  @param path  name of the file; an existing one must be a regular file
 *  @return also MDR_EFILE if it cannot be written
 *  @code
 *  status = mdr_law_save(law, "film.law");
 *  @endcode
 */
int mdr_law_save(const mdr_law *law, const char *path);

/** Read a law from a file that any of the languages of the library wrote.
 *  @param path  name of the file
 *  @param out   receives the handle
 *  @return also MDR_EFILE if the file cannot be read, is damaged, or does not contain a law
 *  @code
 *  mdr_law *loaded = NULL;
 *  mdr_law_save(law, "film.law");
 *  status = mdr_law_load("film.law", &loaded);
 *  MDR_FREE(loaded);
 *  @endcode
 */
int mdr_law_load(const char *path, mdr_law **out);

/** Return the content of the file of a law in memory.
 *  @param law          law
 *  @param buffer       receives the content, if it fits; may be NULL if length < 1
 *  @param length       size of buffer
 *  @param full_length  receives the number of bytes of the content
 *  @code
 *  int size;
 *  status = mdr_law_write(law, NULL, 0, &size);
 *  @endcode
 */
int mdr_law_write(const mdr_law *law, char *buffer, int length, int *full_length);

/** Create a law from the content of its file.
 *  @param buffer  the content
 *  @param length  number of bytes
 *  @param out     receives the handle
 *  @return also MDR_EFILE if the content is damaged, or is not that of a law
 *  @code
 *  int size;
 *  mdr_law *copy = NULL;
 *  mdr_law_write(law, NULL, 0, &size);
 *  char *content = malloc((size_t)size);
 *  mdr_law_write(law, content, size, &size);
 *  status = mdr_law_read(content, size, &copy);
 *  free(content);
 *  MDR_FREE(copy);
 *  @endcode
 */
int mdr_law_read(const char *buffer, int length, mdr_law **out);

/** Advance n contacts by one step, straight in shift and S = int dF/k_t. The error is of first order in the change of direction of
 *  the shift during a step: if the direction changes, a step should be at most 0.2 of the shift of sliding. Any number of threads
 *  may call it with different records. A failed call advances none of the contacts.
 *  @param law       law with friction
 *  @param n         number of contacts
 *  @param force     [n] normal forces F at the end of the step, >= 0 [modulus length^2]; with a constant shear strength the contact
 *                   radii a [length]. 0 separates the bodies
 *  @param shift     [3 n] x, y, z of the shift of each contact in this step, in its tangent plane [length]
 *  @param is_trial  0: take the step; otherwise leave the records unchanged, for Newton's method and for steps that may be rejected
 *  @param tangent   [12 n] or NULL: receives, for each contact and each component i of T, dT_i/dx, dT_i/dy, dT_i/dz with respect to
 *                   the shift of the step [modulus length] and dT_i/dF [1], or dT_i/da [modulus length]
 *  @param memory    [memory_size n] the records
 *  @param T         [3 n] receives the tangential forces on the medium [modulus length^2]
 *  @return also MDR_EDOMAIN beyond the largest force, unless the law continues beyond it
 *  @code
 *  const double F = 1e-3, shift[3] = {1e-9, 0, 0};
 *  double record[43] = {0}, T[3];
 *  status = mdr_law_advance(friction_law, 1, &F, shift, 0, NULL, record, T);
 *  @endcode
 */
int mdr_law_advance(const mdr_law *law, int n, const double force[], const double shift[], int is_trial, double tangent[],
                    double memory[], double T[]);

/** Compute the energies of n contacts under shear, stored by the springs and dissipated by slip, summed over the sliders. Their sum
 *  is the work of T, up to terms of second order in the step; along a line under constant F it does not depend on the steps. The
 *  dissipated energy never decreases. The work of F is not included, because it does not depend on the shift.
 *  @param law         law with friction
 *  @param n           number of contacts
 *  @param memory      [memory_size n] the records
 *  @param stored      [n] or NULL: receives the energy stored in the springs [modulus length^3]
 *  @param dissipated  [n] or NULL: receives the energy dissipated by slip since the first step, including contacts that have opened
 *                     since [modulus length^3]
 *  @return also MDR_EINVALID for a record of another law
 *  @code
 *  const double record[43] = {0};
 *  double stored, dissipated;
 *  status = mdr_law_energies(friction_law, 1, record, &stored, &dissipated);
 *  @endcode
 */
int mdr_law_energies(const mdr_law *law, int n, const double memory[], double stored[], double dissipated[]);

/** Rotate records with their tangent planes, by the smallest rotation from the old normal to the new one and by an angle about that
 *  normal. Call it before the steps of bodies that roll or turn. Energies do not change. The first call stores the normal, so
 *  contacts whose planes turn need a call before their first step too. It is not needed if the plane is fixed, or if shifts are
 *  given in coordinates that turn with the contact.
 *  @param law     law with friction
 *  @param n       number of contacts
 *  @param normal  [3 n] x, y, z of the unit normal of each plane
 *  @param spin    [n] angles by which the bodies have turned about the normals since the last call, the mean of both; or NULL: 0
 *  @param memory  [memory_size n] the records
 *  @code
 *  const double normal[3] = {0, 0, 1};
 *  double record[43] = {0};
 *  status = mdr_law_turn(friction_law, 1, normal, NULL, record);
 *  @endcode
 */
int mdr_law_turn(const mdr_law *law, int n, const double normal[], const double spin[], double memory[]);

#ifdef __cplusplus
}
#endif

#endif
