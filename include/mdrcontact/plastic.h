/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file plastic.h
 * Bodies that yield: imprints, laws, pressure caps. Option MDRCONTACT_PLASTIC.
 * @since 0.1
 */
#ifndef MDRCONTACT_PLASTIC_H
#define MDRCONTACT_PLASTIC_H

#include "contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Imprints ---- */

/** The imprint of a plastic contact: a body, and the profile that unloading and reloading are elastic contacts of. Immutable.
 *  Created by mdr_imprint_new(), mdr_imprint_two_terms() or mdr_imprint_from_pressure(). */
typedef struct mdr_imprint mdr_imprint;

/** Create an imprint from radius, force and depths of an indentation. The pressure at the largest load is assumed to have two terms,
 *  p(r) = uniform + hertz sqrt(1 - r^2/A^2), which force and recovery determine (theory/plastic.md (2.4)).
 *
 *  While nothing yields, unloading and reloading are exactly those of an elastic contact of mdr_imprint_profile() on the same body.
 *  mdr_imprint_reverse_yield() tells whether something does.
 *  @param medium          a homogeneous or an exact medium
 *  @param radius          A > 0, contact radius at the largest load [length]
 *  @param force           F > 0 at the largest load [modulus length^2]
 *  @param residual_depth  depth at which unloading ends the contact, 0 <= residual_depth < depth [length]
 *  @param depth           depth at the largest load, from initial contact [length]
 *  @param out             receives the handle
 *  @return also MDR_EINVALID if the pressure would fall towards the edge by more than Hertz's, or rise so much that the line load
 *          does; MDR_EDOMAIN if the contact would end in a ring, as on very stiff layers; MDR_ENOCONVERGENCE
 *  @code
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_new(medium, 1e-6, 0.018, 40e-9, 140e-9, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_new(const mdr_medium *medium, double radius, double force, double residual_depth, double depth, mdr_imprint **out);

/** Create the imprint of the pressure p(r) = uniform + hertz sqrt(1 - r^2/A^2), r < A, at the largest load.
 *  @param medium   a homogeneous or an exact medium
 *  @param radius   A > 0, contact radius at the largest load [length]
 *  @param uniform  uniform part of the pressure >= 0 [modulus]
 *  @param hertz    Hertz's part of the pressure, greater than -(2/pi) uniform [modulus]
 *  @param depth    depth at the largest load [length]; 0: depths count from there
 *  @param out      receives the handle
 *  @return also MDR_EDOMAIN if the contact would end in a ring; MDR_ENOCONVERGENCE
 *  @code
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_two_terms(medium, 1e-6, 5e9, 2e9, 0.0, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out);

/** Create the imprint of a pressure known at points, such as that of finite elements. It is represented by a polynomial of degree 1
 *  to 8 in sqrt(1 - r^2/A^2), by least squares; mdr_imprint_about() returns its misfit.
 *  @param medium  a homogeneous or an exact medium
 *  @param n       number of points, at least 4
 *  @param r       [n] radii >= 0, ascending; the last one is A, the edge of the contact [length]
 *  @param p       [n] pressure >= 0 at the largest load [modulus]
 *  @param depth   depth at the largest load [length]; 0: depths count from there
 *  @param out     receives the handle
 *  @return also MDR_EINVALID if the polynomial misses the largest pressure by more than 5 %, MDR_EDOMAIN if the contact would end in
 *          a ring; MDR_ENOCONVERGENCE
 *  @code
 *  const double r[5] = {0.0, 0.25e-6, 0.5e-6, 0.75e-6, 1e-6};
 *  const double p[5] = {7e9, 6.94e9, 6.73e9, 6.32e9, 5e9};
 *  mdr_imprint *left = NULL;
 *  status = mdr_imprint_from_pressure(medium, 5, r, p, 0.0, &left);
 *  MDR_FREE(left);
 *  @endcode
 */
int mdr_imprint_from_pressure(const mdr_medium *medium, int n, const double r[], const double p[], double depth, mdr_imprint **out);

