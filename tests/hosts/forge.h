/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Random numbers and checksums for hosts that forge what the library reads. */
#ifndef FORGE_H
#define FORGE_H

#include <math.h>
#include <stdint.h>
#include <stddef.h>

static unsigned long long forge_seed = 88172645463325252ULL;

static inline unsigned long long draw(void)
{
    forge_seed ^= forge_seed << 13;
    forge_seed ^= forge_seed >> 7;
    return forge_seed ^= forge_seed << 17;
}

static inline double draw_between(double low, double high)
{
    return low + (high - low) * (double)(draw() >> 11) * 0x1p-53;
}

static inline double draw_decades(double low, double high) { return pow(10.0, draw_between(low, high)); }

static inline uint32_t crc32_of(const void *first, size_t size)
{
    const unsigned char *const bytes = (const unsigned char *)first;
    uint32_t crc = 0xffffffffu;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int j = 0; j < 8; j++) crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
    }
    return ~crc;
}

/* The checksum that the library writes behind saved numbers. */
static inline double mark_of(const double numbers[], size_t count)
{
    return 8589934592.0 + (double)(int32_t)crc32_of(numbers, count * sizeof *numbers);
}

#endif
