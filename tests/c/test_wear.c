/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wear: the end of fretting, the track, histories that go on from where they were, refusals. */
#include "check.h"
#include "mdrcontact/wear.h"

static const double k = 0.5;

static mdr_contact *hertz(void)
{
    mdr_profile *ball = NULL;
    mdr_medium *body = NULL;
    mdr_contact *contact = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &body));
    CHECK_SUCCESS(mdr_contact_new(ball, body, NULL, &contact));
    CHECK_FREE(ball);
    CHECK_FREE(body);
    return contact;
}

/* F = 2 (d c - c^3/3), and a worn indenter that bears it anew */
static void test_limit(const mdr_contact *contact)
{
    const double one = 1.0, c = 0.4, r[2] = {0.2, 5.0};
    double rim = 0.0, volume = 0.0, height[2];
    mdr_wear *wear = NULL;
    mdr_profile *worn = NULL;
    mdr_state state, end;

    CHECK_SUCCESS(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_LOADING, 1, &one, &state));
    CHECK_SUCCESS(mdr_wear_new(contact, 1, &k, NULL, 0.0, &wear));
    CHECK_SUCCESS(mdr_wear_limit(wear, &state, c, MDR_DEPTH, &end, &rim, &volume, &worn));
    CHECK_CLOSE(end.force, 2.0 * (c - c * c * c / 3.0), 1e-14);
    CHECK_CLOSE(end.radius, c, 0.0);
    CHECK_TRUE(rim > 1.0 && volume > 0.0);
    CHECK_SUCCESS(mdr_profile_values(worn, MDR_HEIGHT, 2, r, height));
    CHECK_CLOSE(height[0], 0.02, 1e-14);
    CHECK_CLOSE(height[1], 12.5, 1e-14);
    CHECK_SUCCESS(mdr_wear_limit(wear, &state, c, MDR_FORCE, &end, NULL, NULL, NULL));
    CHECK_CLOSE(end.force, state.force, 1e-14);
    CHECK_FREE(worn);
    CHECK_FREE(wear);
}

/* h = k N q, q = 2 sqrt... of Hertz: 1 - y^2 */
static void test_track(const mdr_contact *contact)
{
    const double one = 1.0, small = 1e-6, y[3] = {0.0, 0.5, 2.0};
    double depth[3], passes = 0.0;
    mdr_wear *wear = NULL;
    mdr_state state;

    CHECK_SUCCESS(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_LOADING, 1, &one, &state));
    CHECK_SUCCESS(mdr_wear_new(contact, 1, &k, NULL, small, &wear));
    CHECK_SUCCESS(mdr_wear_track(wear, &state, 100.0, 3, y, depth));
    CHECK_CLOSE(depth[0], 1e-4, 1e-12);
    CHECK_CLOSE(depth[1], 0.75e-4, 1e-12);
    CHECK_TRUE(depth[2] == 0.0);
    CHECK_SUCCESS(mdr_wear_passes(wear, &state, 0.01, &passes));
    CHECK_CLOSE(passes, 1e4, 1e-12);
    CHECK_STATUS(mdr_wear_passes(wear, &state, 0.2, &passes), MDR_EDOMAIN, "too deep");
    CHECK_FREE(wear);
}

