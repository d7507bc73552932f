/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whether a block of numbers is a law that the inline functions of mdrcontact_law.h evaluate within the block, whatever the depth: for
 * files, messages and shared memory that others write. What it does not say is whether the law is that of a contact.
 */
#include "mdrcontact_law.h"

#include <limits.h>

enum { HEAD = sizeof(mdr_law_head) / sizeof(double), SEGMENT = sizeof(mdr_law_segment) / sizeof(double),
       INTERVAL = sizeof(mdr_law_interval) / sizeof(double), ROW = 8, MOST_BITS = 20, MOST_ROOTS = 12 };

/* A count, a place or a flag. */
static int is_whole(double x, double least, double most)
{
    return x >= least && x <= most && x == floor(x);
}

static int is_finite(double x) { return x >= -DBL_MAX && x <= DBL_MAX; }

/* Whether `count` parts of `size` numbers lie behind the head. */
static int holds(const mdr_law_head *head, double place, double count, int size)
{
    return is_whole(place, HEAD, head->size) && place + count * size <= head->size;
}

static int is_head(const mdr_law_head *head)
{
    const double panels = head->panel_count, behind = head->energy + panels;
    if (!is_whole(head->adhesive, 0.0, 1.0) || !is_whole(head->continues, 0.0, 1.0)) return 0;
    if (!(head->lowest < head->highest && head->end_radius >= 0.0 && (head->adhesive != 0.0 || head->lowest > 0.0))) return 0;
    if (!is_whole(head->force_roots, 0.0, MOST_ROOTS) || head->force_roots == 1.0) return 0;
    if (!(head->force_power >= 0.0 && head->radius_power >= 0.0)) return 0;
    if (!is_whole(head->segment_count, 1.0, INT_MAX) || !is_whole(head->interval_count, 1.0, INT_MAX)) return 0;
    if (!is_whole(panels, 1.0, INT_MAX) || !is_whole(head->direct, -1.0, head->interval_count - 1.0)) return 0;
    /* the conductance begins at the next multiple of a row */
    if (head->size > behind && ROW * ceil(behind / ROW) + ROW * panels > head->size) return 0;
    return holds(head, head->segments, head->segment_count, SEGMENT) && holds(head, head->intervals, head->interval_count, INTERVAL)
           && holds(head, head->force, panels, ROW) && holds(head, head->contact, panels, 2 * ROW)
           && holds(head, head->energy, panels, 1);
}

/* Whether the panels up to y, from the first of an interval, exist. */
static int has_panels(const mdr_law_head *head, const mdr_law_interval *interval, double y)
{
    uint64_t bits;
    memcpy(&bits, &y, sizeof bits);
    const uint64_t last = (bits - UINT64_C(0x3ff0000000000000)) >> (52 - (int)interval->bits);
    return y >= 1.0 && (double)last + interval->first_panel < head->panel_count;
}

static int is_interval(const mdr_law_head *head, const mdr_law_interval *interval)
{
    if (!(interval->lowest <= interval->highest && fabs(interval->scale) > 0.0 && interval->last_y >= 1.0)) return 0;
    if (!is_whole(interval->is_root, 0.0, 1.0) || !is_whole(interval->bits, 0.0, MOST_BITS)) return 0;
    if (interval->is_root != 0.0 && !(fabs(interval->side) == 1.0 && interval->smallest_root > 0.0)) return 0;
    return is_whole(interval->first_panel, 0.0, INT_MAX) && has_panels(head, interval, interval->last_y);
}

/* The interval in which y is not limited: at both ends, with a sum and a product in one operation or in two. */
static int is_direct(const mdr_law_head *head, const mdr_law_interval *interval)
{
    const double ends[2] = {interval->lowest, interval->highest};
    if (interval->is_root != 0.0 || interval->first_panel != 0.0) return 0;
    for (int i = 0; i < 2; ++i) {
        if (!has_panels(head, interval, interval->scale * ends[i] + interval->offset)) return 0;
        if (!has_panels(head, interval, fma(interval->scale, ends[i], interval->offset))) return 0;
    }
    return 1;
}

static int is_segment(const mdr_law_head *head, const mdr_law_segment *segment)
{
    return segment->lowest <= segment->highest && is_whole(segment->first, 0.0, head->interval_count - 1.0)
           && is_whole(segment->last, segment->first, head->interval_count - 1.0);
}

int mdr_law_check(const double buffer[], size_t bytes)
{
    const mdr_law_head *const head = (const mdr_law_head *)buffer;
    if (!buffer) return MDR_ENULL;
    if ((uintptr_t)buffer % sizeof(double) != 0 || bytes < sizeof *head || head->format != (double)MDR_LAW_FORMAT) return MDR_EINVALID;
    if (!is_whole(head->size, HEAD, (double)(bytes / sizeof(double)))) return MDR_EINVALID;
    for (size_t i = 0; i < (size_t)head->size; ++i) {
        if (!is_finite(buffer[i])) return MDR_EINVALID;
    }
    if (!is_head(head)) return MDR_EINVALID;
    const mdr_law_segment *const segments = (const mdr_law_segment *)(buffer + (size_t)head->segments);
    const mdr_law_interval *const intervals = (const mdr_law_interval *)(buffer + (size_t)head->intervals);
    for (size_t i = 0; i < (size_t)head->interval_count; ++i) {
        if (!is_interval(head, intervals + i)) return MDR_EINVALID;
    }
    for (size_t i = 0; i < (size_t)head->segment_count; ++i) {
        if (!is_segment(head, segments + i)) return MDR_EINVALID;
    }
    return head->direct < 0.0 || is_direct(head, intervals + (size_t)head->direct) ? MDR_SUCCESS : MDR_EINVALID;
}
