/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { EARLIER_NUMBERS = 20, MOST_NUMBERS = 44, PRICE_OF_FIT = 60 };

static const mdr_fit_parameter *take_parameters(input *in, int count, mdr_fit_parameter parameters[MOST_NUMBERS])
{
    for (int i = 0; i < count; i++) {
        mdr_fit_parameter *p = &parameters[i];
        const int b = take_byte(in);
        *p = (mdr_fit_parameter){take_positive(in), -INFINITY, INFINITY, 0.0, 0.0, b % 4 == 0, ""};
        if (b % 8 == 7) p->value = 0.0;
        if (b % 16 != 5) continue;
        p->lower = take_number(in);
        p->upper = take_number(in);
        p->prior = take_number(in);
        p->prior_sd = take_number(in);
    }
    return parameters;
}

/* How far a fuzzer's choices go. The first came before the others and stay as they are, for the inputs that are kept. */
typedef struct choices {
    int kinds, indenters, media, numbers, is_wide;
} choices;

/* An indenter and a medium of a kind, to be given other numbers; NULL for a kind that there is not. */
static mdr_profile *new_profile(int kind)
{
    static const double area[4] = {24.5, 0.1, 0.1, 0.1};
    mdr_profile *p = NULL;

    if (kind == 1) mdr_profile_paraboloid(1.0, &p);
    if (kind == 2) mdr_profile_sphere(1.0, &p);
    if (kind == 3) mdr_profile_cone(0.3, &p);
    if (kind == 4) mdr_profile_power(2.5, 1.0, &p);
    if (kind == 5) mdr_profile_flat_punch(1.0, &p);
    if (kind == 6) mdr_profile_flat_cone(1.0, 0.3, &p);
    if (kind == 7) mdr_profile_flat_paraboloid(1.0, 1.0, &p);
    if (kind == 8) mdr_profile_rounded_cone(1.0, 0.3, &p);
    if (kind == 9) mdr_profile_area_function(4, area, 0.0, 1.0, &p);
    return p;
}

enum { OF_WORLD = 5 };

static mdr_medium *new_medium(int kind, int model, int layers)
{
    static const double one[2] = {1.0, 2.0}, nu[2] = {0.3, 0.2}, z[2] = {0.0, 1.0};
    mdr_medium *m = NULL;

    if (kind == 1) new_homogeneous(1.0, 0.3, &m);
    if (kind == 2) new_layered(layers, one, nu, one, 1.0, 0.4, model, NULL, &m);
    if (kind == 3) medium_of_grades(2, z, one, nu, model, NULL, &m);
    if (kind == 4) medium_of_power(1.0, 1.0, 0.2, 0.3, &m);
    return m;
}

/* What came later: counterbodies, common priors, the branch or part of each point. */
static void widen(world *w, mdr_fit_problem *problem, int branch[MOST_POINTS], double weights[2 * MOST_NUMBERS],
                  mdr_medium **own)
{
    input *in = &w->in;
    for (int i = 0; i < MOST_POINTS; i++) branch[i] = TAKE_ONE_OF(in, MDR_ON_LOADING, MDR_ON_UNLOADING);
    for (int i = 0; i < 2 * MOST_NUMBERS; i++) weights[i] = i % 5 == 0 ? take_number(in) : 0.0;
    if (take_byte(in) % 2) problem->branch = branch;
    if (take_chance(in)) problem->prior_weights = weights;
    if (take_chance(in)) problem->prior_count = take_choice(in, 3);
    const int kind = take_chance(in) ? take_choice(in, 6) : 0, model = take_member(in, MDR_MODEL_GAO,
            MDR_MODEL_EXACT - MDR_MODEL_GAO);
    problem->counterbody = some_medium(w);
    for (int i = 0; i < SLOTS; i++) {
        if (problem->counterbody == w->media[i] && w->medium_is_exact[i]) problem->counterbody = NULL;
    }
    if (kind > 0 && kind < OF_WORLD) problem->counterbody = *own = new_medium(kind, model, 1);
}

/* An instrument that reads what is, which viscoelastic bodies need; one byte in four leaves it as it came. */
static void settle_instrument(input *in, int count, mdr_fit_parameter parameters[MOST_NUMBERS])
{
    static const double values[MDR_FIT_INSTRUMENT_COUNT] = {0.0, 0.0, 0.0, 0.0, INFINITY, 0.75, 1.0, 1.0, 1.0, 0.0};
    if (take_byte(in) % 4 == 3 || count > MOST_NUMBERS || count < MDR_FIT_INSTRUMENT_COUNT) return;
    for (int i = 0; i < MDR_FIT_INSTRUMENT_COUNT; i++) {
        parameters[count - MDR_FIT_INSTRUMENT_COUNT + i] = (mdr_fit_parameter){values[i], -INFINITY, INFINITY, 0.0, 0.0, 0, ""};
    }
}

