#pragma once

// A hot loop is compiled for three instruction sets; the loader picks the best one that this processor has.
// Multiplications and additions are never fused (-ffp-contract=off), so all give the same results to the bit.
// Sanitizers start too late for it.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FACET_CPU_CLONES [[gnu::target_clones("arch=x86-64-v4", "avx2", "default")]]
#else
#define FACET_CPU_CLONES
#endif