/** Create the indenter whose elastic contact with the body of an imprint is its unloading and reloading. It ends at A, the radius of
 *  the largest load. Its depths count from the end of contact: they are those of the imprint less its residual depth. With adhesion
 *  the edge rests at A until the work of adhesion detaches it (theory/plastic.md (3.1)).
 *  @param i    imprint
 *  @param out  receives the handle
 *  @code
 *  mdr_profile *effective = NULL;
 *  status = mdr_imprint_profile(imprint, &effective);
 *  MDR_FREE(effective);
 *  @endcode
 */
int mdr_imprint_profile(const mdr_imprint *i, mdr_profile **out);

/** Properties of an imprint. */
typedef struct mdr_imprint_facts {
    size_t size;           /**< Size of this structure; MDR_SIZED sets it. */
    double radius;         /**< A, contact radius at the largest load [length]. */
    double force;          /**< F at the largest load [modulus length^2]. */
    double depth;          /**< Depth at the largest load [length]. */
    double residual_depth; /**< Depth at which unloading ends the contact [length]. */
    double recovered_work; /**< Work that unloading from the largest load gives back [modulus length^3]. */
    double uniform;        /**< Uniform part of the pressure [modulus]; 0 unless the pressure has two terms. */
    double hertz;          /**< Hertz's part of the pressure [modulus]; 0 unless the pressure has two terms. */
    double misfit;         /**< mdr_imprint_new(): part of F/A by which force and depths need a uniform part below 0, taken as 0, at
                                most 0.005; mdr_imprint_from_pressure(): largest difference at the points relative to the largest
                                pressure [1]. */
} mdr_imprint_facts;

/** Return the properties of an imprint.
 *  @param i      imprint
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);
 *  status = mdr_imprint_about(imprint, &facts);
 *  @endcode
 */
int mdr_imprint_about(const mdr_imprint *i, mdr_imprint_facts *facts);

/** Compute R_Y, the largest ratio over the layers of the von Mises stress under the pressure at the largest load and of the yield
 *  stress. It tells whether unloading is elastic (theory/plastic.md (1.9)): below 1.7 it is; from 1.7 to 2 the force is accurate to
 *  1e-3 of the largest one; from 2 to 3 its error is 0.1 % to 2.5 %; above 3 the imprint does not hold.
 *  @param i             imprint
 *  @param n             number of layers with the half-space
 *  @param yield_stress  [n] of each layer top to bottom, > 0, infinite for one that does not yield [modulus]
 *  @param ratio         receives R_Y [1]
 *  @param layer         receives the layer where it is, 0 the first
 *  @return also MDR_EDOMAIN for R_Y > 3, MDR_EINVALID for graded bodies
 *  @code
 *  const double yield_stress[2] = {3e9, 7e9};
 *  double ratio;
 *  int layer;
 *  status = mdr_imprint_reverse_yield(imprint, 2, yield_stress, &ratio, &layer);
 *  @endcode
 */
int mdr_imprint_reverse_yield(const mdr_imprint *i, int n, const double yield_stress[], double *ratio, int *layer);

/* ---- Laws of contacts that yield ---- */

/** An isotropic material that yields at a stress which may rise with the plastic strain, or one that does not yield. Immutable.
 *  Created by mdr_yielding_new(). */
typedef struct mdr_yielding mdr_yielding;

/** The law of a contact that yields: force, slope and radius over the depth for many contacts, each of which remembers its largest
 *  depth. Immutable. Created by mdr_plastic_law_new(), mdr_plastic_law_from_points() or mdr_plastic_law_with_radius().
 *
 *  The calling program keeps the memory of each contact: memory_size numbers (mdr_plastic_law_facts), all 0 before the first step.
 *  It may copy and store them. The memories of n contacts are consecutive in one array. The first number is the largest depth so
 *  far. With adhesion it is negative while the contact is closed, and the second number is the energy that jumps have lost. */
typedef struct mdr_plastic_law mdr_plastic_law;

