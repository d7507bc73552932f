/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file lateral.h
 * Laterally heterogeneous structures: E_eff(a, x, y), equation (33); docs/lateral.md. Option MDRCONTACT_LATERAL.
 * @since 0.1
 */
#ifndef MDRCONTACT_LATERAL_H
#define MDRCONTACT_LATERAL_H

#include "medium.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A half-space z > 0 whose moduli vary in all directions. Made by mdr_structure_shapes(), mdr_structure_voxels() or
 *  mdr_structure_function(). */
typedef struct mdr_structure mdr_structure;

/**
 * A user's structure. Unlike an mdr_function it is kept, and called in every evaluation, in the thread that evaluates.
 * @param x        position along the surface [length]
 * @param y        position along the surface [length]
 * @param z        depth > 0 [length]
 * @param E        receives Young's modulus > 0 [modulus]
 * @param nu       receives Poisson's ratio, -1 < nu <= 1/2 [1]
 * @param context  the pointer given with the function
 * @return         0, or any other number to report a failure: the evaluation then ends with MDR_ECALLBACK
 */
typedef int (*mdr_field)(double x, double y, double z, double *E, double *nu, void *context);

/** Shapes of bodies in a half-space, with their parameters in order; all but directions are [length]. */
enum mdr_shape {
    MDR_SHAPE_LAYER = 1401,      /**< z_top, z_bottom > z_top; INFINITY is allowed. */
    MDR_SHAPE_HALF_SPACE = 1402, /**< x, y, z of a point on the interface; x, y, z of the normal, of any length, into the
                                      material. */
    MDR_SHAPE_BALL = 1403,       /**< x, y, z of the centre; radius > 0. */
    MDR_SHAPE_FIBRE = 1404,      /**< Endless round cylinder: x, y, z of a point on the axis; x, y, z of its direction, of any
                                      length; radius > 0. */
    MDR_SHAPE_PILLAR = 1405,     /**< Upright round cylinder: x, y of the axis; radius > 0; z_top, z_bottom > z_top; INFINITY is
                                      allowed. */
    MDR_SHAPE_BOX = 1406         /**< x_low, x_high, y_low, y_high, z_top, z_bottom, ascending in pairs. */
};

/** What a structure leaves to choose. Begun by MDR_SIZED; a structure looks only at what concerns
 *  it. */
typedef struct mdr_structure_options {
    size_t size;         /**< Of this structure; MDR_SIZED sets it. */
    double reference_nu; /**< Poisson's ratio of the weights, -1 < nu <= 1/2 [1]; default: that of the background, or the mean
                              over all voxels. */
    double tolerance;    /**< Shapes, functions: relative error of G_eff and nu_eff, 1e-10 to 0.1; default 1e-5. */
    int padded;          /**< Voxels: 0: the array repeats itself in x and y (default); else one material lies beside it. */
    int images;          /**< Voxels that repeat: periods that count cell by cell, 1 to 100; beyond them each slice counts with its
                              mean; default 1. */
    double beside_E;     /**< Padded voxels: Young's modulus of what lies beside, > 0 [modulus]. */
    double beside_nu;    /**< Padded voxels: its Poisson's ratio, -1 < nu <= 1/2 [1]. */
    double origin[2];    /**< Voxels: x and y of the array's lower corner; default 0 [length]. */
    double exponent;     /**< p of the power mean G_eff = [sum w G^p]^(1/p): -1 (series) to 1 (parallel, the default), 0 for the
                              logarithm's. At one Poisson's ratio the exact E_eff lies between those of -1 and 1. */
    int reference_nu_is_given; /**< Not 0: a reference_nu of 0 is meant. */
    int exponent_is_given;     /**< Not 0: an exponent of 0 is meant. */
} mdr_structure_options;

/** Bodies in a background; where they overlap, the later one is there. What lies above the surface z = 0 does not count.
 *  @param E           Young's modulus of the background > 0 [modulus]
 *  @param nu          its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param n           number of bodies
 *  @param kind        [n] one of enum mdr_shape each
 *  @param parameters  [7 n] seven numbers for each body, those of its shape first; the rest is not looked at
 *  @param shape_E     [n] Young's moduli > 0 [modulus]
 *  @param shape_nu    [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param options     NULL for the defaults
 *  @param out         receives the handle */
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[],
                         const double shape_E[], const double shape_nu[], const mdr_structure_options *options,
                         mdr_structure **out);

