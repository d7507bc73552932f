/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_STATE = 1, PRICE_OF_EXACT_STATE = 6 };

static int call(const mdr_contact *c, int which, int branch, int n, const double in[], double d[], double a[], double F[],
                double k[])
{
    mdr_state states[MOST_POINTS];
    double slopes[MOST_POINTS];
    int status;

    switch (which) {
    case 0: return columns_of(c, MDR_DEPTH, n, in, d, a, F, k);
    case 1: return columns_of(c, MDR_FORCE, n, in, d, a, F, k);
    case 2: return columns_of(c, MDR_RADIUS, n, in, d, a, F, k);
    default: break;
    }
    status = mdr_contact_states(c, which == 3 ? MDR_DEPTH : MDR_FORCE, branch, n, in, states);
    for (int i = 0; i < n && status == MDR_SUCCESS && d != NULL; i++) {
        d[i] = states[i].depth, a[i] = states[i].radius, F[i] = states[i].force, k[i] = states[i].stiffness;
    }
    fill(slopes);
    if (status == MDR_SUCCESS) judge("mdr_contact_slope", mdr_contact_slope(c, n, states, slopes), n, slopes, FINITE);
    return status;
}

/* What was requested is what is there. */
static void compare(const char *name, int n, const double wanted[], const double found[], double scale)
{
    for (int i = 0; i < n; i++) {
        if (fabs(found[i] - wanted[i]) > 1e-6 * (fabs(wanted[i]) + scale)) finding(name, "another state than requested", found[i]);
    }
}

void fuzz_states(world *w)
{
    static const char *const names[] = {
        "mdr_contact_states", "mdr_contact_states", "mdr_contact_states", "mdr_contact_states", "mdr_contact_states"
    };
    double in[MOST_POINTS], d[MOST_POINTS], a[MOST_POINTS], F[MOST_POINTS], k[MOST_POINTS];
    const int which = take_byte(&w->in) % 5, branch = which < 3 ? 0 : TAKE_ONE_OF(&w->in, MDR_ON_LOADING, MDR_ON_UNLOADING);
    int slot, status, n = take_count(&w->in);
    const mdr_contact *contact = some_contact(w, &slot);
    enum judgement sign;

    take_positives(&w->in, in);
    if (w->contact_is_exact[slot] && n > 2) n = 2;
    if (!afford(w, n * (w->contact_is_exact[slot] ? PRICE_OF_EXACT_STATE : PRICE_OF_STATE))) return;
    sign = w->contact_is_adhesive[slot] ? FINITE : NOT_NEGATIVE;
    fill(d), fill(a), fill(F), fill(k);
    status = call(contact, which, branch, n, in, d, a, F, k);
    judge(names[which], status, n, d, sign);
    judge(names[which], status, n, a, NOT_NEGATIVE);
    judge(names[which], status, n, F, sign);
    judge(names[which], status, n, k, NOT_NEGATIVE);
    if (status == MDR_SUCCESS && sign == NOT_NEGATIVE) {
        compare(names[which], n, in, which == 2 ? a : which % 3 == 0 ? d : F, 0.0);
    }
    status = call(contact, which, branch, n, in, NULL, NULL, NULL, NULL);
    judge_status(names[which], status);
}
