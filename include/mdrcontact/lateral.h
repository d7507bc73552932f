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

/** A half-space z > 0 whose moduli vary in all directions. Created by mdr_structure_shapes(), mdr_structure_voxels() or
 *  mdr_structure_function(). Immutable. */
typedef struct mdr_structure mdr_structure;

/** A user-defined structure. Unlike an mdr_function it is kept, and called in every evaluation, in the evaluating thread.
 *  @param x        position along the surface [length]
 *  @param y        position along the surface [length]
 *  @param z        depth > 0 [length]
 *  @param E        receives Young's modulus > 0 [modulus]
 *  @param nu       receives Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param context  the pointer given with the function
 *  @return 0, or any other number to report a failure: the evaluation then returns MDR_ECALLBACK */
typedef int (*mdr_field)(double x, double y, double z, double *E, double *nu, void *context);

/** Shapes of inclusions in a half-space, and their parameters in order; all except directions are [length]. */
enum mdr_shape {
    MDR_SHAPE_LAYER = 1401,      /**< z_top, z_bottom > z_top; INFINITY is possible. */
    MDR_SHAPE_HALF_SPACE = 1402, /**< x, y, z of a point on the interface; x, y, z of the normal into the material, of any
                                      length. */
    MDR_SHAPE_BALL = 1403,       /**< x, y, z of the centre; radius > 0. */
    MDR_SHAPE_FIBRE = 1404,      /**< Infinite circular cylinder: x, y, z of a point on the axis; x, y, z of its direction, of any
                                      length; radius > 0. */
    MDR_SHAPE_PILLAR = 1405,     /**< Vertical circular cylinder: x, y of the axis; radius > 0; z_top, z_bottom > z_top; INFINITY is
                                      possible. */
    MDR_SHAPE_BOX = 1406         /**< x_low, x_high, y_low, y_high, z_top, z_bottom, ascending in pairs. */
};

/** Options of structures. A structure ignores the members of other kinds. Initialize with MDR_SIZED. */
typedef struct mdr_structure_options {
    size_t size;               /**< Size of this structure; MDR_SIZED sets it. */
    double reference_nu;       /**< Poisson's ratio of the weights, -1 < nu <= 1/2 [1]; default: that of the background, or the mean
                                    of all voxels. */
    double tolerance;          /**< Shapes, functions: relative error of G_eff and nu_eff, 1e-10 to 0.1; default 1e-5. */
    int padded;                /**< Voxels: 0: the array is periodic in x and y (default); otherwise one material surrounds it. */
    int images;                /**< Periodic voxels: number of periods resolved cell by cell, 1 to 100; beyond them each slice
                                    contributes its mean; default 1. */
    double beside_E;           /**< Padded voxels: Young's modulus of the surrounding material, > 0 [modulus]. */
    double beside_nu;          /**< Padded voxels: its Poisson's ratio, -1 < nu <= 1/2 [1]. */
    double origin[2];          /**< Voxels: x and y of the lower corner of the array; default 0 [length]. */
    double exponent;           /**< p of the power mean G_eff = [sum w G^p]^(1/p): -1 (series) to 1 (parallel, the default), 0: the
                                    geometric mean. For equal Poisson's ratios the results of -1 and 1 bound the exact E_eff. */
    int reference_nu_is_given; /**< Not 0: use a reference_nu of 0. */
    int exponent_is_given;     /**< Not 0: use an exponent of 0. */
} mdr_structure_options;

/** Create a structure of inclusions in a background. In an overlap the later inclusion applies. The part above the surface z = 0
 *  has no effect.
 *  @param E           Young's modulus of the background > 0 [modulus]
 *  @param nu          its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param n           number of inclusions
 *  @param kind        [n] one of enum mdr_shape each
 *  @param parameters  [7 n] seven numbers for each inclusion, those of its shape first; the rest is ignored
 *  @param shape_E     [n] Young's moduli > 0 [modulus]
 *  @param shape_nu    [n] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param options     NULL: default options
 *  @param out         receives the handle
 *  @code
 *  const int kind = MDR_SHAPE_BALL;
 *  const double place[7] = {0, 0, 2e-6, 1e-6}, E = 400e9, nu = 0.2;
 *  mdr_structure *composite = NULL;
 *  status = mdr_structure_shapes(3e9, 0.35, 1, &kind, place, &E, &nu, NULL, &composite);
 *  MDR_FREE(composite);
 *  @endcode
 */
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[],
                         const double shape_E[], const double shape_nu[], const mdr_structure_options *options,
                         mdr_structure **out);

/** Create a structure from an array of cells, each of one phase, on a half-space. Cell (i, j, k) fills origin + (i ... i+1)
 *  spacing[0] in x, (j ... j+1) spacing[1] in y, and the depths k spacing[2] ... (k+1) spacing[2].
 *  @param size      [3] number of cells in x, y and z, each at least 1
 *  @param labels    [size[0] size[1] size[2]] phase of cell (i, j, k), 0 ... phases - 1, at (k size[1] + j) size[0] + i
 *  @param phases    number of phases, at least 1
 *  @param E         [phases] Young's moduli > 0 [modulus]
 *  @param nu        [phases] Poisson's ratios, -1 < nu <= 1/2 [1]
 *  @param spacing   [3] edge lengths of a cell in x, y and z > 0 [length]
 *  @param below_E   Young's modulus of the half-space below the array > 0 [modulus]
 *  @param below_nu  its Poisson's ratio, -1 < nu <= 1/2 [1]
 *  @param options   NULL: default options
 *  @param out       receives the handle
 *  @code
 *  const int size[3] = {2, 2, 1}, labels[4] = {0, 1, 1, 0};
 *  const double E[2] = {3e9, 400e9}, nu[2] = {0.35, 0.2}, spacing[3] = {1e-6, 1e-6, 1e-6};
 *  mdr_structure *chequered = NULL;
 *  status = mdr_structure_voxels(size, labels, 2, E, nu, spacing, 3e9, 0.35, NULL, &chequered);
 *  MDR_FREE(chequered);
 *  @endcode
 */
