/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Hosts that round otherwise, replace small numbers by 0 or trap exceptions: every kind of long call gives the same bits as without, and
 * the host gets its arithmetic back. States of laws, which are left to it, differ in the last digits.
 */
#define _GNU_SOURCE /* feenableexcept */

#include "long_calls.h"

#include <fenv.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

static numbers expected[LONG_CALLS];

static void run_all(const char *how)
{
    for (int i = 0; i < LONG_CALLS; i++) {
        static numbers found;
        found.count = 0;
        long_calls[i].run(&found);
        const int mode = fegetround();
        fesetround(FE_TONEAREST);
        CHECK_INT(found.count, expected[i].count);
        if (memcmp(found.values, expected[i].values, (size_t)found.count * sizeof(double)) != 0) {
            double off = 0.0;
            for (int j = 0; j < found.count; j++) {
                off = fmax(off, fabs(found.values[j] - expected[i].values[j]) / (fabs(expected[i].values[j]) + 1e-300));
            }
            fprintf(stderr, "%s, %s: off by %.1e\n", how, long_calls[i].name, off);
            CHECK_TRUE(off == 0.0);
        }
        fesetround(mode);
    }
}

static void under_modes(void)
{
    static const int modes[3] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    static const char *const names[3] = {"upward", "downward", "to zero"};
    for (int i = 0; i < 3; i++) {
        CHECK_INT(fesetround(modes[i]), 0);
        run_all(names[i]);
        CHECK_INT(fegetround(), modes[i]);
        fesetround(FE_TONEAREST);
    }
}

/* What compilers set where speed is all that counts; beside it a mode, as both stand in one register. */
static void under_flush_to_zero(void)
{
#ifdef __SSE2__
    const unsigned before = _mm_getcsr(), flags = 0x3f, flushing = before | 0x8040;
    _mm_setcsr(flushing);
    run_all("flush to zero");
    CHECK_TRUE((_mm_getcsr() & ~flags) == (flushing & ~flags));
    _mm_setcsr(before);
#endif
}

/* The register of long double has a precision, a rounding mode and traps of its own: 24 bits, 53 bits, towards zero, all traps. */
static void under_x87(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    static const unsigned short words[4] = {0x007f, 0x027f, 0x0f7f, 0x0360};
    unsigned short before, after;
    __asm__ __volatile__("fnstcw %0" : "=m"(before));
    for (int i = 0; i < 4; i++) {
        char name[32];
        snprintf(name, sizeof name, "x87 control word %04x", words[i]);
        __asm__ __volatile__("fldcw %0" : : "m"(words[i]));
        run_all(name);
        __asm__ __volatile__("fnstcw %0" : "=m"(after));
        __asm__ __volatile__("fldcw %0" : : "m"(before));
        CHECK_INT(after & 0x0f3f, words[i] & 0x0f3f);
    }
#endif
}

