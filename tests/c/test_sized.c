/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Programs that were compiled with the header of an older or a newer library: their structures that grow are shorter or longer. The
 * library reads and writes what both know and nothing beside it, whatever stands there.
 */
#include "check.h"

#include <stdint.h>
#include "mdrcontact/all.h"

enum { GUARD = 64, CANARY = 0x5a, LONGER = 24 };

/* What a program of another version has of a structure, with guards around it. */
typedef struct other_version {
    size_t size;
    unsigned char *memory;
} other_version;

static other_version version_of(const void *known, size_t full, size_t size)
{
    other_version v = {size, malloc(size + 2 * GUARD)};
    memset(v.memory, CANARY, size + 2 * GUARD);
    memset(v.memory + GUARD, 0, size);
    memcpy(v.memory + GUARD, known, size < full ? size : full);
    memcpy(v.memory + GUARD, &size, sizeof size);
    return v;
}

static void *content(const other_version *v) { return v->memory + GUARD; }

static void done(other_version *v)
{
    size_t size;
    for (int i = 0; i < GUARD; i++) {
        CHECK_INT(v->memory[i], CANARY);
        CHECK_INT(v->memory[GUARD + v->size + (size_t)i], CANARY);
    }
    memcpy(&size, content(v), sizeof size);
    CHECK_TRUE(size == v->size);
    free(v->memory);
}

typedef struct objects {
    mdr_profile *ball;
    mdr_medium *film;
    mdr_contact *contact;
    mdr_friction *friction;
    mdr_law *law;
    mdr_loop *loop;
    mdr_shear *shear;
#ifdef MDRCONTACT_WEAR_H
    mdr_wear *wear;
#endif
} objects;

/* Each use gives a structure of another version to the library. */
typedef int (*use)(const objects *o, void *structure);

static int use_medium(const objects *o, void *structure)
{
    const mdr_layer film = mdr_isotropic(2.0, 0.3, 1.0), base = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_body *body = NULL;
    mdr_medium *m = NULL;
    (void)o;
    int status = mdr_body_layered(1, &film, &base, NULL, &body);
    if (status == MDR_SUCCESS) status = mdr_medium_new(body, structure, &m);
    MDR_FREE(m);
    MDR_FREE(body);
    return status;
}

static int use_contact(const objects *o, void *structure)
{
    mdr_contact *c = NULL;
    const int status = mdr_contact_new(o->ball, o->film, structure, &c);
    MDR_FREE(c);
    return status;
}

static int use_law(const objects *o, void *structure)
{
    mdr_law *law = NULL;
    const int status = mdr_law_new(o->contact, 0.1, structure, &law);
    MDR_FREE(law);
    return status;
}

#ifdef MDRCONTACT_LATERAL_H
static int use_structure(const objects *o, void *structure)
{
    mdr_structure *s = NULL;
    (void)o;
    const int status = mdr_structure_shapes(1.0, 0.3, 0, NULL, NULL, NULL, NULL, structure, &s);
    MDR_FREE(s);
    return status;
}
#endif

#ifdef MDRCONTACT_FIT_H
static int use_problem(const objects *o, void *structure)
{
    int count, status;
    (void)o;
    status = mdr_fit_parameters(structure, 0, NULL, &count);
    /* it was read, and names no indenter */
    return status == MDR_ENULL ? MDR_SUCCESS : status;
}
#endif

static int use_model_facts(const objects *o, void *structure)
{
    (void)o;
    return mdr_model_info(MDR_MODEL_EXACT, structure);
}

static int use_law_facts(const objects *o, void *structure) { return mdr_law_about(o->law, structure); }

static int use_failure(const objects *o, void *structure)
{
    (void)o;
    return mdr_last_failure(structure);
}

#ifdef MDRCONTACT_FIT_H
static int use_summary(const objects *o, void *structure)
{
    static const double d[4] = {0.1, 0.2, 0.3, 0.4}, F[4] = {1.0, 3.0, 5.0, 8.0};
    mdr_fit_parameter parameters[30];
    mdr_fit_problem problem = MDR_SIZED(mdr_fit_problem);
    problem.profile = o->ball;
    problem.medium = o->film;
    problem.parameters = parameters;
    CHECK_SUCCESS(mdr_fit_parameters(&problem, 30, parameters, &problem.parameter_count));
    parameters[0].lower = 0.1, parameters[0].upper = 100.0, parameters[0].is_free = 1;
    return mdr_fit_solve(&problem, 4, d, F, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, structure);
}
#endif

