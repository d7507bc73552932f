/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An extension of the installed library: how far a flat punch slides until its pressure is that of the end, l = a/(2.060650 k E*). */
#include <mdrcontact/wear.h>

#include <math.h>
#include <stdio.h>

int main(void)
{
    const double coefficient = 1e-3, expected = 2.0 / (2.060650 * coefficient * 3.0);
    double length = 0.0;
    mdr_profile *punch = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_wear *wear = NULL;

    if (mdr_profile_flat_punch(2.0, &punch) != MDR_SUCCESS
        || mdr_medium_contact_modulus(3.0, &medium) != MDR_SUCCESS
        || mdr_contact_new(punch, medium, NULL, &contact) != MDR_SUCCESS
        || mdr_wear_new(contact, 1, &coefficient, NULL, 0.0, &wear) != MDR_SUCCESS
        || mdr_wear_running_in(wear, MDR_FORCE, &length) != MDR_SUCCESS) {
        fprintf(stderr, "%s\n", mdr_last_error());
        return 1;
    }
    MDR_FREE(wear);
    MDR_FREE(contact);
    MDR_FREE(medium);
    MDR_FREE(punch);
    if (!(fabs(length - expected) < 1e-6 * expected)) {
        fprintf(stderr, "length %.17g, expected %.17g\n", length, expected);
        return 1;
    }
    printf("wear: 1 of 1 checks passed\n");
    return 0;
}
