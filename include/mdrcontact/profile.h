/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file profile.h
 * Indenters: f(r) with f(0) = 0, and the one-dimensional profile g(x), equations (3) and (4).
 * @since 0.1
 */
#ifndef MDRCONTACT_PROFILE_H
#define MDRCONTACT_PROFILE_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An indenter. Created by mdr_profile_.... Immutable. */
typedef struct mdr_profile mdr_profile;

/** Create a paraboloid, f = r^2/(2R), g = x^2/R. It approximates a sphere if a is small compared with R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_paraboloid(10e-6, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_paraboloid(double radius, mdr_profile **out);

/** Create a sphere, f = R - sqrt(R^2 - r^2), g = (x/2) ln((R + x)/(R - x)). It is defined for r <= R; contacts reach a < R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_sphere(10e-6, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_sphere(double radius, mdr_profile **out);

/** Create a cone, f = r tan(phi), g = (pi/2) x tan(phi). The equivalent half-angle of a Berkovich or Vickers tip is 70.30 degrees,
 *  that of a cube corner 42.28 degrees.
 *  @param inclination  phi, angle between the face and the surface, pi/2 minus the half-angle, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle
 *  @code
 *  mdr_profile *berkovich = NULL;
 *  status = mdr_profile_cone((90.0 - 70.3) * 3.14159265358979 / 180.0, &berkovich);
 *  MDR_FREE(berkovich);
 *  @endcode
 */
int mdr_profile_cone(double inclination, mdr_profile **out);

/** Create a power-law indenter, f = c r^n, g = kappa_n c x^n with kappa_n = (sqrt(pi)/2) n Gamma(n/2)/Gamma((n+1)/2).
 *  @param exponent     n, 0 < n <= 100 [1]
 *  @param coefficient  c > 0 [length^(1-n)]
 *  @param out          receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_power(1.5, 20.0, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out);

/** Create a flat cylindrical punch: f = g = 0 up to its radius, where it ends in a vertical wall. The contact radius is that radius
 *  at every depth. Compute its states from depth or force.
 *  @param radius  b > 0 [length]
 *  @param out     receives the handle
 *  @code
 *  mdr_profile *punch = NULL;
 *  status = mdr_profile_flat_punch(5e-6, &punch);
 *  MDR_FREE(punch);
 *  @endcode
 */
int mdr_profile_flat_punch(double radius, mdr_profile **out);

/** Create a cone with a flat end: f = (r - b) tan(phi), g = x tan(phi) arccos(b/x) for r, x > b, 0 below.
 *  @param end_radius   b > 0 [length]
 *  @param inclination  phi, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_flat_cone(0.5e-6, 0.35, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);

/** Create a paraboloid with a flat end: f = (r^2 - b^2)/(2R), g = (x/R) sqrt(x^2 - b^2) for r, x > b, 0 below.
 *  @param end_radius  b > 0 [length]
 *  @param radius      R > 0, radius of curvature of the paraboloid at its apex [length]
 *  @param out         receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_flat_paraboloid(0.5e-6, 10e-6, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);

/** Create a cone with a rounded tip: a paraboloid f = r^2 tan(phi)/(2b) for r <= b, and the cone f = (r - b/2) tan(phi) beyond. The
 *  slope is continuous.
 *  @param blend_radius  b > 0; the radius of curvature of the tip is b/tan(phi) [length]
 *  @param inclination   phi, 0 < phi < pi/2 [radian]
 *  @param out           receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_rounded_cone(50e-9, 0.34, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);

/** Create a calibrated nanoindenter tip from its area function A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., A = pi r^2
 *  (Oliver, Pharr, J. Mater. Res. 7 (1992) 1564). A must increase from min_height (0: none) to max_height.
 *  @param n             number of coefficients, at least 1
 *  @param coefficients  [n] C0 [1], C1 [length], C2 [length^(3/2)], C3 [length^(7/4)], ...
 *  @param min_height    f below which the fitted A is not reliable; there the tip is a paraboloid that meets A at this height. 0:
 *                       none [length]
 *  @param max_height    f up to which the tip is used, > min_height [length]
 *  @param out           receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  const double C[2] = {24.5, 1e-6};
 *  status = mdr_profile_area_function(2, C, 20e-9, 1e-6, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out);

/** Create an indenter from points, interpolated without overshoot. Leading zeros of the height form a flat end. If the
 *  one-dimensional profile is given, the height follows from (4).
 *  @param quantity  MDR_HEIGHT or MDR_G: the quantity in `y`
 *  @param n         number of points, at least 3
 *  @param x         [n] r or x, strictly ascending from x[0] = 0; contacts reach a <= x[n-1] [length]
 *  @param y         [n] from y[0] = 0, not descending, not all 0 [length]
 *  @param out       receives the handle
 *  @code
 *  mdr_profile *tip = NULL;
 *  const double r[4] = {0, 1e-6, 2e-6, 4e-6}, f[4] = {0, 5e-8, 2e-7, 8e-7};
 *  status = mdr_profile_table(MDR_HEIGHT, 4, r, f, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_table(int quantity, int n, const double x[], const double y[], mdr_profile **out);

/** Create an indenter from a function f(r) that is smooth except for corners and a power of r at the axis. The function is sampled
 *  when the handle is created, and the samples are checked between the nodes. Features narrower than 1 % of largest_radius may be
 *  missed.
 *
 *  Write f without cancellation, r^2/(R + sqrt(R^2 - r^2)) rather than R - sqrt(R^2 - r^2), so that it is accurate near the axis.
 *  If its values scatter there, a power series in r replaces f. The series must agree with the values within their scatter, and the
 *  values must determine it to 3e-10.
 *  @param height          f(r) on [0, largest_radius], f(0) = 0, greater than 0 beyond, not descending [length]
 *  @param context         passed to height, may be NULL
 *  @param largest_radius  > 0, largest contact radius [length]
 *  @param out             receives the handle
 *  @return also MDR_ECALLBACK; MDR_ENOCONVERGENCE if f is not smooth enough or inaccurate near the axis
 *  @code
 *  mdr_profile *tip = NULL;
 *  status = mdr_profile_function(parabola, NULL, 2e-6, &tip);
 *  MDR_FREE(tip);
 *  @endcode
 */
int mdr_profile_function(mdr_function height, void *context, double largest_radius, mdr_profile **out);

/** Create a sum of indenters, f = f1 + f2 + ..., g = g1 + g2 + .... It ends where the first of them ends.
 *  @param n      number of terms, at least 1
 *  @param terms  [n] handles; copied
 *  @param out    receives the handle
 *  @code
 *  const mdr_profile *terms[2] = {ball, ball};
 *  mdr_profile *sum = NULL;
 *  status = mdr_profile_sum(2, terms, &sum);
 *  MDR_FREE(sum);
 *  @endcode
 */
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);

/** Compute the height or the one-dimensional profile of an indenter, or the slope of either.
 *  @param p         indenter
 *  @param quantity  MDR_HEIGHT, MDR_HEIGHT_SLOPE, MDR_G or MDR_G_SLOPE
 *  @param n         number of radii
 *  @param x         [n] r or x >= 0 [length]
 *  @param out       [n] values
 *  @return also MDR_EDOMAIN beyond the end of the indenter
 *  @code
 *  const double x[2] = {1e-6, 2e-6};
 *  double g[2];
 *  status = mdr_profile_values(ball, MDR_G, 2, x, g);
 *  @endcode
 */
int mdr_profile_values(const mdr_profile *p, int quantity, int n, const double x[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
