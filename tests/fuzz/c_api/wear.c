/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wear: the end of fretting, tracks, and histories of sliding. */
#include "world.h"

#include <stddef.h>

enum { PRICE_OF_WEAR = 8, PRICE_OF_HISTORY = 30, MOST_LAYERS = 3, INTERVALS = 16, MOST_NUMBERS = 80 };

static void march(world *w, const mdr_wear *wear, const mdr_state *state)
{
    const int given = TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE), n = take_count(&w->in) % 3;
    double sliding[MOST_POINTS], value[MOST_POINTS], out[MOST_POINTS], numbers[MOST_NUMBERS];
    mdr_wear_state found[MOST_POINTS];
    mdr_wear_history *h = NULL, *copy = NULL;
    mdr_profile *worn = NULL;
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);
    int status, count = 0;

    options.intervals = INTERVALS;
    options.places = TAKE_ONE_OF(&w->in, MDR_WEAR_FRESH, MDR_WEAR_SAME);
    options.scheme = TAKE_ONE_OF(&w->in, MDR_WEAR_DISC, MDR_WEAR_RINGS);
    take_positives(&w->in, sliding);
    for (int i = 0; i < MOST_POINTS; i++) value[i] = given == MDR_DEPTH ? state->depth : state->force;
    status = mdr_wear_history_new(wear, given, value[0], &options, &h);
    judge_object("mdr_wear_history_new", status, h);
    if (!h) return;
    judge_status("mdr_wear_history_advance", mdr_wear_history_advance(h, given, n, sliding, value, found));
    judge_status("mdr_wear_history_state", mdr_wear_history_state(h, 0, NULL, found, NULL));
    fill(out);
    judge("mdr_wear_history_state", mdr_wear_history_state(h, n, sliding, NULL, out), n, out, FINITE);
    status = mdr_wear_history_profile(h, &worn);
    judge_object("mdr_wear_history_profile", status, worn);
    judge_status("mdr_free", mdr_free(worn));
    judge_status("mdr_wear_history_save", mdr_wear_history_save(h, MOST_NUMBERS, numbers, &count));
    status = mdr_wear_history_copy(h, &copy);
    judge_object("mdr_wear_history_copy", status, copy);
    if (copy) judge_status("mdr_wear_history_restore", mdr_wear_history_restore(copy, count, numbers));
    judge_status("mdr_free", mdr_free(h));
    judge_status("mdr_free", mdr_free(copy));
}

void fuzz_wear(world *w)
{
    const int n = take_choice(&w->in, MOST_LAYERS + 1), points = take_count(&w->in);
    const double body = take_chance(&w->in) ? take_number(&w->in) : 1e-3, passes = take_number(&w->in), part = take_number(&w->in);
    double coefficient[MOST_POINTS], thickness[MOST_POINTS], y[MOST_POINTS], out[MOST_POINTS], rim = 0.0, volume = 0.0;
    mdr_wear *wear = NULL;
    mdr_profile *worn = NULL;
    mdr_state state, reached;
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);

    take_positives(&w->in, coefficient);
    take_positives(&w->in, thickness);
    take_positives(&w->in, y);
    if (!afford(w, PRICE_OF_WEAR)) return;
    status = mdr_wear_new(contact, n, coefficient, thickness, body, &wear);
    judge_object("mdr_wear_new", status, wear);
    if (!wear) return;
    state = some_state(w, contact);
    fill(out);
    judge("mdr_wear_track", mdr_wear_track(wear, &state, passes, points, y, out), points, out, FINITE);
    judge_status("mdr_wear_passes", mdr_wear_passes(wear, &state, y[0], &rim));
    judge_status("mdr_wear_limit", mdr_wear_limit(wear, &state, part * state.radius, TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE),
            &reached, &rim, &volume,
                                                  &worn));
    judge_status("mdr_free", mdr_free(worn));
    judge_status("mdr_wear_running_in", mdr_wear_running_in(wear, TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE), &rim));
    if (afford(w, PRICE_OF_HISTORY)) march(w, wear, &state);
    judge_status("mdr_free", mdr_free(wear));
}
