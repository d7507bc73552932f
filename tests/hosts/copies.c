/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A host that contains the static library and loads the shared one as a plugin does: each refuses the handles of the other. */
#include "../c/check.h"

#include <dlfcn.h>

int main(int count, char **arguments)
{
    void *library = count == 2 ? dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    int (*make)(double, mdr_profile **) = NULL, (*release)(void *) = NULL, (*force)(const mdr_law *, int, double, double *, double *) = NULL;
    const char *(*text)(void) = NULL;
    const mdr_layer steel = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_profile *own = NULL, *others = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    double F = 0.0;

    CHECK_TRUE(library != NULL);
    if (!library) return check_report("copies");
    *(void **)&make = dlsym(library, "mdr_profile_paraboloid");
    *(void **)&release = dlsym(library, "mdr_free");
    *(void **)&force = dlsym(library, "mdr_law_force");
    *(void **)&text = dlsym(library, "mdr_last_error");
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &own));
    CHECK_INT(make(1.0, &others), MDR_SUCCESS);
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &steel, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_STATUS(mdr_contact_new(others, medium, NULL, &contact), MDR_EINVALID, "another copy of the library");
    CHECK_STATUS(mdr_free(others), MDR_EINVALID, "another copy of the library");
    CHECK_INT(release(own), MDR_EINVALID);
    CHECK_TRUE(strstr(text(), "another copy of the library") != NULL);
    CHECK_SUCCESS(mdr_contact_new(own, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_law_new(contact, 0.1, NULL, &law));
    CHECK_INT(force(law, MDR_ON_UNLOADING, 0.05, &F, NULL), MDR_EINVALID);
    CHECK_SUCCESS(mdr_law_force(law, MDR_ON_UNLOADING, 0.05, &F, NULL));
    CHECK_INT(release(others), MDR_SUCCESS);
    CHECK_FREE(law);
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(own);
    return check_report("copies");
}
