// Bugs in where edges cross rows, and crossings that are rounded as stated.
#include <cstdint>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

std::int64_t RoundedDown(std::int64_t n, std::int64_t d) { return n / d - (n % d < 0 ? 1 : 0); }

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

}  // namespace

std::vector<Mutant> ScanlineMutants() {
  return {
      {"scanline-truncated", "crossings left of their upper end are rounded up, not down", "",
       ScanlineStages{.crossing = Truncated}},
      {"scanline-stepped", "a rounded slope is added up row by row", "Qt's image rasterizer",
       ScanlineStages{.crossing = Stepped}},
      {"scanline-above-centre", "crossings are those 1/256 pixel above the samples",
       "cairo 1.16, mono", ScanlineStages{.crossing = AboveCentre}},
      {"scanline-32-bits", "the product of the crossing wraps at 32 bits", "pixman 0.42.2",
       ScanlineStages{.crossing = Wrapped}},
      {"scanline-of-other-rule", "crossings are rounded down where half up is stated", "",
       ScanlineStages{.stated = SnapRule::kHalfUp, .crossing = Floored}},
  };
}

std::vector<Mutant> ScanlineVariants() {
  return {
      {"scanline-floor", "where an edge crosses a row is rounded down to 1/256 pixel", "",
       ScanlineStages{}},
      {"scanline-half-up", "where an edge crosses a row is rounded to the nearest 1/256 pixel", "",
       ScanlineStages{.stated = SnapRule::kHalfUp}},
  };
}

}  // namespace rasterproof::subjects::mutants
