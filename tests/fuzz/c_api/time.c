/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Viscoelastic materials and bodies, and their contacts in time. */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_EXACT = 30, PRICE_OF_HISTORY = 10, PRICE_OF_EXACT_HISTORY = 25, PRICE_OF_OSCILLATION = 5, PRICE_OF_STEP = 20 };

static int make_material(input *in, mdr_material **out)
{
    double moduli[MOST_POINTS], times[MOST_POINTS], relaxed, viscosity, nu, bulk, p, q, r;
    const int kind = take_byte(in) % 8;

    if (kind == 0) {
        p = take_positive(in);
        return mdr_material_viscoelastic(p, 0, NULL, NULL, 0.0, take_ratio(in), 0.0, out);
    }
    if (kind == 1) {
        p = take_positive(in), q = take_positive(in), r = take_chance(in) ? take_number(in) : take_byte(in) / 256.0;
        return mdr_material_power_law(p, q, r, take_ratio(in), out);
    }
    const int n = take_count(in);
    take_positives(in, moduli);
    take_positives(in, times);
    relaxed = take_byte(in) % 8 == 7 ? 0.0 : take_positive(in);
    viscosity = take_byte(in) % 8 == 7 ? take_positive(in) : 0.0;
    nu = take_ratio(in);
    bulk = take_byte(in) % 4 == 3 ? take_positive(in) : 0.0;
    return mdr_material_viscoelastic(relaxed, n, take_chance(in) ? NULL : moduli, times, viscosity, nu, bulk, out);
}

static void materials(world *w)
{
    const int slot = take_byte(&w->in) % SLOTS, n = take_count(&w->in), limit = TAKE_ONE_OF(&w->in, MDR_LIMIT_GLASSY,
            MDR_LIMIT_RELAXED);
    double x[MOST_POINTS], out[MOST_POINTS], other[MOST_POINTS];
    mdr_material *made = NULL;
    const mdr_material *material;
    int status = make_material(&w->in, &made);

    judge_object("mdr_material_...", status, made);
    if (made) {
        MDR_FREE(w->materials[slot]);
        w->materials[slot] = made;
    }
    take_positives(&w->in, x);
    material = some_material(w);
    fill(out);
    judge("mdr_material_values", mdr_material_values(material, MDR_RELAXATION, n, x, out, NULL), n, out, NOT_NEGATIVE);
    fill(out);
    judge("mdr_material_values", mdr_material_values(material, MDR_CREEP, n, x, out, NULL), n, out, NOT_NEGATIVE);
    fill(out), fill(other);
    status = mdr_material_values(material, MDR_COMPLEX_MODULUS, n, x, out, other);
    judge("mdr_material_values", status, n, out, NOT_NEGATIVE);
    judge("mdr_material_values", status, n, other, NOT_NEGATIVE);
    fill(out), fill(other);
    status = mdr_material_limit(material, limit, out, other);
    judge("mdr_material_limit", status, 1, out, POSITIVE);
    judge("mdr_material_limit", status, 1, other, FINITE);
}

static void body(world *w)
{
    enum { MOST_LAYERS = 3 };
    const int slot = take_byte(&w->in) % SLOTS, n = take_byte(&w->in) % (MOST_LAYERS + 1);
    const int model = take_byte(&w->in) % 4 ? MDR_MODEL_EXACT : take_member(&w->in, MDR_MODEL_GAO, MDR_MODEL_EXACT - MDR_MODEL_GAO);
    mdr_layer layers[MOST_LAYERS + 1];
    double thickness[MOST_POINTS];
    mdr_medium *made = NULL;

    for (int i = 0; i <= MOST_LAYERS; i++) {
        layers[i] = MDR_SIZED(mdr_layer);
        layers[i].material = some_material(w);
        if (take_byte(&w->in) % 8 == 7) layers[i].E = take_positive(&w->in);
        if (take_byte(&w->in) % 8 == 7) layers[i].material = NULL;
        if (take_byte(&w->in) % 4 == 3) layers[i].normal_compliance = take_number(&w->in);
        if (take_byte(&w->in) % 4 == 3) layers[i].tangential_compliance = take_chance(&w->in) ? take_number(&w->in) : INFINITY;
    }
    const mdr_layer *substrate = take_byte(&w->in) % 4 ? &layers[MOST_LAYERS] : NULL;
    take_positives(&w->in, thickness);
    for (int i = 0; i < MOST_LAYERS; i++) layers[i].thickness = thickness[i];
    if (n > 0 && model == MDR_MODEL_EXACT && !afford(w, PRICE_OF_EXACT)) return;
    const int status = medium_of_layers(n, layers, substrate, model, NULL, &made);
    judge_object("mdr_medium_new", status, made);
    if (!made) return;
    MDR_FREE(w->media[slot]);
    w->media[slot] = made;
    w->medium_is_exact[slot] = n > 0 && model == MDR_MODEL_EXACT;
}

