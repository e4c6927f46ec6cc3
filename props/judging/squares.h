// Shared parts of the properties about pixels as squares.
#ifndef RASTERPROOF_PROPS_JUDGING_SQUARES_H_
#define RASTERPROOF_PROPS_JUDGING_SQUARES_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/square_rule.h"
#include "core/verdict.h"
#include "exact/square_coverage.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

inline constexpr ProfileRule kMustCoverSquares{
    [](const Profile& p) { return p.squares && p.squares->must; }, "coverage with a must region",
    "the profile states no squares that must be covered", true};
inline constexpr ProfileRule kMayCoverSquares{
    [](const Profile& p) { return p.squares && p.squares->may; }, "coverage with a may region",
    "the profile states no squares beyond which nothing may be covered", true};
inline constexpr ProfileRule kDrawsLargeTriangles{
    [](const Profile& p) { return !p.max_primitive_extent; }, "no largest extent",
    "the profile does not say which squares a triangle beyond its largest extent covers"};

inline constexpr auto kSquareDomains = std::to_array<std::string_view>(
    {"square-grid-lines", "square-crossings", "square-interiors", "uniform-subpixel",
     "axis-aligned", "near-edge", "needles", "caps", "snap-ties", "degenerate", "grids", "fans",
     "mixed-magnitude", "far-negative-corners", "vertex-orders"});

/// The gate of a property about the squares that a profile states.
constexpr Gate SquareGate(std::span<const ProfileRule> rules, std::string_view where = {}) {
  return {.space = Space::kWindow,
          .contract = ContractNeeded::kAny,
          .unwrapped = true,
          .rules = rules,
          .asks_oracle = true,
          .where = where};
}

/// Whether the centre of a pixel lies within the region's square, however it is shrunk, and within
/// it still if vertices are placed a step of the grid elsewhere.
inline bool KeepsCentres(const Profile& profile, const SquareRegion& region) {
  const bool placed = region.geometry == SquareGeometry::kPlaced && !profile.snap.IsNone();
  const double moved = placed ? std::max(exact::PlacingReach(profile.snap, profile.freedom),
                                         std::ldexp(1.0, -profile.snap.bits))
                              : 0;
  return moved - std::min(0.0, region.half_width) < 0.5;
}

/// The direction in which a subject may differ from the expected counts.
enum class MayBe : std::uint8_t { kMore, kLess };

/// Violated at the first sample that is counted less often than expected, where more is allowed, or
/// more often, where less is. Compared are the sums of both facings.
///
/// Returns:    exercised at every sample that either counts.
Verdict ComparedTo(const CoverageCounts& observed, const CoverageCounts& expected, MayBe allowed,
                   std::string_view message);

/// Asks for each triangle alone, up to a stated number, and for the whole mesh: one triangle's
/// excess must not make up for another's lack. `expected` returns the counts of a case.
///
/// Domain:     a case and a description that outlive what is returned.
Checks CompareEachAndAll(const PlacedCase& c, const Description& subject, MayBe allowed,
                         std::string_view message,
                         CoverageCounts (*expected)(const PlacedCase& of,
                                                    const DrawOptions& options));

/// What point samples at the centres of the pixels count, of the vertices as given and under
/// top-left, as often as the profile has samples.
CoverageCounts CentresOf(const PlacedCase& c, const DrawOptions& options);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_SQUARES_H_
