/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that saves and restores the past of contacts in other objects of the same numbers, in units from 1e-9 to 1e9: what is valid
 * is accepted and continues bitwise as if it had never been saved; what is altered, or of another contact, is refused.
 */
#include "../c/check.h"
#include "forge.h"
#include "mdrcontact/all.h"

enum { CASES = 60, MOST = 4000, MOST_MEMORY = 300 };

static const double wild_numbers[] = {-1.0, 1e300, 1.6e155, -1e300, 1e-300, 4503599627370497.0, INFINITY, NAN};
enum { WILD = sizeof wild_numbers / sizeof *wild_numbers };

static double saved[MOST], altered[MOST];
static int compared, refused;

/* The numbers of a contact: units of length and modulus, shape, body. */
typedef struct plan {
    double L, M, size, angle, film, thickness, nu;
    int shape, layers;
} plan;

static plan draw_plan(int shapes)
{
    plan p;
    p.L = draw_decades(-9.0, 9.0);
    p.M = draw_decades(-9.0, 9.0);
    p.size = p.L * draw_decades(-1.0, 1.0);
    p.angle = draw_between(0.05, 1.2);
    p.film = p.M * draw_decades(-1.5, 1.5);
    p.thickness = p.L * draw_decades(-1.0, 1.0);
    p.nu = draw_between(-0.2, 0.48);
    p.shape = (int)(draw() % (unsigned)shapes);
    p.layers = (int)(draw() % 3) == 0;
    return p;
}

static mdr_profile *profile_of(const plan *p)
{
    mdr_profile *made = NULL;
    switch (p->shape) {
    case 0: CHECK_SUCCESS(mdr_profile_paraboloid(p->size, &made)); break;
    case 1: CHECK_SUCCESS(mdr_profile_cone(p->angle, &made)); break;
    case 2: CHECK_SUCCESS(mdr_profile_power(3.0, 1.0 / (p->size * p->size), &made)); break;
    case 3: CHECK_SUCCESS(mdr_profile_rounded_cone(p->size, p->angle, &made)); break;
    case 4: CHECK_SUCCESS(mdr_profile_flat_paraboloid(0.3 * p->size, p->size, &made)); break;
    case 5: CHECK_SUCCESS(mdr_profile_flat_cone(p->size, p->angle, &made)); break;
    default: CHECK_SUCCESS(mdr_profile_flat_punch(p->size, &made)); break;
    }
    return made;
}

static mdr_contact *contact_of(const plan *p)
{
    const mdr_layer film = mdr_isotropic(p->film, 0.3, p->thickness), below = mdr_isotropic(p->M, p->nu, 0.0);
    mdr_profile *tip = profile_of(p);
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;

    CHECK_SUCCESS(mdr_body_layered(p->layers, &film, &below, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(tip, medium, NULL, &contact));
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(tip);
    return contact;
}

static int same_bits(const void *a, const void *b, size_t size)
{
    compared++;
    return memcmp(a, b, size) == 0;
}

/* Each number in turn: a wild one, one a little larger, that of a neighbour. `accepts` is whether the past is taken. */
static void alter(int count, int (*accepts)(void *), void *of)
{
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < WILD + 2; k++) {
            double value = k < WILD ? wild_numbers[k] : saved[i] * (1.0 + 1e-3);
            if (k == WILD + 1) value = saved[i > 0 ? i - 1 : count - 1];
            if (value == saved[i]) continue;
            memcpy(altered, saved, (size_t)count * sizeof *saved);
            altered[i] = value;
            CHECK_TRUE(!accepts(of));
            refused++;
        }
    }
}

/* ---- wear ---- */

typedef struct rubbing {
    mdr_wear_history *history;
    int count;
} rubbing;

static int restores(void *of)
{
    const rubbing *const r = of;
    return mdr_wear_history_restore(r->history, r->count, altered) == MDR_SUCCESS;
}

static mdr_wear_history *wear_of(const plan *p, double k, double load, int scheme, int places)
{
    const double thickness[1] = {1e-2 * p->L}, coefficients[2] = {k, 3.0 * k};
    mdr_wear_options options = MDR_SIZED(mdr_wear_options);
    mdr_contact *contact = contact_of(p);
    mdr_wear *wear = NULL;
    mdr_wear_history *history = NULL;

    options.intervals = 16;
    options.scheme = scheme;
    options.places = places;
    CHECK_SUCCESS(mdr_wear_new(contact, p->layers + 1, coefficients, thickness, places == MDR_WEAR_SAME ? 0.1 * k : 0.0, &wear));
    mdr_wear_history_new(wear, MDR_FORCE, load, &options, &history);
    CHECK_FREE(wear);
    CHECK_FREE(contact);
    return history;
}

