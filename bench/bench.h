// Error against run time: every subject on the same scenes in one run.
#ifndef RASTERPROOF_BENCH_BENCH_H_
#define RASTERPROOF_BENCH_BENCH_H_

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"
#include "core/scene.h"
#include "core/subject.h"

namespace rasterproof::bench {

/// The subject whose time is 1: Pineda's increments from the corner of the box.
inline constexpr std::string_view kBaseline = "f32-incremental";

struct BenchOptions {
  int repetitions = 7;
  std::uint64_t seed = 1;
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// A family of scenes with one hard side.
struct Family {
  std::string_view name;
  std::string_view summary;
  Scene scene;
};

/// The four families: "medium" (1000 triangles of about 64 px), "large" (4 of 2048 px), "wide" (6
/// of 16384 x 64), "needles" (60 of up to 1024 px, less than one pixel wide). float32, unsnapped,
/// front facing.
std::vector<Family> Families(std::uint64_t seed);

/// Runs every subject on every family, repetitions interleaved so that a slow spell of the machine
/// falls on all alike.
///
/// Units:      seconds of the thread's CPU time; only ratios within one result mean something.
/// Returns:    a row per family and subject that takes the family's scene, families in order.
BenchResult RunBench(std::span<Subject* const> subjects, const BenchOptions& options);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_BENCH_H_
