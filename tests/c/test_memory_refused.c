/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * One large request for memory is refused, each in turn: the call must say so, or do without. This program brings its own malloc,
 * realloc and free. Each trial is a process of its own, since the run-time system of Fortran ends one that allocates without a status:
 * where the library still does, the number of such requests is known here and must not grow.
 *
 * Before it copies an object, the library allocates as much as the copy takes and frees it again. What was free then is there for the
 * requests that follow: no other thread takes it here.
 */
#define _GNU_SOURCE
#include "check.h"
#include "mdrcontact/all.h"

#include <sys/wait.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_realloc(void *old, size_t size);
void __libc_free(void *block);

enum { LARGE = 65536, POINTS = 8500, ROWS = 100, GRADES = 400, LAYERS = 3000, NUMBERS = 14, SURVIVED = 42 };

/* Large requests so far, and which one is refused; 0: none. */
static int requests, refused;
/* What the latest large request got, and what was freed at once after one and is not used up. */
static void *latest;
static size_t latest_size, tried;

static int is_refused(size_t size)
{
    if (size < LARGE) return 0;
    latest = NULL;
    if (size <= tried) {
        tried -= size;
        return 0;
    }
    tried = 0;
    return ++requests == refused;
}

void *malloc(size_t size)
{
    void *block;

    if (is_refused(size)) return NULL;
    block = __libc_malloc(size);
    if (size >= LARGE) latest = block, latest_size = size;
    return block;
}

void free(void *block)
{
    if (block != NULL && block == latest) tried = latest_size, latest = NULL;
    __libc_free(block);
}

void *realloc(void *old, size_t size)
{
    return is_refused(size) ? NULL : __libc_realloc(old, size);
}

static double x[POINTS], y[POINTS], half[POINTS], low[POINTS], one[POINTS], small[POINTS], out[POINTS], other[POINTS];
static int branches[POINTS];
static int labels[ROWS * ROWS * 10];
static mdr_profile *ball, *tip;
static mdr_medium *half_space, *film;
static mdr_medium *coating, *soft_film, *multilayer, *exact_layers, *exact_grades;
static mdr_contact *contact, *on_film, *by_tip, *coated, *adhesive, *scaled, *on_pair, *relaxing_film, *on_layers;
static mdr_law *law;
#ifdef MDRCONTACT_LATERAL_H
static mdr_structure *voxels;
#endif
static mdr_contact *relaxing, *relaxing_zone, *scaled_gao;
static mdr_material *springs;
static mdr_friction *rubbed, *rubbed_coating, *rubbed_scaled, *rubbed_tip;
static mdr_state pressed;

static int profile(void) { mdr_profile *p = NULL; return mdr_profile_table(MDR_HEIGHT, POINTS, x, y, &p); }
static int mdr_table(void) { mdr_profile *p = NULL; return mdr_profile_table(MDR_G, POINTS, x, y, &p); }
static int medium(void) { mdr_medium *m = NULL; return mdr_medium_table(POINTS - 1, x + 1, x + 1, &m); }
static int contact_of_tip(void) { mdr_contact *c = NULL; return mdr_contact_new(tip, half_space, NULL, &c); }
static int contact_on_film(void) { mdr_contact *c = NULL; return mdr_contact_new(ball, film, NULL, &c); }
static mdr_state reached[POINTS];
static int states(void) { return mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, x, reached); }
static int states_on_film(void) { return columns_of(on_film, MDR_DEPTH, 3, x + 100, NULL, NULL, out, NULL); }
static int states_of_tip(void) { return columns_of(by_tip, MDR_DEPTH, 3, x + 100, NULL, NULL, out, NULL); }
static int field(void) { return field_at(contact, MDR_PRESSURE, MDR_RADIUS, 2.0, POINTS, x, out); }
/* At scattered points or on a grid. */
static int stress_at(mdr_contact *c, double friction, int is_grid)
{
    static double r[POINTS], z[POINTS];
    static mdr_interior found[POINTS];
    for (int i = 0; i < POINTS; i++) {
        r[i] = is_grid ? i % 100 * 0.02 : x[i];
        z[i] = is_grid ? i / 100 * 0.01 : 0.05 + x[POINTS - 1 - i];
    }
    return state_interior(c, MDR_BODY_LOWER, &pressed, MDR_SIDE_BELOW, friction, POINTS, r, z, NULL, found);
}
static int stresses(void) { return stress_at(contact, 0.0, 0); }
static int stresses_sliding(void) { return stress_at(contact, 0.3, 0); }
static int stresses_of_grid(void) { return stress_at(coated, 0.3, 1); }
static int loop(void) { mdr_loop *l = NULL; return mdr_loop_new(contact, MDR_DEPTH, 0.5, POINTS, 0.0, &l); }
#ifdef MDRCONTACT_LATERAL_H
static int new_voxels(mdr_structure **s)
{
    const int size[3] = {ROWS, ROWS, 10};
    const double E[2] = {1.0, 2.0}, nu[2] = {0.3, 0.3}, spacing[3] = {0.1, 0.1, 0.1};
    return mdr_structure_voxels(size, labels, 2, E, nu, spacing, 1.0, 0.3, NULL, s);
}
static int make_voxels(void) { mdr_structure *s = NULL; return new_voxels(&s); }
static int place(void) { return mdr_structure_modulus(voxels, 1, x + 9, x + 9, x + 99, out); }
#endif
static int write_law(void)
{
    static char text[3000000];
    int length = 0, status = mdr_law_write(law, text, (int)sizeof text, &length);
    mdr_law *again = NULL;
    return status == MDR_SUCCESS ? mdr_law_read(text, length, &again) : status;
}

