/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Gao's weights: refusals, then limits, complements and closed values. */
#include "check.h"

static const int weights[] = {MDR_WEIGHT_PHI, MDR_WEIGHT_I0, MDR_WEIGHT_I1, MDR_WEIGHT_J0, MDR_WEIGHT_J1};
static const double pi = 3.14159265358979323846;

static void refusals(int weight)
{
    const double xi[3] = {0.5, 1.0, 2.0}, negative[3] = {0.5, -1.0, 2.0}, not_a_number[3] = {0.5, 1.0, NAN};
    const double infinite[1] = {INFINITY};
    double out[3];

    fill_untouched(3, out);
    CHECK_STATUS(mdr_weight(weight, 0.3, 3, NULL, out), MDR_ENULL, "xi is NULL");
    CHECK_STATUS(mdr_weight(weight, 0.3, 3, xi, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_weight(weight, 0.3, -1, xi, out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_weight(weight, 0.3, 3, negative, out), MDR_EINVALID, "entry 2 of xi = -1");
    CHECK_STATUS(mdr_weight(weight, 0.3, 3, not_a_number, out), MDR_EINVALID, "entry 3 of xi = NaN");
    CHECK_STATUS(mdr_weight(weight, 0.3, 1, infinite, out), MDR_EINVALID, "entry 1 of xi = infinity");
    CHECK_STATUS(mdr_weight(weight, 0.51, 3, xi, out), MDR_EINVALID, "nu = 0.51");
    CHECK_STATUS(mdr_weight(weight, -1.0, 3, xi, out), MDR_EINVALID, "nu = -1");
    CHECK_STATUS(mdr_weight(weight, NAN, 3, xi, out), MDR_EINVALID, "nu = NaN");
    CHECK_STATUS(mdr_weight(weight, NAN, 0, NULL, NULL), MDR_EINVALID, "nu = NaN");
    CHECK_STATUS(mdr_weight(0, 0.3, 3, xi, out), MDR_EINVALID, "weight = 0");
    CHECK_UNTOUCHED(3, out);
    CHECK_SUCCESS(mdr_weight(weight, 0.3, 0, NULL, NULL));
}

static void closed_values(void)
{
    const double xi[4] = {0.0, 1e-3, 1.0, 1e3}, nu = 0.5;
    double phi[4], i0[4], i1[4], j0[4], j1[4];

    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_PHI, nu, 4, xi, phi));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, nu, 4, xi, i0));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I1, nu, 4, xi, i1));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_J0, nu, 4, xi, j0));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_J1, nu, 4, xi, j1));
    for (int i = 0; i < 4; i++) {
        const double x = xi[i], square = x * x;
        CHECK_CLOSE(phi[i], (1 + 3 * square) / (pi * (1 + square) * (1 + square)), 1e-15);
        CHECK_CLOSE(i0[i] + j0[i], 1.0, 1e-15);
        CHECK_CLOSE(i1[i] + j1[i], 1.0, 1e-15);
        CHECK_CLOSE(i0[i], (2 / pi) * atan(x) - x / (pi * (1 + square)), 1e-14);
    }
    CHECK_CLOSE(i0[2], 0.5 - 1 / (2 * pi), 1e-15);
    CHECK_CLOSE(i1[2], 0.5 + log(2.0) / pi, 1e-15);
    CHECK_CLOSE(i0[0], 0.0, 0.0);
    CHECK_CLOSE(i1[0], 0.0, 0.0);
    /* 1 - I0 -> 3/(pi xi) for large xi: (2/pi) atan(1/xi) + xi/(pi (1 + xi^2)) */
    CHECK_CLOSE(j0[3], (2 / pi) * atan(1e-3) + 1e3 / (pi * (1 + 1e6)), 1e-14);
}

static void compressible_values(void)
{
    const double xi[2] = {0.3, 4.0}, nu = 0.2;
    double i0[2], in_place[2] = {0.3, 4.0};

    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, nu, 2, xi, i0));
    for (int i = 0; i < 2; i++) {
        const double x = xi[i];
        const double expected = (2 / pi) * atan(x)
            + ((1 - 2 * nu) * x * log((1 + x * x) / (x * x)) - x / (1 + x * x)) / (2 * pi * (1 - nu));
        CHECK_CLOSE(i0[i], expected, 1e-14);
    }
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_I0, nu, 2, in_place, in_place));
    CHECK_CLOSE(in_place[0], i0[0], 1e-15);
    CHECK_CLOSE(in_place[1], i0[1], 1e-15);
}

int main(void)
{
    for (size_t i = 0; i < sizeof weights / sizeof *weights; i++) refusals(weights[i]);
    closed_values();
    compressible_values();
    return check_report("weights");
}
