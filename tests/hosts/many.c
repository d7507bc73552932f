/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host with arrays of almost 2^31 numbers, in files of a few pages that its addresses repeat: the last entry is written, and right.
 * More are refused. Linux, 64 bits. Half a minute on one core.
 */
#define _GNU_SOURCE
#include "../c/check.h"
#include "mdrcontact/weights.h"

#include <limits.h>
#include <sys/mman.h>
#include <unistd.h>

enum { MOST_ENTRIES = 2147418112 };

static const size_t piece = (size_t)1 << 20;

/* Addresses for n numbers, all of one file that holds a piece of them but for the last page, which is its own. */
static double *repeated(size_t n)
{
    const size_t bytes = (n * sizeof(double) + piece - 1) / piece * piece, page = (size_t)sysconf(_SC_PAGESIZE);
    const int file = memfd_create("piece", 0);
    char *place = mmap(NULL, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);

    if (file < 0 || place == MAP_FAILED || ftruncate(file, (off_t)piece) != 0) return NULL;
    for (size_t at = 0; at < bytes; at += piece) {
        if (mmap(place + at, piece, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, file, 0) == MAP_FAILED) return NULL;
    }
    close(file);
    char *last = place + (n * sizeof(double) - 1) / page * page;
    if (mmap(last, page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0) == MAP_FAILED) return NULL;
    return (double *)(void *)place;
}

int main(void)
{
    const size_t n = MOST_ENTRIES;
    double *x = repeated(n), *y = repeated(n), expected;
    const double last = 0.7;

    if (!x || !y) {
        printf("many: left out, as the system has no addresses for it\n");
        return 77;
    }
    for (size_t i = 0; i < piece / sizeof(double); i++) x[i] = 0.5;
    x[n - 1] = last;
    CHECK_SUCCESS(mdr_set_threads(2));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_PHI, 0.3, MOST_ENTRIES, x, y));
    CHECK_SUCCESS(mdr_weight(MDR_WEIGHT_PHI, 0.3, 1, &last, &expected));
    CHECK_TRUE(y[n - 1] == expected && expected > 0.0);
    CHECK_STATUS(mdr_weight(MDR_WEIGHT_PHI, 0.3, MOST_ENTRIES + 1, x, y), MDR_EINVALID, "n = 2147418113: it must be at most");
    CHECK_STATUS(mdr_weight(MDR_WEIGHT_PHI, 0.3, INT_MAX, x, y), MDR_EINVALID, "n = 2147483647: it must be at most");
    return check_report("many");
}
