/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stddef.h>

enum { PRICE_OF_INSIDE = 8, PRICE_OF_EXACT_INSIDE = 20, PRICE_OF_FAILURE = 30, PRICE_OF_EXACT_FAILURE = 60 };

/* The largest stresses, and the loads at which some strengths are reached. */
static void fuzz_failure(world *w, const mdr_contact *contact, int body, const mdr_state *state, double friction)
{
    enum { MOST_MAXIMA = 5 * MOST_POINTS + 4 };
    mdr_maximum maxima[MOST_MAXIMA];
    mdr_strength strengths[2];
    mdr_failure_load failures[2];
    const double largest = take_chance(&w->in) ? take_positive(&w->in) : 0.0;
    int status, count = 0;

    for (int i = 0; i < 2; i++) {
        const double value = take_chance(&w->in) ? take_number(&w->in) : 0.1;
        strengths[i] = (mdr_strength){take_member(&w->in, MDR_VON_MISES, 6), take_code(&w->in, 2) - 1, value};
    }
    status = state_critical(contact, body, state, friction, MOST_MAXIMA, maxima, &count);
    judge_status("mdr_load_critical", status);
    for (int i = 0; i < count && i < MOST_MAXIMA && status == MDR_SUCCESS; i++) {
        if (!isfinite(maxima[i].value)) finding("mdr_load_critical", "no number", i);
        if (!(maxima[i].r >= 0.0 && maxima[i].z >= 0.0)) finding("mdr_load_critical", "no place", i);
    }
    status = mdr_contact_first_failure(contact, body, friction, largest, 2, strengths, 2, failures, &count);
    judge_status("mdr_contact_first_failure", status);
    for (int i = 0; i < count && status == MDR_SUCCESS; i++) {
        if (!isfinite(failures[i].force + failures[i].value)) finding("mdr_contact_first_failure", "no number", i);
        if (failures[i].value < 0.999 * failures[i].strength) finding("mdr_contact_first_failure", "not reached", i);
    }
}

/* Stresses and displacements, energies, and the lowest pressure. */
void fuzz_inside(world *w)
{
    const int body = TAKE_ONE_OF(&w->in, MDR_BODY_LOWER, MDR_BODY_UPPER), side = TAKE_ONE_OF(&w->in, MDR_SIDE_BELOW,
            MDR_SIDE_ABOVE), n = take_count(&w->in);
    const double friction = take_chance(&w->in) ? take_number(&w->in) : 0.0;
    double r[MOST_POINTS], z[MOST_POINTS], angle[MOST_POINTS], out[MOST_POINTS];
    double pressure[MOST_POINTS], place[MOST_POINTS];
    mdr_interior inside[MOST_POINTS];
    char words[100];
    int slot, status, count = 0;
    const mdr_contact *contact = some_contact(w, &slot);
    mdr_state state;

    take_positives(&w->in, r);
    take_positives(&w->in, z);
    take_numbers(&w->in, angle);
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_INSIDE : PRICE_OF_INSIDE)) return;
    state = some_state(w, contact);
    if (take_chance(&w->in)) {
        for (int i = 0; i < MOST_POINTS; i++) r[i] = state.radius * fmod(r[i], 3.0), z[i] = state.radius * fmod(z[i], 3.0);
    }
    status = state_interior(contact, body, &state, side, friction, n, r, z, take_chance(&w->in) ? angle : NULL, inside);
    judge_status("mdr_load_interior", status);
    for (int i = 0; i < n && status == MDR_SUCCESS; i++) {
        if (isnan(inside[i].u_z + inside[i].u_r)) finding("mdr_load_interior", "success with NaN", i);
        if (isnan(inside[i].s_zz) || isnan(inside[i].s_rz)) finding("mdr_load_interior", "success with NaN", i);
    }
    fill(out);
    status = state_interior_error(contact, body, &state, out);
    judge("mdr_load_interior", status, 1, out, NOT_NEGATIVE);
    fill(out);
    status = state_layer_energies(contact, body, &state, MOST_POINTS, out, &count);
    judge("mdr_load_layer_energies", status, count < MOST_POINTS ? count : MOST_POINTS, out, FINITE);
    fill(pressure), fill(place);
    status = state_energy(contact, &state, pressure, place);
    judge("mdr_load_energy", status, 1, pressure, FINITE);
    judge("mdr_load_energy", status, 1, place, FINITE);
    fill(pressure), fill(place);
    status = state_lowest_pressure(contact, &state, pressure, place);
    judge("mdr_load_lowest_pressure", status, 1, pressure, FINITE);
    judge("mdr_load_lowest_pressure", status, 1, place, NOT_NEGATIVE);
    judge_status("mdr_contact_warnings", mdr_contact_warnings(contact, &state, words, (int)sizeof words, &count));
    if (afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_FAILURE : PRICE_OF_FAILURE)) {
        fuzz_failure(w, contact, body, &state, friction);
    }
}

