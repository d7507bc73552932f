/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_ADHESION = 10 };

void fuzz_contacts(world *w)
{
    input *in = &w->in;
    const int slot = take_byte(in) % SLOTS;
    const mdr_profile *profile = some_profile(w);
    const mdr_medium *medium = some_medium(w);
    const mdr_contact_options *chosen = NULL;
    double zeta_radius[MOST_POINTS], zeta[MOST_POINTS];
    mdr_contact_options options;
    mdr_contact *made = NULL;
    int status, is_exact = 0;

    for (int i = 0; i < SLOTS; i++) is_exact = is_exact || (medium && medium == w->media[i] && w->medium_is_exact[i]);
    options = MDR_SIZED(mdr_contact_options);
    if (take_byte(in) % 3 == 0) {
        chosen = &options;
        if (!afford(w, is_exact ? 4 * PRICE_OF_ADHESION : PRICE_OF_ADHESION)) return;
        options.work_of_adhesion = take_positive(in);
        options.adhesion_rule = TAKE_ONE_OF(in, MDR_ADHESION_AUTOMATIC, MDR_ADHESION_PAPER, MDR_ADHESION_ENERGY);
        if (take_byte(in) % 5 == 0) {
            if (!afford(w, is_exact ? 20 * PRICE_OF_ADHESION : 2 * PRICE_OF_ADHESION)) return;
            options.cohesive_stress = take_positive(in);
        }
        if (take_chance(in)) {
            options.zeta_count = take_count(in);
            take_ascending(in, zeta_radius);
            take_positives(in, zeta);
            options.zeta_radius = take_chance(in) ? NULL : zeta_radius;
            options.zeta = take_chance(in) ? NULL : zeta;
        }
    }
    status = mdr_contact_new(profile, medium, chosen, &made);
    judge_object("mdr_contact_new", status, made);
    if (!made) return;
    MDR_FREE(w->contacts[slot]);
    w->contacts[slot] = made;
    w->contact_is_exact[slot] = is_exact;
    w->contact_is_adhesive[slot] = options.work_of_adhesion > 0.0;
}
