// Rasterizers of the legal sets of APIs: each does what a sentence leaves open, or one thing that
// lies just outside.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "subjects/mutants/clipping.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/free_choice.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

FixedStages Of(std::string_view preset) { return StagesOfPreset(preset); }

double Floor(double x, int bits) { return std::ldexp(std::floor(std::ldexp(x, bits)), -bits); }
double Nearest(double x, int bits) {
  return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits);
}

FixedStages Snapping(std::string_view preset, std::function<double(double)> snap) {
  FixedStages stages = Of(preset);
  stages.snap = [snap = std::move(snap)](double x, bool) { return snap(x); };
  return stages;
}

// It states that it clips nothing: what lies left of the target is judged as all else.
FixedStages Unclipped(FixedStages stages) {
  stages.profile.guard_band.reset();
  return stages;
}

// Snaps to a grid of `bits` bits, finer than most use.
FixedStages Finer(int bits, std::function<double(double)> snap) {
  FixedStages stages = Snapping("vulkan", std::move(snap));
  stages.bits = bits;
  return stages;
}

using Ownership = std::function<bool(const GridEdge&, const GridTriangle&, const Sample&)>;

FixedStages Owning(std::string_view preset, Ownership owns) {
  FixedStages stages = Of(preset);
  stages.owns = std::move(owns);
  return stages;
}

bool IsAscending(const GridEdge& edge) {
  return edge.a.x != edge.b.x ? edge.a.x < edge.b.x : edge.a.y < edge.b.y;
}

// Equal for both directions of an edge.
bool Coin(const GridEdge& edge, std::int64_t salt) {
  const auto mixed = static_cast<std::uint64_t>((edge.a.x + edge.b.x) * 7919 +
                                                (edge.a.y + edge.b.y) * 104729 + salt * 1299709);
  return (mixed * 0x9e3779b97f4a7c15U >> 62 & 1U) != 0;
}

// Of two neighbours, whose directions differ, exactly one owns it, if the coin is theirs.
bool OwnedBy(const GridEdge& edge, bool coin) { return IsAscending(edge) == coin; }

FixedStages Clamping(std::string_view preset) {
  FixedStages stages = Of(preset);
  stages.vertices = [](std::array<Vertex, 3>& v) {
    for (Vertex& corner : v) {
      if (std::isinf(corner.x)) corner.x = std::copysign(0x1p14, corner.x);
      if (std::isinf(corner.y)) corner.y = std::copysign(0x1p14, corner.y);
    }
  };
  return stages;
}

// The ends of a range, to which coordinates beyond it go.
FixedStages ClampingTo(double low, double high) {
  FixedStages stages = Of("d3d11");
  stages.vertices = [low, high](std::array<Vertex, 3>& v) {
    for (Vertex& corner : v) {
      if (std::isfinite(corner.x)) corner.x = std::clamp(corner.x, low, high);
      if (std::isfinite(corner.y)) corner.y = std::clamp(corner.y, low, high);
    }
  };
  return stages;
}

// Two ways to place vertices, of which the first triangle's indices choose one for the whole call.
FixedStages PlacingByCall(std::string_view preset, const Snap& even, const Snap& odd) {
  FixedStages stages = Of(preset);
  stages.model = [even, odd](Profile& model, const Scene& scene) {
    if (scene.triangles.empty()) return;
    const Triangle& first = scene.triangles.front();
    model.snap = (first[0] + first[1] + first[2]) % 2 == 0 ? even : odd;
  };
  return stages;
}

// Two ways to place vertices, by turns: equal calls need not be equal.
FixedStages PlacingByTurns(std::string_view preset, const Snap& even, const Snap& odd) {
  FixedStages stages = Of(preset);
  stages.model = [even, odd, calls = 0U](Profile& model, const Scene&) mutable {
    model.snap = calls++ % 2 == 0 ? even : odd;
  };
  return stages;
}

FixedStages DrawingNan(std::string_view preset) {
  FixedStages stages = Of(preset);
  stages.vertices = [](std::array<Vertex, 3>& v) {
    for (Vertex& corner : v) {
      if (std::isnan(corner.x)) corner.x = 0;
      if (std::isnan(corner.y)) corner.y = 0;
      if (std::isnan(corner.z)) corner.z = 0;
    }
  };
  return stages;
}

// A pixel and more around small targets.
constexpr WindowBox kBand{-2, -2, 14, 14};

