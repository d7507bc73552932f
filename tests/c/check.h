/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Checks for the C tests: each one is typed, counted, and prints what it saw when it fails.
 * A test program ends with `return check_report("name");`, which fails if anything failed or nothing was checked.
 */
#ifndef CHECK_H
#define CHECK_H

#include "calls.h"
#include "mdrcontact.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int check_count;
static int check_failures;

/* Threads count, too. */
static inline void check_add(int *count)
{
    __atomic_fetch_add(count, 1, __ATOMIC_RELAXED);
}

static inline void check_failed(const char *file, int line, const char *what)
{
    check_add(&check_failures);
    fprintf(stderr, "%s:%d: %s: ", file, line, what);
}

static inline void check_true_at(const char *file, int line, const char *what, int condition)
{
    check_add(&check_count);
    if (!condition) {
        check_failed(file, line, what);
        fprintf(stderr, "is not true\n");
    }
}

static inline void check_int_at(const char *file, int line, const char *what, int found, int expected)
{
    check_add(&check_count);
    if (found != expected) {
        check_failed(file, line, what);
        fprintf(stderr, "%d, expected %d\n", found, expected);
    }
}

static inline void check_text_at(const char *file, int line, const char *what, const char *found, const char *expected)
{
    check_add(&check_count);
    if (found == NULL || strcmp(found, expected) != 0) {
        check_failed(file, line, what);
        fprintf(stderr, "\"%s\", expected \"%s\"\n", found ? found : "NULL", expected);
    }
}

/* |found - expected| <= tolerance |expected|; equal infinities are equal, NaN never is. */
static inline void check_close_at(const char *file, int line, const char *what, double found, double expected, double tolerance)
{
    check_add(&check_count);
    if (found == expected) return;
    if (!(fabs(found - expected) <= tolerance * fabs(expected)) || isinf(expected)) {
        check_failed(file, line, what);
        fprintf(stderr, "%.17g, expected %.17g, off by %.3g relative\n", found, expected, (found - expected) / expected);
    }
}

static inline void check_success_at(const char *file, int line, const char *what, int status)
{
    check_add(&check_count);
    if (status != MDR_SUCCESS) {
        check_failed(file, line, what);
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
    }
}

/* The status, and a last error that says so in the words `part`. */
static inline void check_status_at(const char *file, int line, const char *what, int status, int expected, const char *part)
{
    const char *text = mdr_last_error();
    check_add(&check_count);
    if (status != expected) {
        check_failed(file, line, what);
        fprintf(stderr, "%s, expected %s\n", mdr_name_of(status), mdr_name_of(expected));
    } else if (part[0] != '\0' && strstr(text, part) == NULL) {
        check_failed(file, line, what);
        fprintf(stderr, "the text \"%s\" does not contain \"%s\"\n", text, part);
    }
}

#define CHECK_TRUE(condition) check_true_at(__FILE__, __LINE__, #condition, (condition))
#define CHECK_INT(found, expected) check_int_at(__FILE__, __LINE__, #found, (found), (expected))
#define CHECK_TEXT(found, expected) check_text_at(__FILE__, __LINE__, #found, (found), (expected))
#define CHECK_CLOSE(found, expected, tolerance) check_close_at(__FILE__, __LINE__, #found, (found), (expected), (tolerance))
#define CHECK_SUCCESS(call) check_success_at(__FILE__, __LINE__, #call, (call))
#define CHECK_STATUS(call, expected, part) check_status_at(__FILE__, __LINE__, #call, (call), (expected), (part))

/* Frees what a variable stands for, and sets it to NULL. */
#define CHECK_FREE(handle)                                                                                                             \
    do {                                                                                                                               \
        CHECK_SUCCESS(mdr_free(handle));                                                                                               \
        (handle) = NULL;                                                                                                               \
    } while (0)

/* Marks an output array before a call that must fail, and checks that the call left it alone. */
static const double untouched = -12345.678;

static inline void fill_untouched(int n, double values[])
{
    for (int i = 0; i < n; i++) values[i] = untouched;
}

static inline void check_untouched_at(const char *file, int line, const char *what, int n, const double values[])
{
    for (int i = 0; i < n; i++) check_close_at(file, line, what, values[i], untouched, 0.0);
}

#define CHECK_UNTOUCHED(n, values) check_untouched_at(__FILE__, __LINE__, #values, (n), (values))

/* A field of the state that a radius, depth or force determines, on unloading. */
static inline int field_at(const mdr_contact *c, int field, int given, double value, int n, const double r[], double out[])
{
    mdr_state state = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const int status = mdr_contact_states(c, given, MDR_ON_UNLOADING, 1, &value, &state);
    return status != MDR_SUCCESS ? status : state_field(c, field, &state, n, r, out);
}

/* Layers that relax, from the surface down, on a half-space or, where it is NULL, a rigid base. */
static inline int relaxing_medium(int n, const mdr_material *const materials[], const double thickness[],
                                  const mdr_material *substrate, int model, const mdr_medium_options *options, mdr_medium **out)
{
    enum { MOST = 3 };
    mdr_layer layers[MOST], base = MDR_SIZED(mdr_layer);

    for (int i = 0; i < n && i < MOST; i++) {
        layers[i] = MDR_SIZED(mdr_layer);
        layers[i].thickness = thickness[i];
        layers[i].material = materials[i];
    }
    base.material = substrate;
    return medium_of_layers(n, layers, substrate ? &base : NULL, model, options, out);
}

static inline int check_report(const char *name)
{
    printf("%s: %d checks, %d failed\n", name, check_count, check_failures);
    return check_failures == 0 && check_count > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

#endif
