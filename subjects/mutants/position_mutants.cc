// Bugs in where samples and vertices are taken to lie.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/snap.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

constexpr std::int64_t kHalfPixel = 128;

// Moves the samples by (x, y) in 1/256 pixels.
FixedStages SamplesOff(std::int64_t x, std::int64_t y) {
  return {{.sample = [x, y](const Sample& at) { return GridPoint{at.at.x + x, at.at.y + y}; }}};
}

FixedStages Snapping(double (*snap)(double x, bool along_y)) { return {{.snap = snap}}; }

std::vector<Mutant> SubpixelSamples() {
  const auto four_samples = [](GridPoint (*sample)(const Sample&)) {
    return FixedStages{{.sample = sample}, FourSampleProfile()};
  };
  return {
      {"sample-1-right", "samples lie 1/256 pixel too far right", "", SamplesOff(1, 0),
       "sample-location", "CoverageEqualsTheModel"},
      {"sample-1-up", "samples lie 1/256 pixel too far up", "", SamplesOff(0, -1),
       "sample-location"},
      {"sample-3-down", "samples lie 3/256 pixel too far down",
       "passes the published conformance checks", SamplesOff(0, 3), "sample-location"},
      {"sample-4-left", "samples lie 4/256 pixel too far left",
       "passes the published conformance checks", SamplesOff(-4, 0), "sample-location"},
      {"sample-corner", "the pixel's corner is sampled, not its centre", "PPSSPP #9681",
       SamplesOff(-kHalfPixel, -kHalfPixel), "sample-location"},
      {"sample-creeps", "sample locations are off by 1/256 pixel from column 16 on", "",
       FixedStages{{.sample =
                        [](const Sample& at) {
                          return GridPoint{at.at.x + (at.x >= 16 ? 1 : 0), at.at.y};
                        }}}},
      {"samples-exchanged", "two of the four sample locations are exchanged", "",
       four_samples([](const Sample& at) {
         // (7/8, 3/8) and (1/8, 5/8).
         if (at.s == 1) return GridPoint{at.at.x - 192, at.at.y + 64};
         if (at.s == 2) return GridPoint{at.at.x + 192, at.at.y - 64};
         return at.at;
       }),
       "sample-order", "CoverageEqualsTheModel"},
      {"samples-mirrored", "the four sample locations are mirrored", "",
       four_samples([](const Sample& at) {
         constexpr std::int64_t kOffset[] = {32, 96, 160, 224};
         return GridPoint{at.at.x, at.at.y + 256 - 2 * kOffset[at.s]};
       }),
       "sample-order"},
      {"samples-last-in-centre", "the last of four samples lies in the pixel's centre", "",
       four_samples([](const Sample& at) {
         return at.s == 3 ? GridPoint{at.at.x - 32, at.at.y - 96} : at.at;
       }),
       "sample-order"},
      {"samples-first-for-all", "coverage is decided at the first sample for all four", "",
       four_samples([](const Sample& at) {
         constexpr std::int64_t kX[] = {0, 128, -64, 64};
         return GridPoint{at.at.x - kX[at.s], at.at.y - 64 * at.s};
       }),
       "sample-order"},
  };
}

std::vector<Mutant> Snaps() {
  return {
      {"snap-truncates", "snapping truncates towards zero",
       "passes the published conformance checks",
       Snapping([](double x, bool) { return SnapToGrid(x, {8, SnapRule::kTruncate}); }),
       "truncation"},
      {"snap-floors", "snapping rounds down", "",
       Snapping([](double x, bool) { return SnapToGrid(x, {8, SnapRule::kFloor}); }), "truncation"},
      {"snap-nearest-away", "ties are snapped away from zero", "",
       Snapping([](double x, bool) { return SnapToGrid(x, {8, SnapRule::kNearestAway}); }),
       "rounding"},
      {"snap-half-up-in-float", "one half is added in float32 and the sum truncated",
       "what a published conformance suite's own reference does", Snapping([](double x, bool) {
         const float scaled = static_cast<float>(x) * 256.0F + 0.5F;
         return std::floor(double{scaled}) / 256;
       }),
       "rounding"},
      {"snap-4-bits", "snapping keeps 4 of the 8 bits", "xemu #2183",
       Snapping([](double x, bool) { return SnapToGrid(x, {4, SnapRule::kTruncate}); }),
       "subpixel-bits"},
      {"snap-7-bits", "snapping keeps 7 of the 8 bits", "",
       Snapping([](double x, bool) { return SnapToGrid(x, {7, SnapRule::kNearestEven}); }),
       "subpixel-bits"},
      {"snap-y-truncates", "y is truncated, x is not", "", Snapping([](double x, bool along_y) {
         return SnapToGrid(x, {8, along_y ? SnapRule::kTruncate : SnapRule::kNearestEven});
       }),
       "truncation"},
      {"snap-of-difference", "snapping follows the subtraction of one half in float32",
       "drivers that sample at integers", Snapping([](double x, bool) {
         const float moved = static_cast<float>(x) - 0.5F;
         return SnapToGrid(moved, {8, SnapRule::kNearestEven}) + 0.5;
       }),
       "rounding"},
      {"snap-by-magic-number", "1.5 2^23 is added to force the rounding: too little from 2^14 on",
       "", Snapping([](double x, bool) {
         constexpr float kMagic = 12582912.0F;
         const float forced = static_cast<float>(x) * 256.0F + kMagic;
         return double{forced - kMagic} / 256;
       }),
       "rounding"},
      {"snap-bits-lost-far-off", "from 8192 pixels on only 6 bits are kept", "",
       Snapping([](double x, bool) {
         return SnapToGrid(x, {std::fabs(x) < 0x1p13 ? 8 : 6, SnapRule::kNearestEven});
       }),
       "subpixel-bits"},
      {"snap-negative-mirrored", "negative coordinates are rounded half down", "",
       Snapping([](double x, bool) {
         return x < 0 ? -SnapToGrid(-x, {8, SnapRule::kFloor})
                      : SnapToGrid(x, {8, SnapRule::kNearestEven});
       }),
       "rounding"},
  };
}

std::vector<Mutant> PositionMutants() {
  std::vector<Mutant> table = SubpixelSamples();
  for (Mutant& planted : Snaps()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

Profile FourSampleProfile() {
  Profile profile = FixedPointProfile();
  profile.name = "four samples";
  profile.pattern.locations = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  return profile;
}

extern constinit const MutantTable kPositionMutants{MutantKind::kPlanted, 2, PositionMutants};

}  // namespace rasterproof::subjects::mutants
