/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Viscoelastic materials, media and histories: closed forms, limits, refusals. */
#include "check.h"
#include "mdrcontact/time.h"

enum { N = 4 };

static const double moduli[] = {2.0, 0.5}, times[] = {0.3, 3.0};

static mdr_material *polymer(void)
{
    mdr_material *material = NULL;

    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 2, moduli, times, 0.0, 0.4, 0.0, &material));
    return material;
}

static double relaxation(double t) { return 1.0 + 2.0 * exp(-t / 0.3) + 0.5 * exp(-t / 3.0); }

static void test_materials(void)
{
    const double t[N] = {0.0, 0.3, 2.0, 50.0}, omega[1] = {2.0};
    double G[N], J[N], storage, loss, E, nu, untouched = 7.0;
    mdr_material *material = polymer(), *power = NULL, *elastic = NULL, *none = NULL;

    CHECK_SUCCESS(mdr_material_values(material, MDR_RELAXATION, N, t, G, NULL));
    for (int i = 0; i < N; i++) CHECK_CLOSE(G[i], relaxation(t[i]), 1e-15);
    CHECK_SUCCESS(mdr_material_values(material, MDR_CREEP, N, t, J, NULL));
    CHECK_CLOSE(J[0], 1.0 / 3.5, 1e-14);
    CHECK_CLOSE(J[3], 1.0, 1e-4);
    CHECK_SUCCESS(mdr_material_values(material, MDR_COMPLEX_MODULUS, 1, omega, &storage, &loss));
    CHECK_CLOSE(storage, 1.0 + 2.0 * 0.36 / 1.36 + 0.5 * 36.0 / 37.0, 1e-14);
    CHECK_CLOSE(loss, 2.0 * 0.6 / 1.36 + 0.5 * 6.0 / 37.0, 1e-14);
    CHECK_SUCCESS(mdr_material_limit(material, MDR_LIMIT_GLASSY, &E, &nu));
    CHECK_CLOSE(E, 2.8 * 3.5, 1e-15);
    CHECK_SUCCESS(mdr_material_limit(material, MDR_LIMIT_RELAXED, &E, NULL));
    CHECK_CLOSE(E, 2.8, 1e-15);
    CHECK_SUCCESS(mdr_material_power_law(2.0, 0.5, 0.3, 0.5, &power));
    CHECK_SUCCESS(mdr_material_values(power, MDR_RELAXATION, 1, omega, G, NULL));
    CHECK_CLOSE(G[0], 2.0 * pow(4.0, -0.3), 1e-15);
    CHECK_STATUS(mdr_material_values(power, MDR_RELAXATION, N, t, G, NULL), MDR_EINVALID, "infinite");
    CHECK_SUCCESS(mdr_material_values(power, MDR_CREEP, N, t, J, NULL));
    CHECK_TRUE(J[0] == 0.0 && J[1] > 0.0);
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &elastic));
    CHECK_SUCCESS(mdr_material_limit(elastic, MDR_LIMIT_RELAXED, &E, &nu));
    CHECK_CLOSE(E, 1.0, 1e-15);

    CHECK_STATUS(mdr_material_limit(power, MDR_LIMIT_GLASSY, &untouched, NULL), MDR_EINVALID, "glassy");
    CHECK_STATUS(mdr_material_limit(material, 3, &untouched, NULL), MDR_EINVALID, "limit = 3");
    CHECK_STATUS(mdr_material_values(material, MDR_RELAXATION, -1, t, G, NULL), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_material_values(material, MDR_RELAXATION, 1, NULL, G, NULL), MDR_ENULL, "t");
    CHECK_STATUS(mdr_material_values(NULL, MDR_RELAXATION, 1, t, G, NULL), MDR_ENULL, "m");
    CHECK_STATUS(mdr_material_power_law(1.0, 1.0, 0.0, 0.5, &none), MDR_EINVALID, "exponent = 0");
    CHECK_STATUS(mdr_material_power_law(1.0, NAN, 0.5, 0.5, &none), MDR_EINVALID, "time");
    CHECK_STATUS(mdr_material_viscoelastic(1.0, 0, NULL, NULL, 0.0, 0.3, 0.0, NULL), MDR_ENULL, "out");
    CHECK_STATUS(mdr_material_viscoelastic(1.0, 2, NULL, times, 0.0, 0.4, 0.0, &none), MDR_ENULL, "moduli");
    CHECK_STATUS(mdr_material_viscoelastic(1.0, 2, times, moduli, 1.0, 0.4, 1.0, &none), MDR_EINVALID, "viscosity = 1");
    CHECK_STATUS(mdr_material_viscoelastic(0.0, 0, NULL, NULL, 1.0, 0.4, 0.0, &none), MDR_EINVALID, "it must be greater than 0");
    CHECK_TRUE(none == NULL && untouched == 7.0);
    CHECK_FREE(material);
    CHECK_FREE(power);
    CHECK_FREE(elastic);
    CHECK_SUCCESS(mdr_free(NULL));
}

