/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A work of adhesion that depends on speed: a row of tests/data/adhesion_time.csv, a history in pieces, refusals. */
#include "check.h"
#include "mdrcontact/adhesion.h"

enum { N = 2 };

static mdr_contact *elastic_contact(const mdr_contact_options *options)
{
    mdr_profile *ball = NULL;
    mdr_medium *body = NULL;
    mdr_contact *contact = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.0, &body));
    CHECK_SUCCESS(mdr_contact_new(ball, body, options, &contact));
    CHECK_FREE(ball);
    CHECK_FREE(body);
    return contact;
}

static void test_pull_off(const mdr_rate *rate)
{
    const double time[3] = {0.0, 10.0, 300.0}, depth[3] = {0.1939501, 0.0939501, -2.8060499};
    const mdr_rate_state rest = {.radius = -1.0};
    mdr_rate_state end = {0}, middle = {0};
    double d[3], a[3], F[3], v[3], lost[3], work[3];

    CHECK_SUCCESS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 1e-10, &rest, 3, time, depth, d, a, F, v, lost, work, &end));
    CHECK_CLOSE(end.lowest_force, -0.018852959529303603, 1e-10);
    CHECK_TRUE(a[0] > 0.49 && a[2] == 0.0 && F[2] == 0.0 && end.ruptures == 1.0 && v[1] > 0.0 && lost[1] > 0.0 && work[2] < 0.0);
    CHECK_SUCCESS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 1e-10, &rest, 2, time, depth, d, a, F, v, lost, NULL, &middle));
    CHECK_SUCCESS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 1e-10, &middle, 2, time + 1, depth + 1, NULL, NULL, NULL, NULL,
                                   NULL,
                                   NULL, &middle));
    CHECK_CLOSE(middle.lowest_force, end.lowest_force, 1e-11);
    CHECK_CLOSE(middle.dissipated, end.dissipated, 1e-9);
}

/* The end of a history that was changed, and a start with more than a radius. */
static void test_altered_states(const mdr_rate *rate)
{
    const double time[2] = {0.0, 1.0}, depth[2] = {0.1, 0.05};
    const mdr_rate_state rest = {.radius = -1.0};
    mdr_rate_state end = {0}, altered, after = {.radius = 7.0};
    double *members[] = {&altered.radius, &altered.depth, &altered.dissipated, &altered.work, &altered.lowest_force,
                         &altered.lowest_time, &altered.lowest_depth, &altered.lowest_radius, &altered.lowest_speed,
                         &altered.rupture_time, &altered.rupture_depth, &altered.ruptures, &altered.force, &altered.mark};

    CHECK_SUCCESS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &rest, 2, time, depth, NULL, NULL, NULL, NULL, NULL, NULL, &end));
    CHECK_TRUE(end.force != 0.0 && end.mark != 0.0);
    for (int i = 0; i < 14; i++) {
        altered = end;
        *members[i] = i == 12 ? 0.5 * end.force : 1e300;
        CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &altered, 2, time, depth, NULL, NULL, NULL, NULL, NULL, NULL, &after),
                     MDR_EINVALID, "mark");
        altered = rest;
        *members[i] = NAN;
        CHECK_INT(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &altered, 2, time, depth, NULL, NULL, NULL, NULL, NULL, NULL, &after),
                  MDR_EINVALID);
    }
    CHECK_TRUE(after.radius == 7.0);
    CHECK_SUCCESS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &end, 1, time, depth + 1, NULL, NULL, NULL, NULL, NULL, NULL, &after));
}

