/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bodies that yield: imprints, laws, the overload rule and pressure caps. */
#include "world.h"

#include <stddef.h>
#include <stdlib.h>

/* the rows of states have doubles only */
enum {
    POINTS_OF_RULE = 100, PRICE_OF_IMPRINT = 4, PRICE_OF_LAW = 20, PRICE_OF_STATES = 20, EXACT = 4, MOST_MEMORY = 2, MOST_STATES = 2,
    OVERLOAD = sizeof(mdr_overload_state) / sizeof(double), CAP = sizeof(mdr_cap_state) / sizeof(double), WIDEST = OVERLOAD
};

static void fill_rows(double rows[MOST_POINTS * WIDEST])
{
    for (int i = 0; i < WIDEST; i++) fill(rows + MOST_POINTS * i);
}

static void judge_rows(const char *call, int status, int n, int members, const double rows[MOST_POINTS * WIDEST])
{
    for (int i = 0; i < MOST_POINTS * WIDEST; i++) {
        double one[MOST_POINTS];
        fill(one);
        one[0] = rows[i];
        judge(call, status, i < n * members, one, NOT_NAN);
    }
}

static void judge_imprint(world *w, const char *call, int status, mdr_imprint *imprint)
{
    mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);
    mdr_profile *left = NULL;
    double yield_stress[MOST_POINTS], ratio[MOST_POINTS];
    int layer = -1;

    judge_object(call, status, imprint);
    if (!imprint) return;
    judge_status("mdr_imprint_about", status = mdr_imprint_about(imprint, &facts));
    /* of a radius of 1e-200 it underflows */
    if (status == MDR_SUCCESS && !(facts.force >= 0.0)) finding("mdr_imprint_about", "a negative force", facts.force);
    status = mdr_imprint_profile(imprint, &left);
    judge_object("mdr_imprint_profile", status, left);
    judge_status("mdr_free", mdr_free(left));
    take_positives(&w->in, yield_stress);
    fill(ratio);
    status = mdr_imprint_reverse_yield(imprint, take_count(&w->in), yield_stress, ratio, &layer);
    judge("mdr_imprint_reverse_yield", status, 1, ratio, NOT_NEGATIVE);
    if (status == MDR_SUCCESS && layer < 0) finding("mdr_imprint_reverse_yield", "no layer", layer);
    judge_status("mdr_free", mdr_free(imprint));
}

static void press(world *w)
{
    const mdr_medium *medium = some_medium(w);
    const int way = take_byte(&w->in) % 3, n = take_count(&w->in);
    double x[MOST_POINTS], p[MOST_POINTS];
    mdr_imprint *imprint = NULL;
    int status;

    take_ascending(&w->in, x);
    take_positives(&w->in, p);
    if (!afford(w, PRICE_OF_IMPRINT)) return;
    if (way == 0) {
        status = mdr_imprint_new(medium, x[3], p[0], x[1], x[2], &imprint);
        judge_imprint(w, "mdr_imprint_new", status, imprint);
    } else if (way == 1) {
        status = mdr_imprint_two_terms(medium, x[1], p[0], p[1], take_chance(&w->in) ? take_number(&w->in) : 0.0, &imprint);
        judge_imprint(w, "mdr_imprint_two_terms", status, imprint);
    } else {
        /* a pressure that falls a little, and now and then any */
        if (!take_chance(&w->in)) for (int i = 0; i < MOST_POINTS; i++) p[i] = p[0] * (1.0 - 0.01 * i * i);
        status = mdr_imprint_from_pressure(medium, n, x, p, take_chance(&w->in) ? take_number(&w->in) : 0.0, &imprint);
        judge_imprint(w, "mdr_imprint_from_pressure", status, imprint);
    }
}

