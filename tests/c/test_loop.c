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
    CHECK_SUCCESS(mdr_profile_free(&p));
    CHECK_SUCCESS(mdr_medium_free(&m));
    return c;
}

static void pull_off_refuses(const mdr_contact *c)
{
    double d = untouched, a = untouched, F = untouched;
    int count = -7;

    CHECK_STATUS(mdr_contact_pull_off(NULL, MDR_CONTROL_FORCE, 1, &d, &a, &F, NULL), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_pull_off(c, MDR_CONTROL_SPRING, 1, &d, &a, &F, NULL), MDR_EINVALID, "control = 2");
    CHECK_STATUS(mdr_contact_pull_off(c, -1, 1, &d, &a, &F, NULL), MDR_EINVALID, "control = -1");
    CHECK_STATUS(mdr_contact_pull_off(c, MDR_CONTROL_FORCE, -1, &d, &a, &F, &count), MDR_EINVALID, "capacity = -1");
    CHECK_UNTOUCHED(1, &d);
    CHECK_UNTOUCHED(1, &a);
    CHECK_UNTOUCHED(1, &F);
    CHECK_INT(count, -7);
}

static void loop_refuses(const mdr_contact *c)
{
    const double bad[4] = {0.0, -1.0, NAN, INFINITY};
    double energy = untouched, d[1] = {untouched};
    int number = -7;
    mdr_loop *l = NULL;

    CHECK_STATUS(mdr_loop_new(NULL, MDR_CONTROL_DEPTH, 0.5, 10, 0.0, &l), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, 10, 0.0, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_loop_new(c, 9, 0.5, 10, 0.0, &l), MDR_EINVALID, "control = 9");
    for (int i = 0; i < 4; i++) {
        CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_DEPTH, bad[i], 10, 0.0, &l), MDR_EINVALID, "largest = ");
        CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_SPRING, 0.5, 10, bad[i], &l), MDR_EINVALID, "spring_stiffness = ");
    }
    CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, 1, 0.0, &l), MDR_EINVALID, "points = 1");
    CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, -1, 0.0, &l), MDR_EINVALID, "points = -1");
    CHECK_STATUS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, INT_MAX, 0.0, &l), MDR_EINVALID, "it must be from 2 to 1000000");
    CHECK_TRUE(l == NULL);
    CHECK_STATUS(mdr_loop_size(NULL, &number, &number, &number), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_path(NULL, 1, d, d, d, d), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_jumps(NULL, 1, &number), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_dissipated_energy(NULL, &energy), MDR_ENULL, "l is NULL");
    CHECK_STATUS(mdr_loop_size((const mdr_loop *)(const void *)c, &number, NULL, NULL), MDR_EINVALID, "not an mdr_loop");
    CHECK_SUCCESS(mdr_loop_free(NULL));
    CHECK_SUCCESS(mdr_loop_free(&l));
    CHECK_SUCCESS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, 10, 0.0, &l));
    CHECK_STATUS(mdr_loop_path(l, -1, d, d, d, d), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_loop_jumps(l, -1, &number), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_loop_jumps(l, 1, NULL), MDR_ENULL, "index is NULL");
    CHECK_STATUS(mdr_loop_dissipated_energy(l, NULL), MDR_ENULL, "energy is NULL");
    CHECK_UNTOUCHED(1, d);
    CHECK_UNTOUCHED(1, &energy);
    CHECK_INT(number, -7);
    mdr_contact *wrong = (mdr_contact *)(void *)l;
    CHECK_STATUS(mdr_contact_free(&wrong), MDR_EINVALID, "not an mdr_contact");
    CHECK_SUCCESS(mdr_loop_free(&l));
    CHECK_TRUE(l == NULL);
}

