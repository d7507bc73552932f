/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

/* Exact media cost much, graded ones more. */
enum { PRICE_OF_EXACT = 30, PRICE_OF_EXACT_GRADED = 60, PRICE_OF_SAMPLED = 10 };

static const mdr_medium_options *take_options(input *in, int *model, mdr_medium_options *options)
{
    *model = take_member(in, MDR_MODEL_GAO, MDR_MODEL_EXACT - MDR_MODEL_GAO + 1);
    *options = MDR_SIZED(mdr_medium_options);
    options->tolerance = 1e-4; /* cheaper */
    if (!take_chance(in)) return options;
    if (take_chance(in)) return NULL;
    options->alpha = take_positive(in);
    options->wave_factor = take_positive(in);
    options->weight_nu_choice = TAKE_ONE_OF(in, MDR_WEIGHT_NU_SURFACE, MDR_WEIGHT_NU_SUBSTRATE, MDR_WEIGHT_NU_EFFECTIVE,
            MDR_WEIGHT_NU_GIVEN);
    options->weight_nu = take_ratio(in);
    options->tolerance = take_byte(in) % 2 ? 1e-6 : take_number(in);
    return options;
}

static double take_substrate(input *in)
{
    return take_byte(in) % 8 == 7 ? INFINITY : take_positive(in);
}

/* What the surface of a body answers. */
static void waves(input *in, const mdr_body *body)
{
    const int n = take_count(in), load = take_member(in, MDR_LOAD_NORMAL, MDR_LOAD_COUPLING - MDR_LOAD_NORMAL + 1);
    const int at_rest = take_chance(in);
    double k[MOST_POINTS], omega[MOST_POINTS], out[MOST_POINTS];

    take_positives(in, k);
    take_positives(in, omega);
    fill(out);
    judge("mdr_body_compliance", mdr_body_compliance(body, load, n, k, at_rest ? NULL : omega, out, NULL), n, out, FINITE);
}

/* Its limits, and its displacement in space. */
static void space(input *in, const mdr_body *body)
{
    const int n = take_count(in);
    const double tolerance = take_positive(in), width = take_positive(in), height = take_positive(in);
    double x[MOST_POINTS], y[MOST_POINTS], out[MOST_POINTS];
    mdr_response *response = NULL;

    fill(out);
    judge("mdr_body_compliance_limits", mdr_body_compliance_limits(body, 0.0, out, NULL), 3, out, NOT_NAN);
    take_positives(in, x);
    take_positives(in, y);
    judge_object("mdr_response_new", mdr_response_new(body, tolerance, &response), response);
    if (!response) return;
    fill(out);
    judge("mdr_response_about", mdr_response_about(response, out, NULL), 1, out, FINITE);
    fill(out);
    judge("mdr_response_point", mdr_response_point(response, n, x, out), n, out, FINITE);
    fill(out);
    judge("mdr_response_rectangle", mdr_response_rectangle(response, width, height, n, x, y, out), n, out, FINITE);
    judge_status("mdr_free", mdr_free(response));
}

/* Layers of all kinds, the stress at which one wrinkles, and what their surface answers. */
static int make_stack(world *w, mdr_medium **out, int *is_exact)
{
    input *in = &w->in;
    mdr_layer layers[4];
    mdr_medium_options options;
    const mdr_medium_options *chosen;
    mdr_surface surface = MDR_SIZED(mdr_surface);
    mdr_body *body = NULL;
    double stress, wavelength;
    int model, n = take_count(in) % 4, rigid = take_byte(in) % 8 == 7;

    for (int i = 0; i < 4; i++) {
        layers[i] = MDR_SIZED(mdr_layer);
        layers[i].thickness = take_positive(in);
        layers[i].E = take_positive(in);
        layers[i].nu = take_ratio(in);
        switch (take_byte(in) % 4) {
        case 0: break;
        case 1:
            layers[i].E_z = take_positive(in);
            layers[i].nu_tz = take_ratio(in);
            layers[i].G_z = take_positive(in);
            break;
        case 2:
            layers[i].C11 = take_positive(in);
            layers[i].C12 = take_number(in);
            layers[i].C13 = take_number(in);
            layers[i].C33 = take_positive(in);
            layers[i].C44 = take_positive(in);
            break;
        default: layers[i].prestress = take_number(in);
        }
        if (take_byte(in) % 4 == 3) layers[i].normal_compliance = take_number(in);
        if (take_byte(in) % 4 == 3) layers[i].tangential_compliance = take_chance(in) ? take_number(in) : INFINITY;
    }
    chosen = take_options(in, &model, &options);
    if (take_byte(in) % 4 == 3) {
        surface.tension = take_number(in);
        surface.bending = take_chance(in) ? take_number(in) : take_byte(in) % 2 * take_positive(in);
        if (take_chance(in)) surface.stretching = take_number(in);
    }
    *is_exact = 1;
    if (!afford(w, PRICE_OF_EXACT)) return MDR_ENULL;
    const int status = mdr_body_layered(n, layers, rigid ? NULL : &layers[3], &surface, &body);
    judge_object("mdr_body_layered", status, body);
    if (body) waves(in, body);
    if (body && take_byte(in) % 4 == 0) space(in, body);
    if (body && take_byte(in) % 8 == 7) {
        judge_status("mdr_body_wrinkling", mdr_body_wrinkling(body, take_count(in), &stress, &wavelength));
    }
    return medium_of(status, body, take_chance(in) ? MDR_MODEL_EXACT : model, chosen, out);
}