static void follow(world *w, const mdr_plastic_law *law)
{
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    const int n = take_count(&w->in), is_trial = take_chance(&w->in), is_wild = take_chance(&w->in);
    double d[MOST_POINTS], memory[MOST_MEMORY * MOST_POINTS] = {0.0}, out[4][MOST_POINTS], *numbers;
    int status = mdr_plastic_law_about(law, &facts);

    judge_status("mdr_plastic_law_about", status);
    if (status != MDR_SUCCESS) return;
    if (facts.memory_size < 1 || facts.memory_size > MOST_MEMORY) finding("mdr_plastic_law_about", "memory", facts.memory_size);
    for (int step = 0; step < 3; step++) {
        take_numbers(&w->in, d);
        for (int i = 0; i < MOST_POINTS && !is_wild; i++) d[i] = facts.largest_depth * (take_byte(&w->in) - 64) / 191.0;
        for (int i = 0; i < 4; i++) fill(out[i]);
        status = mdr_plastic_law_energies(law, n, d, memory, out[0], out[1]);
        judge("mdr_plastic_law_energies", status, n, out[0], FINITE);
        judge("mdr_plastic_law_energies", status, n, out[1], FINITE);
        for (int i = 0; i < 4; i++) fill(out[i]);
        status = mdr_plastic_law_advance(law, n, d, is_trial, memory, out[0], out[1], out[2]);
        judge("mdr_plastic_law_advance", status, n, out[0], FINITE);
        judge("mdr_plastic_law_advance", status, n, out[1], NOT_NAN);
        judge("mdr_plastic_law_advance", status, n, out[2], NOT_NEGATIVE);
    }
    for (int i = 0; i < 4; i++) fill(out[i]);
    status = mdr_plastic_law_loading(law, n, d, out[0], out[1], out[2], out[3]);
    for (int i = 0; i < 4; i++) judge("mdr_plastic_law_loading", status, n, out[i], FINITE);
    take_positives(&w->in, d);
    fill(out[0]);
    status = mdr_plastic_law_restitution(law, take_positive(&w->in), n, d, out[0]);
    judge("mdr_plastic_law_restitution", status, n, out[0], NOT_NEGATIVE);
    memory[0] = take_number(&w->in);
    fill(out[0]);
    judge("mdr_plastic_law_advance", mdr_plastic_law_advance(law, 1, d, 0, memory, out[0], NULL, NULL), 1, out[0], FINITE);
    numbers = malloc(sizeof *numbers * (size_t)facts.buffer_size);
    judge_status("mdr_plastic_law_buffer", mdr_plastic_law_buffer(law, facts.buffer_size, numbers));
    if (mdr_plastic_law_buffer(law, facts.buffer_size - 1, numbers) == MDR_SUCCESS) {
        finding("mdr_plastic_law_buffer", "takes too small a buffer", facts.buffer_size);
    }
    free(numbers);
}

static mdr_plastic_law *law_of_points(world *w, const mdr_plastic_law_options *options)
{
    const int n = take_count(&w->in);
    double x[5][MOST_POINTS];
    mdr_plastic_law *law = NULL;

    for (int i = 0; i < 5; i++) take_ascending(&w->in, x[i]);
    const int status = mdr_plastic_law_from_points(n, x[0], x[1], x[2], x[3], x[4], options, &law);
    judge_object("mdr_plastic_law_from_points", status, law);
    return law;
}

static mdr_plastic_law *law_of_ball(world *w, const mdr_yielding *metal, const mdr_plastic_law_options *options)
{
    mdr_profile *ball = NULL;
    mdr_plastic_law *law = NULL;
    const double R = take_positive(&w->in), part = (1 + take_byte(&w->in)) / 3000.0;
    const int is_other = take_chance(&w->in);

    int status = mdr_profile_paraboloid(R, &ball);
    judge_object("mdr_profile_paraboloid", status, ball);
    status = mdr_plastic_law_new(is_other ? some_profile(w) : ball, metal, is_other ? take_number(&w->in) : part * R, options,
                                 &law);
    judge_object("mdr_plastic_law_new", status, law);
    judge_status("mdr_free", mdr_free(ball));
    return law;
}

