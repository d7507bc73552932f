/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The overload rule and the pressure cap: closed forms, limits, refusals. */
#include "check.h"
#include "mdrcontact/plastic.h"

static const double PI = 3.14159265358979323846, MODULUS = 3.2; /* 3/(1 - 0.25^2) */
static mdr_contact *ball, *on_film;

/* A paraboloid of radius 2 on a half-space, and on a film of thickness 0.01 of the same material. */
static void make_contacts(void)
{
    mdr_profile *tip = NULL;
    mdr_medium *body = NULL, *coated = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &tip));
    CHECK_SUCCESS(new_homogeneous(3.0, 0.25, &body));
    CHECK_SUCCESS(mdr_contact_new(tip, body, NULL, &ball));
    CHECK_SUCCESS(new_coated(3.0, 0.25, 0.01, 3.0, 0.25, MDR_MODEL_EXACT, NULL, &coated));
    CHECK_SUCCESS(mdr_contact_new(tip, coated, NULL, &on_film));
    CHECK_FREE(tip);
    CHECK_FREE(body);
    CHECK_FREE(coated);
}

/* The law of a rule: on a half-space, and on a film of the same constants, that of the paraboloid; refusals. */
static void test_law_of_a_rule(void)
{
    const double yield_stress[2] = {1e-4, 4e-4}, strain = 0.0, Y = 1e-4, deepest = 1.5e-6;
    mdr_profile *tip = NULL;
    mdr_yielding *metal = NULL;
    mdr_overload *rules[2] = {NULL, NULL};
    mdr_plastic_law *law = NULL, *expected = NULL, *none = NULL;
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);

    CHECK_SUCCESS(mdr_profile_paraboloid(2.0, &tip));
    CHECK_SUCCESS(mdr_yielding_new(3.0, 0.25, 1, &strain, &Y, &metal));
    CHECK_SUCCESS(mdr_plastic_law_new(tip, metal, deepest, NULL, &expected));
    CHECK_SUCCESS(mdr_overload_new(ball, 1, yield_stress, &rules[0]));
    CHECK_SUCCESS(mdr_overload_new(on_film, 2, yield_stress, &rules[1]));
    for (int i = 0; i < 2; i++) {
        CHECK_SUCCESS(mdr_plastic_law_from_overload(rules[i], deepest, NULL, &law));
        for (int j = 0; j < 20; j++) {
            const double d = 0.07 * deepest * (j % 10 + 4), back = j < 10 ? d : 0.9 * d;
            double memory[2] = {d, d}, F[2];
            CHECK_SUCCESS(mdr_plastic_law_advance(law, 1, &back, 1, memory, F, NULL, NULL));
            CHECK_SUCCESS(mdr_plastic_law_advance(expected, 1, &back, 1, memory + 1, F + 1, NULL, NULL));
            CHECK_CLOSE(F[0], F[1], 1e-4);
        }
        CHECK_FREE(law);
        law = NULL;
    }
    CHECK_STATUS(mdr_plastic_law_from_overload(NULL, deepest, NULL, &none), MDR_ENULL, "rule");
    CHECK_STATUS(mdr_plastic_law_from_overload((mdr_overload *)ball, deepest, NULL, &none), MDR_EINVALID, "mdr_overload");
    CHECK_STATUS(mdr_plastic_law_from_overload(rules[0], deepest, NULL, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_plastic_law_from_overload(rules[0], 0.0, NULL, &none), MDR_EINVALID, "largest_depth");
    CHECK_STATUS(mdr_plastic_law_from_overload(rules[0], 1e-12, NULL, &none), MDR_EDOMAIN, "nothing yields");
    options.other = metal;
    CHECK_STATUS(mdr_plastic_law_from_overload(rules[0], deepest, &options, &none), MDR_EINVALID, "other");
    CHECK_TRUE(none == NULL);
    CHECK_FREE(expected);
    CHECK_FREE(rules[0]);
    CHECK_FREE(rules[1]);
    CHECK_FREE(metal);
    CHECK_FREE(tip);
}

