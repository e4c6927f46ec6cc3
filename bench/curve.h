// Curves: what methods get wrong over the values of a parameter.
#ifndef RASTERPROOF_BENCH_CURVE_H_
#define RASTERPROOF_BENCH_CURVE_H_

#include <vector>

#include "bench/judged_cases.h"
#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "core/bench_result.h"

namespace rasterproof::bench {

/// The points of one curve of errors: a point for each power of two of the parameter. None where
/// the drawer takes no case and shows no edge value.
std::vector<BenchPoint> ErrorCurve(SceneDrawer& drawer, const Parameter& parameter,
                                   JudgedCases& cases);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CURVE_H_
