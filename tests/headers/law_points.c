/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Without the library: law_points BUFFER DEPTHS BRANCH OUT writes the states of a law at depths, as they lie in memory. In C and C++, on
 * OpenMP's device where the compiler has one. */
#include <mdrcontact_law.h>

#include <stdio.h>
#include <stdlib.h>

enum { MOST = 100000, QUANTITIES = 7 };
static double buffer[MOST], d[MOST], out[QUANTITIES * MOST];

static int numbers(const char *path, double *to)
{
    FILE *file = fopen(path, "rb");
    const size_t count = file ? fread(to, sizeof(double), MOST, file) : 0;
    if (file) fclose(file);
    return (int)count;
}

int main(int count, char **words)
{
    if (count != 5) return EXIT_FAILURE;
    const int size = numbers(words[1], buffer), n = numbers(words[2], d), branch = atoi(words[3]);
    int refused = 0;
    (void)size;
#ifdef _OPENMP
#pragma omp target teams distribute parallel for map(to : buffer[0 : size], d[0 : n]) map(from : out[0 : QUANTITIES * n]) \
    map(tofrom : refused) reduction(+ : refused)
#endif
    for (int i = 0; i < n; ++i) {
        mdr_law_view view;
        mdr_law_point point;
        double F, slope;
        if (mdr_law_view_from(buffer, branch, &view) != MDR_SUCCESS) {
            ++refused;
            continue;
        }
        refused += mdr_law_view_state(&view, d[i], &point) != MDR_SUCCESS;
        refused += mdr_law_view_force_slope(&view, d[i], &F, &slope) != MDR_SUCCESS;
        refused += memcmp(&F, &point.force, sizeof F) != 0;
        out[QUANTITIES * i] = point.depth;
        out[QUANTITIES * i + 1] = point.radius;
        out[QUANTITIES * i + 2] = F;
        out[QUANTITIES * i + 3] = point.stiffness;
        out[QUANTITIES * i + 4] = slope;
        out[QUANTITIES * i + 5] = point.energy;
        out[QUANTITIES * i + 6] = point.beyond;
    }
    FILE *file = refused ? NULL : fopen(words[4], "wb");
    if (!file || fwrite(out, sizeof(double), (size_t)(QUANTITIES * n), file) != (size_t)(QUANTITIES * n)) return EXIT_FAILURE;
    return fclose(file) ? EXIT_FAILURE : EXIT_SUCCESS;
}
