/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the arithmetic of the caller to the library's and back. Called by api/entries.c, and by the threads of a team: batch.f90. */
#include "arithmetic.h"

#include <stdint.h>

_Static_assert(sizeof(fenv_t) <= 16 * sizeof(int64_t), "batch.f90 keeps it in so many numbers");

void mdrcontact_set_arithmetic(fenv_t *callers)
{
    fegetenv(callers);
    fesetenv(FE_DFL_ENV);
}

/* Flags of exceptions go to the caller as after any computation. They are set, not raised: a trap of the caller does not fire. */
void mdrcontact_set_arithmetic_back(const fenv_t *callers)
{
#ifdef __SSE2__
    const unsigned raised = (unsigned)fetestexcept(FE_ALL_EXCEPT);
    fesetenv(callers);
    _mm_setcsr(_mm_getcsr() | raised);
#else
    const int raised = fetestexcept(FE_ALL_EXCEPT);
    fexcept_t flags;
    fegetexceptflag(&flags, raised);
    fesetenv(callers);
    fesetexceptflag(&flags, raised);
#endif
}
