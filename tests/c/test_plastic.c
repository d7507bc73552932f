/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Imprints of plastic contacts: closed forms, the contact of their indenter, refusals. */
#include "check.h"
#include "mdrcontact/plastic.h"

static const double radius = 0.9, uniform = 0.015, hertz = 0.01;

static mdr_medium *half_space(void)
{
    const mdr_layer base = mdr_isotropic(0.91, 0.3, 0.0);
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;

    CHECK_SUCCESS(mdr_body_layered(0, NULL, &base, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_FREE(body);
    return medium;
}

/* E* = 1: A2 = 2 pu A, A1 = pi/2 ph A, and the work (2.8) */
static void test_two_terms(const mdr_medium *medium)
{
    const double pi = 3.14159265358979323846, a2 = 2.0 * uniform * radius, a1 = 0.5 * pi * hertz * radius;
    const double recovery = a1 + a2, force = 2.0 * radius * (2.0 / 3.0 * a1 + 0.25 * pi * a2);
    const double x[2] = {0.45, 0.9};
    double g[2], f[2];
    mdr_imprint *imprint = NULL, *again = NULL;
    mdr_profile *effective = NULL;
    mdr_contact *contact = NULL;
    mdr_state state;
    mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);

    CHECK_SUCCESS(mdr_imprint_two_terms(medium, radius, uniform, hertz, 0.0, &imprint));
    CHECK_SUCCESS(mdr_imprint_about(imprint, &facts));
    CHECK_CLOSE(facts.radius, radius, 0.0);
    CHECK_CLOSE(facts.force, force, 1e-14);
    CHECK_CLOSE(facts.residual_depth, -recovery, 1e-14);
    CHECK_CLOSE(facts.depth, 0.0, 0.0);
    CHECK_CLOSE(facts.recovered_work, radius * (8.0 / 15.0 * a1 * a1 + 0.375 * pi * a1 * a2 + 2.0 / 3.0 * a2 * a2), 1e-14);
    CHECK_CLOSE(facts.uniform, uniform, 1e-15);
    CHECK_CLOSE(facts.hertz, hertz, 1e-15);
    CHECK_CLOSE(facts.misfit, 0.0, 0.0);
    CHECK_SUCCESS(mdr_imprint_profile(imprint, &effective));
    CHECK_SUCCESS(mdr_profile_values(effective, MDR_G, 2, x, g));
    CHECK_CLOSE(g[0], a1 * 0.25 + a2 * (1.0 - sqrt(0.75)), 1e-14);
    CHECK_CLOSE(g[1], recovery, 1e-14);
    /* f(A) = A1/2 + (2/pi) A2 (pi/2 - 1) */
    CHECK_SUCCESS(mdr_profile_values(effective, MDR_HEIGHT, 2, x, f));
    CHECK_CLOSE(f[1], 0.5 * a1 + 2.0 / pi * a2 * (0.5 * pi - 1.0), 1e-14);
    CHECK_SUCCESS(mdr_contact_new(effective, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_LOADING, 1, &recovery, &state));
    CHECK_CLOSE(state.force, force, 1e-13);
    CHECK_CLOSE(state.radius, radius, 1e-15);
    CHECK_SUCCESS(mdr_imprint_new(medium, radius, force, 0.1, 0.1 + recovery, &again));
    CHECK_SUCCESS(mdr_imprint_about(again, &facts));
    CHECK_CLOSE(facts.uniform, uniform, 1e-12);
    CHECK_CLOSE(facts.hertz, hertz, 1e-12);
    CHECK_CLOSE(facts.residual_depth, 0.1, 1e-12);
    CHECK_FREE(again);
    CHECK_FREE(contact);
    CHECK_FREE(effective);
    CHECK_FREE(imprint);
}

static void test_pressure(const mdr_medium *medium)
{
    enum { N = 9 };
    double r[N], p[N];
    mdr_imprint *imprint = NULL;
    mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts), known = facts;

    for (int i = 0; i < N; i++) {
        r[i] = radius * i / (N - 1.0);
        p[i] = uniform + hertz * sqrt((1.0 - r[i] / radius) * (1.0 + r[i] / radius));
    }
    CHECK_SUCCESS(mdr_imprint_from_pressure(medium, N, r, p, 0.2, &imprint));
    CHECK_SUCCESS(mdr_imprint_about(imprint, &facts));
    CHECK_FREE(imprint);
    CHECK_SUCCESS(mdr_imprint_two_terms(medium, radius, uniform, hertz, 0.2, &imprint));
    CHECK_SUCCESS(mdr_imprint_about(imprint, &known));
    CHECK_FREE(imprint);
    CHECK_CLOSE(facts.residual_depth, known.residual_depth, 1e-12);
    CHECK_CLOSE(facts.recovered_work, known.recovered_work, 1e-12);
    CHECK_TRUE(facts.misfit < 1e-12);
    CHECK_STATUS(mdr_imprint_from_pressure(medium, 3, r, p, 0.0, &imprint), MDR_EINVALID, "at least 4");
    CHECK_STATUS(mdr_imprint_from_pressure(medium, -1, r, p, 0.0, &imprint), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_imprint_from_pressure(medium, N, NULL, p, 0.0, &imprint), MDR_ENULL, "r");
    CHECK_STATUS(mdr_imprint_from_pressure(medium, N, r, NULL, 0.0, &imprint), MDR_ENULL, "p");
    p[3] = NAN;
    CHECK_STATUS(mdr_imprint_from_pressure(medium, N, r, p, 0.0, &imprint), MDR_EINVALID, "entry 4 of p");
    CHECK_TRUE(imprint == NULL);
}