#ifdef MDRCONTACT_TIME_H
static int path(void) { return mdr_contact_history(relaxing, MDR_DEPTH, 1e-2, POINTS - 1, x + 1, y + 1, out, NULL, NULL); }
static int path_of_forces(void)
{
    return mdr_contact_history(relaxing, MDR_FORCE, 1e-2, POINTS - 1, x + 1, small + 1, out, NULL, NULL);
}
static int oscillations(void) { return mdr_contact_dynamic_stiffness(relaxing, POINTS - 1, x + 1, x + 1, out, other); }
#endif
static int tangential_states(void)
{
    static mdr_shear_state found[POINTS];
    return shear_states(contact, rubbed, &pressed, MDR_ALONG, MDR_SHIFT, POINTS, small, found);
}
static int tangential_loop(void) { return shear_loop(contact, rubbed, &pressed, MDR_ALONG, MDR_SHIFT, 1e-3, POINTS, out, other,
                                                     other); }
/* Large matrices of rings: made, led deeper and back, copied. */
static int rings(void)
{
    const double d[2] = {0.3, 0.1}, s[2] = {0.05, -0.05};
    mdr_friction_history *history = NULL, *copy = NULL;
    mdr_state states[2];
    mdr_shear_state sheared[2];
    int status = mdr_friction_history_new(rubbed, 0.5, 120, &history);
    if (status == MDR_SUCCESS) {
        status = mdr_friction_history_advance(history, MDR_DEPTH, MDR_SHIFT, 2, d, s, states, sheared);
    }
    return status == MDR_SUCCESS ? mdr_friction_history_copy(history, &copy) : status;
}

/* Fields and energies of a state, at some radii within it. */
static int fields_at(mdr_contact *c, int n)
{
    mdr_state state;
    double lower, lowest;
    int status = mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, (double[]){0.5}, &state);
    for (int field = MDR_PRESSURE; status == MDR_SUCCESS && field <= MDR_DISPLACEMENT_UPPER; field++) {
        status = state_field(c, field, &state, n, half + 99, out);
    }
    if (status == MDR_SUCCESS) status = state_energy(c, &state, &lower, NULL);
    if (status == MDR_SUCCESS && c != adhesive) status = state_lowest_pressure(c, &state, &lowest, NULL);
    return status;
}
static int fields_of_scaled(void) { return fields_at(scaled, 1); }
static int fields_on_coating(void) { return fields_at(coated, POINTS - 99); }
static int fields_of_adhesive(void) { return fields_at(adhesive, POINTS - 99); }

