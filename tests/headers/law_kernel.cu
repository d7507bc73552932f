/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All functions of the header in one kernel. */
#include <mdrcontact_law.h>

__global__ void law_kernel(const double *buffer, double d, int *segment, mdr_law_point *points, double *F)
{
    mdr_law_view view;
    if (mdr_law_view_from(buffer, MDR_ON_UNLOADING, &view)) return;
    mdr_law_view_state(&view, d, &points[0]);
    mdr_law_view_follow(&view, d, segment, &points[1]);
    mdr_law_view_force(&view, d, &F[0]);
    mdr_law_view_force_slope(&view, d, &F[1], &F[2]);
}
