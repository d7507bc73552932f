/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Poroelastic gels: elastic limits, units, refusals. */
#include "check.h"
#include "mdrcontact/poroelastic.h"

enum { N = 5 };

static void test_limits(const mdr_poroelastic *gel, double nu)
{
    const double time[N] = {0.0, 1e-3, 0.1, 10.0, 1e30}, omega[2] = {1e24, 1e-24};
    const double G = 3.0, D = 2.0, a = 0.5, at_once = 8.0 * G * a, at_last = 4.0 * G * a / (1.0 - nu);
    double force[N], again[N], depth[N], storage[2], loss[2];

    CHECK_SUCCESS(mdr_poroelastic_response(gel, MDR_RELAXATION, G, D, a, N, time, force));
    CHECK_CLOSE(force[0], at_once, 1e-12);
    CHECK_CLOSE(force[N - 1], at_last, 1e-12);
    for (int i = 1; i < N; i++) CHECK_TRUE(force[i] < force[i - 1]);
    CHECK_SUCCESS(mdr_poroelastic_response(gel, MDR_CREEP, G, D, a, N, time, depth));
    CHECK_CLOSE(depth[0], 1.0 / at_once, 1e-12);
    CHECK_CLOSE(depth[N - 1], 1.0 / at_last, 1e-12);
    for (int i = 1; i < N; i++) CHECK_TRUE(depth[i] * force[i] < 1.0 + 1e-12);
    CHECK_SUCCESS(mdr_poroelastic_dynamic_stiffness(gel, G, D, a, 2, omega, storage, loss));
    CHECK_CLOSE(storage[0], at_once, 1e-9);
    CHECK_CLOSE(storage[1], at_last, 1e-9);
    CHECK_TRUE(loss[0] >= 0.0 && loss[1] >= 0.0 && loss[0] < 1e-9 && loss[1] < 1e-9);
    /* lengths doubled, time in quarters: the same in place */
    memcpy(again, time, sizeof again);
    CHECK_SUCCESS(mdr_poroelastic_response(gel, MDR_RELAXATION, G, 4.0 * D, 2.0 * a, N, again, again));
    for (int i = 0; i < N; i++) CHECK_CLOSE(again[i], 2.0 * force[i], 1e-14);
}

/* tests/data/poroelastic.csv, nu = 0.3, mixed drainage */
static void test_paraboloid(const mdr_poroelastic *gel)
{
    const double time[2] = {0.3, 3.0};
    double force[2];

    CHECK_SUCCESS(mdr_poroelastic_response(gel, MDR_PARABOLOID_RELAXATION, 1.0, 1.0, 1.0, 2, time, force));
    CHECK_CLOSE(force[0], 16.0 / 3.0 * 0.8584312823880124, 1e-6);
    CHECK_CLOSE(force[1], 16.0 / 3.0 * 0.750836446149805, 1e-6);
}

/* what answers a ramp is the mean of what answers a step: by Simpson's rule in time^(1/2), as answers begin with it */
static void test_means(const mdr_poroelastic *gel)
{
    enum { HALVES = 200 };
    const int step[2] = {MDR_RELAXATION, MDR_CREEP};
    const int ramp[2] = {MDR_MEAN_RELAXATION, MDR_MEAN_CREEP};
    const double last = 0.7;
    double time[HALVES + 1], values[HALVES + 1], mean;

    for (int i = 0; i <= HALVES; i++) time[i] = last * i * i / HALVES / HALVES;
    for (int k = 0; k < 2; k++) {
        double sum = 0.0;
        CHECK_SUCCESS(mdr_poroelastic_response(gel, step[k], 1.0, 1.0, 1.0, HALVES + 1, time, values));
        for (int i = 0; i <= HALVES; i++) sum += (i == HALVES ? 1 : 2 + 2 * (i % 2)) * 2.0 * i / HALVES * values[i] / 3.0 / HALVES;
        CHECK_SUCCESS(mdr_poroelastic_response(gel, ramp[k], 1.0, 1.0, 1.0, 1, &last, &mean));
        CHECK_CLOSE(mean, sum, 1e-6);
    }
}

/* a path of any shape: linear between its times, pulled out at last */
static const double path_time[N] = {0.5, 0.7, 1.0, 1.2, 2.0}, path[N] = {0.1, 0.4, 0.4, 0.2, -0.1};

