/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Conduction: stacks of any numbers, and what their spots answer. */
#include "world.h"

#include <stddef.h>

enum { PRICE_OF_KERNEL = 2, PRICE_OF_ANSWER = 4, MOST_LAYERS = 3 };

static int take_stack(input *in, mdr_conductor layers[MOST_LAYERS])
{
    const int n = take_choice(in, MOST_LAYERS + 1);
    for (int i = 0; i < MOST_LAYERS; i++) {
        layers[i].thickness = take_positive(in);
        layers[i].sigma = take_positive(in);
        layers[i].along = take_chance(in) ? take_positive(in) : layers[i].sigma;
        layers[i].capacity = take_chance(in) ? 0.0 : take_positive(in);
        layers[i].resistance = take_chance(in) ? take_positive(in) : 0.0;
    }
    return n > MOST_LAYERS ? -1 : n;
}

void fuzz_conduction(world *w)
{
    mdr_conductor lower[MOST_LAYERS], upper[MOST_LAYERS];
    const int n = take_stack(&w->in, lower), m = take_chance(&w->in) ? take_stack(&w->in, upper) : 0;
    const int base = TAKE_ONE_OF(&w->in, MDR_BASE_HALF_SPACE, MDR_BASE_PERFECT, MDR_BASE_INSULATING),
            upper_base = TAKE_ONE_OF(&w->in, MDR_BASE_HALF_SPACE, MDR_BASE_PERFECT, MDR_BASE_INSULATING),
            answer = TAKE_ONE_OF(&w->in, MDR_CONDUCTANCE, MDR_RESISTANCE, MDR_MEAN_POTENTIAL, MDR_CENTRE_POTENTIAL,
            MDR_GAUSSIAN_POTENTIAL), points = take_count(&w->in);
    const double film = take_chance(&w->in) ? take_positive(&w->in) : 0.0, sink = take_chance(&w->in) ? take_positive(&w->in) : 0.0;
    const double a = take_positive(&w->in);
    double x[MOST_POINTS], z[MOST_POINTS], out[MOST_POINTS], more[MOST_POINTS];
    mdr_conduction *p = NULL, *table = NULL;
    int status;

    take_positives(&w->in, x);
    take_positives(&w->in, z);
    if (!afford(w, PRICE_OF_KERNEL)) return;
    status = mdr_conduction_new(n, lower, base, m, m ? upper : NULL, upper_base, film, sink, &p);
    judge_object("mdr_conduction_new", status, p);
    if (p && afford(w, PRICE_OF_ANSWER)) {
        fill(out);
        fill(more);
        status = mdr_conduction_spot(p, points, x, out, more);
        judge("mdr_conduction_spot", status, points, out, NOT_NEGATIVE);
        judge("mdr_conduction_spot", status, points, more, NOT_NEGATIVE);
        fill(out);
        status = mdr_conduction_field(p, TAKE_ONE_OF(&w->in, MDR_FLUX, MDR_POTENTIAL, MDR_FLUX_Z, MDR_FLUX_R), a,
                TAKE_ONE_OF(&w->in, MDR_BODY_LOWER, MDR_BODY_UPPER), take_byte(&w->in) % 2, 0.0, points, x, z,
                                      out);
        judge("mdr_conduction_field", status, points, out, NOT_NAN);
    }
    if (p && afford(w, PRICE_OF_ANSWER)) {
        fill(out);
        fill(more);
        status = mdr_conduction_admittance(p, answer, a, points, x, out, more);
        judge("mdr_conduction_admittance", status, points, out, NOT_NAN);
        judge("mdr_conduction_admittance", status, points, more, NOT_NAN);
        fill(out);
        fill(more);
        status = mdr_conduction_compliance(p, points, x, z, out, more);
        judge("mdr_conduction_compliance", status, points, out, NOT_NAN);
        judge("mdr_conduction_compliance", status, points, more, NOT_NAN);
        fill(out);
        judge("mdr_conduction_follow", mdr_conduction_follow(p, answer, a, points, x, NULL, out), points, out, NOT_NAN);
        fill(out);
        judge("mdr_conduction_follow", mdr_conduction_follow(p, answer, a, points, x, z, out), points, out, NOT_NAN);
    }
    if (p && afford(w, PRICE_OF_ANSWER)) {
        int slot;
        double heat[sizeof(mdr_friction_heat) / sizeof(double)];
        const mdr_contact *contact = some_contact(w, &slot);
        const mdr_state state = some_state(w, contact);
        fill(out);
        judge("mdr_conduction_along", mdr_conduction_along(p, contact, 1, &state, out, out + 1, out + 2), 3, out, NOT_NAN);
        fill(out);
        judge("mdr_conduction_rough", mdr_conduction_rough(p, contact, &state, x[0], out), 1, out, NOT_NEGATIVE);
        fill(out);
        status = mdr_conduction_joint_resistance(p, x[0], x[1], x[2], z[0], z[1], points, z, out);
        judge("mdr_conduction_joint_resistance", status, points, out, POSITIVE);
        fill(out);
        status = mdr_conduction_joint(p, contact, &state, x[0], x[1], x[2], z[0], z[1], out);
        judge("mdr_conduction_joint", status, 1, out, NOT_NEGATIVE);
        fill(out);
        fill(heat);
        status = mdr_conduction_heat(p, contact, 1, &state, TAKE_ONE_OF(&w->in, MDR_HEAT_SLIDING, MDR_HEAT_SPINNING,
                MDR_HEAT_MOVING), x[1], x[2], (mdr_friction_heat *)heat);
        judge("mdr_conduction_heat", status, (int)(sizeof heat / sizeof *heat), heat, NOT_NAN);
        fill(out);
        status = mdr_conduction_heat_field(p, contact, &state, TAKE_ONE_OF(&w->in, MDR_HEAT_SLIDING, MDR_HEAT_SPINNING), x[1],
                MDR_BODY_LOWER, 1, points, x, z, out);
        judge("mdr_conduction_heat_field", status, points, out, NOT_NAN);
        fill(out);
        judge("mdr_conduction_field", mdr_conduction_field(p, MDR_FLUX, a, MDR_BODY_LOWER, 0, x[0], points, z, NULL,
                                                           out), points, out, NOT_NAN);
    }
    if (p && afford(w, 10 * PRICE_OF_ANSWER)) {
        status = mdr_conduction_tabulate(p, x[0], x[1], 1e-6, &table);
        judge_object("mdr_conduction_tabulate", status, table);
        judge_status("mdr_free", mdr_free(table));
    }
    judge_status("mdr_free", mdr_free(p));
}
