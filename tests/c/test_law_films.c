/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Steps of laws with friction on films, stiff and soft, thick and thin, against rings under Coulomb's law. */
#include "check.h"

enum { SEGMENT = 16, CORNERS = 5, PATHS = 6, CASES = 5, RINGS = 80 };

static const double mu = 0.3;

/* depth, in parts of the largest, and shift in parts of that at which sliding begins there: to and fro under constant F; oblique
 * growth and back; F that falls and rises while sheared; a loop of both; steep oblique growth; from touch to touch */
static const double corners[PATHS][CORNERS][2] = {
    {{1.0, 0.0}, {1.0, 0.6}, {1.0, -0.6}, {1.0, 0.6}, {1.0, 0.0}}, {{0.5, 0.0}, {1.0, 0.4}, {0.5, 0.1}, {1.0, 0.0}, {0.4, 0.2}},
    {{1.0, 0.0}, {1.0, 0.4}, {0.5, 0.4}, {1.0, 0.4}, {1.0, -0.2}}, {{0.6, 0.0}, {1.0, 0.3}, {1.0, -0.3}, {0.6, -0.3}, {0.6, 0.3}},
    {{0.1, 0.0}, {1.0, 1.3}, {1.0, 1.3}, {1.0, 1.0}, {1.0, 0.6}},  {{0.02, 0.0}, {1.0, 0.5}, {0.6, 0.2}, {0.3, 0.3}, {0.02, 0.2}}};

/* G of film and substrate in ratio, a/h; the largest error in per cent of the largest mu F by 8 and by 16 sliders */
static const struct {
    double ratio, radius, percent[PATHS][2];
} cases[CASES] = {
    {10.0, 0.3, {{1.1, 0.4}, {1.1, 0.4}, {0.6, 0.2}, {1.0, 0.3}, {1.0, 1.0}, {0.5, 0.4}}},
    {10.0, 1.0, {{1.1, 0.6}, {1.0, 0.5}, {0.6, 0.3}, {0.8, 0.3}, {1.3, 1.4}, {0.6, 0.5}}},
    {10.0, 3.0, {{1.1, 0.6}, {0.9, 0.5}, {0.6, 0.3}, {1.1, 0.3}, {2.3, 2.2}, {0.5, 0.4}}},
    {0.1, 1.0, {{2.0, 0.9}, {1.8, 0.6}, {1.0, 0.3}, {0.9, 0.3}, {1.1, 0.4}, {0.5, 0.2}}},
    {0.1, 3.0, {{1.8, 0.7}, {2.0, 0.8}, {0.9, 0.3}, {1.0, 0.5}, {1.3, 0.5}, {0.6, 0.2}}},
};

static mdr_contact *on_film(double ratio)
{
    const double nu = 0.3, E = 2.0 * (1.0 + nu);
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(20.0, &ball));
    CHECK_SUCCESS(new_coated(ratio * E, nu, 1.0, E, nu, MDR_MODEL_EXACT, NULL, &film));
    CHECK_SUCCESS(mdr_contact_new(ball, film, NULL, &contact));
    CHECK_FREE(film);
    CHECK_FREE(ball);
    return contact;
}

/* The largest difference of T from that of rings along a path, relative to the largest mu F. */
static void worst_of_path(const mdr_friction *f, mdr_law *const laws[2], const double path[CORNERS][2], double depth, double shift,
                            double worst[2])
{
    mdr_friction_history *history = NULL;
    mdr_state state;
    mdr_shear_state exact;
    double memory[2][11 + 4 * 16] = {{0.0}}, T[3], before = 0.0, largest = 0.0;

    worst[0] = worst[1] = 0.0;
    CHECK_SUCCESS(mdr_friction_history_new(f, 1.01 * depth, RINGS, &history));
    for (int i = 0; i < CORNERS; i++) {
        for (int part = 1; part <= (i ? SEGMENT : 1); part++) {
            const double *from = path[i ? i - 1 : 0], x = (double)part / SEGMENT;
            double d = depth * (from[0] + x * (path[i][0] - from[0])), s = shift * (from[1] + x * (path[i][1] - from[1]));
            CHECK_SUCCESS(mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, 1, &d, &s, &state, &exact));
            for (int j = 0; j < 2; j++) {
                const double step[3] = {s - before, 0.0, 0.0};
                CHECK_SUCCESS(mdr_law_advance(laws[j], 1, &state.force, step, 0, NULL, memory[j], T));
                worst[j] = fmax(worst[j], fabs(T[0] - exact.tangential_force));
            }
            before = s;
            largest = fmax(largest, mu * state.force);
        }
    }
    for (int j = 0; j < 2; j++) worst[j] *= 100.0 / largest;
    CHECK_FREE(history);
}

int main(void)
{
    for (int i = 0; i < CASES; i++) {
        mdr_contact *contact = on_film(cases[i].ratio);
        mdr_friction *f = NULL;
        mdr_law *laws[2] = {NULL, NULL};
        mdr_state state;
        double shift = 0.0, worst[2];

        CHECK_SUCCESS(mdr_friction_new(contact, mu, &f));
        CHECK_SUCCESS(mdr_contact_states(contact, MDR_RADIUS, MDR_ON_UNLOADING, 1, &cases[i].radius, &state));
        CHECK_SUCCESS(shear_sliding(contact, f, &state, MDR_ALONG, &shift, NULL));
        for (int j = 0; j < 2; j++) {
            mdr_law_options options = MDR_SIZED(mdr_law_options);
            options.friction = f;
            options.sliders = j ? 16 : 8;
            options.tolerance = 1e-7;
            CHECK_SUCCESS(mdr_law_new(contact, 1.01 * state.depth, &options, &laws[j]));
        }
        for (int path = 0; path < PATHS; path++) {
            worst_of_path(f, laws, corners[path], state.depth, shift, worst);
            printf("%4g %4g path %d: %.2f %.2f %%\n", cases[i].ratio, cases[i].radius, path, worst[0], worst[1]);
            for (int j = 0; j < 2; j++) CHECK_TRUE(worst[j] <= cases[i].percent[path][j]);
        }
        for (int j = 0; j < 2; j++) CHECK_FREE(laws[j]);
        CHECK_FREE(f);
        CHECK_FREE(contact);
    }
    return check_report("law_films");
}
