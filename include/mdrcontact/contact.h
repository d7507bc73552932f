/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file contact.h
 * Contacts (2)-(10), (21)-(32): states, pull-off and loops, fields, the field inside.
 * @since 0.1
 */
#ifndef MDRCONTACT_CONTACT_H
#define MDRCONTACT_CONTACT_H

#include "profile.h"
#include "medium.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An indenter on a medium. Made by mdr_contact_new(). */
typedef struct mdr_contact mdr_contact;

/** A cycle of approach and retraction. Made by mdr_loop_new(). */
typedef struct mdr_loop mdr_loop;

/** The edge opening dl of an adhesive contact: the distance of the springs at the edge from the indenter when they let go. */
enum mdr_adhesion_rule {
    MDR_ADHESION_AUTOMATIC = 801, /**< Energy where the medium meets the balance exactly, the source's rule elsewhere. */
    MDR_ADHESION_PAPER = 802,     /**< dl = sqrt(2 pi a gamma/E_eff), equation (28). */
    MDR_ADHESION_ENERGY = 803     /**< dl = sqrt(4 pi a gamma/k'(a)), the balance of energy. */
};

/** Which stable state is meant where an adhesive contact has several. */
enum mdr_branch {
    MDR_ON_LOADING = 301,  /**< The smallest contact, met when the bodies approach. */
    MDR_ON_UNLOADING = 302 /**< The largest contact, kept when they are drawn apart: what is usually meant. */
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
    double cohesive_stress;    /**< sigma_0 >= 0 [modulus]: adhesion with a range, the Dugdale-Maugis zone, on homogeneous bodies and
                                    under the model exact, pairs included. The surfaces pull on each other with sigma_0 wherever
                                    they are less than work_of_adhesion/sigma_0 apart; default 0: a range of nothing. A zone too
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
    double punch_depth;    /**< Depth beyond that of the non-adhesive state of this radius: 0 without adhesion, less than 0 with it, the
                           whole depth under a flat punch [length]. */
    double zone_radius; /**< c, outer radius of the cohesive zone: the bodies pull on each other where a < r < c; 0 without a
                             cohesive stress [length]. With radius 0 they attract each other without contact. */
} mdr_state;

/** States from depths, forces or radii.
 *
 *  A coating far stiffer than the body, from 80 times under a cone, from 12 times at the corner of a wide flat end, bends so much
 *  that depth and force fall over some radii. Of several states of one depth or force without adhesion the one with the smallest
 *  radius is given, to which the contact grows from first touch; larger ones would pull (mdr_load_lowest_pressure()).
 *  @param c       contact
 *  @param given   MDR_DEPTH, MDR_FORCE or MDR_RADIUS: what `in` holds
 *  @param branch  one of enum mdr_branch: which state of an adhesive contact; not looked at for radii
 *  @param n       number of states
 *  @param in      [n] depths, forces or radii
 *  @param out     [n] states; depth 0 without adhesion is first touch, all of it 0
 *  @return also MDR_EUNREACHABLE if there is no such state, MDR_EDOMAIN beyond the end of the indenter or the medium,
 *          MDR_ENOCONVERGENCE */
int mdr_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[]);

/** Where an adhesive contact breaks: first the lowest force, or depth, of all its stable states, then, by radius, where each other
 *  stable segment ends: a coated body can have several. The first is 0 without adhesion.
 *  @param c         contact
 *  @param control   MDR_FORCE or MDR_DEPTH
 *  @param capacity  room in `out` >= 0; 1 for the pull-off alone
 *  @param out       [capacity] receives the first of them; NULL where capacity is 0
 *  @param count     or NULL: how many there are, 0 without adhesion
 *  @return also MDR_EUNREACHABLE if no state is stable under this control, MDR_EDOMAIN if the contact is still stable at the
 *          smallest radius for which the medium is defined, MDR_ENOCONVERGENCE */
