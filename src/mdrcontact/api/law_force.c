/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The calls of inner loops: a look at the handle, and one polynomial by the inline functions of mdrcontact_law.h. Whatever else is to be
 * said is said by Fortran: api/law.f90.
 */
#include "mdrcontact_law.h"

#include <math.h>

/* How a handle begins: api/handles.f90. The view of what is no law is empty. */
typedef struct handle {
    int64_t tag;
    mdr_law_view view;
} handle;

static const int64_t live_tag = INT64_C(7239381865347100001);

int mdrcontact_law_at_depth(const mdr_law *law, int branch, double d, mdr_law_point *point);

/* F and its slope, either of which may be NULL, near first touch; 0 if this is no such place. On both branches: there is one. */
static int near_first_touch(const mdr_law *law, int branch, double d, double *F, double *slope)
{
    const handle *inside = (const handle *)law;
    if (!inside || inside->tag != live_tag || !(d > inside->view.open && d < inside->view.first)) return 0;
    if (branch != MDR_ON_LOADING && branch != MDR_ON_UNLOADING) return 0;
    const double force = inside->view.at_first * pow(d / inside->view.first, inside->view.power);
    if (F) *F = force;
    if (slope) *slope = inside->view.power * force / d;
    return 1;
}

/* The view of a law if it has the answer, else NULL. */
static const mdr_law_view *view_for(const mdr_law *law, int branch, double d)
{
    const handle *inside = (const handle *)law;
    if (!inside || inside->tag != live_tag) return NULL;
    if (!(d >= inside->view.lowest && d <= inside->view.highest) && !mdr_law_is_open(&inside->view, d)) return NULL;
    return branch == MDR_ON_LOADING || branch == MDR_ON_UNLOADING ? &inside->view : NULL;
}

int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope)
{
    const mdr_law_view *view = view_for(law, branch, d);
    if (view && F) return slope ? mdr_law_view_force_slope(view, d, F, slope) : mdr_law_view_force(view, d, F);
    if (near_first_touch(law, branch, d, F, slope)) return MDR_SUCCESS;
    mdr_law_point point;
    const int status = mdrcontact_law_at_depth(law, branch, d, &point);
    if (status == MDR_SUCCESS && F) *F = point.force;
    if (status == MDR_SUCCESS && slope) *slope = point.slope;
    return status;
}

int mdr_law_at_depth(const mdr_law *law, int branch, double d, mdr_law_point *point)
{
    const mdr_law_view *view = view_for(law, branch, d);
    return view && point ? mdr_law_view_state(view, d, point) : mdrcontact_law_at_depth(law, branch, d, point);
}
