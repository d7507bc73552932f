/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The whole C API, driven by bytes: objects are made, evaluated and freed with every kind of number. */
#include "world.h"

#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void (*const families[])(world *) = {
    fuzz_profiles, fuzz_media, fuzz_contacts, fuzz_states, fuzz_fields, fuzz_adhesion, fuzz_laws, fuzz_structures, fuzz_fits,
    fuzz_formulas, fuzz_inside, fuzz_friction, fuzz_shear, fuzz_time, fuzz_wide_fits, fuzz_lists, fuzz_gels,
    fuzz_conduction, fuzz_rates, fuzz_wear, fuzz_plastic
};
enum { FAMILIES = sizeof families / sizeof families[0], MOST_CALLS = 40 };

/* Families came in goes: bytes mean what they meant before to all inputs that are kept, but for the highest, which the next byte
   shares out. */
static int family_of(input *in)
{
    const int byte = take_byte(in);
    enum { FIRST = 10, SECOND = 12, THIRD = 16, FOURTH = 20 };
    enum { FIRST_BYTES = 240, SECOND_BYTES = 244, THIRD_BYTES = 255, FOURTH_BYTES = 192 };
    if (byte < FIRST_BYTES) return byte % FIRST;
    if (byte < SECOND_BYTES) return FIRST + byte % (SECOND - FIRST);
    if (byte < THIRD_BYTES) return SECOND + byte % (THIRD - SECOND);
    const int next = take_byte(in);
    if (next < FOURTH_BYTES) return THIRD + next % (FOURTH - THIRD);
    return FOURTH + next % (FAMILIES - FOURTH);
}

static void free_all(world *w)
{
    for (int i = 0; i < SLOTS; i++) {
        void *const handles[] = {w->contacts[i], w->media[i], w->profiles[i], w->materials[i]};
        for (int k = 0; k < 4; k++) {
            const int status = mdr_free(handles[k]);
            judge_status("mdr_free", status);
            if (status != MDR_SUCCESS) finding("mdr_free", "does not free", k);
        }
    }
    MDR_FREE(w->loop);
    MDR_FREE(w->law);
    MDR_FREE(w->structure);
    MDR_FREE(w->friction_law);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    world w;
    memset(&w, 0, sizeof w);
    w.in.bytes = data;
    w.in.size = size;
    for (int i = 0; i < MOST_CALLS && w.in.next < size; i++) families[family_of(&w.in)](&w);
    free_all(&w);
    return 0;
}