static void test_histories(void)
{
    const double t[N] = {0.0, 0.1, 1.0, 10.0}, held[N] = {0.5, 0.5, 0.5, 0.5}, backward[N] = {0.0, 1.0, 0.5, 2.0};
    const double again[N] = {0.1, 0.3, 0.2, 0.3};
    double d[N], a[N], F[N], energy, untouched[N] = {7.0, 7.0, 7.0, 7.0};
    mdr_material *material = polymer();
    const mdr_material *film[1] = {material}, *halves[2] = {material, material};
    const double h = 1.0;
    mdr_profile *ball = NULL;
    mdr_medium *body = NULL, *coated = NULL, *none = NULL;
    mdr_contact *contact = NULL, *gel = NULL;
    mdr_state state = {0};

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, material, MDR_MODEL_EXACT, NULL, &body));
    CHECK_SUCCESS(relaxing_medium(1, film, &h, NULL, MDR_MODEL_EXACT, NULL, &coated));
    CHECK_SUCCESS(mdr_contact_new(ball, body, NULL, &contact));
    CHECK_SUCCESS(mdr_contact_new(ball, coated, NULL, &gel));
    CHECK_SUCCESS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, N, t, held, NULL, a, F));
    for (int i = 0; i < N; i++) {
        CHECK_CLOSE(a[i], sqrt(0.5), 1e-12);
        CHECK_CLOSE(F[i], 4.0 / 3.0 * 2.0 / 0.6 * relaxation(t[i]) * pow(0.5, 1.5), 1e-11);
    }
    CHECK_SUCCESS(mdr_contact_history(contact, MDR_FORCE, 1e-5, N, t, held, d, NULL, NULL));
    CHECK_TRUE(d[0] < d[1] && d[1] < d[2] && d[2] < d[3]);
    CHECK_SUCCESS(mdr_contact_history(gel, MDR_DEPTH, 1e-5, N, t, held, d, a, F));
    for (int i = 1; i < N; i++) CHECK_CLOSE(F[i] / F[0], relaxation(t[i]) / 3.5, 1e-9);
    for (int i = 0; i < N; i++) CHECK_CLOSE(d[i], held[i], 0.0);
    /* two layers of the film's material are the film */
    CHECK_FREE(gel);
    CHECK_FREE(coated);
    CHECK_SUCCESS(relaxing_medium(2, halves, (const double[2]){0.25, 0.75}, NULL, MDR_MODEL_EXACT, NULL, &coated));
    CHECK_SUCCESS(mdr_contact_new(ball, coated, NULL, &gel));
    CHECK_SUCCESS(mdr_contact_history(gel, MDR_DEPTH, 1e-5, N, t, held, NULL, NULL, d));
    for (int i = 0; i < N; i++) CHECK_CLOSE(d[i], F[i], 1e-9);
    CHECK_SUCCESS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, 0, NULL, NULL, NULL, NULL, NULL));

    CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, N, backward, held, untouched, NULL, NULL),
                 MDR_EINVALID, "ascending");
    /* marched, in two rounds or more, the last of them up to its last sample */
    double part = -1.0;
    CHECK_SUCCESS(mdr_set_progress(&part));
    CHECK_SUCCESS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, N, t, again, NULL, a, F));
    CHECK_TRUE(part > 1.0 && part < 20.0);
    CHECK_CLOSE(part - floor(part), (N - 2) / (double)N, 1e-14);
    CHECK_SUCCESS(mdr_set_progress(NULL));
    part = -1.0;
    CHECK_SUCCESS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, N, t, again, NULL, a, F));
    CHECK_TRUE(part == -1.0);
    CHECK_TRUE(a[2] < a[1] && a[2] < a[3] && F[2] < F[1]);
    CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 0.0, N, t, again, untouched, NULL, NULL), MDR_EINVALID, "tolerance");
    CHECK_STATUS(mdr_contact_history(contact, 9, 1e-5, N, t, held, untouched, NULL, NULL), MDR_EINVALID, "given = 9");
    CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, -1, t, held, untouched, NULL, NULL), MDR_EINVALID, "n = -1");
    CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-5, N, NULL, held, untouched, NULL, NULL), MDR_ENULL, "time");
    CHECK_STATUS(mdr_contact_history(NULL, MDR_DEPTH, 1e-5, N, t, held, untouched, NULL, NULL), MDR_ENULL, "c");
    CHECK_STATUS(columns_of(contact, MDR_DEPTH, 1, held, untouched, NULL, NULL, NULL), MDR_EINVALID, "history");
    CHECK_STATUS(mdr_medium_values(body, MDR_MODULUS, 1, held, untouched), MDR_EINVALID, "history");
    state.depth = 0.5;
    state.radius = 0.7;
    CHECK_STATUS(state_field(contact, MDR_PRESSURE, &state, 1, t, untouched), MDR_EINVALID, "");
    CHECK_STATUS(state_energy(contact, &state, &energy, NULL), MDR_EINVALID, "");
    CHECK_STATUS(relaxing_medium(0, NULL, NULL, NULL, MDR_MODEL_EXACT, NULL, &none), MDR_EINVALID, "rigid");
    CHECK_STATUS(relaxing_medium(1, film, &h, material, 99, NULL, &none), MDR_EINVALID, "model = 99");
    mdr_layer mixed = MDR_SIZED(mdr_layer);
    mixed.thickness = h;
    mixed.material = material;
    mixed.E = 1.0;
    CHECK_STATUS(medium_of_layers(1, &mixed, NULL, MDR_MODEL_EXACT, NULL, &none), MDR_EINVALID, "constants and prestress of layer");
    mdr_layer of_crystal[2] = {MDR_SIZED(mdr_layer), MDR_SIZED(mdr_layer)};
    of_crystal[0].thickness = of_crystal[1].thickness = h;
    of_crystal[0].material = material;
    of_crystal[1].E = 1.0;
    of_crystal[1].prestress = 0.1;
    CHECK_STATUS(medium_of_layers(2, of_crystal, NULL, MDR_MODEL_EXACT, NULL, &none), MDR_EINVALID, "prestress of layer 2");
    mdr_body *relaxing = NULL;
    CHECK_SUCCESS(mdr_body_layered(1, of_crystal, NULL, NULL, &relaxing));
    CHECK_STATUS(mdr_body_wrinkling(relaxing, 1, NULL, NULL), MDR_EINVALID, "viscoelastic");
    CHECK_FREE(relaxing);
    of_crystal[0].normal_compliance = -1.0;
    CHECK_STATUS(medium_of_layers(1, of_crystal, NULL, MDR_MODEL_EXACT, NULL, &none), MDR_EINVALID, "normal_compliance = -1");
    CHECK_STATUS(relaxing_medium(1, film, &h, (const mdr_material *)ball, MDR_MODEL_EXACT, NULL, &none),
                 MDR_EINVALID, "substrate");
    CHECK_TRUE(none == NULL);
    for (int i = 0; i < N; i++) CHECK_TRUE(untouched[i] == 7.0);
    const double omega[2] = {2.0, 2.0}, radius[2] = {0.5, 1.5};
    double storage[2], loss[2], G, lost;
    CHECK_SUCCESS(mdr_contact_dynamic_stiffness(contact, 2, omega, radius, storage, loss));
    CHECK_SUCCESS(mdr_material_values(material, MDR_COMPLEX_MODULUS, 1, omega, &G, &lost));
    CHECK_CLOSE(storage[1], 2.0 * 1.5 * 2.0 * G / 0.6, 1e-14);
    CHECK_CLOSE(loss[0], 2.0 * 0.5 * 2.0 * lost / 0.6, 1e-14);
    CHECK_SUCCESS(mdr_contact_step_response(contact, MDR_RELAXATION, 0.5, N - 1, t + 1, F));
    for (int i = 1; i < N; i++) CHECK_CLOSE(F[i - 1], 2.0 / 0.6 * relaxation(t[i]), 1e-12);
    CHECK_STATUS(mdr_contact_step_response(contact, 3, 0.5, 1, t + 1, untouched), MDR_EINVALID, "step = 3");
    CHECK_STATUS(mdr_contact_step_response(contact, MDR_CREEP, -0.5, 1, t + 1, untouched), MDR_EINVALID, "radius");
    CHECK_STATUS(mdr_contact_step_response(contact, MDR_CREEP, 0.5, 1, t, untouched), MDR_EINVALID, "time");
    CHECK_STATUS(mdr_contact_dynamic_stiffness(contact, 1, omega, NULL, untouched, untouched), MDR_ENULL, "radius");
    CHECK_STATUS(mdr_contact_dynamic_stiffness(contact, 2, omega, t, untouched, untouched), MDR_EINVALID, "radius");
    CHECK_STATUS(mdr_contact_dynamic_stiffness(NULL, 1, omega, radius, untouched, untouched), MDR_ENULL, "c");
    for (int i = 0; i < N; i++) CHECK_TRUE(untouched[i] == 7.0);
    CHECK_FREE(contact);
    CHECK_FREE(gel);
    CHECK_FREE(body);
    CHECK_FREE(coated);
    CHECK_FREE(ball);
    CHECK_FREE(material);
}

