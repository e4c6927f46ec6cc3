// What a triangle costs as triangles grow and become more, on larger targets, by more threads.
#ifndef RASTERPROOF_BENCH_COST_CURVE_H_
#define RASTERPROOF_BENCH_COST_CURVE_H_

#include <memory>
#include <span>

#include "bench/contender.h"
#include "bench/limits.h"
#include "core/bench_result.h"
#include "core/scene.h"

namespace rasterproof::bench {

/// Right triangles of about `pixels` pixels each, 2^18 pixels in all or one triangle, at most 4096.
Scene ScatteredOfPixels(double pixels);

/// So many triangles of about 20 pixels on 1024 x 1024; the first 4096 over and over.
Scene ScatteredTriangles(std::uint64_t triangles);

/// Adds the costs, as curves, of every contender that counts by facing: seconds a triangle against
/// pixels a triangle (1 to 10^6) and against triangles (10^2 to most_triangles, of 20 pixels); of
/// every one that draws masks against the target's side (256 to 16384); of the library into every
/// sink against threads (1, 2, 4, ...).
///
/// Domain:     as RunLimits.
void RunCostCurves(std::span<const std::unique_ptr<Contender>> contenders,
                   const LimitOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_COST_CURVE_H_