static int use_loop_facts(const objects *o, void *structure) { return mdr_loop_about(o->loop, structure); }

static int use_shear_facts(const objects *o, void *structure) { return mdr_shear_about(o->shear, structure); }

#ifdef MDRCONTACT_WEAR_H
static int use_wear_options(const objects *o, void *structure)
{
    mdr_wear_history *h = NULL;
    const int status = mdr_wear_history_new(o->wear, MDR_DEPTH, 0.1, structure, &h);
    MDR_FREE(h);
    return status;
}
#endif

#ifdef MDRCONTACT_PLASTIC_H
static int use_imprint_facts(const objects *o, void *structure)
{
    mdr_medium *base = NULL;
    mdr_imprint *imprint = NULL;
    int status = mdr_medium_contact_modulus(1.0, &base);
    (void)o;
    if (status == MDR_SUCCESS) status = mdr_imprint_two_terms(base, 0.5, 0.1, 0.2, 0.3, &imprint);
    if (status == MDR_SUCCESS) status = mdr_imprint_about(imprint, structure);
    MDR_FREE(imprint);
    MDR_FREE(base);
    return status;
}
#endif

#ifdef MDRCONTACT_PLASTIC_H
/* The law of a ball that yields, with these options, and its properties where there is room for them. */
static int make_plastic_law(const objects *o, const mdr_plastic_law_options *options, mdr_plastic_law_facts *facts)
{
    static const double strain = 0.0, stress = 0.01;
    mdr_yielding *metal = NULL;
    mdr_plastic_law *law = NULL;
    int status = mdr_yielding_new(1.0, 0.3, 1, &strain, &stress, &metal);
    if (status == MDR_SUCCESS) status = mdr_plastic_law_new(o->ball, metal, 0.01, options, &law);
    if (status == MDR_SUCCESS && facts) status = mdr_plastic_law_about(law, facts);
    MDR_FREE(law);
    MDR_FREE(metal);
    return status;
}

static int use_plastic_options(const objects *o, void *structure) { return make_plastic_law(o, structure, NULL); }

static int use_plastic_facts(const objects *o, void *structure) { return make_plastic_law(o, NULL, structure); }
#endif

/* Success where a structure was read and refused for this member of it alone, which is required and 0. */
static int lacks_only(int status, const char *member)
{
    return status == MDR_EINVALID && strstr(mdr_last_error(), member) ? MDR_SUCCESS : status;
}

#ifdef MDRCONTACT_ADHESION_H
static int use_rate_options(const objects *o, void *structure)
{
    (void)o;
    return lacks_only(mdr_rate_work(structure, 0, NULL, NULL, NULL, NULL), "work = 0");
}
#endif

static int use_layer(const objects *o, void *structure)
{
    mdr_medium *m = NULL;
    (void)o;
    const int status = medium_of_layers(0, NULL, structure, MDR_MODEL_EXACT, NULL, &m);
    MDR_FREE(m);
    return lacks_only(status, "E = 0");
}

static int use_surface(const objects *o, void *structure)
{
    const mdr_layer half_space = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_body *body = NULL;
    (void)o;
    const int status = mdr_body_layered(0, NULL, &half_space, structure, &body);
    MDR_FREE(body);
    return status;
}

static void every_size(const objects *o, use function, const void *known, size_t full, int is_filled)
{
    for (size_t size = sizeof(size_t); size <= full + LONGER; size += size < full && full - size < 8 ? full - size : 8) {
        other_version v = version_of(known, full, size);
        CHECK_SUCCESS(function(o, content(&v)));
        /* what the library does not know stays 0, what it fills begins behind the size */
        for (size_t i = full; i < size; i++) CHECK_INT(((unsigned char *)content(&v))[i], 0);
        if (!is_filled && size > sizeof size) {
            const size_t both = (size < full ? size : full) - sizeof size;
            CHECK_TRUE(memcmp((unsigned char *)content(&v) + sizeof size, (const unsigned char *)known + sizeof size, both) == 0);
        }
        done(&v);
    }
    if (function == use_failure) return;
    other_version newer = version_of(known, full, full + LONGER);
    ((unsigned char *)content(&newer))[full + LONGER - 1] = 1;
    CHECK_STATUS(function(o, content(&newer)), MDR_EINVALID, "the header of the program is newer");
    done(&newer);
}

