/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program may have global functions of any name that does not begin with mdr_: the library never calls them. */
#include "check.h"
#include "mdrcontact/fit.h"

/* Functions that the library has inside, under the names they have there. */
static int calls;
int residual_callback(void);
int jacobian_callback(void);
double evaluate(double x, void *params);

int residual_callback(void) { return calls++, 0; }
int jacobian_callback(void) { return calls++, 0; }
double evaluate(double x, void *params) { return calls++, params != NULL ? 0.0 : x; }

/* A sphere's force on a medium of E* = 3e9 found back from the data; the depths come from the library's root search. */
int main(void)
{
    enum { POINTS = 20, NUMBERS = 13 };
    mdr_fit_problem problem;
    mdr_fit_parameter parameters[NUMBERS];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    mdr_profile *profile = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    double d[POINTS], F[POINTS], values[NUMBERS];

    CHECK_INT(mdr_profile_sphere(1e-6, &profile), MDR_SUCCESS);
    CHECK_INT(new_homogeneous(3e9, 0.3, &medium), MDR_SUCCESS);
    CHECK_INT(mdr_contact_new(profile, medium, NULL, &contact), MDR_SUCCESS);
    for (int i = 0; i < POINTS; i++) d[i] = 5e-9 * (i + 1);
    CHECK_INT(columns_of(contact, MDR_DEPTH, POINTS, d, NULL, NULL, F, NULL), MDR_SUCCESS);

    problem = MDR_SIZED(mdr_fit_problem);
    problem.profile = profile;
    problem.medium = medium;
    problem.parameters = parameters;
    CHECK_INT(mdr_fit_parameters(&problem, NUMBERS, parameters, &problem.parameter_count), MDR_SUCCESS);
    parameters[1].value = 1e9;
    parameters[1].is_free = 1;
    CHECK_INT(mdr_fit_solve(&problem, POINTS, d, F, NULL, NULL, values, NULL, NULL, NULL, NULL, NULL, NULL, &summary), MDR_SUCCESS);
    CHECK_INT(summary.converged, 1);
    CHECK_CLOSE(values[1], 3e9, 1e-6);
    CHECK_INT(calls, 0);

    MDR_FREE(contact);
    MDR_FREE(medium);
    MDR_FREE(profile);
    return check_report("names");
}
