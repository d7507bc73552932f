/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Laws of contacts that yield: Hertz up to yield, imprints, energies, the inline functions, refusals. */
#include "check.h"
#include "mdrcontact/plastic.h"

#include "mdrcontact_plastic_law.h"

static const double E = 1.0, nu = 0.3, Y = 1e-4, R = 1.0;

static mdr_yielding *metal_of(double stress)
{
    const double strain = 0.0;
    mdr_yielding *metal = NULL;
    CHECK_SUCCESS(mdr_yielding_new(E, nu, 1, &strain, &stress, &metal));
    return metal;
}

static mdr_profile *ball(void)
{
    mdr_profile *profile = NULL;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &profile));
    return profile;
}

static mdr_plastic_law *law_of(double largest_depth, const mdr_plastic_law_options *options)
{
    mdr_yielding *metal = metal_of(Y);
    mdr_profile *profile = ball();
    mdr_plastic_law *law = NULL;
    CHECK_SUCCESS(mdr_plastic_law_new(profile, metal, largest_depth, options, &law));
    CHECK_FREE(metal);
    CHECK_FREE(profile);
    return law;
}

/* F = 4/3 E* sqrt(R) d^1.5 up to L_y = 2.5333749, beyond it less; unloading along 2 E* a */
static void test_path(void)
{
    const double star = E / (1.0 - nu * nu);
    mdr_plastic_law *law = law_of(1e-5, NULL);
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    double memory[2] = {0.0, 0.0}, F[2], slope[2], a[2], stored[2], lost[2], work[2], left[2];

    CHECK_SUCCESS(mdr_plastic_law_about(law, &facts));
    CHECK_CLOSE(facts.first_yield, 2.5333749169681, 1e-12);
    const double a_y = facts.first_yield * R * Y / star;
    CHECK_CLOSE(facts.yield_depth, a_y * a_y / R, 1e-12);
    CHECK_CLOSE(facts.yield_force, 4.0 / 3.0 * star * a_y * a_y * a_y / R, 1e-12);
    CHECK_INT(facts.memory_size, 1);
    CHECK_CLOSE(facts.modulus, star, 1e-15);

    const double small = 0.5 * facts.yield_depth, d[2] = {small, 1e-5}, back[2] = {0.25 * small, 0.9e-5}, apart[2] = {-1.0, 1e-6};
    CHECK_SUCCESS(mdr_plastic_law_advance(law, 2, d, 1, memory, F, slope, a));
    CHECK_TRUE(memory[0] == 0.0 && memory[1] == 0.0);
    CHECK_SUCCESS(mdr_plastic_law_advance(law, 2, d, 0, memory, F, slope, a));
    CHECK_TRUE(memory[0] == d[0] && memory[1] == d[1]);
    CHECK_CLOSE(F[0], 4.0 / 3.0 * star * sqrt(R) * small * sqrt(small), 1e-10);
    CHECK_CLOSE(F[1], facts.largest_force, 1e-9);
    CHECK_CLOSE(a[1], facts.largest_radius, 1e-9);
    CHECK_TRUE(slope[1] < 2.0 * star * a[1]);
    CHECK_SUCCESS(mdr_plastic_law_loading(law, 2, d, NULL, NULL, left, work));
    CHECK_TRUE(left[0] == 0.0 && left[1] > 0.5 * d[1] && left[1] < d[1]);
    CHECK_SUCCESS(mdr_plastic_law_energies(law, 2, d, memory, stored, lost));
    CHECK_CLOSE(stored[1] + lost[1], work[1], 1e-14);
    CHECK_TRUE(lost[0] == 0.0 && lost[1] > 0.0);

    CHECK_SUCCESS(mdr_plastic_law_advance(law, 2, back, 0, memory, F, slope, a));
    CHECK_CLOSE(F[0], 4.0 / 3.0 * star * sqrt(R) * back[0] * sqrt(back[0]), 1e-10);
    CHECK_CLOSE(slope[1], 2.0 * star * a[1], 1e-14);
    CHECK_TRUE(memory[1] == d[1]);
    CHECK_SUCCESS(mdr_plastic_law_advance(law, 2, apart, 0, memory, F, NULL, NULL));
    CHECK_TRUE(F[0] == 0.0 && F[1] == 0.0 && memory[1] == d[1]);
    CHECK_SUCCESS(mdr_plastic_law_energies(law, 2, apart, memory, stored, lost));
    CHECK_TRUE(stored[0] == 0.0 && stored[1] == 0.0);
    /* outputs may lie on the input */
    double both[2] = {d[0], d[1]};
    CHECK_SUCCESS(mdr_plastic_law_advance(law, 2, both, 0, memory, both, NULL, NULL));
    CHECK_CLOSE(both[1], facts.largest_force, 1e-9);
    CHECK_FREE(law);
}

