/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of step.c, for LANES = 1, 2 or 4 sliders at a time. */
#if LANES > 1
#define number NAME(number)
#define whole NAME(whole)
typedef double number __attribute__((vector_size(8 * LANES)));
#define index NAME(index)
typedef int64_t whole __attribute__((vector_size(8 * LANES)));
typedef int32_t index __attribute__((vector_size(4 * LANES)));
#define ALL(x) ((x) - (number){0})
#define EITHER(set, a, b) ((number)(((whole)(set) & (whole)(a)) | (~(whole)(set) & (whole)(b))))
#else
#define number double
#define whole int
#define index int32_t
#define ALL(x) (x)
#define EITHER(set, a, b) ((set) ? (a) : (b))
#endif
enum { NAME(PARTS) = 4 / LANES };

INSIDE number NAME(load)(const double *from)
{
    number v;
    memcpy(&v, from, sizeof v);
    return v;
}

INSIDE void NAME(store)(double *to, number v)
{
    memcpy(to, &v, sizeof v);
}

/* The first `count` numbers, 0 behind them. */
INSIDE number NAME(load_some)(const double *from, int count)
{
    double some[LANES] = {0.0};
    if (count >= LANES) return NAME(load)(from);
    for (int j = 0; j < count; ++j) some[j] = from[j];
    return NAME(load)(some);
}

/* 0, 1, ... */
#if LANES == 4
static const index NAME(places) = {0, 1, 2, 3};
#elif LANES == 2
static const index NAME(places) = {0, 1};
#else
static const index NAME(places) = 0;
#endif

INSIDE index NAME(if_else)(index is, index a, int32_t b)
{
#if LANES > 1
    return (is & a) | (~is & b);
#else
    return is ? a : b;
#endif
}

/* The first three columns of the rows of four numbers that begin at some places of a table. */
INSIDE void NAME(columns)(const double *table, index row, number c[3])
{
#if LANES == 4
    const number x0 = NAME(load)(table + row[0]), x1 = NAME(load)(table + row[1]);
    const number x2 = NAME(load)(table + row[2]), x3 = NAME(load)(table + row[3]);
    const number a = __builtin_shufflevector(x0, x1, 0, 4, 2, 6), b = __builtin_shufflevector(x0, x1, 1, 5, 3, 7);
    const number d = __builtin_shufflevector(x2, x3, 0, 4, 2, 6), e = __builtin_shufflevector(x2, x3, 1, 5, 3, 7);
    c[0] = __builtin_shufflevector(a, d, 0, 1, 4, 5);
    c[1] = __builtin_shufflevector(b, e, 0, 1, 4, 5);
    c[2] = __builtin_shufflevector(a, d, 2, 3, 6, 7);
#elif LANES == 2
    const number x0 = NAME(load)(table + row[0]), x1 = NAME(load)(table + row[1]);
    c[0] = __builtin_shufflevector(x0, x1, 0, 2);
    c[1] = __builtin_shufflevector(x0, x1, 1, 3);
    c[2] = (number){table[row[0] + 2], table[row[1] + 2]};
#else
    for (int j = 0; j < 3; ++j) c[j] = table[row + j];
#endif
}

/* Of each slider what the next one has. */
INSIDE number NAME(next)(number these, number later)
{
#if LANES == 4
    return __builtin_shufflevector(these, later, 1, 2, 3, 4);
#elif LANES == 2
    return __builtin_shufflevector(these, later, 1, 2);
#else
    (void)these;
    return later;
#endif
}

/* Whether any of a comparison's results is true. */
INSIDE int NAME(any)(whole set)
{
#if LANES == 4
    return __builtin_ia32_movmskpd256((number)set) != 0;
#elif LANES == 2
    return (set[0] | set[1]) != 0;
#else
    return set != 0;
#endif
}

/* Whether all of them are. */
INSIDE int NAME(every)(whole set)
{
#if LANES > 1
    return !NAME(any)(~set);
#else
    return set;
#endif
}

INSIDE number NAME(least)(number a, number b)
{
#if LANES == 4
    return __builtin_ia32_minpd256(a, b);
#else
    return EITHER(a < b, a, b);
#endif
}

INSIDE number NAME(most)(number a, number b)
{
#if LANES == 4
    return __builtin_ia32_maxpd256(a, b);
#else
    return EITHER(a > b, a, b);
#endif
}

