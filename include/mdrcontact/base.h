/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file base.h
 * What all of the interface shares: version, status, errors, threads, structures that grow, user functions.
 * @since 0.1
 */
#ifndef MDRCONTACT_BASE_H
#define MDRCONTACT_BASE_H

#include <stddef.h>

/** A structure that grows, `type`, with its size; all else in it is 0. */
#ifdef __cplusplus
template <typename T> inline T mdr_sized()
{
    T made = T();
    made.size = sizeof(T);
    return made;
}
#define MDR_SIZED(type) mdr_sized<type>()
#else
#define MDR_SIZED(type) ((type){.size = sizeof(type)})
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** @name Version of this header; mdr_version() gives that of the library. */
/** @{ */
#define MDR_VERSION_MAJOR 0
#define MDR_VERSION_MINOR 1
#define MDR_VERSION_PATCH 0
/** @} */

/** What a call has to say. */
enum mdr_status {
    MDR_SUCCESS = 0,        /**< The call did what it says. */
    MDR_ENULL = 1,          /**< A required pointer or handle is NULL. */
    MDR_EINVALID = 2,       /**< An argument has a value that is never allowed (NaN, E <= 0, a table that is not ascending). */
    MDR_EDOMAIN = 3,        /**< A point lies where the object is not defined (r > a, beyond the end of a table). */
    MDR_EUNREACHABLE = 4,   /**< No contact state has the requested depth, force or radius. */
    MDR_ENOCONVERGENCE = 5, /**< An iteration or refinement ended before it met its tolerance, or a result left the number range. */
    MDR_ENOMEMORY = 6,      /**< Memory could not be allocated. */
    MDR_ECALLBACK = 7,      /**< A user function reported a failure or gave NaN or infinity. */
    MDR_EFILE = 8,          /**< A file could not be read or written, or is damaged. */
    MDR_ECANCELLED = 9      /**< The function given to mdr_set_cancel() ended the call. */
};

/** The library's version, 10000 major + 100 minor + patch. Never fails. */
int mdr_version(void);

/** The name of a status code, "MDR_EINVALID" for instance; "unknown status" for any other number. A constant: never freed. */
const char *mdr_status_name(int status);

/**
 * The text of the calling thread's last failure. Successful calls leave it as it is; it is empty before the first failure.
 *
 * Writes at most `length` characters, the closing zero included; what does not fit is cut off.
 * @param buffer  receives the text; NULL: the length only
 * @param length  size of buffer; nothing is written if it is less than 1
 * @return        the full length of the text without its closing zero, at most 1023: length + 1 characters hold all of it
 */
int mdr_last_error(char *buffer, int length);

/** The parts of a failure, for programs that put the words together themselves; mdr_last_error() says "entry 3 of xi = -1 is not
 *  allowed: ..." of the argument "xi", the entry 3 and the text " = -1 is not allowed: ...". */
typedef struct mdr_failure {
    size_t size;         /**< Of this structure; MDR_SIZED sets it. */
    int status;        /**< One of enum mdr_status; MDR_SUCCESS before the first failure. */
    int entry;         /**< Which entry of an array it is about, from 1; 0: none. */
    char argument[64]; /**< The argument that the text begins with; empty if the text stands alone. */
    char text[1024];   /**< What is wrong with it. */
} mdr_failure;

/** The calling thread's last failure, which this call leaves as it is.
 *  @param failure  begun by MDR_SIZED; receives it
 *  @return MDR_SUCCESS, MDR_ENULL, or MDR_EINVALID for a size that cannot be */
int mdr_last_failure(mdr_failure *failure);

/**
 * How many threads the calling thread's functions of arrays may use from now on: 1 at first. Each thread of a program has its own
 * number.
 *
 * Arrays too small to gain stay on the calling thread: some ten thousand points of a closed form, two states that are solved for;
 * so do structures made by mdr_structure_function(). Within a parallel region of the caller's all stays on the calling thread. The
 * results are the same to the last bit for every number of threads; where entries fail, the error is that of the first of them. A
 * library built without OpenMP uses one thread.
 * @param threads  at least 1, or 0 for as many as OpenMP offers
 */
int mdr_set_threads(int threads);

/**
 * Called during long calls; its result says whether to stop.
 * @param context  the pointer given with the function
 * @return         0 to go on; anything else to end the call, and then again until it has returned
 */
typedef int (*mdr_cancel)(void *context);

/**
 * From now on all calls of the calling thread that take long - fits, maps, tables, laws, loops, arrays of states - call `cancel`
 * whether to stop: after at most 0.2 s, not more often than every 0.05 s, in this thread. A call that is cancelled returns
 * MDR_ECANCELLED, has written nothing, and leaves every handle as it was. Each thread has its own.
 * @param cancel   NULL: none is called, as at first
 * @param context  passed on to cancel, may be NULL
 */
int mdr_set_cancel(mdr_cancel cancel, void *context);

/**
 * From now on mdr_contact_history() writes to *part, in the calling thread, how far its march through time is, and
 * mdr_contact_critical() and mdr_contact_first_failure() how far their search is. Another thread may read it meanwhile, or the
 * function given to mdr_set_cancel(). Each thread has its own.
 * @param part  [1] receives the number of rounds that are done, each with steps half as long as those of the one before, plus the
 *              part of the path that the present one has behind it; of a search the part that is done; NULL: none is called, as
 *              at first
 */
int mdr_set_progress(double part[]);

/** Frees what any handle of the library stands for: an indenter, a medium, a contact, a law and so on.
 *  @param handle  handle, or NULL: nothing
 *  @return MDR_SUCCESS, or MDR_EINVALID (and frees nothing) if it is no handle */
int mdr_free(void *handle);

/** Frees what a variable `handle` stands for, and sets it to NULL. */
#define MDR_FREE(handle) ((void)mdr_free(handle), (void)((handle) = NULL))

/**
 * A user function y = f(x). It is called only while the object it describes is made, in the thread that makes it.
 * @param x        where
 * @param y        receives the value, which must be finite
 * @param context  the pointer given with the function
 * @return         0, or any other number to report a failure: the creation then ends with MDR_ECALLBACK
 */
typedef int (*mdr_function)(double x, double *y, void *context);

#ifdef __cplusplus
}
#endif

#endif