/* e of an elastic impact is 1, of a plastic one sqrt(U/W) */
static void test_restitution(void)
{
    mdr_plastic_law *law = law_of(1e-5, NULL);
    const double d = 0.8e-5, memory = d;
    double work, stored, lost, e[2];

    CHECK_SUCCESS(mdr_plastic_law_loading(law, 1, &d, NULL, NULL, NULL, &work));
    CHECK_SUCCESS(mdr_plastic_law_energies(law, 1, &d, &memory, &stored, &lost));
    const double speed[2] = {1e-3 * sqrt(work), sqrt(2.0 * work)}, beyond = 10.0 * speed[1], none = 0.0;
    CHECK_SUCCESS(mdr_plastic_law_restitution(law, 1.0, 2, speed, e));
    CHECK_CLOSE(e[0], 1.0, 1e-12);
    CHECK_CLOSE(e[1], sqrt(stored / work), 1e-10);
    CHECK_STATUS(mdr_plastic_law_restitution(law, 1.0, 1, &beyond, e), MDR_EDOMAIN, "the law ends at the speed");
    CHECK_STATUS(mdr_plastic_law_restitution(law, 1.0, 1, &none, e), MDR_EINVALID, "speed");
    CHECK_STATUS(mdr_plastic_law_restitution(law, -1.0, 1, speed, e), MDR_EINVALID, "mass");
    CHECK_CLOSE(e[0], 1.0, 1e-12);
    CHECK_FREE(law);
}

