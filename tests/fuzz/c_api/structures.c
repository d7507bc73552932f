/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { MOST_BODIES = 2, NUMBERS = 7, PRICE_OF_STRUCTURE = 1, PRICE_OF_RADIUS = 25 };

static user_function field; /* a structure keeps its function: it lives as long as the last structure made */

static const mdr_structure_options *take_options(input *in, mdr_structure_options *options)
{
    *options = MDR_SIZED(mdr_structure_options);
    options->tolerance = 1e-2; /* cheaper */
    if (!take_chance(in)) return options;
    options->reference_nu = take_ratio(in);
    options->tolerance = take_byte(in) % 2 ? 1e-3 : take_number(in);
    options->padded = take_choice(in, 2);
    options->images = take_choice(in, 3);
    options->beside_E = take_positive(in);
    options->beside_nu = take_ratio(in);
    options->origin[0] = take_number(in);
    options->origin[1] = take_number(in);
    options->exponent = take_ratio(in);
    return options;
}

static int make_voxels(input *in, const mdr_structure_options *options, mdr_structure **out)
{
    int size[3], labels[27];
    double E[MOST_POINTS], nu[MOST_POINTS], spacing[MOST_POINTS], below;
    const int phases = take_choice(in, 4);

    for (int i = 0; i < 3; i++) size[i] = take_choice(in, 4);
    for (int i = 0; i < 3; i++) size[i] = size[i] > 3 ? 3 : size[i];
    for (int i = 0; i < 27; i++) labels[i] = take_byte(in) % 3 == 0 ? take_choice(in, 3) : 0;
    take_positives(in, E);
    take_ratios(in, nu);
    take_positives(in, spacing);
    below = take_positive(in);
    return mdr_structure_voxels(size, labels, phases > MOST_POINTS ? MOST_POINTS : phases, E, nu, spacing, below, take_ratio(in),
                                options, out);
}

static int make(world *w, mdr_structure **out)
{
    input *in = &w->in;
    mdr_structure_options options;
    const mdr_structure_options *chosen = take_options(in, &options);
    double E, nu, parameters[MOST_BODIES * NUMBERS], shape_E[MOST_POINTS], shape_nu[MOST_POINTS];
    int kinds[MOST_BODIES], n;

    switch (take_byte(in) % 4) {
    case 0: return make_voxels(in, chosen, out);
    case 1:
        MDR_FREE(w->structure);
        field = take_function(in);
        nu = take_ratio(in);
        options.tolerance = take_byte(in) % 2 ? 1e-2 : take_number(in);
        return mdr_structure_function(call_field, &field, nu, chosen, out);
    default:
        E = take_positive(in);
        nu = take_ratio(in);
        n = take_count(in) % (MOST_BODIES + 1);
        for (int i = 0; i < MOST_BODIES; i++) kinds[i] = take_member(in, MDR_SHAPE_LAYER, 6);
        for (int i = 0; i < MOST_BODIES * NUMBERS; i++) parameters[i] = take_byte(in) % 2 ? take_number(in) : take_positive(in);
        take_positives(in, shape_E);
        take_ratios(in, shape_nu);
        return mdr_structure_shapes(E, nu, n, kinds, parameters, shape_E, shape_nu, chosen, out);
    }
}

static void evaluate(world *w)
{
    input *in = &w->in;
    double x[MOST_POINTS], y[MOST_POINTS], a[MOST_POINTS], out[MOST_POINTS];
    const mdr_structure *structure = some_structure(w);
    int n = take_count(in), status;
    mdr_medium *medium = NULL;

    take_numbers(in, x);
    take_numbers(in, y);
    take_positives(in, a);
    if (n > 2) n = 2;
    if (!afford(w, n * PRICE_OF_RADIUS)) return;
    fill(out);
    status = mdr_structure_modulus(structure, n, x, y, a, out);
    judge("mdr_structure_modulus", status, n, out, POSITIVE);
    if (!take_chance(in) || !afford(w, 2 * PRICE_OF_RADIUS)) return;
    status = mdr_structure_medium(structure, x[0], y[0], a[0], a[1], 3, &medium);
    judge_object("mdr_structure_medium", status, medium);
    if (medium) {
        MDR_FREE(w->media[0]);
        w->media[0] = medium;
        w->medium_is_exact[0] = 0;
    }
}

static void weights(world *w)
{
    input *in = &w->in;
    double x[MOST_POINTS], y[MOST_POINTS], p[MOST_POINTS], q[MOST_POINTS], a, top;
    const double nu = take_ratio(in);
    const int n = take_count(in);
    int status;

    take_positives(in, x);
    take_positives(in, y);
    fill(p), fill(q);
    status = mdr_lateral_density(n, x, y, nu, p, q);
    judge("mdr_lateral_density", status, n, p, NOT_NAN);
    judge("mdr_lateral_density", status, n, q, NOT_NAN);
    take_ascending(in, x);
    take_ascending(in, y);
    a = take_positive(in);
    top = take_positive(in);
    fill(p), fill(q);
    status = mdr_lateral_cells(nu, a, top, top + take_positive(in), 2, x, 3, y, p, q);
    judge("mdr_lateral_cells", status, 6, p, FINITE);
    judge("mdr_lateral_cells", status, 6, q, FINITE);
}

void fuzz_structures(world *w)
{
    mdr_structure *made = NULL;
    int status;

    switch (take_byte(&w->in) % 3) {
    case 0:
        if (!afford(w, PRICE_OF_STRUCTURE)) return;
        status = make(w, &made);
        judge_object("mdr_structure_...", status, made);
        if (made) {
            MDR_FREE(w->structure);
            w->structure = made;
        }
        break;
    case 1: evaluate(w); break;
    default: weights(w); break;
    }
}
