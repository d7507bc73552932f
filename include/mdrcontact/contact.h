/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file contact.h
 * Contacts: an indenter pressed into a medium.
 *
 * A contact combines an indenter (profile.h) with a medium (medium.h). Given a depth, a force or a contact radius,
 * mdr_contact_states() computes states. mdr_contact_load() turns a state into a load, from which all fields are computed:
 * - on the surface: mdr_load_field(), mdr_load_lowest_pressure(), mdr_load_energy();
 * - below the surface: mdr_load_interior(), mdr_load_layer_energies(), mdr_load_critical(). mdr_contact_first_failure() finds the *
 *   states at which strengths are reached.
 *
 * A contact with a viscoelastic body has no states; see time.h. Tangential loading is in friction.h, fast evaluation in law.h.
 *
 * Equations (2)-(10) and (21)-(32) of Popov (2014).
 * @since 0.1
 */
#ifndef MDRCONTACT_CONTACT_H
#define MDRCONTACT_CONTACT_H

#include "profile.h"
#include "medium.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A contact of an indenter with a medium. Created by mdr_contact_new(). Immutable. */
typedef struct mdr_contact mdr_contact;

/** An approach-retraction loop. Created by mdr_loop_new(). Immutable. */
typedef struct mdr_loop mdr_loop;

/** The elongation dl at which the springs at the edge of an adhesive contact detach. An adhesive state of radius a has the depth d
 *  = d0(a) - dl and the force F = F0(a) - k(a) dl, with d0 and F0 of the non-adhesive state of the same radius. */
enum mdr_adhesion_rule {
    MDR_ADHESION_AUTOMATIC = 801, /**< MDR_ADHESION_ENERGY on media for which the energy balance is exact, MDR_ADHESION_PAPER on the
                                       others. */
    MDR_ADHESION_PAPER = 802,     /**< dl = sqrt(2 pi a gamma/E_eff), equation (28). */
    MDR_ADHESION_ENERGY = 803     /**< dl = sqrt(4 pi a gamma/k'(a)), the energy balance. */
};

/** Selects one of several stable states of an adhesive contact. */
enum mdr_branch {
    MDR_ON_LOADING = 301,  /**< The smallest contact radius, reached on approach. */
    MDR_ON_UNLOADING = 302 /**< The largest contact radius, kept on retraction; the usual choice. */
};

/** Options of mdr_contact_new(), which copies the arrays. Initialize with MDR_SIZED. */
typedef struct mdr_contact_options {
    size_t size;               /**< Size of this structure; MDR_SIZED sets it. */
    int zeta_count;            /**< Size of the table of zeta in (9), d = zeta(a) g(a), at least 3; default 0: zeta = 1. */
    const double *zeta_radius; /**< [zeta_count] contact radii > 0, strictly ascending; contacts reach the last one [length]. */
    const double *zeta;        /**< [zeta_count] zeta > 0 [1]; zeta(a) g(a) must not decrease. */
    double work_of_adhesion;   /**< gamma >= 0, energy per area that separates the surfaces [modulus length]; default 0. */
    int adhesion_rule;         /**< One of enum mdr_adhesion_rule; default MDR_ADHESION_AUTOMATIC. */
    int zeta_is_exact;         /**< Not 0: use the zeta of the exact solution of the same body instead of a table, for radii up to
                                    1000 thicknesses. E_eff is then the only approximation. Coated, layered and graded bodies;
                                    default 0. */
    double cohesive_stress;    /**< sigma_0 >= 0 [modulus]. Greater than 0: finite-range adhesion (Dugdale-Maugis) on homogeneous
                                    bodies and with MDR_MODEL_EXACT, pairs included. The surfaces attract each other with the stress
                                    sigma_0 if they are less than work_of_adhesion/sigma_0 apart. Default 0: the JKR limit. A
                                    cohesive zone too short to affect the result is neglected, and mdr_contact_warnings() reports
                                    it. */
} mdr_contact_options;

/** Create a contact. The indenter and the medium are copied.
 *  @param profile  indenter
 *  @param medium   medium
 *  @param options  NULL: default options
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN if the flat end of the indenter is larger than the largest contact radius of the medium
 *  @code
 *  mdr_contact_options options = MDR_SIZED(mdr_contact_options);
 *  mdr_contact *adhesive = NULL;
 *  options.work_of_adhesion = 0.05;
 *  status = mdr_contact_new(ball, medium, &options, &adhesive);
 *  MDR_FREE(adhesive);
 *  @endcode
 */
