/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The ways through a law give the same bits: inline, library, and batches of one, two and four points at a time. */
#include "check.h"
#include "mdrcontact/all.h"

#define mdrcontact_law_points points_of_test
#include "../../src/mdrcontact/contact/law/kernel.c"

enum { N = 4003 };

/* With a cohesive stress, on the exact body. */
static mdr_law *ranged_law_with(double work_of_adhesion, double cohesive_stress, double flat, int continue_beyond)
{
    mdr_profile *tip = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    mdr_contact_options options;
    mdr_law_options law_options;

    options = MDR_SIZED(mdr_contact_options);
    law_options = MDR_SIZED(mdr_law_options);
    options.work_of_adhesion = work_of_adhesion;
    options.cohesive_stress = cohesive_stress;
    law_options.continue_beyond = continue_beyond;
    if (flat > 0.0) {
        CHECK_SUCCESS(mdr_profile_rounded_cone(0.5, flat, &tip));
    } else {
        CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &tip));
    }
    CHECK_SUCCESS(new_coated(3.0, 0.3, 0.5, 1.0, 0.4, cohesive_stress > 0.0 ? MDR_MODEL_EXACT : MDR_MODEL_GAO, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(tip, film, &options, &contact));
    CHECK_SUCCESS(mdr_law_new(contact, 1.0, &law_options, &law));
    CHECK_FREE(contact);
    CHECK_FREE(film);
    CHECK_FREE(tip);
    return law;
}

static mdr_law *law_with(double work_of_adhesion, double flat, int continue_beyond)
{
    return ranged_law_with(work_of_adhesion, 0.0, flat, continue_beyond);
}

static int same(double a, double b) { return memcmp(&a, &b, sizeof a) == 0; }

/* How many outputs of a batch differ from those of points one by one. */
static int differences(const mdr_law *law, int branch, const double d[], const double F[], const double slope[], const double a[],
                       const double k[])
{
    int count = 0;
    for (int i = 0; i < N; ++i) {
        mdr_law_point point = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
        CHECK_SUCCESS(law_point(law, MDR_DEPTH, branch, d[i], &point));
        count += !same(F[i], point.force) + !same(slope[i], point.slope) + !same(a[i], point.radius) + !same(k[i], point.stiffness);
    }
    return count;
}

static void test_bits(double work_of_adhesion, double flat, int branch)
{
    static double d[N], F[N], slope[N], a[N], k[N], only_F[N], also_F[N], also_slope[N], untouched = 3.0;
    mdr_law *law = law_with(work_of_adhesion, flat, 0);
    mdr_law_view view = {0};
    int inside = 0;

    CHECK_SUCCESS(mdr_law_view_of(law, branch, &view));
    for (int i = 0; i < N; ++i) d[i] = pow((i - 100.0) / (N - 101.0), 3.0);
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, a, F, k, slope, NULL));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, NULL, only_F, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, NULL, also_F, NULL, also_slope, NULL));
    CHECK_INT(differences(law, branch, d, F, slope, a, k), 0);
    CHECK_INT(memcmp(F, only_F, sizeof F) + memcmp(F, also_F, sizeof F) + memcmp(slope, also_slope, sizeof F), 0);
    for (int i = 0; i < N; ++i) {
        double one, other, rise, external, energy;
        mdr_law_point state, point;
        CHECK_SUCCESS(mdr_law_view_state(&view, d[i], &state));
        CHECK_SUCCESS(law_point(law, MDR_DEPTH, branch, d[i], &point));
        CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, 1, &d[i], NULL, NULL, NULL, NULL, NULL, &energy));
        CHECK_TRUE(memcmp(&state, &point, sizeof state) == 0 && same(state.energy, energy));
        CHECK_SUCCESS(mdr_law_view_force(&view, d[i], &one));
        CHECK_SUCCESS(mdr_law_view_force_slope(&view, d[i], &other, &rise));
        CHECK_SUCCESS(mdr_law_force(law, branch, d[i], &external, NULL));
        CHECK_TRUE(same(one, F[i]) && same(other, F[i]) && same(rise, slope[i]) && same(external, F[i]));
        inside += d[i] >= view.lowest && d[i] <= view.highest;
    }
    CHECK_TRUE(work_of_adhesion > 0.0 ? inside == 0 : inside > N / 3);
    CHECK_INT(mdr_law_view_force(&view, 2.0, &F[0]), MDR_EDOMAIN);
    CHECK_INT(mdr_law_view_force_slope(&view, NAN, &F[0], &slope[0]), MDR_EINVALID);
    mdr_law_point none;
    CHECK_INT(mdr_law_view_state(&view, INFINITY, &none), MDR_EINVALID);
    CHECK_INT(mdr_law_view_force(&view, -INFINITY, &F[1]), MDR_EINVALID);
    CHECK_STATUS(mdr_law_force(law, branch, -INFINITY, &untouched, NULL), MDR_EINVALID, "depth = ");
    CHECK_TRUE(untouched == 3.0);
    CHECK_TRUE(isnan(none.force) && isnan(F[0]) && isnan(slope[0]));
    CHECK_FREE(law);
}

