/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Forces of a compiled law on a device: law_device BUFFER, where BUFFER holds the numbers of mdr_law_buffer() as they lie in memory
 * (`law.buffer().tofile(...)` in Python). Compares the bits with those of the processor, and prints evaluations in a second beside a copy
 * of the same arrays and beside Hertz's F = c d^(3/2). The library is not needed:
 *
 *     nvcc -O3 --fmad=false -I$(python -c "import mdrcontact; print(mdrcontact.get_include())") law_device.cu -o law_device
 *     hipcc -O3 -ffp-contract=off ... the same
 */
#include <mdrcontact_law.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#ifdef __HIPCC__
#include <hip/hip_runtime.h>
#define cudaMalloc hipMalloc
#define cudaMemcpy hipMemcpy
#define cudaMemcpyHostToDevice hipMemcpyHostToDevice
#define cudaMemcpyDeviceToHost hipMemcpyDeviceToHost
#define cudaDeviceSynchronize hipDeviceSynchronize
#define cudaSuccess hipSuccess
#define cudaError_t hipError_t
#define cudaGetErrorString hipGetErrorString
#define cudaEvent_t hipEvent_t
#define cudaEventCreate hipEventCreate
#define cudaEventRecord hipEventRecord
#define cudaEventSynchronize hipEventSynchronize
#define cudaEventElapsedTime hipEventElapsedTime
#endif

static void check(cudaError_t status)
{
    if (status == cudaSuccess) return;
    std::fprintf(stderr, "no device, or it failed: %s\n", cudaGetErrorString(status));
    std::exit(77);
}

/* The view comes by value; its pointers are those of the device. */
__global__ void law_force_and_slope(mdr_law_view view, int n, const double *d, double *F, double *slope)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) mdr_law_view_force_slope(&view, d[i], &F[i], &slope[i]);
}

/* One contact of each thread, with its history. */
__global__ void law_follow(mdr_law_view view, int n, const double *d, int *segment, double *F, double *energy)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    mdr_law_point point;
    if (i >= n) return;
    mdr_law_view_follow(&view, d[i], &segment[i], &point);
    F[i] = point.force;
    energy[i] = point.energy;
}

__global__ void only_copy(int n, const double *d, double *F, double *slope)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) F[i] = slope[i] = d[i];
}

__global__ void hertz(double c, int n, const double *d, double *F, double *slope)
{
    const int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i >= n) return;
    const double a = d[i] > 0.0 ? sqrt(d[i]) : 0.0;
    F[i] = c * d[i] * a;
    slope[i] = 1.5 * c * a;
}

/* Seconds of one of many launches. */
template <class Launch> static double seconds(Launch launch)
{
    const int rounds = 50;
    float milliseconds = 0.0f;
    cudaEvent_t begin, end;
    check(cudaEventCreate(&begin));
    check(cudaEventCreate(&end));
    launch();
    check(cudaEventRecord(begin));
    for (int i = 0; i < rounds; ++i) launch();
    check(cudaEventRecord(end));
    check(cudaEventSynchronize(end));
    check(cudaEventElapsedTime(&milliseconds, begin, end));
    return 1e-3 * milliseconds / rounds;
}

template <class T> static T *on_device(const std::vector<T> &values)
{
    T *there = nullptr;
    check(cudaMalloc(&there, values.size() * sizeof(T)));
    check(cudaMemcpy(there, values.data(), values.size() * sizeof(T), cudaMemcpyHostToDevice));
    return there;
}

static void fetch(std::vector<double> &values, const double *there)
{
    check(cudaMemcpy(values.data(), there, values.size() * sizeof(double), cudaMemcpyDeviceToHost));
}

int main(int count, char **words)
{
    const int n = 1 << 24, blocks = (n + 255) / 256;
    std::vector<double> buffer, d(n), F(n), slope(n);
    std::FILE *file = count == 2 ? std::fopen(words[1], "rb") : nullptr;
    double number;
    if (!file) return EXIT_FAILURE;
    while (std::fread(&number, sizeof number, 1, file) == 1) buffer.push_back(number);
    std::fclose(file);

    const double *const numbers = on_device(buffer);
    mdr_law_view here, view;
    if (mdr_law_view_from(buffer.data(), MDR_ON_UNLOADING, &here)) return EXIT_FAILURE;
    if (mdr_law_view_at(buffer.data(), numbers, MDR_ON_UNLOADING, &view)) return EXIT_FAILURE;
    const double highest = mdr_law_head_of(&here)->highest;
    for (int i = 0; i < n; ++i) d[i] = highest * (2654435761u * (unsigned)i / 4294967296.0 * 1.2 - 0.2); /* a sixth is open */
    const double *const depth = on_device(d);
    double *const force = on_device(F), *const rise = on_device(slope);

    law_force_and_slope<<<blocks, 256>>>(view, n, depth, force, rise);
    fetch(F, force);
    fetch(slope, rise);
    int differences = 0;
    for (int i = 0; i < n; ++i) {
        double f, s;
        mdr_law_view_force_slope(&here, d[i], &f, &s);
        differences += memcmp(&f, &F[i], sizeof f) != 0 || memcmp(&s, &slope[i], sizeof s) != 0;
    }
    int *const segment = on_device(std::vector<int>(n));
    std::printf("points %d\ndifferent_bits %d\n", n, differences);
    std::printf("law_per_second %.3g\n", n / seconds([&] { law_force_and_slope<<<blocks, 256>>>(view, n, depth, force, rise); }));
    std::printf("follow_per_second %.3g\n",
                n / seconds([&] { law_follow<<<blocks, 256>>>(view, n, depth, segment, force, rise); }));
    std::printf("copy_per_second %.3g\n", n / seconds([&] { only_copy<<<blocks, 256>>>(n, depth, force, rise); }));
    std::printf("hertz_per_second %.3g\n", n / seconds([&] { hertz<<<blocks, 256>>>(1.0, n, depth, force, rise); }));
    return differences ? EXIT_FAILURE : EXIT_SUCCESS;
}
