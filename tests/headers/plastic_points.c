/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Without the library: plastic_points BUFFER MEMORIES DEPTHS OUT writes what steps of contacts give, as it lies in memory. The memory
 * of a contact is one number, with adhesion two. In C and C++, on OpenMP's device where the compiler has one. */
#include <mdrcontact_plastic_law.h>

#include <stdio.h>
#include <stdlib.h>

enum { MOST = 100000, QUANTITIES = 7 };
static double buffer[MOST], memory[MOST], d[MOST], out[QUANTITIES * MOST];

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
    const int size = numbers(words[1], buffer), memories = numbers(words[2], memory), n = numbers(words[3], d);
    int refused = 0;
    (void)size;
#ifdef _OPENMP
#pragma omp target teams distribute parallel for map(to : buffer[0 : size], d[0 : n], memory[0 : memories])                           \
    map(from : out[0 : QUANTITIES * n]) map(tofrom : refused) reduction(+ : refused)
#endif
    for (int i = 0; i < n; ++i) {
        const int length = memories / n;
        mdr_plastic_view view;
        mdr_plastic_point point;
        double own[2] = {memory[length * i], memory[length * i + length - 1]}, after[2] = {0.0, 0.0}, F, slope, stored, lost;
        if (mdr_plastic_view_at(buffer, buffer, &view) != MDR_SUCCESS) {
            ++refused;
            continue;
        }
        refused += mdr_plastic_view_try(&view, d[i], own, after, &point) != MDR_SUCCESS;
        refused += mdr_plastic_view_energies(&view, d[i], own, &stored, &lost) != MDR_SUCCESS;
        refused += mdr_plastic_view_advance(&view, d[i], own, &F, &slope) != MDR_SUCCESS;
        refused += memcmp(own, after, (size_t)length * sizeof *own) != 0;
        refused += memcmp(&F, &point.force, sizeof F) != 0 || memcmp(&slope, &point.slope, sizeof slope) != 0;
        out[QUANTITIES * i] = point.force;
        out[QUANTITIES * i + 1] = point.slope;
        out[QUANTITIES * i + 2] = point.radius;
        out[QUANTITIES * i + 3] = own[0];
        out[QUANTITIES * i + 4] = length == 2 ? own[1] : 0.0;
        out[QUANTITIES * i + 5] = stored;
        out[QUANTITIES * i + 6] = lost;
    }
    FILE *file = refused ? NULL : fopen(words[4], "wb");
    if (!file || fwrite(out, sizeof(double), (size_t)(QUANTITIES * n), file) != (size_t)(QUANTITIES * n)) return EXIT_FAILURE;
    return fclose(file) ? EXIT_FAILURE : EXIT_SUCCESS;
}
