/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file law.h
 * Compiled laws: F(d), a(d), k(d) and their inverses for the price of a short polynomial, and their tangential force; docs/laws.md.
 * @since 0.1
 */
#ifndef MDRCONTACT_LAW_H
#define MDRCONTACT_LAW_H

#include "friction.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The law of one contact over a range of depths, made once, verified against the contact, then evaluated in nanoseconds.
 *  Unlike a contact it has an answer for bodies that are apart: 0. Made by mdr_law_new(), mdr_law_with_radius(), mdr_law_load() or
 *  mdr_law_read(). */
typedef struct mdr_law mdr_law;

/** What a law is made with. Begun by MDR_SIZED. */
typedef struct mdr_law_options {
    size_t size;             /**< Of this structure; MDR_SIZED sets it. */
    double smallest_depth;   /**< Without adhesion: depth > 0 from which on the tolerance holds, at most half the largest; nearer
                                  to first touch the law continues value and slope. Default 0: 1e-4 of the largest, or where
                                  the medium begins [length]. */
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
    const struct mdr_conduction *conduction; /**< Of mdr_conduction_new() in conduction.h, of the same bodies: the law has their
                                                  conductance too, within the tolerance. Default NULL: none. */
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
    double energy;    /**< U = int F dd along the branch, from first touch on (elastic energy), with adhesion from pull-off on, with
                           a cohesive stress from bodies that are apart [modulus length^3]. */
    double beyond;    /**< How far d lies beyond the largest depth, where the numbers are those of a tangent and no longer those of
                           the contact; 0 within the range [length]. */
} mdr_law_point;

/** Compiles the law of a contact.
 *  @param contact        contact, with or without adhesion
 *  @param largest_depth  > 0 [length]; the law of an adhesive contact that jumps goes on to where no state beyond is one from
 *                        which the contact unloads to a depth or force that the law answers: mdr_law_about() says how far
 *  @param options        NULL for the defaults
 *  @param out            receives the handle
 *  @return also as mdr_contact_states() and mdr_contact_pull_off(); MDR_ENOCONVERGENCE if the tolerance is not met; with
 *          friction also as mdr_shear_new(), and MDR_EINVALID if it is of another contact */
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

/** The state at one depth of a contact with a history: an open contact closes at d >= 0, with a cohesive stress from the first
 *  attraction on, a closed one stays on its stable segment until that ends, by pull-off or by a jump to another one.
 *  @param law      law
 *  @param d        indentation depth up to the largest one [length]
 *  @param segment  where the contact is: 0 for open before the first call, then what the last call left there
 *  @param point    receives the state
 *  @return also MDR_EDOMAIN beyond the largest depth */
int mdr_law_follow(const mdr_law *law, double d, int *segment, mdr_law_point *point);

/** States of a law. Outputs that are NULL are skipped, and cost nothing.
 *  @param law     law
 *  @param given   MDR_DEPTH or MDR_FORCE: what `in` holds
 *  @param branch  one of enum mdr_branch
 *  @param n       number of states
 *  @param in      [n] depths up to the largest one, where all else is 0 for bodies that are apart [length]; or forces >= 0, with
 *                 adhesion on unloading down to the pull-off force [modulus length^2]
 *  @param d       [n] or NULL: indentation depths [length]
 *  @param a       [n] or NULL: contact radii [length]
 *  @param F       [n] or NULL: normal forces [modulus length^2]
 *  @param k       [n] or NULL: stiffnesses dF/dd at constant a [modulus length]
 *  @param slope   [n] or NULL: along the branch dF/dd [modulus length], where forces are given dd/dF [1/(modulus length)]
 *  @param energy  [n] or NULL: U as in mdr_law_point [modulus length^3]
 *  @return also MDR_EUNREACHABLE below the lowest force, MDR_EDOMAIN beyond the largest depth or force */
int mdr_law_values(const mdr_law *law, int given, int branch, int n, const double in[], double d[], double a[], double F[],
                   double k[], double slope[], double energy[]);

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
    const char *description; /**< The problem it was made from, in the words of the options; as long as the law. */
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
int mdr_law_about(const mdr_law *law, mdr_law_facts *facts);

/** What the first number of a law's buffer is. */
enum mdr_law_format { MDR_LAW_FORMAT = 1296843314 /**< This version. */ };

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
    double first_force;    /**< F at the lowest depth, without adhesion [modulus length^2]. With x = d/lowest and p = force_power, from
                                depth 0 on F = first_force x^p where force_roots = m is 0, else
                                F = first_force x^(m/2) (1 - b + b x^(1/2)) with b = 2 p - m. */
    double first_radius;   /**< There a = end_radius + first_radius (d/lowest)^radius_power [length]. */
    double force_power;    /**< See first_force. */
    double radius_power;   /**< See first_radius. */
    double force_roots;    /**< See first_force: 0 or 2 to 12. */
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
 *  @param is_trial 0: the step is taken; else the records stay as they are, for Newton's method, and for steps that may have to
 *                  be taken back
 *  @param tangent  receives [12 n]: of each contact, for each component i of T, dT_i/dx, dT_i/dy, dT_i/dz by the shift of the step
 *                  [modulus length] and dT_i/dF [1], or dT_i/da [modulus length]; or NULL
 *  @param memory   [memory_size n] the records
 *  @param T        receives [3 n] the tangential forces on the medium [modulus length^2]
 *  @return also MDR_EDOMAIN beyond the largest force, unless the law continues beyond it */
int mdr_law_advance(const mdr_law *law, int n, const double force[], const double shift[], int is_trial, double tangent[],
                    double memory[], double T[]);

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

#ifdef __cplusplus
}
#endif

#endif