INSIDE number NAME(size)(number a)
{
#if LANES > 1
    return (number)((whole)a & INT64_MAX);
#else
    return fabs(a);
#endif
}

INSIDE number NAME(root)(number a)
{
#if LANES == 4
    return (number){sqrt(a[0]), sqrt(a[1]), sqrt(a[2]), sqrt(a[3])};
#elif LANES == 2
    return (number){sqrt(a[0]), sqrt(a[1])};
#else
    return sqrt(a);
#endif
}

/* The sum of four lanes. */
INSIDE double NAME(sum)(const number part[4 / LANES])
{
#if LANES == 4
    return (part[0][0] + part[0][2]) + (part[0][1] + part[0][3]);
#elif LANES == 2
    const number both = part[0] + part[1];
    return both[0] + both[1];
#else
    return (part[0] + part[2]) + (part[1] + part[3]);
#endif
}

/* What a slider has from its lower end on: P, K to the top before and after the step; and of springs that touch. */
#define ends NAME(ends)
typedef struct ends {
    number load, slope, before, after, newborn, newborn_slope;
} ends;

INSIDE ends NAME(ends_at)(const given *of, const place *at, const motion *m, int i, int kind, double x, double rate)
{
    const int grows = kind & GROWS, wanted = kind & TANGENT;
    ends end;
    number c[3];
    index level, row, share;
    memcpy(&level, m->level + i, sizeof level);
    if (kind & GENERAL) level = NAME(if_else)(NAME(places) + i < m->used, level, of->count + 1);
    row = 4 * level;
    NAME(columns)(of->row, row, c);
    const number none = ALL(0.0), S = c[0], F = c[1], k = c[2], top = ALL(m->top[2]);
    end.before = NAME(least)(k, top);
    end.after = grows ? NAME(least)(k, NAME(most)(top, ALL(at->stiffness))) : end.before;
    end.slope = end.newborn = end.newborn_slope = none;
    if ((kind & GENERAL) && m->of_radius) {
        end.load = NAME(load)(m->beyond + i);
        end.slope = NAME(load)(m->slope + i);
        if (!grows) return end;
        end.newborn = NAME(load)(m->newborn + i);
        end.newborn_slope = NAME(load)(m->newborn_slope + i);
        return end;
    }
    end.load = NAME(most)((at->force - F) - k * NAME(most)(at->shift - S, none), none);
    if (wanted) end.slope = EITHER(end.load > 0.0, 1.0 - NAME(least)(k, ALL(at->stiffness)) * at->rate, none);
    if (of->share) {
        /* the row behind those of levels below S is that of a whole share */
        share = 4 * (m->first_share + NAME(if_else)(level <= m->cell, level, m->cell + 1));
        NAME(columns)(of->share, share, c);
        const number part = c[0] + x * (c[1] + x * c[2]), shared = part * end.load, all = ALL(at->load);
        if (wanted) {
            end.slope = part * end.slope + (rate * (c[1] + (2.0 * x) * c[2])) * end.load;
            end.slope = EITHER(shared > all, ALL(1.0), end.slope);
        }
        end.load = NAME(least)(shared, all);
    }
    if ((kind & GENERAL) && m->is_settled) end.load = NAME(load)(m->beyond + i);
    if (!grows) return end;
    /* from where S was largest, or from where they touch */
    const number S1 = EITHER(S > m->top[0], S, ALL(m->top[0])), F1 = EITHER(S > m->top[0], F, ALL(m->top[1]));
    const number k1 = EITHER(S > m->top[0], k, top);
    end.newborn = NAME(most)((at->force - F1) - k1 * NAME(most)(at->shift - S1, none), none);
    if (wanted) end.newborn_slope = EITHER(end.newborn > 0.0, (at->stiffness - k1) * at->rate, none);
    return end;
}

/* What a slider loses as springs that touch become part of it: theirs and its loads add, as where two sliders join. */
INSIDE number NAME(mixing)(const number y[3], number k, number after, number born, const double g[3])
{
    const number none = ALL(0.0), weakest = ALL(DBL_MIN), grew = NAME(most)(after - k, none);
    const number by_k = EITHER(k > weakest, 1.0 / NAME(most)(k, weakest), none);
    const number by_grew = EITHER(grew > weakest, 1.0 / NAME(most)(grew, weakest), none);
    number square = none;
    UNROLLED for (int j = 0; j < 3; ++j) {
        const number theirs = born * g[j], unlike = (y[j] - theirs) * by_k - theirs * by_grew;
        square += unlike * unlike;
    }
    return NAME(least)(square * (0.5 * k * (grew / NAME(most)(after, weakest))), ALL(MOST_LOST));
}

