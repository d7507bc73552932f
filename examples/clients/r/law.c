/* SPDX-License-Identifier: GPL-3.0-or-later */
/* R's .Call to the C library: R CMD SHLIB law.c. A failure is an error of R with the library's words. */
#include <mdrcontact.h>

#include <R.h>
#include <Rinternals.h>

static void check(int status)
{
    char words[1024];
    if (status == MDR_SUCCESS) return;
    mdr_last_error(words, (int)sizeof words);
    error("%s", words);
}

static mdr_law *law_of(SEXP pointer) { return (mdr_law *)R_ExternalPtrAddr(pointer); }

static void forget(SEXP pointer)
{
    mdr_law *law = law_of(pointer);
    mdr_law_free(&law);
    R_ClearExternalPtr(pointer);
}

/* The law of a ball of radius R on a coated half-space; numbers: R, E and nu of the film, its thickness, E and nu below, largest depth. */
SEXP law_of_ball(SEXP numbers)
{
    const double *x = REAL(numbers);
    mdr_profile *ball = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    int status = mdr_profile_paraboloid(x[0], &ball);
    if (status == MDR_SUCCESS) status = mdr_medium_coated(x[1], x[2], x[3], x[4], x[5], MDR_MODEL_EXACT, NULL, &film);
    if (status == MDR_SUCCESS) status = mdr_contact_new(ball, film, NULL, &contact);
    if (status == MDR_SUCCESS) status = mdr_law_new(contact, x[6], NULL, &law);
    mdr_contact_free(&contact);
    mdr_medium_free(&film);
    mdr_profile_free(&ball);
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
    check(mdr_law_from_depth(law_of(pointer), MDR_ON_UNLOADING, n, REAL(depth), to, to + n, to + 2 * n, to + 3 * n));
    UNPROTECT(1);
    return states;
}
