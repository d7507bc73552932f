/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file friction.h
 * Friction: partial slip under a constant normal force, and arbitrary loading paths.
 * @since 0.1
 */
#ifndef MDRCONTACT_FRICTION_H
#define MDRCONTACT_FRICTION_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact with Coulomb friction. Created by mdr_friction_new(). Immutable. */
typedef struct mdr_friction mdr_friction;

/** Direction of the tangential loading. */
enum mdr_shear_direction {
    MDR_ALONG = 601, /**< Displacement of the indenter along the surface. */
    MDR_AROUND = 602 /**< Rotation of the indenter about its axis. */
};

/** A tangential state under a constant normal force: a circular stick zone inside an annulus of slip. Shift and force have the same
 *  sign. Under a twist, shift and force are the angle and the torque. */
typedef struct mdr_shear_state {
    double shift;             /**< s, displacement of the indenter along the surface; of two bodies, the relative displacement of
                                   distant points [length]. Twist: phi, angle about the axis [radian]. */
    double tangential_force;  /**< T, |T| <= coefficient F [modulus length^2]. Twist: torque M [modulus length^3]. */
    double stick_radius;      /**< c, 0 if the contact slides [length]. */
    double stiffness;         /**< dT/ds = k_t(c), that of a full-stick contact of radius c; 0 if the contact slides [modulus
                                   length]. Twist: dM/dphi [modulus length^3]. */
    double dissipated_energy; /**< Dissipated energy since shift 0 [modulus length^3]. */
    double sliding;           /**< 1 if the whole contact slides, otherwise 0. Twist: 1 if the stick radius is less than 1e-6 a, at
                                   which the torque equals that of sliding to machine precision. */
} mdr_shear_state;

/** Create a contact with Coulomb friction. It slips where the traction reaches coefficient times pressure, and sticks elsewhere.
 *
 *  The normal force is constant and the shear does not change the pressure, as in the theory of Cattaneo and Mindlin; this changes
 *  T by 1 to 6 %. The displacement that varies as cos 2 phi around the axis is neglected (at most 0.25 % of T). Otherwise the
 *  solution is exact on homogeneous and exact layered media. Media with Gao's weights superpose flat punches.
 *  @param c            contact without adhesion, on a medium with MDR_TANGENTIAL_MODULUS
 *  @param coefficient  coefficient of friction, > 0 [1]
 *  @param out          receives the handle
 *  @return also MDR_EINVALID with adhesion, because Coulomb's law is not defined under tension, and for media without a tangential
 *          stiffness; MDR_ENOCONVERGENCE
 *  @code
 *  mdr_friction *rough = NULL;
 *  status = mdr_friction_new(contact, 0.3, &rough);
 *  MDR_FREE(rough);
 *  @endcode
 */
int mdr_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out);

/** The tangential response of a normal state under first loading. Created by mdr_shear_new(). Immutable. */
typedef struct mdr_shear mdr_shear;

/** Compute the tangential response of a normal state under a constant normal force. Slip is solved once, for all states, fields and
 *  loops.
 *
 *  Under a twist (Lubkin's problem) the axis sticks at any angle, and the radius of the stick zone decreases exponentially. The
 *  normal load is applied first. The solution is exact, because torsion changes neither the pressure nor the axial symmetry.
 *  @param f          contact with friction; for MDR_AROUND on a homogeneous medium with E and nu or a pair of them
 *  @param load       load of a state of its contact
 *  @param direction  one of enum mdr_shear_direction
 *  @param out        receives the handle
 *  @return also MDR_EINVALID for other media; MDR_EDOMAIN if the pressure is negative somewhere (see mdr_load_lowest_pressure()) or
 *          slip begins inside the contact (a flat punch on a stiff coating); MDR_ENOCONVERGENCE. Slip that begins inside at a
 *          larger shift, under flat ends and r^4 on stiff coatings, is not detected: mdr_shear_field() then returns tractions above
 *          coefficient times pressure inside the stick radius, and the states are wrong. mdr_friction_history_new() with rings
 *          computes this case
 *  @code
 *  mdr_shear *first = NULL;
 *  status = mdr_shear_new(friction, load, MDR_ALONG, &first);
 *  MDR_FREE(first);
 *  @endcode
 */
int mdr_shear_new(const mdr_friction *f, const mdr_load *load, int direction, mdr_shear **out);

/** Compute tangential states, each under monotonic loading from 0.
 *  @param s      tangential response
 *  @param given  the quantity in `in`: MDR_SHIFT or MDR_TANGENTIAL_FORCE for MDR_ALONG, MDR_TWIST or MDR_TORQUE for MDR_AROUND
 *  @param n      number of states
 *  @param in     [n] shifts or tangential forces, twists or torques
 *  @param out    [n] states
 *  @return also MDR_EUNREACHABLE for a force above that of sliding or a torque that reaches that of sliding; MDR_ENOCONVERGENCE
 *  @code
 *  const double shifts[2] = {1e-9, 5e-9};
 *  mdr_shear_state states[2];
 *  status = mdr_shear_states(shear, MDR_SHIFT, 2, shifts, states);
 *  @endcode
 */
int mdr_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[]);

/** Properties of a tangential response. */
typedef struct mdr_shear_facts {
    size_t size;          /**< Size of this structure; MDR_SIZED sets it. */
    double sliding_shift; /**< Shift at which the last point begins to slip [length]. Twist: the axis always sticks; twist at which
                               the member `sliding` of a state becomes 1 [radian]. */
    double sliding_force; /**< coefficient F [modulus length^2]. Twist: torque of sliding, coefficient times int r p dA, for example
                               (3 pi/16) coefficient F a under a paraboloid [modulus length^3]. */
    int direction;        /**< One of enum mdr_shear_direction. */
} mdr_shear_facts;

