/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_PULL_OFF = 6, PRICE_OF_LOOP = 20, EXACT = 4 };

static void pull_off(world *w)
{
    double d[MOST_POINTS], a[MOST_POINTS], F[MOST_POINTS];
    int slot, count = -1, status;
    const mdr_contact *contact = some_contact(w, &slot);
    const int control = take_choice(&w->in, 3);

    if (!afford(w, PRICE_OF_PULL_OFF * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    fill(d), fill(a), fill(F);
    status = mdr_contact_pull_off(contact, control, 1, d, a, F, NULL);
    judge("mdr_contact_pull_off", status, 1, d, FINITE);
    judge("mdr_contact_pull_off", status, 1, a, NOT_NEGATIVE);
    judge("mdr_contact_pull_off", status, 1, F, FINITE);
    fill(d), fill(a), fill(F);
    status = mdr_contact_pull_off(contact, control, MOST_POINTS, d, a, F, &count);
    if (status == MDR_SUCCESS && count < 0) finding("mdr_contact_pull_off", "no count", count);
    if (count > MOST_POINTS) count = MOST_POINTS;
    if (count == 0) count = 1; /* without adhesion the first is 0 */
    judge("mdr_contact_pull_off", status, count, d, FINITE);
    judge("mdr_contact_pull_off", status, count, a, NOT_NEGATIVE);
    judge("mdr_contact_pull_off", status, count, F, FINITE);
}

static void loop(world *w)
{
    double x[MOST_POINTS], d[MOST_POINTS], a[MOST_POINTS], F[MOST_POINTS], energy = NAN;
    int slot, status, points = 0, turn = 0, jumps = 0, index[MOST_POINTS], n;
    const mdr_contact *contact = some_contact(w, &slot);
    const int control = take_choice(&w->in, 3);
    const double spring = take_positive(&w->in), largest = take_positive(&w->in);
    mdr_loop *made = NULL;

    n = take_count(&w->in);
    if (!afford(w, PRICE_OF_LOOP * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    status = mdr_loop_new(contact, control, largest, n + 1, spring, &made);
    judge_object("mdr_loop_new", status, made);
    if (made) {
        mdr_loop_free(&w->loop);
        w->loop = made;
    }
    if (!w->loop) return;
    judge_status("mdr_loop_size", mdr_loop_size(w->loop, &points, &turn, &jumps));
    if (points < 2 || turn < 0 || turn >= points || jumps < 0) finding("mdr_loop_size", "absurd sizes", points);
    if (n > points) n = points;
    fill(x), fill(d), fill(a), fill(F);
    status = mdr_loop_path(w->loop, n, x, d, a, F);
    judge("mdr_loop_path", status, n, x, FINITE);
    judge("mdr_loop_path", status, n, d, FINITE);
    judge("mdr_loop_path", status, n, a, NOT_NEGATIVE);
    judge("mdr_loop_path", status, n, F, FINITE);
    judge_status("mdr_loop_jumps", mdr_loop_jumps(w->loop, n, index));
    status = mdr_loop_dissipated_energy(w->loop, &energy);
    judge_status("mdr_loop_dissipated_energy", status);
    if (status == MDR_SUCCESS && !isfinite(energy)) finding("mdr_loop_dissipated_energy", "not finite", energy);
}

void fuzz_adhesion(world *w)
{
    enum { OLDER = 240 };
    const int byte = take_byte(&w->in);

    if (byte >= OLDER) fuzz_rates(w);
    else if (byte % 2 == 0) pull_off(w);
    else loop(w);
}