/* Returns whether P rises anywhere from a level to the next: then nothing else is of use but P. */
INSIDE int NAME(move)(const given *of, const place *at, motion *m, const double t[], int kind, double tangent[])
{
    const int grows = kind & GROWS, wanted = kind & TANGENT;
    const double mu = of->strength, *way = m->way;
    const int sliders = of->sliders;
    const number none = ALL(0.0), weakest = ALL(DBL_MIN);
    number total[3][4 / LANES], lost[4 / LANES], all[4 / LANES], by_force[3][4 / LANES], squares[6][4 / LANES];
    number turned[3][4 / LANES], falls = none;
    whole weakens = none > 0.0;
    growth grown;
    double x = 0.0, rate = 0.0;
    ends later = {none, none, ALL(m->top[2]), ALL(m->top[2]), none, none};

    UNROLLED for (int part = 0; part < NAME(PARTS); ++part) {
        lost[part] = all[part] = none;
        UNROLLED for (int j = 0; j < 3; ++j) total[j][part] = by_force[j][part] = turned[j][part] = none;
        UNROLLED for (int j = 0; j < 6; ++j) squares[j][part] = none;
    }
    if (grows) {
        grown = growth_of(m, at, mu);
        if (at->stiffness > m->top[2]) later.after = ALL(at->stiffness);
    }
    if (of->share) {
        /* beyond the last level all stays as it is there */
        const double *row = of->row + 4 * m->cell;
        x = (at->shift - row[0]) * row[3];
        rate = at->rate * row[3];
    }
    for (int four = (m->used - 1) & ~3; four >= 0; four -= 4) {
        UNROLLED for (int part = NAME(PARTS) - 1; part >= 0; --part) {
            const int i = four + part * LANES, is_full = i + LANES <= sliders;
            const ends end = NAME(ends_at)(of, at, m, i, kind, x, rate);
            const number drop = end.load - NAME(next)(end.load, later.load);
            const number strength = mu * (kind & GENERAL ? NAME(most)(drop, none) : drop);
            const number k = NAME(next)(end.before, later.before) - end.before;
            const number after = grows ? NAME(next)(end.after, later.after) - end.after : k;
            number old[3], y[3], n[3], born = none;
            falls = NAME(least)(falls, drop);
            if (grows) born = end.newborn - NAME(next)(end.newborn, later.newborn);
            UNROLLED for (int j = 0; j < 3; ++j) {
                if (is_full) {
                    old[j] = NAME(load)(t + j * sliders + i);
                } else {
                    old[j] = NAME(load_some)(t + j * sliders + i, sliders - i);
                }
                y[j] = old[j] + k * way[j];
                if (grows) y[j] += born * grown.g[j];
            }
            if (grows && NAME(any)(after > k)) lost[part] += NAME(mixing)(y, k, after, born, grown.g);
            const number former = (old[0] * old[0] + old[1] * old[1]) + old[2] * old[2];
            const number squared = (y[0] * y[0] + y[1] * y[1]) + y[2] * y[2], most = strength * strength;
            number inverse = none, factor = ALL(1.0);
            if (NAME(any)(squared >= most)) {
                inverse = 1.0 / NAME(most)(NAME(root)(squared), weakest);
                factor = EITHER(squared < most, factor, NAME(least)(strength * inverse, factor));
                const number slipped = (factor * (1.0 - factor)) * squared;
                lost[part] += NAME(least)(slipped, MOST_LOST * after) / NAME(most)(after, weakest);
            }
            weakens |= former > (WITHIN * WITHIN) * most;
            UNROLLED for (int j = 0; j < 3; ++j) {
                const number borne = factor * y[j];
                total[j][part] += borne;
                NAME(store)(m->borne[j] + i, borne);
            }
            NAME(store)(m->stiffness + i, after);
            NAME(store)(m->strength + i, strength);
            if (kind & GENERAL) {
                NAME(store)(m->beyond + i, end.load);
                NAME(store)(m->factor + i, factor);
            }
            if (wanted) {
                /* K' I - K' n n^T of those that slip, K I of those that stick, and mu dB/dF n; n = y/|y| */
                const number slides = EITHER(factor < SLIPS, inverse, none);
                const number along = factor * (grows ? k + grown.one * born : k);
                number change = mu * (end.slope - NAME(next)(end.slope, later.slope));
                UNROLLED for (int j = 0; j < 3; ++j) n[j] = slides * y[j];
                all[part] += along;
                squares[0][part] += (along * n[0]) * n[0];
                squares[1][part] += (along * n[0]) * n[1];
                squares[2][part] += (along * n[0]) * n[2];
                squares[3][part] += (along * n[1]) * n[1];
                squares[4][part] += (along * n[1]) * n[2];
                squares[5][part] += (along * n[2]) * n[2];
                if (grows) {
                    const number born_slope = end.newborn_slope - NAME(next)(end.newborn_slope, later.newborn_slope);
                    const number as_turned = factor * (grown.turned * born);
                    const number ahead = (grown.e[0] * n[0] + grown.e[1] * n[1]) + grown.e[2] * n[2];
                    number change_of[3];
                    UNROLLED for (int j = 0; j < 3; ++j) {
                        change_of[j] = factor * (born_slope * grown.g[j] + born * grown.by_force[j]);
                        turned[j][part] += as_turned * (grown.e[j] - ahead * n[j]);
                        by_force[j][part] += change_of[j];
                    }
                    change -= (change_of[0] * n[0] + change_of[1] * n[1]) + change_of[2] * n[2];
                }
                UNROLLED for (int j = 0; j < 3; ++j) by_force[j][part] += change * n[j];
            }
            later = end;
        }
    }
    if (NAME(any)(falls < none) && !((kind & GENERAL) && m->is_settled)) return 1;
    UNROLLED for (int j = 0; j < 3; ++j) m->total[j] = NAME(sum)(total[j]);
    m->lost = NAME(sum)(lost);
    if (NAME(any)(weakens)) m->lost += weakening(of, m, t);
    if (!wanted) return 0;
    const double whole_k = NAME(sum)(all);
    double pair[6], along[3];
    UNROLLED for (int j = 0; j < 6; ++j) pair[j] = NAME(sum)(squares[j]);
    UNROLLED for (int j = 0; j < 3; ++j) tangent[4 * j + 3] = NAME(sum)(by_force[j]);
    tangent[0] = whole_k - pair[0];
    tangent[5] = whole_k - pair[3];
    tangent[10] = whole_k - pair[5];
    tangent[1] = tangent[4] = -pair[1];
    tangent[2] = tangent[8] = -pair[2];
    tangent[6] = tangent[9] = -pair[4];
    if (!grows) return 0;
    UNROLLED for (int i = 0; i < 3; ++i) {
        along[i] = NAME(sum)(turned[i]);
        UNROLLED for (int j = 0; j < 3; ++j) tangent[4 * i + j] -= along[i] * grown.e[j];
    }
    return 0;
}

