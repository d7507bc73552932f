/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of objects by name: those that they were made of, in the order of fits. */
#include "check.h"

enum { MOST = 20 };

/* Names, separated by blanks, and the first and last value. */
static void check_numbers(const void *object, const char *names, double first, double last)
{
    mdr_parameter found[MOST];
    char all[MOST * 50] = "";
    int count = -1, half = -1;

    CHECK_SUCCESS(mdr_parameters(object, 0, NULL, &count));
    CHECK_TRUE(count >= 0 && count <= MOST);
    CHECK_SUCCESS(mdr_parameters(object, count, found, &half));
    CHECK_INT(half, count);
    for (int i = 0; i < count; i++) {
        strcat(all, found[i].name);
        strcat(all, " ");
    }
    CHECK_TEXT(all, names);
    if (count < 1) return;
    CHECK_CLOSE(found[0].value, first, 1e-15);
    CHECK_CLOSE(found[count - 1].value, last, 1e-15);
    found[count - 1].value = untouched;
    CHECK_SUCCESS(mdr_parameters(object, count - 1, found, &half));
    CHECK_CLOSE(found[count - 1].value, untouched, 0.0);
}

static void of_indenters_and_materials(void)
{
    mdr_profile *p = NULL;
    mdr_material *m = NULL;

    CHECK_SUCCESS(mdr_profile_flat_cone(2.0, 0.3, &p));
    check_numbers(p, "end_radius inclination ", 2.0, 0.3);
    CHECK_FREE(p);
    CHECK_SUCCESS(mdr_material_power_law(5.0, 2.0, 0.2, 0.4, &m));
    check_numbers(m, "modulus time exponent nu ", 5.0, 0.4);
    CHECK_FREE(m);
}

static void of_bodies_and_media(void)
{
    const double z[2] = {0.0, 1.0}, E[2] = {3.0, 4.0}, nu[2] = {0.1, 0.2};
    const mdr_layer film = mdr_isotropic(2.0, 0.3, 0.5), base = mdr_isotropic(7.0, 0.25, 0.0);
    mdr_layer gel = MDR_SIZED(mdr_layer);
    mdr_medium_options options = MDR_SIZED(mdr_medium_options);
    mdr_surface surface = MDR_SIZED(mdr_surface);
    mdr_material *material = NULL;
    mdr_body *body = NULL;
    mdr_medium *m = NULL, *pair = NULL;

    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    check_numbers(body, "layers[0].E layers[0].nu layers[0].thickness layers[0].prestress layers[0].interface.normal "
                  "layers[0].interface.tangential substrate.E substrate.nu ", 2.0, 0.25);
    options.model = MDR_MODEL_DOERNER_NIX;
    options.alpha = 1.5;
    CHECK_SUCCESS(mdr_medium_new(body, &options, &m));
    check_numbers(m, "layers[0].E layers[0].nu layers[0].thickness layers[0].prestress layers[0].interface.normal "
                  "layers[0].interface.tangential substrate.E substrate.nu alpha ", 2.0, 1.5);
    CHECK_SUCCESS(mdr_medium_pair(m, m, &pair));
    check_numbers(pair, "", 0.0, 0.0);
    CHECK_FREE(pair);
    CHECK_FREE(m);
    CHECK_FREE(body);
    surface.tension = 0.75;
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &base, &surface, &body));
    check_numbers(body, "E nu ", 7.0, 0.25);
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &m));
    check_numbers(m, "E nu surface.tension surface.bending surface.stretching ", 7.0, 0.0);
    CHECK_FREE(m);
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_body_graded(2, z, E, nu, &body));
    check_numbers(body, "z[0] E[0] nu[0] z[1] E[1] nu[1] ", 0.0, 0.2);
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_body_power_graded(3.0, 2.0, 0.2, 0.4, &body));
    check_numbers(body, "E0 z0 exponent nu ", 3.0, 0.4);
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_body_rigid(&body));
    check_numbers(body, "", 0.0, 0.0);
    CHECK_FREE(body);
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 0, NULL, NULL, 0.0, 0.5, 0.0, &material));
    gel.material = material;
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &gel, NULL, &body));
    check_numbers(body, "E nu ", 3.0, 0.5);
    CHECK_FREE(body);
    CHECK_FREE(material);
}

static void refusals(void)
{
    mdr_parameter out;
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    int count = 77;

    CHECK_SUCCESS(mdr_profile_sphere(1.0, &p));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &m));
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_STATUS(mdr_parameters(c, 0, NULL, &count), MDR_EINVALID,
                 "object: it is not a handle of type mdr_profile, mdr_material, mdr_body or mdr_medium");
    CHECK_STATUS(mdr_parameters(NULL, 0, NULL, &count), MDR_ENULL, "object is NULL");
    CHECK_STATUS(mdr_parameters(p, 1, NULL, &count), MDR_ENULL, "out is NULL");
    CHECK_STATUS(mdr_parameters(p, 1, &out, NULL), MDR_ENULL, "count is NULL");
    CHECK_STATUS(mdr_parameters(p, -1, &out, &count), MDR_EINVALID, "capacity = -1");
    CHECK_INT(count, 77);
    CHECK_FREE(c);
    CHECK_FREE(m);
    CHECK_FREE(p);
}

int main(void)
{
    of_indenters_and_materials();
    of_bodies_and_media();
    refusals();
    return check_report("parameters");
}