/* a gel that has not drained, and one that drains immediately, are elastic bodies */
static void test_history_limits(const mdr_poroelastic *gel, double nu)
{
    const double G = 3.0, a = 0.5, at_once = 8.0 * G * a, at_last = 4.0 * G * a / (1.0 - nu);
    double out[N];

    CHECK_SUCCESS(mdr_poroelastic_history(gel, MDR_DEPTH, G, 1e-30, a, N, path_time, path, out));
    for (int i = 0; i < N; i++) CHECK_CLOSE(out[i], at_once * path[i], 1e-12);
    CHECK_SUCCESS(mdr_poroelastic_history(gel, MDR_FORCE, G, 1e-30, a, N, path_time, path, out));
    for (int i = 0; i < N; i++) CHECK_CLOSE(out[i], path[i] / at_once, 1e-12);
    CHECK_SUCCESS(mdr_poroelastic_history(gel, MDR_DEPTH, G, 1e30, a, N, path_time, path, out));
    CHECK_CLOSE(out[0], at_once * path[0], 1e-12);
    for (int i = 1; i < N; i++) CHECK_CLOSE(out[i], at_last * path[i], 1e-12);
}

/* any path is a sum of small steps, each halfway up */
static void test_history_of_steps(const mdr_poroelastic *gel)
{
    enum { STEPS = 400 };
    const int given[2] = {MDR_DEPTH, MDR_FORCE}, answer[2] = {MDR_RELAXATION, MDR_CREEP};
    const double G = 3.0, D = 2.0, a = 0.5;
    double since[4 * STEPS + 1], answers[4 * STEPS + 1], out[N], again[N];

    for (int k = 0; k < 2; k++) {
        CHECK_SUCCESS(mdr_poroelastic_history(gel, given[k], G, D, a, N, path_time, path, out));
        for (int i = 0; i < N; i++) {
            double sum = 0.0;
            since[0] = path_time[i] - path_time[0];
            for (int j = 0; j < i * STEPS; j++) {
                const int from = j / STEPS;
                const double part = (j % STEPS + 0.5) / STEPS;
                since[j + 1] = path_time[i] - path_time[from] - part * (path_time[from + 1] - path_time[from]);
            }
            CHECK_SUCCESS(mdr_poroelastic_response(gel, answer[k], G, D, a, i * STEPS + 1, since, answers));
            sum = path[0] * answers[0];
            for (int j = 0; j < i * STEPS; j++) sum += (path[j / STEPS + 1] - path[j / STEPS]) / STEPS * answers[j + 1];
            CHECK_CLOSE(out[i], sum, 1e-4);
        }
        /* in place */
        memcpy(again, path, sizeof again);
        CHECK_SUCCESS(mdr_poroelastic_history(gel, given[k], G, D, a, N, path_time, again, again));
        CHECK_TRUE(memcmp(again, out, sizeof out) == 0);
    }
}

static void test_history_refusals(const mdr_poroelastic *gel)
{
    const double time[3] = {0.0, 1.0, 1.0}, bad_time[2] = {0.0, NAN}, in[3] = {1.0, 2.0, 1.0}, bad[2] = {1.0, NAN};
    double out[3] = {7.0, 7.0, 7.0};

    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_RADIUS, 1.0, 1.0, 1.0, 2, time, in, out), MDR_EINVALID, "given = 103");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 0.0, 1.0, 1.0, 2, time, in, out), MDR_EINVALID, "shear_modulus = 0");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, NAN, 1.0, 2, time, in, out), MDR_EINVALID, "diffusivity");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, -1.0, 2, time, in, out), MDR_EINVALID, "radius = -1");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 3, time, in, out), MDR_EINVALID, "entry 3 of time");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 2, bad_time, in, out), MDR_EINVALID, "entry 2 of time");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 2, time, bad, out), MDR_EINVALID, "entry 2 of depth");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_FORCE, 1.0, 1.0, 1.0, 2, time, bad, out), MDR_EINVALID, "entry 2 of force");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1e300, 1e-300, 2, time, in, out), MDR_ENOCONVERGENCE, "range");
    CHECK_STATUS(mdr_poroelastic_history(NULL, MDR_DEPTH, 1.0, 1.0, 1.0, 2, time, in, out), MDR_ENULL, "p");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 2, NULL, in, out), MDR_ENULL, "time");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 2, time, NULL, out), MDR_ENULL, "in");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 2, time, in, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, -1, time, in, out), MDR_EINVALID, "n = -1");
    CHECK_SUCCESS(mdr_poroelastic_history(gel, MDR_DEPTH, 1.0, 1.0, 1.0, 0, NULL, NULL, NULL));
    CHECK_TRUE(out[0] == 7.0 && out[1] == 7.0 && out[2] == 7.0);
}