/* MDR_ENULL without an object where a costly one was left out. */
static int make(world *w, mdr_medium **out, int *is_exact)
{
    input *in = &w->in;
    mdr_medium_options options;
    const mdr_medium_options *chosen;
    double x[MOST_POINTS], y[MOST_POINTS], z[MOST_POINTS], p, q, r, s;
    user_function f, g;
    int n, model;

    switch (take_byte(in) % 12) {
    case 0:
        p = take_positive(in);
        return new_homogeneous(p, take_ratio(in), out);
    case 1:
        p = take_positive(in);
        return take_byte(in) % 4 < 3 ? mdr_medium_contact_modulus(p, out) : make_stack(w, out, is_exact);
    case 2:
    case 3:
        chosen = take_options(in, &model, &options);
        *is_exact = model == MDR_MODEL_EXACT;
        if (*is_exact && !afford(w, PRICE_OF_EXACT)) return MDR_ENULL;
        p = take_positive(in);
        q = model == MDR_MODEL_DIMITRIADIS || model == MDR_MODEL_GARCIA ? 0.5 : take_ratio(in);
        r = take_positive(in);
        s = model == MDR_MODEL_DIMITRIADIS || model == MDR_MODEL_GARCIA ? INFINITY : take_substrate(in);
        return new_coated(p, q, r, s, take_ratio(in), model, chosen, out);
    case 4:
        chosen = take_options(in, &model, &options);
        *is_exact = model == MDR_MODEL_EXACT;
        if (*is_exact && !afford(w, PRICE_OF_EXACT)) return MDR_ENULL;
        n = take_count(in) % 4;
        take_positives(in, x);
        take_ratios(in, y);
        take_positives(in, z);
        p = take_substrate(in);
        return new_layered(n, x, y, z, p, take_ratio(in), model, chosen, out);
    case 5:
        chosen = take_options(in, &model, &options);
        *is_exact = model == MDR_MODEL_EXACT;
        if (!afford(w, *is_exact ? PRICE_OF_EXACT_GRADED : PRICE_OF_SAMPLED)) return MDR_ENULL;
        n = take_count(in) % 4;
        take_ascending(in, x);
        take_positives(in, y);
        take_ratios(in, z);
        return medium_of_grades(n, x, y, z, model, chosen, out);
    case 6:
        chosen = take_options(in, &model, &options);
        if (model == MDR_MODEL_EXACT || !afford(w, PRICE_OF_SAMPLED)) return MDR_ENULL;
        f = take_function(in);
        g = take_function(in);
        (void)g;
        return medium_of_functions(call_function, call_function, &f, take_positive(in), model, chosen, out);
    case 7:
        p = take_positive(in);
        q = take_positive(in);
        r = take_ratio(in);
        return medium_of_power(p, q, r, take_ratio(in), out);
    case 8:
        n = take_count(in);
        take_ascending(in, x);
        if (x[0] == 0.0) x[0] = x[1] / 2.0;
        take_positives(in, y);
        return mdr_medium_table(n, x, y, out);
    case 9: return rigid_medium(out);
    case 10:
        *is_exact = 1;
        return afford(w, 1) ? mdr_medium_pair(some_medium(w), some_medium(w), out) : MDR_ENULL;
    default:
        if (!afford(w, PRICE_OF_SAMPLED)) return MDR_ENULL;
        f = take_function(in);
        p = take_positive(in);
        q = take_positive(in);
        return mdr_medium_function(call_function, &f, p, p + q, out);
    }
}

void fuzz_media(world *w)
{
    const int slot = take_byte(&w->in) % SLOTS;
    double a[MOST_POINTS], out[MOST_POINTS];
    int is_exact = 0, n;
    mdr_medium *made = NULL;
    const int status = make(w, &made, &is_exact);

    if (made || status != MDR_ENULL) judge_object("mdr_medium_...", status, made);
    if (made) {
        MDR_FREE(w->media[slot]);
        w->media[slot] = made;
        w->medium_is_exact[slot] = is_exact;
    }
    n = take_count(&w->in);
    take_positives(&w->in, a);
    if (!afford(w, 4)) return;
    const mdr_medium *medium = some_medium(w);
    fill(out);
    judge("mdr_medium_values", mdr_medium_values(medium, MDR_MODULUS, n, a, out), n, out, POSITIVE);
    fill(out);
    judge("mdr_medium_values", mdr_medium_values(medium, MDR_STIFFNESS, n, a, out), n, out, POSITIVE);
}
