/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The arithmetic that the library computes in: results rounded to nearest, no number replaced by 0 because it is small, no traps. A host
 * may have set another one for the calling thread; it gets that back.
 */
#ifndef MDRCONTACT_ARITHMETIC_H
#define MDRCONTACT_ARITHMETIC_H

#include <fenv.h>
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

void mdrcontact_set_arithmetic(fenv_t *callers);
void mdrcontact_set_arithmetic_back(const fenv_t *callers);
int mdrcontact_leave_arithmetic(fenv_t *ours);
void mdrcontact_resume_arithmetic(const fenv_t *ours, int differs);

/* Whether the thread computes as the library does: some nanoseconds. Vectors and scalars have one register, long double, in which
 * sums of BLAS may be, another: control words of x87 are 64 significant bits, to nearest, all exceptions masked. */
static inline int arithmetic_is_set(void)
{
#ifdef __SSE2__
    enum { FLAGS = 0x3f, MASKED_NEAREST = 0x1f80, CONTROL = 0x0f3f, EXTENDED_NEAREST = 0x033f };
    unsigned short control;
    __asm__ __volatile__("fnstcw %0" : "=m"(control));
    return (_mm_getcsr() & ~(unsigned)FLAGS) == MASKED_NEAREST && (control & CONTROL) == EXTENDED_NEAREST;
#else
    return fegetround() == FE_TONEAREST;
#endif
}

#endif
