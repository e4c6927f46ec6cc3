// Where attributes are evaluated that are asked for at a fragment's centroid: what the legal sets
// leave open of it, and what they don't.
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/sample_pattern.h"
#include "subjects/mutants/centroids.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Evaluates = std::function<Point2(const CentroidQuestion&)>;

constexpr double kSubpixel = 0x1p-8;

CentroidStages Evaluating(std::string_view preset, Evaluates centroid) {
  CentroidStages stages;
  stages.base = StagesOfPreset(preset);
  stages.centroid = std::move(centroid);
  return stages;
}

// One model, whose vertices are those that barycentrics belong to.
CentroidStages EvaluatingSnapped(Centroid rule, Evaluates centroid) {
  CentroidStages stages;
  stages.base.profile.name = "four samples, centroids stated";
  stages.base.profile.pattern = *StandardPattern(4);
  stages.base.profile.centroid = rule;
  stages.barycentrics_of = BarycentricsOf::kSnapped;
  stages.centroid = std::move(centroid);
  return stages;
}

// Barycentrics of a grid that the profile leaves free.
CentroidStages ShowingSnapped(std::function<void(ShownFragment&)> shown) {
  CentroidStages stages{.base = StagesOfPreset("vulkan"),
                        .barycentrics_of = BarycentricsOf::kSnapped};
  stages.shown = std::move(shown);
  return stages;
}

Point2 Centre(const CentroidQuestion& q) { return q.Centre(); }

Point2 FirstCovered(const CentroidQuestion& q) {
  return q
      .samples[static_cast<std::size_t>(std::ranges::find(q.covered, true) - q.covered.begin())];
}

Point2 LastCovered(const CentroidQuestion& q) {
  if (q.IsWhole()) return q.Centre();
  std::size_t last = 0;
  for (std::size_t s = 0; s < q.samples.size(); ++s) {
    if (q.covered[s]) last = s;
  }
  return q.samples[last];
}

Point2 MeanOf(const std::vector<Point2>& points) {
  Point2 sum;
  for (const Point2 p : points) sum = {sum.x + p.x, sum.y + p.y};
  const auto n = static_cast<double>(points.size());
  return {sum.x / n, sum.y / n};
}

Point2 MeanOfCovered(const CentroidQuestion& q) {
  std::vector<Point2> covered;
  for (std::size_t s = 0; s < q.samples.size(); ++s) {
    if (q.covered[s]) covered.push_back(q.samples[s]);
  }
  return MeanOf(covered);
}

Point2 NearestOfSegment(Point2 a, Point2 b, Point2 p) {
  const Point2 d{b.x - a.x, b.y - a.y};
  const double length = d.x * d.x + d.y * d.y;
  if (length == 0) return a;
  const double part = std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length, 0.0, 1.0);
  return {a.x + part * d.x, a.y + part * d.y};
}

bool IsInside(const std::array<Point2, 3>& v, Point2 p) {
  const auto edge = [&](std::size_t i) {
    const Point2 a = v[i];
    const Point2 b = v[(i + 1) % 3];
    return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
  };
  const auto [least, most] = std::minmax({edge(0), edge(1), edge(2)});
  return least >= 0 || most <= 0;
}

// Of what pixel and triangle have in common, the point nearest to the centre.
Point2 NearestToTheCentre(const CentroidQuestion& q) {
  const Point2 centre = q.Centre();
  if (IsInside(q.v, centre)) return centre;
  const std::vector<Point2> polygon = CommonPolygon(q);
  Point2 nearest = FirstCovered(q);
  double least = Hypot(nearest.x - centre.x, nearest.y - centre.y);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 p = NearestOfSegment(polygon[k], polygon[(k + 1) % polygon.size()], centre);
    const double distance = Hypot(p.x - centre.x, p.y - centre.y);
    if (distance >= least) continue;
    least = distance;
    nearest = p;
  }
  return nearest;
}

Point2 CornerOfTheCommonPart(const CentroidQuestion& q) {
  const std::vector<Point2> polygon = CommonPolygon(q);
  return polygon.empty() ? FirstCovered(q) : polygon.front();
}

Point2 MiddleOfTheCommonPart(const CentroidQuestion& q) {
  const std::vector<Point2> polygon = CommonPolygon(q);
  return polygon.empty() ? FirstCovered(q) : MeanOf(polygon);
}

// The nearest point, and from there on towards the centre that is not covered.
Point2 SubpixelBeyondTheEdge(const CentroidQuestion& q) {
  const Point2 centre = q.Centre();
  const Point2 nearest = NearestToTheCentre(q);
  const double distance = Hypot(centre.x - nearest.x, centre.y - nearest.y);
  if (distance < 2 * kSubpixel) return nearest;
  const double part = kSubpixel / distance;
  return {nearest.x + part * (centre.x - nearest.x), nearest.y + part * (centre.y - nearest.y)};
}

Point2 ClampedToTheBox(const CentroidQuestion& q) {
  const auto [left, right] = std::minmax({q.v[0].x, q.v[1].x, q.v[2].x});
  const auto [top, bottom] = std::minmax({q.v[0].y, q.v[1].y, q.v[2].y});
  const Point2 centre = q.Centre();
  return {std::clamp(centre.x, left, right), std::clamp(centre.y, top, bottom)};
}

// The first covered sample, where it lies in pixels whose pattern is mirrored.
Point2 FirstCoveredOfAnotherPattern(const CentroidQuestion& q) {
  if (q.IsWhole() || q.x % 2 == 0) return CentroidOfDirect3D(q);
  const Point2 first = FirstCovered(q);
  return {2 * q.low.x + 1 - first.x, first.y};
}

