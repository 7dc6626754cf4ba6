#pragma once

// Functions marked FACET_HD compile for the host and, under nvcc, for the device as well.
// FACET_UNROLL stands before a short loop, such as one over eight neighbours, whose index folds into
// constants.
#if defined(__CUDACC__)
#define FACET_HD __host__ __device__
#define FACET_UNROLL _Pragma("unroll")
#else
#define FACET_HD
#define FACET_UNROLL _Pragma("GCC unroll 8")
#endif
