/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Calls that tests make often, with numbers in place of structures. Outputs that are NULL are skipped; nothing is written after a
 * failure. */
#ifndef CALLS_H
#define CALLS_H

#include "mdrcontact.h"

#include <math.h>
#include <stdlib.h>

/* Not inlined, for compilers would say of its outputs that they may be unset. */
#ifdef __GNUC__
#define APART __attribute__((noinline, unused)) static
#else
#define APART static inline
#endif

/* The medium of a body that serves for nothing else: `status` is that of its making. */
static inline int medium_of(int status, mdr_body *body, int model, const mdr_medium_options *options, mdr_medium **out)
{
    mdr_medium_options chosen = options ? *options : MDR_SIZED(mdr_medium_options);
    chosen.model = model;
    if (status == MDR_SUCCESS) status = mdr_medium_new(body, &chosen, out);
    MDR_FREE(body);
    return status;
}

/* Layers from the surface down, on a half-space or, where it is NULL, a rigid base. */
static inline int medium_of_layers(int n, const mdr_layer *layers, const mdr_layer *substrate, int model,
                                   const mdr_medium_options *options, mdr_medium **out)
{
    mdr_body *body = NULL;
    const int status = mdr_body_layered(n, layers, substrate, NULL, &body);
    return medium_of(status, body, model, options, out);
}

static inline int medium_of_grades(int n, const double z[], const double E[], const double nu[], int model,
                                   const mdr_medium_options *options, mdr_medium **out)
{
    mdr_body *body = NULL;
    const int status = mdr_body_graded(n, z, E, nu, &body);
    return medium_of(status, body, model, options, out);
}

static inline int medium_of_functions(mdr_function E, mdr_function nu, void *context, double depth, int model,
                                      const mdr_medium_options *options, mdr_medium **out)
{
    mdr_body *body = NULL;
    const int status = mdr_body_graded_function(E, nu, context, depth, &body);
    return medium_of(status, body, model, options, out);
}

static inline int medium_of_power(double E0, double z0, double exponent, double nu, mdr_medium **out)
{
    mdr_body *body = NULL;
    const int status = mdr_body_power_graded(E0, z0, exponent, nu, &body);
    return medium_of(status, body, MDR_MODEL_EXACT, NULL, out);
}

static inline int rigid_medium(mdr_medium **out)
{
    mdr_body *body = NULL;
    const int status = mdr_body_rigid(&body);
    return medium_of(status, body, MDR_MODEL_EXACT, NULL, out);
}

/* A half-space of one material. */
static inline int new_homogeneous(double E, double nu, mdr_medium **out)
{
    const mdr_layer half_space = mdr_isotropic(E, nu, 0.0);
    return medium_of_layers(0, NULL, &half_space, MDR_MODEL_EXACT, NULL, out);
}

/* One coating, on a rigid base where the substrate's E is INFINITY. */
static inline int new_coated(double E, double nu, double thickness, double substrate_E, double substrate_nu, int model,
                         const mdr_medium_options *options, mdr_medium **out)
{
    const mdr_layer film = mdr_isotropic(E, nu, thickness), base = mdr_isotropic(substrate_E, substrate_nu, 0.0);
    return medium_of_layers(1, &film, substrate_E == INFINITY ? NULL : &base, model, options, out);
}

/* Layers from the surface down. */
static inline int new_layered(int n, const double E[], const double nu[], const double thickness[], double substrate_E,
                          double substrate_nu, int model, const mdr_medium_options *options, mdr_medium **out)
{
    const mdr_layer base = mdr_isotropic(substrate_E, substrate_nu, 0.0);
    mdr_layer *layers = n > 0 ? malloc((size_t)n * sizeof *layers) : NULL;
    for (int i = 0; layers && i < n; i++) layers[i] = mdr_isotropic(E[i], nu[i], thickness[i]);
    const int status = medium_of_layers(n, layers, substrate_E == INFINITY ? NULL : &base, model, options, out);
    free(layers);
    return status;
}

/* States on unloading, by columns. */
APART int columns_of(const mdr_contact *c, int given, int n, const double in[], double d[], double a[], double F[],
                             double k[])
{
    mdr_state *states = malloc((size_t)(n > 0 ? n : 1) * sizeof *states);
    const int status = mdr_contact_states(c, given, MDR_ON_UNLOADING, n, in, states);
    for (int i = 0; states && status == MDR_SUCCESS && i < n; i++) {
        if (d) d[i] = states[i].depth;
        if (a) a[i] = states[i].radius;
        if (F) F[i] = states[i].force;
        if (k) k[i] = states[i].stiffness;
    }
    free(states);
    return status;
}

