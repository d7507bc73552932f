/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Compiled laws: values against the contact, open contact, history, files, refusals. */
#include "check.h"

enum { N = 100000 }; /* enough for several threads */

static mdr_contact *contact_with(double work_of_adhesion)
{
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_contact_options options;

    options = MDR_SIZED(mdr_contact_options);
    options.work_of_adhesion = work_of_adhesion;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(new_coated(3.0, 0.3, 0.5, 1.0, 0.4, MDR_MODEL_GAO, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(ball, film, &options, &contact));
    CHECK_FREE(film);
    CHECK_FREE(ball);
    return contact;
}

static void test_values(void)
{
    static double d[N], F[N], slope[N], a[N], k[N], F1[N], F2[N], back[N];
    mdr_contact *contact = contact_with(0.0);
    mdr_law *law = NULL;

    CHECK_SUCCESS(mdr_law_new(contact, 1.0, NULL, &law));
    for (int i = 0; i < N; i++) d[i] = pow(10.0, -4.0 * i / (N - 1.0));
    CHECK_SUCCESS(mdr_set_threads(2));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, N, d, NULL, a, F, k, slope, NULL));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, N, d, NULL, NULL, F1, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_set_threads(0));
    CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, N, d, NULL, NULL, F2, NULL, NULL, NULL));
    CHECK_SUCCESS(mdr_law_values(law, MDR_FORCE, MDR_ON_UNLOADING, N - 2, F + 1, back, NULL, NULL, NULL, NULL, NULL));
    for (int i = 0; i < N; i += 1371) {
        double exact, radius, stiffness, one, rise;
        CHECK_SUCCESS(columns_of(contact, MDR_DEPTH, 1, &d[i], NULL, &radius, &exact, &stiffness));
        CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, d[i], &one, &rise));
        CHECK_CLOSE(F[i], exact, 1e-9);
        CHECK_CLOSE(a[i], radius, 1e-9);
        CHECK_CLOSE(k[i], stiffness, 1e-9);
        CHECK_CLOSE(slope[i], stiffness, 1e-7);
        CHECK_CLOSE(one, exact, 1e-9);
        CHECK_CLOSE(rise, slope[i], 1e-13);
        CHECK_CLOSE(F1[i], F[i], 1e-13);
        CHECK_CLOSE(F2[i], F[i], 1e-13);
        if (i > 0) CHECK_CLOSE(back[i - 1], d[i], 1e-9);
    }
    /* below the compiled range a power of d, continuous with it; below 0 open */
    double near = 0.9e-4, open = -1e-3, force = 1.0, rise = 1.0, exact;
    CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, near, &force, &rise));
    CHECK_SUCCESS(columns_of(contact, MDR_DEPTH, 1, &near, NULL, NULL, &exact, NULL));
    CHECK_CLOSE(force, exact, 1e-4);
    CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, open, &force, &rise));
    CHECK_TRUE(force == 0.0 && rise == 0.0);
    CHECK_FREE(law);
    CHECK_FREE(contact);
}

static void test_history(void)
{
    mdr_contact *contact = contact_with(0.02);
    mdr_law *law = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    int segment = 0;
    double F = 1.0, pull_off_depth, below;
    mdr_law_point point;

    CHECK_SUCCESS(mdr_law_new(contact, 1.0, NULL, &law));
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    CHECK_INT(facts.adhesive, 1);
    CHECK_TRUE(facts.error <= facts.tolerance);
    CHECK_TRUE(facts.solutions > 10 && facts.solutions <= 200);
    CHECK_SUCCESS(pull_off_of(contact, MDR_DEPTH, 1, &pull_off_depth, NULL, NULL, NULL));
    CHECK_CLOSE(facts.lowest_depth, pull_off_depth, 1e-9);
    below = 1.001 * pull_off_depth;
    CHECK_SUCCESS(mdr_law_follow(law, -1e-9, &segment, &point));
    CHECK_TRUE(segment == 0 && point.force == 0.0);
    CHECK_SUCCESS(mdr_law_follow(law, 0.1, &segment, &point));
    CHECK_TRUE(segment >= 1 && point.force > 0.0);
    CHECK_SUCCESS(mdr_law_follow(law, 0.9 * pull_off_depth, &segment, &point));
    CHECK_TRUE(segment >= 1 && point.force < 0.0);
    CHECK_SUCCESS(mdr_law_follow(law, below, &segment, &point));
    CHECK_TRUE(segment == 0 && point.force == 0.0);
    CHECK_SUCCESS(mdr_law_force(law, MDR_ON_LOADING, -1e-9, &F, NULL));
    CHECK_TRUE(F == 0.0);
    CHECK_STATUS(mdr_law_values(law, MDR_FORCE, MDR_ON_UNLOADING, 1, &(double){2.0 * facts.lowest_force}, &F, NULL, NULL,
                                NULL, NULL, NULL),
                 MDR_EUNREACHABLE, "entry 1 of force = ");
    CHECK_FREE(law);
    CHECK_FREE(contact);
}

