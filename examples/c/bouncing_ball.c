/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A steel ball of 1 mm radius bounces on a painted plate: a time-stepping code that takes its contact force from a compiled law,
 * once per step and contact. Printed: depth and force every so often, and the balance of energy, which nothing but the time step can spoil.
 *
 * With the name of a file as argument the law is saved there, for impact_of_deck.c and examples/legacy/impact.f.
 *
 * SI units. Steel ball, density 7850 kg/m^3, 0.1 m/s, rigid; epoxy paint E = 3 GPa, nu = 0.35, 25 um thick; aluminium E = 70 GPa,
 * nu = 0.33 (handbook values).
 */
#include <mdrcontact.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
        exit(EXIT_FAILURE);
    }
}

/* The exact solution of the painted plate, compiled: some fifty contact states solved here, none in the time loop. */
static mdr_law *painted_plate(double ball_radius, double largest_depth)
{
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *plate = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    mdr_law_options options;

    options = MDR_SIZED(mdr_law_options);
    options.description = "steel ball R = 1 mm on 25 um epoxy on aluminium, SI units";
    check(mdr_profile_paraboloid(ball_radius, &ball));
    const mdr_layer coating = mdr_isotropic(3e9, 0.35, 25e-6), base = mdr_isotropic(70e9, 0.33, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &plate));
    check(mdr_free(body));
    check(mdr_contact_new(ball, plate, NULL, &contact));
    check(mdr_law_new(contact, largest_depth, &options, &law));
    check(mdr_free(contact));
    check(mdr_free(plate));
    check(mdr_free(ball));
    return law;
}

int main(int argc, char *argv[])
{
    const double pi = acos(-1.0), radius = 1e-3, gravity = 9.81, step = 2e-8;
    const double mass = 4.0 / 3.0 * pi * radius * radius * radius * 7850.0;
    mdr_law *law = painted_plate(radius, 20e-6);
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double d = -1e-6, v = 0.1, force = 0.0, work = 0.0, deepest = 0.0, strongest = 0.0;
    int steps = 0, in_contact = 0;

    if (argc > 1) check(mdr_law_save(law, argv[1]));
    check(mdr_law_about(law, &facts));
    printf("law from %d contact states, relative error %.0e\n", facts.solutions, facts.error);
    const double energy_before = 0.5 * mass * v * v;

    /* Velocity Verlet; d grows into the plate. */
    while (d > -1.1e-6) {
        const double force_before = force, d_before = d;
        v += 0.5 * step * (gravity - force / mass);
        d += step * v;
        check(mdr_law_force(law, MDR_ON_UNLOADING, d, &force, NULL));
        v += 0.5 * step * (gravity - force / mass);
        work += 0.5 * (force_before + force) * (d - d_before);
        if (d > deepest) deepest = d;
        if (force > strongest) strongest = force;
        if (force > 0.0) in_contact++;
        if (steps++ % 500 == 0) printf("t = %6.1f us   d = %7.3f um   F = %8.5f N\n", 1e6 * steps * step, 1e6 * d, force);
    }
    const double energy_after = 0.5 * mass * v * v - mass * gravity * (d + 1e-6);

    printf("contact lasts %.1f us, depth %.3f um, force %.4f N\n", 1e6 * in_contact * step, 1e6 * deepest, strongest);
    printf("rebound %.9f m/s\n", -v);
    printf("energy: before %.6e J, after %.6e J, relative difference %.1e\n", energy_before, energy_after,
           energy_after / energy_before - 1.0);
    printf("work of the contact force over the whole impact, relative: %.1e\n", work / energy_before);
    check(mdr_free(law));
    return fabs(energy_after / energy_before - 1.0) < 1e-6 ? EXIT_SUCCESS : EXIT_FAILURE;
}
