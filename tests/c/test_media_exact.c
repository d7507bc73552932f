/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact layered medium: refusals, published and independent numbers, degenerate stacks. */
#include "check.h"

static void refusals(void)
{
    const double E[2] = {2.0, 3.0}, nu[2] = {0.3, 0.2}, h[2] = {0.1, 0.2}, bad_E[2] = {2.0, NAN}, bad_h[2] = {0.1, -0.2};
    const double bad_tolerance[4] = {-1e-5, -1.0, NAN, INFINITY};
    mdr_medium *m = NULL;
    mdr_medium_options options;

    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_EXACT, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(new_coated(-2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "layer 1 E = -2");
    CHECK_STATUS(new_coated(2.0, 0.3, 0.0, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "thickness = 0");
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, -INFINITY, 0.3, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "substrate E = ");
    CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.7, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "substrate nu = 0.7");
    CHECK_STATUS(new_layered(2, E, nu, h, 1.0, 0.3, MDR_MODEL_EXACT, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(new_layered(2, bad_E, nu, h, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "layer 2 E = NaN");
    CHECK_STATUS(new_layered(2, E, nu, bad_h, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "entry 2 of thickness");
    CHECK_STATUS(medium_of_layers(0, NULL, NULL, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "a rigid base needs at least one layer");
    options = MDR_SIZED(mdr_medium_options);
    for (int i = 0; i < 4; i++) {
        options.tolerance = bad_tolerance[i];
        CHECK_STATUS(new_coated(2.0, 0.3, 0.1, 1.0, 0.3, MDR_MODEL_EXACT, &options, &m), MDR_EINVALID, "tolerance = ");
    }
    CHECK_TRUE(m == NULL);
}

/* Flat punch on an incompressible layer bonded to a rigid base: k (1 - nu)/(4 G a) at a/h = 1 and 2, to nine digits. */
static void rigid_base(void)
{
    const double E = 3.0, h = 0.7, a[2] = {0.7, 1.4};
    double found[2];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_coated(E, 0.5, h, INFINITY, NAN, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 2, a, found));
    CHECK_CLOSE(found[0] * 0.75 / E, 3.61873585, 2e-9);
    CHECK_CLOSE(found[1] * 0.75 / E, 9.14945045, 2e-9);
    CHECK_FREE(m);
}

/* Two equal materials, one a layer, under a surface that is not bare. */
static int new_half_space_under(const mdr_surface *surface, double E, double nu, int model, mdr_medium **out)
{
    const mdr_layer layer = mdr_isotropic(E, nu, 1.0);
    mdr_body *body = NULL;
    const int status = mdr_body_layered(1, &layer, &layer, surface, &body);
    return medium_of(status, body, model, NULL, out);
}

/* A flat punch on a surface with tension, l = 2 tau/E* = 10 a (theory/surfaces.md (6.2)); what such a surface does not
 * take. */
static void surface_with_tension(void)
{
    const double a = 1.0, bad[4] = {-1.0, NAN, INFINITY, -INFINITY};
    double found;
    mdr_medium *m = NULL;
    mdr_surface surface = MDR_SIZED(mdr_surface);
    mdr_material *gel = NULL;
    mdr_body *body = NULL;

    surface.tension = 5.0;
    CHECK_SUCCESS(new_half_space_under(&surface, 0.75, 0.5, MDR_MODEL_EXACT, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_STIFFNESS, 1, &a, &found));
    CHECK_CLOSE(found, 12.4154001386, 1e-10);
    CHECK_STATUS(mdr_medium_values(m, MDR_TANGENTIAL_MODULUS, 1, &a, &found), MDR_EINVALID, "surface with tension");
    CHECK_FREE(m);
    CHECK_STATUS(new_half_space_under(&surface, 0.75, 0.5, MDR_MODEL_GAO, &m), MDR_EINVALID, "exact");
    CHECK_SUCCESS(mdr_material_viscoelastic(0.75 / 3, 0, NULL, NULL, 0.0, 0.5, 0.0, &gel));
    mdr_layer of_gel = MDR_SIZED(mdr_layer);
    const mdr_layer plain = mdr_isotropic(0.75, 0.5, 0.0);
    of_gel.material = gel;
    CHECK_STATUS(mdr_body_layered(0, NULL, &of_gel, &surface, &body), MDR_EINVALID, "must be elastic");
    CHECK_FREE(gel);
    for (int i = 0; i < 4; i++) {
        surface.tension = bad[i];
        CHECK_STATUS(mdr_body_layered(0, NULL, &plain, &surface, &body), MDR_EINVALID, "tension");
        surface.tension = 0.5;
        surface.bending = bad[i];
        CHECK_STATUS(mdr_body_layered(0, NULL, &plain, &surface, &body), MDR_EINVALID, "bending");
        surface.bending = 0.0;
        surface.stretching = bad[i];
        CHECK_STATUS(mdr_body_layered(0, NULL, &plain, &surface, &body), MDR_EINVALID, "stretching");
        surface.stretching = 0.0;
    }
    /* under a plate, E* = B = 1: tau_c = -3 (1/4)^(2/3) = -1.19, with a sheet in its plane likewise */
    surface.bending = 1.0;
    for (int i = 0; i < 2; i++) {
        surface.stretching = i;
        surface.tension = -1.15;
        CHECK_STATUS(mdr_body_layered(0, NULL, &plain, &surface, &body), MDR_EINVALID, "wrinkles at tau_c = ");
        surface.tension = -1.1;
        CHECK_SUCCESS(mdr_body_layered(0, NULL, &plain, &surface, &body));
        MDR_FREE(body);
    }
    CHECK_TRUE(m == NULL && body == NULL);
}

/* A surface that is stiff in its plane: small contacts do not move it sideways, E* 4 (1 - nu)^2/(3 - 4 nu); nu = 1/2 does not mind. */
static void surface_with_stiff_sheet(void)
{
    const double a = 1e-6, E = 0.91, nu = 0.3;
    double found;
    mdr_medium *m = NULL;
    mdr_surface surface = MDR_SIZED(mdr_surface);

    surface.stretching = 5.0;
    CHECK_SUCCESS(new_half_space_under(&surface, E, nu, MDR_MODEL_EXACT, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_STIFFNESS, 1, &a, &found));
    CHECK_CLOSE(found / (2.0 * a), 4.0 * (1.0 - nu) * (1.0 - nu) / (3.0 - 4.0 * nu), 1e-6);
    CHECK_STATUS(mdr_medium_values(m, MDR_TANGENTIAL_MODULUS, 1, &a, &found), MDR_EINVALID, "sheet");
    CHECK_FREE(m);
    CHECK_SUCCESS(new_half_space_under(&surface, 0.75, 0.5, MDR_MODEL_EXACT, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_STIFFNESS, 1, &a, &found));
    CHECK_CLOSE(found / (2.0 * a), 1.0, 1e-14);
    CHECK_FREE(m);
}

static void degenerate_stacks(void)
{
    const double E[2] = {2.0, 2.0}, nu[2] = {0.3, 0.3}, h[2] = {0.1, 0.2}, a[3] = {0.01, 0.3, 2.0};
    double found[3], expected[3];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_layered(2, E, nu, h, 2.0, 0.3, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, found));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], 2.0 / 0.91, 1e-10);
    CHECK_FREE(m);
    CHECK_SUCCESS(new_layered(2, E, nu, h, 5.0, 0.2, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, found));
    CHECK_FREE(m);
    CHECK_SUCCESS(new_coated(2.0, 0.3, 0.1 + 0.2, 5.0, 0.2, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 3, a, expected));
    CHECK_FREE(m);
    for (int i = 0; i < 3; i++) CHECK_CLOSE(found[i], expected[i], 1e-9);
}

/* zeta = d/g(a) of the exact solution at a/h = 1, nu = 1/2, G0/G1 = 2: paraboloid 1.2676, cone 1.1976 (five digits). */
static void depth_of_first_touch(void)
{
    const double a[1] = {1.0}, pi = 3.14159265358979323846;
    double d[1];
    mdr_medium *m = NULL;
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(new_coated(6.0, 0.5, 1.0, 3.0, 0.5, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_profile_paraboloid(4.0, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 1, a, d, NULL, NULL, NULL));
    CHECK_CLOSE(d[0] * 4.0, 1.2676, 5e-5);
    CHECK_FREE(c);
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 1, a, d, NULL, NULL, NULL));
    CHECK_CLOSE(d[0] / (0.5 * pi * tan(0.3)), 1.1976, 5e-5);
    CHECK_FREE(c);
    CHECK_FREE(p);
    CHECK_FREE(m);
}