/** Create a material that yields.
 *  @param E             Young's modulus > 0 [modulus]
 *  @param nu            Poisson's ratio, 0 to 0.49 [1]; of a material that does not yield -1 to 0.5
 *  @param n             number of points, at least 1 of a material that yields; 1: perfect plasticity
 *  @param strain        [n] plastic strains >= 0, rising [1]
 *  @param yield_stress  [n] yield stresses > 0, which do not fall and rise less than proportionally to the strain; linear between
 *                       the points, constant below and above them [modulus]. Or NULL: it does not yield
 *  @param out           receives the handle
 *  @code
 *  const double strain = 0.0, Y = 1e9;
 *  mdr_yielding *metal = NULL;
 *  status = mdr_yielding_new(200e9, 0.3, 1, &strain, &Y, &metal);
 *  MDR_FREE(metal);
 *  @endcode
 */
int mdr_yielding_new(double E, double nu, int n, const double strain[], const double yield_stress[], mdr_yielding **out);

/** Estimate a yield stress from a hardness H, the mean pressure of a spherical indentation.
 *  @param E             Young's modulus > 0 [modulus]
 *  @param nu            Poisson's ratio, 0 to 0.49 [1]
 *  @param hardness      H > 0 [modulus]
 *  @param radius_ratio  a/R of that indentation, at most 0.3 [1]: H = Y P(a E* / (R Y)). 0: not known, H = 2.8 Y
 *  @param yield_stress  receives Y [modulus]
 *  @param error         receives the relative error of Y; 0.08 if a/R is not known, as P is 2.6 to 3.01 from a E* / (R Y) = 23 on [1]
 *  @return also MDR_EDOMAIN if nothing yields under H, if a E* / (R Y) exceeds 250, or a/R 0.3
 *  @code
 *  double Y, error;
 *  status = mdr_yield_stress_from_hardness(200e9, 0.3, 2.8e9, 0.0, &Y, &error);
 *  @endcode
 */
int mdr_yield_stress_from_hardness(double E, double nu, double hardness, double radius_ratio, double *yield_stress, double *error);

/** Options of mdr_plastic_law_new(). Initialize with MDR_SIZED. */
typedef struct mdr_plastic_law_options {
    size_t size;               /**< Size of this structure; MDR_SIZED sets it. */
    const mdr_yielding *other; /**< The other body: one that does not yield, or one equal to the first. Default NULL: rigid. */
    double work_of_adhesion;   /**< >= 0; it must not yield the body alone. The contact then follows first loading with the edge
                                    condition of Johnson, Kendall and Roberts superposed, exact up to yield, a model beyond it.
                                    Default 0 [modulus length]. */
    double tolerance;          /**< Relative tolerance of F and a, 1e-11 to 1e-2. Default 0: 1e-9. */
} mdr_plastic_law_options;

/** Create the law of a paraboloid on a half-space that yields. First loading is that of finite elements, with an error of 0.2 % of F
 *  and d, up to a E* / (R Y) = 250. Unloading and reloading are elastic.
 *  @param profile        a paraboloid; between two bodies that of their gap
 *  @param metal          material that yields
 *  @param largest_depth  > 0, at which a <= 0.3 R; from 0.1 R on F has an error of 2 % and more [length]
 *  @param options        NULL: default options
 *  @param out            receives the handle
 *  @return also MDR_EDOMAIN beyond these limits, and if adhesion alone yields the body
 *  @code
 *  const double strain = 0.0, Y = 1e9;
 *  mdr_yielding *steel = NULL;
 *  mdr_profile *ball = NULL;
 *  mdr_plastic_law *law = NULL;
 *  mdr_yielding_new(200e9, 0.3, 1, &strain, &Y, &steel);
 *  mdr_profile_paraboloid(1e-3, &ball);
 *  status = mdr_plastic_law_new(ball, steel, 10e-6, NULL, &law);
 *  MDR_FREE(law);
 *  MDR_FREE(ball);
 *  MDR_FREE(steel);
 *  @endcode
 */
int mdr_plastic_law_new(const mdr_profile *profile, const mdr_yielding *metal, double largest_depth,
                        const mdr_plastic_law_options *options, mdr_plastic_law **out);

