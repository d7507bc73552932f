/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { MOST_NUMBERS = 20, PRICE_OF_FIT = 60 };

static const mdr_fit_parameter *take_parameters(input *in, mdr_fit_parameter parameters[MOST_NUMBERS])
{
    for (int i = 0; i < MOST_NUMBERS; i++) {
        mdr_fit_parameter *p = &parameters[i];
        const int b = take_byte(in);
        *p = (mdr_fit_parameter){take_positive(in), -INFINITY, INFINITY, 0.0, 0.0, b % 4 == 0};
        if (b % 8 == 7) p->value = 0.0;
        if (b % 16 != 5) continue;
        p->lower = take_number(in);
        p->upper = take_number(in);
        p->prior = take_number(in);
        p->prior_sd = take_number(in);
    }
    return parameters;
}

void fuzz_fits(world *w)
{
    input *in = &w->in;
    double x[MOST_POINTS], y[MOST_POINTS], force[MOST_POINTS], sd[MOST_POINTS];
    double fitted[MOST_POINTS], residuals[MOST_POINTS], radii[MOST_POINTS];
    double values[MOST_NUMBERS], covariance[MOST_NUMBERS * MOST_NUMBERS], weakest[MOST_NUMBERS], lower, upper;
    mdr_fit_parameter parameters[MOST_NUMBERS];
    mdr_fit_summary summary;
    mdr_fit_problem problem;
    int status, count = 0, n = take_count(in), at_bound[MOST_NUMBERS];

    mdr_fit_problem_init(&problem);
    problem.data_kind = take_code(in, 4);
    problem.indenter = take_choice(in, 9);
    problem.profile = some_profile(w);
    problem.medium = take_choice(in, 5);
    problem.model = take_choice(in, MDR_MODEL_EXACT);
    problem.layers = take_code(in, 2);
    problem.adhesion_rule = take_choice(in, 3);
    problem.loss = take_choice(in, 3);
    problem.sd_is_absolute = take_choice(in, 2);
    problem.max_iterations = 5;
    problem.check_units = take_choice(in, 2);
    if (problem.medium == MDR_FIT_MEDIUM_GIVEN) {
        const int slot = take_byte(in) % SLOTS;
        if (!w->medium_is_exact[slot]) problem.medium_object = w->media[slot];
    }
    if (take_chance(in)) problem.loss_scale = take_number(in);
    take_positives(in, x);
    take_positives(in, y);
    take_positives(in, force);
    take_positives(in, sd);
    problem.parameters = take_parameters(in, parameters);
    judge_status("mdr_fit_parameter_count", mdr_fit_parameter_count(&problem, &count));
    problem.parameter_count = take_chance(in) ? take_choice(in, MOST_NUMBERS) : count;
    if (problem.parameter_count > MOST_NUMBERS || !afford(w, PRICE_OF_FIT)) return;
    fill(fitted), fill(residuals), fill(radii);
    status = mdr_fit_predict(&problem, n, x, y, take_chance(in) ? NULL : force, fitted, radii);
    judge("mdr_fit_predict", status, n, fitted, FINITE);
    judge("mdr_fit_predict", status, n, radii, NOT_NEGATIVE);
    fill(fitted);
    status = mdr_fit_solve(&problem, n, x, y, force, take_chance(in) ? sd : NULL, values, covariance, NULL, at_bound, weakest, fitted,
                           residuals, &summary);
    judge("mdr_fit_solve", status, n, fitted, FINITE);
    judge("mdr_fit_solve", status, n, residuals, FINITE);
    if (take_chance(in)) {
        status = mdr_fit_interval(&problem, n, x, y, force, NULL, take_choice(in, 3), 0.95, &lower, &upper);
        judge_status("mdr_fit_interval", status);
        if (status == MDR_SUCCESS && (isnan(lower) || isnan(upper))) finding("mdr_fit_interval", "NaN", lower);
    }
}
