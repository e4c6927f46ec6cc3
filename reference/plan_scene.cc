#include "reference/plan_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

#include "core/error.h"
#include "library/triple_sum.h"
#include "model/snap.h"
#include "reference/bounds.h"
#include "reference/box.h"

namespace rasterproof::reference {
namespace {

int LatticeOf(Point2 p) { return -std::min(LatticeExponent(p.x), LatticeExponent(p.y)); }

std::optional<std::array<Point2, 3>> Corners2(const Scene& scene, const Triangle& t,
                                              const Profile& profile, const SampleGrid& grid) {
  return profile.snap.IsNone() ? ScreenCorners<false>(scene, t, profile.snap, grid)
                               : ScreenCorners<true>(scene, t, profile.snap, grid);
}

/// Whether no sample outside `area` lies in the closed box [least, most].
bool SamplesStayInside(Point2 least, Point2 most, const SampleGrid& grid, const PixelRect& area) {
  return std::ranges::all_of(grid.offsets, [&](Point2 o) {
    return area.x0 - 1 + o.x < least.x && most.x < area.x1 + o.x && area.y0 - 1 + o.y < least.y &&
           most.y < area.y1 + o.y;
  });
}

/// Kernels without clipping subtract offsets (below 2^17) from coordinates of the target (below
/// 2^17 as well): multiples of 2^-35 below 2^18 are doubles.
constexpr int kFinestUnclippedLattice = 35;

/// A difference of doubles, never less than the exact one.
double SideUp(double low, double high) {
  const double side = high - low;
  return side - high == -low && high - side == low ? side : RoundBoundUp(side);
}

double ProductUp(double x, double y) {
  const double product = x * y;
  return std::fma(x, y, -product) <= 0 ? product : RoundBoundUp(product);
}

/// The sign of x 2^bits - w steps.
int CompareQuotient(double x, double w, int bits, double steps) {
  library::TripleSum sum;
  sum.Add(x, std::ldexp(1.0, bits), 1);
  sum.Subtract(w, steps, 1);
  return sum.Sign();
}

double SnapQuotient(double x, double w, const Snap& snap, const std::string& place) {
  constexpr double kMostSteps = 0x1p50;  // halves of a step are doubles below this
  const double guess = std::ldexp(x / w, snap.bits);
  if (!(std::fabs(guess) < kMostSteps)) {
    throw InputError(place, "its snapped position x / w does not fit 50 bits",
                     "clip the scene, or use a profile without snapping");
  }
  // Rounding is monotone and the grid's points are doubles: the guess can be rounded up to one from
  // below, never down past one.
  double floor = std::floor(guess);
  if (CompareQuotient(x, w, snap.bits, floor) < 0) --floor;
  // A quarter of a step stands for every place on its side of the middle.
  const int middle = CompareQuotient(x, w, snap.bits, floor + 0.5);
  const bool whole = CompareQuotient(x, w, snap.bits, floor) == 0;
  const double place_in_step = whole ? 0 : 0.5 + 0.25 * middle;
  return SnapCoordinate(std::ldexp(floor + place_in_step, -snap.bits), snap);
}

}  // namespace

SceneExtent MeasureScene(const Scene& scene, const Profile& profile, const DrawOptions& options) {
  const SampleGrid grid(profile, scene.height);
  const PixelRect area = DrawArea(scene, options);
  SceneExtent extent;
  extent.lattice = SceneLattice(scene, profile);
  for (const Triangle& t : scene.triangles) {
    const auto v = Corners2(scene, t, profile, grid);
    if (!v) continue;
    const auto [left, right] = std::minmax({(*v)[0].x, (*v)[1].x, (*v)[2].x});
    const auto [top, bottom] = std::minmax({(*v)[0].y, (*v)[1].y, (*v)[2].y});
    const double width = SideUp(left, right);
    const double height = SideUp(top, bottom);
    extent.largest = std::max(
        {extent.largest, std::fabs(left), std::fabs(right), std::fabs(top), std::fabs(bottom)});
    extent.widest = std::max(extent.widest, width);
    extent.tallest = std::max(extent.tallest, height);
    extent.largest_area = std::max(extent.largest_area, ProductUp(width, height));
    extent.inside_area =
        extent.inside_area && SamplesStayInside({left, top}, {right, bottom}, grid, area);
    extent.on_grid = extent.on_grid && ScreenCorners<false>(scene, t, profile.snap, grid) == v;
  }
  extent.inside_area = extent.inside_area && extent.lattice <= kFinestUnclippedLattice;
  return extent;
}

int SceneLattice(const Scene& scene, const Profile& profile) {
  const SampleGrid grid(profile, scene.height);
  int lattice = 0;
  for (const Point2 offset : grid.offsets) lattice = std::max(lattice, LatticeOf(offset));
  for (const Triangle& t : scene.triangles) {
    const auto v = Corners2(scene, t, profile, grid);
    if (!v) continue;
    for (const Point2 corner : *v) lattice = std::max(lattice, LatticeOf(corner));
  }
  return lattice;
}

Scene SnapProjected(const Scene& scene, const Profile& profile) {
  if (profile.snap.form != SnapForm::kCoordinate) {
    throw InputError("profile \"" + profile.name + "\"",
                     "it snaps differences of window coordinates, not x / w",
                     "use a window-space scene, or a profile that snaps coordinates");
  }
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  Scene snapped = scene;
  snapped.precision = Precision::kFloat64;
  snapped.clip_space = false;
  // A vertex that only non-finite triangles use keeps them from covering anything.
  for (Vertex& v : snapped.vertices) v = {kNowhere, kNowhere, v.z, 1};
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> corners = Corners(scene, t);
    if (!std::ranges::all_of(corners, IsFinite)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string place = "vertices[" + std::to_string(t[k]) + "]";
      const Vertex& v = corners[k];
      if (v.w <= 0) {
        throw InputError(place, "with w <= 0 it has no position to snap",
                         "use a profile without snapping, or clip the scene in front of the eye");
      }
      snapped.vertices[static_cast<std::size_t>(t[k])] = {
          SnapQuotient(v.x, v.w, profile.snap, place), SnapQuotient(v.y, v.w, profile.snap, place),
          v.z, 1};
    }
  }
  return snapped;
}

}  // namespace rasterproof::reference
