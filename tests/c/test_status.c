/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Version, words of codes, the last error's text, and options. */
#include "check.h"

static void version_agrees_with_the_header(void)
{
    CHECK_INT(mdr_version(), 10000 * MDR_VERSION_MAJOR + 100 * MDR_VERSION_MINOR + MDR_VERSION_PATCH);
}

static void codes_have_words(void)
{
    int code = -1;

    CHECK_TEXT(mdr_name_of(MDR_SUCCESS), "success");
    CHECK_TEXT(mdr_name_of(MDR_EINVALID), "invalid");
    CHECK_TEXT(mdr_name_of(MDR_ENOCONVERGENCE), "no-convergence");
    CHECK_TEXT(mdr_name_of(MDR_TANGENTIAL_FORCE), "tangential_force");
    CHECK_TEXT(mdr_name_of(MDR_MODEL_GAO_SERIES), "gao-series");
    CHECK_TEXT(mdr_name_of(MDR_ON_LOADING), "loading");
    CHECK_TEXT(mdr_name_of(-1), "unknown");
    CHECK_TEXT(mdr_name_of(99), "unknown");
    CHECK_SUCCESS(mdr_code_of(MDR_SUCCESS, "cancelled", &code));
    CHECK_INT(code, MDR_ECANCELLED);
    for (int known = 0; known < 3000; known++) {
        if (strcmp(mdr_name_of(known), "unknown") == 0) {
            CHECK_STATUS(mdr_code_of(known, "depth", &code), MDR_EINVALID, "enumeration = ");
            continue;
        }
        CHECK_SUCCESS(mdr_code_of(known, mdr_name_of(known), &code));
        CHECK_INT(code, known);
    }
}

/* A wrong word is answered with the nearest one and all of the enumeration, and with no other. */
static void wrong_words_are_answered(void)
{
    int code = 77;

    CHECK_STATUS(mdr_code_of(MDR_MODEL_EXACT, "gauss", &code), MDR_EINVALID, "name = gauss: did you mean gao?");
    CHECK_STATUS(mdr_code_of(MDR_MODEL_EXACT, "exakt", &code),
                 MDR_EINVALID, "did you mean exact? It must be one of gao, gao-series");
    CHECK_STATUS(mdr_code_of(MDR_ON_LOADING, "depth", &code), MDR_EINVALID, "one of loading, unloading");
    CHECK_STATUS(mdr_code_of(MDR_MODEL_EXACT, "exact ", &code), MDR_EINVALID, "did you mean exact?");
    CHECK_STATUS(mdr_code_of(MDR_ON_LOADING, "", &code), MDR_EINVALID, "did you mean loading?");
    CHECK_STATUS(mdr_code_of(MDR_DEPTH, "a word that is much longer than any word of the library, and of its messages", &code),
                 MDR_EINVALID, "name = a word that is much longer than any word");
    CHECK_STATUS(mdr_code_of(MDR_DEPTH, NULL, &code), MDR_ENULL, "name is NULL");
    CHECK_STATUS(mdr_code_of(MDR_DEPTH, "depth", NULL), MDR_ENULL, "code is NULL");
    CHECK_INT(code, 77);
}

static void text_is_empty_before_the_first_failure(void)
{
    CHECK_TEXT(mdr_last_error(), "");
}

static void text_stays_until_the_next_failure(void)
{
    const char *full = "radius = -1: it must be finite and greater than 0", *text;
    mdr_profile *p = NULL;

    CHECK_INT(mdr_profile_paraboloid(-1.0, &p), MDR_EINVALID);
    CHECK_TRUE(p == NULL);
    text = mdr_last_error();
    CHECK_TEXT(text, full);
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_FREE(p);
    CHECK_TEXT(text, full);
    CHECK_TEXT(mdr_last_error(), full);
    CHECK_STATUS(mdr_profile_paraboloid(0.0, &p), MDR_EINVALID, "radius = 0");
}

static void long_text_is_cut(void)
{
    enum { LENGTH = 3000, LONGEST = 1023 };
    char path[LENGTH + 1];
    mdr_law *law = NULL;

    memset(path, 'x', LENGTH);
    path[LENGTH] = '\0';
    CHECK_STATUS(mdr_law_load(path, &law), MDR_EFILE, "xxxx");
    CHECK_INT((int)strlen(mdr_last_error()), LONGEST);
}

/* A program that was compiled with fewer members gives a smaller size: the others keep their defaults. */
static void options_begin_with_their_size(void)
{
    const size_t nonsense[] = {0, 1, 7, sizeof(mdr_contact_options) - 1, 4104, (size_t)-1};
    mdr_contact_options options;
    mdr_medium_options of_medium;
    mdr_profile *p = NULL;
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &p));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &m));
    options = MDR_SIZED(mdr_contact_options);
    CHECK_TRUE(options.size == sizeof options);
    options.adhesion_rule = 77;
    CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "adhesion_rule = 77");
    options.size = offsetof(mdr_contact_options, adhesion_rule);
    CHECK_SUCCESS(mdr_contact_new(p, m, &options, &c));
    CHECK_FREE(c);
    for (size_t i = 0; i < sizeof nonsense / sizeof *nonsense; i++) {
        options.size = nonsense[i];
        CHECK_STATUS(mdr_contact_new(p, m, &options, &c), MDR_EINVALID, "options");
    }
    CHECK_FREE(m);
    CHECK_FREE(p);

    of_medium = MDR_SIZED(mdr_medium_options);
    CHECK_TRUE(of_medium.size == sizeof of_medium);
    of_medium.weight_nu_choice = 77;
    CHECK_STATUS(new_coated(1.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO, &of_medium, &m), MDR_EINVALID, "77");
    of_medium.size = offsetof(mdr_medium_options, weight_nu_choice);
    CHECK_SUCCESS(new_coated(1.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO, &of_medium, &m));
    CHECK_FREE(m);
    of_medium.size = 0;
    CHECK_STATUS(new_coated(1.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO, &of_medium, &m), MDR_EINVALID, "size = 0");
}

/* What is no handle at all, zeros or a caller's own numbers, is refused by its first bytes: nothing behind them is followed. */
static void what_is_no_handle_is_refused(void)
{
    static double anything[128];
    const double r = 1.0;
    double out = 0.0;

    CHECK_STATUS(mdr_profile_values((const mdr_profile *)anything, MDR_HEIGHT, 1, &r, &out), MDR_EINVALID,
                 "it is not a handle of type mdr_profile");
    for (int i = 0; i < 128; i++) anything[i] = 1.0;
    CHECK_STATUS(mdr_profile_values((const mdr_profile *)anything, MDR_HEIGHT, 1, &r, &out), MDR_EINVALID,
                 "it is not a handle of type mdr_profile");
}

int main(void)
{
    text_is_empty_before_the_first_failure();
    version_agrees_with_the_header();
    codes_have_words();
    wrong_words_are_answered();
    text_stays_until_the_next_failure();
    long_text_is_cut();
    options_begin_with_their_size();
    what_is_no_handle_is_refused();
    return check_report("status");
}
