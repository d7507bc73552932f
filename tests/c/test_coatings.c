/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Layers of any kind: their structure, refusals, a half-space in closed form, sliding, wrinkling. Numbers: tests/python. */
#include "check.h"

static mdr_layer isotropic(double E, double nu, double thickness)
{
    mdr_layer layer = MDR_SIZED(mdr_layer);

    layer.E = E;
    layer.nu = nu;
    layer.thickness = thickness;
    return layer;
}

static mdr_layer zinc_oxide(double thickness)
{
    mdr_layer layer = MDR_SIZED(mdr_layer);

    layer.C11 = 209.7;
    layer.C12 = 121.1;
    layer.C13 = 105.1;
    layer.C33 = 210.9;
    layer.C44 = 42.5;
    layer.thickness = thickness;
    return layer;
}

static void half_space(void)
{
    const mdr_layer base = zinc_oxide(0.0);
    const double a[1] = {0.7};
    double found[1];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(medium_of_layers(0, NULL, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, found));
    CHECK_CLOSE(found[0], 145.561086575394, 1e-13);
    CHECK_SUCCESS(mdr_medium_values(m, MDR_TANGENTIAL_MODULUS, 1, a, found));
    CHECK_CLOSE(2.0 * a[0] * found[0], 152.06802931755, 1e-13);
    CHECK_FREE(m);
}

/* A program whose structure is longer than the library's: elements lie farther apart. */
typedef struct longer_layer {
    mdr_layer known;
    double unknown;
} longer_layer;

static void strides(void)
{
    const mdr_layer film[2] = {zinc_oxide(1.0), isotropic(100.0, 0.2, 0.5)}, base = isotropic(130.0, 0.28, 0.0);
    longer_layer longer[2] = {{film[0], 0.0}, {film[1], 0.0}};
    const double a[1] = {0.7};
    double one[1], other[1];
    mdr_medium *m = NULL;

    CHECK_SUCCESS(medium_of_layers(2, film, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, one));
    CHECK_FREE(m);
    for (int i = 0; i < 2; i++) longer[i].known.size = sizeof(longer_layer);
    CHECK_SUCCESS(medium_of_layers(2, &longer[0].known, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, other));
    CHECK_FREE(m);
    CHECK_TRUE(one[0] == other[0]);
    longer[1].unknown = 1.0;
    CHECK_STATUS(medium_of_layers(2, &longer[0].known, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "unknown to this library");
    longer[0].known.size = 0;
    CHECK_STATUS(medium_of_layers(2, &longer[0].known, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "layer 1->size = 0");
    longer[0].known.size = (size_t)1 << 60;
    CHECK_STATUS(medium_of_layers(2, &longer[0].known, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "layer 1->size = ");
    CHECK_TRUE(m == NULL);
}

static void refusals(void)
{
    mdr_layer film = zinc_oxide(1.0);
    const mdr_layer base = isotropic(130.0, 0.28, 0.0);
    const double a[1] = {0.7};
    double found[1];
    mdr_medium *m = NULL;

    CHECK_STATUS(medium_of_layers(1, NULL, &base, MDR_MODEL_EXACT, NULL, &m), MDR_ENULL, "layers is NULL");
    CHECK_STATUS(medium_of_layers(1, &film, &base, MDR_MODEL_EXACT, NULL, NULL), MDR_ENULL, "out is NULL");
    CHECK_STATUS(medium_of_layers(0, NULL, NULL, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "a rigid base needs at least one layer");
    CHECK_STATUS(medium_of_layers(-1, &film, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "n = -1");
    CHECK_STATUS(medium_of_layers(1, &film, &base, MDR_MODEL_GAO, NULL, &m), MDR_EINVALID, "Use one of exact");
    film.C13 = 300.0;
    CHECK_STATUS(medium_of_layers(1, &film, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "layer 1 C13 = 300");
    film = zinc_oxide(1.0);
    film.normal_compliance = INFINITY;
    CHECK_STATUS(medium_of_layers(1, &film, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "normal_compliance = ");
    film.normal_compliance = 0.0;
    film.tangential_compliance = -1.0;
    CHECK_STATUS(medium_of_layers(1, &film, &base, MDR_MODEL_EXACT, NULL, &m), MDR_EINVALID, "tangential_compliance = -1");
    film.tangential_compliance = INFINITY;
    CHECK_SUCCESS(medium_of_layers(1, &film, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, found));
    CHECK_STATUS(mdr_medium_values(m, MDR_TANGENTIAL_MODULUS, 1, a, found), MDR_EINVALID, "sliding interface");
    CHECK_FREE(m);
}

/* The thin film of Chen and Hutchinson. */
static void wrinkles(void)
{
    const mdr_layer film = isotropic(1e5, 0.3, 1.0), base = isotropic(1.0, 0.5, 0.0);
    const double plane = 1e5 / 0.91, half = 1.0 / 0.75, pi = 3.14159265358979323846;
    double stress = 0.0, wavelength = 0.0;
    mdr_surface tension = MDR_SIZED(mdr_surface);
    mdr_body *body = NULL, *other = NULL;

    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, NULL, &body));
    CHECK_SUCCESS(mdr_body_wrinkling(body, 1, &stress, &wavelength));
    CHECK_CLOSE(stress, -0.25 * plane * pow(3.0 * half / plane, 2.0 / 3.0), 2e-4);
    CHECK_CLOSE(wavelength, 2.0 * pi * cbrt(plane / (3.0 * half)), 5e-4);
    CHECK_SUCCESS(mdr_body_wrinkling(body, 1, NULL, NULL));
    CHECK_STATUS(mdr_body_wrinkling(body, 2, &stress, NULL), MDR_EINVALID, "layer = 2");
    CHECK_STATUS(mdr_body_wrinkling(body, 0, &stress, NULL), MDR_EINVALID, "layer = 0");
    CHECK_FREE(body);
    tension.tension = 1.0;
    CHECK_SUCCESS(mdr_body_layered(1, &film, &base, &tension, &other));
    CHECK_STATUS(mdr_body_wrinkling(other, 1, &stress, NULL), MDR_EINVALID, "bare surface");
    CHECK_FREE(other);
    CHECK_SUCCESS(mdr_body_power_graded(1.0, 1.0, 0.2, 0.3, &other));
    CHECK_STATUS(mdr_body_wrinkling(other, 1, &stress, NULL), MDR_EINVALID, "elastic layers");
    CHECK_FREE(other);
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &base, NULL, &other));
    CHECK_STATUS(mdr_body_wrinkling(other, 1, &stress, NULL), MDR_EINVALID, "from 1 (at the surface) to 0");
    CHECK_FREE(other);
}

int main(void)
{
    half_space();
    strides();
    refusals();
    wrinkles();
    return check_report("coatings");
}
