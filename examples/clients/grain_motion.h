/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How two grains in contact move against each other, and vectors. */
#ifndef GRAIN_MOTION_H
#define GRAIN_MOTION_H

#include <math.h>
#include <stdint.h>

/* A contact in a step: its grains, the normal from the second to the first, and half their distance. */
typedef struct touch {
    int i, j;
    double normal[3], arm;
} touch;

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double distance_of(const double a[3], const double b[3])
{
    const double between[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrt(dot(between, between));
}

/* A number between -1 and 1. */
static double random_number(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)*state / 2147483648.0 - 1.0;
}

/* The shift of grain i against j where they touch and their spin about the normal, in a time. LAMMPS calls between the halves of
 * its step: its velocities there are those from the last positions to these. */
static void motion_of(const touch *t, double *const *v, double *const *omega, double time, double shift[3], double *spin)
{
    double sum[3], from_spin[3], speed[3], along;
    for (int c = 0; c < 3; c++) sum[c] = omega[t->i][c] + omega[t->j][c];
    cross(sum, t->normal, from_spin);
    for (int c = 0; c < 3; c++) speed[c] = v[t->i][c] - v[t->j][c] - t->arm * from_spin[c];
    along = dot(speed, t->normal);
    for (int c = 0; c < 3; c++) shift[c] = time * (speed[c] - along * t->normal[c]);
    *spin = 0.5 * time * dot(sum, t->normal);
}

#endif
