/* SPDX-License-Identifier: GPL-3.0-or-later */
/* CUDA's words for a C++ compiler without CUDA. */
#define __CUDACC__
#define __host__ __attribute__((unused))
#define __device__
#define __global__
