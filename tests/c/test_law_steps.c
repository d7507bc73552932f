/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sliders two and four at a time give the same bits, in records, T and derivatives. */
#include "check.h"

#define mdrcontact_sliders_step step_of_test
#define mdrcontact_sliders_steps steps_of_test
#define mdrcontact_sliders_sound sound_of_test
#define mdrcontact_record_begun begun_of_test
#include "../../src/mdrcontact/contact/law/sliders/step.c"

enum { LEVELS = 40, SLIDERS = 8, SIZE = HEAD + 4 * SLIDERS, CONTACTS = 300 };

static double uniform(void)
{
    static unsigned long long state = 20240607;
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(state >> 11) * 0x1p-53;
}

/* F = S^1.5 on levels S_l = 1.2^(l - LEVELS); shares of springs that interact. */
static void make_levels(double row[][4], double share[][4])
{
    for (int l = 0; l <= LEVELS + 1; ++l) {
        const double S = l == 0 ? 0.0 : pow(1.2, l - LEVELS);
        row[l][0] = S;
        row[l][1] = pow(S, 1.5);
        row[l][2] = 1.5 * sqrt(S);
        row[l][3] = 0.0;
    }
    for (int j = 0; j < 3; ++j) row[LEVELS + 1][j] = DBL_MAX;
    for (int l = 0; l < LEVELS; ++l) row[l][3] = 1.0 / (row[l + 1][0] - row[l][0]);
    for (int m = 0; m <= LEVELS; ++m) {
        for (int l = 0; l <= m + 1; ++l) {
            double *to = share[m * (m + 3) / 2 + l];
            to[0] = 1.0;
            to[1] = to[2] = to[3] = 0.0;
            if (l == 0 || l == m + 1) continue;
            to[0] = 1.0 - 0.1 * l / m;
            to[1] = 0.01 * l / m;
        }
    }
}

/* A contact with `used` sliders below level `next`, sheared at random. */
static void make_record(const double row[][4], double record[SIZE])
{
    const int used = 4 + (int)(4.999 * uniform()), next = LEVELS - (int)(10.0 * uniform());
    const double S = row[next - 1][0] + (row[next][0] - row[next - 1][0]) * uniform();
    memset(record, 0, SIZE * sizeof *record);
    record[0] = 7.0;
    record[AT_NEXT] = next;
    record[AT_USED] = used;
    record[AT_SHIFT] = record[AT_TOP] = S;
    record[AT_TOP + 1] = pow(S, 1.5);
    record[AT_TOP + 2] = 1.5 * sqrt(S);
    for (int i = 1; i < used; ++i) record[HEAD + i] = next - 1 - 2 * (used - 1 - i);
    for (int j = 1; j < 4; ++j) {
        for (int i = 0; i < used; ++i) record[HEAD + j * SLIDERS + i] = 0.02 * (uniform() - 0.5);
    }
}

typedef struct outcome {
    double memory[CONTACTS * SIZE], T[3 * CONTACTS], tangent[12 * CONTACTS];
    int done[CONTACTS];
} outcome;

static double F[CONTACTS], S[CONTACTS], by_force[CONTACTS], way[3 * CONTACTS];

/* Steps of all contacts one by one; what a step leaves to another way stays. */
static void lead(const given *of, const double before[], int with_tangent, int (*many)(const given *, const steps *), outcome *to)
{
    memcpy(to->memory, before, sizeof to->memory);
    memset(to->T, 0, sizeof to->T);
    memset(to->tangent, 0, sizeof to->tangent);
    for (int i = 0; i < CONTACTS; ++i) {
        const steps one = {F + i, S + i, by_force + i, way + 3 * i, to->memory + SIZE * i, to->T + 3 * i,
                           with_tangent ? to->tangent + 12 * i : NULL, 1, 0};
        to->done[i] = many(of, &one);
    }
}

int main(void)
{
    static double row[LEVELS + 2][4], share[(LEVELS + 1) * (LEVELS + 4) / 2 + 1][4], before[CONTACTS * SIZE];
    static outcome two, four;
    make_levels(row, share);
    for (int with_share = 0; with_share < 2; ++with_share) {
        const given of = {row[0], with_share ? share[0] : NULL, 0.3, 1e-100, LEVELS, SLIDERS};
        for (int i = 0; i < CONTACTS; ++i) {
            double *record = before + SIZE * i;
            make_record((const double(*)[4])row, record);
            S[i] = record[AT_SHIFT] * (0.98 + 0.06 * uniform());
            F[i] = pow(S[i], 1.5);
            by_force[i] = 1.0 / (1.5 * sqrt(S[i]));
            for (int j = 0; j < 3; ++j) way[3 * i + j] = 0.2 * (uniform() - 0.5) * S[i];
        }
        for (int with_tangent = 0; with_tangent < 2; ++with_tangent) {
            int done = 0;
#ifdef HAS_VECTORS
            lead(&of, before, with_tangent, many_of_2, &two);
            four = two;
#ifdef HAS_FOUR
            if (__builtin_cpu_supports("avx2")) lead(&of, before, with_tangent, many_by_four, &four);
#endif
            for (int i = 0; i < CONTACTS; ++i) done += two.done[i];
            CHECK_TRUE(done > CONTACTS / 4);
            CHECK_INT(memcmp(&two, &four, sizeof two), 0);
            CHECK_TRUE(memcmp(two.memory, before, sizeof two.memory) != 0);
#endif
            (void)done;
        }
        for (int i = 0; i < CONTACTS; ++i) {
            double *record = before + SIZE * i;
            CHECK_INT(begun_of_test(LEVELS, SLIDERS, 7.0, record), 1);
            record[(int)(SIZE * uniform())] = NAN;
            CHECK_INT(begun_of_test(LEVELS, SLIDERS, 7.0, record), NARROW(begun)(&of, 7.0, record));
        }
    }
    return check_report("law_steps");
}
