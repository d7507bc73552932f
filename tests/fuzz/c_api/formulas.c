/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights and closed forms, names and facts of models. */
#include "world.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

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

/* Names and facts of models, and the points of a rule. */
void fuzz_lists(world *w)
{
    enum { MOST_ORDER = 3, POINTS = 6 * MOST_ORDER * MOST_ORDER * MOST_ORDER };
    const int model = take_choice(&w->in, MDR_MODEL_GAO_POWER + 2), length = take_choice(&w->in, 30);
    const int order = take_choice(&w->in, 4);
    double points[3 * POINTS], weights[2 * POINTS];
    mdr_model_facts facts = MDR_SIZED(mdr_model_facts);
    char name[30];
    int status, again = -1;

    memset(name, 'x', sizeof name), name[sizeof name - 1] = '\0';
    status = mdr_model_name(model, length < (int)sizeof name ? length : (int)sizeof name, name);
    judge_status("mdr_model_name", status);
    if (status == MDR_SUCCESS && (mdr_model_from_name(name, &again) != MDR_SUCCESS || again != model)) {
        finding("mdr_model_from_name", "another model", again);
    }
    judge_status("mdr_model_from_name", mdr_model_from_name(name, &again));
    judge_status("mdr_model_info", mdr_model_info(model, &facts));
    if (order > MOST_ORDER) return;
    status = mdr_lateral_rule(order, take_ratio(&w->in), points, weights);
    judge_status("mdr_lateral_rule", status);
    if (status != MDR_SUCCESS) return;
    for (int i = 0; i < 6 * order * order * order; i++) {
        if (!isfinite(points[3 * i] + points[3 * i + 1] + points[3 * i + 2])) finding("mdr_lateral_rule", "no point", i);
        if (!isfinite(weights[2 * i] + weights[2 * i + 1])) finding("mdr_lateral_rule", "no weight", i);
    }
}
