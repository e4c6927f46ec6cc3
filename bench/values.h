// Errors of the values that a method computes besides coverage.
#ifndef RASTERPROOF_BENCH_VALUES_H_
#define RASTERPROOF_BENCH_VALUES_H_

#include "bench/contender.h"
#include "bench/family.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

/// The errors of edge values at pixels beside the edges of some triangles of the family, and of
/// barycentrics and depths at pixels that they cover. Some: spread over the family, 64 of them;
/// fewer of a contender that is slow alone.
///
/// Domain:     a contender that has loaded the family, in window space; of another one nothing is
///             shown.
BenchValues ValuesOf(Contender& contender, const FamilyInput& family);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_H_