static int continue_wear(const plan *p, int is_last)
{
    const double k = draw_decades(-2.0, 2.0) / p->M, sliding[2] = {draw_decades(-4.0, 1.0) * p->L / (k * p->M), p->L / (k * p->M)};
    const int scheme = p->shape == 6 || draw() % 2 ? MDR_WEAR_RINGS : MDR_WEAR_DISC, places = draw() % 4 ? 0 : MDR_WEAR_SAME;
    const double load = draw_decades(-3.0, 0.0) * p->M * p->L * p->L, loads[2] = {load, scheme == MDR_WEAR_RINGS ? 0.3 * load : load};
    mdr_wear_history *first = wear_of(p, k, load, scheme, places), *second;
    mdr_wear_state one, other;
    int count = 0;

    if (!first) return 0;
    second = wear_of(p, k, load, scheme, places);
    for (int i = 0; i < 2; i++) {
        mdr_wear_history_advance(first, MDR_FORCE, 1, &sliding[i], &loads[i], &one);
        CHECK_SUCCESS(mdr_wear_history_save(first, MOST, saved, &count));
        CHECK_SUCCESS(mdr_wear_history_restore(second, count, saved));
        CHECK_SUCCESS(mdr_wear_history_state(second, 0, NULL, &other, NULL));
        CHECK_SUCCESS(mdr_wear_history_state(first, 0, NULL, &one, NULL));
        CHECK_TRUE(same_bits(&one, &other, sizeof one));
    }
    const int status = mdr_wear_history_advance(first, MDR_FORCE, 1, &sliding[0], &load, &one);
    CHECK_INT(mdr_wear_history_advance(second, MDR_FORCE, 1, &sliding[0], &load, &other), status);
    if (status == MDR_SUCCESS) CHECK_TRUE(same_bits(&one, &other, sizeof one));
    if (is_last) {
        rubbing r = {second, count};
        plan q = *p;
        q.size *= 1.01;
        q.angle *= 1.01;
        alter(count, restores, &r);
        r.history = wear_of(&q, k, load, scheme, places);
        memcpy(altered, saved, sizeof saved);
        if (r.history) CHECK_TRUE(!restores(&r));
        CHECK_FREE(r.history);
    }
    CHECK_FREE(first);
    CHECK_FREE(second);
    return 1;
}

/* ---- friction of laws ---- */

static mdr_law *friction_law_of(const plan *p, double depth)
{
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    mdr_contact *contact = contact_of(p);
    mdr_friction *friction = NULL;
    mdr_law *law = NULL;

    CHECK_SUCCESS(mdr_friction_new(contact, 0.3, &friction));
    options.friction = friction;
    options.tolerance = 1e-5;
    mdr_law_new(contact, depth, &options, &law);
    CHECK_FREE(friction);
    CHECK_FREE(contact);
    return law;
}

static int continue_friction(const plan *p)
{
    const double depth = 0.05 * p->size;
    mdr_law *first = friction_law_of(p, depth), *second, *read = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double memory[3][MOST_MEMORY] = {{0.0}}, T[3][3], d, F;
    int length = 0;

    if (!first) return 0;
    second = friction_law_of(p, depth);
    CHECK_SUCCESS(mdr_law_about(first, &facts));
    CHECK_SUCCESS(mdr_law_write(first, NULL, 0, &length));
    char *text = malloc((size_t)length + 1);
    CHECK_SUCCESS(mdr_law_write(first, text, length, &length));
    CHECK_SUCCESS(mdr_law_read(text, length, &read));
    free(text);
    for (int i = 0; i < 6; i++) {
        const double shift[3] = {draw_between(-0.1, 0.1) * depth, draw_between(-0.1, 0.1) * depth, 0.0};
        d = draw_between(0.01, 1.0) * depth;
        CHECK_SUCCESS(mdr_law_force(first, MDR_ON_UNLOADING, d, &F, NULL));
        CHECK_SUCCESS(mdr_law_advance(first, 1, &F, shift, 0, NULL, memory[0], T[0]));
        CHECK_SUCCESS(mdr_law_advance(second, 1, &F, shift, 0, NULL, memory[1], T[1]));
        CHECK_SUCCESS(mdr_law_advance(read, 1, &F, shift, 0, NULL, memory[2], T[2]));
        CHECK_TRUE(same_bits(T[0], T[1], sizeof T[0]) && same_bits(T[0], T[2], sizeof T[0]));
        CHECK_TRUE(same_bits(memory[0], memory[1], sizeof memory[0]) && same_bits(memory[0], memory[2], sizeof memory[0]));
    }
    plan q = *p;
    q.size *= 1.01;
    q.angle *= 1.01;
    mdr_law *other = friction_law_of(&q, depth);
    const double none[3] = {0.0};
    if (other) CHECK_INT(mdr_law_advance(other, 1, &F, none, 1, NULL, memory[0], T[0]), MDR_EINVALID);
    CHECK_FREE(other);
    CHECK_FREE(read);
    CHECK_FREE(second);
    CHECK_FREE(first);
    return 1;
}