/* The buffer of a law; the law is gone. */
static double *buffer_of(mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    double *buffer = malloc((size_t)facts.buffer_size * sizeof *buffer);
    CHECK_SUCCESS(mdr_law_buffer(law, facts.buffer_size, buffer));
    CHECK_CLOSE(((const mdr_law_head *)buffer)->size, (double)facts.buffer_size, 0.0);
    return buffer;
}

/* Deep and shallow, back and forth, near the ends of segments and beyond the largest depth. */
static double some_depth(const mdr_law_head *head, int i)
{
    const double u = fabs(fmod(0.6180339887498949 * i, 1.0)), span = head->highest - head->lowest;
    switch (i % 8) {
    case 0: return head->lowest * (i % 3 ? 1.0 : 1.0 - 4e-16) + span * pow(u, 9.0);
    case 1: return head->highest * (1.0 - pow(u, 9.0));
    case 2: return -span * pow(u, 5.0);
    case 3: return head->highest * pow(10.0, -12.0 * u);
    case 4: return head->lowest * u;
    case 5: return head->continues != 0.0 ? head->highest + span * u : head->highest;
    case 6: return i % 3 ? 0.0 : DBL_MIN * u;
    default: return head->lowest + span * u;
    }
}

/* A copy of the buffer elsewhere says what the library's Fortran says, where the law itself answers in arrays. */
static void test_copy(double work_of_adhesion, double cohesive_stress, double flat, int continue_beyond)
{
    static double d[N], F[N], slope[N], a[N], k[N], U[N];
    for (int branch = MDR_ON_LOADING; branch <= MDR_ON_UNLOADING; ++branch) {
        mdr_law *law = ranged_law_with(work_of_adhesion, cohesive_stress, flat, continue_beyond);
        double *buffer = buffer_of(law);
        mdr_law_view view = {0};
        int segment = 0, followed = 0, failures = 0;

        CHECK_SUCCESS(mdr_law_view_from(buffer, branch, &view));
        for (int i = 0; i < N; ++i) d[i] = some_depth((const mdr_law_head *)buffer, i);
        CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, a, F, k, slope, NULL));
        CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, NULL, NULL, NULL, NULL, U));
        for (int i = 0; i < N; ++i) {
            mdr_law_point state, point, other;
            double force, rise;
            failures += mdr_law_view_state(&view, d[i], &state) + mdr_law_view_force_slope(&view, d[i], &force, &rise);
            failures += !(same(state.force, F[i]) && same(state.slope, slope[i]) && same(state.radius, a[i]));
            failures += !(same(state.stiffness, k[i]) && same(state.energy, U[i]) && same(force, F[i]) && same(rise, slope[i]));
            failures += mdr_law_follow(law, d[i], &segment, &point) + mdr_law_view_follow(&view, d[i], &followed, &other);
            failures += segment != followed || memcmp(&point, &other, sizeof point) != 0;
        }
        CHECK_INT(failures, 0);
        if (cohesive_stress > 0.0 && branch == MDR_ON_LOADING) { /* attracted from a distance on */
            CHECK_CLOSE(view.open, -work_of_adhesion / cohesive_stress, 1e-12);
            segment = 0;
            CHECK_SUCCESS(mdr_law_view_follow(&view, -0.99 * work_of_adhesion / cohesive_stress, &segment, &(mdr_law_point){0}));
            CHECK_TRUE(segment > 0);
        }
        CHECK_INT(mdr_law_view_follow(&view, 0.1, &(int){99}, &(mdr_law_point){0}), MDR_EINVALID);
        free(buffer);
        CHECK_FREE(law);
    }
}

