// Cliffs: up to which value of a parameter a method is right.
#ifndef RASTERPROOF_BENCH_CLIFF_H_
#define RASTERPROOF_BENCH_CLIFF_H_

#include <optional>

#include "bench/judged_cases.h"
#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

/// Tries the hardest cases of 2^k - 1, 2^k, 2^k + 1 and 3 2^(k - 1) upwards (and of the whole
/// numbers on either side of the drawer's stated limit) until one fails, then bisects between it
/// and the value tried before it.
///
/// Returns:    the least value that was seen failing, where the one below it was tried and held or
///             is the one tried before. Nothing if the drawer took no case at all. Failing is not
///             monotone: a lower value that was not tried may fail.
std::optional<BenchCliff> FindCliff(SceneDrawer& drawer, const Parameter& parameter,
                                    JudgedCases& cases);

/// Up to which value 0 wrong is proved: from the exactness table (reference/exactness.h), or what
/// a method that is proved right states; NaN: nothing is.
double ProvedTo(const BenchMethod& method, const Parameter& parameter);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CLIFF_H_
