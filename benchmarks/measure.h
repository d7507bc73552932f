/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the compiled benchmarks share: processor time, and the end of a program whose call failed. Include mdrcontact.h before. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* Processor time: what other programs of the machine take does not count. */
static double busy(void)
{
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static void check(int status)
{
    if (status == MDR_SUCCESS) return;
    fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
    exit(EXIT_FAILURE);
}

static double least(double a, double b) { return a < b ? a : b; }
