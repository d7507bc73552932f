/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A fuzzer's bytes read as choices and numbers. Where they end, zeros follow. */
#ifndef INPUT_H
#define INPUT_H

#include <stddef.h>
#include <stdint.h>

enum { MOST_POINTS = 6 };

typedef struct input {
    const uint8_t *bytes;
    size_t size;
    size_t next;
} input;

int take_byte(input *in);
int take_choice(input *in, int count);      /* 0 ... count-1, and now and then one that is out of range */
int take_code(input *in, int count);        /* 1 ... count, and now and then one that is out of range */
int take_member(input *in, int first, int count); /* first ... first + count - 1, and now and then a number that is none */
int take_one_of(input *in, int count, const int codes[]); /* one of the codes, and now and then a number that is none */
/* The same of the codes that are listed. */
#define TAKE_ONE_OF(in, ...) take_one_of(in, (int)(sizeof((const int[]){__VA_ARGS__}) / sizeof(int)), (const int[]){__VA_ARGS__})
int take_chance(input *in);                 /* 1 for one byte in sixteen */
int take_count(input *in);                  /* 1 ... MOST_POINTS, and now and then 0 or a negative number */
double take_number(input *in);              /* anything a double can be; ordinary sizes are the most frequent */
double take_positive(input *in);            /* mostly an ordinary positive number */
double take_ratio(input *in);               /* mostly a Poisson's ratio */
void take_numbers(input *in, double values[MOST_POINTS]);
void take_positives(input *in, double values[MOST_POINTS]);
void take_ratios(input *in, double values[MOST_POINTS]);
void take_ascending(input *in, double values[MOST_POINTS]); /* mostly: from 0 or a positive number upwards */

#endif
