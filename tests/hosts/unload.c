/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that loads the library as a plugin, computes on several threads, and unloads it, many times: threads of OpenMP wait in its
 * runtime for more work after the last call. The host itself is not linked with the library.
 */
#define _DEFAULT_SOURCE /* usleep */
#include "check_host.h"
#include "mdrcontact.h"

#include <dlfcn.h>
#include <unistd.h>

enum { CYCLES = 40, COUNT = 64 };

/* The function of a name, of the type of its declaration. */
#define GET(library, name) *(void **)&name##_ = dlsym(library, #name); CHECK(name##_ != NULL)

static void compute(void *library)
{
    int (*mdr_set_threads_)(int), (*mdr_profile_cone_)(double, mdr_profile **), (*mdr_free_)(void *);
    int (*mdr_body_layered_)(int, const mdr_layer *, const mdr_layer *, const mdr_surface *, mdr_body **);
    int (*mdr_medium_new_)(const mdr_body *, const mdr_medium_options *, mdr_medium **);
    int (*mdr_contact_new_)(const mdr_profile *, const mdr_medium *, const mdr_contact_options *, mdr_contact **);
    int (*mdr_contact_states_)(const mdr_contact *, int, int, int, const double[], mdr_state[]);
    const mdr_layer film = mdr_isotropic(10.0, 0.2, 0.5), below = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_profile *cone = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    double depths[COUNT];
    mdr_state states[COUNT];

    GET(library, mdr_set_threads);
    GET(library, mdr_profile_cone);
    GET(library, mdr_body_layered);
    GET(library, mdr_medium_new);
    GET(library, mdr_contact_new);
    GET(library, mdr_contact_states);
    GET(library, mdr_free);
    for (int i = 0; i < COUNT; i++) depths[i] = 0.01 * (i + 1);
    CHECK(mdr_set_threads_(3) == MDR_SUCCESS);
    CHECK(mdr_profile_cone_(0.3, &cone) == MDR_SUCCESS);
    CHECK(mdr_body_layered_(1, &film, &below, NULL, &body) == MDR_SUCCESS);
    CHECK(mdr_medium_new_(body, NULL, &medium) == MDR_SUCCESS);
    CHECK(mdr_contact_new_(cone, medium, NULL, &contact) == MDR_SUCCESS);
    CHECK(mdr_contact_states_(contact, MDR_DEPTH, MDR_ON_UNLOADING, COUNT, depths, states) == MDR_SUCCESS);
    CHECK(states[COUNT - 1].force > states[0].force);
    CHECK(mdr_free_(contact) == MDR_SUCCESS && mdr_free_(medium) == MDR_SUCCESS);
    CHECK(mdr_free_(body) == MDR_SUCCESS && mdr_free_(cone) == MDR_SUCCESS);
}

int main(int count, char **arguments)
{
    for (int i = 0; i < CYCLES && count == 2; i++) {
        void *library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
        CHECK(library != NULL);
        if (!library) break;
        compute(library);
        CHECK(dlclose(library) == 0);
        usleep(2000);
    }
    return host_report("unload");
}
