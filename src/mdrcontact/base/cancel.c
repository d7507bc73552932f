/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Cancellation and progress of the calling thread. Both belong to the thread and live here because Fortran
 * has no thread-local variables. A host may leave the function that it set by a jump: nothing here refers to frames of a call.
 */
#include "arithmetic.h"
#include "mdrcontact.h"

#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>
#include <unwind.h>

/* Seconds between two questions: the user's answer may cost more than the work between them. */
static const double interval = 0.05;

static _Thread_local struct {
    mdr_cancel question;
    void *context;
    double last_time;
    int answer;
    /* the question was put and has not been answered: it may also have been left by a jump */
    int is_open;
    /* for the threads that help this one: whether it was cancelled; and in a thread that helps, that of the other one */
    atomic_int team_stops;
    atomic_int *helped;
    /* receives the progress */
    volatile double *progress;
} cancel_state;

/* What mdrcontact_is_cancelled() answers. */
enum { GO_ON, STOP, ASKED_FROM_WITHIN };

/* All are called from Fortran only. */
int mdrcontact_is_cancelled(void);
void mdrcontact_report(double part);
void *mdrcontact_lead_team(void);
void mdrcontact_help(void *team);
void mdrcontact_stop_team(void *team);

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

/* Puts the question in the arithmetic of the host, which keeps it even if it does not return. */
__attribute__((noinline)) static int ask(void)
{
    fenv_t ours;
    int answer;

    cancel_state.is_open = 1;
    const int differs = mdrcontact_leave_arithmetic(&ours);
    answer = cancel_state.question(cancel_state.context);
    mdrcontact_resume_arithmetic(&ours, differs);
    cancel_state.is_open = 0;
    return answer;
}

static _Unwind_Reason_Code find_ask(struct _Unwind_Context *frame, void *found)
{
    /* the address before the one to return to lies within the function */
    if ((uintptr_t)_Unwind_FindEnclosingFunction((void *)(_Unwind_GetIP(frame) - 1)) != (uintptr_t)ask) return _URC_NO_REASON;
    *(int *)found = 1;
    return _URC_END_OF_STACK;
}

/* Whether the thread is within the function of the host: an open question alone may have been left by a jump. */
static int is_asking(void)
{
    int found = 0;
    if (cancel_state.is_open) _Unwind_Backtrace(find_ask, &found);
    cancel_state.is_open = found;
    return found;
}

int mdrcontact_is_cancelled(void)
{
    struct timespec now;
    double time, passed;

    if (cancel_state.helped != NULL && atomic_load_explicit(cancel_state.helped, memory_order_relaxed)) return STOP;
    if (cancel_state.question == NULL) return GO_ON;
    if (is_asking()) return ASKED_FROM_WITHIN;
    timespec_get(&now, TIME_UTC);
    time = (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
    passed = time - cancel_state.last_time;
    /* a clock that was set back starts anew; a function that has said yes is called until the call has returned */
    if (cancel_state.answer == 0 && passed >= 0.0 && passed < interval) return GO_ON;
    cancel_state.last_time = time;
    cancel_state.answer = ask();
    return cancel_state.answer ? STOP : GO_ON;
}

/* A team begins to work for the calling thread. What it returns lasts as long as the thread. */
void *mdrcontact_lead_team(void)
{
    atomic_store_explicit(&cancel_state.team_stops, 0, memory_order_relaxed);
    return &cancel_state.team_stops;
}

/* The calling thread works for a team from now on; NULL: no more. Who leads it is the one that is cancelled. */
void mdrcontact_help(void *team)
{
    cancel_state.helped = team == &cancel_state.team_stops ? NULL : team;
}

void mdrcontact_stop_team(void *team)
{
    atomic_store_explicit((atomic_int *)team, 1, memory_order_relaxed);
}