static void test_compliance(void)
{
    const double k = 0.3, fast = 1e20, slow[2] = {0.2, -0.2}, waves[2] = {0.3, 0.3};
    double out = 0.0, more = 0.0, both[2], ahead[2], many[64], quick[64], found[64];

    CHECK_SUCCESS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SEALED, 0.0, 2.0, 1.0, 2, waves, slow, both, ahead));
    CHECK_TRUE(ahead[0] < 0.0 && ahead[1] == -ahead[0] && both[0] == both[1]);
    /* drained, (1 - nu)/(G k), and at once 1/(2 G k) */
    CHECK_SUCCESS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SEALED, 0.0, 2.0, 1.0, 1, &k, NULL, &out, &more));
    CHECK_CLOSE(out, 0.4 / k, 1e-12);
    CHECK_SUCCESS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SURFACE, 0.0, 2.0, 1.0, 1, &k, &fast, &out, NULL));
    CHECK_CLOSE(out, 0.25 / k, 1e-8);
    /* at rest without frequencies, whatever the call before has left in memory */
    for (int i = 0; i < 64; i++) many[i] = k, quick[i] = fast;
    CHECK_SUCCESS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SURFACE, 0.0, 2.0, 1.0, 64, many, quick, found, NULL));
    CHECK_SUCCESS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SURFACE, 0.0, 2.0, 1.0, 64, many, NULL, found, NULL));
    for (int i = 0; i < 64; i++) CHECK_CLOSE(found[i], 0.4 / k, 1e-12);
    CHECK_STATUS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_INDENTER, 0.0, 2.0, 1.0, 1, &k, NULL, &out, &more), MDR_EINVALID,
                 "drainage = 3");
    CHECK_STATUS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SURFACE, -1.0, 2.0, 1.0, 1, &k, NULL, &out, &more), MDR_EINVALID,
                 "thickness");
    CHECK_STATUS(mdr_poroelastic_compliance(0.2, MDR_DRAINAGE_SURFACE, 0.0, 2.0, 1.0, 1, NULL, NULL, &out, &more), MDR_ENULL, "k");
}

static void test_pressure(const mdr_poroelastic *gel)
{
    const double r[3] = {0.0, 0.3, 0.6}, edge[1] = {1.0};
    double early[3], pore[3], out = 7.0;

    /* at first that of an incompressible body, 2 G/((1 - nu) pi a) / sqrt(1 - r^2/a^2), and the fluid bears it */
    CHECK_SUCCESS(mdr_poroelastic_pressure(gel, MDR_TOTAL_PRESSURE, 1, 1.0, 1.0, 1.0, 1e-3, 3, r, early));
    CHECK_SUCCESS(mdr_poroelastic_pressure(gel, MDR_PORE_PRESSURE, 1, 1.0, 1.0, 1.0, 1e-3, 3, r, pore));
    for (int i = 0; i < 3; i++) {
        CHECK_CLOSE(early[i], 4.0 / (acos(-1.0) * sqrt(1.0 - r[i] * r[i])), 3e-2);
        CHECK_CLOSE(pore[i], early[i], 5e-2);
    }
    CHECK_STATUS(mdr_poroelastic_pressure(gel, MDR_TOTAL_PRESSURE, 1, 1.0, 1.0, 1.0, 1.0, 1, edge, &out), MDR_EDOMAIN, "r = 1");
    CHECK_STATUS(mdr_poroelastic_pressure(gel, 3, 1, 1.0, 1.0, 1.0, 1.0, 1, r, &out), MDR_EINVALID, "kind = 3");
    CHECK_STATUS(mdr_poroelastic_pressure(gel, MDR_PORE_PRESSURE, 2, 1.0, 1.0, 1.0, 1.0, 1, r, &out), MDR_EINVALID, "is_flat");
    CHECK_STATUS(mdr_poroelastic_pressure(gel, MDR_PORE_PRESSURE, 1, 1.0, 1.0, 1.0, 1e-9, 1, r, &out), MDR_EDOMAIN, "time");
    CHECK_TRUE(out == 7.0);
}

