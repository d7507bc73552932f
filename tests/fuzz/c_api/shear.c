/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stiffness along the surface, compiled laws with friction, and torsion. */
#include "world.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { PRICE_OF_LAW = 40, PRICE_OF_EXACT_LAW = 90, PRICE_OF_MODULUS = 2, PRICE_OF_EXACT_MODULUS = 20 };

static void moduli(world *w)
{
    const int n = take_count(&w->in), slot = take_byte(&w->in) % SLOTS;
    const double nu = take_ratio(&w->in);
    double a[MOST_POINTS], out[MOST_POINTS];

    take_positives(&w->in, a);
    fill(out);
    judge("mdr_weight", mdr_weight(MDR_WEIGHT_I0_TANGENTIAL, nu, n, a, out), n, out, FINITE);
    fill(out);
    judge("mdr_weight", mdr_weight(MDR_WEIGHT_J0_TANGENTIAL, nu, n, a, out), n, out, FINITE);
    if (!afford(w, w->medium_is_exact[slot] ? PRICE_OF_EXACT_MODULUS : PRICE_OF_MODULUS)) return;
    fill(out);
    judge("mdr_medium_values", mdr_medium_values(w->media[slot], MDR_TANGENTIAL_MODULUS, n, a, out), n, out, POSITIVE);
    fill(out);
    judge("mdr_medium_values", mdr_medium_values(w->media[slot], MDR_TORSIONAL_STIFFNESS, n, a, out), n, out, POSITIVE);
}

/* Sliders of a law, and numbers of a record, at most. */
enum { MOST_SLIDERS = 16, MOST_MEMORY = 11 + 4 * MOST_SLIDERS };

/* What it is; and what was written is read again. */
static void write_and_read(const mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr_law *again = NULL;
    int length = 0, second = 0, status;

    judge_status("mdr_law_about", status = mdr_law_about(law, &facts));
    if (!(facts.first_shear_error >= 0.0 && facts.path_error >= -1.0)) finding("mdr_law_about", "no error", 0);
    if (status == MDR_SUCCESS && !facts.description) finding("mdr_law_about", "no description", 0);
    if (mdr_law_write(law, NULL, 0, &length) != MDR_SUCCESS) return;
    char *text = malloc((size_t)length);
    judge_status("mdr_law_write", mdr_law_write(law, text, length, &length));
    status = mdr_law_read(text, length, &again);
    judge_object("mdr_law_read", status, again);
    if (!again) finding("mdr_law_read", "refuses what mdr_law_write wrote", length);
    mdr_law_write(again, NULL, 0, &second);
    if (second != length) finding("mdr_law_write", "another length after reading", second);
    MDR_FREE(again);
    free(text);
}

static void compile(world *w)
{
    const double coefficient = take_chance(&w->in) ? take_positive(&w->in) : 0.3, largest = take_positive(&w->in);
    mdr_law_options options;
    mdr_friction *friction = NULL;
    mdr_law *made = NULL;
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);

    options = MDR_SIZED(mdr_law_options);
    options.tolerance = take_chance(&w->in) ? take_number(&w->in) : 1e-3;
    options.continue_beyond = take_byte(&w->in) % 2;
    if (!afford(w, w->contact_is_exact[slot] ? PRICE_OF_EXACT_LAW : PRICE_OF_LAW)) return;
    status = mdr_friction_new(contact, coefficient, &friction);
    judge_object("mdr_friction_new", status, friction);
    options.friction = friction;
    options.sliders = take_byte(&w->in) % 2 ? MOST_SLIDERS : 0;
    status = mdr_law_new(contact, largest, &options, &made);
    judge_object("mdr_law_new", status, made);
    MDR_FREE(friction);
    if (!made) return;
    MDR_FREE(w->friction_law);
    w->friction_law = made;
    write_and_read(made);
}

