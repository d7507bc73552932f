/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Part of kernel.c, for LANES = 2 or 4 points at a time: the inline functions of mdrcontact_law.h with vectors instead of numbers.
 * A row of coefficients is loaded as it lies in memory, and the rows of all lanes are transposed.
 */
#define number NAME(number)
#define whole NAME(whole)
typedef double number __attribute__((vector_size(8 * LANES)));
typedef uint64_t whole __attribute__((vector_size(8 * LANES)));

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

/* The coefficients c[j] of all lanes, whose rows lie `stride` apart. */
INSIDE void NAME(rows)(const double *table, uint64_t stride, const whole *panel, number c[8])
{
#if LANES == 2
    uint64_t at[2];
    memcpy(at, panel, sizeof at);
    const double *p0 = table + stride * at[0], *p1 = table + stride * at[1];
    for (int j = 0; j < 8; j += 2) {
        const number x0 = NAME(load)(p0 + j), x1 = NAME(load)(p1 + j);
        c[j] = __builtin_shufflevector(x0, x1, 0, 2);
        c[j + 1] = __builtin_shufflevector(x0, x1, 1, 3);
    }
#else
    const double *p0 = table + stride * (*panel)[0], *p1 = table + stride * (*panel)[1];
    const double *p2 = table + stride * (*panel)[2], *p3 = table + stride * (*panel)[3];
    for (int j = 0; j < 8; j += 4) {
        const number x0 = NAME(load)(p0 + j), x1 = NAME(load)(p1 + j), x2 = NAME(load)(p2 + j), x3 = NAME(load)(p3 + j);
        const number a = __builtin_shufflevector(x0, x1, 0, 4, 2, 6), b = __builtin_shufflevector(x0, x1, 1, 5, 3, 7);
        const number d = __builtin_shufflevector(x2, x3, 0, 4, 2, 6), e = __builtin_shufflevector(x2, x3, 1, 5, 3, 7);
        c[j] = __builtin_shufflevector(a, d, 0, 1, 4, 5);
        c[j + 1] = __builtin_shufflevector(b, e, 0, 1, 4, 5);
        c[j + 2] = __builtin_shufflevector(a, d, 2, 3, 6, 7);
        c[j + 3] = __builtin_shufflevector(b, e, 2, 3, 6, 7);
    }
#endif
}

INSIDE number NAME(polynomial)(const number c[8], number t)
{
    const number q = t * t;
    return (c[0] + q * (c[2] + q * (c[4] + q * c[6]))) + t * (c[1] + q * (c[3] + q * (c[5] + q * c[7])));
}

INSIDE number NAME(polynomial_with_slope)(const number c[8], number t, number *slope)
{
    const number q = t * t;
    number even = c[4] + q * c[6], odd = c[5] + q * c[7];
    number even_slope = even + q * c[6], odd_slope = odd + q * c[7];
    even = c[2] + q * even;
    odd = c[3] + q * odd;
    even_slope = even + q * even_slope;
    odd_slope = odd + q * odd_slope;
    even = c[0] + q * even;
    odd = c[1] + q * odd;
    *slope = odd + (t + t) * (even_slope + t * odd_slope);
    return even + t * odd;
}

/* a where all bits are set, b where none is. */
INSIDE number NAME(either)(whole set, number a, number b)
{
    return (number)((set & (whole)a) | (~set & (whole)b));
}

/* Panels and places of the points from s on. The view is a copy: what is written to the outputs cannot change it. */
INSIDE whole NAME(panels)(const mdr_law_view *view, const double *s, number *t)
{
    const number lowest = view->lowest - (number){0}, highest = view->highest - (number){0};
    number d = NAME(load)(s);
    d = NAME(either)((whole)(d > lowest), d, lowest);
    d = NAME(either)((whole)(d < highest), d, highest);
    const number y = view->scale * d + view->offset;
    const whole bits = (whole)y;
    *t = y - (number)((bits & view->mask) | view->half);
    return (bits - UINT64_C(0x3ff0000000000000)) >> (uint64_t)view->shift;
}

/* Returns how many points it did: what is left is less than LANES. */
INSIDE int NAME(points)(const mdr_law_view *of, int n, const double s[], double other[], double slope[], double radius[],
                        double stiffness[])
{
    const mdr_law_view copy = *of, *view = &copy;
    number c[8], t, rate;
    int i = 0;
    if (other && !slope && !radius && !stiffness) {
        for (; i + LANES <= n; i += LANES) {
            const whole panel = NAME(panels)(view, s + i, &t);
            NAME(rows)(view->force, 8, &panel, c);
            NAME(store)(other + i, NAME(polynomial)(c, t));
        }
    } else if (other && slope && !radius && !stiffness) {
        for (; i + LANES <= n; i += LANES) {
            const whole panel = NAME(panels)(view, s + i, &t);
            NAME(rows)(view->force, 8, &panel, c);
            NAME(store)(other + i, NAME(polynomial_with_slope)(c, t, &rate));
            NAME(store)(slope + i, view->scale * rate);
        }
    } else {
        for (; i + LANES <= n; i += LANES) {
            const whole panel = NAME(panels)(view, s + i, &t);
            if (other || slope) {
                NAME(rows)(view->force, 8, &panel, c);
                const number value = NAME(polynomial_with_slope)(c, t, &rate);
                if (other) NAME(store)(other + i, value);
                if (slope) NAME(store)(slope + i, view->scale * rate);
            }
            if (radius) {
                NAME(rows)(view->contact, 16, &panel, c);
                NAME(store)(radius + i, NAME(polynomial)(c, t));
            }
            if (stiffness) {
                NAME(rows)(view->contact + 8, 16, &panel, c);
                NAME(store)(stiffness + i, NAME(polynomial)(c, t));
            }
        }
    }
    return i;
}
#undef number
#undef whole
