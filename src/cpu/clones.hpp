#pragma once

// A hot loop is compiled for two instruction sets; the loader picks the better one that this processor has.
// Without fused multiply-add (AVX2 does not imply it) both give the same results to the bit. Sanitizers start
// too late for it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FACET_CPU_CLONES [[gnu::target_clones("avx2", "default")]]
#else
#define FACET_CPU_CLONES
#endif