static mdr_layer many[POINTS], stiff[LAYERS];
static int layers(void)
{
    const mdr_layer base = mdr_isotropic(2.0, 0.3, 0.0);
    mdr_medium *m = NULL;
    return medium_of_layers(POINTS - 1, many, &base, MDR_MODEL_GAO, NULL, &m);
}
static int contact_on_layers(void)
{
    mdr_contact *c = NULL;
    int status = mdr_contact_new(ball, multilayer, NULL, &c);
    return status == MDR_SUCCESS ? columns_of(c, MDR_DEPTH, 1, x + 100, NULL, NULL, out, NULL) : status;
}
static int pair_of_layers(void)
{
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    int status = mdr_medium_pair(multilayer, multilayer, &m);
    return status == MDR_SUCCESS ? mdr_contact_new(ball, m, NULL, &c) : status;
}
static int friction_on_layers(void)
{
    mdr_friction *f = NULL;
    int status = mdr_medium_values(multilayer, MDR_TANGENTIAL_MODULUS, 2, x + 100, out);
    if (status == MDR_SUCCESS) status = mdr_friction_new(on_layers, 0.3, &f);
    return status == MDR_SUCCESS ? mdr_friction_new(by_tip, 0.3, &f) : status;
}
/* Its past is small, its indenter is a table. */
static int friction_history_of_table(void)
{
    mdr_friction_history *history = NULL, *copy = NULL;
    const int status = mdr_friction_history_new(rubbed_tip, 0.0, 0, &history);
    return status == MDR_SUCCESS ? mdr_friction_history_copy(history, &copy) : status;
}
static int graded_table(void)
{
    mdr_medium *m = NULL;
    return medium_of_grades(GRADES, x, one, small, MDR_MODEL_GAO, NULL, &m);
}
static int graded_table_exact(void)
{
    mdr_medium *m = NULL;
    return medium_of_grades(GRADES, x, one, small, MDR_MODEL_EXACT, NULL, &m);
}
/* Thousands of layers and depths, solved exactly. */
static int layers_exact(void)
{
    const mdr_layer base = mdr_isotropic(2.0, 0.3, 0.0);
    mdr_medium *m = NULL;
    return medium_of_layers(LAYERS, stiff, &base, MDR_MODEL_EXACT, NULL, &m);
}
static int sheared(mdr_medium *m)
{
    int status = mdr_medium_values(m, MDR_TANGENTIAL_MODULUS, 1, x + 1000, out);
    return status == MDR_SUCCESS ? mdr_medium_values(m, MDR_TORSIONAL_STIFFNESS, 1, x + 1000, out) : status;
}
static int sheared_layers(void) { return sheared(exact_layers); }
static int sheared_grades(void) { return sheared(exact_grades); }
static int pair_of_exact(void) { mdr_medium *m = NULL; return mdr_medium_pair(exact_layers, exact_grades, &m); }
static int stress_in_layers(void)
{
    mdr_contact *c = NULL;
    mdr_state state;
    mdr_interior found;
    const double radius = 0.5, r = 0.1, z = 0.2;
    int status = mdr_contact_new(ball, exact_layers, NULL, &c);
    if (status == MDR_SUCCESS) status = mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, &radius, &state);
    if (status != MDR_SUCCESS) return status;
    return state_interior(c, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 1, &r, &z, NULL, &found);
}
static int pair(void) { mdr_medium *m = NULL; return mdr_medium_pair(film, film, &m); }
static int contact_on_pair(void)
{
    mdr_medium *m = NULL;
    mdr_contact *c = NULL;
    int status = mdr_medium_pair(film, coating, &m);
    return status == MDR_SUCCESS ? mdr_contact_new(ball, m, NULL, &c) : status;
}
static int contact_scaled(void)
{
    mdr_contact_options options;
    mdr_contact *c = NULL;
    options = MDR_SIZED(mdr_contact_options);
    options.zeta_count = POINTS - 1;
    options.zeta_radius = x + 1;
    options.zeta = one;
    return mdr_contact_new(ball, film, &options, &c);
}
static int states_scaled(void) { return columns_of(scaled, MDR_DEPTH, 3, x + 100, NULL, NULL, out, NULL); }
static int states_on_pair(void) { return columns_of(on_pair, MDR_DEPTH, 3, x + 100, NULL, NULL, out, NULL); }
static int sum(void)
{
    const mdr_profile *terms[2] = {tip, tip};
    mdr_profile *p = NULL;
    return mdr_profile_sum(2, terms, &p);
}
static int heights(void) { return mdr_profile_values(tip, MDR_G, POINTS, x, out); }
static int moduli(void) { return mdr_medium_values(film, MDR_MODULUS, POINTS - 1, x + 1, out); }
static int shear_moduli(void) { return mdr_medium_values(coating, MDR_TANGENTIAL_MODULUS, 200, x + 1, out); }
static int torsional_stiffnesses(void) { return mdr_medium_values(coating, MDR_TORSIONAL_STIFFNESS, 200, x + 1, out); }
static int closed_form(void)
{
    const double constants[] = {1.0, 2.0, 1.0, 0.1, 1e-3};
    return mdr_closed_form(MDR_FORM_ADHESIVE_DEPTH, POINTS - 1, x + 1, constants, out);
}
static int loop_path(void)
{
    mdr_loop *l = NULL;
    static mdr_loop_point points[POINTS];
    int status = mdr_loop_new(adhesive, MDR_DEPTH, 0.5, POINTS, 3.0, &l);
    return status == MDR_SUCCESS ? mdr_loop_points(l, POINTS, points, NULL) : status;
}
static int creep(void) { return mdr_material_values(springs, MDR_CREEP, POINTS - 1, x + 1, out, NULL); }
#ifdef MDRCONTACT_TIME_H
static int new_frequencies(void) { return mdr_contact_dynamic_stiffness(relaxing_film, 3, x + 1, one, out, other); }
static int steps(void) { return mdr_contact_step_response(relaxing_film, MDR_CREEP, 0.5, 3, x + 1, out); }
#endif
#ifdef MDRCONTACT_ADHESION_H
/* bodies that stay apart */
static int march_of_zone(void)
{
    static const mdr_rate_state apart;
    mdr_rate_state end;
    return mdr_contact_adhesive_history(relaxing_zone, MDR_DEPTH, 0.0, 0.0, &apart, POINTS - 1, x + 1, low + 1, out, NULL,
                                        NULL, NULL, &end);
}
#endif

