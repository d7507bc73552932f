/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL keeps its error handler in a plain variable: threads that switch it off at the same time race for it. The first one does it,
 * the others wait until it has; later calls leave the variable, and whatever handler the program has set meanwhile, alone.
 */
#include <gsl/gsl_errno.h>
#include <stdatomic.h>

enum { UNTOUCHED, BEING_SWITCHED, SWITCHED };

static atomic_int handler_state = UNTOUCHED;

void mdrcontact_switch_gsl_handler_off(void);

/* Called from Fortran only. */
void mdrcontact_switch_gsl_handler_off(void)
{
    int expected = UNTOUCHED;
    if (atomic_load(&handler_state) == SWITCHED) return;
    if (atomic_compare_exchange_strong(&handler_state, &expected, BEING_SWITCHED)) {
        gsl_set_error_handler_off();
        atomic_store(&handler_state, SWITCHED);
    }
    while (atomic_load(&handler_state) != SWITCHED) { /* one store in another thread */
    }
}
