/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <stddef.h>

static int make(world *w, mdr_profile **out)
{
    input *in = &w->in;
    double x[MOST_POINTS], y[MOST_POINTS];
    const mdr_profile *terms[3];
    user_function f;
    double p, q;
    int n;

    switch (take_byte(in) % 13) {
    case 0: return mdr_profile_paraboloid(take_positive(in), out);
    case 1: return mdr_profile_sphere(take_positive(in), out);
    case 2: return mdr_profile_cone(take_positive(in), out);
    case 3:
        p = take_positive(in);
        return mdr_profile_power(p, take_positive(in), out);
    case 4: return mdr_profile_flat_punch(take_positive(in), out);
    case 5:
        p = take_positive(in);
        return mdr_profile_flat_cone(p, take_positive(in), out);
    case 6:
        p = take_positive(in);
        return mdr_profile_flat_paraboloid(p, take_positive(in), out);
    case 7:
        p = take_positive(in);
        return mdr_profile_rounded_cone(p, take_positive(in), out);
    case 8:
        n = take_count(in);
        p = take_chance(in) ? take_number(in) : 0.0;
        q = take_positive(in);
        take_positives(in, x);
        return mdr_profile_area_function(n, x, p, q, out);
    case 9:
    case 10:
        n = take_count(in);
        p = take_byte(in);
        take_ascending(in, x);
        take_ascending(in, y);
        return p < 128 ? mdr_profile_table(MDR_HEIGHT, n, x, y, out) : mdr_profile_table(MDR_G, n, x, y, out);
    case 11:
        f = take_function(in);
        return afford(w, 4) ? mdr_profile_function(call_function, &f, take_positive(in), out) : MDR_ENULL;
    default:
        n = take_byte(in) % 4;
        for (int i = 0; i < n; i++) terms[i] = some_profile(w);
        return afford(w, 4) ? mdr_profile_sum(n, terms, out) : MDR_ENULL;
    }
}

/* f, f', g and g' at any points. */
static void evaluate(world *w, const mdr_profile *profile)
{
    static const int quantities[] = {MDR_HEIGHT, MDR_HEIGHT_SLOPE, MDR_G, MDR_G_SLOPE};
    double x[MOST_POINTS], out[MOST_POINTS];
    const int n = take_count(&w->in);

    take_positives(&w->in, x);
    for (int i = 0; i < 4; i++) {
        fill(out);
        /* g may fall where f only just rises: its slope has any sign */
        judge("mdr_profile_values", mdr_profile_values(profile, quantities[i], n, x, out), n, out,
              i == 3 ? NOT_NAN : UP_TO_INFINITY);
    }
    judge_status("mdr_profile_values", mdr_profile_values(profile, MDR_HEIGHT, n, NULL, out));
}

void fuzz_profiles(world *w)
{
    const int slot = take_byte(&w->in) % SLOTS;
    mdr_profile *made = NULL;
    const int status = make(w, &made);

    if (made || status != MDR_ENULL) judge_object("mdr_profile_...", status, made);
    if (made) {
        MDR_FREE(w->profiles[slot]);
        w->profiles[slot] = made;
    }
    evaluate(w, some_profile(w));
}
