/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file conduction.h
 * Conduction of heat or current through a circular contact area, and frictional heat. Option MDRCONTACT_CONDUCTION.
 * @since 0.1
 */
#ifndef MDRCONTACT_CONDUCTION_H
#define MDRCONTACT_CONDUCTION_H

#include "law.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One or two conductors with a circular contact area. Created by mdr_conduction_new(). Immutable. */
typedef struct mdr_conduction mdr_conduction;

/** A conducting layer, and the interface below it. Electrical: conductivities in S/m, potential in V, flux in A. Thermal: W/(m K),
 *  K, W. */
typedef struct mdr_conductor {
    double thickness;  /**< h > 0; ignored in a half-space [length]. */
    double sigma;      /**< Conductivity > 0 into the body [conductance/length]. */
    double along;      /**< Conductivity > 0 along the surface [conductance/length]. */
    double capacity;   /**< Heat capacity >= 0 per volume; 0: the layer responds instantaneously. */
    double resistance; /**< Area resistance >= 0 of the interface below (Kapitza, oxide) [length^2/conductance]. */
} mdr_conductor;

/** Base of the layers. */
enum mdr_conduction_base {
    MDR_BASE_HALF_SPACE = 1801, /**< The last layer is a half-space. */
    MDR_BASE_PERFECT = 1802,    /**< A perfect conductor at potential 0. */
    MDR_BASE_INSULATING = 1803  /**< No flux: steady states need a sink. */
};

/** Create one or two bodies whose surfaces meet in a circular contact area. No flux passes outside it. Potentials are relative to
 *  those far away.
 *  @param n           number of layers of the lower body, at least 1
 *  @param lower       [n] top to bottom
 *  @param lower_base  one of enum mdr_conduction_base
 *  @param m           number of layers of the upper body; 0: a potential is applied to the contact area of the lower body
 *  @param upper       [m] from the surface upwards
 *  @param upper_base  one of enum mdr_conduction_base; ignored if m = 0
 *  @param film        area resistance >= 0 of the contact area itself [length^2/conductance]
 *  @param sink        for a body on an insulating base: radius of the circle at which the flux leaves it, at potential 0. At least
 *                     8.5 thicknesses of that body beyond the largest contact radius (error exp(-pi distance/thickness)). 0: none;
 *                     such a body then has transient responses only, other bodies need none [length]
 *  @param out         receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const mdr_conductor metal = {0.0, 4e7, 4e7, 0.0, 0.0};
 *  mdr_conduction *joint = NULL;
 *  status = mdr_conduction_new(1, &metal, MDR_BASE_HALF_SPACE, 1, &metal, MDR_BASE_HALF_SPACE, 0.0, 0.0, &joint);
 *  MDR_FREE(joint);
 *  @endcode
 */
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base,
                       double film, double sink, mdr_conduction **out);

/** Compute the steady conductance G = flux/potential of an equipotential contact area, and its slope dG/da. G = 4 S a on a
 *  half-space, S = sqrt(sigma along). The relative error is below 1e-11, with a film below 1e-10.
 *  @param p            conduction
 *  @param n            number of radii
 *  @param radius       [n] a > 0, up to 1e4 thicknesses of the layers [length]
 *  @param conductance  [n] G, or NULL [conductance]
 *  @param slope        [n] dG/da, or NULL [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double a[2] = {1e-7, 1e-6};
 *  double G[2];
 *  status = mdr_conduction_spot(conduction, 2, a, G, NULL);
 *  @endcode
 */
int mdr_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[]);

/** Create a copy of a conduction with a table of its conductance between two radii, checked against the solution between its nodes.
 *  mdr_conduction_spot() and mdr_conduction_along() then read the table in a few hundred nanoseconds per radius, for codes that
 *  integrate motion.
 *  @param p          conduction
 *  @param smallest   radius > 0 [length]
 *  @param largest    > smallest [length]
 *  @param tolerance  relative tolerance of G, 1e-10 to 1e-2
 *  @param out        receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_conduction *fast = NULL;
 *  status = mdr_conduction_tabulate(conduction, 1e-8, 1e-6, 1e-6, &fast);
 *  MDR_FREE(fast);
 *  @endcode
 */
int mdr_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance, mdr_conduction **out);

