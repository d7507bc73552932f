/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a block of numbers is a plastic law that the inline functions of mdrcontact_plastic_law.h evaluate within the block, whatever
 * depth and memory: as api/law_check.c for elastic laws.
 */
#include "mdrcontact_plastic_law.h"

#include <limits.h>

enum { HEAD = sizeof(mdr_plastic_head) / sizeof(double), ROWS = 32, TENSION = 8, MOST_BITS = 20 };

/* A count or a place. */
static int is_whole(double x, double least, double most)
{
    return x >= least && x <= most && x == floor(x);
}

/* Whether `count` numbers lie behind the head. */
static int holds(const mdr_plastic_head *head, double place, double count)
{
    return is_whole(place, HEAD, head->size) && place + count <= head->size;
}

/* Whether the bits of y number one of the panels. */
static int has_panel(const mdr_plastic_head *head, double y)
{
    uint64_t bits;
    memcpy(&bits, &y, sizeof bits);
    return y >= 1.0 && (double)((bits - UINT64_C(0x3ff0000000000000)) >> (52 - (int)head->bits)) < head->panels;
}

/* Whether each depth beyond yield has a panel: y rises, with a sum and a product in one operation or in two. */
static int has_panels(const mdr_plastic_head *head, const double *edges)
{
    const double depth = head->highest - head->yield;
    if (!(depth > 0.0)) return 1;
    if (!(head->panels >= 1.0 && head->scale > 0.0)) return 0;
    if (head->edges == 0.0) {
        return has_panel(head, head->offset) && has_panel(head, head->scale * depth + head->offset)
               && has_panel(head, fma(head->scale, depth, head->offset));
    }
    for (size_t i = 0; i < (size_t)head->panels; ++i) {
        if (!(edges[i] < edges[i + 1])) return 0;
    }
    return 1;
}

static int is_head(const mdr_plastic_head *head)
{
    if (!is_whole(head->panels, 0.0, INT_MAX) || !is_whole(head->bits, 0.0, MOST_BITS)) return 0;
    if (!(head->yield >= 0.0 && head->highest > 0.0 && head->modulus > 0.0 && head->line >= 0.0 && head->radius >= 0.0)) return 0;
    if (head->edges != 0.0 && !holds(head, head->edges, head->panels + 1.0)) return 0;
    if (head->tension != 0.0 && !holds(head, head->tension, TENSION * head->panels)) return 0;
    return holds(head, head->elastic, 0.0) && holds(head, head->rows, ROWS * head->panels) && holds(head, head->energy, head->panels);
}

int mdr_plastic_law_check(const double buffer[], size_t bytes)
{
    const mdr_plastic_head *const head = (const mdr_plastic_head *)buffer;
    if (!buffer) return MDR_ENULL;
    if ((uintptr_t)buffer % sizeof(double) != 0 || bytes < sizeof *head || head->format != MDR_PLASTIC_FORMAT) return MDR_EINVALID;
    if (!is_whole(head->size, HEAD, (double)(bytes / sizeof(double)))) return MDR_EINVALID;
    for (size_t i = 0; i < (size_t)head->size; ++i) {
        if (!(fabs(buffer[i]) <= DBL_MAX)) return MDR_EINVALID;
    }
    if (!is_head(head) || !has_panels(head, buffer + (size_t)head->edges)) return MDR_EINVALID;
    const size_t elastic = (size_t)head->elastic;
    return mdr_law_check(buffer + elastic, ((size_t)head->size - elastic) * sizeof(double));
}
