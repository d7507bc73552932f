/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A diamond-like sphere of 10 um radius pressed into 500 nm of thermal oxide on silicon: depth, contact radius, stiffness and
 * pressure under forces that an experimenter sets, by the exact solution and by three approximate models of the coating.
 *
 * Units of this program: nm, GPa, and hence nN (1 GPa nm^2 = 1 nN). The library takes any consistent set.
 * SiO2: E = 72 GPa, nu = 0.17 (Oliver, Pharr, J. Mater. Res. 7 (1992) 1564, fused silica); Si: isotropic average
 * E = 163 GPa, nu = 0.22 (after Hopcroft, Nix, Kenny, J. Microelectromech. Syst. 19 (2010) 229).
 */
#include <mdrcontact.h>

#include <stdio.h>
#include <stdlib.h>

/* One place that looks at every status: prints the library's own words and ends the program. */
static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
        exit(EXIT_FAILURE);
    }
}

static mdr_contact *sphere_on_oxide(int model)
{
    mdr_profile *sphere = NULL;
    mdr_body *body = NULL;
    mdr_medium *coated = NULL;
    mdr_medium_options options = MDR_SIZED(mdr_medium_options);
    mdr_contact *contact = NULL;

    check(mdr_profile_sphere(10000.0, &sphere));
    const mdr_layer coating = mdr_isotropic(72.0, 0.17, 500.0), base = mdr_isotropic(163.0, 0.22, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    options.model = model;
    check(mdr_medium_new(body, &options, &coated));
    check(mdr_free(body));
    check(mdr_contact_new(sphere, coated, NULL, &contact));
    check(mdr_free(coated)); /* the contact has its own copies */
    check(mdr_free(sphere));
    return contact;
}

int main(void)
{
    enum { COUNT = 6, MODELS = 4 };
    const int models[MODELS] = {MDR_MODEL_EXACT, MDR_MODEL_GAO, MDR_MODEL_GAO_SERIES, MDR_MODEL_PERRIOT_BARTHEL};
    const char *names[MODELS] = {"exact", "Gao, parallel", "Gao, series", "Perriot-Barthel"};
    const double force[COUNT] = {1e3, 1e4, 1e5, 1e6, 2e6, 5e6};
    mdr_state state[COUNT];
    double pressure[1];
    const double middle[1] = {0.0};

    for (int i = 0; i < MODELS; i++) {
        mdr_contact *contact = sphere_on_oxide(models[i]);
        check(mdr_contact_states(contact, MDR_FORCE, MDR_ON_UNLOADING, COUNT, force, state));
        printf("%s\n%12s %12s %12s %16s %20s\n", names[i], "force, mN", "depth, nm", "radius, nm", "stiffness, N/m",
               "pressure at 0, GPa");
        for (int j = 0; j < COUNT; j++) {
            mdr_load *load = NULL;
            check(mdr_contact_load(contact, &state[j], &load));
            check(mdr_load_field(load, MDR_PRESSURE, 1, middle, pressure));
            check(mdr_free(load));
            printf("%12.4f %12.3f %12.2f %16.1f %20.4f\n", state[j].force * 1e-6, state[j].depth, state[j].radius,
                   state[j].stiffness, pressure[0]);
        }
        check(mdr_free(contact));
    }
    return EXIT_SUCCESS;
}