/** Compute a field at a potential difference of 1.
 *  @param p       conduction; fields inside a body on an insulating base are not available
 *  @param field   MDR_FLUX, MDR_FLUX_Z, MDR_FLUX_R or MDR_POTENTIAL
 *  @param radius  a > 0 [length]
 *  @param body    one of enum mdr_which_body; ignored for MDR_FLUX
 *  @param below   at an interface with a resistance: 1: the side below it, 0: the side above. z is at an interface if it equals a
 *                 sum of thicknesses to machine precision
 *  @param time    0: steady. Otherwise, for MDR_FLUX without a film, time after a step of the potential, D t/a^2 >= 1e-4 with D =
 *                 along/capacity of the surface [time]
 *  @param n       number of points
 *  @param r       [n] >= 0 [length]
 *  @param z       [n] >= 0, depth below the surface of the body; may be NULL for MDR_FLUX [length]
 *  @param out     [n] potential [1], or flux density [conductance/length^2]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double r[2] = {0.0, 0.5e-6};
 *  double flux[2];
 *  status = mdr_conduction_field(conduction, MDR_FLUX, 1e-6, MDR_BODY_LOWER, 0, 0.0, 2, r, NULL, flux);
 *  @endcode
 */
int mdr_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, double time, int n,
                         const double r[], const double z[], double out[]);

/** Compute C(k), the potential of the surface per flux of a wave with wavenumber k: 1/(sqrt(sigma along) k) of a half-space in the
 *  steady state; of two bodies the sum, without the film. Compare mdr_body_compliance().
 *  @param p          conduction
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0 [1/length]
 *  @param omega      [n] angular frequencies, 0: steady, or NULL: all 0; C(-omega) is the complex conjugate of C(omega) [1/time]
 *  @param out        [n] real parts [length/conductance]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0 for omega > 0
 *  @return also MDR_EINVALID
 *  @code
 *  const double k[2] = {1e5, 1e7};
 *  double C[2];
 *  status = mdr_conduction_compliance(conduction, 2, k, NULL, C, NULL);
 *  @endcode
 */
int mdr_conduction_compliance(const mdr_conduction *p, int n, const double k[], const double omega[], double out[],
                              double imaginary[]);

/** Compute the complex response to exp(i omega t).
 *  @param p         conduction
 *  @param answer    MDR_CONDUCTANCE, MDR_RESISTANCE, MDR_MEAN_POTENTIAL, MDR_CENTRE_POTENTIAL or MDR_GAUSSIAN_POTENTIAL
 *  @param radius    a > 0 [length]
 *  @param n         number of frequencies
 *  @param omega     [n] angular frequencies >= 0, omega a^2/D <= 1e5 with D = along/capacity of the surface; 0: steady [1/time]
 *  @param in_phase  [n] real part
 *  @param ahead     [n] imaginary part, > 0 if the response leads
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double omega = 1e5;
 *  double real, imaginary;
 *  status = mdr_conduction_admittance(conduction, MDR_MEAN_POTENTIAL, 1e-6, 1, &omega, &real, &imaginary);
 *  @endcode
 */
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[],
                              double ahead[]);

/** Compute the response in time to a step at time 0, or to a piecewise linear history; of the potential for MDR_CONDUCTANCE,
 *  otherwise of the flux.
 *  @param p       conduction
 *  @param answer  as for mdr_conduction_admittance()
 *  @param radius  as for mdr_conduction_admittance()
 *  @param n       number of times
 *  @param time    [n] > 0, D t/a^2 >= 1e-4 with D = along/capacity of the surface; of a history ascending, with at least this
 *                 distance [time]
 *  @param given   [n] the history, which begins at 0; NULL: a step to 1
 *  @param out     [n] flux or potential, see enum mdr_quantity
 *  @return also MDR_EINVALID, MDR_ENOCONVERGENCE; MDR_EDOMAIN, also for a conductance or a resistance if the surface layer is
 *          thinner than about radius/1500
 *  @code
 *  const double t[2] = {1e-6, 1e-3};
 *  double mean[2];
 *  status = mdr_conduction_follow(conduction, MDR_MEAN_POTENTIAL, 1e-6, 2, t, NULL, mean);
 *  @endcode
 */
int mdr_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[], const double given[],
                          double out[]);

