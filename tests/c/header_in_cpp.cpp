// SPDX-License-Identifier: GPL-3.0-or-later
// The headers compile as C++ and their functions link.
#include "mdrcontact_law.h"

int main()
{
    mdr_profile *p = nullptr;
    if (mdr_profile_paraboloid(1.0, &p) != MDR_SUCCESS || mdr_isotropic(1.0, 0.3, 2.0).E != 1.0) return 1;
    MDR_FREE(p);
    mdr_law_view view;
    if (mdr_law_view_from(nullptr, MDR_ON_UNLOADING, &view) != MDR_ENULL) return 1;
    const mdr_law_options options = MDR_SIZED(mdr_law_options);
    if (options.size != sizeof options || options.tolerance != 0.0 || options.description != nullptr) return 1;
    return p == nullptr ? 0 : 1;
}
