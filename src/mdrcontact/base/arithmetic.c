/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From the arithmetic of the caller to the library's and back. Called by api/entries.c, and by the threads of a team: batch.f90. */
#include "arithmetic.h"

#include <stdint.h>

_Static_assert(sizeof(fenv_t) <= 16 * sizeof(int64_t), "batch.f90 keeps it in so many numbers");

/* The arithmetic of the calling thread's host, while a call computes in another one. */
static _Thread_local struct {
    int differs;
    fenv_t environment;
} host_arithmetic;

void mdrcontact_set_arithmetic(fenv_t *callers)
{
    fegetenv(callers);
    host_arithmetic.environment = *callers;
    host_arithmetic.differs = 1;
    fesetenv(FE_DFL_ENV);
}

/* Flags of exceptions go to the caller as after any computation. They are set, not raised: a trap of the caller does not fire. */
void mdrcontact_set_arithmetic_back(const fenv_t *callers)
{
    host_arithmetic.differs = 0;
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

/* For a function of the host that may not return: it finds the arithmetic of the host, and that is what remains. */
int mdrcontact_leave_arithmetic(fenv_t *ours)
{
    const int differs = host_arithmetic.differs;
    if (differs) {
        const fenv_t callers = host_arithmetic.environment;
        fegetenv(ours);
        mdrcontact_set_arithmetic_back(&callers);
    }
    return differs;
}

void mdrcontact_resume_arithmetic(const fenv_t *ours, int differs)
{
    fenv_t callers;
    if (!differs) return;
    mdrcontact_set_arithmetic(&callers);
    fesetenv(ours);
}
