/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that reads blocks of laws which others wrote: each of some thousand forged ones is refused by mdr_law_check(), or evaluates
 * within its bounds, which the sanitizers watch.
 */
#include "../c/check.h"
#include "forge.h"
#include "mdrcontact/all.h"
#ifdef MDRCONTACT_PLASTIC_H
#include "mdrcontact_plastic_law.h"
#else
#include "mdrcontact_law.h"
#endif

enum { FORGED = 20000, DEPTHS = 9 };

static double wild(double was)
{
    static const double values[] = {0.0, -1.0, 1.0, 2.0, 7.0, 63.0, 1e3, 1e9, 1e18, 1e300, -1e300, 0.5, 1e-300};
    switch (draw() % 4) {
    case 0: return values[draw() % (sizeof values / sizeof *values)];
    case 1: return was + (double)(draw() % 64);
    case 2: return was - (double)(draw() % 64);
    default: return draw() % 2 ? INFINITY : NAN;
    }
}

/* Evaluates everywhere; the numbers do not matter. */
static void evaluate(const double *block, double highest)
{
    for (int branch = MDR_ON_LOADING; branch <= MDR_ON_UNLOADING; branch++) {
        mdr_law_view view;
        if (mdr_law_view_from(block, branch, &view) != MDR_SUCCESS) continue;
        int segment = 0;
        for (int i = -2; i < DEPTHS; i++) {
            double F, slope;
            mdr_law_point point;
            const double d = highest * i / (DEPTHS - 2);
            mdr_law_view_force(&view, d, &F);
            mdr_law_view_force_slope(&view, d, &F, &slope);
            mdr_law_view_state(&view, d, &point);
            mdr_law_view_follow(&view, d, &segment, &point);
            mdr_law_view_conductance(&view, d, &F, &slope);
        }
    }
}

static void forge(mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    int refused = 0, sound = 0;

    CHECK_SUCCESS(mdr_law_about(law, &facts));
    const size_t size = (size_t)facts.buffer_size, bytes = size * sizeof(double);
    double *whole = malloc(bytes), *block = malloc(bytes);
    CHECK_SUCCESS(mdr_law_buffer(law, facts.buffer_size, whole));
    CHECK_INT(mdr_law_check(whole, bytes), MDR_SUCCESS);
    CHECK_INT(mdr_law_check(whole, bytes - 8), MDR_EINVALID);
    CHECK_INT(mdr_law_check(NULL, bytes), MDR_ENULL);
    CHECK_INT(mdr_law_check(whole, 0), MDR_EINVALID);
    for (int i = 0; i < FORGED; i++) {
        memcpy(block, whole, bytes);
        /* head, segments and intervals: where places and counts are */
        const size_t first = ((const mdr_law_head *)whole)->force > 200.0 ? 200 : (size_t)((const mdr_law_head *)whole)->force;
        for (unsigned long long j = 0; j <= draw() % 3; j++) {
            const size_t k = (size_t)(draw() % first);
            block[k] = wild(block[k]);
        }
        if (mdr_law_check(block, bytes) != MDR_SUCCESS) {
            refused++;
            continue;
        }
        sound++;
        evaluate(block, facts.highest_depth);
    }
    CHECK_TRUE(refused > FORGED / 4 && sound > 0);
    free(whole);
    free(block);
}

#ifdef MDRCONTACT_PLASTIC_H
static void evaluate_plastic(const double *block, double highest)
{
    mdr_plastic_view view;
    if (mdr_plastic_view_at(block, block, &view) != MDR_SUCCESS) return;
    for (int i = -2; i < DEPTHS; i++) {
        const double d = highest * i / (DEPTHS - 2), memories[3][2] = {{0.0, 0.0}, {0.9 * highest, 0.0}, {-0.9 * highest, wild(0.0)}};
        for (int k = 0; k < 3; k++) {
            double memory[2] = {memories[k][0], memories[k][1]}, F, slope, stored, lost;
            mdr_plastic_point point;
            mdr_plastic_view_energies(&view, d, memory, &stored, &lost);
            mdr_plastic_view_try(&view, d, memory, NULL, &point);
            mdr_plastic_view_advance(&view, d, memory, &F, &slope);
        }
    }
}