/** Return the properties of a tangential response.
 *  @param s      tangential response
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_shear_facts facts = MDR_SIZED(mdr_shear_facts);
 *  status = mdr_shear_about(shear, &facts);
 *  @endcode
 */
int mdr_shear_about(const mdr_shear *s, mdr_shear_facts *facts);

/** Compute a field of a tangential state.
 *  @param s      tangential response
 *  @param at     a tangential state of it
 *  @param field  MDR_TRACTION or MDR_TANGENTIAL_LINE_LOAD
 *  @param n      number of positions
 *  @param r      [n] r or x, 0 <= r <= a [length]
 *  @param out    [n] values
 *  @return also MDR_EDOMAIN for a position outside the contact, MDR_ENOCONVERGENCE
 *  @code
 *  const double shift = 1e-9, r = 0.1e-6;
 *  double tau;
 *  mdr_shear_state at;
 *  mdr_shear_states(shear, MDR_SHIFT, 1, &shift, &at);
 *  status = mdr_shear_field(shear, &at, MDR_TRACTION, 1, &r, &tau);
 *  @endcode
 */
int mdr_shear_field(const mdr_shear *s, const mdr_shear_state *at, int field, int n, const double r[], double out[]);

/** Compute the loop between +amplitude and -amplitude by Masing's rule, which is exact here: after each turning point the force
 *  changes by twice that of the first loading at half the distance.
 *  @param s           tangential response
 *  @param given       the quantity of the amplitude, as for mdr_shear_states()
 *  @param amplitude   > 0; a force or a torque must be less than that of sliding
 *  @param n           number of points, at least 3: from +amplitude to -amplitude and back, in equal steps of the shift
 *  @param shift       [n] shifts [length], or twists [radian]
 *  @param force       [n] tangential forces [modulus length^2], or torques [modulus length^3]
 *  @param dissipated  energy dissipated in the cycle, the area of the loop, accurate also at small amplitudes [modulus length^3]
 *  @return as mdr_shear_states()
 *  @code
 *  double shift[41], force[41], dissipated;
 *  status = mdr_shear_loop(shear, MDR_SHIFT, 2e-9, 41, shift, force, &dissipated);
 *  @endcode
 */
int mdr_shear_loop(const mdr_shear *s, int given, double amplitude, int n, double shift[], double force[], double *dissipated);

/** A contact with friction and its loading history, along any path of normal and tangential loading. Only one thread may use it at
 *  a time. Created by mdr_friction_history_new() or mdr_friction_history_copy(). */
typedef struct mdr_friction_history mdr_friction_history;

/** Create a history of a contact that has not been loaded.
 *
 *  On homogeneous bodies the springs do not interact and each step of any size is exact. On exact layered bodies, and on
 *  homogeneous ones if largest_depth > 0, the contact is divided into rings that each obey Coulomb's law. With 100 rings the error
 *  of T is 2e-4 coefficient F, that of the stick radius a third of a ring, that of the energy 2e-3. Twice the number of rings
 *  reduces the errors by a factor of two or more. Steps are divided at the radii of the rings, so a long step gives the result, and
 *  has the cost, of many short ones.
 *  @param f              contact with friction
 *  @param largest_depth  largest depth of rings; > 0 on layered bodies; 0: no rings [length]
 *  @param rings          10 to 1000, or 0: 100
 *  @param out            receives the handle
 *  @return also MDR_EINVALID for media other than homogeneous and exact layered ones, and as mdr_contact_states()
 *  @code
 *  mdr_friction_history *path = NULL;
 *  status = mdr_friction_history_new(friction, 50e-9, 20, &path);
 *  MDR_FREE(path);
 *  @endcode
 */
int mdr_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out);

/** Copy a history. The copy is independent.
 *  @param h    history
 *  @param out  receives the handle
 *  @code
 *  mdr_friction_history *copy = NULL;
 *  status = mdr_friction_history_copy(friction_history, &copy);
 *  MDR_FREE(copy);
 *  @endcode
 */
int mdr_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out);

/** Continue a history along steps in which depth and shift change proportionally. After a failure the history is unchanged.
 *  @param h                 history
 *  @param normal_given      MDR_DEPTH or MDR_FORCE: the quantity in `normal`
 *  @param tangential_given  MDR_SHIFT or MDR_TANGENTIAL_FORCE: the quantity in `tangential`
 *  @param n                 number of steps
 *  @param normal            [n] depths or normal forces at the ends of the steps, >= 0; 0 separates the bodies
 *  @param tangential        [n] shifts or tangential forces at the ends of the steps, |T| < coefficient F
 *  @param states            [n] normal states
 *  @param out               [n] tangential states; stick_radius is the radius of the zone that did not slip in the last step,
 *                           dissipated_energy the total since the beginning
 *  @return also MDR_EUNREACHABLE for a tangential force at which the contact slides, MDR_EDOMAIN beyond the largest depth of rings
 *          or if the pressure is negative somewhere, MDR_ENOCONVERGENCE, and as mdr_contact_states()
 *  @code
 *  const double depths[2] = {30e-9, 30e-9}, shifts[2] = {0.0, 1e-9};
 *  mdr_state normal[2];
 *  mdr_shear_state tangential[2];
 *  status = mdr_friction_history_advance(friction_history, MDR_DEPTH, MDR_SHIFT, 2, depths, shifts, normal, tangential);
 *  @endcode
 */
int mdr_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n, const double normal[],
                                 const double tangential[], mdr_state states[], mdr_shear_state out[]);

#ifdef __cplusplus
}
#endif

#endif