/* The inline functions: the bits of the library, with adhesion too. */
static void test_inline(double gamma)
{
    enum { MOST = 20000, STEPS = 400 };
    static double buffer[MOST];
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    options.work_of_adhesion = gamma;
    mdr_plastic_law *law = law_of(1e-5, &options);
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    mdr_plastic_view view;
    double ours[2] = {0.0, 0.0}, theirs[2] = {0.0, 0.0}, after[2], F, slope, force, rise, radius, stored, lost, kept, gone;
    unsigned random = 1;

    CHECK_SUCCESS(mdr_plastic_law_about(law, &facts));
    CHECK_INT(facts.memory_size, gamma > 0.0 ? 2 : 1);
    CHECK_STATUS(mdr_plastic_law_buffer(law, facts.buffer_size - 1, buffer), MDR_EINVALID, "size");
    CHECK_TRUE(facts.buffer_size <= MOST);
    CHECK_SUCCESS(mdr_plastic_law_buffer(law, facts.buffer_size, buffer));
    CHECK_INT(mdr_plastic_view_at(buffer, buffer, &view), MDR_SUCCESS);
    CHECK_INT(mdr_plastic_view_at(NULL, buffer, &view), MDR_ENULL);
    CHECK_INT(mdr_plastic_view_at(buffer + 1, buffer + 1, &view), MDR_EINVALID);
    for (int i = 0; i < STEPS; i++) {
        random = random * 1103515245u + 12345u;
        const double d = 1e-5 * ((double)(random >> 16 & 0x7fff) / 32768.0 * 1.2 - 0.2);
        mdr_plastic_point point;
        CHECK_INT(mdr_plastic_view_try(&view, d, ours, after, &point), MDR_SUCCESS);
        CHECK_INT(mdr_plastic_view_energies(&view, d, ours, &kept, &gone), MDR_SUCCESS);
        CHECK_SUCCESS(mdr_plastic_law_energies(law, 1, &d, theirs, &stored, &lost));
        CHECK_INT(mdr_plastic_view_advance(&view, d, ours, &F, &slope), MDR_SUCCESS);
        CHECK_SUCCESS(mdr_plastic_law_advance(law, 1, &d, 0, theirs, &force, &rise, &radius));
        CHECK_TRUE(memcmp(ours, theirs, sizeof ours) == 0 && memcmp(ours, after, sizeof(double) * (size_t)facts.memory_size) == 0);
        CHECK_TRUE(F == force && slope == rise && point.force == force && point.slope == rise && point.radius == radius);
        CHECK_TRUE(stored == kept && lost == gone);
    }
    const double before = ours[0];
    CHECK_INT(mdr_plastic_view_advance(&view, 1.0, ours, &F, &slope), MDR_EDOMAIN);
    CHECK_TRUE(isnan(F) && isnan(slope) && ours[0] == before);
    CHECK_INT(mdr_plastic_view_advance(&view, (double)NAN, ours, &F, &slope), MDR_EINVALID);
    if (facts.memory_size == 2) {
        const double much[2] = {0.0, 1.6e155}, d = 0.5 * facts.largest_depth;
        CHECK_INT(mdr_plastic_law_energies(law, 1, &d, much, &stored, &lost), MDR_EINVALID);
        CHECK_INT(mdr_plastic_view_energies(&view, d, much, &stored, &lost), MDR_EINVALID);
    }
    ours[0] = 1.0;
    CHECK_INT(mdr_plastic_view_advance(&view, 0.0, ours, &F, &slope), MDR_EINVALID);
    CHECK_FREE(law);
}

/* Arrays: the bits of the inline functions for any mixture of contacts, blocks of one kind and of many, with outputs on the input. */
static void test_arrays(void)
{
    enum { MOST = 20000, MANY = 1500 };
    static double buffer[MOST], d[MANY], memory[MANY], before[MANY], F[MANY], slope[MANY], a[MANY];
    mdr_plastic_law *law = law_of(1e-5, NULL);
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    mdr_plastic_view view;
    unsigned random = 7;

    CHECK_SUCCESS(mdr_plastic_law_about(law, &facts));
    CHECK_SUCCESS(mdr_plastic_law_buffer(law, facts.buffer_size, buffer));
    CHECK_INT(mdr_plastic_view_at(buffer, buffer, &view), MDR_SUCCESS);
    for (int i = 0; i < MANY; i++) {
        random = random * 1103515245u + 12345u;
        before[i] = memory[i] = 1e-5 * (double)(random >> 16 & 0x7fff) / 32768.0;
        random = random * 1103515245u + 12345u;
        d[i] = 1e-5 * ((double)(random >> 16 & 0x7fff) / 32768.0 * 1.2 - 0.2);
        if (i < 600 && d[i] > before[i]) d[i] = 0.9 * before[i]; /* two blocks and a part below the largest depth */
        if (i >= 1200) memory[i] = before[i] = 0.0;
    }
    CHECK_SUCCESS(mdr_plastic_law_advance(law, MANY, d, 0, memory, F, slope, a));
    for (int i = 0; i < MANY; i++) {
        mdr_plastic_point point;
        double after = -1.0;
        CHECK_INT(mdr_plastic_view_try(&view, d[i], &before[i], &after, &point), MDR_SUCCESS);
        CHECK_TRUE(point.force == F[i] && point.slope == slope[i] && point.radius == a[i] && after == memory[i]);
    }
    CHECK_SUCCESS(mdr_plastic_law_advance(law, MANY, d, 1, memory, NULL, NULL, d));
    CHECK_TRUE(memcmp(a, d, sizeof a) == 0);
    memory[MANY - 1] = -1.0;
    CHECK_STATUS(mdr_plastic_law_advance(law, MANY, F, 1, memory, F, NULL, NULL), MDR_EINVALID, "entry 1500 of memory");
    CHECK_FREE(law);
}