/** An array of cells of one phase each, on a half-space. Cell (i, j, k) fills origin + (i ... i+1) spacing[0] in x, (j ... j+1)
 *  spacing[1] in y, and the depths k spacing[2] ... (k+1) spacing[2].
 *  @param size      [3] number of cells in x, y and z, each at least 1
 *  @param labels    [size[0] size[1] size[2]] phase of cell (i, j, k), 0 ... phases - 1, at (k size[1] + j) size[0] + i
 *  @param phases    number of phases, at least 1
 *  @param E         [phases] Young's moduli > 0 [modulus]
 *  @param nu        [phases] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param spacing   [3] edge lengths of a cell in x, y and z > 0 [length]
 *  @param below_E   Young's modulus of the half-space under the array > 0 [modulus]
 *  @param below_nu  its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param options   NULL for the defaults
 *  @param out       receives the handle */
int mdr_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[],
                         const double spacing[3], double below_E, double below_nu,
                         const mdr_structure_options *options, mdr_structure **out);

/** A structure of smooth functions of position; for those with jumps shapes or voxels are the better description.
 *  @param field         E and nu at a point; it and its context must live as long as the structure
 *  @param context       passed on to field, may be NULL
 *  @param reference_nu  Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param options       tolerance and exponent; NULL for the defaults
 *  @param out           receives the handle */
int mdr_structure_function(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options,
                           mdr_structure **out);

/** E_eff(a, x, y) = 2 G_eff/(1 - nu_eff), to first order in the contrast of the moduli, equation (33).
 *  @param s    structure
 *  @param n    number of contacts
 *  @param x    [n] centres of the contacts [length]
 *  @param y    [n] centres of the contacts [length]
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] E_eff [modulus]
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE where the tolerance is not met */
int mdr_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[], double out[]);

/** The medium that an indenter meets at (x, y): a table of E_eff(a, x, y) as mdr_medium_table() takes it.
 *  @param s                structure
 *  @param x                centre of the contact [length]
 *  @param y                centre of the contact [length]
 *  @param smallest_radius  > 0 [length]
 *  @param largest_radius   > smallest_radius [length]
 *  @param points           number of radii, evenly spaced in ln a, 3 to 1000000
 *  @param out              receives the handle
 *  @return also as mdr_structure_modulus() */
int mdr_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius, int points,
                         mdr_medium **out);

/** The weights with which shear modulus and Poisson's ratio at a point enter G_eff and nu_eff: densities whose integral over the
 *  half-space is 1, in units of a. Both are infinite at the edge of the contact, rho = 1, z = 0.
 *  @param n        number of points
 *  @param rho      [n] distances from the contact's axis >= 0, in units of a [1]
 *  @param z        [n] depths >= 0, in units of a [1]
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param shear    [n] weights of the shear modulus [1]
 *  @param poisson  [n] weights of Poisson's ratio [1] */
int mdr_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[]);

/** The weights integrated over the cells between lines, relative to the contact's axis, and two depths.
 *  @param nu        Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param a         contact radius > 0 [length]
 *  @param z_top     >= 0 [length]
 *  @param z_bottom  > z_top [length]
 *  @param nx        number of cells in x, at least 1
 *  @param x         [nx + 1] lines, strictly ascending [length]
 *  @param ny        number of cells in y, at least 1
 *  @param y         [ny + 1] lines, strictly ascending [length]
 *  @param shear     [ny nx] weights of the shear modulus, that of cell (i, j) at j nx + i [1]
 *  @param poisson   [ny nx] weights of Poisson's ratio, in the same order [1] */
int mdr_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny, const double y[],
                      double shear[], double poisson[]);

/** Points and weights for sums over smooth structures, G_eff = sum of weight * G(x + a point): what mdr_structure_function()
 *  uses.
 *  @param order    1 to 200; the rule has N = 6 order^3 points
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param points   [3 N] x, y, z of each point, relative to the contact's centre and in units of a [1]
 *  @param weights  [2 N] weights of the shear modulus and of Poisson's ratio at each point, with sum 1 each [1]
 *  @return MDR_ECANCELLED leaves part of a rule in both arrays */
int mdr_lateral_rule(int order, double nu, double points[], double weights[]);

#ifdef __cplusplus
}
#endif

#endif
