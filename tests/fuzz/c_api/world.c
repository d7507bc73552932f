/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "world.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double untouched = -1.2345678e77;
enum { MOST_COST = 100 };

int afford(world *w, int price)
{
    if (w->cost + price > MOST_COST) return 0;
    w->cost += price;
    return 1;
}

/* One of `slots`, or now and then NULL or the given handle of another kind. */
static const void *pick(world *w, void *const slots[], int *slot, const void *stranger)
{
    const int b = take_byte(&w->in);
    *slot = b % SLOTS;
    if (b == 255) return NULL;
    if (b == 254) return stranger;
    for (int i = 0; i < SLOTS && slots[*slot] == NULL; i++) *slot = (*slot + 1) % SLOTS;
    return slots[*slot];
}

const mdr_profile *some_profile(world *w)
{
    int slot;
    return pick(w, (void *const *)w->profiles, &slot, w->media[0]);
}

const mdr_medium *some_medium(world *w)
{
    int slot;
    return pick(w, (void *const *)w->media, &slot, w->profiles[0]);
}

const mdr_contact *some_contact(world *w, int *slot)
{
    return pick(w, (void *const *)w->contacts, slot, w->law);
}

const mdr_law *some_law(world *w)
{
    return take_byte(&w->in) == 254 ? (const mdr_law *)w->contacts[0] : w->law;
}

const mdr_structure *some_structure(world *w)
{
    return take_byte(&w->in) == 254 ? (const mdr_structure *)w->law : w->structure;
}

const mdr_material *some_material(world *w)
{
    int slot;
    return pick(w, (void *const *)w->materials, &slot, w->media[0]);
}

const mdr_law *some_friction_law(world *w)
{
    return take_byte(&w->in) == 254 ? w->law : w->friction_law;
}

mdr_state some_state(world *w, const mdr_contact *contact)
{
    const double at = take_positive(&w->in);
    mdr_state state = {at, at, at, at, 0.0, 0.0};
    if (mdr_contact_states(contact, MDR_RADIUS, MDR_ON_UNLOADING, 1, &at, &state) != MDR_SUCCESS && take_chance(&w->in)) {
        state.radius = take_number(&w->in);
        state.punch_depth = take_number(&w->in);
    }
    return state;
}

void finding(const char *call, const char *what, double value)
{
    fprintf(stderr, "FINDING: %s: %s (%.17g)\n", call, what, value);
    abort();
}

void judge_status(const char *call, int status)
{
    mdr_failure failure = MDR_SIZED(mdr_failure);
    if (status == MDR_SUCCESS) return;
    if (strcmp(mdr_name_of(status), "unknown") == 0) finding(call, "a status that has no name", status);
    if (mdr_last_error()[0] == '\0') finding(call, "a failure without words", status);
    mdr_last_failure(&failure);
    if (failure.status != status || failure.text[0] == '\0') finding(call, "a failure without parts", failure.status);
}

void fill(double values[MOST_POINTS])
{
    for (int i = 0; i < MOST_POINTS; i++) values[i] = untouched;
}

void judge(const char *call, int status, int n, const double values[], enum judgement demand)
{
    judge_status(call, status);
    if (status != MDR_SUCCESS) n = 0;
    for (int i = 0; i < n; i++) {
        const double v = values[i];
        if (v == untouched) finding(call, "an output that was not written", i);
        if (isnan(v)) finding(call, "success with NaN", i);
        if (demand != NOT_NAN && demand != UP_TO_INFINITY && isinf(v)) finding(call, "success with infinity", v);
        if (demand == POSITIVE && !(v > 0.0)) finding(call, "success with a number that is not positive", v);
        if (demand >= NOT_NEGATIVE && v < 0.0) finding(call, "success with a negative number", v);
    }
    for (int i = n < 0 ? 0 : n; i < MOST_POINTS; i++) {
        if (values[i] != untouched) finding(call, "wrote where it must not", i);
    }
}

void judge_object(const char *call, int status, const void *object)
{
    judge_status(call, status);
    if ((status == MDR_SUCCESS) != (object != NULL)) finding(call, "status and handle disagree", status);
}

user_function take_function(input *in)
{
    user_function f = {take_byte(in) % 12, {0.0, 0.0, 0.0}, 0};
    for (int i = 0; i < 3; i++) f.p[i] = take_positive(in);
    return f;
}

int call_function(double x, double *y, void *context)
{
    user_function *f = context;
    f->calls++;
    if (isnan(x)) finding("a user function", "called with NaN", x);
    switch (f->kind) {
    case 0: *y = f->p[0]; break;
    case 1: *y = f->p[0] * x; break;
    case 2: *y = f->p[0] * x * x + f->p[1] * x; break;
    case 3: *y = f->p[0] + f->p[1] * x; break;
    case 4: *y = f->p[0] * exp(-f->p[1] * x) + f->p[2]; break;
    case 5: *y = f->p[0] * pow(x, f->p[1]); break;
    case 6: *y = x < f->p[1] ? f->p[0] : f->p[2]; break;
    case 7: *y = f->p[0] + f->p[1] * sin(f->p[2] * x); break;
    case 8: *y = x > f->p[1] ? NAN : f->p[0] * x; break;
    case 9: *y = f->p[0] / x; break;
    case 10: *y = f->p[0]; return f->calls > 10;
    default: break; /* y stays what it was */
    }
    return 0;
}

int call_field(double x, double y, double z, double *E, double *nu, void *context)
{
    const int status = call_function(sqrt(x * x + y * y + z * z), E, context);
    *nu = 0.3;
    return status;
}
