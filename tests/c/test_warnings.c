/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What speaks against a state: each warning at its limit, the texts, and refusals. */
#include "check.h"

#include <string.h>

enum { depth, force, radius, room = 1000 };

/* Warnings of the state of one depth, force or radius; the text goes to `words`. */
static int warnings_at(mdr_contact *c, int given, double value, char *words)
{
    static const int codes[] = {MDR_DEPTH, MDR_FORCE, MDR_RADIUS};
    mdr_state state;
    int found = -1;

    CHECK_SUCCESS(mdr_contact_states(c, codes[given], MDR_ON_UNLOADING, 1, &value, &state));
    CHECK_SUCCESS(mdr_contact_warnings(c, &state, words, words == NULL ? 0 : room, &found));
    return found;
}

static mdr_contact *contact_of(mdr_profile *p, mdr_medium *m)
{
    mdr_contact *c = NULL;
    CHECK_SUCCESS(mdr_contact_new(p, m, NULL, &c));
    CHECK_FREE(p);
    CHECK_FREE(m);
    return c;
}

static mdr_profile *paraboloid(double R)
{
    mdr_profile *p = NULL;
    CHECK_SUCCESS(mdr_profile_paraboloid(R, &p));
    return p;
}

static mdr_medium *half_space(double E)
{
    mdr_medium *m = NULL;
    CHECK_SUCCESS(mdr_medium_contact_modulus(E, &m));
    return m;
}

/* A film of thickness 1; a base modulus of infinity makes the base rigid. */
static mdr_medium *film(double E, double base)
{
    mdr_medium *m = NULL;
    CHECK_SUCCESS(new_coated(E, 0.3, 1.0, base, 0.3, MDR_MODEL_EXACT, NULL, &m));
    return m;
}

static void slopes_and_pressures(void)
{
    char words[room];
    mdr_profile *punch = NULL;
    mdr_contact *c = contact_of(paraboloid(2.0), half_space(1.0));

    CHECK_TRUE(warnings_at(c, radius, 2.3, words) == 0);
    CHECK_TRUE(words[0] == '\0');
    CHECK_TRUE(warnings_at(c, radius, 2.5, words) == MDR_WARNING_SLOPE);
    CHECK_TRUE(strstr(words, "slope of 1.25") != NULL && words[strlen(words) - 1] == '\n');
    CHECK_TRUE(warnings_at(c, depth, 0.0, NULL) == 0); /* no contact yet */
    CHECK_FREE(c);

    CHECK_SUCCESS(mdr_profile_flat_punch(1.0, &punch));
    c = contact_of(punch, half_space(1.0));
    CHECK_TRUE(warnings_at(c, depth, 0.94, NULL) == 0);
    CHECK_TRUE(warnings_at(c, depth, 0.95, words) == MDR_WARNING_PRESSURE);
    CHECK_TRUE(strchr(words, '\n') == words + strlen(words) - 1);
    CHECK_FREE(c);
}

static void layers(void)
{
    mdr_contact *c = contact_of(paraboloid(100.0), film(1.0, INFINITY));

    CHECK_TRUE(warnings_at(c, depth, 0.49, NULL) == 0);
    CHECK_TRUE(warnings_at(c, depth, 0.51, NULL) == MDR_WARNING_COMPRESSION);
    CHECK_FREE(c);

    /* a base as soft as the film, or softer, gives way: the film is carried down, not compressed */
    c = contact_of(paraboloid(1000.0), film(1.0, 1.1));
    CHECK_TRUE(warnings_at(c, depth, 10.0, NULL) == 0);
    CHECK_FREE(c);
    c = contact_of(paraboloid(1000.0), film(100.0, 1.0));
    CHECK_TRUE(warnings_at(c, depth, 10.0, NULL) == 0);
    CHECK_FREE(c);

    /* a base that is far stiffer does not */
    c = contact_of(paraboloid(100.0), film(1.0, 1e4));
    CHECK_TRUE(warnings_at(c, depth, 0.6, NULL) == MDR_WARNING_COMPRESSION);
    CHECK_FREE(c);
}

/* Of two bodies each is looked at with its own part of the depth. */
static void pairs(void)
{
    mdr_medium *pair = NULL, *lower = film(1.0, INFINITY), *upper = NULL;
    mdr_contact *c;

    CHECK_SUCCESS(new_homogeneous(1e-3, 0.3, &upper));
    CHECK_SUCCESS(mdr_medium_pair(lower, upper, &pair));
    CHECK_FREE(lower);
    CHECK_FREE(upper);
    c = contact_of(paraboloid(100.0), pair);
    CHECK_TRUE(warnings_at(c, depth, 2.0, NULL) == 0); /* taken by the soft ball */
    CHECK_FREE(c);
}

static void moduli(void)
{
    char words[room];
    mdr_contact *c = contact_of(paraboloid(1.0), film(72.0, 163e9));

    CHECK_TRUE(warnings_at(c, depth, 1e-3, words) == MDR_WARNING_CONTRAST);
    CHECK_TRUE(strstr(words, "72 to 1.63e+11") != NULL);
    CHECK_TRUE(warnings_at(c, depth, 0.6, words) == (MDR_WARNING_COMPRESSION | MDR_WARNING_CONTRAST));
    CHECK_TRUE(strchr(words, '\n') < words + strlen(words) - 1); /* two lines */
    CHECK_FREE(c);
    c = contact_of(paraboloid(1.0), film(1e3, 70e9)); /* a gel on glass */
    CHECK_TRUE(warnings_at(c, depth, 1e-3, NULL) == 0);
    CHECK_FREE(c);
}

static void refusals(void)
{
    char words[4] = "xyz";
    int found = -7;
    mdr_state state;
    mdr_contact *c = contact_of(paraboloid(1.0), half_space(1.0));

    CHECK_SUCCESS(mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &(double){3.0}, &state));
    CHECK_STATUS(mdr_contact_warnings(NULL, &state, NULL, 0, &found), MDR_ENULL, "c is NULL");
    CHECK_STATUS(mdr_contact_warnings(c, NULL, NULL, 0, &found), MDR_ENULL, "state is NULL");
    CHECK_STATUS(mdr_contact_warnings(c, &state, NULL, 1, &found), MDR_ENULL, "buffer is NULL");
    state.radius = NAN;
    CHECK_STATUS(mdr_contact_warnings(c, &state, words, 4, &found), MDR_EINVALID, "there is no contact");
    CHECK_TRUE(found == -7 && words[0] == 'x');
    state.radius = 3.0;
    CHECK_SUCCESS(mdr_contact_warnings(c, &state, words, 4, NULL));
    CHECK_TRUE(strcmp(words, "the") == 0);
    CHECK_SUCCESS(mdr_contact_warnings(c, &state, NULL, 0, NULL));
    CHECK_FREE(c);
}

int main(void)
{
    slopes_and_pressures();
    layers();
    pairs();
    moduli();
    refusals();
    return check_report("warnings");
}
