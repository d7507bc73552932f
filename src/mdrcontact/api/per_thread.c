/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What belongs to the calling thread: the text of its last failure, and the number of threads of its calls with arrays. It is here
 * because Fortran has no thread-local variables: the rest of the library keeps no state between calls.
 */
#include "mdrcontact.h"
#include "refuse.h"

#include <stdio.h>
#include <string.h>

/* No structure of the caller is larger, and sizes are multiples of 4: options.f90. */
enum { LONGEST_TEXT = 1023, LARGEST_STRUCTURE = 4096 };

static _Thread_local char last_text[LONGEST_TEXT + 1];
static _Thread_local mdr_failure last_failure;
static _Thread_local int wanted_threads = 1;

/* Both are called from Fortran only. */
void mdrcontact_store_error(int status, const char *words, int length, const char *argument, int argument_length, int text_length,
                            int entry);
int mdrcontact_wanted_threads(void);

/* Copies what fits of n characters, and a closing zero. */
static void copy(char *to, int room, const char *from, int n)
{
    const int copied = n < room - 1 ? n : room - 1;
    memcpy(to, from, (size_t)copied);
    to[copied] = '\0';
}

/* The sentence ends with the text. */
void mdrcontact_store_error(int status, const char *words, int length, const char *argument, int argument_length, int text_length,
                            int entry)
{
    copy(last_text, (int)sizeof last_text, words, length);
    memset(&last_failure, 0, sizeof last_failure);
    last_failure.status = status;
    last_failure.entry = entry;
    copy(last_failure.argument, (int)sizeof last_failure.argument, argument, argument_length);
    copy(last_failure.text, (int)sizeof last_failure.text, words + length - text_length, text_length);
}

/* A size that cannot be is not a failure to remember: the caller is about to read another one. */
int mdr_last_failure(mdr_failure *failure)
{
    if (failure == NULL) return MDR_ENULL;
    if (failure->size < sizeof failure->size || failure->size > LARGEST_STRUCTURE || failure->size % 4 != 0) return MDR_EINVALID;
    const size_t size = failure->size < sizeof last_failure ? failure->size : sizeof last_failure;
    last_failure.size = failure->size;
    memcpy(failure, &last_failure, size);
    return MDR_SUCCESS;
}

int mdrcontact_wanted_threads(void)
{
    return wanted_threads;
}

/* Words that begin with an argument. */
static int refuse(int status, const char *argument, const char *text)
{
    char words[256];
    const int length = snprintf(words, sizeof words, "%s%s", argument, text), name = (int)strlen(argument);
    mdrcontact_store_error(status, words, length, argument, name, length - name, 0);
    return status;
}

int mdrcontact_refuse_null(const char *argument)
{
    return refuse(MDR_ENULL, argument, " is NULL: a pointer is required");
}

int mdrcontact_refuse_count(const char *argument, int count)
{
    char text[96];
    if (count < 0) snprintf(text, sizeof text, " = %d: it must be at least 0", count);
    else snprintf(text, sizeof text, " = %d: it must be at most %d. Divide the arrays", count, MDRCONTACT_MOST_ENTRIES);
    return refuse(MDR_EINVALID, argument, text);
}

int mdr_set_threads(int threads)
{
    if (threads < 0) {
        char text[128];
        snprintf(text, sizeof text, " = %d: it must be at least 1, or 0 for the number that OpenMP offers", threads);
        return refuse(MDR_EINVALID, "threads", text);
    }
    wanted_threads = threads;
    return MDR_SUCCESS;
}

const char *mdr_last_error(void)
{
    return last_text;
}
