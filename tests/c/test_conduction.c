/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conduction: closed forms, in place, refusals. */
#include "check.h"

static const double PI = 3.14159265358979323846;
static const mdr_conductor HALF_SPACE = {0.0, 2.0, 8.0, 3.0, 0.0};

static void test_half_space(void)
{
    const double radius[2] = {1.5, 3.0}, omega[2] = {0.0, 1.0}, time[2] = {1.0, 1e-3}, r[2] = {0.0, 0.5}, z[2] = {0.0, 0.0};
    double conductance[2], slope[2], out[2], ahead[2];
    mdr_conduction *p = NULL;

    CHECK_SUCCESS(mdr_conduction_new(1, &HALF_SPACE, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, radius, conductance, slope));
    for (int i = 0; i < 2; i++) {
        CHECK_CLOSE(conductance[i], 16.0 * radius[i], 1e-13);
        CHECK_CLOSE(slope[i], 16.0, 1e-13);
    }
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, radius, NULL, NULL));
    memcpy(out, radius, sizeof out);
    CHECK_SUCCESS(mdr_conduction_spot(p, 2, out, out, NULL));
    CHECK_CLOSE(out[1], conductance[1], 1e-15);
    CHECK_SUCCESS(mdr_conduction_field(p, MDR_CONDUCTION_FLUX, 1.5, MDR_BODY_LOWER, 1, 2, r, NULL, out));
    CHECK_CLOSE(out[1], 8.0 / (PI * sqrt(1.5 * 1.5 - 0.25)), 1e-13);
    CHECK_SUCCESS(mdr_conduction_field(p, MDR_CONDUCTION_POTENTIAL, 1.5, MDR_BODY_LOWER, 1, 2, r, z, out));
    CHECK_CLOSE(out[0], 1.0, 1e-13);
    CHECK_CLOSE(out[1], 1.0, 1e-13);
    CHECK_SUCCESS(mdr_conduction_admittance(p, MDR_CONDUCTION_CONDUCTANCE, 1.5, 2, omega, out, ahead));
    CHECK_CLOSE(out[0], conductance[0], 1e-13);
    CHECK_TRUE(ahead[0] == 0.0 && ahead[1] > 0.0 && out[1] > out[0]);
    CHECK_SUCCESS(mdr_conduction_step(p, MDR_CONDUCTION_CONDUCTANCE, 1.5, 2, time, out));
    CHECK_TRUE(out[0] > conductance[0] && out[1] > out[0]);
    CHECK_SUCCESS(mdr_conduction_free(&p));
    CHECK_TRUE(p == NULL);
}

static void test_pair(void)
{
    const double radius[1] = {1.0};
    const mdr_conductor film[2] = {{0.5, 1.0, 1.0, 0.0, 0.1}, {0.0, 5.0, 5.0, 0.0, 0.0}};
    double one, both, slope;
    mdr_conduction *p = NULL;

    CHECK_SUCCESS(mdr_conduction_new(2, film, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 1, radius, &one, &slope));
    CHECK_SUCCESS(mdr_conduction_free(&p));
    CHECK_SUCCESS(mdr_conduction_new(2, film, MDR_BASE_HALF_SPACE, 2, film, MDR_BASE_HALF_SPACE, 0.0, 0.0, &p));
    CHECK_SUCCESS(mdr_conduction_spot(p, 1, radius, &both, &slope));
    CHECK_CLOSE(both, 0.5 * one, 1e-12);
    CHECK_SUCCESS(mdr_conduction_free(&p));
}

