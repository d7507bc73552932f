/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weights and closed forms, names and facts of models. */
#include "world.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

void fuzz_formulas(world *w)
{
    input *in = &w->in;
    static const int weights[] = {MDR_WEIGHT_PHI, MDR_WEIGHT_I0, MDR_WEIGHT_I1, MDR_WEIGHT_J0, MDR_WEIGHT_J1};
    const int which = take_byte(in) % 10, n = take_count(in);
    double x[MOST_POINTS], out[MOST_POINTS], p, q, r, s, t;

    take_positives(in, x);
    fill(out);
    if (which < 5) {
        judge("mdr_weight", mdr_weight(weights[which], take_ratio(in), n, x, out), n, out, FINITE);
        return;
    }
    p = take_positive(in), q = take_positive(in), r = take_positive(in), s = take_positive(in), t = take_positive(in);
    const double with_coating[] = {p, q, r, s, t}, scales[] = {q, r}, ratios[] = {p, q};
    switch (which) {
    case 5: judge("mdr_closed_form", mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, n, x, with_coating, out), n, out,
                  NOT_NEGATIVE); break;
    case 6: judge("mdr_closed_form", mdr_closed_form(MDR_FORM_CONE_FORCE, n, x, with_coating, out), n, out, NOT_NEGATIVE); break;
    case 7: judge("mdr_closed_form", mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, n, x, with_coating, out), n, out, FINITE); break;
    case 8:
        judge("mdr_closed_form", mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, &p, scales, out), 1, out, NOT_NEGATIVE);
        fill(out);
        judge("mdr_closed_form", mdr_closed_form(MDR_FORM_DEPTH_SCALE, 1, &p, scales, out), 1, out, NOT_NEGATIVE);
        break;
    default: judge("mdr_closed_form", mdr_closed_form(MDR_FORM_REDUCED_DEPTH, n, x, ratios, out), n, out, FINITE); break;
    }
}

/* Words of codes, facts of models, and the points of a rule. */
void fuzz_lists(world *w)
{
    enum { MOST_NUMBERS = 8, MOST_ORDER = 3, POINTS = 6 * MOST_ORDER * MOST_ORDER * MOST_ORDER };
    const int model = take_member(&w->in, MDR_MODEL_GAO, MDR_MODEL_GAO_POWER - MDR_MODEL_GAO + 2), length = take_choice(&w->in, 30);
    const int order = take_choice(&w->in, 4);
    double points[3 * POINTS], weights[2 * POINTS];
    mdr_model_facts facts = MDR_SIZED(mdr_model_facts);
    mdr_parameter numbers[MOST_NUMBERS];
    char name[30];
    int status, again = -1;

    memset(name, 'x', sizeof name), name[sizeof name - 1] = '\0';
    if (length >= 0 && length < (int)sizeof name) name[length] = '\0';
    judge_status("mdr_code_of", mdr_code_of(model, name, &again));
    status = mdr_code_of(model, mdr_name_of(model), &again);
    judge_status("mdr_code_of", status);
    if (status == MDR_SUCCESS && again != model) finding("mdr_code_of", "another code", again);
    judge_status("mdr_model_info", mdr_model_info(model, &facts));
    judge_status("mdr_parameters", mdr_parameters(some_medium(w), length % (MOST_NUMBERS + 1), numbers, &again));
    if (order > MOST_ORDER) return;
    status = mdr_lateral_rule(order, take_ratio(&w->in), points, weights);
    judge_status("mdr_lateral_rule", status);
    if (status != MDR_SUCCESS) return;
    for (int i = 0; i < 6 * order * order * order; i++) {
        if (!isfinite(points[3 * i] + points[3 * i + 1] + points[3 * i + 2])) finding("mdr_lateral_rule", "no point", i);
        if (!isfinite(weights[2 * i] + weights[2 * i + 1])) finding("mdr_lateral_rule", "no weight", i);
    }
}
