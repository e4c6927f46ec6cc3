// Rasterizers that do what others don't and keep what their profile states: none may fail.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "core/snap.h"
#include "core/tie_rule.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

// The fixed-point rasterizer under the d3d11 profile, but for one thing.
FixedStages With(void (*change)(Profile&)) {
  FixedStages stages;
  stages.profile.name = "legal variant";
  change(stages.profile);
  return stages;
}

FixedStages WithRule(const TieRule& rule) {
  FixedStages stages = With([](Profile&) {});
  stages.profile.tie_rule = rule;
  return stages;
}

FixedStages WithSnap(const Snap& snap, double limit) {
  FixedStages stages = With([](Profile&) {});
  stages.profile.snap = snap;
  stages.profile.coordinate_limit = limit;
  return stages;
}

FixedStages WithTile(int tile) {
  FixedStages stages;
  stages.tile = tile;
  return stages;
}

std::vector<Mutant> TieRules() {
  return {
      {"ties-top-left", "ties fall top-left, as in every API", "",
       WithRule({+1, +1, false, false})},
      {"ties-top-right", "ties fall to the right edge", "", WithRule({-1, +1, false, false})},
      {"ties-bottom-left", "ties fall to the left and the bottom edge", "",
       WithRule({+1, -1, false, false})},
      {"ties-bottom-right", "ties fall to the right and the bottom edge", "",
       WithRule({-1, -1, false, false})},
      {"ties-top-left-y", "ties are decided along y first", "", WithRule({+1, +1, true, false})},
      {"ties-top-right-y", "ties are decided along y first, to the right", "",
       WithRule({-1, +1, true, false})},
      {"ties-bottom-left-y", "ties are decided along y first, to the bottom", "",
       WithRule({+1, -1, true, false})},
      {"ties-bottom-right-y", "ties are decided along y first, to the bottom and the right", "",
       WithRule({-1, -1, true, false})},
  };
}

std::vector<Mutant> SnapVariants() {
  constexpr double kLimit = 0x1p15;
  return {
      {"snap-nearest-away", "ties of the snap go away from zero", "",
       WithSnap({8, SnapRule::kNearestAway}, kLimit)},
      {"snap-half-up", "ties of the snap go up", "", WithSnap({8, SnapRule::kHalfUp}, kLimit)},
      {"snap-floor", "the snap rounds down", "", WithSnap({8, SnapRule::kFloor}, kLimit)},
      {"snap-truncate", "the snap truncates", "xemu #2183 is the rule of that hardware",
       WithSnap({4, SnapRule::kTruncate}, kLimit)},
      {"snap-4-bits", "coordinates are 12.4, up to 2048 pixels", "",
       WithSnap({4, SnapRule::kNearestEven}, 0x1p11)},
      {"snap-12-bits", "there are 12 subpixel bits", "",
       WithSnap({12, SnapRule::kNearestEven}, kLimit)},
      {"snap-16-bits", "there are 16 subpixel bits, up to 8192 pixels", "",
       WithSnap({16, SnapRule::kNearestEven}, 0x1p13)},
      {"snap-whole-pixels", "vertices lie on whole pixels", "the consoles of the nineties",
       WithSnap({0, SnapRule::kTruncate}, 0x1p10)},
  };
}

std::vector<Mutant> Samples() {
  return {
      {"samples-four", "a pixel has four samples", "", FixedStages{{}, FourSampleProfile()}},
      {"samples-two", "a pixel has two samples", "",
       With([](Profile& profile) { profile.pattern.locations = {{0.75, 0.75}, {0.25, 0.25}}; })},
      {"sample-corner", "the pixel's corner is sampled", "",
       With([](Profile& profile) { profile.pattern.locations = {{0, 0}}; })},
      {"sample-off-centre", "samples lie 1/256 pixel off the centre, and the profile says so", "",
       With([](Profile& profile) { profile.pattern.locations = {{0.5 + 0x1p-8, 0.5}}; })},
      {"y-up", "y grows upwards", "OpenGL",
       With([](Profile& profile) { profile.y_axis = YAxis::kUp; })},
      {"y-up-all-else-too",
       "y grows upwards, four samples, ties bottom-right, the snap rounds down", "",
       With([](Profile& profile) {
         profile = FourSampleProfile();
         profile.y_axis = YAxis::kUp;
         profile.tie_rule = {-1, -1, true, false};
         profile.snap.rule = SnapRule::kFloor;
       })},
  };
}

std::vector<Mutant> Freedoms() {
  FixedStages moved = With([](Profile& profile) { profile.contract = Contract::kWatertight; });
  moved.sample = [](const Sample& at) { return GridPoint{at.at.x + 37, at.at.y - 80}; };
  FixedStages unruly = With([](Profile& profile) { profile.contract = Contract::kNone; });
  unruly.times = [](const Sample& at, const GridTriangle&) { return at.x % 3 == 0 ? 2U : 1U; };
  unruly.owns = [](const GridEdge&, const GridTriangle&, const Sample&) { return true; };
  FixedStages limited = With([](Profile& profile) { profile.coordinate_limit = 128; });
  limited.place = [](GridPoint& p, const Scene&) {
    // int16 in 1/256 pixel, clamped to what it holds beside the limit.
    const auto held = [](std::int64_t n) { return std::clamp<std::int64_t>(n, -32768, 32768); };
    p = {held(p.x), held(p.y)};
  };
  FixedStages inclusive = With([](Profile& profile) { profile.tie_rule.inclusive = true; });
  return {
      {"tile-1", "every sample is a tile of its own", "", WithTile(1)},
      {"tile-3", "tiles are 3 pixels wide", "", WithTile(3)},
      {"tile-64", "tiles are 64 pixels wide", "", WithTile(64)},
      {"batches", "scenes are taken in batches", "",
       FixedStages{{.batch = [](std::vector<DrawOutcome>&) {}}}},
      {"watertight-elsewhere", "samples lie elsewhere, and only watertight meshes are stated", "",
       std::move(moved)},
      {"contract-none", "every edge owns its samples and some count twice; nothing is stated", "",
       std::move(unruly)},
      {"limited-to-128", "coordinates are 8.8 and the profile's limit is 128 pixels", "",
       std::move(limited)},
      {"inclusive", "every edge owns its samples, and the profile says so", "",
       std::move(inclusive)},
  };
}

std::vector<Mutant> OtherBases() {
  return {
      {"real-exact", "nothing is snapped, signs are exact", "", RealStages{}},
      {"clip-exact", "clip space is taken, nothing is clipped", "", ClipStages{}},
      {"shown-float32", "edge values and barycentrics of float32 are shown with proven bounds", "",
       ValueStages{}},
      {"shown-steps", "steps in float32 are shown with proven bounds", "",
       ValueStages{.method = "f32-incremental"}},
  };
}

std::vector<Mutant> UnusualVariants() {
  std::vector<Mutant> table = TieRules();
  for (const auto more : {SnapVariants, Samples, Freedoms, OtherBases}) {
    for (Mutant& planted : more()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kUnusualVariants{MutantKind::kLegal, 1, UnusualVariants};

}  // namespace rasterproof::subjects::mutants