static void test_refusals(const mdr_contact *contact, const mdr_rate *rate, mdr_rate_options options)
{
    const double time[N] = {0.0, 1.0}, still[N] = {1.0, 1.0}, deep[N] = {0.0, 9.0};
    const mdr_rate_state apart = {0};
    mdr_rate_state end = {.radius = 7.0};
    mdr_rate *none = NULL;
    double out[N] = {7.0, 7.0};

    CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &apart, N, still, still, out, out, out, out, out, out, &end),
                 MDR_EINVALID,
                 "time");
    CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &apart, N, time, deep, out, NULL, NULL, NULL, NULL, NULL, &end),
                 MDR_EDOMAIN,
                 "largest_radius");
    CHECK_STATUS(mdr_rate_history(rate, MDR_SPRING, 0.0, 0.0, &apart, N, time, still, out, NULL, NULL, NULL, NULL, NULL, &end),
                 MDR_EINVALID,
                 "stiffness");
    CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 1.0, &apart, N, time, still, out, NULL, NULL, NULL, NULL, NULL, &end),
                 MDR_EINVALID,
                 "tolerance");
    CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, NULL, N, time, still, out, NULL, NULL, NULL, NULL, NULL, &end),
                 MDR_ENULL,
                 "start");
    CHECK_STATUS(mdr_rate_history(rate, MDR_DEPTH, 0.0, 0.0, &apart, -1, time, still, out, NULL, NULL, NULL, NULL, NULL, &end),
                 MDR_EINVALID, "n");
    CHECK_STATUS(mdr_rate_work(NULL, N, time, out, NULL, NULL), MDR_ENULL, "options");
    options.exponent = 2.5;
    CHECK_STATUS(mdr_rate_work(&options, N, time, out, NULL, NULL), MDR_EINVALID, "exponent = 2.5");
    options.exponent = 0.5;
    options.speed = -1.0;
    CHECK_STATUS(mdr_rate_new(contact, &options, &none), MDR_EINVALID, "speed = -1");
    options.speed = 1.0;
    options.closing_work = 2.0 * options.work;
    CHECK_STATUS(mdr_rate_new(contact, &options, &none), MDR_EINVALID, "closing_work");
    options.closing_work = 0.0;
    options.largest_radius = NAN;
    CHECK_STATUS(mdr_rate_new(contact, &options, &none), MDR_EINVALID, "largest_radius");
    CHECK_TRUE(none == NULL && end.radius == 7.0 && out[0] == 7.0 && out[1] == 7.0);
}

static void test_no_zone(mdr_rate_options options)
{
    mdr_contact_options zone = MDR_SIZED(mdr_contact_options);
    mdr_contact *contact = NULL;
    mdr_rate *none = NULL;

    zone.work_of_adhesion = 0.01;
    zone.cohesive_stress = 0.2;
    contact = elastic_contact(&zone);
    CHECK_STATUS(mdr_rate_new(contact, &options, &none), MDR_EINVALID, "cohesive_stress");
    CHECK_FREE(contact);
}

/* Of E_glassy = 10 E_relaxed: between 1 and 10 times the work, and 1/10. */
static void test_surface(const mdr_contact *contact)
{
    const double moduli[1] = {4.5}, times[1] = {0.1}, v[3] = {0.0, 1e9, -1e9};
    mdr_rate_options options = MDR_SIZED(mdr_rate_options);
    mdr_material *rubber = NULL;
    mdr_rate *rate = NULL;
    double out[3], time, zone;

    CHECK_SUCCESS(mdr_material_viscoelastic(0.5, 1, moduli, times, 0.0, 0.0, 0.0, &rubber));
    options.work = 0.01;
    options.material = rubber;
    options.cohesive_stress = 1.0;
    options.largest_radius = 1.0;
    CHECK_SUCCESS(mdr_rate_work(&options, 3, v, out, NULL, NULL));
    CHECK_CLOSE(out[0], 0.01, 1e-15);
    CHECK_CLOSE(out[1], 0.1, 1e-6);
    CHECK_CLOSE(out[2], 0.001, 1e-6);
    CHECK_SUCCESS(mdr_rate_work(&options, 0, NULL, NULL, &time, &zone));
    CHECK_CLOSE(time, 1.0, 1e-12);
    CHECK_CLOSE(zone, 0.01 * acos(-1.0) / 4.0, 1e-12);
    CHECK_SUCCESS(mdr_rate_new(contact, &options, &rate));
    options.speed = 1.0;
    CHECK_STATUS(mdr_rate_work(&options, 3, v, out, NULL, NULL), MDR_EINVALID, "material");
    CHECK_FREE(rate);
    CHECK_FREE(rubber);
}

