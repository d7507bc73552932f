/* SPDX-License-Identifier: GPL-3.0-or-later */
/* All functions of the header in one kernel. */
#include <mdrcontact_plastic_law.h>

__global__ void plastic_kernel(const double *buffer, double d, double *memory, double *after, mdr_plastic_point *point, double *F)
{
    mdr_plastic_view view;
    if (mdr_plastic_view_at(buffer, buffer, &view)) return;
    mdr_plastic_view_try(&view, d, memory, after, point);
    mdr_plastic_view_energies(&view, d, memory, &F[0], &F[1]);
    mdr_plastic_view_advance(&view, d, memory, &F[2], &F[3]);
}
