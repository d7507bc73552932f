/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cancellation and progress of the calling thread. Both belong to the thread and live here because Fortran
 * has no thread-local variables.
 */
#include "mdrcontact.h"

#include <stddef.h>
#include <time.h>

/* Seconds between two questions: the user's answer may cost more than the work between them. */
static const double interval = 0.05;

static _Thread_local struct {
    mdr_cancel question;
    void *context;
    double last_time;
    int answer;
    /* in a thread that helps another one: whether that one was cancelled */
    const volatile int *helped;
    /* receives the progress */
    volatile double *progress;
} cancel_state;

/* All are called from Fortran only. */
int mdrcontact_is_cancelled(void);
void mdrcontact_report(double part);
void mdrcontact_poll_for_team(const volatile int *team_flag);

int mdr_set_cancel(mdr_cancel cancel, void *context)
{
    cancel_state.question = cancel;
    cancel_state.context = context;
    cancel_state.last_time = 0.0;
    cancel_state.answer = 0;
    return MDR_SUCCESS;
}

int mdr_set_progress(double *part)
{
    cancel_state.progress = part;
    return MDR_SUCCESS;
}

void mdrcontact_report(double part)
{
    if (cancel_state.progress != NULL) *cancel_state.progress = part;
}

int mdrcontact_is_cancelled(void)
{
    struct timespec now;
    double time, passed;

    if (cancel_state.helped != NULL && *cancel_state.helped) return 1;
    if (cancel_state.question == NULL) return 0;
    timespec_get(&now, TIME_UTC);
    time = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
    passed = time - cancel_state.last_time;
    /* a clock that was set back starts anew; a function that has said yes is called until the call has returned */
    if (cancel_state.answer == 0 && passed >= 0.0 && passed < interval) return 0;
    cancel_state.last_time = time;
    cancel_state.answer = cancel_state.question(cancel_state.context);
    return cancel_state.answer;
}

void mdrcontact_poll_for_team(const volatile int *team_flag)
{
    cancel_state.helped = team_flag;
}
