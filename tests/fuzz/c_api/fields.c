/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <stddef.h>

enum { PRICE_OF_FIELD = 2, PRICE_OF_EXACT_FIELD = 12 };

/* p(r), u(r) and q(x), at a contact radius or at a depth, at positions that often lie within the contact. */
void fuzz_fields(world *w)
{
    static int (*const calls[])(const mdr_contact *, double, int, const double[], double[]) = {
        mdr_contact_pressure, mdr_contact_displacement, mdr_contact_line_load,
        mdr_contact_pressure_at_depth, mdr_contact_displacement_at_depth, mdr_contact_line_load_at_depth
    };
    static const char *const names[] = {
        "mdr_contact_pressure", "mdr_contact_displacement", "mdr_contact_line_load",
        "mdr_contact_pressure_at_depth", "mdr_contact_displacement_at_depth", "mdr_contact_line_load_at_depth"
    };
    const int which = take_byte(&w->in) % 6, inside = take_byte(&w->in) % 2;
    const double at = take_positive(&w->in);
    double r[MOST_POINTS], out[MOST_POINTS], radius = at;
    int slot, n = take_count(&w->in);
    const mdr_contact *contact = some_contact(w, &slot);

    take_positives(&w->in, r);
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_FIELD : PRICE_OF_FIELD)) return;
    if (inside) {
        if (which > 2) mdr_contact_from_depth(contact, 1, &at, NULL, &radius, NULL, NULL);
        for (int i = 0; i < MOST_POINTS; i++) r[i] = r[i] < 1e4 ? radius * (r[i] / 1e4) : r[i];
        r[0] = radius;
        r[1] = 0.0;
    }
    fill(out);
    judge(names[which], calls[which](contact, at, n, r, out), n, out, NOT_NAN);
}