/** Create the law of a measured or computed curve of first loading. Between the points cubics rise.
 *  @param n               number of points, at least 3
 *  @param d               [n] depths > 0, rising; up to the first one the contact is elastic [length]
 *  @param F               [n] forces > 0, rising [modulus length^2]
 *  @param a               [n] contact radii > 0, rising [length]
 *  @param residual_depth  [n] depths that remain after an elastic unloading from each point, 0 up to yield [length]
 *  @param modulus         [n] E* > 0 of the homogeneous half-space as which the contact unloads from each point: that of the body, of a
 *                         coated body k/(2 a) with its stiffness k at the beginning of unloading [modulus]
 *  @param options         NULL: default options; options.other must be NULL
 *  @param out             receives the handle
 *  @return also MDR_EDOMAIN for a residual depth that no imprint of two terms with this force and radius has
 *  @code
 *  const double d[3] = {1e-9, 4e-9, 9e-9}, F[3] = {1e-6, 6e-6, 15e-6}, a[3] = {3e-8, 7e-8, 11e-8};
 *  const double left[3] = {0.0, 1.3e-9, 4.5e-9}, modulus[3] = {20e9, 20e9, 20e9};
 *  mdr_plastic_law *measured = NULL;
 *  status = mdr_plastic_law_from_points(3, d, F, a, left, modulus, NULL, &measured);
 *  MDR_FREE(measured);
 *  @endcode
 */
int mdr_plastic_law_from_points(int n, const double d[], const double F[], const double a[], const double residual_depth[],
                                const double modulus[], const mdr_plastic_law_options *options, mdr_plastic_law **out);

/** Create the law of the same bodies under a paraboloid of another radius: d and a are proportional to R, F to R^2.
 *  @param law     law of a paraboloid without adhesion
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle
 *  @return also MDR_EINVALID for adhesive laws, which scale only at a work of adhesion proportional to R, and for laws of points
 *  @code
 *  mdr_plastic_law *larger = NULL;
 *  status = mdr_plastic_law_with_radius(plastic_law, 2e-3, &larger);
 *  MDR_FREE(larger);
 *  @endcode
 */
int mdr_plastic_law_with_radius(const mdr_plastic_law *law, double radius, mdr_plastic_law **out);

/** Properties of a plastic law. */
typedef struct mdr_plastic_law_facts {
    size_t size;             /**< Size of this structure; MDR_SIZED sets it. */
    double yield_depth;      /**< Depth of first yield; the range may end before it [length]. */
    double yield_force;      /**< Force there [modulus length^2]. */
    double first_yield;      /**< a E* / (R Y) there, of the body that yields; 0 in a law of points [1]. */
    double largest_depth;    /**< End of the range [length]. */
    double largest_force;    /**< Force of first loading there [modulus length^2]. */
    double largest_radius;   /**< Contact radius there [length]. */
    double radius;           /**< R of the paraboloid; 0 in a law of points [length]. */
    double modulus;          /**< E* of the contact [modulus]. */
    double work_of_adhesion; /**< 0 without adhesion [modulus length]. */
    double tolerance;        /**< The requested relative tolerance. */
    double error;            /**< Largest relative error of the polynomials found against the curve. */
    int memory_size;         /**< Numbers in the memory of a contact: 1, with adhesion 2. */
    int buffer_size;         /**< Number of values that mdr_plastic_law_buffer() writes. */
} mdr_plastic_law_facts;

/** Return the properties of a plastic law.
 *  @param law    law
 *  @param facts  initialize with MDR_SIZED; receives the properties
 *  @code
 *  mdr_plastic_law_facts plastic_facts = MDR_SIZED(mdr_plastic_law_facts);
 *  status = mdr_plastic_law_about(plastic_law, &plastic_facts);
 *  @endcode
 */
int mdr_plastic_law_about(const mdr_plastic_law *law, mdr_plastic_law_facts *facts);

