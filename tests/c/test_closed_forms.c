/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Closed forms for an incompressible coating: refusals, then values against the contact itself. */
#include "check.h"

static const double pi = 3.14159265358979323846;
static const double R = 2.0, phi = 0.3, G0 = 3.0, G1 = 0.5, h = 0.4, work = 0.05;
static const double a[3] = {0.01, 0.3, 5.0};

static void refusals(void)
{
    const double bad[4] = {0.0, -1.0, NAN, INFINITY};
    double out[3];

    fill_untouched(3, out);
    for (int i = 0; i < 4; i++) {
        CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){bad[i], G0, G1, h}, out), MDR_EINVALID,
                     "radius = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){R, bad[i], G1, h}, out), MDR_EINVALID,
                     "coating_shear = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){R, G0, bad[i], h}, out), MDR_EINVALID,
                     "substrate_shear = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){R, G0, G1, bad[i]}, out), MDR_EINVALID,
                     "thickness = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 1, &bad[i], (const double[]){R, G0, G1, h}, out), MDR_EINVALID,
                     "entry 1 of a = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_CONE_FORCE, 3, a, (const double[]){bad[i], G0, G1, h}, out), MDR_EINVALID,
                     "inclination = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){bad[i]}, (const double[]){G1, work}, out),
                     MDR_EINVALID, "radius = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){R}, (const double[]){bad[i], work}, out),
                     MDR_EINVALID, "substrate_shear = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_DEPTH_SCALE, 1, (const double[]){R}, (const double[]){G1, bad[i]}, out), MDR_EINVALID,
                     "work_of_adhesion = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, 3, a, (const double[]){bad[i], 1.0}, out), MDR_EINVALID,
                     "shear_ratio = ");
        CHECK_STATUS(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, 3, a, (const double[]){2.0, bad[i]}, out), MDR_EINVALID,
                     "reduced_thickness = ");
    }
    CHECK_STATUS(mdr_closed_form(MDR_FORM_CONE_FORCE, 3, a, (const double[]){0.5 * pi, G0, G1, h}, out), MDR_EINVALID,
                 "inclination = ");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, 3, a, (const double[]){R, G0, G1, h, -1.0}, out), MDR_EINVALID,
                 "work_of_adhesion = ");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, -1, a, (const double[]){R, G0, G1, h}, out), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, NULL, (const double[]){R, G0, G1, h}, out), MDR_ENULL, "x is NULL");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_CONE_FORCE, 3, a, (const double[]){phi, G0, G1, h}, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, 3, NULL, (const double[]){2.0, 1.0}, out), MDR_ENULL, "x is NULL");
    CHECK_STATUS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){R}, (const double[]){G1, work}, NULL), MDR_ENULL,
                 "out is NULL");
    CHECK_UNTOUCHED(3, out);
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 0, NULL, (const double[]){R, G0, G1, h}, NULL));
}

/* What the contact computes by quadrature. */
static void against_the_contact(void)
{
    mdr_profile *paraboloid = NULL, *cone = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;
    double found[3], expected[3];

    CHECK_SUCCESS(mdr_profile_paraboloid(R, &paraboloid));
    CHECK_SUCCESS(mdr_profile_cone(phi, &cone));
    CHECK_SUCCESS(new_coated(3 * G0, 0.5, h, 3 * G1, 0.5, MDR_MODEL_GAO, NULL, &m));
    CHECK_SUCCESS(mdr_contact_new(paraboloid, m, NULL, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 3, a, NULL, NULL, expected, NULL));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_PARABOLOID_FORCE, 3, a, (const double[]){R, G0, G1, h}, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-12);
    CHECK_FREE(c);
    CHECK_SUCCESS(mdr_contact_new(cone, m, NULL, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 3, a, NULL, NULL, expected, NULL));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_CONE_FORCE, 3, a, (const double[]){phi, G0, G1, h}, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-12);
    CHECK_FREE(c);
    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work;
    options.adhesion_rule = MDR_ADHESION_PAPER;
    CHECK_SUCCESS(mdr_contact_new(paraboloid, m, &options, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 3, a, expected, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, 3, a, (const double[]){R, G0, G1, h, work}, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-12);
    CHECK_FREE(c);
    CHECK_FREE(paraboloid);
    CHECK_FREE(cone);
    CHECK_FREE(m);
}

/* (29) in the units (31) is (32). */
static void scales(void)
{
    double radius_scale, depth_scale, at[3], reduced[3], depth[3];

    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_RADIUS_SCALE, 1, (const double[]){R}, (const double[]){G1, work}, &radius_scale));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_DEPTH_SCALE, 1, (const double[]){R}, (const double[]){G1, work}, &depth_scale));
    CHECK_CLOSE(radius_scale, cbrt(pi * work * R * R / (32 * G1)), 1e-15);
    CHECK_CLOSE(depth_scale, 3 * radius_scale * radius_scale / R, 1e-15);
    for (int i = 0; i < 3; i++) at[i] = a[i] / radius_scale;
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_REDUCED_DEPTH, 3, at, (const double[]){G0 / G1, h / radius_scale}, reduced));
    CHECK_SUCCESS(mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, 3, a, (const double[]){R, G0, G1, h, work}, depth));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(reduced[i], depth[i] / depth_scale, 1e-13);
}

int main(void)
{
    refusals();
    against_the_contact();
    scales();
    return check_report("closed_forms");
}
