// Bugs that were written after the generators and the properties had been frozen.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/snap.h"
#include "library/exact_sign.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> FixedPointOnes() {
  return {
      {"late-half-up-y", "ties of the snap go up along y", "",
       FixedStages{{.snap =
                        [](double x, bool along_y) {
                          return SnapToGrid(
                              x, {8, along_y ? SnapRule::kHalfUp : SnapRule::kNearestEven});
                        }}},
       "rounding"},
      {"late-small-box",
       "boxes of at most 4x4 pixels lose their last row if they are higher than wide", "",
       FixedStages{{.box =
                        [](PixelRect& box, const GridTriangle&, const Scene&) {
                          const int w = box.x1 - box.x0;
                          const int h = box.y1 - box.y0;
                          if (w <= 4 && h <= 4 && h > w) --box.y1;
                        }}}},
      {"late-long-horizontal", "a horizontal edge of more than 1024 pixels owns its samples", "",
       FixedStages{{.owns =
                        [](const GridEdge& e, const GridTriangle&, const Sample&) {
                          const bool is_long = std::abs(e.b.x - e.a.x) > 1024 * 256;
                          return e.owns || (is_long && e.a.y == e.b.y);
                        }}}},
      {"late-same-area", "a triangle of the same facing and area as the one before is not drawn",
       "",
       FixedStages{{.area =
                        [last = std::int64_t{0}](const std::array<GridPoint, 3>& v) mutable {
                          const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
                          return std::exchange(last, area) == area ? 0 : area;
                        }}},
       "list"},
      {"late-beside-vertex", "a sample beside a vertex, by at most 2/256 pixel, is not drawn", "",
       FixedStages{{.times =
                        [](const Sample& at, const GridTriangle& t) {
                          return std::ranges::any_of(t.v,
                                                     [&](const GridPoint& p) {
                                                       const std::int64_t off =
                                                           std::max(std::abs(p.x - at.at.x),
                                                                    std::abs(p.y - at.at.y));
                                                       return off == 1 || off == 2;
                                                     })
                                     ? 0U
                                     : 1U;
                        }}}},
      {"late-cull-small", "where anything is culled, triangles under half a pixel are lost", "",
       [] {
         // The stages share what the options said.
         const auto culls = std::make_shared<bool>(false);
         return FixedStages{
             {.options = [culls](DrawOptions& options,
                                 const Scene&) { *culls = options.cull != Cull::kNone; },
              .area =
                  [culls](const std::array<GridPoint, 3>& v) {
                    const std::int64_t area = GridEdge{v[0], v[1]}.At(v[2]);
                    return *culls && std::abs(area) < 65536 ? 0 : area;
                  }}};
       }(),
       "culling"},
      {"late-slope-saturates", "edge deltas saturate at 24576 pixels", "",
       FixedStages{{.value =
                        [](const GridEdge& e, const Sample& at) {
                          const auto held = [](std::int64_t d) {
                            return std::clamp<std::int64_t>(d, -24576 * 256, 24576 * 256);
                          };
                          return (at.at.x - e.a.x) * held(e.b.y - e.a.y) -
                                 (at.at.y - e.a.y) * held(e.b.x - e.a.x);
                        }}}},
  };
}

std::vector<Mutant> OtherOnes() {
  return {
      {"late-real-short-edges", "edges shorter than a pixel are evaluated in float32", "",
       Signing([](Point2 a, Point2 b, Point2 p) {
         if (Hypot(b.x - a.x, b.y - a.y) >= 1) {
           return library::EdgeSign(a, b, p);
         }
         const auto f = [](double x) { return static_cast<float>(x); };
         const float left = (f(p.x) - f(a.x)) * (f(b.y) - f(a.y));
         const float right = (f(p.y) - f(a.y)) * (f(b.x) - f(a.x));
         return (left > right) - (left < right);
       })},
      {"late-clip-depth-range", "w below 2^-12 of the largest of the triangle is raised to that",
       "",
       ClipStages{{.clip =
                       [](const ClipTriangle& v) {
                         const double most = std::max({v[0].w, v[1].w, v[2].w});
                         ClipTriangle raised = v;
                         for (Vertex& p : raised) {
                           if (p.w > 0) p.w = std::max(p.w, most * 0x1p-12);
                         }
                         return std::vector<ClipTriangle>{raised};
                       }}}},
      {"late-barycentrics-near-zero", "barycentrics below 10^-4 are shown as zero", "",
       ValueStages{.barycentrics =
                       [](Triple& l, BarycentricForm, const std::array<Point2, 3>&, Point2) {
                         for (double& barycentric : l) {
                           if (std::fabs(barycentric) < 1e-4) barycentric = 0;
                         }
                       }},
       "shown-values"},
  };
}

std::vector<Mutant> LateMutants() {
  std::vector<Mutant> table = FixedPointOnes();
  for (Mutant& planted : OtherOnes()) table.push_back(std::move(planted));
  return table;
}

}  // namespace

extern constinit const MutantTable kLateMutants{MutantKind::kLate, 1, LateMutants};

}  // namespace rasterproof::subjects::mutants
