// SPDX-License-Identifier: GPL-3.0-or-later
// The header compiles as C++ and its functions link.
#include "mdrcontact.h"

int main()
{
    mdr_profile *p = nullptr;
    if (mdr_profile_paraboloid(1.0, &p) != MDR_SUCCESS || mdr_profile_free(&p) != MDR_SUCCESS) return 1;
    return p == nullptr ? 0 : 1;
}