/** Advance n contacts to new depths. A failed call advances none of them. Any number of threads may call it with different memories.
 *  @param law       law
 *  @param n         number of contacts
 *  @param d         [n] indentation depths at the end of the step, up to the largest one [length]
 *  @param is_trial  0: take the step; otherwise leave the memories unchanged
 *  @param memory    [memory_size n] the memories
 *  @param F         [n] or NULL: receives normal forces, positive in compression [modulus length^2]
 *  @param slope     [n] or NULL: receives the stiffnesses dF/dd along the path, which jump at the largest depth [modulus length]
 *  @param a         [n] or NULL: receives contact radii, 0 for separated bodies [length]
 *  @return also MDR_EDOMAIN beyond the largest depth, MDR_EINVALID for numbers that are not a memory
 *  @code
 *  const double depth = 5e-6;
 *  double memory[1] = {0}, F, slope;
 *  status = mdr_plastic_law_advance(plastic_law, 1, &depth, 0, memory, &F, &slope, NULL);
 *  @endcode
 */
int mdr_plastic_law_advance(const mdr_plastic_law *law, int n, const double d[], int is_trial, double memory[], double F[],
                            double slope[], double a[]);

/** Compute the energies of n contacts. Their sum is the work int F dd since the first step. The dissipated energy never falls.
 *  @param law         law
 *  @param n           number of contacts
 *  @param d           [n] indentation depths; a step to them is taken without a change of the memories [length]
 *  @param memory      [memory_size n] the memories
 *  @param stored      [n] receives what the contacts give back, with adhesion less the energy of their surfaces [modulus length^3]
 *  @param dissipated  [n] receives what plastic flow, and with adhesion jumps, have taken since the first step [modulus length^3]
 *  @return also MDR_EDOMAIN beyond the largest depth, MDR_EINVALID for numbers that are not a memory
 *  @code
 *  const double depth = 5e-6, memory[1] = {6e-6};
 *  double stored, dissipated;
 *  status = mdr_plastic_law_energies(plastic_law, 1, &depth, memory, &stored, &dissipated);
 *  @endcode
 */
int mdr_plastic_law_energies(const mdr_plastic_law *law, int n, const double d[], const double memory[], double stored[],
                             double dissipated[]);

/** Compute states of first loading.
 *  @param law       law
 *  @param n         number of states
 *  @param d         [n] indentation depths up to the largest one [length]
 *  @param F         [n] or NULL: receives forces [modulus length^2]
 *  @param a         [n] or NULL: receives contact radii [length]
 *  @param residual  [n] or NULL: receives the depths at which the contact opens on unloading without adhesion [length]
 *  @param work      [n] or NULL: receives the work int F dd [modulus length^3]
 *  @return also MDR_EDOMAIN beyond the largest depth
 *  @code
 *  const double depth = 5e-6;
 *  double F, residual;
 *  status = mdr_plastic_law_loading(plastic_law, 1, &depth, &F, NULL, &residual, NULL);
 *  @endcode
 */
int mdr_plastic_law_loading(const mdr_plastic_law *law, int n, const double d[], double F[], double a[], double residual[],
                            double work[]);

/** Compute coefficients of restitution of impacts without waves: what the contact gives back of the energy m V^2/2.
 *  @param law    law
 *  @param mass   reduced mass m > 0; m V^2 in the unit of energies
 *  @param n      number of speeds
 *  @param speed  [n] speeds V > 0 at initial contact
 *  @param e      [n] receives the coefficients of restitution; 0: the bodies stick [1]
 *  @return also MDR_EDOMAIN for an impact beyond the largest depth
 *  @code
 *  const double speed = 0.1;
 *  double e;
 *  status = mdr_plastic_law_restitution(plastic_law, 1e-6, 1, &speed, &e);
 *  @endcode
 */
int mdr_plastic_law_restitution(const mdr_plastic_law *law, double mass, int n, const double speed[], double e[]);

/** Write a plastic law as an array of numbers without addresses, which the inline functions of mdrcontact_plastic_law.h evaluate.
 *  @param law     law
 *  @param size    length of the array, at least buffer_size of mdr_plastic_law_facts
 *  @param buffer  [size] receives the numbers
 *  @return also MDR_EINVALID for a shorter array
 *  @code
 *  double numbers[20000];
 *  status = mdr_plastic_law_buffer(plastic_law, 20000, numbers);
 *  @endcode
 */
