/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of mdrcontact/plastic.h that compute: each in the library's arithmetic. Written by tools/generate.py. */
#include "../base/arithmetic.h"
#include "mdrcontact/plastic.h"
#include "refuse.h"

int mdrcontact_entry_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth,
        mdr_imprint **out);
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out)
{
    if (!out) return mdrcontact_refuse_null("out");
    if (arithmetic_is_set()) return mdrcontact_entry_imprint_two_terms(medium, radius, uniform, hertz, depth, out);
    fenv_t callers;
    mdrcontact_set_arithmetic(&callers);
    const int status = mdrcontact_entry_imprint_two_terms(medium, radius, uniform, hertz, depth, out);
    mdrcontact_set_arithmetic_back(&callers);
    return status;
}