#ifdef MDRCONTACT_CONDUCTION_H
/* A law that conducts: inline, from a copy of its buffer, and from its file, with the bits of the library; near the solution. */
static void test_conductance(double work_of_adhesion)
{
    static double d[N], G[N], slope[N], a[N], again[N];
    const mdr_conductor layers[2] = {{0.5, 0.1, 0.1, 0.0, 0.0}, {0.0, 1.0, 1.0, 0.0, 0.0}};
    mdr_conduction *conduction = NULL;
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL, *read = NULL, *none = NULL;
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    mdr_law_options law_options = MDR_SIZED(mdr_law_options);
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr_law_view view = {0};
    int length, failures = 0;

    options.work_of_adhesion = work_of_adhesion;
    CHECK_SUCCESS(mdr_conduction_new(2, layers, MDR_BASE_HALF_SPACE, 0, NULL, 0, 0.0, 0.0, &conduction));
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(new_coated(3.0, 0.3, 0.5, 1.0, 0.4, MDR_MODEL_GAO, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(ball, film, &options, &contact));
    law_options.conduction = conduction;
    law_options.tolerance = 1e-8;
    CHECK_SUCCESS(mdr_law_new(contact, 1.0, &law_options, &law));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    CHECK_INT(facts.conducts, 1);
    CHECK_SUCCESS(mdr_law_write(law, NULL, 0, &length));
    char *text = malloc((size_t)length + 1);
    CHECK_SUCCESS(mdr_law_write(law, text, length + 1, &length));
    CHECK_SUCCESS(mdr_law_read(text, length, &read));
    free(text);
    for (int branch = MDR_ON_LOADING; branch <= MDR_ON_UNLOADING; ++branch) {
        CHECK_SUCCESS(mdr_law_view_of(law, branch, &view));
        for (int i = 0; i < N; ++i) d[i] = some_depth(mdr_law_head_of(&view), i);
        CHECK_SUCCESS(mdr_law_conductance(law, branch, N, d, G, slope));
        CHECK_SUCCESS(mdr_law_conductance(read, branch, N, d, again, NULL));
        CHECK_INT(memcmp(G, again, sizeof G), 0);
        CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, branch, N, d, NULL, a, NULL, NULL, NULL, NULL));
        double *buffer = malloc((size_t)facts.buffer_size * sizeof *buffer);
        CHECK_SUCCESS(mdr_law_buffer(law, facts.buffer_size, buffer));
        CHECK_SUCCESS(mdr_law_view_from(buffer, branch, &view));
        for (int i = 0; i < N; ++i) {
            double one, rise, exact;
            failures += mdr_law_view_conductance(&view, d[i], &one, &rise) != MDR_SUCCESS;
            failures += !same(one, G[i]) + !same(rise, slope[i]);
            if (i % 40 || a[i] <= 1e-3) continue;
            CHECK_SUCCESS(mdr_conduction_spot(conduction, 1, &a[i], &exact, NULL));
            if (d[i] >= mdr_law_head_of(&view)->lowest) CHECK_CLOSE(G[i], exact, 2e-8);
        }
        CHECK_INT(failures, 0);
        free(buffer);
    }
    CHECK_STATUS(mdr_law_conductance(law, MDR_ON_UNLOADING, 1, (double[]){7.0}, G, slope), MDR_EDOMAIN, "depth = 7");
    CHECK_STATUS(mdr_law_conductance(law, 5, 1, d, G, slope), MDR_EINVALID, "branch");
    CHECK_STATUS(mdr_law_conductance(law, MDR_ON_UNLOADING, 1, NULL, G, slope), MDR_ENULL, "d");
    CHECK_STATUS(mdr_law_conductance(law, MDR_ON_UNLOADING, -1, d, G, slope), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_law_conductance(NULL, MDR_ON_UNLOADING, 1, d, G, slope), MDR_ENULL, "law");
    law_options.conduction = (const mdr_conduction *)ball;
    CHECK_STATUS(mdr_law_new(contact, 1.0, &law_options, &none), MDR_EINVALID, "options.conduction");
    none = law_with(work_of_adhesion, 0.0, 0);
    CHECK_STATUS(mdr_law_conductance(none, MDR_ON_UNLOADING, 1, d, G, slope), MDR_EINVALID, "it has no conductance");
    CHECK_SUCCESS(mdr_law_view_of(none, MDR_ON_UNLOADING, &view));
    CHECK_INT(mdr_law_view_conductance(&view, 0.5, G, slope), MDR_EINVALID);
    CHECK_FREE(none);
    CHECK_FREE(read);
    CHECK_FREE(law);
    CHECK_FREE(contact);
    CHECK_FREE(film);
    CHECK_FREE(ball);
    CHECK_FREE(conduction);
}
#endif

