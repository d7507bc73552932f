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
    const int control = TAKE_ONE_OF(&w->in, MDR_FORCE, MDR_DEPTH, MDR_SPRING);

    if (!afford(w, PRICE_OF_PULL_OFF * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    fill(d), fill(a), fill(F);
    status = pull_off_of(contact, control, 1, d, a, F, NULL);
    judge("mdr_contact_pull_off", status, 1, d, FINITE);
    judge("mdr_contact_pull_off", status, 1, a, NOT_NEGATIVE);
    judge("mdr_contact_pull_off", status, 1, F, FINITE);
    fill(d), fill(a), fill(F);
    status = pull_off_of(contact, control, MOST_POINTS, d, a, F, &count);
    if (status == MDR_SUCCESS && count < 0) finding("mdr_contact_pull_off", "no count", count);
    if (count > MOST_POINTS) count = MOST_POINTS;
    if (count == 0) count = 1; /* without adhesion the first is 0 */
    judge("mdr_contact_pull_off", status, count, d, FINITE);
    judge("mdr_contact_pull_off", status, count, a, NOT_NEGATIVE);
    judge("mdr_contact_pull_off", status, count, F, FINITE);
}

static void loop(world *w)
{
    mdr_loop_point points[MOST_POINTS];
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    int slot, status, count = 0, n;
    const mdr_contact *contact = some_contact(w, &slot);
    const int control = TAKE_ONE_OF(&w->in, MDR_FORCE, MDR_DEPTH, MDR_SPRING);
    const double spring = take_positive(&w->in), largest = take_positive(&w->in);
    mdr_loop *made = NULL;

    n = take_count(&w->in);
    if (!afford(w, PRICE_OF_LOOP * (w->contact_is_exact[slot] ? EXACT : 1))) return;
    status = mdr_loop_new(contact, control, largest, n + 1, spring, &made);
    judge_object("mdr_loop_new", status, made);
    if (made) {
        MDR_FREE(w->loop);
        w->loop = made;
    }
    if (!w->loop) return;
    status = mdr_loop_about(w->loop, &facts);
    judge_status("mdr_loop_about", status);
    if (status != MDR_SUCCESS) return;
    if (facts.points < 2 || facts.turning_point < 0 || facts.turning_point >= facts.points || facts.jumps < 0) {
        finding("mdr_loop_about", "absurd sizes", facts.points);
    }
    if (!isfinite(facts.dissipated_energy)) finding("mdr_loop_about", "not finite", facts.dissipated_energy);
    status = mdr_loop_points(w->loop, n, points, &count);
    judge_status("mdr_loop_points", status);
    if (count != facts.points) finding("mdr_loop_points", "another count", count);
    for (int i = 0; i < n && i < count && status == MDR_SUCCESS; i++) {
        const mdr_loop_point *p = &points[i];
        if (!isfinite(p->position + p->depth + p->force) || !(p->radius >= 0.0)) finding("mdr_loop_points", "no number", i);
    }
}

void fuzz_adhesion(world *w)
{
    enum { OLDER = 240 };
    const int byte = take_byte(&w->in);

    if (byte >= OLDER) fuzz_rates(w);
    else if (byte % 2 == 0) pull_off(w);
    else loop(w);
}
