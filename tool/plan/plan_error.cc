#include "tool/plan/plan_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/evaluators.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "library/kernels/kernel.h"
#include "library/rivals/rival.h"
#include "reference/method.h"

namespace rasterproof::tool {
namespace {

using Corners2 = std::array<Point2, 3>;

// The centres of the pixels of a triangle's box that lie on the target, and how many a row has.
struct Rows {
  Point2 first;
  double last_y = 0;
  int steps = 0;
  bool is_empty = false;
};

Rows RowsOf(const Corners2& v, const Scene& scene) {
  const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
  const double left = std::clamp(std::floor(x0) - 1, 0.0, scene.width - 1.0);
  const double right = std::clamp(std::ceil(x1) + 1, 0.0, scene.width - 1.0);
  const double top = std::clamp(std::floor(y0) - 1, 0.0, scene.height - 1.0);
  const double bottom = std::clamp(std::ceil(y1) + 1, 0.0, scene.height - 1.0);
  const bool is_outside = x1 < 0 || y1 < 0 || x0 > scene.width || y0 > scene.height;
  return {.first = {left + 0.5, top + 0.5},
          .last_y = bottom + 0.5,
          .steps = static_cast<int>(right - left),
          .is_empty = is_outside};
}

// The largest bound on the values met along a row; NaN if one of them has none.
double LargestOnRow(const EdgeBounds& edges, Point2 a, Point2 b, Point2 p, int steps) {
  double largest = 0;
  for (const double bound : edges.SteppingErrorBounds(a, b, p, {}, steps)) {
    if (std::isnan(bound)) return bound;
    largest = std::max(largest, bound);
  }
  return largest;
}

// Over all edges. Bounds are sums of magnitudes of linear functions of the sample, convex along a
// column, so that the first and the last row tell; where both are exact all between are.
double LargestOverScene(const EdgeBounds& edges, const Scene& scene) {
  double largest = 0;
  for (const Triangle& triangle : scene.triangles) {
    const auto corners = Corners(scene, triangle);
    if (!std::ranges::all_of(corners, [](const Vertex& c) { return IsFinite(c); })) continue;
    const Corners2 v{WindowPoint(corners[0]), WindowPoint(corners[1]), WindowPoint(corners[2])};
    const Rows rows = RowsOf(v, scene);
    if (rows.is_empty) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = v[k];
      const Point2 b = v[(k + 1) % 3];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length == 0) continue;
      for (const double y : {rows.first.y, rows.last_y}) {
        const double bound = LargestOnRow(edges, a, b, {rows.first.x, y}, rows.steps) / length;
        if (std::isnan(bound)) return bound;
        largest = std::max(largest, bound);
      }
    }
  }
  return largest;
}

double LargestCoordinate(const Scene& scene) {
  double largest = 0;
  for (const Vertex& v : scene.vertices) {
    if (IsFinite(v)) largest = std::max({largest, std::abs(v.x), std::abs(v.y)});
  }
  return largest;
}

// A corner moves by half a step along either axis, and no edge farther than its ends.
double SnapDistance(int bits) { return std::ldexp(std::numbers::sqrt2 / 2, -bits); }

std::string BeyondText(double limit) { return fmt::format("a corner lies beyond {} px", limit); }

ProvedError RivalError(const library::rivals::Rival& rival, const Scene& scene) {
  using library::rivals::Traversal;
  // The slopes of spans are rounded.
  if (!Snaps(rival.arithmetic) || rival.traversal != Traversal::kTiles) {
    return {.why = "it has no proved bound"};
  }
  const double limit = library::rivals::kFixedRange;
  if (LargestCoordinate(scene) > limit) return {.why = BeyondText(limit)};
  return {SnapDistance(8), "corners on 1/256 px, exact from there"};
}

double CoveredPerTriangle(const BenchFamily& family) {
  const auto triangles = static_cast<double>(std::max<std::uint64_t>(1, family.triangles));
  return std::max(static_cast<double>(family.covered), 1.0) / triangles;
}

double CoveredPerTriangle(const Scene& scene) {
  const CoverageCounts counts = exact::Coverage(scene, Profile{});
  double covered = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) covered += static_cast<double>(counts.Count(i));
  const auto triangles = static_cast<double>(std::max<std::size_t>(1, scene.triangles.size()));
  return std::max(covered, 1.0) / triangles;
}

}  // namespace

ProvedError ProvedErrorOf(std::string_view name, const Scene& scene) {
  if (name == "kernel-exact" || name == "kernel-clip") {
    return {0, "exact for every finite float32"};
  }
  if (const auto rival = library::rivals::FindRival(name)) return RivalError(*rival, scene);
  const reference::Method* const method = reference::FindMethod(name);
  if (method == nullptr) return {.why = "not a method of this program"};
  const SubjectInfo& info = method->info;
  if (LargestCoordinate(scene) > info.profile.coordinate_limit) {
    return {.why = BeyondText(info.profile.coordinate_limit)};
  }
  if (info.states_exact && info.profile.snap.IsNone()) return {0, "exact"};
  if (info.states_exact) {
    const int bits = info.profile.snap.bits;
    return {SnapDistance(bits), fmt::format("corners on 1/{} px, exact from there", 1 << bits)};
  }
  if (method->edges == nullptr || method->steps_from_corner) {
    return {.why = "it has no proved bounds steps down and across"};
  }
  const double largest = LargestOverScene(*method->edges, scene);
  if (std::isnan(largest)) return {.why = "no bound is proved for this scene's edges"};
  return {largest, "error of E over the edge's length, largest over the scene"};
}

std::size_t NearestFamily(const BenchResult& bench, const Scene& scene, const std::string& place) {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  const double size = CoveredPerTriangle(scene);
  std::size_t nearest = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < bench.families.size(); ++k) {
    const BenchFamily& family = bench.families[k];
    if (family.is_clip_space != scene.clip_space) continue;
    if (!scene.name.empty() && family.name == scene.name) return k;
    const double factor = std::abs(std::log(CoveredPerTriangle(family) / size));
    if (factor >= least) continue;
    least = factor;
    nearest = k;
  }
  if (nearest != kNone) return nearest;
  throw InputError(place, "it holds no family in the scene's kind of coordinates",
                   "time the scene itself: rasterproof bench --scene SCENE --json FILE");
}

std::vector<ErrorChoice> ErrorChoices(const BenchResult& bench, std::size_t family,
                                      const Scene& scene, double most_pixels) {
  std::vector<ErrorChoice> choices;
  const auto triangles =
      static_cast<double>(std::max<std::uint64_t>(1, bench.families[family].triangles));
  for (const BenchRow& row : bench.rows) {
    const BenchMethod& method = bench.methods[row.method];
    if (row.family != family || method.sink != NameOf(library::kernels::Sink::kFacing)) continue;
    if (row.method == bench.families[family].twin || method.kind == "floor") continue;
    const ProvedError error = ProvedErrorOf(method.name, scene);
    choices.push_back({.method = method.name,
                       .target = method.target,
                       .proved = error.pixels,
                       .why = error.why,
                       .nanoseconds = 1e9 * row.time.median / triangles,
                       .meets = error.pixels <= most_pixels});
  }
  std::ranges::sort(choices, {}, [](const ErrorChoice& one) {
    return std::tuple(one.nanoseconds, std::string_view(one.method), std::string_view(one.target));
  });
  return choices;
}

}  // namespace rasterproof::tool
