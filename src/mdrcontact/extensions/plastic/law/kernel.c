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

/* How far an elastic unloading without adhesion recovers from a largest depth of the range. */
double mdrcontact_plastic_recovery(const mdr_plastic_view *view, double deepest);
double mdrcontact_plastic_recovery(const mdr_plastic_view *view, double deepest)
{
    const mdr_plastic_imprint imprint = mdr_plastic_any_imprint(view, deepest);
    return imprint.uniform + imprint.hertz;
}

double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest);
double mdrcontact_plastic_loss(const mdr_plastic_view *view, double deepest) { return mdr_plastic_loss(view, deepest); }