/* A path of a contact; its cost is that of a coarse one. */
static void history(world *w)
{
    const int given = TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE, MDR_RADIUS), n = take_count(&w->in);
    double time[MOST_POINTS], in[MOST_POINTS], d[MOST_POINTS], a[MOST_POINTS], F[MOST_POINTS], tolerance = 1e-2, part = 0.0;
    const double *wanted = given == MDR_DEPTH ? d : given == MDR_FORCE ? F : a;
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);

    take_ascending(&w->in, time);
    if (take_chance(&w->in)) take_numbers(&w->in, in);
    else take_positives(&w->in, in);
    if (take_chance(&w->in)) tolerance = take_number(&w->in);
    if (tolerance > 1e-9 && tolerance < 1e-3) tolerance = 1e-3;
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_HISTORY : PRICE_OF_HISTORY)) return;
    fill(d), fill(a), fill(F);
    mdr_set_progress(&part);
    status = mdr_contact_history(contact, given, tolerance, n, time, in, d, a, F);
    mdr_set_progress(NULL);
    if (!(part >= 0.0 && part < 30.0)) finding("mdr_set_progress", "absurd progress", part);
    judge("mdr_contact_history", status, n, d, FINITE);
    judge("mdr_contact_history", status, n, a, NOT_NEGATIVE);
    judge("mdr_contact_history", status, n, F, FINITE);
    for (int i = 0; i < n && status == MDR_SUCCESS; i++) {
        if (fabs(wanted[i] - in[i]) > 1e-6 * fabs(in[i])) finding("mdr_contact_history", "another path than requested", wanted[i]);
    }
    judge_status("mdr_contact_history", mdr_contact_history(contact, given, 1e-2, 1, time, in, NULL, NULL, NULL));
}

static void oscillation(world *w)
{
    const int step = TAKE_ONE_OF(&w->in, MDR_RELAXATION, MDR_CREEP);
    double omega[MOST_POINTS], radius[MOST_POINTS], storage[MOST_POINTS], loss[MOST_POINTS], out[MOST_POINTS];
    int slot, status, n = take_count(&w->in);
    const mdr_contact *contact = some_contact(w, &slot);

    take_positives(&w->in, omega);
    take_positives(&w->in, radius);
    if (n > 2) n = 2;
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_OSCILLATION + PRICE_OF_STEP : 1)) return;
    fill(storage), fill(loss);
    status = mdr_contact_dynamic_stiffness(contact, n, omega, radius, storage, loss);
    judge("mdr_contact_dynamic_stiffness", status, n, storage, NOT_NEGATIVE);
    judge("mdr_contact_dynamic_stiffness", status, n, loss, FINITE);
    for (int i = 0; i < n && status == MDR_SUCCESS; i++) {
        if (loss[i] < -1e-12 * storage[i]) finding("mdr_contact_dynamic_stiffness", "energy from nowhere", loss[i]);
    }
    fill(out);
    judge("mdr_contact_step_response", mdr_contact_step_response(contact, step, radius[0], n, omega, out), n, out, FINITE);
}

void fuzz_time(world *w)
{
    switch (take_byte(&w->in) % 4) {
    case 0: materials(w); break;
    case 1: body(w); break;
    case 2: history(w); break;
    default: oscillation(w); break;
    }
}