int mdr_contact_pull_off(const mdr_contact *c, int control, int capacity, mdr_state out[], int *count);

/** A cycle: approach from afar, jump into contact, press to `largest`, retract until the bodies are apart again.
 *  @param c                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: what the positions of the loop are
 *  @param largest           position where the motion turns back, > 0 [length, or modulus length^2 under force control]
 *  @param points            points on each way, 2 to 1000000; jumps and their ends come on top
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], not looked at otherwise
 *  @param out               receives the handle
 *  @return also MDR_EUNREACHABLE if `largest` cannot be reached or the bodies do not stick when they touch,
 *          MDR_ENOCONVERGENCE */
int mdr_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness, mdr_loop **out);

/** A point of a loop. */
typedef struct mdr_loop_point {
    double position; /**< What is prescribed, see mdr_loop_new(). */
    double depth;    /**< d, negative where the bodies are apart [length]. */
    double radius;   /**< a, 0 where they are apart [length]. */
    double force;    /**< F [modulus length^2]. */
    double jumps;    /**< 1 where the path jumps to the next point, else 0. */
} mdr_loop_point;

/** The points of a loop.
 *  @param l         loop
 *  @param capacity  room in `out` >= 0
 *  @param out       [capacity] receives the first of them; NULL where capacity is 0
 *  @param count     or NULL: receives how many there are */
int mdr_loop_points(const mdr_loop *l, int capacity, mdr_loop_point out[], int *count);

/** What a loop is. */
typedef struct mdr_loop_facts {
    size_t size;              /**< Of this structure; MDR_SIZED sets it. */
    double dissipated_energy; /**< Energy lost in the cycle, the area of the loop; under a prescribed force up to pull-off, for how
                                   far the bodies then fly apart under it is not known [modulus length^3]. */
    int points;               /**< How many points it has. */
    int turning_point;        /**< Index, from 0, of the last point of the approach. */
    int jumps;                /**< How often it jumps. */
} mdr_loop_facts;

/** What a loop is.
 *  @param l      loop
 *  @param facts  begun by MDR_SIZED; receives it */
int mdr_loop_about(const mdr_loop *l, mdr_loop_facts *facts);

/** The load of a state: what it bears on the surface, solved once for all that is read from it. It never changes, any number of
 *  threads may share it, and it keeps what it needs of its contact, which may be freed before it. Made by mdr_contact_load(). */
typedef struct mdr_load mdr_load;

/** The load of a state.
 *  @param c      contact
 *  @param state  a state of this contact, with a radius > 0
 *  @param out    receives the handle
 *  @return also MDR_ENOCONVERGENCE */
int mdr_contact_load(const mdr_contact *c, const mdr_state *state, mdr_load **out);

/** Elastic energy of either body: together int F dd from first touch, with adhesion int F dd + pi a^2 work_of_adhesion along the
 *  branch [modulus length^3].
 *  @param load   load
 *  @param lower  or NULL: receives that of the medium or of the lower body
 *  @param upper  or NULL: receives that of the upper body, 0 for a rigid indenter
 *  @return also MDR_EINVALID for power-law graded media, MDR_ENOCONVERGENCE */
int mdr_load_energy(const mdr_load *load, double *lower, double *upper);

/** A field on the surface.
 *  @param load   load
 *  @param field  MDR_PRESSURE, MDR_DISPLACEMENT, MDR_DISPLACEMENT_LOWER, MDR_DISPLACEMENT_UPPER or MDR_LINE_LOAD
 *  @param n      number of positions
 *  @param r      [n] r or x, see enum mdr_quantity [length]
 *  @param out    [n] values, see enum mdr_quantity
 *  @return also MDR_EDOMAIN for a position outside the range of the field, MDR_ENOCONVERGENCE */
int mdr_load_field(const mdr_load *load, int field, int n, const double r[], double out[]);

