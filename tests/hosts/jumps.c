/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host whose functions leave by longjmp, which the headers forbid: what the call had allocated is lost, but the thread computes on,
 * in the arithmetic that the host had set when a cancel function left. Then one whose cancel function makes long calls itself.
 */
#include "../c/check.h"

#include <fenv.h>
#include <setjmp.h>

enum { COUNT = 1 << 22 };

static jmp_buf back;
static double x[COUNT], y[COUNT];
static mdr_medium *medium;
static int deepest, depth, inner_status;
static char inner_text[256];

static int leave(void *context)
{
    (void)context;
    longjmp(back, 1);
}

static int leave_function(double r, double *f, void *context)
{
    if (r > 0.5) longjmp(back, 1);
    (void)context;
    *f = r * r;
    return 0;
}

/* A long call: some tenths of a second. */
static int long_call(void) { return mdr_medium_values(medium, MDR_MODULUS, COUNT / 2048, x, y); }

static int make_long_call(void *context)
{
    (void)context;
    depth++;
    if (depth > deepest) deepest = depth;
    if (depth < 50) inner_status = long_call();
    if (depth == 1) snprintf(inner_text, sizeof inner_text, "%s", mdr_last_error());
    depth--;
    return 0;
}

static void jump_out_of_cancel(int mode)
{
    fesetround(mode);
    if (setjmp(back) == 0) {
        CHECK_SUCCESS(mdr_set_cancel(leave, NULL));
        long_call();
        CHECK_TRUE(!"the cancel function was called");
    }
    CHECK_INT(fegetround(), mode);
    fesetround(FE_TONEAREST);
    CHECK_SUCCESS(mdr_set_cancel(NULL, NULL));
    CHECK_SUCCESS(long_call());
}

/* After a jump another function, which is asked as any other, and cancels. */
static int yes(void *context)
{
    ++*(int *)context;
    return 1;
}

static void cancel_after_jump(void)
{
    int asked = 0;
    if (setjmp(back) == 0) {
        CHECK_SUCCESS(mdr_set_cancel(leave, NULL));
        long_call();
    }
    CHECK_SUCCESS(mdr_set_cancel(yes, &asked));
    CHECK_INT(long_call(), MDR_ECANCELLED);
    CHECK_TRUE(asked > 0);
    CHECK_SUCCESS(mdr_set_cancel(NULL, NULL));
    CHECK_SUCCESS(long_call());
}

static void jump_out_of_function(void)
{
    mdr_profile *never = NULL, *bowl = NULL;
    if (setjmp(back) == 0) {
        mdr_profile_function(leave_function, NULL, 1.0, &never);
        CHECK_TRUE(!"the function was called");
    }
    CHECK_TRUE(never == NULL);
    CHECK_SUCCESS(mdr_profile_function(leave_function, NULL, 0.4, &bowl));
    CHECK_FREE(bowl);
}

static void call_from_within(void)
{
    CHECK_SUCCESS(mdr_set_cancel(make_long_call, NULL));
    CHECK_SUCCESS(long_call());
    CHECK_SUCCESS(mdr_set_cancel(NULL, NULL));
    CHECK_INT(deepest, 1);
    CHECK_INT(inner_status, MDR_EINVALID);
    CHECK_TRUE(strstr(inner_text, "it must return first") != NULL);
}

int main(void)
{
    const mdr_layer film = mdr_isotropic(10.0, 0.2, 0.5), below = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_body *body = NULL;

    for (int i = 0; i < COUNT; i++) x[i] = 0.01 + 1e-3 * (i % 5000);
    CHECK_SUCCESS(mdr_body_layered(1, &film, &below, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    jump_out_of_cancel(FE_TONEAREST);
    jump_out_of_cancel(FE_UPWARD);
    cancel_after_jump();
    jump_out_of_function();
    call_from_within();
    CHECK_FREE(medium);
    CHECK_FREE(body);
    return check_report("jumps");
}
