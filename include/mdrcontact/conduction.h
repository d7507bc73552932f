/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file conduction.h
 * Conduction of heat or current through a circular spot, heat of friction. Option MDRCONTACT_CONDUCTION.
 * @since 0.1
 */
#ifndef MDRCONTACT_CONDUCTION_H
#define MDRCONTACT_CONDUCTION_H

#include "law.h"

#ifdef __cplusplus
extern "C" {
#endif

/** One or two conductors that touch at a spot. Made by mdr_conduction_new(). */
typedef struct mdr_conduction mdr_conduction;

/** A layer that conducts, and the interface below it. Electrical: conductivities in S/m, potential in V, flux in A; thermal: W/(m K),
 *  K, W. */
typedef struct mdr_conductor {
    double thickness;  /**< h > 0 [length]; not used of a half-space. */
    double sigma;      /**< Conductivity > 0 into the body [conductance/length]. */
    double along;      /**< Conductivity > 0 along the surface [conductance/length]. */
    double capacity;   /**< Heat capacity >= 0 per volume; 0: the layer follows at once. */
    double resistance; /**< Area resistance >= 0 between it and what lies below (Kapitza, oxide) [length^2/conductance]. */
} mdr_conductor;

/** What layers lie on. */
enum mdr_conduction_base {
    MDR_BASE_HALF_SPACE = 1801, /**< The last layer is a half-space. */
    MDR_BASE_PERFECT = 1802,    /**< A perfect conductor at potential 0. */
    MDR_BASE_INSULATING = 1803  /**< No flux: steady states need a sink. */
};

/** One or two bodies whose surfaces meet at a circular spot; beside it no flux passes. Potentials count from those far away.
 *  @param n           number of layers of the lower body, at least 1
 *  @param lower       [n] from the surface down
 *  @param lower_base  one of enum mdr_conduction_base
 *  @param m           number of layers of the upper body; 0: the spot of the lower one is held at a potential
 *  @param upper       [m] from the surface away
 *  @param upper_base  one of enum mdr_conduction_base; not used if m = 0
 *  @param film        area resistance >= 0 in the spot itself [length^2/conductance]
 *  @param sink        radius of the circle at which the flux leaves a body on an insulating base, potential 0 there; more than 8.5
 *                     thicknesses of that body beyond every spot (exact but for exp(-pi distance/thickness)); 0: none, and such a
 *                     body answers in time alone; other bodies have none [length]
 *  @param out         receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base,
                       double film, double sink, mdr_conduction **out);

/** The steady conductance G = flux/potential of an equipotential spot, and its slope dG/da: 4 S a of a half-space,
 *  S = sqrt(sigma along). Relative errors below 1e-11, with a film below 1e-10.
 *  @param p            conduction
 *  @param n            number of radii
 *  @param radius       [n] a > 0, up to 1e4 thicknesses of the layers [length]
 *  @param conductance  [n] G; NULL: not wanted [conductance]
 *  @param slope        [n] dG/da; NULL: not wanted [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[]);

/** The same conduction with a table of its conductance between two radii, made once and compared with the solution between its nodes:
 *  mdr_conduction_spot() and mdr_conduction_along() read it there, some hundred nanoseconds a radius, for codes that integrate motion.
 *  @param p          conduction
 *  @param smallest   radius > 0 [length]
 *  @param largest    > smallest [length]
 *  @param tolerance  relative, of G, 1e-10 to 1e-2
 *  @param out        receives the handle
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance, mdr_conduction **out);

/** Fields of the spot at potential difference 1.
 *  @param p       conduction; fields inside are not offered on an insulating base
 *  @param field   MDR_FLUX, MDR_FLUX_Z, MDR_FLUX_R or MDR_POTENTIAL
 *  @param radius  a > 0 [length]
 *  @param body    one of enum mdr_which_body; not used by MDR_FLUX
 *  @param below   at an interface with a resistance: 1 the side below it, 0 the side above; z is at one to the rounding of a sum of
 *                 thicknesses
 *  @param time    0: steady; else of MDR_FLUX without a film: after a step of the potential, D t/a^2 >= 1e-4 with
 *                 D = along/capacity of the surface [time]
 *  @param n       number of points
 *  @param r       [n] >= 0 [length]
 *  @param z       [n] >= 0, depth below the body's own surface; may be NULL for MDR_FLUX [length]
 *  @param out     [n] potential [1], or flux density [conductance/length^2]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, double time, int n,
                         const double r[], const double z[], double out[]);

/** C(k), what the surfaces answer to a wave of flux: potential over flux at wavenumber k, 1/(sqrt(sigma along) k) of a half-space at
 *  rest; of two bodies the sum of both, without the film in the spot. See mdr_body_compliance().
 *  @param p          conduction
 *  @param omega      angular frequency >= 0, 0: steady [1/time]
 *  @param n          number of wavenumbers
 *  @param k          [n] > 0 [1/length]
 *  @param out        [n] real parts [length/conductance]
 *  @param imaginary  [n] or NULL: imaginary parts, <= 0
 *  @return also MDR_EINVALID */
int mdr_conduction_compliance(const mdr_conduction *p, double omega, int n, const double k[], double out[], double imaginary[]);

/** Answers to exp(i omega t): complex, ahead of its cause or behind it.
 *  @param p         conduction
 *  @param answer    MDR_CONDUCTANCE, MDR_RESISTANCE, MDR_MEAN_POTENTIAL, MDR_CENTRE_POTENTIAL or MDR_GAUSSIAN_POTENTIAL
 *  @param radius    a > 0 [length]
 *  @param n         number of frequencies
 *  @param omega     [n] angular frequencies >= 0, omega a^2/D <= 1e5 with D = along/capacity of the surface; 0: steady [1/time]
 *  @param in_phase  [n] real part
 *  @param ahead     [n] imaginary part
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[],
                              double ahead[]);

/** Answers in time: to a step at time 0, or to any history that goes evenly from one value to the next; of potential for
 *  MDR_CONDUCTANCE, else of flux.
 *  @param p       conduction
 *  @param answer  as for mdr_conduction_admittance()
 *  @param radius  as for mdr_conduction_admittance()
 *  @param n       number of times
 *  @param time    [n] > 0, D t/a^2 >= 1e-4 with D = along/capacity of the surface; of a history ascending, and apart by that [time]
 *  @param given   [n] the history, whose first value is 0; NULL: a step to 1
 *  @param out     [n] flux or potential, see enum mdr_quantity
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[], const double given[],
                          double out[]);

/** The steady conductance of a state of contact between rough surfaces, whose area conductance goes with the pressure: a film of
 *  area resistance kappa/p(r) in the spot, by the pressure of the state. Right to 1e-9 under smooth indenters, else to 1e-6.
 *  @param p      conduction; its own film is left out
 *  @param c      contact
 *  @param state  of that contact, a > 0, whose pressure is nowhere a tension, and which carries no line force on its edge, as under
 *                a plate
 *  @param kappa  > 0, as small as it may be: area resistance times pressure [modulus length^2/conductance]
 *  @param out    receives the conductance
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa, double *out);

/** The conductance along the loading of a contact: G(a) of each state, and how it grows with the force and the depth there,
 *  dG/dF = G'(a)/F'(a), dG/dd = G'(a)/d'(a): 0 at a vertical wall.
 *  @param p            conduction
 *  @param c            contact, of bodies of the same layers or not
 *  @param n            number of states
 *  @param states       [n] of that contact, a > 0
 *  @param conductance  [n] G; NULL: not wanted [conductance]
 *  @param by_force     [n] dG/dF; NULL: not wanted [conductance/force]
 *  @param by_depth     [n] dG/dd; NULL: not wanted [conductance/length]
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[],
                         double by_force[], double by_depth[]);

/** How the heat of friction is made. */
enum mdr_heat_motion {
    MDR_HEAT_SLIDING = 1901,  /**< q = mu v p(r), the source resting on both bodies: fretting, or low speeds. */
    MDR_HEAT_SPINNING = 1902, /**< q = mu omega r p(r) of a twist about the axis: exact at any speed. */
    MDR_HEAT_MOVING = 1903    /**< q = mu v p(r), the source moving over the lower body, v a c/sigma <= 1000, and resting on the
                                   upper one. Of two bodies the share is that of equal flux_mean, an approximation. */
};

/** The heat of friction of a state, and temperature rises of the contact over those far away. */
typedef struct mdr_friction_heat {
    double total;     /**< Q = mu v F, or mu omega times the moment of p. */
    double share;     /**< Part of it that the lower body takes: 1 without an upper one. */
    double centre;    /**< Temperature rise at r = 0, for MDR_HEAT_MOVING that of the lower body, as all below. */
    double flux_mean; /**< Its mean weighted with the heat. */
    double area_mean; /**< Its mean over the contact; 0 for MDR_HEAT_MOVING. */
    double largest;   /**< For MDR_HEAT_MOVING the largest rise on the line of motion through the centre; else 0. */
    double behind;    /**< How far behind the centre it is; else 0 [length]. */
} mdr_friction_heat;

/** The heat of friction of states and its temperatures. Two bodies share it so that their temperatures are the same all over the
 *  contact; a film in the spot is not offered then. Refused with adhesion and where the pressure is a tension, which would cool, and
 *  where the edge carries a line force, as under a plate.
 *  @param p         conduction of heat
 *  @param c         contact
 *  @param n         number of states
 *  @param states    [n] of that contact, a > 0
 *  @param motion    one of enum mdr_heat_motion
 *  @param strength  mu v >= 0, heat per normal force; mu omega of MDR_HEAT_SPINNING
 *  @param speed     v > 0 of the source over the lower body, of MDR_HEAT_MOVING alone [length/time]
 *  @param out       [n] results: means as exact as the states, the centre to 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion,
                        double strength, double speed, mdr_friction_heat out[]);

/** The temperature rise that the heat of friction makes at points of a body.
 *  @param p         conduction of heat
 *  @param c         contact
 *  @param state     of that contact, a > 0
 *  @param motion    MDR_HEAT_SLIDING or MDR_HEAT_SPINNING
 *  @param strength  as for mdr_conduction_heat()
 *  @param body      one of enum mdr_which_body
 *  @param below     at an interface with a resistance: 1 the side below it, 0 the side above
 *  @param n         number of points
 *  @param r         [n] >= 0 [length]
 *  @param z         [n] >= 0, depth below the body's own surface [length]
 *  @param out       [n] temperature rise. At the surface near kinks of the indenter within 2e-3 of the largest, else 1e-8
 *  @return also MDR_EINVALID, MDR_EDOMAIN, MDR_ENOCONVERGENCE */
int mdr_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion, double strength,
                              int body, int below, int n, const double r[], const double z[], double out[]);

/** Conductances G of a law that was made with a conduction, and dG/dd along the branch. Outputs that are NULL are skipped. Beyond
 *  the largest depth of a law that goes on there G is that at its end, as a and k are.
 *  @param law          law with options.conduction
 *  @param branch       one of enum mdr_branch
 *  @param n            number of states
 *  @param d            [n] depths up to the largest one; G is 0 where the bodies are apart [length]
 *  @param conductance  [n] or NULL: G [conductance]
 *  @param slope        [n] or NULL: dG/dd [conductance/length]
 *  @return also MDR_EDOMAIN beyond the largest depth, MDR_EINVALID for other laws */
int mdr_law_conductance(const mdr_law *law, int branch, int n, const double d[], double conductance[], double slope[]);

#ifdef __cplusplus
}
#endif

#endif