/** The lowest pressure of a load without adhesion. Below 0 the bodies would have to pull on each other: the contact is then not
 *  one disc, its pressure is not that of the true contact, and F(d) is off by up to 0.05 % (cone), 0.6 % (r^4) or 3.5 % (flat
 *  punch) at a ratio of moduli of 100; at larger ones, where the radius jumps, by as much as the force jumps there: under a cone
 *  7 % at 300, 28 % at 1,000. It happens on stiff coatings, solved exactly: from a ratio of moduli of 5 (nu = 1/2) to 7 (nu = 0)
 *  under flat ends, 6 to 10 under r^4, 8 to 12 under r^3, 12 to 20 under r^2.5, 50 to 100 under cones; never under paraboloids.
 *  It can also show outside alone: where the surface beyond the contact, MDR_DISPLACEMENT, would pass through the indenter,
 *  u(r) < d - f(r), as under cones from a ratio of 300 on.
 *  @param load      load without adhesion
 *  @param pressure  or NULL: the smallest p(r), 0 <= r <= a; 0, at the edge, where no pressure is negative [modulus]
 *  @param r         or NULL: the r that has it [length]
 *  @return also MDR_EINVALID with adhesion, MDR_ENOCONVERGENCE */
int mdr_load_lowest_pressure(const mdr_load *load, double *pressure, double *r);

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
enum mdr_which_body {
    MDR_BODY_LOWER = 401, /**< The medium, or the lower one of two. */
    MDR_BODY_UPPER = 402  /**< The upper one of two deformable bodies; a rigid indenter is none. */
};

