// What is said of the times of two methods: one table, each claim with the one thing in which its
// methods differ. The page, README.md and docs/bench.md take their sentences from here.
#ifndef RASTERPROOF_REPORT_CLAIMS_H_
#define RASTERPROOF_REPORT_CLAIMS_H_

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// In what methods can differ: see BenchMethod.
enum class Trait : std::uint8_t { kTraversal, kArithmetic, kVectors, kSink, kSpace, kVertexBytes };
inline constexpr std::array kTraits{Trait::kTraversal, Trait::kArithmetic, Trait::kVectors,
                                    Trait::kSink,      Trait::kSpace,      Trait::kVertexBytes};
std::string_view TraitName(Trait trait);

/// The instruction set of a claim: the widest by which the run's kernels draw.
inline constexpr std::string_view kWidest = "widest";

/// A method by its traits.
struct ClaimSide {
  std::string_view traversal;
  std::string_view arithmetic;
  std::string_view vectors = kWidest;  ///< an instruction set, "compiler", or kWidest
  std::string_view sink = "mask";
  std::string_view space = "window";
  std::uint64_t vertex_bytes = 12;
};

/// "`A` takes N times as long as `B`."
struct Claim {
  std::string_view id;
  std::string_view about;  ///< what is said before it
  ClaimSide a;
  ClaimSide b;
  /// The one trait in which they differ. Nothing: they differ in several, so that it is no advice,
  /// and `about` says kTextbook.
  std::optional<Trait> differs;
  /// Names; empty: every family that both draw.
  std::span<const std::string_view> families = {};
};
inline constexpr std::string_view kTextbook = "a scalar textbook loop, not a kernel";

std::span<const Claim> Claims();

/// The traits in which the sides of a claim differ.
std::vector<Trait> Differences(const Claim& claim);

/// Why nothing may be said so: its methods differ in another way than it says, its arithmetic is
/// compared in a sink in which stores hide it. Empty if it may.
std::string FaultOf(const Claim& claim);

/// One family of a claim.
struct ClaimCell {
  std::uint32_t family = 0;
  /// Of times less floor, paired within rounds; of whole times where the claim has no trait.
  /// Nothing: a side costs no more than the floor, as far as the run tells.
  std::optional<Interval> ratio;

  /// Whether the run does not tell the two apart.
  bool Overlaps() const { return ratio && ratio->low <= 1 && ratio->high >= 1; }
};

/// A claim, measured.
struct ClaimFigure {
  std::string a;  ///< full names; empty: no such row
  std::string b;
  std::vector<ClaimCell> cells;  ///< empty: not measured
  std::string times;             ///< "0.98 [0.97, 0.99] (`px5`) to 1.2 [1.1, 1.3] (`ties`)"
  std::string a_wrong;           ///< "wrong in 17 of 18 families, by up to 0.07 pixel"
  std::string b_wrong;
  std::string sentence;  ///< all of it, names in backticks
};
ClaimFigure FigureOf(const Claim& claim, const BenchResult& result);

/// "traversal, vectors, arithmetic: not like for like"
std::string DifferenceText(const Claim& claim);

/// The row of the floor, what storing known spans takes, of a row; nullptr if there is none.
const BenchRow* FloorOf(const BenchResult& result, const BenchRow& row);

/// Nanoseconds a triangle of a row less its floor; NaN without one.
double NanosecondsLessFloor(const BenchResult& result, const BenchRow& row);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CLAIMS_H_
