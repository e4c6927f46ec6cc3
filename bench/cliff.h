// Cliffs: up to which value of a parameter a method is right.
#ifndef RASTERPROOF_BENCH_CLIFF_H_
#define RASTERPROOF_BENCH_CLIFF_H_

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/judged_cases.h"
#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

struct LimitOptions {
  /// Names of parameters and of methods; empty: all.
  std::vector<std::string> parameters;
  std::vector<std::string> methods;
  /// WallSeconds() from which on no more methods are begun.
  double end = std::numeric_limits<double>::infinity();
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

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

/// Adds the parameters and the cliffs of every contender that draws triangles alone, each name
/// once: its instruction sets and sinks decide alike (tests/library/kernels_test.cc). Adds its
/// methods to a result that has none; otherwise they are those of the contenders, in their order.
void RunCliffs(std::span<const std::unique_ptr<Contender>> contenders, const LimitOptions& options,
               BenchResult& result);

/// The same of one more method, a subject's; its method is added to the result.
void RunCliffs(SceneDrawer& drawer, const LimitOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CLIFF_H_
