/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Checks of hosts: counted, printed where they fail. tests/c/check.h refers to the library, which some hosts do not link. */
#ifndef CHECK_HOST_H
#define CHECK_HOST_H

#include <stdio.h>

static int host_checks, host_failures;

#define CHECK(condition)                                                                      \
    do {                                                                                      \
        host_checks++;                                                                        \
        if (!(condition)) {                                                                   \
            host_failures++;                                                                  \
            fprintf(stderr, "%s:%d: %s is not true\n", __FILE__, __LINE__, #condition);       \
        }                                                                                     \
    } while (0)

/* Ends a program; nothing checked is a failure. */
static inline int host_report(const char *name)
{
    printf("%s: %d checks, %d failed\n", name, host_checks, host_failures);
    return host_failures > 0 || host_checks == 0;
}

#endif