static void NAME(one)(const given *of, const place *at, motion *m, const double t[], double tangent[])
{
    for (;;) {
        int falls;
        if (m->grows) {
            falls = tangent ? NAME(move)(of, at, m, t, GENERAL | GROWS | TANGENT, tangent)
                            : NAME(move)(of, at, m, t, GENERAL | GROWS, NULL);
        } else {
            falls = tangent ? NAME(move)(of, at, m, t, GENERAL | TANGENT, tangent) : NAME(move)(of, at, m, t, GENERAL, NULL);
        }
        if (!falls) return;
        settle(m);
    }
}

/* The record after a step in which its sliders stay the same. */
INSIDE void NAME(keep)(const given *of, const place *at, const motion *m, double record[])
{
    record[AT_LOST] += m->lost;
    record[AT_SHIFT] = at->shift;
    if (m->grows) {
        record[AT_TOP] = at->shift;
        record[AT_TOP + 1] = at->force;
        record[AT_TOP + 2] = at->stiffness > m->top[2] ? at->stiffness : m->top[2];
    }
    double *t = record + HEAD + of->sliders;
    for (int j = 0; j < 3; ++j, t += of->sliders) {
        int i = 0;
        for (; i + LANES <= of->sliders && i < m->used; i += LANES) NAME(store)(t + i, NAME(load)(m->borne[j] + i));
        for (; i < m->used; ++i) t[i] = m->borne[j][i];
    }
}