/* Partial slip: states, a loop, a path. */
void fuzz_friction(world *w)
{
    enum { MEMBERS = 6 };
    const double coefficient = take_chance(&w->in) ? take_positive(&w->in) : 0.3;
    const int given = TAKE_ONE_OF(&w->in, MDR_SHIFT, MDR_TANGENTIAL_FORCE), normal = TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE),
            n = take_count(&w->in);
    double in[MOST_POINTS], path[MOST_POINTS], out[MOST_POINTS], other[MOST_POINTS], lost[MOST_POINTS];
    mdr_shear_state found[MOST_POINTS];
    mdr_state states[MOST_POINTS], state;
    mdr_friction *f = NULL;
    mdr_friction_history *h = NULL, *copy = NULL;
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);

    take_numbers(&w->in, in);
    take_positives(&w->in, path);
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_INSIDE : PRICE_OF_INSIDE)) return;
    status = mdr_friction_new(contact, coefficient, &f);
    judge_object("mdr_friction_new", status, f);
    if (!f) return;
    state = some_state(w, contact);
    status = shear_states(contact, f, &state, MDR_ALONG, given, n, in, found);
    judge_status("mdr_shear_states", status);
    for (int i = 0; i < n && status == MDR_SUCCESS; i++) {
        const double numbers[MEMBERS] = {found[i].shift, found[i].tangential_force, found[i].stick_radius, found[i].stiffness,
                                         found[i].dissipated_energy, found[i].sliding};
        for (int k = 0; k < MEMBERS; k++) if (!isfinite(numbers[k])) finding("mdr_shear_states", "no number", k);
    }
    if (status == MDR_SUCCESS && n > 0) {
        fill(out);
        status = shear_field(contact, f, &state, MDR_ALONG, found,
                             TAKE_ONE_OF(&w->in, MDR_TRACTION, MDR_TANGENTIAL_LINE_LOAD), n, path,
                out);
        judge("mdr_shear_field", status, n, out, NOT_NAN);
    }
    fill(out), fill(other), fill(lost);
    status = shear_sliding(contact, f, &state, MDR_ALONG, out, other);
    judge("mdr_shear_about", status, 1, out, NOT_NEGATIVE);
    judge("mdr_shear_about", status, 1, other, NOT_NEGATIVE);
    fill(out), fill(other);
    status = shear_loop(contact, f, &state, MDR_ALONG, given, path[0], n, out, other, lost);
    judge("mdr_shear_loop", status, n, out, FINITE);
    judge("mdr_shear_loop", status, n, other, FINITE);
    judge("mdr_shear_loop", status, 1, lost, NOT_NEGATIVE);
    status = mdr_friction_history_new(f, w->contact_is_exact[slot] ? state.depth : 0.0, 12, &h);
    judge_object("mdr_friction_history_new", status, h);
    if (h) judge_status("mdr_friction_history_advance", mdr_friction_history_advance(h, normal, given, n, path, in, states, found));
    status = mdr_friction_history_copy(h, &copy);
    judge_object("mdr_friction_history_copy", status, copy);
    judge_status("mdr_free", mdr_free(h));
    judge_status("mdr_free", mdr_free(copy));
    judge_status("mdr_free", mdr_free(f));
}
