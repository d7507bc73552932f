/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * GSL and LAPACK fail on command: no workspace, no step, a matrix that is not positive definite. This program brings functions of
 * their names, which the library then calls, and which refuse while a switch is set. Every call must say so in its status.
 */
#define _GNU_SOURCE
#include "check.h"
#include "mdrcontact/all.h"

#include <dlfcn.h>

enum refused { NOTHING, ROOT_WORKSPACE, ROOT_START, ROOT_STEP, ROOT_TEST, RULE, SPLINE, FIT_STEP, FACTORS };

static enum refused refused = NOTHING;
static int refusals;

/* The real function, or NULL, counted, if it is the one to fail. */
static void *real(const char *name, enum refused which)
{
    if (refused != which) return dlsym(RTLD_NEXT, name);
    refusals++;
    return NULL;
}

/* ISO C has no conversion from an object pointer to a function pointer; a union has. */
#define FUNCTION(type, pointer) (((union { void *object; type function; }){(pointer)}).function)

typedef void *(*make_one)(const void *);
typedef void *(*make_sized)(size_t);
typedef void *(*make_typed)(const void *, size_t);
typedef int (*step)(void *);
typedef int (*test)(double, double, double, double);
typedef int (*start)(void *, void *, double, double);
typedef void (*factorise)(const char *, const int *, double *, const int *, int *, size_t);

void *gsl_root_fsolver_alloc(const void *kind);
void *gsl_integration_glfixed_table_alloc(size_t n);
void *gsl_spline_alloc(const void *kind, size_t n);
int gsl_root_fsolver_set(void *solver, void *f, double lower, double upper);
int gsl_root_fsolver_iterate(void *solver);
int gsl_root_test_interval(double lower, double upper, double absolute, double relative);
int gsl_multifit_nlinear_iterate(void *workspace);
void dpotf2_(const char *uplo, const int *n, double *a, const int *lda, int *info, size_t length);

void *gsl_root_fsolver_alloc(const void *kind)
{
    void *f = real("gsl_root_fsolver_alloc", ROOT_WORKSPACE);
    return f ? FUNCTION(make_one, f)(kind) : NULL;
}

void *gsl_integration_glfixed_table_alloc(size_t n)
{
    void *f = real("gsl_integration_glfixed_table_alloc", RULE);
    return f ? FUNCTION(make_sized, f)(n) : NULL;
}

void *gsl_spline_alloc(const void *kind, size_t n)
{
    void *f = real("gsl_spline_alloc", SPLINE);
    return f ? FUNCTION(make_typed, f)(kind, n) : NULL;
}

int gsl_root_fsolver_set(void *solver, void *function, double lower, double upper)
{
    void *f = real("gsl_root_fsolver_set", ROOT_START);
    return f ? FUNCTION(start, f)(solver, function, lower, upper) : 4;
}

int gsl_root_fsolver_iterate(void *solver)
{
    void *f = real("gsl_root_fsolver_iterate", ROOT_STEP);
    return f ? FUNCTION(step, f)(solver) : 9;
}

/* -2: go on, for ever */
int gsl_root_test_interval(double lower, double upper, double absolute, double relative)
{
    void *f = real("gsl_root_test_interval", ROOT_TEST);
    return f ? FUNCTION(test, f)(lower, upper, absolute, relative) : -2;
}

int gsl_multifit_nlinear_iterate(void *workspace)
{
    void *f = real("gsl_multifit_nlinear_iterate", FIT_STEP);
    return f ? FUNCTION(step, f)(workspace) : 27;
}

void dpotf2_(const char *uplo, const int *n, double *a, const int *lda, int *info, size_t length)
{
    void *f = real("dpotf2_", FACTORS);
    if (f) FUNCTION(factorise, f)(uplo, n, a, lda, info, length);
    else *info = 1;
}

static mdr_profile *ball;
static mdr_medium *film, *exact_film, *rising;
static mdr_contact *contact, *exact_contact, *broken_power;
static mdr_contact_options sticky;
static const double x[3] = {0.0, 0.5, 1.0}, y[3] = {0.0, 0.1, 0.4};
static const double E[2] = {3.0, 2.0}, nu[2] = {0.3, 0.2}, h[2] = {0.5, 0.2}, thin[1] = {7e-5};
static const double E_graded[3] = {1.0, 2.0, 3.0}, nu_graded[3] = {0.3, 0.3, 0.3};
static double out[3];