static void test_refusals(void)
{
    const mdr_conductor bad = {1.0, -1.0, 1.0, 0.0, 0.0}, layer = {1.0, 1.0, 1.0, 1.0, 0.0};
    const double one[2] = {1.0, -1.0};
    double out[2] = {7.0, 7.0}, more[2] = {7.0, 7.0};
    mdr_conduction *p = NULL;
    mdr_material *other = NULL;

    CHECK_STATUS(mdr_conduction_new(1, &bad, MDR_BASE_PERFECT, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "sigma = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, MDR_BASE_PERFECT, 1, &bad, 1, 0.0, 0.0, &p), MDR_EINVALID, "sigma = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 4, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "base = 4");
    CHECK_STATUS(mdr_conduction_new(0, NULL, 1, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "no layer");
    CHECK_STATUS(mdr_conduction_new(-1, &layer, 1, 0, NULL, 0, 0.0, 0.0, &p), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_conduction_new(1, NULL, 1, 0, NULL, 0, 0.0, 0.0, &p), MDR_ENULL, "lower");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 1, 1, NULL, 1, 0.0, 0.0, &p), MDR_ENULL, "upper");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 1, 0, NULL, 0, -1.0, 0.0, &p), MDR_EINVALID, "film = -1");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 1, 0, NULL, 0, 0.0, NAN, &p), MDR_EINVALID, "sink");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 3, 0, NULL, 0, 0.0, 2.0, &p), MDR_EDOMAIN, "sink = 2");
    CHECK_STATUS(mdr_conduction_new(1, &layer, 1, 0, NULL, 0, 0.0, 0.0, NULL), MDR_ENULL, "out");
    CHECK_TRUE(p == NULL);
    CHECK_SUCCESS(mdr_conduction_new(1, &layer, MDR_BASE_INSULATING, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_STATUS(mdr_conduction_spot(p, 1, one, out, more), MDR_EINVALID, "sink");
    CHECK_STATUS(mdr_conduction_admittance(p, 1, 1.0, 2, one, out, more), MDR_EINVALID, "entry 2 of omega");
    CHECK_STATUS(mdr_conduction_admittance(p, 6, 1.0, 1, one, out, more), MDR_EINVALID, "answer = 6");
    CHECK_STATUS(mdr_conduction_admittance(p, 1, 1e4, 1, one, out, more), MDR_EDOMAIN, "omega");
    CHECK_STATUS(mdr_conduction_admittance(p, 1, 1.0, 1, one, NULL, more), MDR_ENULL, "in_phase");
    CHECK_STATUS(mdr_conduction_step(p, 1, 1e3, 1, one, out), MDR_EDOMAIN, "time");
    CHECK_STATUS(mdr_conduction_step(p, 1, 1.0, 2, one, out), MDR_EINVALID, "entry 2 of time");
    CHECK_STATUS(mdr_conduction_step(p, 1, 1.0, 1, NULL, out), MDR_ENULL, "time");
    CHECK_SUCCESS(mdr_conduction_step(p, 1, 1.0, 0, NULL, NULL));
    CHECK_SUCCESS(mdr_conduction_free(&p));
    CHECK_SUCCESS(mdr_conduction_new(1, &layer, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &p));
    CHECK_STATUS(mdr_conduction_spot(p, 2, one, out, more), MDR_EINVALID, "radius = -1");
    CHECK_STATUS(mdr_conduction_spot(p, -1, one, out, more), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_conduction_spot(NULL, 1, one, out, more), MDR_ENULL, "p");
    CHECK_STATUS(mdr_conduction_field(p, 1, 1.0, 1, 1, 1, one, NULL, out), MDR_EDOMAIN, "r = 1");
    CHECK_STATUS(mdr_conduction_field(p, 2, 1.0, 1, 1, 1, one, NULL, out), MDR_ENULL, "z");
    CHECK_STATUS(mdr_conduction_field(p, 5, 1.0, 1, 1, 1, one, one, out), MDR_EINVALID, "field = 5");
    CHECK_STATUS(mdr_conduction_field(p, 2, 1.0, 2, 1, 1, one, one, out), MDR_EINVALID, "body = 2");
    CHECK_STATUS(mdr_conduction_field(p, 2, 1.0, 1, 2, 1, one, one, out), MDR_EINVALID, "below = 2");
    CHECK_SUCCESS(mdr_material_elastic(1.0, 0.3, &other));
    CHECK_STATUS(mdr_conduction_spot((mdr_conduction *)other, 1, one, out, more), MDR_EINVALID, "mdr_conduction");
    CHECK_SUCCESS(mdr_material_free(&other));
    CHECK_SUCCESS(mdr_conduction_free(&p));
    CHECK_SUCCESS(mdr_conduction_free(NULL));
    CHECK_TRUE(out[0] == 7.0 && out[1] == 7.0 && more[0] == 7.0);
}

int main(void)
{
    test_half_space();
    test_pair();
    test_refusals();
    return check_report("conduction");
}