/* With zeta_is_exact an approximate model has the depths of the exact one, up to where the tip ends. */
static void exact_zeta_of_a_model(void)
{
    const double a[3] = {0.3, 1.0, 3.0};
    double d[3], expected[3];
    mdr_medium *exact = NULL, *model = NULL;
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;
    mdr_contact_options options;

    CHECK_SUCCESS(new_coated(6.0, 0.5, 1.0, 3.0, 0.5, MDR_MODEL_EXACT, NULL, &exact));
    CHECK_SUCCESS(new_coated(6.0, 0.5, 1.0, 3.0, 0.5, MDR_MODEL_GAO, NULL, &model));
    options = MDR_SIZED(mdr_contact_options);
    options.zeta_is_exact = 1;
    CHECK_SUCCESS(mdr_profile_sphere(5.5, &p));
    CHECK_SUCCESS(mdr_contact_new(p, exact, NULL, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 3, a, expected, NULL, NULL, NULL));
    CHECK_FREE(c);
    CHECK_SUCCESS(mdr_contact_new(p, model, &options, &c));
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 3, a, d, NULL, NULL, NULL));
    for (int i = 0; i < 3; i++) CHECK_CLOSE(d[i], expected[i], 1e-6);
    CHECK_STATUS(columns_of(c, MDR_RADIUS, 1, (const double[]){5.6}, d, NULL, NULL, NULL), MDR_EDOMAIN, "5.5");
    CHECK_FREE(c);
    CHECK_STATUS(mdr_contact_new(p, exact, &options, &c), MDR_EINVALID, "with an approximate model");
    options.zeta_count = 3;
    CHECK_STATUS(mdr_contact_new(p, model, &options, &c), MDR_EINVALID, "zeta_is_exact = 1: it excludes a table");
    CHECK_FREE(p);
    CHECK_FREE(exact);
    CHECK_FREE(model);
}