static int table(void)
{
    mdr_profile *p = NULL;
    int status = mdr_profile_table(MDR_HEIGHT, 3, x, y, &p);
    MDR_FREE(p);
    return status;
}
static int tip(void)
{
    const double C[2] = {24.5, 0.1};
    mdr_profile *p = NULL;
    int status = mdr_profile_area_function(2, C, 0.0, 1.0, &p);
    MDR_FREE(p);
    return status;
}
static int adhesive(void)
{
    mdr_contact *c = NULL;
    int status = mdr_contact_new(ball, film, &sticky, &c);
    if (status == MDR_SUCCESS) status = columns_of(c, MDR_DEPTH, 1, y + 1, NULL, out, NULL, NULL);
    MDR_FREE(c);
    return status;
}
static int states(void) { return columns_of(contact, MDR_DEPTH, 2, y + 1, NULL, NULL, out, NULL); }
static int exact_states(void) { return columns_of(exact_contact, MDR_DEPTH, 2, y + 1, NULL, NULL, out, NULL); }
static int layer_energies(void)
{
    static const mdr_state state = {0.1, 0.3, 0.05, 0.6, 0.0, 0.0};
    double energies[3];
    int count;
    return state_layer_energies(contact, MDR_BODY_LOWER, &state, 3, energies, &count);
}
static int interior(void)
{
    static const mdr_state state = {0.1, 0.3, 0.05, 0.6, 0.0, 0.0};
    mdr_interior inside;
    return state_interior(contact, MDR_BODY_LOWER, &state, MDR_SIDE_BELOW, 0.0, 1, x + 1, x + 1, NULL, &inside);
}
static int graded(void)
{
    mdr_medium *m = NULL;
    int status = medium_of_grades(3, x, E_graded, nu_graded, MDR_MODEL_EXACT, NULL, &m);
    MDR_FREE(m);
    return status;
}
static int power_graded(void)
{
    return field_at(broken_power, MDR_DISPLACEMENT, MDR_RADIUS, 0.5, 1, x + 2, out);
}
static int fields(void) { return field_at(contact, MDR_PRESSURE, MDR_RADIUS, 1.0, 3, x, out); }
#ifdef MDRCONTACT_FIT_H
static int fit(void)
{
    static const double depth[3] = {0.1, 0.2, 0.3}, load[3] = {0.05, 0.15, 0.3};
    mdr_fit_parameter p[30];
    mdr_fit_problem problem;
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    int status;
    problem = MDR_SIZED(mdr_fit_problem);
    problem.data_kind = MDR_FIT_FORCE_DEPTH;
    problem.profile = ball;
    problem.medium = film;
    problem.parameters = p;
    status = mdr_fit_parameters(&problem, 30, p, &problem.parameter_count);
    if (status != MDR_SUCCESS) return status;
    p[0].is_free = 1;
    status = mdr_fit_solve(&problem, 3, depth, load, NULL, NULL, NULL, NULL, NULL, NULL, NULL, out, NULL, &summary);
    /* the best point found is a result, marked by its flag */
    return status == MDR_SUCCESS && !summary.converged ? MDR_ENOCONVERGENCE : status;
}
#endif

/* Sound before, refused with that status and nothing written, sound again afterwards. */
static void check_refusal(const char *name, enum refused which, int (*call)(void), int expected)
{
    int status;
    CHECK_SUCCESS(call());
    fill_untouched(3, out);
    refused = which;
    refusals = 0;
    status = call();
    refused = NOTHING;
    if (status != expected || refusals == 0) printf("%s: %s, %d refusals\n", name, mdr_name_of(status), refusals);
    CHECK_INT(status, expected);
    CHECK_TRUE(refusals > 0);
    /* a fit gives the best point that it found */
    if (which != FIT_STEP) CHECK_UNTOUCHED(3, out);
    CHECK_SUCCESS(call());
}

int main(void)
{
    sticky = MDR_SIZED(mdr_contact_options);
    sticky.work_of_adhesion = 0.02;
    CHECK_SUCCESS(mdr_profile_paraboloid(1.0, &ball));
    CHECK_SUCCESS(new_layered(2, E, nu, h, 1.0, 0.4, MDR_MODEL_GAO, NULL, &film));
    /* so thin that LAPACK factorizes */
    CHECK_SUCCESS(new_layered(1, E, nu, thin, 1.0, 0.4, MDR_MODEL_EXACT, NULL, &exact_film));
    CHECK_SUCCESS(mdr_contact_new(ball, film, NULL, &contact));
    CHECK_SUCCESS(mdr_contact_new(ball, exact_film, NULL, &exact_contact));
    CHECK_SUCCESS(medium_of_power(1.0, 1.0, 0.4, 0.3, &rising));
    CHECK_SUCCESS(mdr_contact_new(ball, rising, NULL, &broken_power));

    check_refusal("table, no spline", SPLINE, table, MDR_ENOMEMORY);
    check_refusal("table, no rule", RULE, table, MDR_ENOMEMORY);
    check_refusal("tip, no rule", RULE, tip, MDR_ENOMEMORY);
    check_refusal("states, no rule", RULE, states, MDR_ENOMEMORY);
    check_refusal("fields, no rule", RULE, fields, MDR_ENOMEMORY);
    check_refusal("exact, no rule", RULE, exact_states, MDR_ENOMEMORY);
    check_refusal("layers, no rule", RULE, layer_energies, MDR_ENOMEMORY);
    check_refusal("interior, no rule", RULE, interior, MDR_ENOMEMORY);
    check_refusal("graded, no rule", RULE, graded, MDR_ENOMEMORY);
    check_refusal("power-law graded, no rule", RULE, power_graded, MDR_ENOMEMORY);
    check_refusal("adhesive, no root workspace", ROOT_WORKSPACE, adhesive, MDR_ENOMEMORY);
    check_refusal("adhesive, no start", ROOT_START, adhesive, MDR_ENOCONVERGENCE);
    check_refusal("adhesive, no step", ROOT_STEP, adhesive, MDR_ENOCONVERGENCE);
    check_refusal("adhesive, no end", ROOT_TEST, adhesive, MDR_ENOCONVERGENCE);
    check_refusal("exact, no factors", FACTORS, exact_states, MDR_ENOCONVERGENCE);
#ifdef MDRCONTACT_FIT_H
    check_refusal("fit, no step", FIT_STEP, fit, MDR_ENOCONVERGENCE);
#endif

    CHECK_FREE(broken_power);
    CHECK_FREE(rising);
    CHECK_FREE(exact_contact);
    CHECK_FREE(contact);
    CHECK_FREE(exact_film);
    CHECK_FREE(film);
    CHECK_FREE(ball);
    return check_report("failures of GSL and LAPACK");
}
