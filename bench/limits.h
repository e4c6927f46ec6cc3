// How far methods are right, and what they get wrong and cost on the way there.
#ifndef RASTERPROOF_BENCH_LIMITS_H_
#define RASTERPROOF_BENCH_LIMITS_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/contender.h"
#include "bench/scene_drawer.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

struct LimitOptions {
  /// Names of parameters ("pixels", "target", "threads" and "triangles" are costs) and of methods;
  /// empty: all.
  std::vector<std::string> parameters;
  std::vector<std::string> methods;
  bool with_curves = true;  ///< of errors and of costs, besides the cliffs
  /// Costs are measured up to this number of triangles: of a method up to a draw of a second. 10^7
  /// take half a GB.
  std::uint64_t most_triangles = 100'000;
  std::size_t rounds = 5;  ///< of each cost
  /// WallSeconds() from which on no more methods, and no more costs, are begun.
  double end = std::numeric_limits<double>::infinity();
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// Adds the parameters, the cliffs and the curves of errors of every contender that draws triangles
/// alone, each name once: its instruction sets and sinks decide alike
/// (tests/library/kernels_test.cc). Then the costs of all: RunCostCurves. Adds its methods to a
/// result that has none; otherwise they are those of the contenders, in their order.
void RunLimits(std::span<const std::unique_ptr<Contender>> contenders, const LimitOptions& options,
               BenchResult& result);

/// The same of one more method, a subject's, without costs; its method is added to the result.
void RunLimits(SceneDrawer& drawer, const LimitOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_LIMITS_H_
