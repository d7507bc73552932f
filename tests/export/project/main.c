/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hertz's force through the installed library. */
#include <mdrcontact.h>
#include <mdrcontact/all.h>

#include <math.h>
#include <stdio.h>

int main(void)
{
    const double depth[1] = {0.5}, expected = 4.0 * sqrt(2.0) * pow(0.5, 1.5);
    mdr_state state = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    mdr_profile *profile = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;

    if (mdr_version() != 10000 * MDR_VERSION_MAJOR + 100 * MDR_VERSION_MINOR + MDR_VERSION_PATCH
        || mdr_profile_paraboloid(2.0, &profile) != MDR_SUCCESS
        || mdr_medium_contact_modulus(3.0, &medium) != MDR_SUCCESS
        || mdr_contact_new(profile, medium, NULL, &contact) != MDR_SUCCESS
        || mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, 1, depth, &state) != MDR_SUCCESS) {
        fprintf(stderr, "%s\n", mdr_last_error());
        return 1;
    }
    MDR_FREE(contact);
    MDR_FREE(medium);
    MDR_FREE(profile);
    if (!(fabs(state.force - expected) < 1e-12 * expected)) {
        fprintf(stderr, "force %.17g, expected %.17g\n", state.force, expected);
        return 1;
    }
    printf("C: 2 checks passed\n");
    return 0;
}
