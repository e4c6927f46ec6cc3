// Legal variants whose profiles have the rarer keys.
#include <cmath>
#include <utility>
#include <vector>

#include "subjects/mutants/placing.h"
#include "subjects/mutants/planted.h"
#include "subjects/mutants/promises.h"

namespace rasterproof::subjects::mutants {
namespace {

FixedStages Promising(void (*change)(Profile&)) {
  FixedStages stages;
  stages.profile.name = "legal variant";
  change(stages.profile);
  return stages;
}

}  // namespace

FixedStages WrappingInput() {
  return Promising([](Profile& profile) {
    profile.fixed = FixedInput{11, 4, true, true};
    profile.snap = {};
  });
}

FixedStages LimitedExtent() {
  return Promising([](Profile& profile) {
    profile.fixed = FixedInput{12, 4, true, false};
    profile.snap = {};
    profile.max_extent = MaxExtent{64, 32};
  });
}

FixedStages ClippedBeyond256() {
  return Promising([](Profile& profile) { profile.no_clip = WindowBox{-256, -256, 256, 256}; });
}

FixedStages BitsByTarget() {
  return Promising([](Profile& profile) {
    profile.targets = {{.max_width = 32, .max_height = 24, .snap = profile.snap},
                       {.max_width = 40, .max_height = 40, .snap = {4, SnapRule::kTruncate}}};
    profile.snap.bits = 6;
  });
}

FixedStages UnspecifiedFlat() {
  return Promising([](Profile& profile) { profile.zero_area = ZeroArea::kUnspecified; });
}

FixedStages OverdrawAllowed() {
  return Promising([](Profile& profile) { profile.overdraw = true; });
}

FixedStages EdgesInside() {
  return Promising([](Profile& profile) { profile.fill_rule = {.inclusive = true}; });
}

FixedStages EdgesOutside() {
  return Promising([](Profile& profile) { profile.fill_rule = {.exclusive = true}; });
}

std::vector<Planted> PromiseVariants() {
  FixedStages coarse = WrappingInput();
  coarse.profile.snap = {2, SnapRule::kFloor};
  FixedStages unsigned_input = WrappingInput();
  unsigned_input.profile.fixed = FixedInput{10, 6, false, false};
  FixedStages moved = ClippedBeyond256();
  moved.snap = [](double x, bool) {
    const double at = SnapToGrid(x, {8, SnapRule::kNearestEven});
    return std::fabs(x) <= 256 ? at : at + 0x1p-7;
  };
  FixedStages flat = UnspecifiedFlat();
  flat.draws_flat = true;
  FixedStages twice = OverdrawAllowed();
  twice.owns = [](const GridEdge&, const GridTriangle&, const Sample&) { return true; };
  FixedStages sometimes = OverdrawAllowed();
  sometimes.owns = [](const GridEdge& edge, const GridTriangle& triangle, const Sample&) {
    return edge.owns || !triangle.front;
  };
  return {
      {"fixed-wraps", "coordinates are integers of 11.4 bits and wrap",
       "the consoles of the nineties", WrappingInput()},
      {"fixed-wraps-coarse", "coordinates are integers of 11.4 bits, wrap and are rounded down", "",
       std::move(coarse)},
      {"fixed-unsigned", "coordinates are unsigned integers of 10.6 bits", "",
       std::move(unsigned_input)},
      {"extent-limited", "triangles of more than 64 by 32 pixels are dropped",
       "the consoles of the nineties", LimitedExtent()},
      {"clip-moves-edges", "vertices more than 256 pixels off are moved by 1/128 pixel", "",
       std::move(moved)},
      {"bits-by-target", "large targets have a coarser grid, and the profile says so", "",
       BitsByTarget()},
      {"flat-drawn", "triangles without area cover the samples on them", "", std::move(flat)},
      {"overdraw", "every edge owns its samples, and overdraw is allowed", "", std::move(twice)},
      {"overdraw-of-backs", "edges of back faces own their samples, and overdraw is allowed", "",
       std::move(sometimes)},
      {"exclusive", "no edge owns its samples, and the profile says so", "", EdgesOutside()},
  };
}

}  // namespace rasterproof::subjects::mutants