/** Which side of an interface between layers: sigma_rr, sigma_tt and sigma_rt jump there. */
enum mdr_side {
    MDR_SIDE_BELOW = 501, /**< That of the larger depth. */
    MDR_SIDE_ABOVE = 502  /**< That of the smaller depth. */
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

/** Displacements and stresses inside a body of homogeneous, layered or graded material, under the pressure of a load.
 *
 *  Points that form a grid of few distinct r and z cost far less than as many scattered ones. Where the load is singular on the
 *  surface (edge of a flat punch or of an adhesive contact, apex of a cone, edge of a flat end) stresses are infinite, with
 *  friction the shear tractions too; the sign is that inside the contact. What jumps there, s_rt across the edge of a flat end,
 *  has its value just below the surface, halfway. Under an approximate model it is the field in the layers under the model's own
 *  pressure, whose surface does not fit the indenter.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
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
int mdr_load_interior(const mdr_load *load, int body, int side, double friction, int n, const double r[],
                         const double z[], const double angle[], mdr_interior out[]);

/** How far the field of mdr_load_interior() is from what the contact has on its surface, by other equations: at r = 0.31 a, 0.62 a
 *  and 0.9 a s_zz from -p(r), relative to the largest pressure there or the mean one, and u_z from d - f(r), of two bodies from the
 *  body's part of it, relative to d or f(a). Under an approximate model s_zz alone, for its surface does not fit the indenter. Costs
 *  about as much as three points on the surface; one call serves all points of a state.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param deviation receives the largest of them [1]: 1e-8 or less is usual with the default tolerance of a medium
 *  @return as mdr_load_interior() */
int mdr_load_interior_error(const mdr_load *load, int body, double *deviation);

/** Elastic energy in each layer of a body without friction, from the surface down, the half-space last (0 for a rigid base).
 *  Together they are the work of the pressure on the surface.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param capacity  size of the array, >= 0: at most so many are written
 *  @param out       [capacity] energies [modulus length^3]
 *  @param count     receives how many there are
 *  @return also MDR_EINVALID for graded bodies and media without E and nu, MDR_ENOCONVERGENCE */
int mdr_load_layer_energies(const mdr_load *load, int body, int capacity, double out[], int *count);

/** A largest stress and where it is. */
typedef struct mdr_maximum {
    int quantity; /**< MDR_VON_MISES to MDR_FREE_SURFACE_TENSION of enum mdr_quantity. */
    int place;    /**< Which layer or interface, 0 is the first one from the surface; 0 of the free surface. */
    double value; /**< The stress, negative where all of it is compression [modulus]. */
    double r;     /**< Distance from the axis [length]. */
    double z;     /**< Depth [length]. */
    double angle; /**< Azimuth from the direction of sliding, 0 or pi; 0 without friction [radian]. */
} mdr_maximum;

/** What decides inside a body of homogeneous layers: the largest stresses in each layer, at each interface and on the free
 *  surface, and where they are; with friction in the plane of sliding. They are looked for up to 3 (a + z) from the axis, and no
 *  nearer than 1e-3 a to a point where stresses are infinite. They have about ten digits, three beside such a point, places five.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param friction  f >= 0, as of mdr_load_interior()
 *  @param capacity  size of the array, >= 0: at most so many are written; 0: they are counted only
 *  @param out       [capacity] of each layer, the half-space last, MDR_VON_MISES, MDR_TRESCA and MDR_TENSION; of each
 *                   interface MDR_INTERFACE_SHEAR and MDR_INTERFACE_TENSION; then MDR_FREE_SURFACE_TENSION
 *  @param count     receives how many there are
 *  @return as mdr_load_interior(); also MDR_EINVALID for graded bodies, and MDR_ENOCONVERGENCE where mdr_load_interior_error()
 *          is more than 1e-3 */
int mdr_load_critical(const mdr_load *load, int body, double friction, int capacity, mdr_maximum out[],
                         int *count);

/** What a layer, an interface or the free surface bears. */
typedef struct mdr_strength {
    int quantity; /**< MDR_VON_MISES to MDR_FREE_SURFACE_TENSION of enum mdr_quantity. */
    int place;    /**< Which layer or interface, 0 is the first one from the surface; 0 of the free surface. */
    double value; /**< The strength > 0 [modulus]. */
} mdr_strength;

/** A strength that is reached: the state, whose six numbers are those of mdr_state, and where in the body. */
typedef struct mdr_failure_load {
    double depth;       /**< d [length]. */
    double radius;      /**< a [length]; the smallest one looked at where the strength is reached at any load: a sharp tip. */
    double force;       /**< F [modulus length^2]. */
    double stiffness;   /**< k [modulus length]. */
    double punch_depth; /**< Depth beyond that of the non-adhesive state [length]. */
    double zone_radius; /**< 0 [length]. */
    int quantity;       /**< Of the strength. */
    int place;          /**< Of the strength. */
    double strength;    /**< [modulus] */
    double value;       /**< The largest stress: the strength, or more where that is reached at any load [modulus]. */
    double r;           /**< Distance from the axis [length]. */
    double z;           /**< Depth in the body [length]. */
    double angle;       /**< Azimuth from the direction of sliding, 0 or pi; 0 without friction [radian]. */
} mdr_failure_load;

/** The loads at which strengths are reached first, as the contact grows. At the edge of a flat punch or of an adhesive contact, where
 *  stresses are infinite no matter how weak the load is, there is no failure.
 *  @param c               contact
 *  @param body            one of enum mdr_which_body
 *  @param friction        f >= 0, as of mdr_load_interior()
 *  @param largest_radius  contact radii are looked at up to this one, and up to where indenter and medium end, four decades [length];
 *                         0: 30 times the thickness of all layers
 *  @param n               number of strengths, at least 1
 *  @param strengths       [n] strengths; what has none is left out
 *  @param capacity        size of the array, >= 0: at most so many are written; n is enough
 *  @param out             [capacity] those that are reached, the smallest force first
 *  @param count           receives how many are reached
 *  @return as mdr_load_critical(); MDR_EINVALID also for a place that the body does not have, and without layers for
 *          largest_radius = 0 */
int mdr_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
                              const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count);

#ifdef __cplusplus
}
#endif

#endif
