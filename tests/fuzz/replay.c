/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Feeds the files of a corpus to a fuzzer's entry, without the fuzzer: every finding of the past stays mended. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { LARGEST = 1 << 20 };

int main(int count, char **names)
{
    static uint8_t buffer[LARGEST];
    int read = 0;

    for (int i = 1; i < count; i++) {
        FILE *file = fopen(names[i], "rb");
        if (!file) {
            fprintf(stderr, "%s cannot be read\n", names[i]);
            return EXIT_FAILURE;
        }
        const size_t size = fread(buffer, 1, sizeof buffer, file);
        fclose(file);
        /* in a block of its very size, so that a checker sees what lies beyond */
        uint8_t *bytes = malloc(size > 0 ? size : 1);
        if (!bytes) return EXIT_FAILURE;
        for (size_t j = 0; j < size; j++) bytes[j] = buffer[j];
        if (getenv("REPLAY_NAMES")) fprintf(stderr, "%s\n", names[i]);
        LLVMFuzzerTestOneInput(bytes, size);
        free(bytes);
        read++;
    }
    printf("%d files\n", read);
    return read > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