int mdr_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options, mdr_contact **out);

/** A state of a contact. */
typedef struct mdr_state {
    double depth;       /**< d, indentation depth, positive into the medium [length]. */
    double radius;      /**< a, contact radius [length]. */
    double force;       /**< F, normal force, positive in compression [modulus length^2]. */
    double stiffness;   /**< k = dF/dd at constant a, 2 a E_eff(a) [modulus length]; along the branch dF/dd is that of
                             mdr_contact_slope(), which differs from k under adhesion. */
    double punch_depth; /**< d - d0(a): depth relative to the non-adhesive state of the same radius [length]. 0 without adhesion,
                             negative with adhesion, equal to d under a flat punch. */
    double zone_radius; /**< c, outer radius of the cohesive zone a < r < c in which the surfaces attract each other; 0 without a
                             cohesive stress [length]. With a = 0 and c > 0 the surfaces attract each other before contact. */
} mdr_state;

/** Compute states from depths, forces or radii.
 *
 *  Very stiff coatings bend so strongly that depth and force decrease over part of the range of radii: from a modulus ratio of 80
 *  under a cone, and of 12 at the corner of a wide flat end. Several states without adhesion can then share one depth or force. The
 *  function returns the state of smallest radius, which a growing contact reaches first. States of larger radius would need tensile
 *  pressures; see mdr_load_lowest_pressure().
 *  @param c       contact
 *  @param given   MDR_DEPTH, MDR_FORCE or MDR_RADIUS: the quantity in `in`
 *  @param branch  one of enum mdr_branch, for adhesive contacts; ignored for radii
 *  @param n       number of states
 *  @param in      [n] depths, forces or radii
 *  @param out     [n] states. Without adhesion, all members are 0 at depth 0, the initial contact
 *  @return also MDR_EUNREACHABLE if no such state exists, MDR_EDOMAIN beyond the end of the indenter or of the medium,
 *          MDR_ENOCONVERGENCE
 *  @code
 *  const double depths[2] = {20e-9, 50e-9};
 *  mdr_state states[2];
 *  status = mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, 2, depths, states);
 *  @endcode
 */
int mdr_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[]);

/** Compute dF/dd along the branch of equilibria, on which the contact radius changes with the depth.
 *
 *  Without adhesion, and at a vertical wall of the indenter, it is the stiffness of the state, dF/dd at constant radius. With
 *  adhesion it is dF/dd = k - k'(a) dl/(d0'(a) - dl'(a)), with dl = -punch_depth. For a paraboloid on a half-space it is k/3 at d =
 *  0, 0 at pull-off under force control, infinite at pull-off under depth control, and negative between the two. It has about eight
 *  significant digits.
 *  @param c       contact
 *  @param n       number of states
 *  @param states  [n] states of equilibrium of this contact
 *  @param out     [n] receives the slopes [modulus length]; 0 of separated bodies
 *  @return also MDR_EINVALID for a state that is not one of this contact, MDR_EDOMAIN if a cohesive zone reaches the end of the
 *          indenter or of the medium, MDR_ENOCONVERGENCE
 *  @code
 *  double slope;
 *  status = mdr_contact_slope(contact, 1, &state, &slope);
 *  @endcode
 */
int mdr_contact_slope(const mdr_contact *c, int n, const mdr_state states[], double out[]);

/** Compute the states at which an adhesive contact detaches: first the lowest force, or depth, of all stable states, then the ends
 *  of all other stable segments in order of radius. A coated body can have several segments.
 *  @param c         contact
 *  @param control   MDR_FORCE or MDR_DEPTH
 *  @param capacity  size of `out` >= 0; 1 for pull-off alone
 *  @param out       [capacity] receives the first states; NULL if capacity is 0
 *  @param count     or NULL: receives the number of states, 0 without adhesion
 *  @return also MDR_EUNREACHABLE if no state is stable under this control, MDR_EDOMAIN if the contact is still stable at the
 *          smallest radius of the medium, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_state pull_off;
 *  int count;
 *  status = mdr_contact_pull_off(sticky, MDR_FORCE, 1, &pull_off, &count);
 *  @endcode
 */
int mdr_contact_pull_off(const mdr_contact *c, int control, int capacity, mdr_state out[], int *count);

