/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that hands over what nobody wrote: files of laws with forged numbers and the right checksum, wild records of friction, wild
 * numbers for every argument of some functions. Each is refused, or gives numbers; none ends the program.
 */
#include "../c/check.h"
#include "forge.h"

enum { FILES = 7000, RECORDS = 20000, CHECKSUM_LINE = 15, MOST_RECORD = 300, WORD = 17 };

static const double wild_numbers[] = {0.0, -0.0, -1.0, 1e-320, 1e-300, 1e300, -1e300, 1.7976931348623157e308, 1e155, 4503599627370497.0,
                                      2147483648.0, 0.5, INFINITY, -INFINITY, NAN};
enum { WILD = sizeof wild_numbers / sizeof *wild_numbers };

static mdr_law *new_law(double gamma, double mu)
{
    const mdr_layer soft = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_contact_options options = MDR_SIZED(mdr_contact_options);
    mdr_law_options law_options = MDR_SIZED(mdr_law_options);
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_friction *friction = NULL;
    mdr_law *law = NULL;

    options.work_of_adhesion = gamma;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &soft, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(ball, medium, &options, &contact));
    if (mu > 0.0) CHECK_SUCCESS(mdr_friction_new(contact, mu, &friction));
    law_options.friction = friction;
    CHECK_SUCCESS(mdr_law_new(contact, 0.1, &law_options, &law));
    CHECK_SUCCESS(mdr_free(friction));
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(ball);
    return law;
}

/* Evaluates a law of a file, whatever it is. */
static void evaluate(const mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    CHECK_SUCCESS(mdr_law_about(law, &facts));
    for (int i = -1; i < 8; i++) {
        double F = 0.0, slope = 0.0;
        const double d = facts.lowest_depth + i * (facts.highest_depth - facts.lowest_depth) / 6.0;
        if (mdr_law_force(law, MDR_ON_UNLOADING, d, &F, &slope) == MDR_SUCCESS) CHECK_TRUE(!isnan(F));
    }
}

static void forge_files(const mdr_law *law)
{
    int length = 0, accepted = 0;
    CHECK_SUCCESS(mdr_law_write(law, NULL, 0, &length));
    char *whole = malloc((size_t)length + 1), *text = malloc((size_t)length + 1);
    CHECK_SUCCESS(mdr_law_write(law, whole, length, &length));
    const int body = length - CHECKSUM_LINE;
    for (int i = 0; i < FILES / 2; i++) {
        mdr_law *read = NULL;
        memcpy(text, whole, (size_t)length);
        for (unsigned long long j = 0; j <= draw() % 3; j++) {
            /* a digit of some word, or all of one */
            const int place = (int)(draw() % (unsigned long long)(body - WORD));
            if (text[place] == '\n') continue;
            text[place] = "0123456789ABCDEF"[draw() % 16];
        }
        char line[CHECKSUM_LINE + 1];
        snprintf(line, sizeof line, "crc32 %08X\n", (unsigned)crc32_of(text, (size_t)body));
        memcpy(text + body, line, CHECKSUM_LINE);
        if (mdr_law_read(text, length, &read) != MDR_SUCCESS) continue;
        accepted++;
        evaluate(read);
        CHECK_FREE(read);
    }
    printf("wild: %d of %d forged files accepted\n", accepted, FILES / 2);
    free(whole);
    free(text);
}

static void wild_records(const mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double sound[MOST_RECORD] = {0.0}, record[MOST_RECORD], T[3];
    const double F = 0.01, shift[3] = {1e-4, 0.0, 0.0};
    int refused = 0;

    CHECK_SUCCESS(mdr_law_about(law, &facts));
    CHECK_TRUE(facts.memory_size > 0 && facts.memory_size <= MOST_RECORD);
    CHECK_SUCCESS(mdr_law_advance(law, 1, &F, shift, 0, NULL, sound, T));
    for (int i = 0; i < RECORDS; i++) {
        memcpy(record, sound, sizeof record);
        for (unsigned long long j = 0; j <= draw() % 4; j++) {
            record[draw() % (unsigned long long)facts.memory_size] = wild_numbers[draw() % WILD];
        }
        const int status = mdr_law_advance(law, 1, &F, shift, 0, NULL, record, T);
        refused += status != MDR_SUCCESS;
        if (status == MDR_SUCCESS) CHECK_TRUE(!isnan(T[0]) && !isnan(T[1]) && !isnan(T[2]));
    }
    CHECK_TRUE(refused > RECORDS / 2);
}

/* Each argument of makers and of states in turn: 360 calls and more. */
static void wild_arguments(void)
{
    const mdr_layer soft = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    int calls = 0;

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &soft, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(ball, medium, NULL, &contact));
    for (int i = 0; i < WILD; i++) {
        const double x = wild_numbers[i];
        for (int j = 0; j < 8; j++) {
            mdr_profile *made = NULL;
            mdr_body *layered = NULL;
            mdr_layer layer = mdr_isotropic(j == 5 ? x : 2.0, j == 6 ? x : 0.2, j == 7 ? x : 0.1);
            switch (j) {
            case 0: mdr_profile_paraboloid(x, &made); break;
            case 1: mdr_profile_cone(x, &made); break;
            case 2: mdr_profile_power(x, 1.0, &made); break;
            case 3: mdr_profile_power(2.0, x, &made); break;
            case 4: mdr_profile_rounded_cone(0.3, x, &made); break;
            default: mdr_body_layered(1, &layer, &soft, NULL, &layered); break;
            }
            CHECK_SUCCESS(mdr_free(made));
            CHECK_SUCCESS(mdr_free(layered));
            calls++;
        }
        static const int given[3] = {MDR_DEPTH, MDR_FORCE, MDR_RADIUS};
        for (int j = 0; j < 18; j++) {
            mdr_state state = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
            if (mdr_contact_states(contact, given[j % 3], j % 2 ? MDR_ON_LOADING : MDR_ON_UNLOADING, 1, &x, &state) == MDR_SUCCESS) {
                CHECK_TRUE(isfinite(state.depth) && isfinite(state.radius) && isfinite(state.force));
            }
            calls++;
        }
    }
    CHECK_TRUE(calls >= 360);
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(ball);
}

int main(void)
{
    mdr_law *plain = new_law(0.0, 0.0), *sticky = new_law(1e-3, 0.0), *rough = new_law(0.0, 0.3);
    forge_files(plain);
    forge_files(sticky);
    wild_records(rough);
    wild_arguments();
    CHECK_FREE(plain);
    CHECK_FREE(sticky);
    CHECK_FREE(rough);
    return check_report("wild");
}
