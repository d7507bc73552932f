/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <stddef.h>

enum { PRICE_OF_FIELD = 2, PRICE_OF_EXACT_FIELD = 12 };

/* p(r), u(r) and q(x), at a contact radius or at a depth, at positions that often lie within the contact. */
void fuzz_fields(world *w)
{
    const int which = take_byte(&w->in) % 6, inside = take_byte(&w->in) % 2;
    const double at = take_positive(&w->in);
    double r[MOST_POINTS], out[MOST_POINTS], radius = at;
    mdr_state state = {at, at, at, at, 0.0, 0.0};
    int slot, n = take_count(&w->in);
    const mdr_contact *contact = some_contact(w, &slot);

    take_positives(&w->in, r);
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_FIELD : PRICE_OF_FIELD)) return;
    if (mdr_contact_states(contact, which < 3 ? MDR_RADIUS : MDR_DEPTH, MDR_ON_UNLOADING, 1, &at, &state) == MDR_SUCCESS) {
        radius = state.radius;
    } else if (take_chance(&w->in)) {
        state.punch_depth = take_number(&w->in); /* no state of this contact */
        state.radius = take_number(&w->in);
    }
    if (inside) {
        for (int i = 0; i < MOST_POINTS; i++) r[i] = r[i] < 1e4 ? radius * (r[i] / 1e4) : r[i];
        r[0] = radius;
        r[1] = 0.0;
    }
    fill(out);
    judge("mdr_load_field", state_field(contact, MDR_PRESSURE + (take_chance(&w->in) ? 3 + which % 2 : which % 3),
            &state, n, r, out), n, out, NOT_NAN);
}
