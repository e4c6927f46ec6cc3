// Statistics of paired measurements: in which order methods are drawn, and medians.
#ifndef RASTERPROOF_BENCH_PAIRED_H_
#define RASTERPROOF_BENCH_PAIRED_H_

#include <cstddef>
#include <span>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::bench {

/// Returns the order in which round `round` draws `count` methods: a row of a Williams design.
///
/// Properties: over 2 `count` rounds every method stands at every place equally often, and follows
///             every other one equally often: what a method leaves in the caches falls on all.
/// Source:     Williams, Australian Journal of Scientific Research A 2 (1949).
std::vector<std::size_t> RoundOrder(std::size_t count, std::size_t round);

/// The interval of the ratio from pairs of one round each.
///
/// Shape:      as many of either; the shorter one's length counts.
Interval RatioInterval(std::span<const double> seconds, std::span<const double> baseline);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_PAIRED_H_
