/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Poroelastic gels: a table, and what it answers. */
#include "world.h"

#include <stddef.h>

enum { PRICE_OF_TABLE = 90 };

void fuzz_gels(world *w)
{
    const double nu = take_ratio(&w->in), ratio = take_chance(&w->in) ? take_positive(&w->in) : 0.0;
    const int drainage = TAKE_ONE_OF(&w->in, MDR_DRAINAGE_SURFACE, MDR_DRAINAGE_SEALED, MDR_DRAINAGE_INDENTER),
            answer = TAKE_ONE_OF(&w->in, MDR_RELAXATION, MDR_CREEP, MDR_PARABOLOID_RELAXATION, MDR_MEAN_RELAXATION,
            MDR_MEAN_CREEP), n = take_count(&w->in);
    const double G = take_positive(&w->in), D = take_positive(&w->in), a = take_positive(&w->in);
    double x[MOST_POINTS], time[MOST_POINTS], path[MOST_POINTS], out[MOST_POINTS], loss[MOST_POINTS];
    mdr_poroelastic *gel = NULL;
    int status;

    take_positives(&w->in, x);
    if (!afford(w, PRICE_OF_TABLE)) return;
    status = mdr_poroelastic_new(nu, drainage, ratio, out, &gel);
    judge_object("mdr_poroelastic_new", status, gel);
    fill(out);
    fill(out);
    judge("mdr_poroelastic_response", mdr_poroelastic_response(gel, answer, G, D, a, n, x, out), n, out, NOT_NAN);
    take_ascending(&w->in, time);
    take_numbers(&w->in, path);
    fill(out);
    status = mdr_poroelastic_history(gel, TAKE_ONE_OF(&w->in, MDR_DEPTH, MDR_FORCE, MDR_RADIUS), G, D, a, n, time, path, out);
    judge("mdr_poroelastic_history", status, n, out, NOT_NAN);
    fill(out);
    fill(loss);
    status = mdr_poroelastic_dynamic_stiffness(gel, G, D, a, n, x, out, loss);
    judge("mdr_poroelastic_dynamic_stiffness", status, n, out, NOT_NAN);
    judge("mdr_poroelastic_dynamic_stiffness", status, n, loss, NOT_NAN);
    fill(out);
    status = mdr_poroelastic_pressure(gel, TAKE_ONE_OF(&w->in, MDR_TOTAL_PRESSURE, MDR_PORE_PRESSURE), take_byte(&w->in) % 2, G,
            D, a, take_positive(&w->in), n, x, out);
    judge("mdr_poroelastic_pressure", status, n, out, NOT_NAN);
    fill(out);
    fill(loss);
    status = mdr_poroelastic_compliance(nu, drainage, ratio, G, D, n, x, time, out, loss);
    judge("mdr_poroelastic_compliance", status, n, out, NOT_NAN);
    judge("mdr_poroelastic_compliance", status, n, loss, NOT_NAN);
    judge_status("mdr_free", mdr_free(gel));
}