/** Compute an approach-retraction loop: approach from separation, jump-in, loading to `largest`, retraction until the bodies are
 *  separated.
 *  @param c                 contact
 *  @param control           MDR_FORCE, MDR_DEPTH or MDR_SPRING: the controlled quantity
 *  @param largest           turning point of the controlled quantity, > 0 [length, or modulus length^2 under force control]
 *  @param points            number of points on each way, 2 to 1000000; jumps add further points
 *  @param spring_stiffness  > 0 for MDR_SPRING [modulus length], otherwise ignored
 *  @param out               receives the handle
 *  @return also MDR_EUNREACHABLE if `largest` cannot be reached or the bodies do not adhere on contact, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_loop *cycle = NULL;
 *  status = mdr_loop_new(sticky, MDR_SPRING, 2e-6, 50, 0.5, &cycle);
 *  MDR_FREE(cycle);
 *  @endcode
 */
int mdr_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness, mdr_loop **out);

/** A point of a loop. */
typedef struct mdr_loop_point {
    double position; /**< The controlled quantity, see mdr_loop_new(). */
    double depth;    /**< d, negative for separated bodies [length]. */
    double radius;   /**< a, 0 for separated bodies [length]. */
    double force;    /**< F [modulus length^2]. */
    double jumps;    /**< 1 if the path jumps to the next point, otherwise 0. */
} mdr_loop_point;

/** Return the points of a loop.
 *  @param l         loop
 *  @param capacity  size of `out` >= 0
 *  @param out       [capacity] receives the first points; NULL if capacity is 0
 *  @param count     or NULL: receives the number of points
 *  @code
 *  mdr_loop_point points[200];
 *  int count;
 *  status = mdr_loop_points(loop, 200, points, &count);
 *  @endcode
 */
int mdr_loop_points(const mdr_loop *l, int capacity, mdr_loop_point out[], int *count);

/** Properties of a loop. */
typedef struct mdr_loop_facts {
    size_t size;              /**< Size of this structure; MDR_SIZED sets it. */
    double dissipated_energy; /**< Energy dissipated in the loop, its area. Under force control the loop ends at pull-off, because
                                   the distance that the bodies then move apart is unknown [modulus length^3]. */
    int points;               /**< Number of points. */
    int turning_point;        /**< Index, from 0, of the last point of the approach. */
    int jumps;                /**< Number of jumps. */
} mdr_loop_facts;

/** Return the properties of a loop.
 *  @param l      loop
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
 *  status = mdr_loop_about(loop, &facts);
 *  @endcode
 */
int mdr_loop_about(const mdr_loop *l, mdr_loop_facts *facts);

/** The surface load of a state, solved once for all fields. It contains the data of its contact that it needs; the contact may be
 *  freed first. Created by mdr_contact_load(). Immutable. */
typedef struct mdr_load mdr_load;

/** Compute the load of a state.
 *  @param c      contact
 *  @param state  a state of this contact, with a radius > 0
 *  @param out    receives the handle
 *  @return also MDR_ENOCONVERGENCE
 *  @code
 *  mdr_load *pressed = NULL;
 *  status = mdr_contact_load(contact, &state, &pressed);
 *  MDR_FREE(pressed);
 *  @endcode
 */
int mdr_contact_load(const mdr_contact *c, const mdr_state *state, mdr_load **out);

/** Compute the elastic energy of either body [modulus length^3]. The sum is int F dd from initial contact, with adhesion int F dd +
 *  pi a^2 work_of_adhesion along the branch.
 *  @param load   load
 *  @param lower  or NULL: receives the energy of the medium or of the lower body
 *  @param upper  or NULL: receives the energy of the upper body, 0 for a rigid indenter
 *  @return also MDR_EINVALID for power-law graded media, MDR_ENOCONVERGENCE
 *  @code
 *  double energy;
 *  status = mdr_load_energy(load, &energy, NULL);
 *  @endcode
 */
int mdr_load_energy(const mdr_load *load, double *lower, double *upper);

/** Compute a surface field.
 *  @param load   load
 *  @param field  MDR_PRESSURE, MDR_DISPLACEMENT, MDR_DISPLACEMENT_LOWER, MDR_DISPLACEMENT_UPPER or MDR_LINE_LOAD
 *  @param n      number of positions
 *  @param r      [n] r or x, see enum mdr_quantity [length]
 *  @param out    [n] values, see enum mdr_quantity
 *  @return also MDR_EDOMAIN for a position outside the range of the field, MDR_ENOCONVERGENCE
 *  @code
 *  const double r[2] = {0.0, 0.5e-6};
 *  double p[2];
 *  status = mdr_load_field(load, MDR_PRESSURE, 2, r, p);
 *  @endcode
 */
