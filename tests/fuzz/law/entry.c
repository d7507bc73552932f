/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The reader of saved laws. The first byte of the input says what the others are: the text of a file as it is, a text whose
 * checksum is put right first (it would stop almost every mutation at the gate), or the bits of the numbers, from which the
 * text is made.
 * A law that is accepted is evaluated everywhere: it may be wrong, but it must be tame.
 */
#include "mdrcontact.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { DEPTHS = 9, CHECKSUM_LINE = 15, LARGEST = 1 << 16 };

static uint32_t crc32_of(const uint8_t *bytes, size_t size)
{
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int j = 0; j < 8; j++) crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
    }
    return ~crc;
}

static void mend_checksum(char *text, size_t size)
{
    char line[CHECKSUM_LINE + 1];
    if (size < CHECKSUM_LINE) return;
    snprintf(line, sizeof line, "crc32 %08X\n", (unsigned)crc32_of((const uint8_t *)text, size - CHECKSUM_LINE));
    memcpy(text + size - CHECKSUM_LINE, line, CHECKSUM_LINE);
}

static void finding(const char *what)
{
    fprintf(stderr, "FINDING: a law from a file: %s\n", what);
    abort();
}

static void evaluate(const mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    mdr_law_point point;
    double x[DEPTHS], v[4][DEPTHS];
    int segment = 0, length = 0, status;

    if (mdr_law_about(law, &facts) != MDR_SUCCESS) finding("has no facts");
    if (!facts.description) finding("has no description");
    for (int branch = MDR_ON_LOADING; branch <= MDR_ON_UNLOADING; branch++) {
        for (int i = 0; i < DEPTHS; i++) {
            const double t = (i - 1) / (DEPTHS - 3.0);
            x[i] = facts.lowest_depth + t * (facts.highest_depth - facts.lowest_depth);
            if (mdr_law_follow(law, x[i], &segment, &point) == MDR_SUCCESS) {
                if (isnan(point.force) || isnan(point.radius)) finding("mdr_law_follow gives NaN");
            }
            if (mdr_law_force(law, branch, x[i], &v[0][0], &v[1][0]) == MDR_SUCCESS && isnan(v[0][0])) {
                finding("mdr_law_force gives NaN");
            }
        }
        for (int i = 0; i < DEPTHS; i++) {
            status = mdr_law_values(law, MDR_DEPTH, branch, 1, &x[i], NULL, v[2], v[0], v[3], v[1], NULL);
            if (status == MDR_SUCCESS && isnan(v[0][0])) finding("mdr_law_values gives NaN at a depth");
            x[i] = facts.lowest_force + (i - 1) / (DEPTHS - 3.0) * (facts.highest_force - facts.lowest_force);
            status = mdr_law_values(law, MDR_FORCE, branch, 1, &x[i], v[0], v[2], NULL, v[3], v[1], NULL);
            if (status == MDR_SUCCESS && isnan(v[0][0])) finding("mdr_law_values gives NaN under a force");
        }
    }
    if (mdr_law_write(law, NULL, 0, &length) != MDR_SUCCESS || length < CHECKSUM_LINE) finding("cannot be written again");
}

/* A law that has friction, led along a path. */
static void rub(const mdr_law *law)
{
    mdr_law_facts facts = MDR_SIZED(mdr_law_facts);
    double T[3], tangent[12];

    if (mdr_law_about(law, &facts) != MDR_SUCCESS) finding("has no facts");
    if (facts.sliders == 0) return;
    double *memory = calloc((size_t)facts.memory_size, sizeof *memory);
    if (!memory) abort();
    for (int i = 0; i < DEPTHS; i++) {
        const double force = facts.highest_force * (i + 1) / (DEPTHS - 1.0);
        const double shift[3] = {facts.highest_sliding_shift * (i % 3 - 0.7), 0.0,
                                 i == 5 ? 0.1 * facts.highest_sliding_shift : 0.0};
        mdr_law_advance(law, 1, &force, shift, 0, tangent, memory, T);
    }
    free(memory);
}

/* The file with these bits as its numbers. */
static size_t text_of_numbers(const uint8_t *data, size_t size, char *text)
{
    const size_t count = size / 8;
    int length = sprintf(text, "mdrcontact compiled contact law, format 5\n1 characters of description, then %d numbers\nx\n",
                         (int)count);
    for (size_t i = 0; i < count; i++) {
        for (int j = 7; j >= 0; j--) length += sprintf(text + length, "%02X", data[8 * i + (size_t)j]);
        text[length++] = i % 8 == 7 ? '\n' : ' ';
    }
    length += sprintf(text + length, "\ncrc32 00000000\n");
    return (size_t)length;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    mdr_law *law = NULL;
    size_t length = size - 1;

    if (size < 1 || size > LARGEST) return 0;
    char *buffer = malloc(3 * size + 256);
    if (!buffer) return 0;
    memcpy(buffer, data + 1, length);
    if (data[0] % 4 >= 2) length = text_of_numbers(data + 1, length, buffer);
    if (data[0] % 4 >= 1) mend_checksum(buffer, length);
    /* in a block of its very size, so that a checker sees what lies beyond */
    char *text = malloc(length > 0 ? length : 1);
    if (!text) abort();
    memcpy(text, buffer, length);
    const int status = mdr_law_read(text, (int)length, &law);
    if ((status == MDR_SUCCESS) != (law != NULL)) finding("status and handle disagree");
    if (status == MDR_SUCCESS) {
        evaluate(law);
        rub(law);
    } else if (mdr_last_error()[0] == '\0') {
        finding("is refused without words");
    }
    MDR_FREE(law);
    free(text);
    free(buffer);
    return 0;
}