std::vector<Mutant> CentroidMutants() {
  return {
      {"centroid-centre-always", "centroid is the pixel's centre, covered in part or not", "",
       Evaluating("d3d11-4x", Centre), "shown-values", "CentroidsLieWhereStated"},
      {"centroid-last-covered", "centroid is the covered sample of the largest index", "",
       Evaluating("d3d11-4x", LastCovered), "shown-values"},
      {"centroid-first-of-pattern", "centroid is the first sample, covered or not", "",
       Evaluating(
           "d3d11-4x",
           [](const CentroidQuestion& q) { return q.IsWhole() ? q.Centre() : q.samples[0]; }),
       "shown-values"},
      {"centroid-mean-under-d3d11", "centroid is the mean of the covered samples", "",
       Evaluating(
           "d3d11-4x",
           [](const CentroidQuestion& q) { return q.IsWhole() ? q.Centre() : MeanOfCovered(q); }),
       "shown-values"},
      {"centroid-first-of-whole", "centroid of a whole pixel is its first sample", "",
       Evaluating("d3d11-8x", FirstCovered), "shown-values"},
      {"centroid-nearest-under-d3d11", "centroid is the covered point nearest to the centre", "",
       Evaluating("d3d11-8x", NearestToTheCentre), "shown-values"},
      {"centroid-of-another-pattern",
       "centroid is the first covered sample of the pattern that the next pixel has", "",
       Evaluating("d3d11-4x", FirstCoveredOfAnotherPattern), "shown-values"},
      {"centroid-centre-under-vulkan", "centroid is the centre, though the triangle misses it", "",
       Evaluating("vulkan-4x", Centre), "shown-values"},
      {"centroid-clamped-to-box", "centroid is the centre, clamped to the triangle's box", "",
       Evaluating("gl-4x", ClampedToTheBox), "shown-values"},
      {"centroid-of-triangle", "centroid is the triangle's, wherever the pixel lies", "",
       Evaluating("webgpu-4x",
                  [](const CentroidQuestion& q) { return MeanOf({q.v[0], q.v[1], q.v[2]}); }),
       "shown-values"},
      {"centroid-subpixel-outside", "centroid lies a 256th of a pixel beyond the triangle's edge",
       "", EvaluatingSnapped(Centroid::kInside, SubpixelBeyondTheEdge), "shown-values"},
      {"vulkan-fragments-sum-off", "a barycentric at a snapped triangle's sample is off by 2^-10",
       "", ShowingSnapped([](ShownFragment& f) { f.barycentrics[2] += 0x1p-10; }), "shown-values",
       "FragmentBarycentricsSumToOne"},
      {"vulkan-depth-off", "a depth of a snapped triangle is off by a quarter", "",
       ShowingSnapped([](ShownFragment& f) { f.depth *= 1.25; }), "shown-values",
       "FragmentDepthStaysInTheHull|FragmentDepthFollowsItsBarycentrics"},
      {"centroid-beside-the-only-sample", "centroid of one sample is not the centre", "",
       Evaluating("gl", MiddleOfTheCommonPart), "shown-values", "CentroidsLieWhereStated"},
  };
}

std::vector<Mutant> CentroidVariants() {
  return {
      {"centroid-direct3d-1x", "centroid of one sample is the centre", "Direct3D 11.3, 3.5.5",
       Evaluating("d3d11", {})},
      {"centroid-direct3d-4x", "centroid of four samples is where Direct3D says",
       "Direct3D 11.3, 3.5.5", Evaluating("d3d11-4x", {})},
      {"centroid-direct3d-8x", "centroid of eight samples is where Direct3D says",
       "Direct3D 11.3, 3.5.5", Evaluating("d3d11-8x", {})},
      {"centroid-direct3d-snapped", "centroid is told by the snapped vertices", "",
       EvaluatingSnapped(Centroid::kDirect3D, {})},
      {"vulkan-fragments-snapped", "barycentrics belong to corners on a grid of its own choice", "",
       ShowingSnapped({})},
      {"centroid-inside-1x", "centroid of one sample is the centre", "Vulkan",
       Evaluating("vulkan", Centre)},
      {"centroid-inside-snapped",
       "centroid is the covered point nearest to the centre, told by the snapped vertices", "",
       EvaluatingSnapped(Centroid::kInside, NearestToTheCentre)},
      {"vulkan-centroid-nearest", "centroid is the covered point nearest to the centre", "Vulkan",
       Evaluating("vulkan-4x", NearestToTheCentre)},
      {"vulkan-centroid-corner", "centroid is a corner of what pixel and triangle share", "",
       Evaluating("vulkan-standard-8x", CornerOfTheCommonPart)},
      {"gl-centroid-first-covered", "centroid is the first covered sample, of whole pixels too",
       "OpenGL", Evaluating("gl-4x", FirstCovered)},
      {"gl-centroid-mean", "centroid is the mean of the covered samples", "",
       Evaluating("gl-8x", MeanOfCovered)},
      {"webgpu-centroid-middle", "centroid is the middle of what pixel and triangle share", "",
       Evaluating("webgpu-4x", MiddleOfTheCommonPart)},
  };
}

}  // namespace

extern constinit const MutantTable kCentroidMutants{MutantKind::kPlanted, 22, CentroidMutants};
extern constinit const MutantTable kCentroidVariants{MutantKind::kLegal, 14, CentroidVariants};

}  // namespace rasterproof::subjects::mutants