/* Force control: F = -(3/2) pi gamma R at a^3 = 9 pi gamma R^2/(8 E*); depth control: F = -(5/6) pi gamma R at a ninth of it. */
static void jkr_pull_off(const mdr_contact *c)
{
    double d, a, F, ds[3], as[3], Fs[3];
    int count = 0;

    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_FORCE, 1, &d, &a, &F, NULL));
    CHECK_CLOSE(F, -1.5 * pi * work * R, 1e-12);
    CHECK_CLOSE(a, cbrt(9 * pi * work * R * R / (8 * modulus)), 1e-6); /* at an extremum of F: half the digits */
    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_DEPTH, 1, &d, &a, &F, NULL));
    CHECK_CLOSE(F, -5.0 / 6.0 * pi * work * R, 1e-6);
    CHECK_CLOSE(a, cbrt(pi * work * R * R / (8 * modulus)), 1e-6);
    CHECK_CLOSE(d, a * a / R - sqrt(2 * pi * a * work / modulus), 1e-12);
    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_DEPTH, 1, NULL, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_DEPTH, 3, ds, as, Fs, &count));
    CHECK_INT(count, 1);
    CHECK_CLOSE(ds[0], d, 1e-12);
    CHECK_CLOSE(as[0], a, 1e-12);
    CHECK_CLOSE(Fs[0], F, 1e-12);
    count = 0;
    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_DEPTH, 0, NULL, NULL, NULL, &count));
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
    double position[CAPACITY], d[CAPACITY], a[CAPACITY], F[CAPACITY], energy = 0;
    int points = 0, turning_point = 0, jumps = 0, index[2] = {-1, -1};
    mdr_loop *l = NULL;

    CHECK_SUCCESS(mdr_loop_new(c, MDR_CONTROL_DEPTH, 0.5, 20, 0.0, &l));
    CHECK_SUCCESS(mdr_loop_size(l, &points, &turning_point, &jumps));
    CHECK_TRUE(points > 40 && points <= CAPACITY);
    CHECK_INT(jumps, 2);
    CHECK_SUCCESS(mdr_loop_path(l, CAPACITY, position, d, a, F));
    CHECK_CLOSE(position[turning_point], 0.5, 1e-15);
    CHECK_CLOSE(d[turning_point], 0.5, 1e-15);
    CHECK_SUCCESS(mdr_loop_jumps(l, 2, index));
    CHECK_TRUE(index[0] < turning_point && turning_point < index[1] && index[1] + 1 < points);
    CHECK_CLOSE(a[index[0]], 0.0, 0.0);
    CHECK_CLOSE(a[index[0] + 1], cbrt(2 * pi * work * R * R / modulus), 1e-9);
    CHECK_CLOSE(a[index[1]], cbrt(pi * work * R * R / (8 * modulus)), 1e-6);
    CHECK_CLOSE(a[index[1] + 1], 0.0, 0.0);
    for (int i = index[0] + 1; i <= index[1]; i++) {
        CHECK_CLOSE(F[i], 4 * modulus * pow(a[i], 3) / (3 * R) - sqrt(8 * pi * pow(a[i], 3) * work * modulus), 1e-9);
    }
    CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
    CHECK_CLOSE(energy, lost_under_depth_control(), 1e-8);
    CHECK_SUCCESS(mdr_loop_path(l, 0, NULL, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_loop_size(l, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_loop_free(&l));
    CHECK_SUCCESS(mdr_loop_new(c, MDR_CONTROL_SPRING, 0.5, 20, 1e6, &l)); /* a stiff spring is depth control */
    CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
    CHECK_CLOSE(energy, lost_under_depth_control(), 1e-3);
    CHECK_SUCCESS(mdr_loop_free(&l));
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
        CHECK_SUCCESS(mdr_loop_new(punch, MDR_CONTROL_DEPTH, loads[i], 3, 0.0, &l));
        CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
        CHECK_CLOSE(energy, out, 1e-12);
        CHECK_SUCCESS(mdr_loop_free(&l));
        CHECK_SUCCESS(mdr_loop_new(punch, MDR_CONTROL_SPRING, loads[i], 3, stiffness, &l));
        CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
        CHECK_CLOSE(energy, out + pull_off * pull_off / (2 * stiffness), 1e-12);
        CHECK_SUCCESS(mdr_loop_free(&l));
    }
    for (int i = 0; i < 3; i++) {
        CHECK_SUCCESS(mdr_loop_new(paraboloid, MDR_CONTROL_SPRING, loads[i], 3, stiffness, &l));
        CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
        if (i == 0) small = energy;
        CHECK_CLOSE(energy, small, 1e-12);
        CHECK_SUCCESS(mdr_loop_free(&l));
    }
    CHECK_SUCCESS(mdr_contact_free(&punch));
    CHECK_SUCCESS(mdr_profile_free(&p));
    CHECK_SUCCESS(mdr_medium_free(&m));
}

/* A soft spring: the area under F over the position of the machine, by the path itself. */
static void loop_on_a_spring(const mdr_contact *c)
{
    enum { CAPACITY = 20000 };
    static double position[CAPACITY], F[CAPACITY];
    double energy = 0, area = 0;
    int points = 0;
    mdr_loop *l = NULL;

    CHECK_SUCCESS(mdr_loop_new(c, MDR_CONTROL_SPRING, 1.0, 8000, 0.7, &l));
    CHECK_SUCCESS(mdr_loop_size(l, &points, NULL, NULL));
    CHECK_TRUE(points <= CAPACITY);
    CHECK_SUCCESS(mdr_loop_path(l, CAPACITY, position, NULL, NULL, F));
    for (int i = 1; i < points; i++) area += 0.5 * (F[i] + F[i - 1]) * (position[i] - position[i - 1]);
    CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
    CHECK_CLOSE(energy, area, 1e-5);
    CHECK_SUCCESS(mdr_loop_free(&l));
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
        CHECK_SUCCESS(mdr_loop_free(&l));
    }
    CHECK_TRUE(seconds[1] < 64 * seconds[0] + 0.05);
}

static void without_adhesion(void)
{
    double d = 1, a = 1, F = 1, energy = 1;
    int count = 5, jumps = 5;
    mdr_contact *c = new_contact(0.0);
    mdr_loop *l = NULL;

    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_FORCE, 1, &d, &a, &F, NULL));
    CHECK_TRUE(d == 0 && a == 0 && F == 0);
    CHECK_SUCCESS(mdr_contact_pull_off(c, MDR_CONTROL_FORCE, 1, &d, &a, &F, &count));
    CHECK_INT(count, 0);
    CHECK_SUCCESS(mdr_loop_new(c, MDR_CONTROL_FORCE, 2.0, 5, 0.0, &l));
    CHECK_SUCCESS(mdr_loop_size(l, NULL, NULL, &jumps));
    CHECK_INT(jumps, 0);
    CHECK_SUCCESS(mdr_loop_dissipated_energy(l, &energy));
    CHECK_CLOSE(energy, 0.0, 0.0);
    CHECK_SUCCESS(mdr_loop_free(&l));
    CHECK_SUCCESS(mdr_contact_free(&c));
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
    long_loops(c, MDR_CONTROL_DEPTH, 0.0);
    long_loops(c, MDR_CONTROL_SPRING, 0.7);
    CHECK_SUCCESS(mdr_contact_free(&c));
    without_adhesion();
    return check_report("loop");
}