#ifdef MDRCONTACT_TIME_H
static int march(void)
{
    const double t[4] = {0.0, 0.1, 0.2, 0.3}, d[4] = {0.0, 0.1, 0.05, 0.1};
    return mdr_contact_history(relaxing_film, MDR_DEPTH, 1e-3, 4, t, d, out, NULL, NULL);
}
#endif

static int torsional_states(void)
{
    static mdr_shear_state found[POINTS];
    return shear_states(contact, rubbed, &pressed, MDR_AROUND, MDR_TWIST, 1400, small, found);
}
static int shear_fields(const mdr_friction *f, mdr_contact *c, int n)
{
    mdr_state state;
    mdr_shear_state sheared;
    int status = mdr_contact_states(c, MDR_RADIUS, MDR_ON_UNLOADING, 1, (double[]){0.5}, &state);
    if (status == MDR_SUCCESS) status = shear_states(c, f, &state, MDR_ALONG, MDR_SHIFT, 1, (double[]){1e-3}, &sheared);
    for (int field = MDR_TRACTION; status == MDR_SUCCESS && field <= MDR_TANGENTIAL_LINE_LOAD; field++) {
        status = shear_field(c, f, &state, MDR_ALONG, &sheared, field, n, half, out);
    }
    return status;
}
static int tractions(void) { return shear_fields(rubbed, contact, POINTS); }
static int tractions_on_coating(void) { return shear_fields(rubbed_coating, coated, POINTS); }
static int tractions_of_scaled(void) { return shear_fields(rubbed_scaled, scaled_gao, 2); }

static int law_of(const mdr_contact *c, double tolerance)
{
    mdr_law_options options;
    mdr_law *made = NULL;
    options = MDR_SIZED(mdr_law_options);
    options.tolerance = tolerance;
    return mdr_law_new(c, 0.3, &options, &made);
}
static int law_of_half_space(void) { return law_of(contact, 1e-12); }
static int law_of_coating(void) { return law_of(coated, 1e-8); }
static int law_of_adhesive(void) { return law_of(adhesive, 1e-8); }
static int law_energies(void)
{
    return mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, POINTS, half, NULL, NULL, NULL, NULL, NULL, out);
}
static int law_of_friction(void)
{
    mdr_law *made = NULL, *again = NULL;
    static char text[3000000];
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.friction = rubbed;
    int length = 0, status = mdr_law_new(contact, 0.3, &options, &made);
    if (status == MDR_SUCCESS) status = mdr_law_write(made, text, (int)sizeof text, &length);
    return status == MDR_SUCCESS ? mdr_law_read(text, length, &again) : status;
}
static int law_of_friction_on_coating(void)
{
    mdr_law *made = NULL;
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    options.friction = rubbed_coating;
    return mdr_law_new(coated, 0.1, &options, &made);
}

