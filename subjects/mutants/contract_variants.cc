// Legal variants whose profiles have the rarer keys.
#include <cmath>
#include <utility>
#include <vector>

#include "subjects/mutants/contracts.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

FixedStages WithProfileOf(void (*change)(Profile&)) {
  FixedStages stages;
  stages.profile.name = "legal variant";
  change(stages.profile);
  return stages;
}

std::vector<Mutant> ContractVariants() {
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
  flat.owns = OwnsIfFlat;
  FixedStages twice = EdgeSamplesMayBeShared();
  twice.owns = [](const GridEdge&, const GridTriangle&, const Sample&) { return true; };
  FixedStages sometimes = EdgeSamplesMayBeShared();
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
      {"shared-edge-samples", "every edge owns its samples, and edge samples may be shared", "",
       std::move(twice)},
      {"shared-samples-of-backs",
       "edges of back faces own their samples, and edge samples may be shared", "",
       std::move(sometimes)},
      {"exclusive", "no edge owns its samples, and the profile says so", "", EdgesOutside()},
  };
}

}  // namespace

FixedStages WrappingInput() {
  return WithProfileOf([](Profile& profile) {
    profile.fixed = FixedInput{11, 4, true, true};
    profile.snap = {};
  });
}

FixedStages LimitedExtent() {
  return WithProfileOf([](Profile& profile) {
    profile.fixed = FixedInput{12, 4, true, false};
    profile.snap = {};
    profile.max_primitive_extent = MaxPrimitiveExtent{64, 32};
  });
}

FixedStages ClippedBeyond256() {
  return WithProfileOf(
      [](Profile& profile) { profile.guard_band = WindowBox{-256, -256, 256, 256}; });
}

FixedStages BitsByTarget() {
  return WithProfileOf([](Profile& profile) {
    profile.by_target_size = {
        {.max_width = 32, .max_height = 24, .snap = profile.snap},
        {.max_width = 40, .max_height = 40, .snap = {4, SnapRule::kTruncate}}};
    profile.snap.bits = 6;
  });
}

FixedStages UnspecifiedFlat() {
  return WithProfileOf(
      [](Profile& profile) { profile.degenerate_triangles = DegenerateTriangles::kUnspecified; });
}

FixedStages EdgeSamplesMayBeShared() {
  return WithProfileOf([](Profile& profile) { profile.shares_edge_samples = true; });
}

FixedStages EdgesInside() {
  return WithProfileOf([](Profile& profile) { profile.tie_rule = {.inclusive = true}; });
}

FixedStages EdgesOutside() {
  return WithProfileOf([](Profile& profile) { profile.tie_rule = {.exclusive = true}; });
}

extern constinit const MutantTable kContractVariants{MutantKind::kLegal, 6, ContractVariants};

}  // namespace rasterproof::subjects::mutants
