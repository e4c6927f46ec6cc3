// Bugs in where edges cross rows, and crossings that are rounded as stated.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// Where an edge crosses a row, in 1/256 pixel; its upper end is `a`.
using RowCrossing = std::int64_t (*)(GridPoint a, GridPoint b, std::int64_t y);

// From one crossing up to the other.
bool IsInTheRow(RowCrossing crossing, const Sample& s, std::array<GridPoint, 3> v) {
  std::ranges::sort(v, {}, &GridPoint::y);
  const std::int64_t y = s.at.y;
  if (y < v[0].y || y >= v[2].y) return false;
  const std::int64_t p = crossing(v[0], v[2], y);
  const std::int64_t q = y < v[1].y ? crossing(v[0], v[1], y) : crossing(v[1], v[2], y);
  return s.at.x >= std::min(p, q) && s.at.x < std::max(p, q);
}

// Snaps to 1/256 pixel, and fills each row between its rounded crossings; top-left.
FixedStages Scanlines(SnapRule stated, RowCrossing crossing) {
  FixedStages stages;
  stages.has_workers = false;
  stages.profile.name = "rounded crossings";
  stages.profile.scanline_rounding = {8, stated};
  stages.box = [](PixelRect& box, const GridTriangle&, const Scene& scene) {
    box.x0 = 0;
    box.x1 = scene.width;
  };
  stages.value = [](const GridEdge&, const Sample&) { return std::int64_t{1}; };
  stages.times = [crossing](const Sample& s, const GridTriangle& t) {
    return IsInTheRow(crossing, s, t.v) ? 1U : 0U;
  };
  return stages;
}

std::int64_t RoundedDown(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

// |dx dy| is below 2^50.
std::int64_t HalfUp(GridPoint a, GridPoint b, std::int64_t y) {
  const std::int64_t d = b.y - a.y;
  return a.x + RoundedDown(2 * (y - a.y) * (b.x - a.x) + d, 2 * d);
}

std::int64_t Floored(GridPoint a, GridPoint b, std::int64_t y) {
  return a.x + RoundedDown((y - a.y) * (b.x - a.x), b.y - a.y);
}

std::int64_t Truncated(GridPoint a, GridPoint b, std::int64_t y) {
  return a.x + (y - a.y) * (b.x - a.x) / (b.y - a.y);
}

// The slope is rounded once, to 2^-16 of 1/256 pixel, and added up row by row.
std::int64_t Stepped(GridPoint a, GridPoint b, std::int64_t y) {
  const std::int64_t slope = (b.x - a.x) * 65536 / (b.y - a.y);
  return a.x + (((y - a.y) * slope) >> 16);
}

std::int64_t AboveCentre(GridPoint a, GridPoint b, std::int64_t y) {
  return Floored(a, b, y - 1 < a.y ? y : y - 1);
}

// In 32 bits, as an int would hold the product.
std::int64_t Wrapped(GridPoint a, GridPoint b, std::int64_t y) {
  const auto n = static_cast<std::int32_t>(static_cast<std::uint32_t>((y - a.y) * (b.x - a.x)));
  return a.x + RoundedDown(n, b.y - a.y);
}

std::vector<Mutant> ScanlineMutants() {
  return {
      {"scanline-truncated", "crossings left of their upper end are rounded up, not down", "",
       Scanlines(SnapRule::kFloor, Truncated)},
      {"scanline-stepped", "a rounded slope is added up row by row", "Qt's image rasterizer",
       Scanlines(SnapRule::kFloor, Stepped)},
      {"scanline-above-centre", "crossings are those 1/256 pixel above the samples",
       "cairo 1.16, mono", Scanlines(SnapRule::kFloor, AboveCentre)},
      {"scanline-32-bits", "the product of the crossing wraps at 32 bits", "pixman 0.42.2",
       Scanlines(SnapRule::kFloor, Wrapped)},
      {"scanline-of-other-rule", "crossings are rounded down where half up is stated", "",
       Scanlines(SnapRule::kHalfUp, Floored)},
  };
}

std::vector<Mutant> ScanlineVariants() {
  return {
      {"scanline-floor", "where an edge crosses a row is rounded down to 1/256 pixel", "",
       Scanlines(SnapRule::kFloor, Floored)},
      {"scanline-half-up", "where an edge crosses a row is rounded to the nearest 1/256 pixel", "",
       Scanlines(SnapRule::kHalfUp, HalfUp)},
  };
}

}  // namespace

extern constinit const MutantTable kScanlineMutants{MutantKind::kPlanted, 10, ScanlineMutants};
extern constinit const MutantTable kScanlineVariants{MutantKind::kLegal, 4, ScanlineVariants};

}  // namespace rasterproof::subjects::mutants
