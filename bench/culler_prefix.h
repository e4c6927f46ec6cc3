// Included before MaskedOcclusionCulling's sources, which define what GCC 12's headers have by now.
#ifndef RASTERPROOF_BENCH_CULLER_PREFIX_H_
#define RASTERPROOF_BENCH_CULLER_PREFIX_H_

#include <cpuid.h>
#include <immintrin.h>

#define __cpuidex culler_cpuidex
#define _xgetbv culler_xgetbv

#endif  // RASTERPROOF_BENCH_CULLER_PREFIX_H_