static void test_files(void)
{
    mdr_contact *contact = contact_with(0.0);
    mdr_law *law = NULL, *again = NULL, *copy = NULL;
    mdr_law_options options;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    int length = 0;
    double one, other;
    const char *path = "test_law.mdrlaw";
    FILE *file;

    options = MDR_SIZED(mdr_law_options);
    options.tolerance = 1e-6;
    options.description = "a ball on a film";
    CHECK_SUCCESS(mdr_law_new(contact, 1.0, &options, &law));
    CHECK_SUCCESS(mdr_law_save(law, path));
    CHECK_SUCCESS(mdr_law_load(path, &again));
    CHECK_SUCCESS(mdr_law_about(again, &facts));
    CHECK_TEXT(facts.description, options.description);
    CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, 0.3, &one, NULL));
    CHECK_SUCCESS(mdr_law_force(again, MDR_ON_UNLOADING, 0.3, &other, NULL));
    CHECK_CLOSE(other, one, 0.0);

    CHECK_SUCCESS(mdr_law_with_radius(again, 2.0, &copy));
    CHECK_FREE(copy);
    CHECK_STATUS(mdr_law_with_radius(again, -2.0, &copy), MDR_EINVALID, "radius");
    CHECK_STATUS(mdr_law_with_radius(NULL, 2.0, &copy), MDR_ENULL, "law");
    CHECK_TRUE(copy == NULL);

    CHECK_SUCCESS(mdr_law_write(law, NULL, 0, &length));
    CHECK_TRUE(length > 1000);
    char *content = malloc((size_t)length);
    CHECK_SUCCESS(mdr_law_write(law, content, length, &length));
    CHECK_SUCCESS(mdr_law_read(content, length, &copy));
    CHECK_SUCCESS(mdr_law_force(copy, MDR_ON_UNLOADING, 0.3, &other, NULL));
    CHECK_CLOSE(other, one, 0.0);
    CHECK_FREE(copy);
    content[length / 2] ^= 4;
    CHECK_STATUS(mdr_law_read(content, length, &copy), MDR_EFILE, "damaged");
    CHECK_STATUS(mdr_law_read(content, length / 2, &copy), MDR_EFILE, "truncated");
    CHECK_STATUS(mdr_law_read("hello", 5, &copy), MDR_EFILE, "not a compiled contact law");
    CHECK_TRUE(copy == NULL);
    file = fopen(path, "ab");
    CHECK_TRUE(file != NULL);
    if (file) {
        fputs("more", file);
        fclose(file);
    }
    CHECK_STATUS(mdr_law_load(path, &copy), MDR_EFILE, path);
    remove(path);
    CHECK_STATUS(mdr_law_load(path, &copy), MDR_EFILE, "cannot be read");
    CHECK_STATUS(mdr_law_save(law, "no/such/folder/law"), MDR_EFILE, "cannot be written");
    free(content);
    CHECK_FREE(again);
    CHECK_FREE(law);
    CHECK_FREE(contact);
}

static void test_refusals(void)
{
    mdr_contact *contact = contact_with(0.0);
    mdr_law *law = NULL;
    double in[3] = {0.1, NAN, 0.2}, out[3];
    int segment = 7;
    mdr_law_point point;

    fill_untouched(3, out);
    CHECK_STATUS(mdr_law_new(NULL, 1.0, NULL, &law), MDR_ENULL, "contact");
    CHECK_STATUS(mdr_law_new(contact, NAN, NULL, &law), MDR_EINVALID, "largest_depth");
    CHECK_STATUS(mdr_law_new(contact, 1.0, NULL, NULL), MDR_ENULL, "out");
    CHECK_SUCCESS(mdr_law_new(contact, 1.0, NULL, &law));
    CHECK_STATUS(mdr_law_force(law, 0, 0.1, out, NULL), MDR_EINVALID, "branch");
    CHECK_STATUS(mdr_law_force(law, MDR_ON_UNLOADING, NAN, out, NULL), MDR_EINVALID, "depth = NaN");
    CHECK_STATUS(mdr_law_force(law, MDR_ON_UNLOADING, INFINITY, out, NULL), MDR_EINVALID, "depth = infinity");
    CHECK_STATUS(mdr_law_force(law, MDR_ON_UNLOADING, 1.5, out, NULL), MDR_EDOMAIN, "compiled up to");
    CHECK_STATUS(mdr_law_force(NULL, MDR_ON_UNLOADING, 0.1, out, NULL), MDR_ENULL, "law");
    CHECK_STATUS(mdr_law_force((const mdr_law *)contact, MDR_ON_UNLOADING, 0.1, out, NULL), MDR_EINVALID, "handle of type mdr_law");
    CHECK_STATUS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 3, in, NULL, NULL, out, NULL, NULL, NULL), MDR_EINVALID,
                 "entry 2 of depth = ");
    CHECK_STATUS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, -1, in, NULL, NULL, out, NULL, NULL, NULL), MDR_EINVALID,
                 "n = -1");
    CHECK_STATUS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 3, NULL, NULL, NULL, out, NULL, NULL, NULL), MDR_ENULL,
                 "d is NULL");
    CHECK_STATUS(mdr_law_follow(law, 0.1, &segment, &point), MDR_EINVALID, "segment");
    CHECK_STATUS(mdr_law_follow(law, 0.1, NULL, &point), MDR_ENULL, "segment");
    CHECK_STATUS(mdr_law_load(NULL, &law), MDR_ENULL, "path");
    CHECK_UNTOUCHED(3, out);
    segment = 1; /* in contact before */
    CHECK_SUCCESS(mdr_law_follow(law, -0.1, &segment, &point));
    CHECK_TRUE(segment == 0 && point.force == 0.0);
    CHECK_FREE(law);
    CHECK_TRUE(law == NULL);
    CHECK_FREE(law);
    CHECK_SUCCESS(mdr_free(NULL));
    CHECK_FREE(contact);
}

int main(void)
{
    test_values();
    test_history();
    test_files();
    test_refusals();
    return check_report("law");
}