static void test_power(void)
{
    double worst = 0.0;
    for (int i = 1; i < 200000; ++i) {
        const double x = pow(10.0, -300.0 * fmod(0.6180339887498949 * i, 1.0) * (i % 2)) * fmod(0.7548776662466927 * i, 1.0);
        const double p = 0.1 + 3.0 * fmod(0.5698402909980532 * i, 1.0), right = pow(x, p);
        if (right > DBL_MIN) worst = fmax(worst, fabs(mdr_law_power(x, p) / right - 1.0) / (1.0 + fabs(log(right))));
    }
    CHECK_TRUE(worst < 1e-15);
    CHECK_CLOSE(mdr_law_power(1.0, 1.4567), 1.0, 0.0);
    CHECK_CLOSE(mdr_law_power(4.9406564584124654e-324, 0.5), 2.2227587494850775e-162, 1e-12);
    CHECK_CLOSE(mdr_law_power(0.3, 0.0), 1.0, 0.0);
    CHECK_TRUE(mdr_law_power(1e-300, 11.0) == 0.0 && mdr_law_power(0.5, -1e-7) > 1.0);
}

typedef void points(const mdr_law_view *view, int n, const double s[], double F[], double slope[], double a[], double k[]);

/* All lanes and the rest that they leave, for every choice of outputs. */
static void test_lanes(points *some)
{
    mdr_law *law = law_with(0.0, 0.0, 0);
    mdr_law_view view = {0};

    CHECK_SUCCESS(mdr_law_view_of(law, MDR_ON_UNLOADING, &view));
    for (int n = 1; n < 11; ++n) {
        double d[11], one[4][11], other[4][11];
        for (int i = 0; i < n; ++i) d[i] = pow(10.0, -0.35 * (i + 1) - 0.01 * n);
        d[n / 2] = 0.0; /* moved to the end of the view */
        for (int wanted = 1; wanted < 16; ++wanted) {
            for (int j = 0; j < 4; ++j) {
                for (int i = 0; i < 11; ++i) one[j][i] = other[j][i] = -7.0;
            }
            double *to[4], *again[4];
            for (int j = 0; j < 4; ++j) to[j] = wanted >> j & 1 ? one[j] : NULL, again[j] = wanted >> j & 1 ? other[j] : NULL;
            some(&view, n, d, to[0], to[1], to[2], to[3]);
            one_by_one(&view, 0, n, d, again[0], again[1], again[2], again[3]);
            CHECK_INT(memcmp(one, other, sizeof one), 0);
            CHECK_TRUE(!(wanted & 1) || (one[0][n - 1] > 0.0 && one[0][n] == -7.0));
        }
    }
    CHECK_FREE(law);
}

