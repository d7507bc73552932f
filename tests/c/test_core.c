/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the core says of handles that only an extension can use, whether the library has the extension or not. */
#include "check.h"

int main(void)
{
    static const double depth = 0.1;
    mdr_profile *ball = NULL;
    mdr_medium *base = NULL, *soft = NULL;
    mdr_material *rubber = NULL;
    mdr_contact *contact = NULL, *relaxing = NULL;
    mdr_law *law = NULL;
    mdr_friction *friction = NULL;
    mdr_state state = {0};

    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &base));
    CHECK_SUCCESS(mdr_contact_new(ball, base, NULL, &contact));
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.conduction = (const struct mdr_conduction *)ball;
    CHECK_STATUS(mdr_law_new(contact, 0.1, &options, &law),
                 MDR_EINVALID, "options.conduction: it is not a handle of type mdr_conduction");
    CHECK_TRUE(law == NULL);

    /* a contact with a body that relaxes has histories in place of states */
    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 1, (double[]){2.0}, (double[]){0.5}, 0.0, 0.5, 0.0, &rubber));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, rubber, MDR_MODEL_EXACT, NULL, &soft));
    CHECK_SUCCESS(mdr_contact_new(ball, soft, NULL, &relaxing));
    CHECK_STATUS(mdr_contact_states(relaxing, MDR_DEPTH, MDR_ON_UNLOADING, 1, &depth, &state), MDR_EINVALID, "viscoelastic");
    CHECK_STATUS(mdr_law_new(relaxing, 0.1, NULL, &law), MDR_EINVALID, "viscoelastic");
    CHECK_STATUS(mdr_friction_new(relaxing, 0.3, &friction), MDR_EINVALID, "viscoelastic");
    CHECK_TRUE(law == NULL && friction == NULL && state.radius == 0.0);

    CHECK_FREE(relaxing);
    CHECK_FREE(soft);
    CHECK_FREE(rubber);
    CHECK_FREE(contact);
    CHECK_FREE(base);
    CHECK_FREE(ball);
    return check_report("core");
}