int mdr_load_field(const mdr_load *load, int field, int n, const double r[], double out[]);

/** Find the lowest pressure of a load without adhesion.
 *
 *  A negative value means that the assumption of a single contact disc fails: the true contact is a ring, or a disc and a ring. The
 *  pressure is then wrong. The error of F(d) is up to 0.05 % (cone), 0.6 % (r^4) or 3.5 % (flat punch) at a modulus ratio of 100.
 *  At larger ratios, at which the contact radius jumps, the error is as large as the jump of the force: under a cone 7 % at 300 and
 *  28 % at 1,000.
 *
 *  This happens on stiff coatings with MDR_MODEL_EXACT. It begins at these modulus ratios E0/E1 (first value nu = 1/2, second nu =
 *  0): flat ends 5 to 7, r^4 6 to 10, r^3 8 to 12, r^2.5 12 to 20, cones 50 to 100, paraboloids never.
 *
 *  Above a ratio of about 300 under cones the failure can be visible outside the contact only. The free surface would then
 *  penetrate the indenter: u(r) < d - f(r), with u of MDR_DISPLACEMENT.
 *  @param load      load without adhesion
 *  @param pressure  or NULL: receives the smallest p(r), 0 <= r <= a; 0, at the edge, if no pressure is negative [modulus]
 *  @param r         or NULL: receives the radius of this minimum [length]
 *  @return also MDR_EINVALID with adhesion, MDR_ENOCONVERGENCE
 *  @code
 *  double lowest, where;
 *  status = mdr_load_lowest_pressure(load, &lowest, &where);
 *  @endcode
 */
int mdr_load_lowest_pressure(const mdr_load *load, double *pressure, double *r);

/** Warnings about a state, combined as bits. A warning means that the result lies outside the range of linear elasticity, or that
 *  an input looks wrong. */
enum mdr_warning {
    MDR_WARNING_SLOPE = 1,       /**< The slope f'(a) of the indenter at the contact edge exceeds 1.2: 50 degrees, or a = 1.2 R of a
                                      paraboloid, which represents a sphere only for a much smaller than R. */
    MDR_WARNING_PRESSURE = 2,    /**< The mean pressure exceeds 0.6 of E_eff(a) and of the contact modulus of the surface, for
                                      example under a flat punch at depths beyond 0.94 a. Not set together with MDR_WARNING_SLOPE if
                                      the slope is the cause. */
    MDR_WARNING_COMPRESSION = 4, /**< Layers are compressed by more than half of their thickness. On a rigid base the depth is
                                      compared with the thickness; on an elastic one the depth minus F/(a E1*), the largest possible
                                      displacement of the base. */
    MDR_WARNING_CONTRAST = 8,    /**< Young's moduli differ by a factor of 1e9 or more, for example because of mixed units (GPa and
                                      Pa). */
    MDR_WARNING_SHORT_ZONE = 16, /**< The cohesive zone is too short to affect the result and is neglected: the JKR limit
                                      applies. */
    MDR_WARNING_WETTING = 32     /**< The work of adhesion exceeds 0.05 of the surface tension, or under a plate 0.05 of B^(1/3)
                                      (0.5 E*)^(2/3): the slope of the surface at the edge is not small. */
};

/** Return the warnings about a state.
 *  @param c         contact
 *  @param state     a state of this contact
 *  @param buffer    receives a line of text for each warning, in the order of the codes; may be NULL if length < 1
 *  @param length    size of buffer; 1000 suffices, a longer text is truncated
 *  @param warnings  or NULL: receives the bits of enum mdr_warning, 0 if there are none
 *  @return also MDR_EINVALID for a state that cannot belong to this contact
 *  @code
 *  char text[1000];
 *  int warnings;
 *  status = mdr_contact_warnings(contact, &state, text, 1000, &warnings);
 *  @endcode
 */
int mdr_contact_warnings(const mdr_contact *c, const mdr_state *state, char *buffer, int length, int *warnings);

/** One of two bodies in contact. */
enum mdr_which_body {
    MDR_BODY_LOWER = 401, /**< The medium, or the lower of two bodies. */
    MDR_BODY_UPPER = 402  /**< The upper of two deformable bodies. A rigid indenter does not count as a body. */
};