/* A table with a step is a coating, at every radius from the surface's to many times the film's thickness. */
static void graded_bodies(void)
{
    const double z[4] = {0.0, 0.3, 0.3 + 1e-10, 2.0}, E[4] = {5.0, 5.0, 1.0, 1.0}, nu[4] = {0.2, 0.2, 0.4, 0.4};
    const double a[6] = {1e-4, 0.03, 0.3, 3.0, 100.0, 2e3};
    double found[6], expected[6], d[2], F[2];
    mdr_medium *graded = NULL, *coated = NULL;
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(medium_of_grades(4, z, E, nu, MDR_MODEL_EXACT, NULL, &graded));
    CHECK_SUCCESS(new_coated(5.0, 0.2, 0.3, 1.0, 0.4, MDR_MODEL_EXACT, NULL, &coated));
    CHECK_SUCCESS(mdr_medium_values(graded, MDR_MODULUS, 6, a, found));
    CHECK_SUCCESS(mdr_medium_values(coated, MDR_MODULUS, 6, a, expected));
    for (int i = 0; i < 6; i++) CHECK_CLOSE(found[i], expected[i], 1e-8);
    CHECK_SUCCESS(mdr_profile_sphere(10.0, &p));
    for (int i = 0; i < 2; i++) {
        CHECK_SUCCESS(mdr_contact_new(p, i == 0 ? graded : coated, NULL, &c));
        CHECK_SUCCESS(columns_of(c, MDR_RADIUS, 1, a + 3, d + i, NULL, F + i, NULL));
        CHECK_FREE(c);
    }
    CHECK_CLOSE(d[0], d[1], 1e-8);
    CHECK_CLOSE(F[0], F[1], 1e-8);
    CHECK_FREE(p);
    CHECK_FREE(graded);
    CHECK_FREE(coated);
}

/* Layers of one material are a half-space, whatever the unit of length. */
static void one_material(void)
{
    const double a[5] = {1e-50, 1e-9, 1.0, 1e7, 1e99};
    double found[5];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(new_coated(2.0, 0.3, 1e-3, 2.0, 0.3, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 5, a, found));
    for (int i = 0; i < 5; i++) CHECK_CLOSE(found[i], 2.0 / 0.91, 1e-14);
    CHECK_FREE(m);
}