/* 0.62 p0 for nu = 0.3 */
static void test_reverse_yield(const mdr_medium *medium)
{
    const double stress = 0.01, none = 0.0, low = 0.005;
    double ratio = -1.0;
    int layer = -1;
    mdr_imprint *imprint = NULL;

    CHECK_SUCCESS(mdr_imprint_two_terms(medium, radius, 0.0, 0.03, 0.0, &imprint));
    CHECK_SUCCESS(mdr_imprint_reverse_yield(imprint, 1, &stress, &ratio, &layer));
    CHECK_CLOSE(ratio, 1.86, 2e-3);
    CHECK_INT(layer, 0);
    ratio = layer = -1;
    CHECK_STATUS(mdr_imprint_reverse_yield(imprint, 1, &none, &ratio, &layer), MDR_EINVALID, "yield_stress = 0");
    CHECK_STATUS(mdr_imprint_reverse_yield(imprint, 1, &low, &ratio, &layer), MDR_EDOMAIN, "exceeds 3");
    CHECK_STATUS(mdr_imprint_reverse_yield(imprint, 2, (double[]){1.0, 1.0}, &ratio, &layer), MDR_EINVALID, "has 1 layers");
    CHECK_STATUS(mdr_imprint_reverse_yield(imprint, 0, &stress, &ratio, &layer), MDR_EINVALID, "n = 0");
    CHECK_STATUS(mdr_imprint_reverse_yield(imprint, 1, NULL, &ratio, &layer), MDR_ENULL, "yield_stress");
    CHECK_STATUS(mdr_imprint_reverse_yield(NULL, 1, &stress, &ratio, &layer), MDR_ENULL, "i");
    CHECK_TRUE(ratio == -1.0 && layer == -1);
    CHECK_FREE(imprint);
}

static void test_refusals(const mdr_medium *medium)
{
    mdr_imprint *imprint = NULL;
    mdr_profile *profile = NULL;
    mdr_medium *none = NULL;
    mdr_imprint_facts facts = MDR_SIZED(mdr_imprint_facts);

    CHECK_STATUS(mdr_imprint_new(medium, 0.0, 1.0, 0.0, 1.0, &imprint), MDR_EINVALID, "radius = 0");
    CHECK_STATUS(mdr_imprint_new(medium, 1.0, NAN, 0.0, 1.0, &imprint), MDR_EINVALID, "force");
    CHECK_STATUS(mdr_imprint_new(medium, 1.0, 1.0, 1.0, 1.0, &imprint), MDR_EINVALID, "residual_depth = 1");
    CHECK_STATUS(mdr_imprint_new(medium, 1.0, 1.0, 0.0, 1.0, &imprint), MDR_EINVALID, "more than Hertz's");
    CHECK_STATUS(mdr_imprint_two_terms(medium, 1.0, 1.0, -0.7, 0.0, &imprint), MDR_EINVALID, "hertz = -0.7");
    CHECK_STATUS(mdr_imprint_two_terms(NULL, 1.0, 1.0, 1.0, 0.0, &imprint), MDR_ENULL, "medium");
    CHECK_STATUS(mdr_imprint_two_terms(medium, 1.0, 1.0, 1.0, 0.0, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_imprint_two_terms((const mdr_medium *)&facts, 1.0, 1.0, 1.0, 0.0, &imprint), MDR_EINVALID, "medium");
    CHECK_STATUS(mdr_imprint_about(NULL, &facts), MDR_ENULL, "i");
    CHECK_STATUS(mdr_imprint_profile(NULL, &profile), MDR_ENULL, "i");
    CHECK_TRUE(imprint == NULL && profile == NULL && none == NULL);
}

int main(void)
{
    mdr_medium *medium = half_space();

    test_two_terms(medium);
    test_pressure(medium);
    test_reverse_yield(medium);
    test_refusals(medium);
    CHECK_FREE(medium);
    return check_report("plastic");
}
