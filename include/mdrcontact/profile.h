/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file profile.h
 * Indenters: f(r), f(0) = 0, and the one-dimensional g(x), equations (3) and (4).
 * @since 0.1
 */
#ifndef MDRCONTACT_PROFILE_H
#define MDRCONTACT_PROFILE_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/** An indenter. Made by mdr_profile_.... */
typedef struct mdr_profile mdr_profile;

/** Paraboloid f = r^2/(2R), g = x^2/R: a sphere as long as a is small against R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_paraboloid(double radius, mdr_profile **out);

/** Sphere f = R - sqrt(R^2 - r^2), g = (x/2) ln((R + x)/(R - x)). Defined for r <= R; contacts reach a < R.
 *  @param radius  R > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_sphere(double radius, mdr_profile **out);

/** Cone f = r tan(phi), g = (pi/2) x tan(phi). A Berkovich or Vickers tip has the equivalent half-angle 70.30 degrees, a cube
 *  corner 42.28 degrees.
 *  @param inclination  phi, the angle between the face and the surface, pi/2 minus the half-angle, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle */
int mdr_profile_cone(double inclination, mdr_profile **out);

/** Power law f = c r^n, g = kappa_n c x^n with kappa_n = (sqrt(pi)/2) n Gamma(n/2)/Gamma((n+1)/2).
 *  @param exponent     n, 0 < n <= 100 [1]
 *  @param coefficient  c > 0 [length^(1-n)]
 *  @param out          receives the handle */
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out);

/** Flat cylindrical punch: f = g = 0 up to its radius, where it ends in a vertical wall. The contact radius is that radius
 *  at every depth: compute states by depth or force.
 *  @param radius  b > 0 [length]
 *  @param out     receives the handle */
int mdr_profile_flat_punch(double radius, mdr_profile **out);

/** Cone with a flat end: f = (r - b) tan(phi), g = x tan(phi) arccos(b/x) for r, x > b, 0 below.
 *  @param end_radius   b > 0 [length]
 *  @param inclination  phi, 0 < phi < pi/2 [radian]
 *  @param out          receives the handle */
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);

/** Paraboloid with a flat end: f = (r^2 - b^2)/(2R), g = (x/R) sqrt(x^2 - b^2) for r, x > b, 0 below.
 *  @param end_radius  b > 0 [length]
 *  @param radius      R > 0, radius of curvature at the apex that is cut off [length]
 *  @param out         receives the handle */
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);

/** Cone with a rounded tip, a paraboloid that passes into the cone at b without a kink: f = r^2 tan(phi)/(2b) for r <= b,
 *  (r - b/2) tan(phi) beyond.
 *  @param blend_radius  b > 0; the radius of curvature at the tip is b/tan(phi) [length]
 *  @param inclination   phi, 0 < phi < pi/2 [radian]
 *  @param out           receives the handle */
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);

/** Calibrated nanoindenter tip by its area function A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., A = pi r^2
 *  (Oliver, Pharr, J. Mater. Res. 7 (1992) 1564). A must grow from min_height (from 0 without one) to max_height.
 *  @param n             number of coefficients, at least 1
 *  @param coefficients  [n] C0 [1], C1 [length], C2 [length^(3/2)], C3 [length^(7/4)], ...
 *  @param min_height    f below which the fitted A is not to be trusted, 0 if there is none; below it the tip is a paraboloid
 *                       that meets A there [length]
 *  @param max_height    f up to which the tip is used, > min_height [length]
 *  @param out           receives the handle */
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out);

/** Indenter through points, interpolated without overshoot. Of its height leading zeros are a flat end; if its one-dimensional
 *  profile is given, its height follows from (4).
 *  @param quantity  MDR_HEIGHT or MDR_G: what y is
 *  @param n         number of points, at least 3
 *  @param x         [n] r or x, strictly ascending from x[0] = 0; contacts reach a <= x[n-1] [length]
 *  @param y         [n] from y[0] = 0, never decreasing, not all 0 [length]
 *  @param out       receives the handle */
int mdr_profile_table(int quantity, int n, const double x[], const double y[], mdr_profile **out);

/** Indenter from a function f(r), smooth but for corners and a power of r at the axis; a feature narrower than 1 % of
 *  largest_radius may go unseen. It is sampled when the handle is made, and compared with f between the nodes. Written without
 *  cancellation, r^2/(R + sqrt(R^2 - r^2)) rather than R - sqrt(R^2 - r^2), f keeps its digits down to the axis. Where its values
 *  scatter there, f is continued by a power series in r that agrees with them within their scatter and is determined by them to
 *  3e-10, or refused.
 *  @param height          f(r) on [0, largest_radius], f(0) = 0, greater than 0 beyond, never decreasing [length]
 *  @param context         passed on to height, may be NULL
 *  @param largest_radius  > 0, up to where contacts reach [length]
 *  @param out             receives the handle
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if f is not smooth enough to be sampled or loses its digits towards the axis */
int mdr_profile_function(mdr_function height, void *context, double largest_radius, mdr_profile **out);

/** Sum of indenters, f = f1 + f2 + ...: their g add too. It is defined as far as the first of them ends.
 *  @param n      number of terms, at least 1
 *  @param terms  [n] handles; copied
 *  @param out    receives the handle */
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);

/** Height or one-dimensional profile of an indenter, or the slope of either.
 *  @param p         indenter
 *  @param quantity  MDR_HEIGHT, MDR_HEIGHT_SLOPE, MDR_G or MDR_G_SLOPE
 *  @param n         number of radii
 *  @param x         [n] r or x >= 0 [length]
 *  @param out       [n] values
 *  @return also MDR_EDOMAIN beyond the end of the profile */
int mdr_profile_values(const mdr_profile *p, int quantity, int n, const double x[], double out[]);

#ifdef __cplusplus
}
#endif

#endif