#define EVERY_SIZE(function, type, is_filled) \
    do { \
        const type known = MDR_SIZED(type); \
        every_size(&o, function, &known, sizeof known, is_filled); \
    } while (0)

/* Layers of a program of a newer version lie further apart, and their new members are 0. */
static void layers_have_a_stride(void)
{
    enum { COUNT = 3 };
    static const double a[1] = {1.0};
    const size_t size = sizeof(mdr_layer) + LONGER;
    const mdr_layer base = mdr_isotropic(1.0, 0.3, 0.0);
    unsigned char *const apart = calloc(COUNT, size);
    mdr_layer layers[COUNT];
    double close_by, far_apart;
    mdr_medium *m = NULL;
    for (int i = 0; i < COUNT; i++) {
        layers[i] = mdr_isotropic(2.0 + i, 0.3, 0.5);
        memcpy(apart + (size_t)i * size, &layers[i], sizeof layers[i]);
        memcpy(apart + (size_t)i * size, &size, sizeof size);
    }
    CHECK_SUCCESS(medium_of_layers(COUNT, layers, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, &close_by));
    MDR_FREE(m);
    CHECK_SUCCESS(medium_of_layers(COUNT, (const mdr_layer *)(const void *)apart, &base, MDR_MODEL_EXACT, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, &far_apart));
    MDR_FREE(m);
    CHECK_CLOSE(far_apart, close_by, 0.0);
    free(apart);
}

/* A shorter structure gets what it has room for. */
static void what_is_known_is_written(const objects *o)
{
    mdr_law_facts all = MDR_SIZED(mdr_law_facts), few = all;
    CHECK_SUCCESS(mdr_law_about(o->law, &all));
    CHECK_TRUE(all.highest_depth >= 0.1 && all.segments == 1);
    few.size = offsetof(mdr_law_facts, tolerance);
    CHECK_SUCCESS(mdr_law_about(o->law, &few));
    CHECK_TRUE(few.highest_force == all.highest_force && few.tolerance == 0.0 && few.segments == 0);
    CHECK_STATUS(mdr_law_about(o->law, &(mdr_law_facts){0}), MDR_EINVALID, "facts->size = 0");
    mdr_failure failure = MDR_SIZED(mdr_failure);
    CHECK_SUCCESS(mdr_last_failure(&failure));
    CHECK_INT(failure.status, MDR_EINVALID);
    CHECK_INT(mdr_last_failure(NULL), MDR_ENULL);
    CHECK_INT(mdr_last_failure(&(mdr_failure){0}), MDR_EINVALID);
    CHECK_INT(mdr_last_failure(&(mdr_failure){.size = 9}), MDR_EINVALID);
    CHECK_INT(mdr_last_failure(&(mdr_failure){.size = SIZE_MAX}), MDR_EINVALID);
    {
        static union {
            mdr_failure failure;
            char bytes[4100];
        } large = {.failure = {.size = sizeof large}};
        CHECK_INT(mdr_last_failure(&large.failure), MDR_EINVALID);
    }
}

/* 0 is the default; where it is a value, too, that has to be said. */
static void defaults(void)
{
    static const double a[1] = {1.0};
    const double p[4] = {-0.65, -0.65, 0.0, 0.3};
    double none, found[4];
    mdr_medium *m = NULL;
    CHECK_SUCCESS(new_coated(9.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO_POWER, NULL, &m));
    CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, &none));
    MDR_FREE(m);
    for (int i = 0; i < 4; i++) {
        mdr_medium_options options = MDR_SIZED(mdr_medium_options);
        options.exponent = i == 0 ? 0.0 : p[i];
        options.exponent_is_given = i == 2;
        CHECK_SUCCESS(new_coated(9.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO_POWER, &options, &m));
        CHECK_SUCCESS(mdr_medium_values(m, MDR_MODULUS, 1, a, &found[i]));
        MDR_FREE(m);
    }
    CHECK_CLOSE(found[0], none, 0.0);
    CHECK_CLOSE(found[1], none, 0.0);
    CHECK_TRUE(found[2] > found[1] && found[3] > found[2]);
}

