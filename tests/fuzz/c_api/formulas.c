/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights and closed forms. */
#include "world.h"

#include <stddef.h>

void fuzz_formulas(world *w)
{
    input *in = &w->in;
    static int (*const weights[])(int, const double[], double, double[]) = {
        mdr_weight_phi, mdr_weight_i0, mdr_weight_i1, mdr_weight_j0, mdr_weight_j1
    };
    const int which = take_byte(in) % 10, n = take_count(in);
    double x[MOST_POINTS], out[MOST_POINTS], p, q, r, s, t;

    take_positives(in, x);
    fill(out);
    if (which < 5) {
        judge("mdr_weight_...", weights[which](n, x, take_ratio(in), out), n, out, FINITE);
        return;
    }
    p = take_positive(in), q = take_positive(in), r = take_positive(in), s = take_positive(in), t = take_positive(in);
    switch (which) {
    case 5:
        judge("mdr_coated_paraboloid_force", mdr_coated_paraboloid_force(n, x, p, q, r, s, out), n, out, NOT_NEGATIVE);
        break;
    case 6: judge("mdr_coated_cone_force", mdr_coated_cone_force(n, x, p, q, r, s, out), n, out, NOT_NEGATIVE); break;
    case 7:
        judge("mdr_coated_paraboloid_adhesive_depth", mdr_coated_paraboloid_adhesive_depth(n, x, p, q, r, s, t, out), n, out,
              FINITE);
        break;
    case 8:
        judge("mdr_adhesive_radius_scale", mdr_adhesive_radius_scale(p, q, r, out), 1, out, NOT_NEGATIVE);
        fill(out);
        judge("mdr_adhesive_depth_scale", mdr_adhesive_depth_scale(p, q, r, out), 1, out, NOT_NEGATIVE);
        break;
    default: judge("mdr_reduced_adhesive_depth", mdr_reduced_adhesive_depth(n, x, p, q, out), n, out, FINITE); break;
    }
}
