/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What HIP's headers say, for clang where they are not installed. */
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
extern "C" __device__ void *memcpy(void *to, const void *from, __SIZE_TYPE__ size);
extern "C" __device__ double sqrt(double x);