#ifdef MDRCONTACT_LATERAL_H
static int map_of(const mdr_structure *s, int n) { return mdr_structure_modulus(s, n, x, x, one, out); }
static int smooth(double at_x, double at_y, double z, double *E, double *nu, void *context)
{
    (void)context;
    *E = 2.0 + sin(at_x) * sin(at_y) * exp(-z);
    *nu = 0.3;
    return 0;
}
static int map_of_function(void)
{
    mdr_structure *s = NULL;
    int status = mdr_structure_function(smooth, NULL, 0.3, NULL, &s);
    return status == MDR_SUCCESS ? map_of(s, 2) : status;
}
static int cells(void) { return mdr_lateral_cells(0.3, 0.1, 0.0, 0.1, 90, x, 90, x, out, other); }
#endif

#ifdef MDRCONTACT_FIT_H
/* What differs from a paraboloid's forces over depths, by least squares of its modulus. */
typedef struct {
    int data_kind, loss, free, use_branch;
    double work_of_adhesion, frame_compliance;
    int (*end)(const mdr_fit_problem *problem, const double *given);
} trial;
static int fit(trial t, const double *given)
{
    mdr_fit_problem problem;
    mdr_fit_parameter p[NUMBERS - 1];
    problem = MDR_SIZED(mdr_fit_problem);
    problem.data_kind = t.data_kind;
    problem.profile = ball;
    problem.medium = half_space;
    problem.parameters = p;
    problem.any_units = 1;
    problem.loss = t.loss;
    problem.max_iterations = 2;
    if (t.use_branch) problem.branch = branches;
    const int status = mdr_fit_parameters(&problem, NUMBERS - 1, p, &problem.parameter_count);
    if (status != MDR_SUCCESS) return status;
    if (t.free >= 0) p[t.free].is_free = 1;
    p[3].value = t.work_of_adhesion;
    p[6].value = t.frame_compliance;
    return t.end(&problem, given);
}
static int predicted(const mdr_fit_problem *p, const double *given)
{
    return mdr_fit_predict(p, POINTS - 1, x + 1, y + 1, given, out, NULL);
}
static int solved(const mdr_fit_problem *p, const double *given)
{
    return mdr_fit_solve(p, POINTS - 1, x + 1, y + 1, given, NULL, NULL, NULL, NULL, NULL, NULL, out, NULL, NULL);
}
static int bounded(const mdr_fit_problem *p, const double *given)
{
    double lower, upper;
    return mdr_fit_interval(p, POINTS - 1, x + 1, y + 1, given, NULL, 1, 0.9, &lower, &upper);
}
static int predict(void) { return fit((trial){MDR_FIT_FORCE_DEPTH, MDR_FIT_LINEAR, -1, 0, 0.0, 0.0, predicted}, NULL); }
static int predict_radii(void) { return fit((trial){MDR_FIT_STIFFNESS_RADIUS, MDR_FIT_LINEAR, -1, 0, 0.0, 0.0, predicted}, NULL); }
static int solve(void) { return fit((trial){MDR_FIT_FORCE_DEPTH, MDR_FIT_LINEAR, 1, 0, 0.0, 0.0, solved}, NULL); }
static int solve_adhesive(void) { return fit((trial){MDR_FIT_FORCE_DEPTH, MDR_FIT_HUBER, 1, 1, 1e-3, 1e-3, solved}, NULL); }
static int solve_stiffness(void) { return fit((trial){MDR_FIT_STIFFNESS_DEPTH, MDR_FIT_LINEAR, 1, 0, 0.0, 0.0, solved}, small); }
static int interval(void) { return fit((trial){MDR_FIT_MODULUS_RADIUS, MDR_FIT_LINEAR, 1, 0, 0.0, 0.0, bounded}, NULL); }
#endif

#ifdef MDRCONTACT_PLASTIC_H
static mdr_yielding *metal;
static mdr_plastic_law *plastic;
static mdr_overload *rule;
static mdr_cap *cap;
static double shallow[POINTS], hertz[POINTS], memory[POINTS];

static void make_plastic(void)
{
    const double strain = 0.0, stress = 1e-2;
    for (int i = 0; i < POINTS; i++) shallow[i] = 1e-6 * (i + 1), hertz[i] = 1.4 * shallow[i] * shallow[i];
    CHECK_SUCCESS(mdr_yielding_new(1.0, 0.3, 1, &strain, &stress, &metal));
    CHECK_SUCCESS(mdr_plastic_law_new(ball, metal, 1e-2, NULL, &plastic));
    CHECK_SUCCESS(mdr_overload_new(contact, 1, &stress, &rule));
    CHECK_SUCCESS(mdr_cap_new(contact, 0.03, &cap));
}