static void test_history(const mdr_contact *contact)
{
    enum { MOST = 200 };
    const double sliding[2] = {0.2, 0.3}, force[2] = {1.0, 1.0}, more = 1.1, less = 0.2, r[2] = {0.0, 9.0};
    double numbers[MOST], other_numbers[MOST], pressure[2];
    int count = 0, other_count = 0;
    mdr_wear *wear = NULL;
    mdr_wear_history *h = NULL, *copy = NULL, *other = NULL;
    mdr_profile *worn = NULL;
    mdr_wear_state states[2], now;
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);

    options.intervals = 40;

    CHECK_SUCCESS(mdr_wear_new(contact, 1, &k, NULL, 0.0, &wear));
    CHECK_SUCCESS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h));
    CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 2, sliding, force, states));
    CHECK_CLOSE(states[1].work, 0.5, 1e-9);
    CHECK_CLOSE(states[1].worn_volume, k * 0.5, 1e-3);
    CHECK_SUCCESS(mdr_wear_history_state(h, 0, NULL, &now, NULL));
    CHECK_TRUE(now.radius == states[1].radius && now.sliding == 0.5 && now.error < 1e-2);
    CHECK_SUCCESS(mdr_wear_history_save(h, 0, NULL, &count));
    CHECK_TRUE(count > 0 && count < MOST);
    CHECK_SUCCESS(mdr_wear_history_save(h, MOST, numbers, &count));
    CHECK_SUCCESS(mdr_wear_history_copy(h, &copy));
    CHECK_SUCCESS(mdr_wear_history_new(wear, MDR_FORCE, 0.1, &options, &other));
    CHECK_SUCCESS(mdr_wear_history_restore(other, count, numbers));
    CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 1, sliding, &more, states));
    CHECK_SUCCESS(mdr_wear_history_save(h, MOST, numbers, &count));
    CHECK_SUCCESS(mdr_wear_history_advance(copy, MDR_FORCE, 1, sliding, &more, states));
    CHECK_SUCCESS(mdr_wear_history_save(copy, MOST, other_numbers, &other_count));
    CHECK_TRUE(count == other_count && !memcmp(numbers, other_numbers, (size_t)count * sizeof *numbers));
    CHECK_SUCCESS(mdr_wear_history_advance(other, MDR_FORCE, 1, sliding, &more, states));
    CHECK_SUCCESS(mdr_wear_history_save(other, MOST, other_numbers, &other_count));
    CHECK_TRUE(!memcmp(numbers, other_numbers, (size_t)count * sizeof *numbers));
    CHECK_SUCCESS(mdr_wear_history_state(h, 2, r, NULL, pressure));
    CHECK_TRUE(pressure[0] > 0.0 && pressure[1] == 0.0);
    CHECK_SUCCESS(mdr_wear_history_profile(h, &worn));
    CHECK_FREE(worn);
    /* the second part fails: the first has not been either */
    CHECK_STATUS(mdr_wear_history_advance(h, MDR_FORCE, 1, sliding, &less, states), MDR_EDOMAIN, "entry 1");
    CHECK_SUCCESS(mdr_wear_history_save(h, MOST, other_numbers, &other_count));
    CHECK_TRUE(!memcmp(numbers, other_numbers, (size_t)count * sizeof *numbers));
    CHECK_STATUS(mdr_wear_history_restore(h, 3, numbers), MDR_EINVALID, "do not belong to a history");
    CHECK_STATUS(mdr_wear_history_restore(h, 3, NULL), MDR_ENULL, "numbers");
    CHECK_STATUS(mdr_wear_history_state(h, 1, &less, NULL, NULL), MDR_ENULL, "pressure");
    CHECK_STATUS(mdr_wear_history_advance(h, MDR_FORCE, -1, sliding, force, states), MDR_EINVALID, "n = -1");
    CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 0, NULL, NULL, NULL));
    CHECK_STATUS(mdr_wear_history_advance(h, MDR_RADIUS, 1, sliding, force, states), MDR_EINVALID, "control = 103 (radius)");
    CHECK_FREE(h);
    CHECK_FREE(copy);
    CHECK_FREE(other);
    CHECK_FREE(wear);
}

/* Rings follow a load that falls; what is worn off is k F s to rounding. */
static void test_rings(const mdr_contact *contact)
{
    const double sliding[3] = {0.2, 0.1, 0.3}, force[3] = {1.0, 0.1, 0.1};
    mdr_wear *wear = NULL;
    mdr_wear_history *h = NULL;
    mdr_wear_state states[3];
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);

    options.scheme = MDR_WEAR_RINGS;
    CHECK_SUCCESS(mdr_wear_new(contact, 1, &k, NULL, 0.0, &wear));
    CHECK_SUCCESS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h));
    CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 3, sliding, force, states));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(states[i].worn_volume, k * states[i].work, 1e-12);
    CHECK_TRUE(states[1].radius < states[0].radius && states[2].radius > 0.0);
    CHECK_FREE(h);
    CHECK_FREE(wear);
}

static int enough(void *looks)
{
    return ++*(int *)looks > 0;
}

/* Ended halfway, a path leaves the history as it was, by either scheme; the part that is done grows. */
static void test_cancel(const mdr_contact *contact)
{
    const double far = 100.0, near = 0.01, force = 1.0;
    mdr_wear *wear = NULL;

    CHECK_SUCCESS(mdr_wear_new(contact, 1, &k, NULL, 0.0, &wear));
    for (int scheme = MDR_WEAR_DISC; scheme <= MDR_WEAR_RINGS; scheme++) {
        mdr_wear_options options = MDR_SIZED(mdr_wear_options);
        mdr_wear_history *h = NULL;
        mdr_wear_state before, after;
        double part = 0.0;
        int looks = 0;

        options.scheme = scheme;
        options.intervals = scheme == MDR_WEAR_DISC ? 160 : 320;
        CHECK_SUCCESS(mdr_wear_history_new(wear, MDR_FORCE, force, &options, &h));
        CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 1, &near, &force, &before));
        CHECK_SUCCESS(mdr_set_cancel(enough, &looks));
        CHECK_SUCCESS(mdr_set_progress(&part));
        CHECK_STATUS(mdr_wear_history_advance(h, MDR_FORCE, 1, &far, &force, &after), MDR_ECANCELLED, "");
        CHECK_SUCCESS(mdr_set_cancel(NULL, NULL));
        CHECK_TRUE(looks > 0 && part < 1.0);
        CHECK_SUCCESS(mdr_wear_history_state(h, 0, NULL, &after, NULL));
        CHECK_TRUE(!memcmp(&before, &after, sizeof before));
        CHECK_SUCCESS(mdr_wear_history_advance(h, MDR_FORCE, 1, &near, &force, &after));
        CHECK_TRUE(part == 1.0 && after.sliding == near + near);
        CHECK_SUCCESS(mdr_set_progress(NULL));
        CHECK_FREE(h);
    }
    CHECK_FREE(wear);
}

