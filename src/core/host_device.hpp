#pragma once

// Functions marked FACET_HD compile for the host and, under nvcc, for the device as well.
#if defined(__CUDACC__)
#define FACET_HD __host__ __device__
#else
#define FACET_HD
#endif
