// Errors of the values that a method computes besides coverage.
#ifndef RASTERPROOF_BENCH_VALUES_H_
#define RASTERPROOF_BENCH_VALUES_H_

#include "bench/contender.h"
#include "bench/family.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

/// The errors of edge values at pixels beside the edges of some hundred triangles of the family.
///
/// Domain:     a family in window space; of another one nothing is shown.
BenchValues ValuesOf(const Contender& contender, const FamilyInput& family);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_H_