/* One hard collision does not end a run, and the state says so. */
static void test_beyond(void)
{
    mdr_law *law = law_with(0.0, 0.0, 1);
    mdr_law_point last, point;
    mdr_law_view view = {0};
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double F, U, d;

    CHECK_SUCCESS(mdr_law_about(law, &facts));
    d = facts.highest_depth + 0.5;
    CHECK_SUCCESS(law_point(law, MDR_DEPTH, MDR_ON_UNLOADING, facts.highest_depth, &last));
    CHECK_SUCCESS(law_point(law, MDR_DEPTH, MDR_ON_UNLOADING, d, &point));
    CHECK_CLOSE(point.beyond, 0.5, 1e-12);
    CHECK_CLOSE(point.force, last.force + 0.5 * last.slope, 1e-12);
    CHECK_SUCCESS(mdr_law_view_of(law, MDR_ON_UNLOADING, &view));
    CHECK_SUCCESS(mdr_law_view_force(&view, d, &F));
    CHECK_TRUE(same(F, point.force));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 1, &d, NULL, NULL, &F, NULL, NULL, NULL));
    CHECK_TRUE(same(F, point.force));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 1, &d, NULL, NULL, NULL, NULL, NULL, &U));
    CHECK_CLOSE(U, point.energy, 0.0);
    CHECK_SUCCESS(law_point(law, MDR_FORCE, MDR_ON_UNLOADING, point.force, &last));
    CHECK_CLOSE(last.depth, d, 1e-7);
    CHECK_FREE(law);
}

static void test_refusals(void)
{
    mdr_law *law = law_with(0.0, 0.0, 0);
    mdr_law_point point;
    mdr_law_view view = {0};
    double d[2] = {0.5, 2.0}, U[2];

    CHECK_STATUS(mdr_law_view_of(NULL, MDR_ON_UNLOADING, &view), MDR_ENULL, "law");
    CHECK_STATUS(mdr_law_view_of(law, 5, &view), MDR_EINVALID, "branch");
    CHECK_STATUS(mdr_law_view_of(law, MDR_ON_UNLOADING, NULL), MDR_ENULL, "view");
    CHECK_STATUS(mdr_law_buffer(law, 7, d), MDR_EINVALID, "size = 7: the law has");
    CHECK_STATUS(mdr_law_buffer(law, 7000000, NULL), MDR_ENULL, "buffer");
    CHECK_STATUS(mdr_law_buffer(NULL, 7, d), MDR_ENULL, "law");
    CHECK_INT(mdr_law_view_from(NULL, MDR_ON_UNLOADING, &view), MDR_ENULL);
    CHECK_INT(mdr_law_view_from((double[22]){1.0}, MDR_ON_UNLOADING, &view), MDR_EINVALID);
    CHECK_STATUS(law_point(law, MDR_DEPTH, MDR_ON_UNLOADING, NAN, &point), MDR_EINVALID, "depth = NaN");
    CHECK_STATUS(law_point(law, MDR_FORCE, MDR_ON_UNLOADING, -1.0, &point), MDR_EUNREACHABLE, "the lowest force");
    CHECK_STATUS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 2, d, NULL, NULL, NULL, NULL, NULL, U), MDR_EDOMAIN,
                 "entry 2 of depth = 2");
    CHECK_STATUS(mdr_law_values(law, MDR_RADIUS, MDR_ON_UNLOADING, 2, d, NULL, NULL, NULL, NULL, NULL, U), MDR_EINVALID,
                 "given = 103 (radius)");
    CHECK_STATUS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 2, NULL, NULL, NULL, NULL, NULL, NULL, U), MDR_ENULL,
                 "d is NULL");
    CHECK_FREE(law);
}

int main(void)
{
    test_bits(0.0, 0.0, MDR_ON_UNLOADING);
    test_bits(0.0, 0.2, MDR_ON_LOADING);
    test_bits(0.05, 0.0, MDR_ON_UNLOADING);
    test_bits(0.05, 0.0, MDR_ON_LOADING);
    test_lanes(points_of_test);
#ifdef HAS_VECTORS
    test_lanes(by_two);
#endif
    test_copy(0.0, 0.0, 0.0, 0);
    test_copy(0.0, 0.0, 0.2, 1);
    test_copy(0.05, 0.0, 0.0, 0);
    test_copy(0.05, 0.0, 0.0, 1);
    test_copy(0.05, 0.02, 0.0, 0);
    test_copy(0.05, 0.5, 0.0, 1);
#ifdef MDRCONTACT_CONDUCTION_H
    test_conductance(0.0);
    test_conductance(0.05);
#endif
    test_power();
    test_beyond();
    test_refusals();
    return check_report("law_view");
}
