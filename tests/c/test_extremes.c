/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers far from 1: a result that is right, or a refusal in words; never NaN, never a hang. */
#include "check.h"


/* f = r^80 falls by 24 orders of magnitude in an octave */
static int steep(double r, double *f, void *context)
{
    (void)context;
    *f = pow(r, 80.0);
    return 0;
}

static int overflowing(double r, double *f, void *context)
{
    (void)context;
    *f = r * 1e308 * r;
    return isfinite(*f) ? 0 : 1;
}

static void test_profiles(void)
{
    const double r[4] = {0.0, 3477.2701614742141, 3477.2702614742143, 3477.2703614742145}, f[4] = {0.0, 1e-4, 2e-4, 3e-4};
    const double tiny[3] = {0.0, 1e-300, 2e-300}, area[3] = {1e-4, 1e-4, 1e-4};
    double middle = 3477.2702, half = 0.5, height;
    mdr_profile *p = NULL;

    /* knots closer than the rounding of g lets it follow */
    const int status = mdr_profile_table(MDR_HEIGHT, 4, r, f, &p);
    CHECK_TRUE(status == MDR_SUCCESS || status == MDR_ENOCONVERGENCE);
    if (status == MDR_SUCCESS) {
        CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 1, &middle, &height));
        CHECK_TRUE(height > 1e-4 && height < 2e-4);
    }
    CHECK_FREE(p);

    CHECK_SUCCESS(mdr_profile_function(steep, NULL, 1.0, &p));
    CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 1, &half, &height));
    CHECK_TRUE(height >= 0.0 && height < 1e-15); /* to the accuracy of the largest value between 0.5 and 1 */
    CHECK_FREE(p);

    CHECK_STATUS(mdr_profile_table(MDR_HEIGHT, 3, tiny, tiny, &p), MDR_EINVALID, "must lie between");
    CHECK_STATUS(mdr_profile_table(MDR_G, 3, tiny, tiny, &p), MDR_EINVALID, "must lie between");
    CHECK_STATUS(mdr_profile_function(overflowing, NULL, 1.0, &p), MDR_EINVALID, "must lie between");
    CHECK_STATUS(mdr_profile_area_function(3, area, 0.0, 1e-304, &p), MDR_EINVALID, "must lie between");
    /* small, but far from the end of the number range: relative accuracy does not depend on the unit of length */
    CHECK_SUCCESS(mdr_profile_area_function(3, area, 0.0, 1e-120, &p));
    CHECK_FREE(p);
}

static void test_media(void)
{
    double large = 1e300, small = 1e-300, out = untouched;
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_homogeneous(1e200, 0.3, &m));
    CHECK_STATUS(mdr_medium_values(m, MDR_STIFFNESS, 1, &large, &out), MDR_ENOCONVERGENCE, "exceeds the range of double precision");
    CHECK_FREE(m);
    CHECK_SUCCESS(new_homogeneous(1e-200, 0.3, &m));
    CHECK_STATUS(mdr_medium_values(m, MDR_STIFFNESS, 1, &small, &out), MDR_ENOCONVERGENCE, "exceeds the range of double precision");
    CHECK_FREE(m);
    CHECK_UNTOUCHED(1, &out);
}

static void test_closed_forms(void)
{
    double a = 1.0, large = 1e200, out = untouched;

    /* a coating so thin that (a/h)^2 overflows is none */
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 1, &a, (const double[]){1.0, 3.0, 2.0, 1e-200}, &out));
    CHECK_CLOSE(out, 32.0 / 3.0, 1e-14);
    out = untouched;
    CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 1, &large, (const double[]){1.0, 3.0, 2.0, 1.0}, &out),
                 MDR_ENOCONVERGENCE, "double precision");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_CONE_FORCE, 1, &large, (const double[]){0.2, 3.0, 2.0, 1.0}, &out), MDR_ENOCONVERGENCE,
                 "double precision");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){1e200}, (const double[]){1.0, 1.0}, &out),
                 MDR_ENOCONVERGENCE, "double precision");
    CHECK_UNTOUCHED(1, &out);
}

/* p at radii whose squares are no numbers, against p(0), against a cone's logarithm, and against its power of r. */
static void test_pressures_at_the_axis(void)
{
    const double r[4] = {0.0, 1e-300, 1e-200, 1e-198}, pi = 3.14159265358979323846;
    const double exponents[2] = {-0.3, 0.3};
    double p[4];
    mdr_profile *ball = NULL, *cone = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_profile_cone(0.3, &cone));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &m));
    CHECK_SUCCESS(mdr_contact_new(ball, m, NULL, &c));
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 0.5, 4, r, p));
    for (int i = 0; i < 4; i++) CHECK_CLOSE(p[i], 2.0 * 0.5 / pi, 1e-12);
    CHECK_FREE(c);
    CHECK_SUCCESS(mdr_contact_new(cone, m, NULL, &c));
    CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 0.5, 4, r, p));
    CHECK_CLOSE(p[0], INFINITY, 0.0);
    for (int i = 1; i < 4; i++) CHECK_CLOSE(p[i], 0.5 * tan(0.3) * (log(1.0 / r[i])), 1e-12);
    CHECK_FREE(c);
    CHECK_FREE(m);
    for (int k = 0; k < 2; k++) {
        CHECK_SUCCESS(medium_of_power(1.0, 1.0, exponents[k], 0.3, &m));
        CHECK_SUCCESS(mdr_contact_new(ball, m, NULL, &c));
        CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 0.5, 4, r, p));
        for (int i = 1; i < 4; i++) CHECK_CLOSE(p[i], p[0], 1e-8);
        CHECK_FREE(c);
        CHECK_SUCCESS(mdr_contact_new(cone, m, NULL, &c));
        CHECK_SUCCESS(field_at(c, MDR_PRESSURE, MDR_RADIUS, 0.5, 4, r, p));
        if (exponents[k] > 0.0) CHECK_CLOSE(p[2], p[0], 1e-8);
        else CHECK_CLOSE(p[2] / p[3], pow(100.0, 0.3), 1e-6);
        CHECK_FREE(c);
        CHECK_FREE(m);
    }
    CHECK_FREE(cone);
    CHECK_FREE(ball);
}

int main(void)
{
    test_pressures_at_the_axis();
    test_profiles();
    test_media();
    test_closed_forms();
    return check_report("extremes");
}