/** Compute the steady conductance of a contact between rough surfaces, whose area conductance is proportional to the pressure: a
 *  film of area resistance kappa/p(r). The relative error is 1e-9 under smooth indenters, otherwise 1e-6.
 *  @param p      conduction; its own film is ignored
 *  @param c      contact
 *  @param state  a state of that contact, a > 0, without tensile pressure and without a line force on its edge, as under a plate
 *  @param kappa  > 0, arbitrarily small: area resistance times pressure [modulus length^2/conductance]
 *  @param out    receives the conductance
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  double G;
 *  status = mdr_conduction_rough(conduction, contact, &state, 1e-3, &G);
 *  @endcode
 */
int mdr_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa, double *out);

/** Compute the area resistance of rough surfaces whose asperities are plastic, 1/R_c = 1.25 k_s (m/sigma) (p/H)^0.95 + k_g/(Y + M):
 *  micro-contacts by Cooper, Mikic and Yovanovich (1969), and a gas between the mean planes, whose separation Y fulfils
 *  erfc(Y/(sqrt(2) sigma)) = 2 p/H (Yovanovich 2005). k_s is the harmonic mean of the conductivities of both surfaces; below a
 *  single body, whose partner conducts perfectly, it is twice that of the surface. Measured for p/H from 1e-6 to 0.023.
 *  @param p          conduction
 *  @param roughness  sigma > 0, root mean square of the heights of both surfaces together [length]
 *  @param slope      m > 0, mean absolute slope of both surfaces together [1]
 *  @param hardness   H > 0 of the softer surface [modulus]
 *  @param gas        conductivity k_g >= 0 of the gas; 0: vacuum [conductance/length]
 *  @param jump       M >= 0, sum of the temperature jump lengths of both surfaces; 0 in a vacuum [length]
 *  @param n          number of pressures
 *  @param pressure   [n] > 0, less than half of H [modulus]
 *  @param out        [n] R_c [length^2/conductance]
 *  @return also MDR_EINVALID, MDR_EDOMAIN
 *  @code
 *  const double pressure[2] = {1e6, 1e7};
 *  double R[2];
 *  status = mdr_conduction_joint_resistance(conduction, 1e-6, 0.1, 2e9, 0.026, 4e-7, 2, pressure, R);
 *  @endcode
 */
int mdr_conduction_joint_resistance(const mdr_conduction *p, double roughness, double slope, double hardness, double gas,
                                    double jump, int n, const double pressure[], double out[]);

/** Compute the steady conductance of a contact between rough surfaces whose asperities are plastic: a film of the area resistance
 *  of mdr_conduction_joint_resistance() under the pressure of the state. The relative error of the solution is below 1e-6, and about
 *  1e-9 under smooth indenters.
 *  @param p          conduction; its own film is ignored
 *  @param c          contact
 *  @param state      as for mdr_conduction_rough(); its pressure is less than half of the hardness everywhere
 *  @param roughness  as for mdr_conduction_joint_resistance()
 *  @param slope      as for mdr_conduction_joint_resistance()
 *  @param hardness   as for mdr_conduction_joint_resistance()
 *  @param gas        as for mdr_conduction_joint_resistance(); the gas outside the contact area is left out
 *  @param jump       as for mdr_conduction_joint_resistance()
 *  @param out        receives the conductance
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  double G;
 *  status = mdr_conduction_joint(conduction, contact, &state, 1e-6, 0.1, 20e9, 0.026, 4e-7, &G);
 *  @endcode
 */
int mdr_conduction_joint(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double roughness, double slope,
                         double hardness, double gas, double jump, double *out);

/** Compute the conductance of states of a contact, G(a), and its derivatives along the loading curve, dG/dF = G'(a)/F'(a) and dG/dd
 *  = G'(a)/d'(a): 0 at a vertical wall.
 *  @param p            conduction
 *  @param c            contact, whose layers may differ from those of the conduction
 *  @param n            number of states
 *  @param states       [n] of that contact, a > 0
 *  @param conductance  [n] G, or NULL [conductance]
 *  @param by_force     [n] dG/dF, or NULL [conductance/force]
 *  @param by_depth     [n] dG/dd, or NULL [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  double G, by_force;
 *  status = mdr_conduction_along(conduction, contact, 1, &state, &G, &by_force, NULL);
 *  @endcode
 */
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[],
                         double by_force[], double by_depth[]);