/* Partial slip under a twist. */
static void twist(world *w)
{
    enum { MEMBERS = sizeof(mdr_shear_state) / sizeof(double), PRICE = 20 };
    const double coefficient = take_chance(&w->in) ? take_positive(&w->in) : 0.3;
    const int given = TAKE_ONE_OF(&w->in, MDR_TWIST, MDR_TORQUE), n = take_count(&w->in);
    double in[MOST_POINTS], r[MOST_POINTS], out[MOST_POINTS], other[MOST_POINTS], lost[MOST_POINTS], numbers[MEMBERS];
    mdr_shear_state found[MOST_POINTS];
    mdr_friction *f = NULL;
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);

    take_numbers(&w->in, in);
    take_positives(&w->in, r);
    if (!afford(w, PRICE)) return;
    status = mdr_friction_new(contact, coefficient, &f);
    judge_object("mdr_friction_new", status, f);
    if (!f) return;
    const mdr_state state = some_state(w, contact);
    status = shear_states(contact, f, &state, MDR_AROUND, given, n, in, found);
    judge_status("mdr_shear_states", status);
    for (int i = 0; i < n && status == MDR_SUCCESS; i++) {
        memcpy(numbers, &found[i], sizeof numbers);
        for (int k = 0; k < MEMBERS; k++) if (!isfinite(numbers[k])) finding("mdr_shear_states", "no number", k);
    }
    if (status == MDR_SUCCESS && n > 0) {
        fill(out);
        status = shear_field(contact, f, &state, MDR_AROUND, found,
                             TAKE_ONE_OF(&w->in, MDR_TRACTION, MDR_TANGENTIAL_LINE_LOAD), n, r, out);
        judge("mdr_shear_field", status, n, out, NOT_NAN);
    }
    fill(out);
    status = shear_sliding(contact, f, &state, MDR_AROUND, NULL, out);
    judge("mdr_shear_about", status, 1, out, NOT_NEGATIVE);
    fill(out), fill(other), fill(lost);
    status = shear_loop(contact, f, &state, MDR_AROUND, given, r[0], n, out, other, lost);
    judge("mdr_shear_loop", status, n, out, FINITE);
    judge("mdr_shear_loop", status, n, other, FINITE);
    judge("mdr_shear_loop", status, 1, lost, NOT_NEGATIVE);
    judge_status("mdr_free", mdr_free(f));
}

/* The steps of a few contacts, whose planes turn in between. */
static void advance(world *w)
{
    enum { STEPS = 4 };
    double force[MOST_POINTS], shift[3 * MOST_POINTS], normal[3 * MOST_POINTS], tangent[12 * MOST_POINTS];
    double T[3 * MOST_POINTS], stored[MOST_POINTS], dissipated[MOST_POINTS], memory[MOST_POINTS * MOST_MEMORY];
    const int n = take_count(&w->in);
    const mdr_law *law = some_friction_law(w);
    int status;

    memset(memory, 0, sizeof memory);
    if (take_chance(&w->in)) memory[take_byte(&w->in) % MOST_MEMORY] = take_number(&w->in);
    for (int step = 0; step < STEPS; step++) {
        take_numbers(&w->in, force);
        for (int i = 0; i < 3; i++) take_numbers(&w->in, &shift[i * MOST_POINTS]);
        for (int i = 0; i < 3 * MOST_POINTS; i++) normal[i] = i % 3 == 2;
        if (take_chance(&w->in)) normal[0] = 0.6, normal[2] = take_chance(&w->in) ? take_number(&w->in) : 0.8;
        status = mdr_law_turn(law, n, normal, take_chance(&w->in) ? force : NULL, memory);
        judge_status("mdr_law_turn", status);
        status = mdr_law_advance(law, n, force, shift, 1, tangent, memory, T);
        judge_status("mdr_law_advance", status);
        for (int i = 0; i < 12 * n && status == MDR_SUCCESS; i++) {
            if (!isfinite(tangent[i])) finding("mdr_law_advance", "no number", i);
        }
        status = mdr_law_advance(law, n, force, shift, 0, NULL, memory, T);
        judge_status("mdr_law_advance", status);
        for (int i = 0; i < 3 * n && status == MDR_SUCCESS; i++) {
            if (!isfinite(T[i])) finding("mdr_law_advance", "no number", i);
        }
        status = mdr_law_energies(law, n, memory, stored, dissipated);
        judge_status("mdr_law_energies", status);
    }
}

void fuzz_shear(world *w)
{
    switch (take_byte(&w->in) % 4) {
    case 0: moduli(w); break;
    case 1: compile(w); break;
    case 3: twist(w); break;
    default: advance(w); break;
    }
}