int main(void)
{
    static const double depth = 0.1;
    objects o = {0};
    mdr_state state;
    mdr_medium *base = NULL;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &o.ball));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &base));
    CHECK_SUCCESS(new_coated(2.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO, NULL, &o.film));
    CHECK_SUCCESS(mdr_contact_new(o.ball, base, NULL, &o.contact));
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    CHECK_SUCCESS(mdr_friction_new(o.contact, 0.3, &o.friction));
    options.friction = o.friction;
    CHECK_SUCCESS(mdr_law_new(o.contact, 0.1, &options, &o.law));
    CHECK_SUCCESS(mdr_contact_states(o.contact, MDR_DEPTH, MDR_ON_LOADING, 1, &depth, &state));
    CHECK_SUCCESS(shear_of(o.contact, o.friction, &state, MDR_ALONG, &o.shear));
#ifdef MDRCONTACT_WEAR_H
    CHECK_SUCCESS(mdr_wear_new(o.contact, 1, (const double[]){1e-3}, NULL, 0.0, &o.wear));
#endif
    mdr_contact_options adhesive = MDR_SIZED(mdr_contact_options);
    mdr_contact *sticky = NULL;
    adhesive.work_of_adhesion = 0.01;
    CHECK_SUCCESS(mdr_contact_new(o.ball, base, &adhesive, &sticky));
    CHECK_SUCCESS(mdr_loop_new(sticky, MDR_DEPTH, depth, 10, 0.0, &o.loop));
    MDR_FREE(sticky);
    EVERY_SIZE(use_medium, mdr_medium_options, 0);
    EVERY_SIZE(use_contact, mdr_contact_options, 0);
    EVERY_SIZE(use_law, mdr_law_options, 0);
    EVERY_SIZE(use_model_facts, mdr_model_facts, 1);
    EVERY_SIZE(use_law_facts, mdr_law_facts, 1);
    EVERY_SIZE(use_failure, mdr_failure, 1);
    EVERY_SIZE(use_loop_facts, mdr_loop_facts, 1);
    EVERY_SIZE(use_shear_facts, mdr_shear_facts, 1);
    EVERY_SIZE(use_layer, mdr_layer, 0);
    EVERY_SIZE(use_surface, mdr_surface, 0);
#ifdef MDRCONTACT_ADHESION_H
    EVERY_SIZE(use_rate_options, mdr_rate_options, 0);
#endif
#ifdef MDRCONTACT_WEAR_H
    EVERY_SIZE(use_wear_options, mdr_wear_options, 0);
    MDR_FREE(o.wear);
#endif
#ifdef MDRCONTACT_PLASTIC_H
    EVERY_SIZE(use_imprint_facts, mdr_imprint_facts, 1);
    EVERY_SIZE(use_plastic_options, mdr_plastic_law_options, 0);
    EVERY_SIZE(use_plastic_facts, mdr_plastic_law_facts, 1);
#endif
#ifdef MDRCONTACT_LATERAL_H
    EVERY_SIZE(use_structure, mdr_structure_options, 0);
#endif
#ifdef MDRCONTACT_FIT_H
    EVERY_SIZE(use_problem, mdr_fit_problem, 0);
    EVERY_SIZE(use_summary, mdr_fit_summary, 1);
#endif
    layers_have_a_stride();
    what_is_known_is_written(&o);
    defaults();
    MDR_FREE(o.loop);
    MDR_FREE(o.shear);
    MDR_FREE(o.friction);
    MDR_FREE(o.law);
    MDR_FREE(o.contact);
    MDR_FREE(o.film);
    MDR_FREE(base);
    MDR_FREE(o.ball);
    return check_report("structures that grow");
}