static void test_refusals(mdr_poroelastic *gel)
{
    const double time[2] = {1.0, -1.0};
    double out[2] = {7.0, 7.0}, loss[2] = {7.0, 7.0};
    mdr_poroelastic *none = NULL;
    mdr_material *other = NULL;

    CHECK_STATUS(mdr_poroelastic_new(0.5, MDR_DRAINAGE_SURFACE, 0.0, NULL, &none), MDR_EINVALID, "nu = 0.5");
    CHECK_STATUS(mdr_poroelastic_new(NAN, MDR_DRAINAGE_SURFACE, 0.0, NULL, &none), MDR_EINVALID, "nu");
    CHECK_STATUS(mdr_poroelastic_new(0.2, 0, 0.0, NULL, &none), MDR_EINVALID, "drainage = 0");
    CHECK_STATUS(mdr_poroelastic_new(0.2, MDR_DRAINAGE_INDENTER, 1.0, NULL, &none), MDR_EINVALID, "film");
    CHECK_STATUS(mdr_poroelastic_new(0.2, MDR_DRAINAGE_SURFACE, 1e3, NULL, &none), MDR_EINVALID, "ratio = 1000");
    CHECK_STATUS(mdr_poroelastic_new(0.2, MDR_DRAINAGE_SURFACE, 0.0, NULL, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_poroelastic_response(gel, 9, 1.0, 1.0, 1.0, 1, time, out), MDR_EINVALID, "answer = 9");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 0.0, 1.0, 1.0, 1, time, out), MDR_EINVALID, "shear_modulus = 0");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, -1.0, 1.0, 1, time, out), MDR_EINVALID, "diffusivity = -1");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1.0, NAN, 1, time, out), MDR_EINVALID, "radius");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1.0, 1.0, 2, time, out), MDR_EINVALID, "entry 2 of time");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1e300, 1e-300, 1, time, out), MDR_ENOCONVERGENCE, "range");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1.0, 1.0, 1, NULL, out), MDR_ENULL, "time");
    CHECK_STATUS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1.0, 1.0, -1, time, out), MDR_EINVALID, "n = -1");
    CHECK_SUCCESS(mdr_poroelastic_response(gel, MDR_RELAXATION, 1.0, 1.0, 1.0, 0, NULL, NULL));
    CHECK_STATUS(mdr_poroelastic_dynamic_stiffness(gel, 1.0, 1.0, 1.0, 2, time, out, loss), MDR_EINVALID, "entry 2 of omega");
    CHECK_STATUS(mdr_poroelastic_dynamic_stiffness(gel, 1.0, 1.0, 1.0, 1, time, NULL, loss), MDR_ENULL, "storage");
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &other));
    CHECK_STATUS(mdr_poroelastic_response((mdr_poroelastic *)other, MDR_RELAXATION, 1.0, 1.0, 1.0, 1, time, out), MDR_EINVALID,
                 "mdr_poroelastic");
    CHECK_FREE(other);
    CHECK_TRUE(none == NULL && out[0] == 7.0 && out[1] == 7.0 && loss[0] == 7.0);
}

/* One table: under valgrind each takes a minute. The other drainages have the Python tests. */
int main(void)
{
    mdr_poroelastic *gel = NULL;
    double deviation = 1.0;

    CHECK_SUCCESS(mdr_poroelastic_new(0.3, MDR_DRAINAGE_INDENTER, 0.0, &deviation, &gel));
    CHECK_TRUE(deviation > 0.0 && deviation < 1e-6);
    test_limits(gel, 0.3);
    test_paraboloid(gel);
    test_means(gel);
    test_history_limits(gel, 0.3);
    test_history_of_steps(gel);
    test_history_refusals(gel);
    test_compliance();
    test_pressure(gel);
    test_refusals(gel);
    CHECK_FREE(gel);
    CHECK_TRUE(gel == NULL);
    CHECK_FREE(gel);
    CHECK_SUCCESS(mdr_free(NULL));
    return check_report("poroelastic");
}