// Vertices outside the guard band move, and the edges that leave it with them.
FixedStages MovingOutside(double moved) {
  FixedStages stages = Of("vulkan");
  stages.profile.name = "vulkan, clipped";
  stages.profile.guard_band = kBand;
  stages.vertices = [moved](std::array<Vertex, 3>& v) {
    for (Vertex& corner : v) {
      if (!kBand.Contains(corner.x, corner.y)) corner.x += moved;
    }
  };
  return stages;
}

ClippingStages Clipping(std::string_view preset, double beyond, double wider = 0) {
  return {.base = Of(preset), .beyond = beyond, .wider = wider};
}

// Up or down, as the bits of the number say.
double RoundByHash(double x) {
  const std::uint64_t mixed = std::bit_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U;
  return (mixed >> 60 & 1U) != 0 ? Floor(x, 8) : -Floor(-x, 8);
}

// The images of draws, kept by the vertices in the steps of a grid and the indices.
FixedStages Keeping(std::string_view preset, std::function<std::int64_t(double)> word) {
  FixedStages stages = Of(preset);
  stages.kept_by = [word = std::move(word)](const Scene& scene) {
    std::vector<std::int64_t> key;
    for (const Vertex& v : scene.vertices) key.insert(key.end(), {word(v.x), word(v.y)});
    key.push_back(-1);  // of lists as long, one has the more vertices
    for (const Triangle& t : scene.triangles) key.insert(key.end(), t.begin(), t.end());
    return key;
  };
  return stages;
}

FixedStages KeepingByGrid(std::string_view preset, int bits) {
  return Keeping(preset, [bits](double x) {
    if (std::isnan(x)) return std::numeric_limits<std::int64_t>::min();
    return static_cast<std::int64_t>(std::clamp(std::ldexp(Floor(x, bits), bits), -0x1p60, 0x1p60));
  });
}

FreeStages Farthest(std::string_view preset, int bits, double tolerance, CoverageKind coverage) {
  FreeStages stages;
  stages.profile = *PresetProfile(preset);
  stages.bits = bits;
  stages.tolerance = tolerance;
  stages.harm = [](Point2 at, Point2 grid_point) {
    return (at.x - grid_point.x) * (at.x - grid_point.x) +
           (at.y - grid_point.y) * (at.y - grid_point.y);
  };
  stages.coverage = coverage;
  return stages;
}

// Each triangle takes the legal grid point that is nearer to its middle.
FreeStages SnapByTriangle() {
  FreeStages stages = Farthest("d3d11", 8, 0.6, CoverageKind::kFacingCounts);
  stages.instead = [](const FreeCorner& corner, Point2 legal) {
    const auto toward = [](double at, double middle, double own) {
      const double down = Floor(at, 8);
      const double off = std::ldexp(at - down, 8);
      if (off < 0.4 || off > 0.6) return own;
      return middle > at ? down + 0x1p-8 : down;
    };
    const auto& [a, b, c] = corner.triangle;
    return Point2{toward(corner.at.x, (a.x + b.x + c.x) / 3, legal.x),
                  toward(corner.at.y, (a.y + b.y + c.y) / 3, legal.y)};
  };
  return stages;
}