static int imprint_of_pressure(void)
{
    mdr_imprint *made = NULL;
    return mdr_imprint_from_pressure(half_space, POINTS, x, one, 0.0, &made);
}
static int hardening(void)
{
    mdr_yielding *made = NULL;
    return mdr_yielding_new(1.0, 0.3, POINTS, x, one, &made);
}
static int plastic_table(void)
{
    mdr_plastic_law *made = NULL;
    return mdr_plastic_law_from_points(POINTS, shallow, hertz, shallow, memory, one, NULL, &made);
}
static int plastic_steps(void)
{
    int status = mdr_plastic_law_advance(plastic, POINTS, shallow, 0, memory, out, NULL, NULL);
    if (status == MDR_SUCCESS) status = mdr_plastic_law_energies(plastic, POINTS, shallow, memory, out, y);
    return status;
}
static int plastic_loading(void) { return mdr_plastic_law_loading(plastic, POINTS, shallow, out, NULL, NULL, NULL); }
static int restitution(void) { return mdr_plastic_law_restitution(plastic, 1.0, POINTS, hertz, out); }
static int overloads(void)
{
    static mdr_overload_state found[POINTS];
    return mdr_overload_states(rule, MDR_RADIUS, POINTS, shallow, found);
}
static int capped_pressure(void) { return mdr_cap_pressure(cap, 0.1, POINTS, x, out, NULL); }
#endif

/* In a process of its own. 0 if it came to its end with a status that may be. */
static int dies(int (*call)(void), int number, int *count)
{
    int ends[2], result, died;
    pid_t child;

    if (pipe(ends) != 0) return 1;
    fflush(NULL);
    child = fork();
    if (child == 0) {
        int status;
        if (freopen("/dev/null", "w", stderr) == NULL) _exit(1);
        requests = 0;
        tried = 0;
        latest = NULL;
        refused = number;
        status = call();
        refused = 0;
        if (write(ends[1], &requests, sizeof requests) < 0) _exit(1);
        _exit(status == MDR_SUCCESS || (number > 0 && status == MDR_ENOMEMORY) ? SURVIVED : status);
    }
    close(ends[1]);
    *count = 0;
    if (read(ends[0], count, sizeof *count) < 0) *count = 0;
    close(ends[0]);
    waitpid(child, &result, 0);
    died = !(WIFEXITED(result) && WEXITSTATUS(result) == SURVIVED);
    return died;
}

static void refuse_each(const char *name, int known, int (*call)(void))
{
    int count, unused, deaths = 0;

    CHECK_TRUE(!dies(call, 0, &count));
    /* of many a part */
    for (int k = 1; k <= count; k += 1 + count / 20) deaths += dies(call, k, &unused);
    printf("%s: %d large requests, %d of those refused without a status\n", name, count, deaths);
    CHECK_TRUE(deaths <= known);
}

int main(void)
{
    mdr_law_options options;
    mdr_material *layer[1] = {NULL};
    mdr_contact_options chosen;
    mdr_medium *soft = NULL, *gao = NULL, *two = NULL;

    for (int i = 0; i < POINTS; i++) x[i] = i * 1e-4, y[i] = x[i] * x[i] * (1.0 + 0.01 * sin(30.0 * x[i]));
    for (int i = 0; i < POINTS; i++) small[i] = 1e-3 * y[i] * x[i], branches[i] = i % 2 ? MDR_ON_LOADING : MDR_ON_UNLOADING;
    for (int i = 0; i < POINTS; i++) one[i] = 1.0, half[i] = 0.5 * x[i], low[i] = x[i] - 10.0;
    for (int i = 0; i < ROWS * ROWS * 10; i++) labels[i] = i % 2;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(mdr_profile_table(MDR_HEIGHT, POINTS, x, y, &tip));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &half_space));
    CHECK_SUCCESS(mdr_medium_table(POINTS - 1, x + 1, x + 1, &film));
    CHECK_SUCCESS(mdr_contact_new(ball, half_space, NULL, &contact));
    CHECK_SUCCESS(mdr_contact_new(ball, film, NULL, &on_film));
    CHECK_SUCCESS(mdr_contact_new(tip, half_space, NULL, &by_tip));
    CHECK_SUCCESS(mdr_friction_new(by_tip, 0.3, &rubbed_tip));
#ifdef MDRCONTACT_LATERAL_H
    CHECK_SUCCESS(new_voxels(&voxels));