int mdr_plastic_law_buffer(const mdr_plastic_law *law, int size, double buffer[]);

/* ---- Coated bodies and other profiles: the overload rule ---- */

/** First loading of coated bodies, and of indenters between a cone and a paraboloid, by the overload rule. Immutable. Created by
 *  mdr_overload_new(). */
typedef struct mdr_overload mdr_overload;

/** Create the overload rule of an elastic contact, a model: with the mean pressure p of the elastic contact at the same radius, Lambda
 *  = (3 pi/4) p/Y determines force and depth as for a paraboloid on a half-space (theory/plastic.md (7.1)-(7.3)).
 *  @param c             contact without adhesion of a rigid indenter with a homogeneous or an exact medium
 *  @param n             number of materials: layers and half-space
 *  @param yield_stress  [n] of each material, top to bottom, > 0; of all but the first one also infinite [modulus]
 *  @param out           receives the handle
 *  @return also MDR_EINVALID for a Poisson's ratio of the surface outside [0, 0.49], and for indenters with a flat end
 *  @code
 *  const double yield_stress[2] = {1e9, 4e9};
 *  mdr_overload *rule = NULL;
 *  status = mdr_overload_new(contact, 2, yield_stress, &rule);
 *  MDR_FREE(rule);
 *  @endcode
 */
int mdr_overload_new(const mdr_contact *c, int n, const double yield_stress[], mdr_overload **out);

/** A state of first loading by the overload rule. */
typedef struct mdr_overload_state {
    double depth;       /**< d [length]. */
    double radius;      /**< a [length]. */
    double force;       /**< F [modulus length^2]. */
    double load;        /**< Lambda, the overload; yield begins at 2.04 to 2.93 [1]. */
    double uniform;     /**< Uniform part of the pressure, for mdr_imprint_two_terms() [modulus]. */
    double hertz;       /**< Hertz's part of the pressure [modulus]. */
    double force_error; /**< Relative error of F by comparison with finite elements; 0 before yield. */
    double depth_error; /**< Relative error of d by comparison with finite elements; 0 before yield. */
} mdr_overload_state;

/** Compute states of first loading.
 *  @param rule   overload rule
 *  @param given  MDR_RADIUS, MDR_DEPTH or MDR_FORCE
 *  @param n      number of states
 *  @param value  [n] > 0, in the unit of the given quantity
 *  @param out    [n] states
 *  @return also MDR_EDOMAIN for a > 2 thicknesses of the surface layer, where a material below it yields, Lambda > 250, a/R > 0.3 of
 *          a sphere, and where the mean elastic pressure falls; MDR_EINVALID for indenters blunter than a paraboloid or sharper than
 *          a cone; MDR_ENOCONVERGENCE
 *  @code
 *  const double depth[2] = {10e-9, 20e-9};
 *  mdr_overload_state states[2];
 *  status = mdr_overload_states(rule, MDR_DEPTH, 2, depth, states);
 *  @endcode
 */
int mdr_overload_states(const mdr_overload *rule, int given, int n, const double value[], mdr_overload_state out[]);

/** Create the law of a coated grain: elastic as the contact of the rule up to first yield, first loading by the rule, unloading as that
 *  of the half-space on which the imprint gives back the same work (theory/plastic.md (9.7)). In between the force has an error of up
 *  to 1.1 % of the largest one against the imprint on the body.
 *  @param rule           overload rule of a paraboloid, or of another indenter with an elastic range
 *  @param largest_depth  > 0, at which the body yields [length]
 *  @param options        NULL: default options; options.other must be NULL, and there is no adhesion on coated bodies
 *  @param out            receives the handle
 *  @return also MDR_EDOMAIN where the rule does not hold or nothing yields, as mdr_overload_states()
 *  @code
 *  const double yield_stress[2] = {1e9, 4e9};
 *  mdr_overload *soft_film = NULL;
 *  mdr_plastic_law *grain = NULL;
 *  status = mdr_overload_new(contact, 2, yield_stress, &soft_film);
 *  status = mdr_plastic_law_from_overload(soft_film, 50e-9, NULL, &grain);
 *  MDR_FREE(grain);
 *  MDR_FREE(soft_film);
 *  @endcode
 */