static void test_refusals(void)
{
    const double good[3] = {0.0, 0.1, 0.2}, falls[3] = {3.0, 2.0, 1.0}, d = 1e-6, minus = -1.0, none = (double)NAN, far = 1.0;
    double memory = 0.0, F = 7.0, a = 7.0, Y_of_H = 7.0, error = 7.0;
    mdr_yielding *metal = metal_of(Y), *other = NULL, *soft = metal_of(0.5 * Y), *elastic = NULL;
    mdr_profile *profile = ball(), *cone = NULL;
    mdr_plastic_law *law = NULL, *scaled = NULL;
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);

    CHECK_STATUS(mdr_yielding_new(E, nu, 3, good, falls, &other), MDR_EINVALID, "must not fall");
    CHECK_STATUS(mdr_yielding_new(E, 0.495, 1, good, falls, &other), MDR_EINVALID, "nu");
    CHECK_STATUS(mdr_yielding_new(E, nu, 0, good, falls, &other), MDR_EINVALID, "empty");
    CHECK_STATUS(mdr_yielding_new(E, nu, -1, good, falls, &other), MDR_EINVALID, "n");
    CHECK_STATUS(mdr_yielding_new(-E, nu, 1, good, falls, &other), MDR_EINVALID, "E");
    CHECK_TRUE(other == NULL);
    CHECK_SUCCESS(mdr_yielding_new(E, 0.5, 1, good, NULL, &elastic));
    CHECK_STATUS(mdr_yield_stress_from_hardness(E, nu, 0.0, 0.0, &Y_of_H, &error), MDR_EINVALID, "hardness");
    CHECK_TRUE(Y_of_H == 7.0 && error == 7.0);
    CHECK_SUCCESS(mdr_yield_stress_from_hardness(E, nu, 2.8, 0.0, &Y_of_H, &error));
    CHECK_CLOSE(Y_of_H, 1.0, 1e-15);

    CHECK_SUCCESS(mdr_profile_cone(0.1, &cone));
    CHECK_STATUS(mdr_plastic_law_new(cone, metal, 1e-6, NULL, &law), MDR_EINVALID, "paraboloid");
    CHECK_STATUS(mdr_plastic_law_new(profile, elastic, 1e-6, NULL, &law), MDR_EINVALID, "does not yield");
    CHECK_STATUS(mdr_plastic_law_new(profile, metal, 1.0, NULL, &law), MDR_EDOMAIN, "250");
    CHECK_STATUS(mdr_plastic_law_new(NULL, metal, 1e-6, NULL, &law), MDR_ENULL, "profile");
    CHECK_STATUS(mdr_plastic_law_new(profile, NULL, 1e-6, NULL, &law), MDR_ENULL, "metal");
    CHECK_STATUS(mdr_plastic_law_new(profile, metal, 1e-6, NULL, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_plastic_law_new(profile, (const mdr_yielding *)profile, 1e-6, NULL, &law), MDR_EINVALID, "mdr_yielding");
    options.other = soft;
    CHECK_STATUS(mdr_plastic_law_new(profile, metal, 1e-6, &options, &law), MDR_EINVALID, "both yield");
    options.other = NULL;
    options.work_of_adhesion = 1.0;
    CHECK_STATUS(mdr_plastic_law_new(profile, metal, 1e-6, &options, &law), MDR_EDOMAIN, "adhesion alone yields");
    CHECK_TRUE(law == NULL);

    CHECK_SUCCESS(mdr_plastic_law_new(profile, metal, 1e-5, NULL, &law));
    CHECK_STATUS(mdr_plastic_law_advance(NULL, 1, &d, 0, &memory, &F, NULL, &a), MDR_ENULL, "law");
    CHECK_STATUS(mdr_plastic_law_advance(law, 1, NULL, 0, &memory, &F, NULL, &a), MDR_ENULL, "d");
    CHECK_STATUS(mdr_plastic_law_advance(law, 1, &d, 0, NULL, &F, NULL, &a), MDR_ENULL, "memory");
    CHECK_STATUS(mdr_plastic_law_advance(law, -1, &d, 0, &memory, &F, NULL, &a), MDR_EINVALID, "n");
    CHECK_STATUS(mdr_plastic_law_advance(law, 1, &none, 0, &memory, &F, NULL, &a), MDR_EINVALID, "depth");
    CHECK_STATUS(mdr_plastic_law_advance(law, 1, &far, 0, &memory, &F, NULL, &a), MDR_EDOMAIN, "largest depth");
    CHECK_SUCCESS(mdr_plastic_law_advance(law, 0, NULL, 0, NULL, NULL, NULL, NULL));
    memory = minus;
    CHECK_STATUS(mdr_plastic_law_advance(law, 1, &d, 0, &memory, &F, NULL, &a), MDR_EINVALID, "memory");
    CHECK_STATUS(mdr_plastic_law_energies(law, 1, &d, &memory, &F, &a), MDR_EINVALID, "memory");
    CHECK_STATUS(mdr_plastic_law_loading(law, 1, &far, &F, &a, NULL, NULL), MDR_EDOMAIN, "largest depth");
    CHECK_TRUE(memory == minus && F == 7.0 && a == 7.0);
    CHECK_STATUS(mdr_plastic_law_with_radius(law, 0.0, &scaled), MDR_EINVALID, "radius");
    CHECK_SUCCESS(mdr_plastic_law_with_radius(law, 4.0 * R, &scaled));
    CHECK_FREE(scaled);
    CHECK_FREE(law);
    CHECK_FREE(cone);
    CHECK_FREE(profile);
    CHECK_FREE(metal);
    CHECK_FREE(soft);
    CHECK_FREE(elastic);
}

