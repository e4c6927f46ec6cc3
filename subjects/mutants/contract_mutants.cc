// Bugs in what only some profiles contract.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "subjects/mutants/contracts.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

FixedStages Wrapping(std::int64_t (*wrap)(std::int64_t)) {
  FixedStages stages = WrappingInput();
  stages.wrap = [wrap, bits = stages.profile.fixed->fraction_bits](double x) {
    const auto raw = static_cast<std::int64_t>(std::ldexp(x, bits));
    return std::ldexp(static_cast<double>(wrap(raw)), -bits);
  };
  return stages;
}

FixedStages TooLarge(bool (*too_large)(std::int64_t, std::int64_t)) {
  FixedStages stages = LimitedExtent();
  stages.too_large = [too_large](const std::array<GridPoint, 3>& v) {
    const auto [left, right] = std::ranges::minmax(v, {}, &GridPoint::x);
    const auto [top, bottom] = std::ranges::minmax(v, {}, &GridPoint::y);
    return too_large(right.x - left.x, bottom.y - top.y);
  };
  return stages;
}

FixedStages ByTarget(Profile (*model)(const Profile&, const Scene&)) {
  FixedStages stages = BitsByTarget();
  stages.model = [model](Profile& profile, const Scene& scene) {
    profile = model(profile, scene);
    profile.by_target_size.clear();
  };
  return stages;
}

bool LeavesBy(const GridTriangle& triangle, std::int64_t pixels) {
  return std::ranges::any_of(triangle.v, [&](const GridPoint& p) {
    return std::max(std::abs(p.x), std::abs(p.y)) > pixels * 256;
  });
}

FixedStages Clipping(void (*edges)(GridTriangle&)) {
  FixedStages stages = ClippedBeyond256();
  stages.edges = edges;
  return stages;
}

void MoveEdges(GridTriangle& triangle) {
  for (GridEdge& edge : triangle.edges) {
    edge.a.y += 2;
    edge.b.y += 2;
  }
}

std::vector<Mutant> FixedInputs() {
  constexpr std::int64_t kRange = std::int64_t{1} << 15;  // 11.4 bits
  return {
      {"fixed-wraps-wide", "coordinates wrap at 12 integer bits, not 11", "",
       Wrapping([](std::int64_t raw) { return std::int64_t{static_cast<std::int16_t>(raw)}; })},
      {"fixed-sign-lost", "the sign of a wrapped coordinate is not extended", "",
       Wrapping([](std::int64_t raw) { return raw & (kRange - 1); })},
      {"fixed-clamps", "coordinates beyond the range are clamped, not wrapped", "",
       Wrapping([](std::int64_t raw) { return std::clamp(raw, -kRange / 2, kRange / 2 - 1); })},
      {"fixed-least-negated", "the least coordinate of the range comes out positive", "",
       Wrapping([](std::int64_t raw) {
         const std::int64_t low = raw & (kRange - 1);
         return low > kRange / 2 ? low - kRange : low;
       })},
      {"fixed-bit-lost", "the last fraction bit is lost", "", Wrapping([](std::int64_t raw) {
         const std::int64_t low = raw & (kRange - 2);
         return low >= kRange / 2 ? low - kRange : low;
       })},
  };
}

std::vector<Mutant> Extents() {
  constexpr std::int64_t kWidth = 64 * 256;
  constexpr std::int64_t kHeight = 32 * 256;
  return {
      {"extent-or-equal", "triangles of exactly the largest extent are dropped as well", "",
       TooLarge([](std::int64_t w, std::int64_t h) { return w >= kWidth || h >= kHeight; })},
      {"extent-off-by-a-step", "triangles one step over the largest extent are drawn", "",
       TooLarge(
           [](std::int64_t w, std::int64_t h) { return w > kWidth + 16 || h > kHeight + 16; })},
      {"extent-of-x", "only the width is compared", "",
       TooLarge([](std::int64_t w, std::int64_t) { return w > kWidth; })},
      {"extent-exchanged", "width and height are exchanged", "",
       TooLarge([](std::int64_t w, std::int64_t h) { return h > kWidth || w > kHeight; })},
      {"extent-unlimited", "large triangles are drawn though the profile says that none is", "",
       TooLarge([](std::int64_t, std::int64_t) { return false; })},
  };
}