// Up where the fraction is above the threshold, else down.
double RoundAbove(double x, int bits, double threshold) {
  const double scaled = std::ldexp(x, bits);
  const double whole = std::floor(scaled);
  return std::ldexp(scaled - whole > threshold ? whole + 1 : whole, -bits);
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> SetVariants() {
  return {
      {"vulkan-4-bits", "the grid has four subpixel bits", "SwiftShader",
       Snapping("vulkan", [](double x) { return Nearest(x, 4); })},
      {"vulkan-4-bits-floor", "four subpixel bits, and the snap rounds down", "",
       Snapping("vulkan", [](double x) { return Floor(x, 4); })},
      {"vulkan-5-bits-truncate", "five subpixel bits, and the snap truncates", "",
       Snapping("vulkan", [](double x) { return std::ldexp(std::trunc(std::ldexp(x, 5)), -5); })},
      {"vulkan-8-bits-ceiling", "the snap rounds up", "",
       Snapping("vulkan", [](double x) { return -Floor(-x, 8); })},
      {"vulkan-owner-by-edge", "each edge has an owner of its own", "",
       Owning("vulkan", [](const GridEdge& edge, const GridTriangle&,
                           const Sample&) { return OwnedBy(edge, Coin(edge, 0)); })},
      {"vulkan-owner-by-sample", "each sample of an edge has an owner of its own", "",
       Owning("vulkan",
              [](const GridEdge& edge, const GridTriangle&, const Sample& sample) {
                return OwnedBy(edge, Coin(edge, sample.x * 31 + sample.row));
              })},
      {"vulkan-owner-by-tile", "the owner changes from tile to tile", "",
       Owning("vulkan",
              [](const GridEdge& edge, const GridTriangle&, const Sample& sample) {
                return OwnedBy(edge, (sample.x / 4 + sample.row / 4) % 2 == 0);
              })},
      {"vulkan-flat-drawn", "a triangle without area covers the samples on it", "",
       [] {
         FixedStages stages = Of("vulkan");
         stages.draws_flat = true;
         stages.owns = OwnsIfFlat;
         return stages;
       }()},
      {"vulkan-infinite-clamped", "an infinite coordinate is drawn as a far one", "",
       Clamping("vulkan")},
      {"vulkan-nan-drawn", "a NaN is drawn as zero", "", DrawingNan("vulkan")},
      {"vulkan-clipped-moves", "edges that leave the guard band move by half a step", "",
       MovingOutside(0x1p-9)},
      {"vulkan-clips-to-target", "triangles are clipped to the target, new vertices snap", "",
       Clipping("vulkan", 0)},
      {"vulkan-clips-64-beyond", "triangles are clipped 64 pixels around the target", "",
       Clipping("vulkan", 64)},
      {"gl-clips-to-target", "triangles are clipped to the target, new vertices snap", "",
       Clipping("gl", 0)},
      {"gl-clips-64-beyond", "triangles are clipped 64 pixels around the target", "",
       Clipping("gl", 64)},
      {"d3d11-clips-to-target", "triangles are clipped to the target, new vertices snap", "",
       Clipping("d3d11", 0)},
      {"d3d11-clips-64-beyond", "triangles are clipped 64 pixels around the target", "",
       Clipping("d3d11", 64)},
      {"vulkan-farthest-counts", "each vertex takes the farther grid point, shown as counts", "",
       Farthest("vulkan", 4, 1, CoverageKind::kCounts)},
      {"vulkan-farthest-mask", "each vertex takes the farther grid point, shown as a mask", "",
       Farthest("vulkan", 6, 1, CoverageKind::kMask)},
      {"vulkan-farthest-ids", "each vertex takes the farther grid point, shown as ids", "",
       Farthest("vulkan", 5, 1, CoverageKind::kPrimitiveIds)},
      {"vulkan-kept-by-all", "images are kept, and found again by every bit of the scene", "",
       Keeping("vulkan", [](double x) { return std::bit_cast<std::int64_t>(x); })},
      {"vulkan-17-bits", "17 subpixel bits, and the snap rounds down", "",
       Finer(17, [](double x) { return Floor(x, 17); })},
      {"vulkan-23-bits", "23 subpixel bits", "",
       Finer(23, [](double x) { return Nearest(x, 23); })},
      {"gl-4-bits-floor", "four subpixel bits, and the snap rounds down", "",
       Snapping("gl", [](double x) { return Floor(x, 4); })},
      {"gl-owner-by-direction", "an edge's direction decides who owns it", "",
       Owning("gl",
              [](const GridEdge& edge, const GridTriangle&, const Sample&) {
                const std::int64_t across = edge.b.x - edge.a.x;
                const std::int64_t down = edge.b.y - edge.a.y;
                return OwnedBy(edge, across * down < 0 || across == 0);
              })},
      {"gl-bottom-right", "ties fall to the right and the bottom", "",
       Owning("gl",
              [](const GridEdge& edge, const GridTriangle&, const Sample&) { return !edge.owns; })},
      {"d3d11-nearest-away", "ties of the snap go away from zero", "Direct3D 11.3, 3.2.4.1",
       Snapping("d3d11", [](double x) { return std::ldexp(std::round(std::ldexp(x, 8)), -8); })},
      {"d3d11-rounds-above-0.4", "the snap rounds up above 0.4 of a step", "",
       Snapping("d3d11", [](double x) { return RoundAbove(x, 8, 0.4); })},
      {"d3d11-farthest", "each vertex takes the farthest grid point within 0.6 of a step", "",
       Farthest("d3d11", 8, 0.6, CoverageKind::kFacingCounts)},
      {"d3d11-infinite-clamped", "an infinite coordinate is drawn as a far one", "",
       Clamping("d3d11")},
      {"d3d11-clamps-to-range", "coordinates beyond 16.8 go to the nearest end", "",
       ClampingTo(-0x1p15, 0x1p15 - 0x1p-8)},
      {"d3d11-snap-by-call", "which way ties of the snap go changes from call to call", "",
       PlacingByCall("d3d11", {8, SnapRule::kNearestEven}, {8, SnapRule::kNearestAway})},
      {"d3d11-snap-by-turns", "which way ties of the snap go changes from call to the next", "",
       PlacingByTurns("d3d11", {8, SnapRule::kNearestEven}, {8, SnapRule::kNearestAway})},
      {"webgpu-grid-by-call", "the grid has four subpixel bits in some calls, eight in others", "",
       PlacingByCall("webgpu", {4, SnapRule::kFloor}, {8, SnapRule::kNearestEven})},
      {"webgpu-owner-by-number", "every other triangle of a call owns the samples on its edges", "",
       Owning("webgpu", [](const GridEdge&, const GridTriangle& triangle,
                           const Sample&) { return triangle.number % 2 == 0; })},
      {"webgpu-inclusive", "every edge owns its samples", "",
       Owning("webgpu", [](const GridEdge&, const GridTriangle&, const Sample&) { return true; })},
      {"webgpu-exclusive", "no edge owns its samples", "",
       Owning("webgpu", [](const GridEdge&, const GridTriangle&, const Sample&) { return false; })},
      {"webgpu-owner-by-indices",
       "triangles whose indices add up to an even number own the samples on their edges", "",
       Owning("webgpu",
              [](const GridEdge&, const GridTriangle& triangle, const Sample&) {
                return (triangle.indices[0] + triangle.indices[1] + triangle.indices[2]) % 2 == 0;
              })},
      {"webgpu-whole-pixels", "vertices go to whole pixels", "",
       Snapping("webgpu", [](double x) { return Nearest(x, 0); })},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> SetMutants() {
  return {
      {"vulkan-3-bits", "the grid has three subpixel bits, where four are the fewest", "",
       Unclipped(Snapping("vulkan", [](double x) { return Nearest(x, 3); })), "subpixel-bits"},
      {"vulkan-two-owners", "every edge owns its samples", "",
       Owning("vulkan", [](const GridEdge&, const GridTriangle&, const Sample&) { return true; }),
       "tie-rule", "OpenTiesAreCoveredOnce"},
      {"vulkan-no-owner", "no edge owns its samples", "",
       Owning("vulkan", [](const GridEdge&, const GridTriangle&, const Sample&) { return false; }),
       "tie-rule"},
      {"vulkan-owner-by-triangle", "every other triangle owns the samples on its edges", "",
       Owning("vulkan", [](const GridEdge&, const GridTriangle& triangle,
                           const Sample&) { return triangle.number % 2 == 0; })},
      {"vulkan-owner-by-order", "the triangle whose first index is even owns the edge's samples",
       "",
       Owning("vulkan", [](const GridEdge& edge, const GridTriangle& triangle,
                           const Sample&) { return OwnedBy(edge, triangle.indices[0] % 2 == 0); })},
      {"vulkan-sample-off", "samples lie an eighth of a pixel off the centre", "",
       [] {
         FixedStages stages = Of("vulkan");
         stages.sample = [](const Sample& at) { return GridPoint{at.at.x + 32, at.at.y}; };
         return stages;
       }(),
       "sample-location"},
      {"vulkan-clipped-too-far", "edges that leave the guard band move by half a pixel", "",
       MovingOutside(0.5)},
      {"vulkan-clipped-apart", "neighbours part along edges that leave, by up to three steps", "",
       Clipping("vulkan", 0, -0x3p-4)},
      {"vulkan-clipped-twice", "both neighbours own samples up to two steps beside such edges", "",
       Clipping("vulkan", 0, 0x1p-3)},
      {"vulkan-17-bits-some-3", "of 17 subpixel bits some coordinates keep three, by their bits",
       "", Finer(17, [](double x) { return RoundByHash(x) < x ? Floor(x, 3) : Floor(x, 17); })},
      {"gl-rounds-by-hash", "off the grid the bits of a coordinate say whether it rounds up", "",
       Snapping("gl", RoundByHash)},
      {"gl-owner-by-sample", "each sample of an edge has an owner of its own", "",
       Owning("gl",
              [](const GridEdge& edge, const GridTriangle&, const Sample& sample) {
                return OwnedBy(edge, Coin(edge, sample.x * 31 + sample.row));
              })},
      {"gl-truncates", "the snap truncates to four bits, which zero divides in two", "",
       Unclipped(
           Snapping("gl", [](double x) { return std::ldexp(std::trunc(std::ldexp(x, 4)), -4); })),
       "subpixel-bits|truncation"},
      {"d3d11-rounds-above-0.39", "the snap rounds up above 0.39 of a step, where 0.4 is legal", "",
       Snapping("d3d11", [](double x) { return RoundAbove(x, 8, 0.39); })},
      {"d3d11-floor", "the snap rounds down", "Direct3D 10",
       Snapping("d3d11", [](double x) { return Floor(x, 8); }), "truncation"},
      {"d3d11-7-bits", "the grid has seven subpixel bits", "",
       Snapping("d3d11", [](double x) { return Nearest(x, 7); }), "subpixel-bits"},
      {"vulkan-kept-by-pixels", "images are kept, and found again by the vertices' pixels", "",
       KeepingByGrid("vulkan", 0), "earlier-draws",
       "NewVerticesGiveNewCoverage|EarlierScenesLeaveNoTrace"},
      {"vulkan-kept-by-indices", "images are kept, and found again by the indices alone", "",
       Keeping("vulkan", [](double) { return std::int64_t{0}; }), "earlier-draws",
       "NewVerticesGiveNewCoverage"},
      {"vulkan-kept-by-sixteenths", "images are kept, and found again by sixteenths of a pixel", "",
       KeepingByGrid("vulkan", 4), "earlier-draws", "EarlierScenesLeaveNoTrace"},
      {"gl-kept-by-sixteenths", "images are kept, and found again by sixteenths of a pixel", "",
       KeepingByGrid("gl", 4), "earlier-draws", "EarlierScenesLeaveNoTrace"},
      {"vulkan-snap-by-turns", "which way the snap rounds changes from call to the next", "",
       PlacingByTurns("vulkan", {8, SnapRule::kNearestEven}, {8, SnapRule::kFloor}),
       "earlier-draws", "TilesDrawnApartEqualTheWhole"},
      {"d3d11-kept-by-sixteenths", "images are kept, and found again by sixteenths of a pixel", "",
       KeepingByGrid("d3d11", 4), "earlier-draws", "NewVerticesGiveNewCoverage"},
      {"d3d11-bottom-right", "ties fall to the right and the bottom", "",
       Owning("d3d11",
              [](const GridEdge& edge, const GridTriangle&, const Sample&) { return !edge.owns; }),
       "tie-rule"},
      {"d3d11-clamps-to-half-range", "coordinates beyond 2^14 go there", "",
       ClampingTo(-0x1p14, 0x1p14), "range"},
      {"d3d11-snap-by-triangle", "each triangle of a call takes the grid points on its side", "",
       SnapByTriangle(), "list"},
      {"d3d11-nan-drawn", "a NaN is drawn as zero", "", DrawingNan("d3d11"), "not-finite"},
      {"webgpu-lost-by-number", "every other triangle of a call loses every third column", "",
       [] {
         FixedStages stages = Of("webgpu");
         stages.times = [](const Sample& sample, const GridTriangle& triangle) {
           return triangle.number % 2 == 1 && sample.x % 3 == 1 ? 0U : 1U;
         };
         return stages;
       }(),
       "list"},
      {"webgpu-edge-twice", "a triangle has the samples on its left edges twice", "",
       [] {
         FixedStages stages = Of("webgpu");
         stages.times = [](const Sample& sample, const GridTriangle& triangle) {
           return std::ranges::any_of(
                      triangle.edges,
                      [&](const GridEdge& edge) { return edge.owns && edge.At(sample.at) == 0; })
                      ? 2U
                      : 1U;
         };
         return stages;
       }()},
      {"webgpu-two-pixels-off", "samples lie two pixels off", "",
       [] {
         FixedStages stages = Of("webgpu");
         stages.sample = [](const Sample& at) { return GridPoint{at.at.x + 512, at.at.y}; };
         return stages;
       }(),
       "sample-location"},
  };
}

}  // namespace

FixedStages StagesOfPreset(std::string_view preset) { return {{}, *PresetProfile(preset)}; }

extern constinit const MutantTable kSetVariants{MutantKind::kLegal, 8, SetVariants};
extern constinit const MutantTable kSetMutants{MutantKind::kPlanted, 16, SetMutants};

}  // namespace rasterproof::subjects::mutants
