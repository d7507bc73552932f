/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include "mdrcontact_law.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

/* mdr_law_point has doubles only, more than the others */
enum { PRICE_OF_LAW = 40, POINT = sizeof(mdr_law_point) / sizeof(double) };

static void make(world *w)
{
    int slot, status;
    const mdr_contact *contact = some_contact(w, &slot);
    const double largest = take_positive(&w->in);
    mdr_law_options options, *chosen = &options;
    mdr_law *made = NULL;

    options = MDR_SIZED(mdr_law_options);
    options.tolerance = 1e-4;
    if (take_chance(&w->in)) {
        options.smallest_depth = take_number(&w->in);
        options.tolerance = take_number(&w->in);
        options.description = take_chance(&w->in) ? NULL : "words\nin two lines";
    }
    if (w->contact_is_exact[slot] || !afford(w, PRICE_OF_LAW)) return;
    status = mdr_law_new(contact, largest, chosen, &made);
    judge_object("mdr_law_new", status, made);
    if (made) {
        MDR_FREE(w->law);
        w->law = made;
    }
}

static void evaluate(world *w)
{
    const int n = take_count(&w->in), branch = TAKE_ONE_OF(&w->in, MDR_ON_LOADING, MDR_ON_UNLOADING),
            threads = take_chance(&w->in) ? take_choice(&w->in, 3) : 1;
    const mdr_law *law = some_law(w);
    double point[POINT], x[MOST_POINTS], p[MOST_POINTS], q[MOST_POINTS], r[MOST_POINTS], s[MOST_POINTS];
    int status, segment = take_choice(&w->in, 4);
    mdr_law_view view;

    take_numbers(&w->in, x);
    fill(p), fill(q);
    judge_status("mdr_set_threads", mdr_set_threads(threads));
    status = mdr_law_force(law, branch, x[0], p, q);
    judge("mdr_law_force", status, 1, p, FINITE);
    judge("mdr_law_force", status, 1, q, NOT_NAN);
    fill(p), fill(q), fill(r), fill(s);
    fill(point);
    status = mdr_law_follow(law, x[1], &segment, (mdr_law_point *)point);
    judge("mdr_law_follow", status, MOST_POINTS, point, NOT_NAN);
    fill(point);
    status = law_point(law, MDR_DEPTH, branch, x[1], (mdr_law_point *)point);
    judge("mdr_law_values", status, MOST_POINTS, point, NOT_NAN);
    fill(point);
    status = law_point(law, MDR_FORCE, branch, x[2], (mdr_law_point *)point);
    judge("mdr_law_values", status, MOST_POINTS, point, NOT_NAN);
    judge_status("mdr_law_view_of", mdr_law_view_of(law, branch, &view));
    fill(p), fill(q), fill(r), fill(s);
    status = mdr_law_values(law, MDR_DEPTH, branch, n, x, NULL, r, p, s, q, NULL);
    judge("mdr_law_values", status, n, p, FINITE);
    judge("mdr_law_values", status, n, q, NOT_NAN);
    judge("mdr_law_values", status, n, r, NOT_NEGATIVE);
    judge("mdr_law_values", status, n, s, NOT_NEGATIVE);
    fill(p), fill(q), fill(r), fill(s);
    status = mdr_law_values(law, MDR_FORCE, branch, n, x, p, r, NULL, s, q, NULL);
    judge("mdr_law_values", status, n, p, FINITE);
    judge("mdr_law_values", status, n, q, NOT_NAN);
    judge("mdr_law_values", status, n, r, NOT_NEGATIVE);
    judge("mdr_law_values", status, n, s, NOT_NEGATIVE);
}

/* The law of another radius, and the work done on the way. */
static void derive(world *w)
{
    const mdr_law *law = some_law(w);
    const int n = take_count(&w->in), branch = TAKE_ONE_OF(&w->in, MDR_ON_LOADING, MDR_ON_UNLOADING);
    mdr_law *other = NULL;
    double x[MOST_POINTS], U[MOST_POINTS];
    int status;

    take_numbers(&w->in, x);
    fill(U);
    status = mdr_law_values(law, MDR_DEPTH, branch, n, x, NULL, NULL, NULL, NULL, NULL, U);
    judge("mdr_law_values", status, n, U, FINITE);
    fill(U);
    judge("mdr_law_conductance", mdr_law_conductance(law, branch, n, x, U, NULL), n, U, FINITE);
    status = mdr_law_with_radius(law, take_positive(&w->in), &other);
    judge_object("mdr_law_with_radius", status, other);
    fill(U);
    if (other) status = mdr_law_values(other, MDR_DEPTH, branch, n, x, NULL, NULL, NULL, NULL, NULL, U);
    if (other) judge("mdr_law_values", status, n, U, FINITE);
    MDR_FREE(other);
}

/* What was written is read again, byte for byte. */
static void write_and_read(world *w)
{
    const mdr_law *law = some_law(w);
    mdr_law *again = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    int length = 0, second = 0, status;

    judge_status("mdr_law_about", status = mdr_law_about(law, &facts));
    if (status == MDR_SUCCESS && !facts.description) finding("mdr_law_about", "no description", 0);
    take_choice(&w->in, 8);
    if (mdr_law_write(law, NULL, 0, &length) != MDR_SUCCESS) return;
    double *numbers = malloc(sizeof *numbers * (size_t)facts.buffer_size);
    judge_status("mdr_law_buffer", mdr_law_buffer(law, facts.buffer_size, numbers));
    if (mdr_law_buffer(law, facts.buffer_size - 1, numbers) == MDR_SUCCESS) finding("mdr_law_buffer", "takes too small a buffer",
                                                                                    0);
    free(numbers);
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

void fuzz_laws(world *w)
{
    switch (take_byte(&w->in) % 3) {
    case 0: make(w); break;
    case 1: evaluate(w); break;
    default: take_byte(&w->in) % 8 ? write_and_read(w) : derive(w); break;
    }
}