/* Of the rows only the places matter: the head is forged, the ends of panels, and the elastic law. */
static void forge_plastic(mdr_plastic_law *law)
{
    mdr_plastic_law_facts facts = MDR_SIZED(mdr_plastic_law_facts);
    int refused = 0, sound = 0;

    CHECK_SUCCESS(mdr_plastic_law_about(law, &facts));
    const size_t size = (size_t)facts.buffer_size, bytes = size * sizeof(double), head = sizeof(mdr_plastic_head) / sizeof(double);
    double *whole = malloc(bytes), *block = malloc(bytes);
    CHECK_SUCCESS(mdr_plastic_law_buffer(law, facts.buffer_size, whole));
    CHECK_INT(mdr_plastic_law_check(whole, bytes), MDR_SUCCESS);
    CHECK_INT(mdr_plastic_law_check(whole, bytes - 8), MDR_EINVALID);
    CHECK_INT(mdr_plastic_law_check(NULL, bytes), MDR_ENULL);
    CHECK_INT(mdr_plastic_law_check(whole, 0), MDR_EINVALID);
    for (int i = 0; i < FORGED; i++) {
        memcpy(block, whole, bytes);
        for (unsigned long long j = 0; j <= draw() % 3; j++) {
            const size_t k = (size_t)(draw() % (draw() % 4 ? head : size));
            block[k] = wild(block[k]);
        }
        if (mdr_plastic_law_check(block, bytes) != MDR_SUCCESS) {
            refused++;
            continue;
        }
        sound++;
        evaluate_plastic(block, facts.largest_depth);
    }
    CHECK_TRUE(refused > FORGED / 4 && sound > 0);
    free(whole);
    free(block);
}

static void forge_plastic_laws(void)
{
    const double strain = 0.0, Y = 5e-3, E = 1.0;
    const double d[4] = {1e-3, 4e-3, 9e-3, 12e-3}, F[4] = {1e-6, 6e-6, 15e-6, 20e-6}, a[4] = {3e-2, 7e-2, 11e-2, 13e-2};
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    mdr_profile *ball = NULL;
    mdr_yielding *metal = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_yielding_new(E, 0.3, 1, &strain, &Y, &metal));
    for (int i = 0; i < 3; i++) {
        mdr_plastic_law *law = NULL;
        options.work_of_adhesion = i == 1 ? 1e-8 : 0.0;
        options.tolerance = 1e-5;
        if (i == 2) {
            const double left[4] = {0.0, 1.3e-3, 4.5e-3, 7e-3}, modulus[4] = {0.02, 0.02, 0.02, 0.02};
            CHECK_SUCCESS(mdr_plastic_law_from_points(4, d, F, a, left, modulus, &options, &law));
        } else {
            CHECK_SUCCESS(mdr_plastic_law_new(ball, metal, 1e-2, &options, &law));
        }
        if (law) forge_plastic(law);
        CHECK_FREE(law);
    }
    CHECK_FREE(metal);
    CHECK_FREE(ball);
}
#endif

int main(void)
{
    const mdr_layer soft = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &soft, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    for (int i = 0; i < 2; i++) {
        mdr_contact *contact = NULL;
        mdr_law *law = NULL;
        options.work_of_adhesion = i == 0 ? 0.0 : 1e-3;
        CHECK_SUCCESS(mdr_contact_new(ball, medium, &options, &contact));
        CHECK_SUCCESS(mdr_law_new(contact, 0.2, NULL, &law));
        forge(law);
        CHECK_FREE(law);
        CHECK_FREE(contact);
    }
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(ball);
#ifdef MDRCONTACT_PLASTIC_H
    forge_plastic_laws();
#endif
    return check_report("blocks");
}
