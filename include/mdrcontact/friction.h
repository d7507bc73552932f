/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file friction.h
 * Friction: partial slip at constant normal force, and along any path.
 * @since 0.1
 */
#ifndef MDRCONTACT_FRICTION_H
#define MDRCONTACT_FRICTION_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact under Coulomb's law of friction. Made by mdr_friction_new(). */
typedef struct mdr_friction mdr_friction;

/** How a state is sheared. */
enum mdr_shear_direction {
    MDR_ALONG = 601, /**< The indenter is displaced along the surface. */
    MDR_AROUND = 602 /**< It is twisted about its axis. */
};

/** A state of shear under a constant normal force: a disc of stick inside an annulus of slip. Shift and force have one sign. */
typedef struct mdr_shear_state {
    double shift;             /**< s, displacement of the indenter along the surface, of distant points of two bodies [length]; or
                                   phi, its angle about the axis [radian]. */
    double tangential_force;  /**< T, |T| <= coefficient F [modulus length^2]; or the torque M [modulus length^3]. */
    double stick_radius;      /**< c, 0 where the contact slides [length]. */
    double stiffness;         /**< dT/ds = k_t(c), that of a contact of radius c that sticks; 0 where it slides [modulus length]; or
                                   dM/dphi [modulus length^3]. */
    double dissipated_energy; /**< Since the shift was 0 [modulus length^3]. */
    double sliding;           /**< 1 if the whole contact slides, else 0; under a twist 1 if the disc of stick is smaller than
                                   1e-6 a, which no torque distinguishes from 0. */
} mdr_shear_state;

/** Coulomb's law in a contact: slip where the traction reaches coefficient times pressure, stick where it is less.
 *
 *  The normal force is constant; the shear does not change the pressure (as with Cattaneo and Mindlin; T would be 1 to 6 % higher),
 *  and the displacement that varies as cos 2 phi around the axis is left out (at most 0.25 % of T). Else exact on homogeneous and
 *  exact layered media; media with Gao's weights superpose punches.
 *  @param c            contact without adhesion, on a medium whose MDR_TANGENTIAL_MODULUS is known
 *  @param coefficient  of friction, > 0 [1]
 *  @param out          receives the handle
 *  @return also MDR_EINVALID with adhesion (Coulomb's law knows no tension) and for media whose tangential stiffness is not known,
 *          MDR_ENOCONVERGENCE */
int mdr_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out);

/** A state of a contact with friction that is sheared for the first time. Made by mdr_shear_new(). */
typedef struct mdr_shear mdr_shear;

/** What happens to a state of a contact with friction as it is sheared under constant normal force. Slip is solved once, for all
 *  states, fields and loops.
 *
 *  Under a twist (Lubkin's problem) the axis sticks at any angle, and the disc of stick around it shrinks exponentially. It is
 *  pressed first, twisted then; exact, for torsion changes neither the pressure nor anything around the axis.
 *  @param f          contact with friction; for MDR_AROUND on a homogeneous medium with E and nu or a pair of them
 *  @param load       of a state of its contact
 *  @param direction  one of enum mdr_shear_direction
 *  @param out        receives the handle
 *  @return also MDR_EINVALID for other media, MDR_EDOMAIN if the pressure would be negative somewhere (see
 *          mdr_load_lowest_pressure()) or slip would begin inside the contact (a flat punch on a stiff coating),
 *          MDR_ENOCONVERGENCE. Slip that begins inside later, under flat ends and r^4 on stiff coatings, is not refused: there
 *          mdr_shear_field() gives tractions above coefficient times pressure inside the stick radius, and the states are not
 *          those of the true contact; mdr_friction_history_new() with rings gives these */
int mdr_shear_new(const mdr_friction *f, const mdr_load *load, int direction, mdr_shear **out);

/** States of shear, each reached from 0 in one go.
 *  @param s      sheared state
 *  @param given  what `in` holds: MDR_SHIFT or MDR_TANGENTIAL_FORCE for MDR_ALONG, MDR_TWIST or MDR_TORQUE for MDR_AROUND
 *  @param n      number of states
 *  @param in     [n] shifts or tangential forces, twists or torques
 *  @param out    [n] states
 *  @return also MDR_EUNREACHABLE beyond the force of sliding, and from the torque of sliding on; MDR_ENOCONVERGENCE */