int mdr_plastic_law_from_overload(const mdr_overload *rule, double largest_depth, const mdr_plastic_law_options *options,
                                  mdr_plastic_law **out);

/* ---- Pressure caps ---- */

/** A contact whose pressure is at most a hardness. Immutable. Created by mdr_cap_new(). */
typedef struct mdr_cap mdr_cap;

/** Create a contact with 0 <= p <= H (theory/plastic.md (6.1)). With a hardness measured at that depth force and radius have an
 *  error of 3 % up to a E/(R Y) = 32; a constant multiple of the yield stress is less accurate.
 *  @param c         contact without adhesion, with a homogeneous or an exact medium
 *  @param hardness  H > 0 [modulus]
 *  @param out       receives the handle
 *  @return also MDR_EINVALID for flat punches
 *  @code
 *  mdr_cap *cap = NULL;
 *  status = mdr_cap_new(contact, 5e9, &cap);
 *  MDR_FREE(cap);
 *  @endcode
 */
int mdr_cap_new(const mdr_contact *c, double hardness, mdr_cap **out);

/** A state under a pressure cap. */
typedef struct mdr_cap_state {
    double depth;          /**< d [length]. */
    double radius;         /**< a [length]. */
    double force;          /**< F [modulus length^2]. */
    double capped_radius;  /**< Outermost radius at which p = H; 0: none [length]. */
    double residual_depth; /**< Residual displacement on the axis, the depth at which unloading ends the contact [length]. */
    double recovered_work; /**< Work that unloading gives back [modulus length^3]. */
    double error;          /**< Relative error of F and d of the numerical solution, from two resolutions. */
} mdr_cap_state;

/** Compute states of first loading.
 *  @param cap    pressure cap
 *  @param given  MDR_RADIUS, MDR_DEPTH or MDR_FORCE
 *  @param n      number of states
 *  @param value  [n] > 0, in the unit of the given quantity
 *  @param out    [n] states
 *  @return also MDR_EDOMAIN for a force or depth beyond what the hardness supports up to the end of the indenter, and for contacts
 *          that are not a single disc; MDR_ENOCONVERGENCE
 *  @code
 *  const double force = 1e-3;
 *  mdr_cap_state state;
 *  status = mdr_cap_states(cap, MDR_FORCE, 1, &force, &state);
 *  @endcode
 */
int mdr_cap_states(const mdr_cap *cap, int given, int n, const double value[], mdr_cap_state out[]);

/** Compute pressure and residual displacement of a state.
 *  @param cap       pressure cap
 *  @param radius    a > 0 of the state [length]
 *  @param n         number of places
 *  @param r         [n] >= 0 [length]
 *  @param pressure  [n] p, 0 from a on, or NULL [modulus]
 *  @param residual  [n] u_p, 0 where p < H, or NULL [length]
 *  @return also MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double r[2] = {0.0, 0.5e-6};
 *  double pressure[2], residual[2];
 *  status = mdr_cap_pressure(cap, 1e-6, 2, r, pressure, residual);
 *  @endcode
 */
int mdr_cap_pressure(const mdr_cap *cap, double radius, int n, const double r[], double pressure[], double residual[]);

/** Compute the line load of Hertz's pressure cut at a hardness, min(p0 sqrt(1 - r^2/a^2), H): the model of Thornton (1997), in closed
 *  form (theory/plastic.md (6.5)).
 *  @param a         contact radius > 0 [length]
 *  @param largest   p0 > 0 [modulus]
 *  @param hardness  H > 0 [modulus]
 *  @param n         number of places
 *  @param x         [n] 0 <= x <= a [length]
 *  @param out       [n] line loads [modulus length]
 *  @code
 *  const double x[2] = {0.0, 0.5e-6};
 *  double q[2];
 *  status = mdr_truncated_hertz(1e-6, 5e9, 3e9, 2, x, q);
 *  @endcode
 */
int mdr_truncated_hertz(double a, double largest, double hardness, int n, const double x[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