/* Where an adhesive contact breaks, by columns. */
APART int pull_off_of(const mdr_contact *c, int control, int capacity, double d[], double a[], double F[], int *count)
{
    int found = 0;
    mdr_state *states = malloc((size_t)(capacity > 0 ? capacity : 1) * sizeof *states);
    const int status = mdr_contact_pull_off(c, control, capacity, states, &found);
    for (int i = 0; states && status == MDR_SUCCESS && i < capacity && i < (found > 1 ? found : 1); i++) {
        if (d) d[i] = states[i].depth;
        if (a) a[i] = states[i].radius;
        if (F) F[i] = states[i].force;
    }
    if (status == MDR_SUCCESS && count) *count = found;
    free(states);
    return status;
}

/* What is read of a state once. */
APART int state_field(const mdr_contact *c, int field, const mdr_state *state, int n, const double r[], double out[])
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_field(load, field, n, r, out);
    MDR_FREE(load);
    return status;
}

APART int state_energy(const mdr_contact *c, const mdr_state *state, double *lower, double *upper)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_energy(load, lower, upper);
    MDR_FREE(load);
    return status;
}

APART int state_lowest_pressure(const mdr_contact *c, const mdr_state *state, double *pressure, double *r)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_lowest_pressure(load, pressure, r);
    MDR_FREE(load);
    return status;
}

APART int state_interior(const mdr_contact *c, int body, const mdr_state *state, int side, double friction, int n,
                         const double r[], const double z[], const double angle[], mdr_interior out[])
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_interior(load, body, side, friction, n, r, z, angle, out);
    MDR_FREE(load);
    return status;
}

APART int state_interior_error(const mdr_contact *c, int body, const mdr_state *state, double *deviation)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_interior_error(load, body, deviation);
    MDR_FREE(load);
    return status;
}

APART int state_layer_energies(const mdr_contact *c, int body, const mdr_state *state, int capacity, double out[], int *count)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_layer_energies(load, body, capacity, out, count);
    MDR_FREE(load);
    return status;
}

APART int state_critical(const mdr_contact *c, int body, const mdr_state *state, double friction, int capacity,
                         mdr_maximum out[], int *count)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_load_critical(load, body, friction, capacity, out, count);
    MDR_FREE(load);
    return status;
}

/* A state that is sheared. */
APART int shear_of(const mdr_contact *c, const mdr_friction *f, const mdr_state *state, int direction, mdr_shear **shear)
{
    mdr_load *load = NULL;
    int status = mdr_contact_load(c, state, &load);
    if (status == MDR_SUCCESS) status = mdr_shear_new(f, load, direction, shear);
    MDR_FREE(load);
    return status;
}

/* What happens to a state that is sheared for one call only. */
static inline int shear_states(const mdr_contact *c, const mdr_friction *f, const mdr_state *state, int direction, int given, int n,
                               const double in[], mdr_shear_state out[])
{
    mdr_shear *shear = NULL;
    int status = shear_of(c, f, state, direction, &shear);
    if (status == MDR_SUCCESS) status = mdr_shear_states(shear, given, n, in, out);
    MDR_FREE(shear);
    return status;
}

APART int shear_sliding(const mdr_contact *c, const mdr_friction *f, const mdr_state *state, int direction, double *shift,
                        double *force)
{
    mdr_shear *shear = NULL;
    mdr_shear_facts facts = MDR_SIZED(mdr_shear_facts);
    int status = shear_of(c, f, state, direction, &shear);
    if (status == MDR_SUCCESS) status = mdr_shear_about(shear, &facts);
    if (status == MDR_SUCCESS && shift) *shift = facts.sliding_shift;
    if (status == MDR_SUCCESS && force) *force = facts.sliding_force;
    MDR_FREE(shear);
    return status;
}

static inline int shear_field(const mdr_contact *c, const mdr_friction *f, const mdr_state *state, int direction,
                              const mdr_shear_state *at, int field, int n, const double r[], double out[])
{
    mdr_shear *shear = NULL;
    int status = shear_of(c, f, state, direction, &shear);
    if (status == MDR_SUCCESS) status = mdr_shear_field(shear, at, field, n, r, out);
    MDR_FREE(shear);
    return status;
}

static inline int shear_loop(const mdr_contact *c, const mdr_friction *f, const mdr_state *state, int direction, int given,
                             double amplitude, int n, double shift[], double force[], double *dissipated)
{
    mdr_shear *shear = NULL;
    int status = shear_of(c, f, state, direction, &shear);
    if (status == MDR_SUCCESS) status = mdr_shear_loop(shear, given, amplitude, n, shift, force, dissipated);
    MDR_FREE(shear);
    return status;
}

/* One state of a law. */
APART int law_point(const mdr_law *law, int given, int branch, double in, mdr_law_point *point)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr_law_point p = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const int status = mdr_law_values(law, given, branch, 1, &in, &p.depth, &p.radius, &p.force, &p.stiffness, &p.slope, &p.energy);
    if (status != MDR_SUCCESS) return status;
    if (given == MDR_FORCE && p.slope > 0.0) p.slope = 1.0 / p.slope;
    mdr_law_about(law, &facts);
    if (p.depth > facts.highest_depth) p.beyond = p.depth - facts.highest_depth;
    *point = p;
    return status;
}

#endif
