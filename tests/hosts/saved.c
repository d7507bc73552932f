/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that restores histories of wear from numbers that are not theirs: of other contacts and altered ones, all refused, and
 * forged ones with their checksum, which are refused, or continue to finite states within their time.
 */
#include "../c/check.h"
#include "forge.h"
#include "mdrcontact/wear.h"

#include <time.h>

enum { MOST = 4000, OTHERS = 7 };

static double saved[MOST], numbers[MOST], again[MOST];

/* A contact that wears: 0 the one whose past is saved, the others differ from it in one property each. */
static mdr_wear_history *new_history(int which, int scheme)
{
    const double k[2] = {which == 3 ? 0.02 : 0.01, 0.2}, thickness[1] = {0.05};
    const mdr_layer film = mdr_isotropic(which == 4 ? 6.0 : 5.0, 0.3, which == 5 ? 0.6 : 0.5), below = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);
    mdr_profile *tip = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_wear *wear = NULL;
    mdr_wear_history *history = NULL;

    options.intervals = 40;
    options.scheme = scheme;
    if (which == 1) CHECK_SUCCESS(mdr_profile_cone(0.2, &tip));
    if (which != 1) CHECK_SUCCESS(mdr_profile_paraboloid(which == 2 ? 1.1 : 1.0, &tip));
    CHECK_SUCCESS(mdr_body_layered(1, &film, &below, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(tip, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_wear_new(contact, which == 6 ? 2 : 1, k, thickness, which == 7 ? 0.005 : 0.0, &wear));
    if (which == 7) options.places = MDR_WEAR_SAME;
    CHECK_SUCCESS(mdr_wear_history_new(wear, MDR_FORCE, 0.2, &options, &history));
    CHECK_FREE(wear);
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(tip);
    return history;
}

static double seconds(void) { return (double)clock() / CLOCKS_PER_SEC; }

/* What follows from an altered number: a refusal; and with the checksum: a refusal, or a state soon. */
static void try_altered(mdr_wear_history *h, int count, int place, double value, int *refused)
{
    const double sliding = 0.1, force = 0.25, begin = seconds();
    mdr_wear_state state;

    memcpy(numbers, saved, sizeof numbers);
    numbers[place] = value;
    CHECK_STATUS(mdr_wear_history_restore(h, count, numbers), MDR_EINVALID, "numbers: they");
    if (place < count - 1) numbers[count - 1] = mark_of(numbers, (size_t)count - 1);
    if (mdr_wear_history_restore(h, count, numbers) != MDR_SUCCESS) {
        ++*refused;
        return;
    }
    if (mdr_wear_history_advance(h, MDR_FORCE, 1, &sliding, &force, &state) == MDR_SUCCESS) {
        CHECK_TRUE(isfinite(state.radius) && isfinite(state.depth) && isfinite(state.worn_volume));
    }
    CHECK_TRUE(seconds() - begin < 3.0);
}

static void run(int scheme)
{
    static const double altered[] = {-1.0, 1.6e155, 1e-300, 1e3, 0.0};
    const double sliding[2] = {0.2, 0.5}, force[2] = {0.2, 0.3};
    mdr_wear_history *first = new_history(0, scheme), *h = new_history(0, scheme);
    mdr_wear_state states[2];
    int count = 0, tried = 0, refused = 0, unused = 0;

    CHECK_SUCCESS(mdr_wear_history_advance(first, MDR_FORCE, 2, sliding, force, states));
    CHECK_SUCCESS(mdr_wear_history_save(first, MOST, saved, &count));
    CHECK_TRUE(count > 0 && count < MOST);
    CHECK_SUCCESS(mdr_wear_history_restore(h, count, saved));
    CHECK_SUCCESS(mdr_wear_history_save(h, MOST, again, &count));
    CHECK_TRUE(memcmp(saved, again, (size_t)count * sizeof *saved) == 0);
    for (int which = 1; which <= OTHERS; which++) {
        mdr_wear_history *other = new_history(which, scheme);
        CHECK_STATUS(mdr_wear_history_restore(other, count, saved), MDR_EINVALID, "do not belong to a history of this contact");
        CHECK_FREE(other);
    }
    for (int place = 0; place < count; place++) {
        /* a negative number, one of another size: none of them is what wear leaves, but for zeros that stay zeros */
        for (int i = 0; i < (int)(sizeof altered / sizeof *altered); i++) {
            if (saved[place] == altered[i] || (i == 2 && saved[place] == 0.0)) continue;
            tried++;
            try_altered(h, count, place, altered[i], &refused);
        }
        if (place > 0 && saved[place - 1] != saved[place]) try_altered(h, count, place, saved[place - 1], &unused);
        try_altered(h, count, place, NAN, &unused);
    }
    printf("saved: %d of %d pasts with a valid checksum refused\n", refused, tried);
    CHECK_TRUE(refused > 0.8 * tried);
    CHECK_FREE(first);
    CHECK_FREE(h);
}

int main(void)
{
    run(MDR_WEAR_DISC);
    run(MDR_WEAR_RINGS);
    return check_report("saved");
}