/* A curve of points: its values, and where they are wrong. */
static void test_points(void)
{
    const double d[3] = {1e-9, 4e-9, 9e-9}, F[3] = {1e-6, 6e-6, 15e-6}, a[3] = {3e-8, 7e-8, 11e-8}, w[3] = {0.0, 1.3e-9, 4.5e-9};
    const double falling[3] = {1e-9, 4e-9, 3e-9}, none[3] = {0.0, 0.0, 0.0}, E_star[3] = {20e9, 20e9, 20e9};
    double found[3], radius[3], left[3];
    mdr_plastic_law *law = NULL;

    CHECK_SUCCESS(mdr_plastic_law_from_points(3, d, F, a, w, E_star, NULL, &law));
    CHECK_SUCCESS(mdr_plastic_law_loading(law, 3, d, found, radius, left, NULL));
    for (int i = 0; i < 3; i++) {
        CHECK_CLOSE(found[i], F[i], 1e-9);
        CHECK_CLOSE(radius[i], a[i], 1e-9);
        CHECK_TRUE(fabs(left[i] - w[i]) < 1e-8 * d[i]);
    }
    CHECK_FREE(law);
    law = NULL;
    CHECK_STATUS(mdr_plastic_law_from_points(3, falling, F, a, w, E_star, NULL, &law), MDR_EINVALID, "must rise");
    CHECK_STATUS(mdr_plastic_law_from_points(2, d, F, a, w, E_star, NULL, &law), MDR_EINVALID, "at least 3");
    CHECK_STATUS(mdr_plastic_law_from_points(3, d, F, a, none, E_star, NULL, &law), MDR_EDOMAIN, "leaves between");
    CHECK_TRUE(law == NULL);
}

int main(void)
{
    test_path();
    test_restitution();
    test_inline(0.0);
    test_inline(1e-13);
    test_arrays();
    test_refusals();
    test_points();
    return check_report("plastic_law");
}