/* A row of the table: 1/E* = 0.1 + 0.9 (1 - exp(-t)), gamma = 0.01, sigma = 0.25, from rest at a = 0.6. */
static void test_viscoelastic_zone(void)
{
    const double modulus = 4.5, relaxation = 0.1, time[N] = {0.0, 10.0}, depth[N] = {0.20863054002498174, -0.79136945997501826};
    const mdr_rate_state rest = {.radius = -1.0}, wrong = {.radius = 1.0};
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    mdr_rate_state end = {.radius = 7.0};
    mdr_material *rubber = NULL;
    mdr_medium *body = NULL;
    mdr_profile *ball = NULL;
    mdr_contact *contact = NULL, *plain = NULL;
    double d[N], a[N], c[N] = {7.0, 7.0}, F[N];

    options.work_of_adhesion = 0.01;
    options.cohesive_stress = 0.25;
    CHECK_SUCCESS(mdr_material_viscoelastic(0.5, 1, &modulus, &relaxation, 0.0, 0.0, 0.0, &rubber));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, rubber, MDR_MODEL_EXACT, NULL, &body));
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_contact_new(ball, body, &options, &contact));
    CHECK_SUCCESS(mdr_contact_new(ball, body, NULL, &plain));
    CHECK_STATUS(mdr_contact_adhesive_history(plain, MDR_DEPTH, 0.0, 0.0, &rest, N, time, depth, d, a, c, F, &end), MDR_EINVALID,
                 "cohesive_stress");
    CHECK_STATUS(mdr_contact_adhesive_history(contact, MDR_DEPTH, 0.0, 0.0, &wrong, N, time, depth, d, a, c, F, &end), MDR_EINVALID,
                 "start");
    CHECK_STATUS(mdr_contact_adhesive_history(contact, MDR_DEPTH, 0.0, 0.0, NULL, N, time, depth, d, a, c, F, &end), MDR_ENULL,
                 "start");
    CHECK_STATUS(mdr_contact_adhesive_history(NULL, MDR_DEPTH, 0.0, 0.0, &rest, N, time, depth, d, a, c, F, &end), MDR_ENULL, "c");
    CHECK_TRUE(c[0] == 7.0 && end.radius == 7.0);
    CHECK_SUCCESS(mdr_contact_adhesive_history(contact, MDR_DEPTH, 0.0, 0.0, &rest, N, time, depth, d, a, c, F, &end));
    CHECK_CLOSE(end.lowest_force, -2.645998 * 0.047123889803846899, 1e-4);
    CHECK_TRUE(a[0] > 0.5999 && c[0] > a[0] && F[0] > 0.0 && a[1] == 0.0 && c[1] == 0.0 && d[1] == depth[1] && end.ruptures == 1.0);
    CHECK_SUCCESS(mdr_contact_adhesive_history(contact, MDR_DEPTH, 0.0, 0.0, &rest, N, time, depth, NULL, NULL, NULL, NULL, &end));
    CHECK_FREE(contact);
    CHECK_FREE(plain);
    CHECK_FREE(ball);
    CHECK_FREE(body);
    CHECK_FREE(rubber);
}

int main(void)
{
    mdr_rate_options options = MDR_SIZED(mdr_rate_options);
    mdr_contact *contact = elastic_contact(NULL);
    mdr_rate *rate = NULL;

    options.work = 1e-3;
    options.speed = 1e-3;
    options.exponent = 0.33;
    options.largest_radius = 0.51;
    CHECK_SUCCESS(mdr_rate_new(contact, &options, &rate));
    test_pull_off(rate);
    test_altered_states(rate);
    test_viscoelastic_zone();
    test_refusals(contact, rate, options);
    test_surface(contact);
    test_no_zone(options);
    CHECK_FREE(rate);
    CHECK_TRUE(rate == NULL);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(contact);
    return check_report("rate");
}