static void fit(world *w, choices of)
{
    input *in = &w->in;
    double x[MOST_POINTS], y[MOST_POINTS], force[MOST_POINTS], sd[MOST_POINTS];
    double fitted[MOST_POINTS], residuals[MOST_POINTS], radii[MOST_POINTS];
    double values[MOST_NUMBERS], covariance[MOST_NUMBERS * MOST_NUMBERS], weakest[MOST_NUMBERS], lower, upper;
    double weights[2 * MOST_NUMBERS];
    mdr_fit_parameter parameters[MOST_NUMBERS];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    mdr_fit_problem problem;
    mdr_profile *profile;
    mdr_medium *medium, *counterbody = NULL;
    int status, kind, model, count = 0, n = take_count(in), at_bound[MOST_NUMBERS], branch[MOST_POINTS];

    problem = MDR_SIZED(mdr_fit_problem);
    problem.data_kind = take_member(in, MDR_FIT_FORCE_DEPTH, of.kinds);
    profile = new_profile(take_choice(in, of.indenters));
    problem.profile = some_profile(w);
    if (profile != NULL) problem.profile = profile;
    kind = take_choice(in, of.media);
    model = take_member(in, MDR_MODEL_GAO, MDR_MODEL_EXACT - MDR_MODEL_GAO);
    medium = new_medium(kind, model, 1 + (take_code(in, 2) == 2));
    problem.medium = medium;
    problem.adhesion_rule = TAKE_ONE_OF(in, MDR_ADHESION_AUTOMATIC, MDR_ADHESION_PAPER, MDR_ADHESION_ENERGY);
    problem.loss = TAKE_ONE_OF(in, MDR_FIT_LINEAR, MDR_FIT_HUBER, MDR_FIT_CAUCHY);
    problem.sd_is_relative = take_choice(in, 2);
    problem.max_iterations = 5;
    problem.any_units = take_choice(in, 2);
    if (kind == 0 || kind == OF_WORLD) {
        const int slot = take_byte(in) % SLOTS;
        if (!w->medium_is_exact[slot]) problem.medium = w->media[slot];
    }
    if (take_chance(in)) problem.loss_scale = take_number(in);
    take_positives(in, x);
    take_positives(in, y);
    take_positives(in, force);
    take_positives(in, sd);
    if (of.is_wide) widen(w, &problem, branch, weights, &counterbody);
    problem.parameters = take_parameters(in, of.numbers, parameters);
    judge_status("mdr_fit_parameters", mdr_fit_parameters(&problem, 0, NULL, &count));
    if (of.is_wide) settle_instrument(in, count, parameters);
    problem.parameter_count = take_chance(in) ? take_choice(in, of.numbers) : count;
    if (problem.parameter_count <= of.numbers && afford(w, PRICE_OF_FIT)) {
        fill(fitted), fill(residuals), fill(radii);
        status = mdr_fit_predict(&problem, n, x, y, take_chance(in) ? NULL : force, fitted, radii);
        judge("mdr_fit_predict", status, n, fitted, FINITE);
        judge("mdr_fit_predict", status, n, radii, NOT_NEGATIVE);
        fill(fitted);
        status = mdr_fit_solve(&problem, n, x, y, force, take_chance(in) ? sd : NULL, values, covariance, NULL, at_bound, weakest,
                               fitted, residuals, &summary);
        judge("mdr_fit_solve", status, n, fitted, FINITE);
        judge("mdr_fit_solve", status, n, residuals, FINITE);
        if (take_chance(in)) {
            status = mdr_fit_interval(&problem, n, x, y, force, NULL, take_choice(in, 3), 0.95, &lower, &upper);
            judge_status("mdr_fit_interval", status);
            if (status == MDR_SUCCESS && (isnan(lower) || isnan(upper))) finding("mdr_fit_interval", "NaN", lower);
        }
    }
    MDR_FREE(profile);
    MDR_FREE(medium);
    MDR_FREE(counterbody);
}

void fuzz_fits(world *w)
{
    fit(w, (choices){.kinds = 4, .indenters = 9, .media = 5, .numbers = EARLIER_NUMBERS, .is_wide = 0});
}

void fuzz_wide_fits(world *w)
{
    double factor[MOST_POINTS];
    const double level = take_ratio(&w->in), degrees_of_freedom = take_positive(&w->in);

    fill(factor);
    judge("mdr_fit_quantile", mdr_fit_quantile(level, degrees_of_freedom, factor), 1, factor, NOT_NEGATIVE);
    fit(w, (choices){.kinds = 7, .indenters = 10, .media = 6, .numbers = MOST_NUMBERS, .is_wide = 1});
}
