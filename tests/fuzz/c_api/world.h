/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one run of the fuzzer holds: a few objects of every kind, and the judgement of what a call gave back. */
#ifndef WORLD_H
#define WORLD_H

#include "../../c/calls.h"
#include "input.h"
#include "mdrcontact/all.h"

enum { SLOTS = 3 };

typedef struct world {
    input in;
    int cost;                       /* what has been spent; costly calls are left out when it is used up */
    mdr_profile *profiles[SLOTS];
    mdr_medium *media[SLOTS];
    int medium_is_exact[SLOTS];
    mdr_contact *contacts[SLOTS];
    int contact_is_exact[SLOTS];
    int contact_is_adhesive[SLOTS];
    mdr_loop *loop;
    mdr_law *law;
    mdr_structure *structure;
    mdr_material *materials[SLOTS];
    mdr_law *friction_law;
} world;

/* Whether a call of that price may still be made. */
int afford(world *w, int price);

/* Objects that were made before, NULL now and then, seldom one of another kind. */
const mdr_profile *some_profile(world *w);
const mdr_medium *some_medium(world *w);
const mdr_contact *some_contact(world *w, int *slot);
const mdr_law *some_law(world *w);
const mdr_structure *some_structure(world *w);
const mdr_material *some_material(world *w);
const mdr_law *some_friction_law(world *w);
/* A state of the contact, or seldom none. */
mdr_state some_state(world *w, const mdr_contact *contact);

/* Ends the program with a report: the finding. */
void finding(const char *call, const char *what, double value);

/* A status is one of enum mdr_status, with words if it is a failure. */
void judge_status(const char *call, int status);

/* Outputs are filled before a call; a failure leaves them alone, success leaves no NaN, nor an infinity unless allowed. */
enum judgement { NOT_NAN, FINITE, NOT_NEGATIVE, POSITIVE, UP_TO_INFINITY };
void fill(double values[MOST_POINTS]);
void judge(const char *call, int status, int n, const double values[], enum judgement demand);
/* The same for a new object. */
void judge_object(const char *call, int status, const void *object);

/* User functions of every character, ill-behaved ones among them; the context points to one. */
typedef struct user_function {
    int kind;
    double p[3];
    int calls;
} user_function;
user_function take_function(input *in);
int call_function(double x, double *y, void *context);
int call_field(double x, double y, double z, double *E, double *nu, void *context);

void fuzz_profiles(world *w);
void fuzz_media(world *w);
void fuzz_contacts(world *w);
void fuzz_states(world *w);
void fuzz_fields(world *w);
void fuzz_adhesion(world *w);
void fuzz_laws(world *w);
void fuzz_structures(world *w);
void fuzz_fits(world *w);
void fuzz_formulas(world *w);
void fuzz_inside(world *w);
void fuzz_friction(world *w);
void fuzz_shear(world *w);
void fuzz_time(world *w);
void fuzz_wide_fits(world *w);
void fuzz_lists(world *w);
void fuzz_gels(world *w);
void fuzz_conduction(world *w);
void fuzz_rates(world *w);
void fuzz_wear(world *w);
void fuzz_plastic(world *w);

#endif