/* ---- adhesion that depends on the speed ---- */

static mdr_rate *rate_of(const plan *p, double work, double speed, double exponent, double largest)
{
    mdr_rate_options options = MDR_SIZED(mdr_rate_options);
    mdr_contact *contact = contact_of(p);
    mdr_rate *rate = NULL;

    options.work = work;
    options.speed = speed;
    options.exponent = exponent;
    options.closing_work = 0.8 * work;
    options.largest_radius = largest;
    mdr_rate_new(contact, &options, &rate);
    CHECK_FREE(contact);
    return rate;
}

enum { STATE = sizeof(mdr_rate_state) / sizeof(double) };

typedef struct peeling {
    const mdr_rate *rate;
    int control;
    double value;
} peeling;

static int starts(void *of)
{
    const peeling *const p = of;
    mdr_rate_state start, end;
    const double time = 0.0;
    memcpy(&start, altered, sizeof start);
    return mdr_rate_history(p->rate, p->control, 0.0, 1e-6, &start, 1, &time, &p->value, NULL, NULL, NULL, NULL, NULL, NULL, &end)
           == MDR_SUCCESS;
}

static int continue_rate(const plan *p, int is_last)
{
    const double work = draw_decades(-5.0, -2.0) * p->M * p->L, speed = draw_decades(-3.0, 3.0) * p->L, n = draw_between(0.1, 1.0);
    const double largest = 3.0 * p->size, top = draw_decades(-3.0, -1.0) * p->size;
    const double time[4] = {0.0, 1.0, 2.0, 3.0}, depth[4] = {0.0, top, draw_between(-1.0, 1.0) * top, -4.0 * top};
    mdr_rate *first = rate_of(p, work, speed, n, largest), *second;
    const mdr_rate_state apart = {.radius = draw() % 2 ? 0.0 : -1.0};
    mdr_rate_state middle, end, again, kept;
    double F[2], G[2];

    if (!first) return 0;
    /* of another range, as programs choose it for their path */
    second = rate_of(p, work, speed, n, 0.97 * largest);
    if (mdr_rate_history(first, MDR_DEPTH, 0.0, 1e-6, &apart, 3, time, depth, NULL, NULL, NULL, NULL, NULL, NULL, &middle) == MDR_SUCCESS) {
        kept = middle;
        const int status = mdr_rate_history(first, MDR_DEPTH, 0.0, 1e-6, &middle, 2, time + 2, depth + 2, NULL, NULL, F, NULL, NULL,
                                            NULL, &end);
        memcpy(saved, &kept, sizeof kept);
        mdr_rate *made = rate_of(p, work, speed, n, largest);
        CHECK_INT(mdr_rate_history(made, MDR_DEPTH, 0.0, 1e-6, &kept, 2, time + 2, depth + 2, NULL, NULL, G, NULL, NULL, NULL, &again),
                  status);
        if (status == MDR_SUCCESS) CHECK_TRUE(same_bits(F, G, sizeof F) && same_bits(&end, &again, sizeof end));
        if (second && status == MDR_SUCCESS) {
            CHECK_SUCCESS(mdr_rate_history(second, MDR_DEPTH, 0.0, 1e-6, &kept, 2, time + 2, depth + 2, NULL, NULL, G, NULL, NULL, NULL,
                                           &again));
        }
        if (is_last) {
            peeling of = {first, MDR_DEPTH, depth[2]};
            plan q = *p;
            alter(STATE, starts, &of);
            memcpy(altered, saved, sizeof kept);
            CHECK_TRUE(starts(&of));
            of.rate = rate_of(p, 1.01 * work, speed, n, largest);
            if (of.rate) CHECK_TRUE(!starts(&of));
            CHECK_SUCCESS(mdr_free((void *)of.rate));
            q.M *= 1.01;
            q.film *= 1.01;
            of.rate = rate_of(&q, work, speed, n, largest);
            if (of.rate) CHECK_TRUE(!starts(&of));
            CHECK_SUCCESS(mdr_free((void *)of.rate));
        }
        CHECK_FREE(made);
    }
    CHECK_FREE(second);
    CHECK_FREE(first);
    return 1;
}

