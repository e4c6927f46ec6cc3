// Curves: what methods get wrong, and what they cost, over the values of a parameter.
#ifndef RASTERPROOF_BENCH_CURVE_H_
#define RASTERPROOF_BENCH_CURVE_H_

#include <cstdint>
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

struct CurveOptions {
  /// Names of parameters ("pixels", "target", "threads" and "triangles" are costs) and of methods;
  /// empty: all.
  std::vector<std::string> parameters;
  std::vector<std::string> methods;
  /// Costs are measured up to this number of triangles: of a method up to a draw of a second. 10^7
  /// take half a GB.
  std::uint64_t most_triangles = 100'000;
  std::size_t rounds = 5;  ///< of each cost
  /// WallSeconds() from which on no more methods, and no more costs, are begun.
  double end = std::numeric_limits<double>::infinity();
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// The points of one curve of errors: a point for each power of two of the parameter. None where
/// the drawer takes no case and shows no edge value.
std::vector<BenchPoint> ErrorCurve(SceneDrawer& drawer, const Parameter& parameter,
                                   JudgedCases& cases);

/// Adds to the result the curves of errors of each name once, as RunCliffs, and of costs of every
/// contender that counts by facing: seconds a triangle against pixels a triangle (1 to 10^6) and
/// against triangles (10^2 to most_triangles, of 20 pixels); of every one that draws masks against
/// the target's side (256 to 16384); of the library into every sink against threads (1, 2, 4, ...).
///
/// Domain:     as RunCliffs.
void RunCurves(std::span<const std::unique_ptr<Contender>> contenders, const CurveOptions& options,
               BenchResult& result);

/// The errors of one more method, a subject's; its method is added to the result.
void RunCurves(SceneDrawer& drawer, const CurveOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CURVE_H_