int mdr_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[]);

/** What a sheared state is. */
typedef struct mdr_shear_facts {
    size_t size;          /**< Of this structure; MDR_SIZED sets it. */
    double sliding_shift; /**< The shift at which the last point begins to slip; of a twist, whose axis always sticks, that at which
                               sliding becomes 1 [length, or radian]. */
    double sliding_force; /**< coefficient F [modulus length^2]; or the torque that a growing twist approaches, coefficient times
                               int r p dA: (3 pi/16) coefficient F a under a paraboloid [modulus length^3]. */
    int direction;        /**< One of enum mdr_shear_direction. */
} mdr_shear_facts;

/** What a sheared state is.
 *  @param s      sheared state
 *  @param facts  begun by MDR_SIZED; receives it */
int mdr_shear_about(const mdr_shear *s, mdr_shear_facts *facts);

/** A field of a state of shear.
 *  @param s      sheared state
 *  @param at     a state of shear of it
 *  @param field  MDR_TRACTION or MDR_TANGENTIAL_LINE_LOAD
 *  @param n      number of positions
 *  @param r      [n] r or x, 0 <= r <= a [length]
 *  @param out    [n] values
 *  @return also MDR_EDOMAIN for a position outside the contact, MDR_ENOCONVERGENCE */
int mdr_shear_field(const mdr_shear *s, const mdr_shear_state *at, int field, int n, const double r[], double out[]);

/** The loop of a cycle between +amplitude and -amplitude, by Masing's rule, which is exact here: from each turn the force changes
 *  as twice the first loading of half the way.
 *  @param s           sheared state
 *  @param given       what the amplitude is, as for mdr_shear_states()
 *  @param amplitude   > 0, below that of sliding where it is a force or a torque
 *  @param n           number of points, at least 3: from +amplitude to -amplitude and back, in equal steps of the shift
 *  @param shift       [n] shifts [length], or twists [radian]
 *  @param force       [n] tangential forces [modulus length^2], or torques [modulus length^3]
 *  @param dissipated  energy dissipated in the cycle, the area of the loop, without loss of digits at small amplitudes
 *                     [modulus length^3]
 *  @return as mdr_shear_states() */
int mdr_shear_loop(const mdr_shear *s, int given, double amplitude, int n, double shift[], double force[], double *dissipated);

/** A contact with friction and its past, along any path of normal and tangential loading; not for two threads at a time. Made by
 *  mdr_friction_history_new() or mdr_friction_history_copy(). */
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
 *  @return also MDR_EINVALID for media other than homogeneous and exact layered ones, and as mdr_contact_states() */
int mdr_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out);

/** A copy with the same past, which goes its own way from here.
 *  @param h    history
 *  @param out  receives the handle */
int mdr_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out);

/** Goes on along a path of steps in which depth and shift change in proportion. After a failure the history is as before the call.
 *  @param h                 history
 *  @param normal_given      MDR_DEPTH or MDR_FORCE: what `normal` holds
 *  @param tangential_given  MDR_SHIFT or MDR_TANGENTIAL_FORCE: what `tangential` holds
 *  @param n                 number of steps
 *  @param normal            [n] depths or normal forces at the ends of the steps, >= 0; 0 parts the bodies
 *  @param tangential        [n] shifts or tangential forces there, |T| < coefficient F
 *  @param states            [n] normal states reached
 *  @param out               [n] tangential states reached: stick_radius is where the last step did not slip, dissipated_energy that
 *                           since the beginning
 *  @return also MDR_EUNREACHABLE for a tangential force at which the contact slides, MDR_EDOMAIN beyond the largest depth of rings
 *          or if the pressure would be negative somewhere, MDR_ENOCONVERGENCE, and as mdr_contact_states() */
int mdr_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n, const double normal[],
                                 const double tangential[], mdr_state states[], mdr_shear_state out[]);

#ifdef __cplusplus
}
#endif

#endif