/* Layers that do not relax in proportion: what is refused writes nothing, and a contact is lost and comes back. */
static void test_marching(void)
{
    const double t[5] = {0.0, 1.0, 1.2, 3.0, 4.0}, path[5] = {0.0, 0.4, -0.1, 0.0, 0.4}, jump[5] = {0.1, 0.1, 0.1, 0.1, 0.1};
    const double twice[5] = {0.0, 1.0, 1.0, 3.0, 4.0}, missing[5] = {0.0, 0.1, NAN, 0.1, 0.1};
    const double pull[5] = {0.0, 0.1, -0.1, 0.1, 0.1}, h = 1.0;
    double d[5], a[5], F[5], untouched[5] = {7.0, 7.0, 7.0, 7.0, 7.0};
    mdr_material *film = polymer(), *gel = NULL, *kelvin = NULL, *base = NULL;
    mdr_profile *ball = NULL;

    CHECK_SUCCESS(mdr_material_power_law(1.0, 1.0, 0.2, 0.5, &gel));
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 0, NULL, NULL, 0.5, 0.4, 0.0, &kelvin));
    CHECK_SUCCESS(mdr_material_viscoelastic(10.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &base));
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    const mdr_material *tops[3] = {film, gel, kelvin};
    for (int i = 0; i < 3; i++) {
        mdr_medium *coated = NULL;
        mdr_contact *contact = NULL;
        CHECK_SUCCESS(relaxing_medium(1, tops + i, &h, base, MDR_MODEL_EXACT, NULL, &coated));
        CHECK_SUCCESS(mdr_contact_new(ball, coated, NULL, &contact));
        if (i < 2) {
            CHECK_SUCCESS(mdr_contact_history(contact, MDR_DEPTH, 1e-3, 5, t, path, d, a, F));
            CHECK_TRUE(a[2] == 0.0 && F[2] == 0.0 && a[4] > 0.0 && F[4] > 0.5 * F[1] && F[4] < F[1]);
        } else {
            CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-3, 5, t, path, untouched, untouched, untouched),
                         MDR_EINVALID, "dashpot");
        }
        if (i > 0) {
            CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-3, 5, t, jump, untouched, untouched, untouched),
                         MDR_EINVALID, "Begin with 0");
        }
        CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-3, 5, twice, path, untouched, untouched, untouched),
                     MDR_EINVALID, "ascending");
        CHECK_STATUS(mdr_contact_history(contact, MDR_DEPTH, 1e-3, 5, t, missing, untouched, untouched, untouched),
                     MDR_EINVALID, "finite");
        CHECK_STATUS(mdr_contact_history(contact, MDR_FORCE, 1e-3, 5, t, pull, untouched, untouched, untouched),
                     MDR_EINVALID, "force");
        CHECK_FREE(contact);
        CHECK_FREE(coated);
    }
    for (int i = 0; i < 5; i++) CHECK_TRUE(untouched[i] == 7.0);
    CHECK_FREE(ball);
    CHECK_FREE(film);
    CHECK_FREE(gel);
    CHECK_FREE(kelvin);
    CHECK_FREE(base);
}

int main(void)
{
    test_materials();
    test_histories();
    test_marching();
    return check_report("history");
}