int mdr_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[],
                         const double spacing[3], double below_E, double below_nu,
                         const mdr_structure_options *options, mdr_structure **out);

/** Create a structure from smooth functions of position. Describe discontinuous structures by shapes or voxels.
 *  @param field         E and nu at a point; it and its context must live as long as the structure
 *  @param context       passed to field, may be NULL
 *  @param reference_nu  Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param options       tolerance and exponent; NULL: default options
 *  @param out           receives the handle
 *  @code
 *  mdr_structure *smooth = NULL;
 *  status = mdr_structure_function(field, NULL, 0.3, NULL, &smooth);
 *  MDR_FREE(smooth);
 *  @endcode
 */
int mdr_structure_function(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options,
                           mdr_structure **out);

/** Compute E_eff(a, x, y) = 2 G_eff/(1 - nu_eff), to first order in the contrast of the moduli, equation (33).
 *  @param s    structure
 *  @param n    number of contacts
 *  @param x    [n] centres of the contacts [length]
 *  @param y    [n] centres of the contacts [length]
 *  @param a    [n] contact radii > 0 [length]
 *  @param out  [n] E_eff [modulus]
 *  @return also MDR_ECALLBACK, MDR_ENOCONVERGENCE if the tolerance is not met
 *  @code
 *  const double x[2] = {0.0, 2e-6}, y[2] = {0.0, 0.0}, a[2] = {1e-6, 1e-6};
 *  double E_eff[2];
 *  status = mdr_structure_modulus(structure, 2, x, y, a, E_eff);
 *  @endcode
 */
int mdr_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[], double out[]);

/** Create the medium at a position (x, y): a table of E_eff(a, x, y) as for mdr_medium_table().
 *  @param s                structure
 *  @param x                centre of the contact [length]
 *  @param y                centre of the contact [length]
 *  @param smallest_radius  > 0 [length]
 *  @param largest_radius   > smallest_radius [length]
 *  @param points           number of radii, equally spaced in ln a, 3 to 1000000
 *  @param out              receives the handle
 *  @return also as mdr_structure_modulus()
 *  @code
 *  mdr_medium *above = NULL;
 *  status = mdr_structure_medium(structure, 0.0, 0.0, 1e-7, 2e-6, 20, &above);
 *  MDR_FREE(above);
 *  @endcode
 */
int mdr_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius, int points,
                         mdr_medium **out);

/** Compute the weights of the shear modulus and of Poisson's ratio at a point in G_eff and nu_eff: densities whose integral over
 *  the half-space is 1, in units of a. Both are infinite at the contact edge, rho = 1, z = 0.
 *  @param n        number of points
 *  @param rho      [n] distances from the axis of the contact >= 0, in units of a [1]
 *  @param z        [n] depths >= 0, in units of a [1]
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param shear    [n] weights of the shear modulus [1]
 *  @param poisson  [n] weights of Poisson's ratio [1]
 *  @code
 *  const double rho = 0.5, z = 0.5;
 *  double shear, poisson;
 *  status = mdr_lateral_density(1, &rho, &z, 0.3, &shear, &poisson);
 *  @endcode
 */
int mdr_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[]);

/** Integrate the weights over cells of a grid between two depths. Coordinates are relative to the axis of the contact.
 *  @param nu        Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param a         contact radius > 0 [length]
 *  @param z_top     >= 0 [length]
 *  @param z_bottom  > z_top [length]
 *  @param nx        number of cells in x, at least 1
 *  @param x         [nx + 1] grid lines, strictly ascending [length]
 *  @param ny        number of cells in y, at least 1
 *  @param y         [ny + 1] grid lines, strictly ascending [length]
 *  @param shear     [ny nx] weights of the shear modulus, that of cell (i, j) at j nx + i [1]
 *  @param poisson   [ny nx] weights of Poisson's ratio, in the same order [1]
 *  @code
 *  const double x[3] = {-1e-6, 0.0, 1e-6}, y[2] = {-1e-6, 1e-6};
 *  double shear[2], poisson[2];
 *  status = mdr_lateral_cells(0.3, 1e-6, 0.0, 1e-6, 2, x, 1, y, shear, poisson);
 *  @endcode
 */
int mdr_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny, const double y[],
                      double shear[], double poisson[]);

/** Compute the points and weights that mdr_structure_function() uses for smooth structures, G_eff = sum of weight * G(x + a point).
 *  @param order    1 to 200; the rule has N = 6 order^3 points
 *  @param nu       Poisson's ratio of the weights, -1 < nu <= 1/2 [1]
 *  @param points   [3 N] x, y, z of each point, relative to the centre of the contact and in units of a [1]
 *  @param weights  [2 N] weights of the shear modulus and of Poisson's ratio at each point, each with sum 1 [1]
 *  @return MDR_ECANCELLED leaves part of a rule in both arrays
 *  @code
 *  double points[3 * 48], weights[2 * 48];
 *  status = mdr_lateral_rule(2, 0.3, points, weights);
 *  @endcode
 */
int mdr_lateral_rule(int order, double nu, double points[], double weights[]);

#ifdef __cplusplus
}
#endif

#endif