/* Virgin loading at L = 40, nu = 0.25; a film of the same elastic constants changes nothing but the errors. */
static void test_overload(void)
{
    const double yield_stress[2] = {1e-4, 4e-4}, bad[2] = {1e-4, 0.0}, a[2] = {40.0 * 2.0 * 1e-4 / 3.2, 1e-5};
    mdr_overload *rule = NULL, *film = NULL, *none = NULL;
    mdr_overload_state states[2], again[2], one;

    CHECK_SUCCESS(mdr_overload_new(ball, 1, yield_stress, &rule));
    CHECK_SUCCESS(mdr_overload_states(rule, MDR_RADIUS, 2, a, states));
    CHECK_CLOSE(states[0].load, 40.0, 1e-12);
    CHECK_CLOSE(states[0].force, PI * a[0] * a[0] * 1e-4 * 2.804630, 1e-6);
    CHECK_CLOSE(states[0].depth, a[0] * a[0] / 2.0 * 0.548857, 2e-6);
    CHECK_CLOSE(states[0].depth_error, 2e-3, 1e-12);
    CHECK_CLOSE(states[1].force, 4.0 * MODULUS * a[1] * a[1] * a[1] / (3.0 * 2.0), 1e-12);
    CHECK_TRUE(states[1].force_error == 0.0 && states[1].load < 2.0);
    CHECK_SUCCESS(mdr_overload_states(rule, MDR_FORCE, 1, &states[0].force, again));
    CHECK_CLOSE(again[0].radius, a[0], 1e-12);
    CHECK_SUCCESS(mdr_overload_new(on_film, 2, yield_stress, &film));
    CHECK_SUCCESS(mdr_overload_states(film, MDR_DEPTH, 1, &states[0].depth, again));
    CHECK_CLOSE(again[0].force, states[0].force, 1e-9);
    CHECK_CLOSE(again[0].depth_error, 1e-2, 1e-12);
    one.force = 7.0;
    CHECK_STATUS(mdr_overload_new(ball, 2, yield_stress, &none), MDR_EINVALID, "1 materials");
    CHECK_STATUS(mdr_overload_new(on_film, 2, bad, &none), MDR_EINVALID, "entry 2 of yield_stress");
    CHECK_STATUS(mdr_overload_new(ball, 0, NULL, &none), MDR_EINVALID, "n = 0");
    CHECK_STATUS(mdr_overload_new(ball, -1, yield_stress, &none), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_overload_new(NULL, 1, yield_stress, &none), MDR_ENULL, "c");
    CHECK_STATUS(mdr_overload_new(ball, 1, NULL, &none), MDR_ENULL, "yield_stress");
    CHECK_STATUS(mdr_overload_new(ball, 1, yield_stress, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_overload_states(rule, MDR_HEIGHT, 1, a, &one), MDR_EINVALID, "given");
    CHECK_STATUS(mdr_overload_states(rule, MDR_RADIUS, 1, NULL, &one), MDR_ENULL, "value");
    CHECK_STATUS(mdr_overload_states(rule, MDR_RADIUS, 1, a, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_overload_states((mdr_overload *)ball, MDR_RADIUS, 1, a, &one), MDR_EINVALID, "mdr_overload");
    CHECK_STATUS(mdr_overload_states(film, MDR_RADIUS, 1, &(const double){0.0201}, &one), MDR_EDOMAIN, "radius = 0.0201");
    CHECK_STATUS(mdr_overload_states(rule, MDR_DEPTH, 2, (const double[2]){1e-6, -1.0}, again), MDR_EINVALID,
                 "entry 2 of depth = -1");
    CHECK_SUCCESS(mdr_overload_states(rule, MDR_RADIUS, 0, NULL, NULL));
    CHECK_TRUE(one.force == 7.0 && none == NULL);
    CHECK_FREE(film);
    CHECK_FREE(rule);
}

/* A cap that is not reached is Hertz's contact; one that is, supports at most pi a^2 H. */
static void test_cap(void)
{
    const double a = 0.01, r[3] = {0.0, 0.004, 0.02};
    double pressure[3], residual[3], hertz = 4.0 * MODULUS * 1e-6 / 6.0;
    mdr_cap *cap = NULL, *none = NULL;
    mdr_cap_state state, again;

    CHECK_SUCCESS(mdr_cap_new(ball, 10.0, &cap));
    CHECK_SUCCESS(mdr_cap_states(cap, MDR_RADIUS, 1, &a, &state));
    CHECK_CLOSE(state.force, hertz, 1e-7);
    CHECK_CLOSE(state.depth, a * a / 2.0, 1e-7);
    CHECK_CLOSE(state.recovered_work, 0.4 * hertz * state.depth, 1e-6);
    CHECK_TRUE(state.capped_radius == 0.0 && state.residual_depth == 0.0);
    CHECK_FREE(cap);
    CHECK_SUCCESS(mdr_cap_new(on_film, 2e-3, &cap));
    CHECK_SUCCESS(mdr_cap_states(cap, MDR_RADIUS, 1, &a, &state));
    CHECK_TRUE(state.force < PI * a * a * 2e-3 && state.force > 0.9 * PI * a * a * 2e-3);
    CHECK_TRUE(state.capped_radius > 0.9 * a && state.residual_depth > 0.0 && state.residual_depth < state.depth);
    CHECK_SUCCESS(mdr_cap_states(cap, MDR_FORCE, 1, &state.force, &again));
    CHECK_CLOSE(again.radius, a, 1e-12);
    CHECK_SUCCESS(mdr_cap_pressure(cap, a, 3, r, pressure, residual));
    CHECK_TRUE(pressure[1] == 2e-3 && residual[0] > residual[1] && residual[1] > 0.0);
    CHECK_TRUE(pressure[2] == 0.0 && residual[2] == 0.0);
    CHECK_SUCCESS(mdr_cap_pressure(cap, a, 3, r, NULL, residual));
    again.force = 7.0;
    CHECK_STATUS(mdr_cap_new(ball, 0.0, &none), MDR_EINVALID, "hardness = 0");
    CHECK_STATUS(mdr_cap_new(NULL, 1.0, &none), MDR_ENULL, "c");
    CHECK_STATUS(mdr_cap_new(ball, 1.0, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_cap_states(cap, 5, 1, &a, &again), MDR_EINVALID, "given");
    CHECK_STATUS(mdr_cap_states(cap, MDR_FORCE, 1, NULL, &again), MDR_ENULL, "value");
    CHECK_STATUS(mdr_cap_states(NULL, MDR_FORCE, 1, &a, &again), MDR_ENULL, "cap");
    CHECK_STATUS(mdr_cap_pressure(cap, -a, 3, r, pressure, NULL), MDR_EINVALID, "radius = -0.01");
    CHECK_STATUS(mdr_cap_pressure(cap, a, -1, r, pressure, NULL), MDR_EINVALID, "n = -1");
    CHECK_TRUE(again.force == 7.0 && none == NULL);
    CHECK_FREE(cap);
}

static void test_truncated(void)
{
    const double x[2] = {0.0, 1.6}, outside = 2.5;
    double q[2] = {7.0, 7.0};

    CHECK_SUCCESS(mdr_truncated_hertz(2.0, 4.0 / PI, 0.4, 2, x, q));
    CHECK_CLOSE(q[0], 1.573276985761152, 1e-12);
    CHECK_CLOSE(q[1], 0.9141265702784391, 1e-12);
    CHECK_STATUS(mdr_truncated_hertz(2.0, 1.0, 1.0, 1, &outside, q), MDR_EINVALID, "x = 2.5");
    CHECK_STATUS(mdr_truncated_hertz(2.0, 1.0, -1.0, 1, x, q), MDR_EINVALID, "hardness = -1");
    CHECK_STATUS(mdr_truncated_hertz(2.0, 1.0, 1.0, 1, x, NULL), MDR_ENULL, "out");
}

int main(void)
{
    make_contacts();
    test_overload();
    test_law_of_a_rule();
    test_cap();
    test_truncated();
    CHECK_FREE(ball);
    CHECK_FREE(on_film);
    return check_report("plastic_models");
}