#endif
    options = MDR_SIZED(mdr_law_options);
    options.tolerance = 1e-12;
    CHECK_SUCCESS(mdr_law_new(contact, 0.5, &options, &law));

    CHECK_SUCCESS(mdr_material_viscoelastic(1.0, 1, (double[]){2.0}, (double[]){0.5}, 0.0, 0.5, 0.0, &springs));
    CHECK_SUCCESS(relaxing_medium(0, NULL, NULL, springs, MDR_MODEL_EXACT, NULL, &soft));
    CHECK_SUCCESS(mdr_contact_new(ball, soft, NULL, &relaxing));
    chosen = MDR_SIZED(mdr_contact_options);
    chosen.work_of_adhesion = 1e-2;
    chosen.cohesive_stress = 0.5;
    CHECK_SUCCESS(mdr_contact_new(ball, soft, &chosen, &relaxing_zone));
    CHECK_SUCCESS(new_coated(2.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_EXACT, NULL, &coating));
    CHECK_SUCCESS(mdr_contact_new(ball, coating, NULL, &coated));
    CHECK_SUCCESS(mdr_friction_new(contact, 0.3, &rubbed));
    CHECK_SUCCESS(mdr_contact_states(contact, MDR_DEPTH, MDR_ON_UNLOADING, 1, (double[]){0.3}, &pressed));

    CHECK_SUCCESS(mdr_material_viscoelastic(1.0 / 2.6, 0, NULL, NULL, 0.0, 0.3, 0.0, &layer[0]));
    CHECK_SUCCESS(relaxing_medium(1, (const mdr_material *const *)layer, (double[]){0.4}, springs, MDR_MODEL_EXACT, NULL,
                                          &soft_film));
    CHECK_SUCCESS(mdr_contact_new(ball, soft_film, NULL, &relaxing_film));
    CHECK_SUCCESS(mdr_medium_pair(film, half_space, &two));
    CHECK_SUCCESS(mdr_contact_new(ball, two, NULL, &on_pair));
    CHECK_SUCCESS(new_coated(2.0, 0.3, 1.0, 1.0, 0.3, MDR_MODEL_GAO, NULL, &gao));
    chosen = MDR_SIZED(mdr_contact_options);
    chosen.zeta_count = POINTS - 1;
    chosen.zeta_radius = x + 1;
    chosen.zeta = one;
    CHECK_SUCCESS(mdr_contact_new(ball, film, &chosen, &scaled));
    CHECK_SUCCESS(mdr_contact_new(ball, gao, &chosen, &scaled_gao));
    chosen = MDR_SIZED(mdr_contact_options);
    chosen.work_of_adhesion = 1e-3;
    CHECK_SUCCESS(mdr_contact_new(ball, coating, &chosen, &adhesive));
    CHECK_SUCCESS(mdr_friction_new(coated, 0.3, &rubbed_coating));
    CHECK_SUCCESS(mdr_friction_new(scaled_gao, 0.3, &rubbed_scaled));

    for (int i = 0; i < POINTS; i++) many[i] = mdr_isotropic(one[i], small[i], one[i]);
    for (int i = 0; i < LAYERS; i++) stiff[i] = mdr_isotropic(x[5000 + i], half[1 + i], one[i]);
    CHECK_SUCCESS(new_layered(POINTS - 1, one, small, one, 2.0, 0.3, MDR_MODEL_GAO, NULL, &multilayer));
    CHECK_SUCCESS(mdr_contact_new(ball, multilayer, NULL, &on_layers));
    CHECK_SUCCESS(new_layered(LAYERS, x + 5000, half + 1, one, 2.0, 0.3, MDR_MODEL_EXACT, NULL, &exact_layers));
    CHECK_SUCCESS(medium_of_grades(LAYERS, x, x + 5000, half, MDR_MODEL_EXACT, NULL, &exact_grades));

    refuse_each("table of f", 0, profile);
    refuse_each("table of g", 0, mdr_table);
    refuse_each("table of E_eff", 0, medium);
    refuse_each("contact of a table", 0, contact_of_tip);
    refuse_each("contact on a table", 0, contact_on_film);
    refuse_each("states", 0, states);
    refuse_each("states on a table", 0, states_on_film);
    refuse_each("states of a table", 0, states_of_tip);
    refuse_each("field", 0, field);
    refuse_each("stresses", 0, stresses);
    refuse_each("stresses under sliding", 0, stresses_sliding);
    refuse_each("stresses of a grid in a coated body", 0, stresses_of_grid);
    refuse_each("loop", 0, loop);
    refuse_each("law written and read", 0, write_law);
    refuse_each("tangential states", 0, tangential_states);
    refuse_each("tangential loop", 0, tangential_loop);
    refuse_each("friction by rings", 0, rings);
    refuse_each("fields under zeta", 0, fields_of_scaled);
    refuse_each("fields on a coating", 0, fields_on_coating);
    refuse_each("fields of an adhesive contact", 0, fields_of_adhesive);
    refuse_each("layers", 0, layers);
    refuse_each("contact on layers", 0, contact_on_layers);
    refuse_each("pair of layers", 0, pair_of_layers);
    refuse_each("friction on layers and of a table", 0, friction_on_layers);
    refuse_each("history of friction of a table", 0, friction_history_of_table);
    refuse_each("table of depths", 0, graded_table);
    refuse_each("table of depths, exact", 0, graded_table_exact);
    refuse_each("thousands of layers, exact", 0, layers_exact);
    refuse_each("layers under shear", 0, sheared_layers);
    refuse_each("depths under shear", 0, sheared_grades);
    refuse_each("pair of layers and depths, exact", 0, pair_of_exact);
    refuse_each("stresses in layers", 0, stress_in_layers);
    refuse_each("pair", 0, pair);
    refuse_each("contact on a pair", 0, contact_on_pair);
    refuse_each("contact under zeta", 0, contact_scaled);
    refuse_each("states under zeta", 0, states_scaled);
    refuse_each("states on a pair", 0, states_on_pair);
    refuse_each("sum of tables", 0, sum);
    refuse_each("values of g", 0, heights);
    refuse_each("moduli", 0, moduli);
    refuse_each("shear moduli", 0, shear_moduli);
    refuse_each("torsional stiffnesses", 0, torsional_stiffnesses);
    refuse_each("closed form", 0, closed_form);
    refuse_each("adhesive loop", 0, loop_path);
    refuse_each("creep", 0, creep);
    refuse_each("torsional states", 0, torsional_states);
    refuse_each("tractions", 0, tractions);
    refuse_each("tractions on a coating", 0, tractions_on_coating);
    refuse_each("tractions under zeta", 0, tractions_of_scaled);
    refuse_each("law of a half-space", 0, law_of_half_space);
    refuse_each("law of a coating", 0, law_of_coating);
    refuse_each("law of an adhesive contact", 0, law_of_adhesive);
    refuse_each("energies of a law", 0, law_energies);
    refuse_each("law of friction", 0, law_of_friction);
    refuse_each("law of friction on a coating", 0, law_of_friction_on_coating);
