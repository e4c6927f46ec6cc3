// Error against run time: every method on the same families in one run.
#ifndef RASTERPROOF_BENCH_BENCH_H_
#define RASTERPROOF_BENCH_BENCH_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/contender.h"
#include "bench/family.h"
#include "core/bench_result.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {

/// The methods whose time is 1: Pineda's increments from the corner of the box, and in clip space
/// the division followed by the direct form.
inline constexpr std::string_view kBaseline = "f32-incremental";
inline constexpr std::string_view kClipBaseline = "hom-projected-f32";

/// Whether this names a baseline, or its twin: "f32-incremental again".
bool IsBaseline(std::string_view name);
/// Whether this names a baseline's twin.
bool IsTwin(std::string_view name);

struct BenchOptions {
  /// Rounds of a family go on until this is used up, within the two limits. Errors are part of it.
  double seconds_per_family = 4;
  /// The most that all draws of one user's method may take of a family.
  double seconds_of_users = 60;
  std::size_t least_rounds = 9;
  std::size_t most_rounds = 61;
  /// Triangles are judged until their boxes add up to this.
  std::uint64_t judged_pixels = 2'000'000;
  /// Called with what is being done. May be empty.
  std::function<void(const std::string&)> progress;
};

/// Which of the built-in methods and kernels are drawn.
enum class ContenderChoice : std::uint8_t {
  /// As kQuick, but of the rivals only spans-f64 and those that are called kernels.
  kFew,
  /// Every method; kernels by the widest vectors into counts and masks.
  kQuick,
  /// Every method; kernels by every instruction set into every sink, rivals by those with vectors.
  kFull
};

/// The project's own: every method of the table, every kernel, the floors; the baselines and their
/// twins first. With a target, which is one of SupportedTargets(), kernels draw by it alone.
std::vector<std::unique_ptr<Contender>> OwnContenders(
    ContenderChoice choice, std::optional<library::kernels::Target> target = {});

/// Adds the measurements of one family to the result. Every contender that draws the family draws
/// it once a round, after a draw that is not counted. A user's whose draws would take longer than
/// options.seconds_of_users leave is left out with the reason.
///
/// Domain:     the contenders of earlier calls for the same result, in the same order; the family's
///             baseline and twin among them, or the first one stands in for both.
void RunFamily(const FamilyInput& family, std::span<const std::unique_ptr<Contender>> contenders,
               const BenchOptions& options, BenchResult& result);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_BENCH_H_