/* Up to the last radius that is offered under a hemisphere, whose flank is vertical at its rim, there is an answer. */
static void rim_of_a_sphere(void)
{
    const double R = 0.3696276369761353;
    double last, d, a, F, k;
    mdr_medium *m = NULL;
    mdr_profile *p = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(new_coated(1.0, 0.0, 10.990568195442522, 1.0, 0.5, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_profile_sphere(R, &p));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    for (last = nextafter(R, 0.0); last > R * (1.0 - 1e-14); last = nextafter(last, 0.0)) {
        int status = columns_of(c, MDR_RADIUS, 1, &last, &d, &a, &F, &k);
        CHECK_TRUE(status == MDR_EDOMAIN || (status == MDR_SUCCESS && last < R && d > 0.0 && F > 0.0));
    }
    CHECK_FREE(c);
    CHECK_FREE(p);
    CHECK_FREE(m);
}

/* What a surface answers to waves: short ones see the film, long ones the substrate; refusals write nothing. */
static void compliances(void)
{
    const double k[2] = {1e-9, 1e9}, bad[2] = {1.0, 0.0}, infinite[2] = {0.0, INFINITY};
    double C[2], imaginary[2], limits[3];
    const mdr_layer film = mdr_isotropic(2.6, 0.3, 0.1), base = mdr_isotropic(26.0, 0.3, 0.0);
    mdr_surface tension = MDR_SIZED(mdr_surface);
    mdr_body *body = NULL, *rigid = NULL, *power = NULL, *tense = NULL;
    mdr_medium *medium = NULL;

    tension.tension = 3.0;
    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, &tension, &tense));
    CHECK_SUCCESS(mdr_body_rigid(&rigid));
    CHECK_SUCCESS(mdr_body_power_graded(1.0, 1.0, 0.2, 0.3, &power));
    CHECK_SUCCESS(mdr_medium_contact_modulus(1.0, &medium));
    for (int load = MDR_LOAD_NORMAL; load <= MDR_LOAD_TWIST; load++) {
        const double factor = load == MDR_LOAD_NORMAL ? 0.7 : load == MDR_LOAD_SHEAR ? 0.85 : 1.0;

        CHECK_SUCCESS(mdr_body_compliance(body, load, 2, k, NULL, C, imaginary));
        CHECK_CLOSE(C[0], 0.1 * factor / k[0], 1e-6);
        CHECK_CLOSE(C[1], factor / k[1], 1e-15);
        CHECK_TRUE(imaginary[0] == 0.0 && imaginary[1] == 0.0);
    }
    CHECK_SUCCESS(mdr_body_compliance(body, MDR_LOAD_COUPLING, 2, k, NULL, C, imaginary));
    CHECK_CLOSE(C[0], 0.1 * 0.2 / k[0], 1e-6);
    CHECK_CLOSE(C[1], 0.2 / k[1], 1e-14);
    CHECK_SUCCESS(mdr_body_compliance_limits(body, 0.0, limits, NULL));
    CHECK_CLOSE(limits[0], 0.35, 1e-14);
    CHECK_CLOSE(limits[1], 0.035, 1e-14);
    CHECK_SUCCESS(mdr_body_compliance(power, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL));
    CHECK_CLOSE(C[0] / C[1], pow(k[0] / k[1], -0.8), 1e-12);
    CHECK_STATUS(mdr_body_compliance_limits(power, 0.0, limits, NULL), MDR_EINVALID, "power-law graded");
    CHECK_STATUS(mdr_body_compliance_limits(body, INFINITY, limits, NULL), MDR_EINVALID, "omega");
    CHECK_STATUS(mdr_body_compliance_limits(NULL, 0.0, limits, NULL), MDR_ENULL, "body is NULL");
    CHECK_STATUS(mdr_body_compliance_limits(body, 0.0, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_CLOSE(limits[0], 0.35, 1e-14);
    fill_untouched(2, C);
    CHECK_STATUS(mdr_body_compliance(NULL, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL), MDR_ENULL, "body is NULL");
    CHECK_STATUS(mdr_body_compliance(body, 4, 2, k, NULL, C, NULL), MDR_EINVALID, "load = 4");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, 2, k, infinite, C, NULL), MDR_EINVALID, "omega");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, -1, k, NULL, C, NULL), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, 2, bad, NULL, C, NULL), MDR_EINVALID, "entry 2 of k");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, 2, NULL, NULL, C, NULL), MDR_ENULL, "k is NULL");
    CHECK_STATUS(mdr_body_compliance(body, MDR_LOAD_NORMAL, 2, k, NULL, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_body_compliance((const mdr_body *)medium, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL), MDR_EINVALID,
                 "not a handle of type mdr_body");
    CHECK_STATUS(mdr_body_compliance(rigid, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL), MDR_EINVALID, "rigid");
    CHECK_STATUS(mdr_body_compliance(power, MDR_LOAD_SHEAR, 2, k, NULL, C, NULL), MDR_EINVALID, "power-law graded");
    CHECK_STATUS(mdr_body_compliance(tense, MDR_LOAD_SHEAR, 2, k, NULL, C, NULL), MDR_EINVALID, "for a pressure only");
    CHECK_UNTOUCHED(2, C);
    CHECK_SUCCESS(mdr_body_compliance(body, MDR_LOAD_NORMAL, 0, NULL, NULL, NULL, NULL));
    /* 1/C + tension k^2 in place of 1/C: short waves see nothing but the tension */
    CHECK_SUCCESS(mdr_body_compliance(tense, MDR_LOAD_NORMAL, 2, k, NULL, C, NULL));
    CHECK_CLOSE(C[1], 1.0 / (3.0 * k[1] * k[1]), 1e-8);
    CHECK_FREE(tense);
    CHECK_FREE(power);
    CHECK_FREE(rigid);
    CHECK_FREE(body);
    CHECK_FREE(medium);
}