/* Steps up to the first that does not leave the sliders as they are; how many. */
INSIDE int NAME(run)(const given *of, const steps *these, int wanted)
{
    const int size = HEAD + 4 * of->sliders;
    motion m;
    m.of_radius = m.at_once = 0;
    for (int i = 0; i < these->n; ++i) {
        double *record = these->memory + (int64_t)size * i;
        const place at = {these->force[i], these->level[i], 1.0 / these->compliance[i], these->compliance[i], these->force[i]};
        if (!keeps_sliders(of, &at, record, these->is_trial, &m)) return i;
        memcpy(m.way, these->shift + 3 * i, sizeof m.way);
        const double *t = record + HEAD + of->sliders;
        double *tangent = wanted ? these->tangent + 12 * i : NULL;
        if (m.grows ? NAME(move)(of, &at, &m, t, GROWS | wanted, tangent) : NAME(move)(of, &at, &m, t, wanted, tangent)) return i;
        memcpy(these->traction + 3 * i, m.total, sizeof m.total);
        if (!these->is_trial) NAME(keep)(of, &at, &m, record);
    }
    return these->n;
}

static int NAME(many)(const given *of, const steps *these)
{
    return these->tangent ? NAME(run)(of, these, TANGENT) : NAME(run)(of, these, 0);
}

/* Whether a record has begun, and is one that a step of the law left. */
INSIDE int NAME(is_begun)(const given *of, double mark, const double record[])
{
    const int size = 3 * of->sliders;
    const double next = record[AT_NEXT], *level = record + HEAD, *t = level + of->sliders;
    number part[4 / LANES];
    if (!(record[0] == mark && next >= 1.0 && next <= of->count + 1.0)) return 0;
    if (!(record[AT_USED] >= 1.0 && record[AT_USED] <= of->sliders)) return 0;
    const int used = (int)record[AT_USED];
    if (!(record[AT_SHIFT] >= 0.0 && record[AT_TOP] >= record[AT_SHIFT] && record[AT_TOP + 2] >= 0.0 && level[0] == 0.0)) return 0;
    /* also for NaN and infinity */
    UNROLLED for (int j = 0; j < NAME(PARTS); ++j) {
        const double *head = record + AT_SHIFT + j * LANES;
        part[j] = NAME(size)(NAME(load)(head)) + NAME(size)(NAME(load)(head + 4));
    }
    int i = 0;
    for (; i + 4 <= size; i += 4) {
        UNROLLED for (int j = 0; j < NAME(PARTS); ++j) part[j] += NAME(size)(NAME(load)(t + i + j * LANES));
    }
    double total = NAME(sum)(part);
    for (; i < size; ++i) total += fabs(t[i]);
    if (!(total <= LARGEST * size)) return 0;
    whole rises = ALL(0.0) < 1.0;
    for (i = 0; i + LANES < used; i += LANES) rises &= NAME(load)(level + i + 1) - NAME(load)(level + i) >= 1.0;
    if (!NAME(every)(rises)) return 0;
    for (; i + 1 < used; ++i) {
        if (!(level[i + 1] - level[i] >= 1.0)) return 0;
    }
    return next - level[used - 1] >= 1.0;
}

static int NAME(begun)(const given *of, double mark, const double record[])
{
    return NAME(is_begun)(of, mark, record);
}

/* How many contacts, from the first one on, can certainly take their step. */
static int NAME(sound)(const given *of, double mark, double highest, int n, const double force[], const double shift[],
                       const double memory[])
{
    const int size = HEAD + 4 * of->sliders;
    const double k = of->row[4 * of->count + 2], stiffest = k > 1.0 ? k : 1.0;
    for (int i = 0; i < n; ++i) {
        const double *way = shift + 3 * i;
        if (!(force[i] >= 0.0 && force[i] <= highest)) return i;
        if (!((fabs(way[0]) + fabs(way[1]) + fabs(way[2])) * stiffest <= LARGEST)) return i;
        if (!NAME(is_begun)(of, mark, memory + (int64_t)size * i)) return i;
    }
    return n;
}
#undef number
#undef whole
#undef index
#undef ends
#undef ALL
#undef EITHER
