/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * What makes libFuzzer see code compiled by gcc and gfortran: -fsanitize-coverage=trace-pc calls this function (under the name that
 * the linker's --wrap gives it) in every basic block, and libFuzzer keeps an input that changes the counters in this section.
 */
#include <stdint.h>

enum { COUNTER_BITS = 17 };

extern const char __executable_start;
void __wrap___sanitizer_cov_trace_pc(void);

static uint8_t counters[1 << COUNTER_BITS] __attribute__((section("__libfuzzer_extra_counters"), used));

__attribute__((no_sanitize("address", "undefined"))) void __wrap___sanitizer_cov_trace_pc(void)
{
    const uintptr_t place = (uintptr_t)__builtin_return_address(0) - (uintptr_t)&__executable_start;
    counters[(uint32_t)place * 2654435769u >> (32 - COUNTER_BITS)]++;
}
