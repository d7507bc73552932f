/* SPDX-License-Identifier: GPL-3.0-or-later */
/* [force, slope, radius, stiffness] = law_states(law, depth): by the inline functions alone, without the library. */
#include <mdrcontact_law.h>

#include <mex.h>

void mexFunction(int results, mxArray *result[], int arguments, const mxArray *argument[])
{
    mdr_law_view view;
    double *to[4];

    if (results > 4 || arguments != 2) mexErrMsgTxt("[force, slope, radius, stiffness] = law_states(law, depth)");
    for (int i = 0; i < 2; i++) {
        if (!mxIsDouble(argument[i]) || mxIsComplex(argument[i])) mexErrMsgTxt("law and depth must be real numbers");
    }
    const double *const law = mxGetPr(argument[0]), *const depth = mxGetPr(argument[1]);
    const size_t size = mxGetNumberOfElements(argument[0]), n = mxGetNumberOfElements(argument[1]);
    if (size * sizeof *law < sizeof(mdr_law_head) || mdr_law_view_from(law, MDR_ON_UNLOADING, &view) != MDR_SUCCESS
        || mdr_law_head_of(&view)->size != (double)size) {
        mexErrMsgTxt("this is no law of law_of_ball");
    }
    const int wanted = results > 1 ? results : 1;
    for (int j = 0; j < wanted; j++) {
        result[j] = mxCreateDoubleMatrix(mxGetM(argument[1]), mxGetN(argument[1]), mxREAL);
        to[j] = mxGetPr(result[j]);
    }
    for (size_t i = 0; i < n; i++) {
        mdr_law_point point;
        if (mdr_law_view_state(&view, depth[i], &point) != MDR_SUCCESS) {
            mexErrMsgIdAndTxt("mdrcontact:depth", "depth = %g is beyond the law, which ends at %g", depth[i],
                              mdr_law_head_of(&view)->highest);
        }
        const double all[] = {point.force, point.slope, point.radius, point.stiffness};
        for (int j = 0; j < wanted; j++) to[j][i] = all[j];
    }
}
