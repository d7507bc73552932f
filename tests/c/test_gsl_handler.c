/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Threads that begin to use GSL at the same time: none goes on before its error handler is off. This program brings the function
 * that switches it off, and takes its time; and one that is used afterwards, which looks.
 */
#define _GNU_SOURCE
#include "check.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

enum { THREADS = 4 };

static atomic_int is_off, switched, too_early;

void *gsl_set_error_handler_off(void);
void *gsl_spline_alloc(const void *kind, size_t n);

void *gsl_set_error_handler_off(void)
{
    atomic_fetch_add(&switched, 1);
    nanosleep(&(struct timespec){0, 200000000}, NULL);
    atomic_store(&is_off, 1);
    return NULL;
}

void *gsl_spline_alloc(const void *kind, size_t n)
{
    const union {
        void *object;
        void *(*function)(const void *, size_t);
    } real = {dlsym(RTLD_NEXT, "gsl_spline_alloc")};

    if (!atomic_load(&is_off)) atomic_fetch_add(&too_early, 1);
    return real.function(kind, n);
}

static void *make_table(void *unused)
{
    const double a[3] = {1.0, 2.0, 3.0}, E[3] = {1.0, 1.5, 2.0};
    mdr_medium *m = NULL;

    if (mdr_medium_table(3, a, E, &m) == MDR_SUCCESS) MDR_FREE(m);
    return unused;
}

int main(void)
{
    pthread_t threads[THREADS];

    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_create(&threads[i], NULL, make_table, NULL), 0);
    for (int i = 0; i < THREADS; i++) CHECK_INT(pthread_join(threads[i], NULL), 0);
    CHECK_INT(atomic_load(&switched), 1);
    CHECK_INT(atomic_load(&too_early), 0);
    return check_report("gsl_handler");
}