/* The surface in space: far from a force it is that of the base, 1/(pi E* r), and close to it that of the film. */
static void responses(void)
{
    const double r[2] = {1e-9, 1e9}, none[2] = {1.0, 0.0}, y[2] = {0.0, 0.0}, bad[2] = {0.0, NAN};
    const mdr_layer film = mdr_isotropic(2.6, 0.3, 0.1), base = mdr_isotropic(26.0, 0.3, 0.0);
    const double pi = acos(-1.0);
    double u[2], error, tiny = 1e-9;
    int images;
    mdr_body *body = NULL, *rigid = NULL;
    mdr_response *response = NULL, *missed = NULL;

    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    CHECK_SUCCESS(mdr_body_rigid(&rigid));
    CHECK_SUCCESS(mdr_response_new(body, 1e-8, &response));
    CHECK_SUCCESS(mdr_response_about(response, &error, &images));
    CHECK_TRUE(error > 0.0 && error < 1e-8 && images == 60);
    CHECK_SUCCESS(mdr_response_point(response, 2, r, u));
    CHECK_CLOSE(u[0], 0.35 / (pi * r[0]), 1e-6);
    CHECK_CLOSE(u[1], 0.035 / (pi * r[1]), 1e-10);
    /* a square of side s displaces its centre by 4 s ln(1 + sqrt(2))/(pi E*) */
    CHECK_SUCCESS(mdr_response_rectangle(response, tiny, tiny, 2, y, y, u));
    CHECK_CLOSE(u[0], 4.0 * tiny * asinh(1.0) * 0.35 / pi, 1e-6);
    CHECK_TRUE(u[1] == u[0]);
    fill_untouched(2, u);
    CHECK_STATUS(mdr_response_new(rigid, 1e-8, &missed), MDR_EINVALID, "rigid");
    CHECK_STATUS(mdr_response_new(body, 0.0, &missed), MDR_EINVALID, "tolerance = 0");
    CHECK_STATUS(mdr_response_new(body, 1e-15, &missed), MDR_ENOCONVERGENCE, "240 images");
    CHECK_STATUS(mdr_response_new(NULL, 1e-8, &missed), MDR_ENULL, "body is NULL");
    CHECK_STATUS(mdr_response_new(body, 1e-8, NULL), MDR_ENULL, "out is NULL");
    CHECK_TRUE(missed == NULL);
    CHECK_STATUS(mdr_response_point(response, 2, none, u), MDR_EINVALID, "entry 2 of r");
    CHECK_STATUS(mdr_response_point(NULL, 2, r, u), MDR_ENULL, "response is NULL");
    CHECK_STATUS(mdr_response_point(response, -1, r, u), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_response_rectangle(response, 0.0, 1.0, 2, y, y, u), MDR_EINVALID, "width = 0");
    CHECK_STATUS(mdr_response_rectangle(response, 1.0, NAN, 2, y, y, u), MDR_EINVALID, "height");
    CHECK_STATUS(mdr_response_rectangle(response, 1.0, 1.0, 2, y, bad, u), MDR_EINVALID, "entry 2 of y");
    CHECK_STATUS(mdr_response_rectangle(response, 1.0, 1.0, 2, NULL, y, u), MDR_ENULL, "x is NULL");
    CHECK_STATUS(mdr_response_about(response, NULL, &images), MDR_ENULL, "tolerance is NULL");
    CHECK_STATUS(mdr_response_about((const mdr_response *)body, &error, NULL), MDR_EINVALID, "not a handle of type mdr_response");
    CHECK_UNTOUCHED(2, u);
    CHECK_SUCCESS(mdr_response_point(response, 0, NULL, NULL));
    CHECK_SUCCESS(mdr_response_rectangle(response, 1.0, 1.0, 0, NULL, NULL, NULL));
    CHECK_FREE(response);
    CHECK_FREE(rigid);
    CHECK_FREE(body);
}

int main(void)
{
    refusals();
    compliances();
    responses();
    rim_of_a_sphere();
    graded_bodies();
    one_material();
    rigid_base();
    surface_with_tension();
    surface_with_stiff_sheet();
    degenerate_stacks();
    depth_of_first_touch();
    exact_zeta_of_a_model();
    return check_report("media_exact");
}
