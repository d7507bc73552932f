/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double extremes[] = {
    0.0, -0.0, 1.0, -1.0, 0.5, -0.5, NAN, INFINITY, -INFINITY, DBL_MAX, -DBL_MAX, DBL_MIN, DBL_TRUE_MIN, -DBL_TRUE_MIN,
    1e308, 1e300, 1e200, 1e155, 1e150, 1e100, 1e50, 1e20, 1e16, 1e-16, 1e-20, 1e-50, 1e-100, 1e-150, 1e-155, 1e-162, 1e-200,
    1e-300, 1e-310, 0x1p53, 0x1p63, 0x1p31, DBL_EPSILON, 1.0 - DBL_EPSILON, 1.0 + DBL_EPSILON, 1.5707963267948966, -1e-3, -1e100
};
static const int extreme_count = sizeof extremes / sizeof extremes[0];

int take_byte(input *in)
{
    return in->next < in->size ? in->bytes[in->next++] : 0;
}

int take_choice(input *in, int count)
{
    static const int outside[] = {-1, 99, 2147483647, -2147483647 - 1};
    const int b = take_byte(in);
    return b < 252 ? b % count : outside[b - 252];
}

int take_code(input *in, int count)
{
    const int choice = take_choice(in, count);
    return choice < 0 || choice >= count ? choice : choice + 1;
}

int take_member(input *in, int first, int count)
{
    const int choice = take_choice(in, count);
    return choice < 0 || choice >= count ? choice : first + choice;
}

int take_one_of(input *in, int count, const int codes[])
{
    const int choice = take_choice(in, count);
    return choice < 0 || choice >= count ? choice : codes[choice];
}

int take_chance(input *in)
{
    return take_byte(in) % 16 == 15;
}

int take_count(input *in)
{
    const int b = take_byte(in);
    if (b == 255) return -1;
    if (b == 254) return 0;
    return 1 + b % MOST_POINTS;
}

/* 1e-4 ... 1e4 in steps of about a tenth, finer by the second byte */
static double ordinary(input *in)
{
    const int coarse = take_byte(in), fine = take_byte(in);
    return pow(10.0, (coarse % 81 - 40) / 10.0) * (1.0 + fine / 2560.0);
}

double take_number(input *in)
{
    const int b = take_byte(in);
    if (b < 128) return ordinary(in);
    if (b < 160) return (b - 144) / 8.0;
    if (b < 208) return extremes[(b - 160) % extreme_count];
    if (b < 224) return pow(10.0, (take_byte(in) - 128) * 2.4);
    if (b < 232) return -ordinary(in);
    double value;
    uint64_t bits = 0;
    for (int i = 0; i < 8; i++) bits = bits << 8 | (uint64_t)take_byte(in);
    memcpy(&value, &bits, sizeof value);
    return value;
}

double take_positive(input *in)
{
    return take_chance(in) ? take_number(in) : ordinary(in);
}

double take_ratio(input *in)
{
    if (take_chance(in)) return take_number(in);
    return (take_byte(in) % 150 - 99) / 100.0;
}

void take_numbers(input *in, double values[MOST_POINTS])
{
    for (int i = 0; i < MOST_POINTS; i++) values[i] = take_number(in);
}

void take_positives(input *in, double values[MOST_POINTS])
{
    for (int i = 0; i < MOST_POINTS; i++) values[i] = take_positive(in);
}

void take_ratios(input *in, double values[MOST_POINTS])
{
    for (int i = 0; i < MOST_POINTS; i++) values[i] = take_ratio(in);
}

void take_ascending(input *in, double values[MOST_POINTS])
{
    if (take_chance(in)) {
        take_numbers(in, values);
        return;
    }
    values[0] = take_byte(in) % 2 == 0 ? 0.0 : take_positive(in);
    for (int i = 1; i < MOST_POINTS; i++) values[i] = values[i - 1] + take_positive(in);
}