/** Side of an interface between layers, at which sigma_rr, sigma_tt and sigma_rt are discontinuous. */
enum mdr_side {
    MDR_SIDE_BELOW = 501, /**< The side of larger depth. */
    MDR_SIDE_ABOVE = 502  /**< The side of smaller depth. */
};

/** Displacements and stresses at a point inside a body, in cylindrical coordinates (r, t, z); z and u_z point into the body,
 *  tension is positive. */
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

/** Compute displacements and stresses inside a body of homogeneous, layered or graded material, under the pressure of a load.
 *
 *  Points on a grid of few distinct r and z cost far less than the same number of scattered points. If the load is singular (edge
 *  of a flat punch or of an adhesive contact, apex of a cone, edge of a flat end), stresses at that point are infinite, with the
 *  sign that they have inside the contact; with friction the shear tractions are also infinite. s_rt is discontinuous across the
 *  edge of a flat end: the function returns the mean of both sides, the value just below the surface. With an approximate model the
 *  result is the field in the layers under the pressure of the model, whose surface does not fit the indenter.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param side      one of enum mdr_side, for points on an interface
 *  @param friction  f >= 0: the contact slides, with the traction f p(r) in +x on the lower body and -f p(r) on the upper one; p is
 *                   that of the contact without friction (Goodman). 0 with adhesion.
 *  @param n         number of points
 *  @param r         [n] distances from the axis, >= 0 [length]
 *  @param z         [n] depths in the body, >= 0 [length]
 *  @param angle     [n] azimuths from +x [radian], or NULL: 0
 *  @param out       [n] displacements and stresses
 *  @return also MDR_EDOMAIN for points in a rigid base or beyond 1e12 a, MDR_EINVALID for media without E and nu and for tensile
 *          pressures under friction, MDR_ENOCONVERGENCE
 *  @code
 *  const double r[2] = {0.0, 0.3e-6}, z[2] = {0.2e-6, 0.2e-6};
 *  mdr_interior inside[2];
 *  status = mdr_load_interior(load, MDR_BODY_LOWER, MDR_SIDE_BELOW, 0.0, 2, r, z, NULL, inside);
 *  @endcode
 */
int mdr_load_interior(const mdr_load *load, int body, int side, double friction, int n, const double r[],
                         const double z[], const double angle[], mdr_interior out[]);

/** Estimate the error of mdr_load_interior() by a comparison with the surface fields of the contact, which come from other
 *  equations: at r = 0.31 a, 0.62 a and 0.9 a, s_zz with -p(r), relative to the largest or the mean pressure there, and u_z with
 *  the displacement of this body, relative to d or f(a). With an approximate model only s_zz is compared, because its surface does
 *  not fit the indenter. The cost is about that of three points on the surface; one call serves all points of a state.
 *  @param load       load
 *  @param body       one of enum mdr_which_body
 *  @param deviation  receives the largest difference [1]; typically <= 1e-8 with the default tolerance of a medium
 *  @return as mdr_load_interior()
 *  @code
 *  double deviation;
 *  status = mdr_load_interior_error(load, MDR_BODY_LOWER, &deviation);
 *  @endcode
 */
int mdr_load_interior_error(const mdr_load *load, int body, double *deviation);

/** Compute the elastic energy in each layer of a body without friction, top to bottom, the half-space last (0 for a rigid base).
 *  The sum is the work of the pressure on the surface.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param capacity  size of `out`, >= 0
 *  @param out       [capacity] receives the first energies [modulus length^3]
 *  @param count     receives the number of energies
 *  @return also MDR_EINVALID for graded bodies and media without E and nu, MDR_ENOCONVERGENCE
 *  @code
 *  double energies[2];
 *  int count;
 *  status = mdr_load_layer_energies(load, MDR_BODY_LOWER, 2, energies, &count);
 *  @endcode
 */
int mdr_load_layer_energies(const mdr_load *load, int body, int capacity, double out[], int *count);

/** A largest stress and its position. */
typedef struct mdr_maximum {
    int quantity; /**< MDR_VON_MISES to MDR_FREE_SURFACE_TENSION of enum mdr_quantity. */
    int place;    /**< Layer or interface, counted from 0 at the surface; 0 for the free surface. */
    double value; /**< The stress, negative if the whole region is under compression [modulus]. */
    double r;     /**< Distance from the axis [length]. */
    double z;     /**< Depth [length]. */
    double angle; /**< Azimuth from the direction of sliding, 0 or pi; 0 without friction [radian]. */
} mdr_maximum;

