/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The calls of inner loops: a look at the handle, and the inline functions of mdrcontact_law.h. What is refused is worded by
 * Fortran: api/law.f90.
 */
#include "mdrcontact_law.h"

/* How a handle begins: api/handles.f90. The view of what is no law is empty. */
typedef struct handle {
    int64_t tag;
    intptr_t copy;
    mdr_law_view view;
} handle;

/* Each copy of the library in a process, static or shared, has one at an address of its own, which its handles contain. */
static const char this_copy = 0;

intptr_t mdrcontact_this_copy(void);
intptr_t mdrcontact_this_copy(void) { return (intptr_t)&this_copy; }

static const int64_t live_tag = INT64_C(7239381865347100001);

int mdrcontact_law_at_depth(const mdr_law *law, int branch, double d, mdr_law_point *point);

/* For Fortran: the view of numbers, and that of an open handle's law. */
int mdrcontact_law_view_from(const double *buffer, int branch, mdr_law_view *view);
int mdrcontact_law_view_from(const double *buffer, int branch, mdr_law_view *view) { return mdr_law_view_from(buffer, branch, view); }

void mdrcontact_law_view(const mdr_law *law, int branch, mdr_law_view *view);
void mdrcontact_law_view(const mdr_law *law, int branch, mdr_law_view *view)
{
    mdr_law_view_from(((const handle *)law)->view.buffer, branch, view);
}

/* The view of a law on a branch, else NULL; without adhesion both branches are one. */
static const mdr_law_view *view_for(const mdr_law *law, int branch)
{
    const handle *inside = (const handle *)law;
    if (!inside || inside->tag != live_tag || inside->copy != (intptr_t)&this_copy || !inside->view.buffer) return NULL;
    if (branch == MDR_ON_UNLOADING) return &inside->view;
    return branch == MDR_ON_LOADING && mdr_law_head_of(&inside->view)->adhesive == 0.0 ? &inside->view : NULL;
}

int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope)
{
    const mdr_law_view *view = view_for(law, branch);
    double force, rise;
    if (view && !slope && mdr_law_view_force(view, d, &force) == MDR_SUCCESS) {
        if (F) *F = force;
        return MDR_SUCCESS;
    }
    if (view && slope && mdr_law_view_force_slope(view, d, &force, &rise) == MDR_SUCCESS) {
        if (F) *F = force;
        *slope = rise;
        return MDR_SUCCESS;
    }
    mdr_law_point point;
    const int status = mdrcontact_law_at_depth(law, branch, d, &point);
    if (status == MDR_SUCCESS && F) *F = point.force;
    if (status == MDR_SUCCESS && slope) *slope = point.slope;
    return status;
}