/* ---- bodies that yield ---- */

static mdr_plastic_law *plastic_law_of(const plan *p, double gamma)
{
    const double strain = 0.0, Y = p->M * (0.002 + 0.01 * p->angle);
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    mdr_profile *ball = NULL;
    mdr_yielding *metal = NULL;
    mdr_plastic_law *law = NULL;

    options.work_of_adhesion = gamma * Y * p->size * 1e-5;
    options.tolerance = 1e-4;
    CHECK_SUCCESS(mdr_profile_paraboloid(p->size, &ball));
    CHECK_SUCCESS(mdr_yielding_new(p->M, fabs(p->nu), 1, &strain, &Y, &metal));
    mdr_plastic_law_new(ball, metal, 5e-3 * p->size, &options, &law);
    CHECK_FREE(metal);
    CHECK_FREE(ball);
    return law;
}

typedef struct yielded {
    const mdr_plastic_law *law;
    double depth;
} yielded;

static int advances(void *of)
{
    const yielded *const y = of;
    double F, stored, lost;
    const int status = mdr_plastic_law_advance(y->law, 1, &y->depth, 1, altered, &F, NULL, NULL);
    CHECK_INT(mdr_plastic_law_energies(y->law, 1, &y->depth, altered, &stored, &lost), status);
    return status == MDR_SUCCESS;
}

static int continue_plastic(const plan *p)
{
    const int adhesive = draw() % 2 != 0;
    mdr_plastic_law *first = plastic_law_of(p, adhesive), *second;
    double memory[2][2] = {{0.0}}, F[2], slope[2], a[2];

    if (!first) return 0;
    second = plastic_law_of(p, adhesive);
    for (int i = 0; i < 8; i++) {
        const double d = draw_between(-0.3, 1.0) * 4e-3 * p->size;
        CHECK_SUCCESS(mdr_plastic_law_advance(first, 1, &d, 0, memory[0], &F[0], &slope[0], &a[0]));
        CHECK_SUCCESS(mdr_plastic_law_advance(second, 1, &d, 0, memory[1], &F[1], &slope[1], &a[1]));
        CHECK_TRUE(F[0] == F[1] && slope[0] == slope[1] && a[0] == a[1] && same_bits(memory[0], memory[1], sizeof memory[0]));
        /* the largest depth may be any of the range; wild numbers are none */
        yielded y = {first, d};
        for (int place = 0; place < 1 + adhesive; place++) {
            for (int k = 0; k < WILD; k++) {
                memcpy(altered, memory[0], sizeof memory[0]);
                altered[place] = wild_numbers[k] * (isfinite(wild_numbers[k]) && fabs(wild_numbers[k]) < 1e100 ? p->size : 1.0);
                if (fabs(altered[place]) <= 5e-3 * p->size || (place == 1 && altered[place] >= 0.0 && altered[place] < 1e150)) continue;
                CHECK_TRUE(!advances(&y));
                refused++;
            }
        }
    }
    CHECK_FREE(second);
    CHECK_FREE(first);
    return 1;
}

int main(void)
{
    int done[4] = {0};
    while (done[0] < CASES || done[1] < CASES || done[2] < CASES || done[3] < CASES) {
        const plan any = draw_plan(7), smooth = draw_plan(4);
        if (done[0] < CASES) done[0] += continue_wear(&any, done[0] % 50 == 0);
        if (done[1] < CASES) done[1] += continue_friction(&smooth);
        if (done[2] < CASES) done[2] += continue_rate(&smooth, done[2] % 10 == 0);
        if (done[3] < CASES) done[3] += continue_plastic(&any);
    }
    printf("histories: %d pasts compared, %d altered ones refused\n", compared, refused);
    return check_report("histories");
}
