/* SPDX-License-Identifier: GPL-3.0-or-later */
/* law = law_of_ball(R, [E nu] of the film, thickness, [E nu] below, largest depth): the law of a ball on a coated half-space as a row of
 * numbers, which Octave saves, copies and hands to processes as any other. mkoctfile --mex law_of_ball.c. */
#include <mdrcontact.h>

#include <mex.h>

static void check(int status)
{
    if (status != MDR_SUCCESS) mexErrMsgIdAndTxt("mdrcontact:refused", "%s", mdr_last_error());
}

void mexFunction(int results, mxArray *result[], int arguments, const mxArray *argument[])
{
    static const int sizes[] = {1, 2, 1, 2, 1};
    const double *x[5];
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *film = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);

    if (results > 1 || arguments != 5) mexErrMsgTxt("law = law_of_ball(R, [E nu], thickness, [E nu], largest_depth)");
    for (int i = 0; i < 5; i++) {
        if (!mxIsDouble(argument[i]) || mxIsComplex(argument[i]) || (int)mxGetNumberOfElements(argument[i]) != sizes[i]) {
            mexErrMsgTxt("law_of_ball takes real numbers: one, two, one, two, one");
        }
        x[i] = mxGetPr(argument[i]);
    }
    int status = mdr_profile_paraboloid(x[0][0], &ball);
    if (status == MDR_SUCCESS) {
        const mdr_layer coating = mdr_isotropic(x[1][0], x[1][1], x[2][0]), base = mdr_isotropic(x[3][0], x[3][1], 0.0);
        status = mdr_body_layered(1, &coating, &base, NULL, &body);
    }
    if (status == MDR_SUCCESS) status = mdr_medium_new(body, NULL, &film);
    if (status == MDR_SUCCESS) status = mdr_contact_new(ball, film, NULL, &contact);
    if (status == MDR_SUCCESS) status = mdr_law_new(contact, x[4][0], NULL, &law);
    if (status == MDR_SUCCESS) status = mdr_law_about(law, &facts);
    MDR_FREE(contact);
    MDR_FREE(film);
    MDR_FREE(body);
    MDR_FREE(ball);
    check(status);
    result[0] = mxCreateDoubleMatrix(1, (mwSize)facts.buffer_size, mxREAL);
    status = mdr_law_buffer(law, facts.buffer_size, mxGetPr(result[0]));
    MDR_FREE(law);
    check(status);
}