static void test_refusals(const mdr_contact *contact)
{
    const double bad = -1.0, one = 1.0, layers[2] = {1.0, 2.0};
    double out = 7.0;
    mdr_wear *wear = NULL;
    mdr_wear_history *h = NULL;
    mdr_material *other = NULL;
    mdr_state state;
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);

    CHECK_STATUS(mdr_wear_new(contact, 1, &bad, NULL, 0.0, &wear), MDR_EINVALID, "coefficient = -1");
    CHECK_STATUS(mdr_wear_new(contact, 0, &one, NULL, 0.0, &wear), MDR_EINVALID, "n = 0");
    CHECK_STATUS(mdr_wear_new(contact, 2, layers, NULL, 0.0, &wear), MDR_ENULL, "thickness");
    CHECK_STATUS(mdr_wear_new(contact, 2, layers, &bad, 0.0, &wear), MDR_EINVALID, "thickness = -1");
    CHECK_STATUS(mdr_wear_new(contact, 1, &one, NULL, NAN, &wear), MDR_EINVALID, "body_coefficient");
    CHECK_STATUS(mdr_wear_new(contact, 1, NULL, NULL, 0.0, &wear), MDR_ENULL, "coefficient");
    CHECK_STATUS(mdr_wear_new(NULL, 1, &one, NULL, 0.0, &wear), MDR_ENULL, "c");
    CHECK_STATUS(mdr_wear_new(contact, 1, &one, NULL, 0.0, NULL), MDR_ENULL, "out");
    CHECK_TRUE(wear == NULL);
    CHECK_SUCCESS(mdr_wear_new(contact, 1, &one, NULL, 0.0, &wear));
    CHECK_SUCCESS(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_LOADING, 1, &one, &state));
    CHECK_STATUS(mdr_wear_limit(wear, &state, 2.0, MDR_DEPTH, &state, NULL, NULL, NULL), MDR_EDOMAIN, "stick_radius = 2");
    CHECK_STATUS(mdr_wear_limit(wear, &state, 0.5, MDR_RADIUS, &state, NULL, NULL, NULL), MDR_EINVALID, "control = 103 (radius)");
    CHECK_STATUS(mdr_wear_limit(wear, NULL, 0.5, MDR_DEPTH, &state, NULL, NULL, NULL), MDR_ENULL, "state");
    CHECK_STATUS(mdr_wear_limit(wear, &state, 0.5, MDR_DEPTH, NULL, NULL, NULL, NULL), MDR_ENULL, "reached");
    CHECK_STATUS(mdr_wear_track(wear, &state, 1.0, 1, &one, &out), MDR_EINVALID, "body_coefficient");
    CHECK_STATUS(mdr_wear_track(wear, &state, 1.0, 1, NULL, &out), MDR_ENULL, "y");
    CHECK_STATUS(mdr_wear_passes(wear, &state, 1.0, NULL), MDR_ENULL, "passes");
    options.intervals = 42;
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h), MDR_EINVALID, "multiple of 4");
    options.intervals = 4;
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h), MDR_EINVALID, "intervals = 4");
    options.intervals = 40;
    CHECK_STATUS(mdr_wear_running_in(wear, MDR_FORCE, &out), MDR_EINVALID, "flat punch");
    CHECK_STATUS(mdr_wear_running_in(wear, MDR_FORCE, NULL), MDR_ENULL, "length");
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 0.0, &options, &h), MDR_EINVALID, "force = 0");
    options.places = 3;
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h), MDR_EINVALID, "places = 3");
    options.places = 0;
    options.scheme = 3;
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h), MDR_EINVALID, "scheme = 3");
    options.size = 1;
    CHECK_STATUS(mdr_wear_history_new(wear, MDR_FORCE, 1.0, &options, &h), MDR_EINVALID, "options->size");
    CHECK_STATUS(mdr_wear_history_new(NULL, MDR_FORCE, 1.0, NULL, &h), MDR_ENULL, "w");
    CHECK_STATUS(mdr_wear_history_copy(NULL, &h), MDR_ENULL, "h");
    CHECK_STATUS(mdr_wear_history_state(h, 0, NULL, NULL, NULL), MDR_ENULL, "h");
    CHECK_STATUS(mdr_wear_history_profile(h, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_wear_history_save(h, 0, NULL, NULL), MDR_ENULL, "h");
    CHECK_TRUE(h == NULL && out == 7.0);
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &other));
    CHECK_STATUS(mdr_wear_passes((mdr_wear *)other, &state, 1.0, &out), MDR_EINVALID, "mdr_wear");
    CHECK_FREE(other);
    CHECK_FREE(wear);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_SUCCESS(mdr_free(NULL));
}

int main(void)
{
    mdr_contact *contact = hertz();
    test_limit(contact);
    test_track(contact);
    test_history(contact);
    test_rings(contact);
    test_cancel(contact);
    test_refusals(contact);
    CHECK_FREE(contact);
    return check_report("wear");
}
