/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Steps of many plastic contacts: the inline functions of mdrcontact_plastic_law.h, called from Fortran.
 */
#include "mdrcontact_plastic_law.h"

int mdrcontact_plastic_view(const double *buffer, mdr_plastic_view *view);
int mdrcontact_plastic_view(const double *buffer, mdr_plastic_view *view) { return mdr_plastic_view_at(buffer, buffer, view); }

/* Steps of n contacts, up to the first that fails; its index, or n. Trials leave the memory. Outputs may be NULL. */
int mdrcontact_plastic_steps(const mdr_plastic_view *view, int n, const double depth[], int is_trial, double memory[], double force[],
                             double slope[], double radius[]);
int mdrcontact_plastic_steps(const mdr_plastic_view *view, int n, const double depth[], int is_trial, double memory[], double force[],
                             double slope[], double radius[])
{
    const size_t size = mdr_plastic_memory_size(view);
    for (int i = 0; i < n; ++i) {
        double after[2], F, rise, a = 0.0;
        double *const mine = memory + size * (size_t)i;
        if (mdr_plastic_step(view, depth[i], mine, after, &F, &rise, radius ? &a : NULL) != MDR_SUCCESS) return i;
        if (!is_trial) memcpy(mine, after, size * sizeof *mine);
        if (force) force[i] = F;
        if (slope) slope[i] = rise;
        if (radius) radius[i] = a;
    }
    return n;
}

/* Energies of n contacts at depths, up to the first that fails; its index, or n. */
int mdrcontact_plastic_energies(const mdr_plastic_view *view, int n, const double depth[], const double memory[], double stored[],
                                double dissipated[]);
int mdrcontact_plastic_energies(const mdr_plastic_view *view, int n, const double depth[], const double memory[], double stored[],
                                double dissipated[])
{
    const size_t size = mdr_plastic_memory_size(view);
    for (int i = 0; i < n; ++i) {
        if (mdr_plastic_view_energies(view, depth[i], memory + size * (size_t)i, &stored[i], &dissipated[i]) != MDR_SUCCESS) return i;
    }
    return n;
}

/* First loading without adhesion at a depth of the range: F, dF/dd, a, da/dd, the recovery of an elastic unloading and the work. */
void mdrcontact_plastic_virgin(const mdr_plastic_view *view, double depth, double state[6]);
void mdrcontact_plastic_virgin(const mdr_plastic_view *view, double depth, double state[6])
{
    const mdr_plastic_imprint imprint = mdr_plastic_any_imprint(view, depth);
    mdr_plastic_virgin(view, depth, &state[0], &state[1], &state[2], &state[3]);
    state[4] = imprint.uniform + imprint.hertz;
    state[5] = mdr_plastic_work(view, depth);
}

/* The largest depth without adhesion of first loading to a depth; NaN beyond the range. */
double mdrcontact_plastic_arrive(const mdr_plastic_view *view, double depth);
double mdrcontact_plastic_arrive(const mdr_plastic_view *view, double depth)
{
    if (view->line > 0.0) return mdr_plastic_arrive(view, 0.0, depth);
    return depth <= view->highest ? depth : (double)NAN;
}

double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest);
double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest) { return mdr_plastic_loss(view, deepest); }