static void yield(world *w)
{
    const int n = take_count(&w->in), is_of_points = take_byte(&w->in) % 4 == 0;
    const double E = take_positive(&w->in), nu = take_chance(&w->in) ? take_ratio(&w->in) : take_byte(&w->in) % 50 / 100.0;
    double strain[MOST_POINTS], stress[MOST_POINTS], out[2][MOST_POINTS];
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    mdr_yielding *metal = NULL, *hard = NULL;
    mdr_plastic_law *law, *larger = NULL;
    int status;

    take_ascending(&w->in, strain);
    stress[0] = take_positive(&w->in) * E * 1e-3;
    for (int i = 1; i < MOST_POINTS; i++) stress[i] = stress[0] * (1.0 + 0.1 * i);
    if (take_chance(&w->in)) take_positives(&w->in, stress);
    fill(out[0]), fill(out[1]);
    status = mdr_yield_stress_from_hardness(E, nu, 3.0 * stress[0], take_chance(&w->in) ? take_number(&w->in) : 0.0, out[0],
                                            out[1]);
    judge("mdr_yield_stress_from_hardness", status, 1, out[0], POSITIVE);
    judge("mdr_yield_stress_from_hardness", status, 1, out[1], NOT_NEGATIVE);
    status = mdr_yielding_new(E, nu, n, strain, stress, &metal);
    judge_object("mdr_yielding_new", status, metal);
    if (take_chance(&w->in)) {
        status = mdr_yielding_new(take_positive(&w->in), nu, 0, NULL, NULL, &hard);
        judge_object("mdr_yielding_new", status, hard);
        options.other = take_chance(&w->in) ? metal : hard;
    }
    options.tolerance = take_chance(&w->in) ? take_number(&w->in) : 1e-4;
    options.work_of_adhesion = take_chance(&w->in) ? take_positive(&w->in) * 1e-3 : 0.0;
    if (afford(w, PRICE_OF_LAW)) {
        law = is_of_points ? law_of_points(w, &options) : law_of_ball(w, metal, &options);
        if (law) {
            follow(w, law);
            status = mdr_plastic_law_with_radius(law, take_positive(&w->in), &larger);
            judge_object("mdr_plastic_law_with_radius", status, larger);
            if (larger) follow(w, larger);
            judge_status("mdr_free", mdr_free(larger));
        }
        judge_status("mdr_free", mdr_free(law));
    }
    judge_status("mdr_free", mdr_free(metal));
    judge_status("mdr_free", mdr_free(hard));
}

static void limit(world *w)
{
    const int given = TAKE_ONE_OF(&w->in, MDR_RADIUS, MDR_DEPTH, MDR_FORCE), layers = take_count(&w->in);
    const int points = take_count(&w->in), n = points > MOST_STATES ? MOST_STATES : points;
    double x[MOST_POINTS], yield_stress[MOST_POINTS], out[2][MOST_POINTS], rows[MOST_POINTS * WIDEST];
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);
    mdr_overload *rule = NULL;
    mdr_cap *cap = NULL;

    take_positives(&w->in, x);
    take_positives(&w->in, yield_stress);
    fill(out[0]);
    status = mdr_truncated_hertz(x[0], yield_stress[0], yield_stress[1], points, x, out[0]);
    judge("mdr_truncated_hertz", status, points, out[0], NOT_NEGATIVE);
    if (!afford(w, PRICE_OF_STATES * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    status = mdr_overload_new(contact, layers, yield_stress, &rule);
    judge_object("mdr_overload_new", status, rule);
    fill_rows(rows);
    status = mdr_overload_states(rule, given, n, x, (mdr_overload_state *)rows);
    judge_rows("mdr_overload_states", status, n, OVERLOAD, rows);
    status = mdr_cap_new(contact, yield_stress[0], &cap);
    judge_object("mdr_cap_new", status, cap);
    fill_rows(rows);
    status = mdr_cap_states(cap, given, n, x, (mdr_cap_state *)rows);
    judge_rows("mdr_cap_states", status, n, CAP, rows);
    fill(out[0]), fill(out[1]);
    status = mdr_cap_pressure(cap, take_positive(&w->in), points, x, out[0], out[1]);
    judge("mdr_cap_pressure", status, points, out[0], FINITE);
    judge("mdr_cap_pressure", status, points, out[1], FINITE);
    if (afford(w, POINTS_OF_RULE * PRICE_OF_IMPRINT)) {
        mdr_plastic_law *law = NULL;
        status = mdr_plastic_law_from_overload(rule, x[0], NULL, &law);
        judge_object("mdr_plastic_law_from_overload", status, law);
        if (status == MDR_SUCCESS) follow(w, law);
        judge_status("mdr_free", mdr_free(law));
    }
    judge_status("mdr_free", mdr_free(rule));
    judge_status("mdr_free", mdr_free(cap));
}

void fuzz_plastic(world *w)
{
    switch (take_byte(&w->in) % 3) {
    case 0: press(w); break;
    case 1: yield(w); break;
    default: limit(w); break;
    }
}
