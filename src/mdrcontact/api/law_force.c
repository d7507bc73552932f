/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The calls of inner loops: a look at the handle, and one polynomial by the inline functions of mdrcontact_law.h. Whatever else is to be
 * said is said by Fortran: api/law.f90.
 */
#include "mdrcontact_law.h"

/* How a handle begins: api/handles.f90. The view of what is no law is empty. */
typedef struct handle {
    int64_t tag;
    mdr_law_view view;
} handle;

static const int64_t live_tag = INT64_C(7239381865347100001);

int mdrcontact_law_force(const mdr_law *law, int branch, double d, double *F, double *slope);

int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope)
{
    const handle *inside = (const handle *)law;
    if (inside && inside->tag == live_tag && F && d >= inside->view.lowest && d <= inside->view.highest
        && (branch == MDR_ON_LOADING || branch == MDR_ON_UNLOADING)) {
        return slope ? mdr_law_view_force_slope(&inside->view, d, F, slope) : mdr_law_view_force(&inside->view, d, F);
    }
    return mdrcontact_law_force(law, branch, d, F, slope);
}
