/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pull-off and loops of an adhesive paraboloid on a homogeneous body: refusals, then JKR. */
#include "check.h"

#include <limits.h>
#include <time.h>

static const double pi = 3.14159265358979323846;
static const double R = 2.0, modulus = 3.0, work = 0.05;

static mdr_contact *new_contact(double gamma)
{
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = gamma;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

/* The energy that a loop loses. */
static double lost_in(const mdr_loop *l)
{
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    CHECK_SUCCESS(mdr_loop_about(l, &facts));
    return facts.dissipated_energy;
}

static void pull_off_refuses(const mdr_contact *c)
{
    double d = untouched, a = untouched, F = untouched;
    int count = -7;

    CHECK_STATUS(pull_off_of(NULL, MDR_FORCE, 1, &d, &a, &F, NULL), MDR_ENULL, "c is NULL");
    CHECK_STATUS(pull_off_of(c, MDR_SPRING, 1, &d, &a, &F, NULL), MDR_EINVALID, "control = 104 (spring)");
    CHECK_STATUS(pull_off_of(c, -1, 1, &d, &a, &F, NULL), MDR_EINVALID, "control = -1");
    CHECK_STATUS(pull_off_of(c, MDR_FORCE, -1, &d, &a, &F, &count), MDR_EINVALID, "capacity = -1");
    CHECK_UNTOUCHED(1, &d);
    CHECK_UNTOUCHED(1, &a);
    CHECK_UNTOUCHED(1, &F);
    CHECK_INT(count, -7);
}

static void loop_refuses(const mdr_contact *c)
{
    const double bad[4] = {0.0, -1.0, NAN, INFINITY};
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    mdr_loop_point point;
    int number = -7;
    mdr_loop *l = NULL;

    CHECK_STATUS(mdr_loop_new(NULL, MDR_DEPTH, 0.5, 10, 0.0, &l), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_loop_new(c, MDR_DEPTH, 0.5, 10, 0.0, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_loop_new(c, 9, 0.5, 10, 0.0, &l), MDR_EINVALID, "control = 9");
    for (int i = 0; i < 4; i++) {
        CHECK_STATUS(mdr_loop_new(c, MDR_DEPTH, bad[i], 10, 0.0, &l), MDR_EINVALID, "largest = ");
        CHECK_STATUS(mdr_loop_new(c, MDR_SPRING, 0.5, 10, bad[i], &l), MDR_EINVALID, "spring_stiffness = ");
    }
    CHECK_STATUS(mdr_loop_new(c, MDR_DEPTH, 0.5, 1, 0.0, &l), MDR_EINVALID, "points = 1");
    CHECK_STATUS(mdr_loop_new(c, MDR_DEPTH, 0.5, -1, 0.0, &l), MDR_EINVALID, "points = -1");
    CHECK_STATUS(mdr_loop_new(c, MDR_DEPTH, 0.5, INT_MAX, 0.0, &l), MDR_EINVALID, "it must be from 2 to 1000000");
    CHECK_TRUE(l == NULL);
    fill_untouched(5, &point.position);
    CHECK_STATUS(mdr_loop_points(NULL, 1, &point, &number), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_about(NULL, &facts), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_about((const mdr_loop *)(const void *)c, &facts), MDR_EINVALID, "not a handle of type mdr_loop");
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(l);
    CHECK_SUCCESS(mdr_loop_new(c, MDR_DEPTH, 0.5, 10, 0.0, &l));
    CHECK_STATUS(mdr_loop_points(l, -1, &point, &number), MDR_EINVALID, "capacity = -1");
    CHECK_STATUS(mdr_loop_points(l, 1, NULL, &number), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_loop_about(l, NULL), MDR_ENULL, "facts is NULL");
    CHECK_UNTOUCHED(5, &point.position);
    CHECK_TRUE(facts.points == 0 && facts.dissipated_energy == 0.0);
    CHECK_INT(number, -7);
    CHECK_FREE(l);
    CHECK_TRUE(l == NULL);
}

/* Force control: F = -(3/2) pi gamma R at a^3 = 9 pi gamma R^2/(8 E*); depth control: F = -(5/6) pi gamma R at a ninth of it. */
static void jkr_pull_off(const mdr_contact *c)
{
    double d, a, F, ds[3], as[3], Fs[3];
    int count = 0;

    CHECK_SUCCESS(pull_off_of(c, MDR_FORCE, 1, &d, &a, &F, NULL));
    CHECK_CLOSE(F, -1.5 * pi * work * R, 1e-12);
    CHECK_CLOSE(a, cbrt(9 * pi * work * R * R / (8 * modulus)), 1e-6); /* at an extremum of F: half the digits */
    CHECK_SUCCESS(pull_off_of(c, MDR_DEPTH, 1, &d, &a, &F, NULL));
    CHECK_CLOSE(F, -5.0 / 6.0 * pi * work * R, 1e-6);
    CHECK_CLOSE(a, cbrt(pi * work * R * R / (8 * modulus)), 1e-6);
    CHECK_CLOSE(d, a * a / R - sqrt(2 * pi * a * work / modulus), 1e-12);
    CHECK_SUCCESS(pull_off_of(c, MDR_DEPTH, 1, NULL, NULL, NULL, NULL));
    CHECK_SUCCESS(pull_off_of(c, MDR_DEPTH, 3, ds, as, Fs, &count));
    CHECK_INT(count, 1);
    CHECK_CLOSE(ds[0], d, 1e-12);
    CHECK_CLOSE(as[0], a, 1e-12);
    CHECK_CLOSE(Fs[0], F, 1e-12);
    count = 0;
    CHECK_SUCCESS(pull_off_of(c, MDR_DEPTH, 0, NULL, NULL, NULL, &count));
    CHECK_INT(count, 1);
}

/* The energy lost under depth control does not depend on how far the indenter went: it is the work of the jump in at d = 0,
 * the area under F from there, and of the jump out. By quadrature over a of F dd along the stable branch from a(d = 0) down
 * to pull-off. */
static double lost_under_depth_control(void)
{
    const double out = cbrt(pi * work * R * R / (8 * modulus)), in = cbrt(2 * pi * work * R * R / modulus);
    const int n = 2000;
    double sum = 0;
    for (int i = 0; i <= n; i++) { /* Simpson */
        const double a = out + (in - out) * i / n;
        const double F = 4 * modulus * pow(a, 3) / (3 * R) - sqrt(8 * pi * pow(a, 3) * work * modulus);
        const double slope = 2 * a / R - sqrt(pi * work / (2 * modulus * a));
        sum += F * slope * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2);
    }
    return -sum * (in - out) / n / 3;
}

static void loop_under_depth_control(const mdr_contact *c)
{
    enum { CAPACITY = 200 };
    mdr_loop_point p[CAPACITY];
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    int count = 0, jumps = 0, index[2] = {-1, -1};
    mdr_loop *l = NULL;

    CHECK_SUCCESS(mdr_loop_new(c, MDR_DEPTH, 0.5, 20, 0.0, &l));
    CHECK_SUCCESS(mdr_loop_about(l, &facts));
    CHECK_TRUE(facts.points > 40 && facts.points <= CAPACITY);
    CHECK_INT(facts.jumps, 2);
    CHECK_SUCCESS(mdr_loop_points(l, CAPACITY, p, &count));
    CHECK_INT(count, facts.points);
    CHECK_CLOSE(p[facts.turning_point].position, 0.5, 1e-15);
    CHECK_CLOSE(p[facts.turning_point].depth, 0.5, 1e-15);
    for (int i = 0; i < count; i++) {
        CHECK_TRUE(p[i].jumps == 0.0 || p[i].jumps == 1.0);
        if (p[i].jumps == 1.0 && jumps < 2) index[jumps++] = i;
    }
    CHECK_INT(jumps, 2);
    CHECK_TRUE(index[0] < facts.turning_point && facts.turning_point < index[1] && index[1] + 1 < count);
    CHECK_CLOSE(p[index[0]].radius, 0.0, 0.0);
    CHECK_CLOSE(p[index[0] + 1].radius, cbrt(2 * pi * work * R * R / modulus), 1e-9);
    CHECK_CLOSE(p[index[1]].radius, cbrt(pi * work * R * R / (8 * modulus)), 1e-6);
    CHECK_CLOSE(p[index[1] + 1].radius, 0.0, 0.0);
    for (int i = index[0] + 1; i <= index[1]; i++) {
        const double a = p[i].radius;
        CHECK_CLOSE(p[i].force, 4 * modulus * pow(a, 3) / (3 * R) - sqrt(8 * pi * pow(a, 3) * work * modulus), 1e-9);
    }
    CHECK_CLOSE(facts.dissipated_energy, lost_under_depth_control(), 1e-8);
    CHECK_SUCCESS(mdr_loop_points(l, 0, NULL, &count));
    CHECK_INT(count, facts.points);
    CHECK_SUCCESS(mdr_loop_points(l, 0, NULL, NULL));
    CHECK_FREE(l);
    CHECK_SUCCESS(mdr_loop_new(c, MDR_SPRING, 0.5, 20, 1e6, &l)); /* a stiff spring is depth control */
    CHECK_CLOSE(lost_in(l), lost_under_depth_control(), 1e-3);
    CHECK_FREE(l);
}

/* The way up to `largest` and down again loses nothing, however large the load: a flat punch loses the work of its jump out,
 * 2 pi a^2 gamma, and on a spring the energy F^2/(2 k) of the spring with it; a paraboloid what it loses after a small load. */
static void loss_does_not_depend_on_the_load(const mdr_contact *paraboloid)
{
    const double radius = 0.6, stiffness = 0.7, loads[] = {0.5, 1e3, 1e8, 1e150, 1e300};
    const double pull_off = sqrt(8 * pi * work * modulus * pow(radius, 3)), out = 2 * pi * radius * radius * work;
    double energy = 0, small = 0;
    mdr_contact_options options;
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *punch = NULL;
    mdr_loop *l = NULL;

    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work;
    CHECK_SUCCESS(mdr_profile_flat_punch(radius, &p));
    CHECK_SUCCESS(mdr_medium_contact_modulus(modulus, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &punch));
    for (int i = 0; i < 5; i++) {
        CHECK_SUCCESS(mdr_loop_new(punch, MDR_DEPTH, loads[i], 3, 0.0, &l));
        energy = lost_in(l);
        CHECK_CLOSE(energy, out, 1e-12);
        CHECK_FREE(l);
        CHECK_SUCCESS(mdr_loop_new(punch, MDR_SPRING, loads[i], 3, stiffness, &l));
        energy = lost_in(l);
        CHECK_CLOSE(energy, out + pull_off * pull_off / (2 * stiffness), 1e-12);
        CHECK_FREE(l);
    }
    for (int i = 0; i < 3; i++) {
        CHECK_SUCCESS(mdr_loop_new(paraboloid, MDR_SPRING, loads[i], 3, stiffness, &l));
        energy = lost_in(l);
        if (i == 0) small = energy;
        CHECK_CLOSE(energy, small, 1e-12);
        CHECK_FREE(l);
    }
    CHECK_FREE(punch);
    CHECK_FREE(p);
    CHECK_FREE(m);
}

/* A soft spring: the area under F over the position of the machine, by the path itself. */
static void loop_on_a_spring(const mdr_contact *c)
{
    enum { CAPACITY = 20000 };
    static mdr_loop_point p[CAPACITY];
    double energy = 0, area = 0;
    int count = 0;
    mdr_loop *l = NULL;

    CHECK_SUCCESS(mdr_loop_new(c, MDR_SPRING, 1.0, 8000, 0.7, &l));
    CHECK_SUCCESS(mdr_loop_points(l, CAPACITY, p, &count));
    CHECK_TRUE(count <= CAPACITY);
    for (int i = 1; i < count; i++) area += 0.5 * (p[i].force + p[i - 1].force) * (p[i].position - p[i - 1].position);
    energy = lost_in(l);
    CHECK_CLOSE(energy, area, 1e-5);
    CHECK_FREE(l);
}

/* A loop of sixteen times as many points takes about sixteen times as long, not its square. */
static void long_loops(const mdr_contact *c, int control, double stiffness)
{
    double seconds[2];

    for (int i = 0; i < 2; i++) {
        mdr_loop *l = NULL;
        const clock_t start = clock();
        CHECK_SUCCESS(mdr_loop_new(c, control, 0.5, i ? 32000 : 2000, stiffness, &l));
        seconds[i] = (double)(clock() - start) / CLOCKS_PER_SEC;
        CHECK_FREE(l);
    }
    CHECK_TRUE(seconds[1] < 64 * seconds[0] + 0.05);
}

static void without_adhesion(void)
{
    double d = 1, a = 1, F = 1;
    mdr_loop_facts facts = MDR_SIZED(mdr_loop_facts);
    int count = 5;
    mdr_contact *c = new_contact(0.0);
    mdr_loop *l = NULL;

    CHECK_SUCCESS(pull_off_of(c, MDR_FORCE, 1, &d, &a, &F, NULL));
    CHECK_TRUE(d == 0 && a == 0 && F == 0);
    CHECK_SUCCESS(pull_off_of(c, MDR_FORCE, 1, &d, &a, &F, &count));
    CHECK_INT(count, 0);
    CHECK_SUCCESS(mdr_loop_new(c, MDR_FORCE, 2.0, 5, 0.0, &l));
    CHECK_SUCCESS(mdr_loop_about(l, &facts));
    CHECK_INT(facts.jumps, 0);
    CHECK_CLOSE(facts.dissipated_energy, 0.0, 0.0);
    CHECK_FREE(l);
    CHECK_FREE(c);
}

int main(void)
{
    mdr_contact *c = new_contact(work);
    pull_off_refuses(c);
    loop_refuses(c);
    jkr_pull_off(c);
    loop_under_depth_control(c);
    loop_on_a_spring(c);
    loss_does_not_depend_on_the_load(c);
    long_loops(c, MDR_DEPTH, 0.0);
    long_loops(c, MDR_SPRING, 0.7);
    CHECK_FREE(c);
    without_adhesion();
    return check_report("loop");
}
