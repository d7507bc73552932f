/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Works of adhesion that depend on the speed of the edge: the law, and histories of contacts. */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_SAMPLES = 10, PRICE_OF_HISTORY = 20, EXACT = 4 };

static mdr_rate_options take_options(world *w)
{
    mdr_rate_options options = MDR_SIZED(mdr_rate_options);

    options.work = take_positive(&w->in);
    if (take_byte(&w->in) % 4 == 0) {
        options.material = some_material(w);
        options.cohesive_stress = take_positive(&w->in);
    } else {
        options.speed = take_positive(&w->in);
        options.exponent = take_ratio(&w->in);
        options.closing_work = take_chance(&w->in) ? take_positive(&w->in) : 0.0;
    }
    options.largest_radius = take_positive(&w->in);
    return options;
}

void fuzz_rates(world *w)
{
    double x[MOST_POINTS], out[6][MOST_POINTS], time = NAN, zone = NAN;
    int slot, status, n;
    const mdr_contact *contact = some_contact(w, &slot);
    const mdr_rate_options options = take_options(w);
    mdr_rate_state start = {0}, end = {0};
    mdr_rate *rate = NULL;

    n = take_count(&w->in);
    take_positives(&w->in, x);
    if (!afford(w, PRICE_OF_HISTORY + PRICE_OF_SAMPLES * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    fill(out[0]);
    judge("mdr_rate_work", mdr_rate_work(&options, n, x, out[0], NULL, NULL), n, out[0], NOT_NEGATIVE);
    status = mdr_rate_work(&options, 0, NULL, NULL, &time, &zone);
    judge_status("mdr_rate_work", status);
    if (status == MDR_SUCCESS && !(time >= 0.0 && zone >= 0.0)) finding("mdr_rate_work", "negative", zone);
    status = mdr_rate_new(contact, &options, &rate);
    judge_object("mdr_rate_new", status, rate);
    for (int i = 1; i < n; i++) x[i] += x[i - 1];
    start.radius = take_chance(&w->in) ? -1.0 : 0.0;
    for (int i = 0; i < 6; i++) fill(out[i]);
    status = mdr_rate_history(rate, TAKE_ONE_OF(&w->in, MDR_FORCE, MDR_DEPTH, MDR_SPRING), take_positive(&w->in), 1e-4, &start, n,
            x, x, out[0], out[1], out[2],
                              out[3], out[4], out[5], &end);
    judge("mdr_rate_history", status, n, out[0], FINITE);
    judge("mdr_rate_history", status, n, out[1], NOT_NEGATIVE);
    for (int i = 2; i < 6; i++) judge("mdr_rate_history", status, n, out[i], FINITE);
    judge_status("mdr_free", mdr_free(rate));
    for (int i = 0; i < 4; i++) fill(out[i]);
    status = mdr_contact_adhesive_history(contact, TAKE_ONE_OF(&w->in, MDR_FORCE, MDR_DEPTH, MDR_SPRING), take_positive(&w->in),
            1e-2, &start, n < 3 ? n : 2, x, x,
                                          out[0], out[1], out[2], out[3], &end);
    judge("mdr_contact_adhesive_history", status, n < 3 ? n : 2, out[0], FINITE);
    for (int i = 1; i < 3; i++) judge("mdr_contact_adhesive_history", status, n < 3 ? n : 2, out[i], NOT_NEGATIVE);
    judge("mdr_contact_adhesive_history", status, n < 3 ? n : 2, out[3], FINITE);
}