/** Find the largest stresses in each layer, at each interface and on the free surface of a layered body, and their positions; with
 *  friction in the plane of sliding. The search extends to a distance of 3 (a + z) from the axis. It excludes the neighbourhood
 *  (1e-3 a) of points where the stress is singular. Stresses are accurate to about ten digits, next to a singular point to three;
 *  positions to five.
 *  @param load      load
 *  @param body      one of enum mdr_which_body
 *  @param friction  f >= 0, as for mdr_load_interior()
 *  @param capacity  size of `out`, >= 0; 0: only count
 *  @param out       [capacity] receives the first maxima: for each layer, the half-space last, MDR_VON_MISES, MDR_TRESCA and
 *                   MDR_TENSION; for each interface MDR_INTERFACE_SHEAR and MDR_INTERFACE_TENSION; then MDR_FREE_SURFACE_TENSION
 *  @param count     receives the number of maxima
 *  @return as mdr_load_interior(); also MDR_EINVALID for graded bodies, and MDR_ENOCONVERGENCE if mdr_load_interior_error() exceeds
 *          1e-3
 *  @code
 *  mdr_maximum maxima[9];
 *  int count;
 *  status = mdr_load_critical(load, MDR_BODY_LOWER, 0.0, 9, maxima, &count);
 *  @endcode
 */
int mdr_load_critical(const mdr_load *load, int body, double friction, int capacity, mdr_maximum out[],
                         int *count);

/** Strength of a layer, an interface or the free surface. */
typedef struct mdr_strength {
    int quantity; /**< MDR_VON_MISES to MDR_FREE_SURFACE_TENSION of enum mdr_quantity. */
    int place;    /**< Layer or interface, counted from 0 at the surface; 0 for the free surface. */
    double value; /**< The strength > 0 [modulus]. */
} mdr_strength;

/** A strength that is reached: the state, with the members of mdr_state, and the position in the body. */
typedef struct mdr_failure_load {
    double depth;       /**< d [length]. */
    double radius;      /**< a [length]; the smallest radius of the search if the strength is exceeded at any load, as under a sharp
                             tip. */
    double force;       /**< F [modulus length^2]. */
    double stiffness;   /**< k [modulus length]. */
    double punch_depth; /**< Depth relative to the non-adhesive state [length]. */
    double zone_radius; /**< 0 [length]. */
    int quantity;       /**< Quantity of the strength. */
    int place;          /**< Place of the strength. */
    double strength;    /**< The strength [modulus]. */
    double value;       /**< The largest stress: the strength, or more if the strength is exceeded at any load [modulus]. */
    double r;           /**< Distance from the axis [length]. */
    double z;           /**< Depth in the body [length]. */
    double angle;       /**< Azimuth from the direction of sliding, 0 or pi; 0 without friction [radian]. */
} mdr_failure_load;

/** Find the loads at which strengths are first reached as the contact grows. The singular edge of a flat punch or of an adhesive
 *  contact does not count as a failure, because its stresses are infinite at any load.
 *  @param c               contact
 *  @param body            one of enum mdr_which_body
 *  @param friction        f >= 0, as for mdr_load_interior()
 *  @param largest_radius  the search covers four decades of contact radii up to this one, and up to the end of indenter and medium
 *                         [length]; 0: 30 times the total thickness of the layers
 *  @param n               number of strengths, at least 1
 *  @param strengths       [n] strengths; omit quantities without one
 *  @param capacity        size of `out`, >= 0; n suffices
 *  @param out             [capacity] receives the strengths that are reached, in order of increasing force
 *  @param count           receives the number of strengths that are reached
 *  @return as mdr_load_critical(); MDR_EINVALID also for a place that the body does not have, and for largest_radius = 0 without
 *          layers
 *  @code
 *  const mdr_strength yield = {MDR_VON_MISES, 1, 7e9};
 *  mdr_failure_load failure;
 *  int count;
 *  status = mdr_contact_first_failure(contact, MDR_BODY_LOWER, 0.0, 0.0, 1, &yield, 1, &failure, &count);
 *  @endcode
 */
int mdr_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n,
                              const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count);

#ifdef __cplusplus
}
#endif

#endif