std::vector<Mutant> GridsByTarget() {
  return {
      {"target-first-entry", "the model of small targets is taken for all", "",
       ByTarget([](const Profile& profile, const Scene&) { return ModelOn(profile, 1, 1); })},
      {"target-or-equal", "a target of exactly the largest width is taken for a larger one", "",
       ByTarget([](const Profile& profile, const Scene& scene) {
         return ModelOn(profile, std::min(scene.width + 1, kMaxTargetSide), scene.height);
       })},
      {"target-by-width", "the model is chosen by the width alone", "",
       ByTarget([](const Profile& profile, const Scene& scene) {
         return ModelOn(profile, scene.width, 1);
       })},
  };
}

std::vector<Mutant> Clips() {
  FixedStages dropping = ClippedBeyond256();
  dropping.edges = [](GridTriangle& triangle) {
    if (LeavesBy(triangle, 256)) triangle.edges[0].a = triangle.edges[0].b = {0, 0};
    if (LeavesBy(triangle, 256)) triangle.edges[0].owns = false;
  };
  return {
      {"clip-apart", "clipping moves the edges of odd triangles alone", "",
       Clipping([](GridTriangle& triangle) {
         if (triangle.number % 2 == 1 && LeavesBy(triangle, 256)) MoveEdges(triangle);
       })},
      {"clip-early", "edges move from 255 pixels on", "", Clipping([](GridTriangle& triangle) {
         if (LeavesBy(triangle, 255)) MoveEdges(triangle);
       })},
      {"clip-drops", "triangles that need clipping are dropped", "", std::move(dropping)},
  };
}

std::vector<Mutant> LeftOpen() {
  FixedStages thin = UnspecifiedFlat();
  thin.area = [](const std::array<GridPoint, 3>& v) {
    const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
    return std::abs(area) <= 256 ? 0 : area;  // 1/256 of a square pixel
  };
  FixedStages wide = UnspecifiedFlat();
  wide.owns = [](const GridEdge& edge, const GridTriangle& triangle, const Sample&) {
    const std::int64_t area = GridEdge{triangle.v[0], triangle.v[1]}.At(triangle.v[2]);
    return edge.owns || area <= 4096;
  };
  FixedStages never = EdgeSamplesMayBeShared();
  never.owns = [](const GridEdge&, const GridTriangle&, const Sample&) { return false; };
  FixedStages beyond = EdgeSamplesMayBeShared();
  beyond.value = [](const GridEdge& edge, const Sample& sample) {
    const std::int64_t e = edge.At(sample.at);
    return e < 0 && e >= -256 ? 0 : e;
  };
  beyond.owns = [](const GridEdge&, const GridTriangle&, const Sample&) { return true; };
  FixedStages inside = EdgesInside();
  inside.owns = [](const GridEdge& edge, const GridTriangle&, const Sample&) {
    return edge.a.y != edge.b.y;
  };
  FixedStages outside = EdgesOutside();
  outside.owns = [](const GridEdge& edge, const GridTriangle&, const Sample&) {
    return edge.a.x == edge.b.x && edge.a.y < edge.b.y;
  };
  return {
      {"flat-and-thin", "thin triangles are dropped with those without area", "", std::move(thin),
       "lost-triangles"},
      {"flat-widens-thin", "edges of small triangles own their samples, as flat ones may", "",
       std::move(wide)},
      {"shared-samples-gap", "edge_samples may be shared, and no edge owns its samples", "",
       std::move(never), "tie-rule"},
      {"shared-samples-beyond", "the sharing reaches beyond the edge", "", std::move(beyond),
       "edge-precision"},
      {"inclusive-not-rows", "edges are inside, and horizontal ones are not", "", std::move(inside),
       "tie-rule"},
      {"exclusive-not-left", "edges are outside, and vertical left ones are not", "",
       std::move(outside), "tie-rule"},
  };
}

FixedStages OwningTies(Contract contract, bool owns) {
  FixedStages stages;
  stages.profile.contract = contract;
  stages.owns = [owns](const GridEdge&, const GridTriangle&, const Sample&) { return owns; };
  return stages;
}

std::vector<Mutant> Sides() {
  return {
      {"at-least-model-ties-lost", "at-least-model, and no edge owns its samples", "",
       OwningTies(Contract::kAtLeastModel, false), "tie-rule", "CoverageKeepsToItsSideOfTheModel"},
      {"at-most-model-ties-twice", "at-most-model, and every edge owns its samples", "",
       OwningTies(Contract::kAtMostModel, true), "tie-rule", "CoverageKeepsToItsSideOfTheModel"},
  };
}

std::vector<Mutant> ContractMutants() {
  std::vector<Mutant> table = FixedInputs();
  for (const auto more : {Extents, GridsByTarget, Clips, LeftOpen, Sides}) {
    for (Mutant& planted : more()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kContractMutants{MutantKind::kPlanted, 13, ContractMutants};

}  // namespace rasterproof::subjects::mutants
