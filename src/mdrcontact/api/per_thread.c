/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What belongs to the calling thread: the text of its last failure, and how many threads its calls with arrays may use. It lives here
 * because Fortran has no thread-local variables: the rest of the library keeps no state between calls.
 */
#include "mdrcontact.h"

#include <stdio.h>
#include <string.h>

enum { LONGEST_TEXT = 1023 };

static _Thread_local char last_text[LONGEST_TEXT + 1];
static _Thread_local int last_length;
static _Thread_local int wanted_threads = 1;

/* Both are called from Fortran only. */
void mdrcontact_store_error(const char *text, int length);
int mdrcontact_wanted_threads(void);

/* What does not fit is cut off. */
void mdrcontact_store_error(const char *text, int length)
{
    last_length = length < LONGEST_TEXT ? length : LONGEST_TEXT;
    memcpy(last_text, text, (size_t)last_length);
    last_text[last_length] = '\0';
}

int mdrcontact_wanted_threads(void)
{
    return wanted_threads;
}

int mdr_set_threads(int threads)
{
    if (threads < 0) {
        char text[128];
        int length = snprintf(text, sizeof text, "threads = %d is not allowed: it must be at least 1, or 0 for as many as OpenMP offers",
                              threads);
        mdrcontact_store_error(text, length);
        return MDR_EINVALID;
    }
    wanted_threads = threads;
    return MDR_SUCCESS;
}

int mdr_last_error(char *buffer, int length)
{
    if (buffer != NULL && length > 0) {
        int copied = last_length < length - 1 ? last_length : length - 1;
        memcpy(buffer, last_text, (size_t)copied);
        buffer[copied] = '\0';
    }
    return last_length;
}

const char *mdr_status_name(int status)
{
    switch (status) {
    case MDR_SUCCESS: return "MDR_SUCCESS";
    case MDR_ENULL: return "MDR_ENULL";
    case MDR_EINVALID: return "MDR_EINVALID";
    case MDR_EDOMAIN: return "MDR_EDOMAIN";
    case MDR_EUNREACHABLE: return "MDR_EUNREACHABLE";
    case MDR_ENOCONVERGENCE: return "MDR_ENOCONVERGENCE";
    case MDR_ENOMEMORY: return "MDR_ENOMEMORY";
    case MDR_ECALLBACK: return "MDR_ECALLBACK";
    case MDR_EFILE: return "MDR_EFILE";
    default: return "unknown status";
    }
}