/* Traps of the host fire in the host alone; flags show what happened inside. */
static void under_traps(void)
{
#ifdef __GLIBC__
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    run_all("traps");
    CHECK_INT(fegetexcept(), FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
    fedisableexcept(FE_ALL_EXCEPT);
    CHECK_TRUE(fetestexcept(FE_INEXACT) != 0);
#endif
    mdr_profile *p = NULL;
    const double r[1] = {0.3};
    double out[1];
    CHECK_SUCCESS(mdr_profile_cone(0.3, &p));
    for (int i = 0; i < 2; i++) {
        fesetround(i == 0 ? FE_TONEAREST : FE_UPWARD);
        feclearexcept(FE_ALL_EXCEPT);
        feraiseexcept(FE_OVERFLOW);
        CHECK_SUCCESS(mdr_profile_values(p, MDR_HEIGHT, 1, r, out));
        CHECK_TRUE(fetestexcept(FE_OVERFLOW) != 0 && fetestexcept(FE_INEXACT) != 0);
    }
    fesetround(FE_TONEAREST);
    feclearexcept(FE_ALL_EXCEPT);
    MDR_FREE(p);
}

/* User functions are called in the library's arithmetic, and may call the library. */
static int nested(double r, double *y, void *context)
{
    static const double a[1] = {0.5};
    CHECK_INT(fegetround(), FE_TONEAREST);
    CHECK_SUCCESS(mdr_medium_values(context, MDR_MODULUS, 1, a, y));
    CHECK_INT(fegetround(), FE_TONEAREST);
    *y *= r * r;
    return 0;
}

static void with_user_functions(void)
{
    mdr_medium *m = coating(10.0);
    mdr_profile *p = NULL;
    fesetround(FE_UPWARD);
    CHECK_SUCCESS(mdr_profile_function(nested, m, 1.0, &p));
    CHECK_INT(fegetround(), FE_UPWARD);
    CHECK_STATUS(mdr_profile_function(nested, m, -1.0, &p), MDR_EINVALID, "largest_radius"); /* failures too */
    CHECK_INT(fegetround(), FE_UPWARD);
    fesetround(FE_TONEAREST);
    MDR_FREE(p);
    MDR_FREE(m);
}

static void states_of_laws(void)
{
    static const int modes[4] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    mdr_contact *c = ball_on(coating(10.0), 0.0);
    mdr_law *law = NULL;
    CHECK_SUCCESS(mdr_law_new(c, 0.2, NULL, &law));
    for (int j = 1; j < 20; j++) {
        const double d[1] = {0.01 * j};
        double F[4], all[4], U[4];
        mdr_law_point at[4];
        for (int i = 0; i < 4; i++) {
            fesetround(modes[i]);
            CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, d[0], &F[i], NULL));
            CHECK_SUCCESS(law_point(law, MDR_FORCE, MDR_ON_UNLOADING, 0.03 * j, &at[i]));
            CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 1, d, NULL, NULL, &all[i], NULL, NULL, NULL));
            CHECK_SUCCESS(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, 1, d, NULL, NULL, NULL, NULL, NULL, &U[i]));
            fesetround(FE_TONEAREST);
            CHECK_CLOSE(F[i], F[0], 1e-14);
            CHECK_CLOSE(all[i], F[0], 1e-14);
            CHECK_CLOSE(U[i], U[0], 1e-14);
            CHECK_CLOSE(at[i].depth, at[0].depth, 1e-14);
        }
    }
    MDR_FREE(law);
    MDR_FREE(c);
}

/* Threads of a team keep the mode in which they were started, whatever that of the caller is later. */
static void in_teams(void)
{
    enum { MANY = 64 };
    static double a[MANY], alone[MANY], shared[MANY];
    mdr_contact *c = ball_on(coating(10.0), 0.0);
    for (int i = 0; i < MANY; i++) a[i] = 0.1 + 0.01 * i;
    CHECK_SUCCESS(columns_of(c, MDR_RADIUS, MANY, a, NULL, NULL, alone, NULL));
    CHECK_SUCCESS(mdr_set_threads(4));
    fesetround(FE_UPWARD);
    for (int i = 0; i < 2; i++) {
        CHECK_SUCCESS(columns_of(c, MDR_RADIUS, MANY, a, NULL, NULL, shared, NULL));
        fesetround(FE_TONEAREST);
        for (int j = 0; j < MANY; j++) CHECK_CLOSE(shared[j], alone[j], 0.0);
    }
    CHECK_SUCCESS(mdr_set_threads(1));
    MDR_FREE(c);
}

int main(void)
{
    in_teams(); /* before any other: no team has been started */
    for (int i = 0; i < LONG_CALLS; i++) long_calls[i].run(&expected[i]);
    under_modes();
    under_flush_to_zero();
    under_traps();
    under_x87();
    with_user_functions();
    states_of_laws();
    return check_report("rounding modes");
}
