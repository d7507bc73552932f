/* SPDX-License-Identifier: GPL-3.0-or-later */
/* R's .Call to the C library: R CMD SHLIB law.c. A failure is an error of R with the library's words. */
#include <mdrcontact.h>

#include <R.h>
#include <Rinternals.h>

static void check(int status)
{
    if (status != MDR_SUCCESS) error("%s", mdr_last_error());
}

static mdr_law *law_of(SEXP pointer) { return (mdr_law *)R_ExternalPtrAddr(pointer); }

static void forget(SEXP pointer)
{
    mdr_law *law = law_of(pointer);
    MDR_FREE(law);
    R_ClearExternalPtr(pointer);
}

/* The law of a ball of radius R on a coated half-space; numbers: R, E and nu of the film, its thickness, E and nu below, largest depth. */
SEXP law_of_ball(SEXP numbers)
{
    const double *x = REAL(numbers);
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    int status = mdr_profile_paraboloid(x[0], &ball);
    const mdr_layer coating = mdr_isotropic(x[1], x[2], x[3]), base = mdr_isotropic(x[4], x[5], 0.0);
    if (status == MDR_SUCCESS) status = mdr_body_layered(1, &coating, &base, NULL, &body);
    if (status == MDR_SUCCESS) status = mdr_medium_new(body, NULL, &film);
    if (status == MDR_SUCCESS) status = mdr_contact_new(ball, film, NULL, &contact);
    if (status == MDR_SUCCESS) status = mdr_law_new(contact, x[6], NULL, &law);
    MDR_FREE(contact);
    MDR_FREE(film);
    MDR_FREE(body);
    MDR_FREE(ball);
    check(status);
    SEXP pointer = PROTECT(R_MakeExternalPtr(law, R_NilValue, R_NilValue));
    R_RegisterCFinalizerEx(pointer, forget, TRUE);
    UNPROTECT(1);
    return pointer;
}

/* A matrix with a row for each depth: F, dF/dd, a, k. */
SEXP law_states(SEXP pointer, SEXP depth)
{
    const int n = length(depth);
    SEXP states = PROTECT(allocMatrix(REALSXP, n, 4));
    double *to = REAL(states);
    check(mdr_law_values(law_of(pointer), MDR_DEPTH, MDR_ON_UNLOADING, n, REAL(depth), NULL, to + 2 * n, to, to + 3 * n,
                         to + n, NULL));
    UNPROTECT(1);
    return states;
}