/** Source of the frictional heat. */
enum mdr_heat_motion {
    MDR_HEAT_SLIDING = 1901,  /**< q = mu v p(r), at rest relative to both bodies: fretting, or low speeds. */
    MDR_HEAT_SPINNING = 1902, /**< q = mu omega r p(r) of a rotation about the axis: exact at any speed. */
    MDR_HEAT_MOVING = 1903    /**< q = mu v p(r), moving over the lower body with v a c/sigma <= 1000 and at rest relative to the
                                   upper one. Two bodies share the heat so that flux_mean is equal, an approximation. */
};

/** Frictional heat of a state, and temperature rises of the contact relative to the far field. */
typedef struct mdr_friction_heat {
    double total;     /**< Q = mu v F, or mu omega times the moment of p. */
    double share;     /**< Share of the lower body: 1 without an upper one. */
    double centre;    /**< Temperature rise at r = 0; for MDR_HEAT_MOVING this and the following rises are those of the lower
                           body. */
    double flux_mean; /**< Mean temperature rise weighted with the heat. */
    double area_mean; /**< Mean temperature rise over the contact; 0 for MDR_HEAT_MOVING. */
    double largest;   /**< For MDR_HEAT_MOVING the largest rise on the line of motion through the centre; otherwise 0. */
    double behind;    /**< For MDR_HEAT_MOVING its distance behind the centre; otherwise 0 [length]. */
} mdr_friction_heat;

/** Compute the frictional heat of states and its temperatures. Two bodies share it so that their temperatures are equal everywhere
 *  in the contact; a film is then not supported. Not supported: adhesion; tensile pressures, which would cool; and a line force on
 *  the edge, as under a plate.
 *  @param p         thermal conduction
 *  @param c         contact
 *  @param n         number of states
 *  @param states    [n] of that contact, a > 0
 *  @param motion    one of enum mdr_heat_motion
 *  @param strength  mu v >= 0, heat per normal force; mu omega for MDR_HEAT_SPINNING
 *  @param speed     v > 0 of the source over the lower body, only for MDR_HEAT_MOVING [length/time]
 *  @param out       [n] results. Means have the accuracy of the states, the centre 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  mdr_friction_heat heat;
 *  status = mdr_conduction_heat(conduction, contact, 1, &state, MDR_HEAT_SLIDING, 0.1, 0.0, &heat);
 *  @endcode
 */
int mdr_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion,
                        double strength, double speed, mdr_friction_heat out[]);

/** Compute the temperature rise due to frictional heat at points of a body.
 *  @param p         thermal conduction
 *  @param c         contact
 *  @param state     of that contact, a > 0
 *  @param motion    MDR_HEAT_SLIDING or MDR_HEAT_SPINNING
 *  @param strength  as for mdr_conduction_heat()
 *  @param body      one of enum mdr_which_body
 *  @param below     at an interface with a resistance: 1: the side below it, 0: the side above
 *  @param n         number of points
 *  @param r         [n] >= 0 [length]
 *  @param z         [n] >= 0, depth below the surface of the body [length]
 *  @param out       [n] temperature rise. The relative error is 2e-3 at the surface near kinks of the indenter, otherwise 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE
 *  @code
 *  const double r = 0.0, z = 0.5e-6;
 *  double rise;
 *  status = mdr_conduction_heat_field(conduction, contact, &state, MDR_HEAT_SLIDING, 0.1, MDR_BODY_LOWER, 0, 1, &r, &z, &rise);
 *  @endcode
 */
int mdr_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion, double strength,
                              int body, int below, int n, const double r[], const double z[], double out[]);

/** Compute conductances G of a law that was made with a conduction, and dG/dd along the branch. Outputs that are NULL are skipped.
 *  Beyond the largest depth of a law that continues, G, a and k keep their last values.
 *  @param law          law with options.conduction
 *  @param branch       one of enum mdr_branch
 *  @param n            number of states
 *  @param d            [n] depths up to the largest one; G is 0 for separated bodies [length]
 *  @param conductance  [n] or NULL: G [conductance]
 *  @param slope        [n] or NULL: dG/dd [conductance/length]
 *  @return also MDR_EDOMAIN beyond the largest depth, MDR_EINVALID for other laws
 *  @code
 *  const double d = 40e-9;
 *  double G, slope;
 *  status = mdr_law_conductance(conducting_law, MDR_ON_UNLOADING, 1, &d, &G, &slope);
 *  @endcode
 */
int mdr_law_conductance(const mdr_law *law, int branch, int n, const double d[], double conductance[], double slope[]);

#ifdef __cplusplus
}
#endif

#endif