#ifdef MDRCONTACT_TIME_H
    refuse_each("path in time", 0, path);
    refuse_each("path in time of forces", 0, path_of_forces);
    refuse_each("oscillations", 0, oscillations);
    refuse_each("frequencies of a film", 0, new_frequencies);
    refuse_each("step of a film", 0, steps);
    refuse_each("path in time on a film", 0, march);
#endif
#ifdef MDRCONTACT_ADHESION_H
    refuse_each("path in time of a zone", 0, march_of_zone);
#endif
#ifdef MDRCONTACT_LATERAL_H
    refuse_each("voxels", 0, make_voxels);
    refuse_each("place among voxels", 0, place);
    refuse_each("map of a function", 0, map_of_function);
    refuse_each("cells", 0, cells);
#endif
#ifdef MDRCONTACT_FIT_H
    refuse_each("prediction", 0, predict);
    refuse_each("prediction at radii", 0, predict_radii);
    refuse_each("fit", 0, solve);
    refuse_each("fit of an adhesive curve under a robust loss", 0, solve_adhesive);
    refuse_each("fit of stiffnesses", 0, solve_stiffness);
    refuse_each("interval", 0, interval);
#endif
#ifdef MDRCONTACT_PLASTIC_H
    make_plastic();
    refuse_each("imprint of a pressure", 0, imprint_of_pressure);
    refuse_each("hardening", 0, hardening);
    refuse_each("table of first loading", 21, plastic_table);
    refuse_each("steps of plastic contacts", 0, plastic_steps);
    refuse_each("first loading", 0, plastic_loading);
    refuse_each("restitution", 0, restitution);
    refuse_each("overload rule", 0, overloads);
    refuse_each("pressure under a cap", 1, capped_pressure);
#endif
    return check_report("refused memory");
}
