#include "props/judging/freedom/facing_freedom.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/profile.h"
#include "core/target_size.h"
#include "exact/coverage.h"
#include "model/target_profile.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/freedom/sample_region.h"
#include "props/judging/freedom/thin_triangles.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// What doubles make of a clipped triangle's thickness is off by less than this times its largest
// coordinate L. With u = 2^-53 a cut's share carries four roundings and its point three more, of a
// difference of at most 2L, and one of L: 15u L on each axis, 22u L in all. Cutting convex polygons
// that lie within d of each other gives some whose thickness differs by at most 3d: the four cuts
// leave 4 * 3 * 22u L = 264u L. A distance from a line carries five roundings of at most
// 2 sqrt(2) L, less than 16u L. 512u L in all.
constexpr double kRoundingMargin = 0x1p-44;

using Polygon = std::vector<Point2>;

// Returns the step of the coarsest legal grid, in pixels; 0: there is no grid.
double CoarsestStep(const Profile& profile) {
  if (profile.snap.IsNone()) return 0;
  return std::ldexp(1.0, -profile.freedom.least_bits.value_or(profile.snap.bits));
}

// The part where `inside`, affine, is not negative.
template <class Inside>
Polygon Cut(const Polygon& polygon, const Inside& inside) {
  Polygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 a = polygon[k];
    const Point2 b = polygon[(k + 1) % polygon.size()];
    const double at_a = inside(a);
    const double at_b = inside(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) == (at_b < 0)) continue;
    const double part = at_a / (at_a - at_b);
    kept.push_back({a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part});
  }
  return kept;
}

Polygon CutTo(const Polygon& polygon, const LegalPlaces& box) {
  Polygon cut = Cut(polygon, [&](Point2 p) { return p.x - box.low.x; });
  cut = Cut(cut, [&](Point2 p) { return p.y - box.low.y; });
  cut = Cut(cut, [&](Point2 p) { return box.high.x - p.x; });
  return Cut(cut, [&](Point2 p) { return box.high.y - p.y; });
}

bool Leaves(const std::array<Vertex, 3>& v, const Scene& scene) {
  return !std::ranges::all_of(v, [&](const Vertex& p) {
    return p.x >= 0 && p.y >= 0 && p.x <= scene.width && p.y <= scene.height;
  });
}

// The part of the triangle in the target, grown by a step, is too thin to have a facing.
bool IsThinOnceClipped(const std::array<Vertex, 3>& v, const Scene& scene, double step) {
  double largest = 0;
  for (const Vertex& p : v) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  const Polygon whole{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
  const Polygon part = CutTo(whole, {{-step, -step}, {scene.width + step, scene.height + step}});
  return !(WidthOf(part) > kThinnestClippedSteps * step + kRoundingMargin * largest);
}

constexpr int kReferenceSide = 4;

Scene ReferenceTriangle(int width, int height) {
  Scene scene;
  scene.name = "reference triangle";
  scene.width = width;
  scene.height = height;
  scene.vertices = {{0, 0, 0, 1}, {2.0 * width, 0, 0, 1}, {0, 2.0 * height, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  return scene;
}

}  // namespace

LegalTriangle::LegalTriangle(const PlacedCase& c, const Triangle& t) {
  const TargetProfile& profile = c.profile;
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  if (!std::ranges::all_of(v, IsFinite)) return;
  const auto places = LegalPlacesOf(c, t);
  if (!places) return;
  has_places_ = true;
  knows_samples_ = profile.sample_positions == SamplePositions::kStated;
  beyond_pixel_ = knows_samples_ || BoundsSamples(profile) ? 0 : kSampleMargin;
  places_ = *places;
  turn_ = FacingOfAll(places_).value_or(0);
  const double step = CoarsestStep(profile);
  const bool leaves = Leaves(v, c.scene);
  if (turn_ == 0 || (leaves && step > 0 && IsThinOnceClipped(v, c.scene, step))) return;
  facing_ = profile.y_axis == YAxis::kUp ? -turn_ : turn_;
  is_culled_ = AlwaysCulls(profile, facing_);
  if (!leaves) return;
  // New vertices lie within a step of the edges.
  for (auto& [low, high] : places_) {
    low = {low.x - step, low.y - step};
    high = {high.x + step, high.y + step};
  }
}

bool LegalTriangle::CoversInEveryModel(Point2 p) const {
  if (facing_ == 0 || is_culled_) return false;
  std::vector<Point2> at{p};
  if (!knows_samples_) {
    const Point2 corner{std::floor(p.x), std::floor(p.y)};
    const double far = 1 + beyond_pixel_;
    at = CornersOf(
        {{corner.x - beyond_pixel_, corner.y - beyond_pixel_}, {corner.x + far, corner.y + far}});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto turn = FacingOfAll(CornersOf(places_[i]), CornersOf(places_[(i + 1) % 3]), at);
    if (turn != turn_) return false;
  }
  return true;
}

bool LegalTriangle::MayCover(Point2 p) const {
  if (is_culled_) return false;
  if (!has_places_) return true;
  const auto& [a, b, d] = places_;
  // A pixel more holds every sample of the pixel, and what clipping moves.
  return p.x >= std::min({a.low.x, b.low.x, d.low.x}) - 1 - kSampleMargin &&
         p.y >= std::min({a.low.y, b.low.y, d.low.y}) - 1 - kSampleMargin &&
         p.x <= std::max({a.high.x, b.high.x, d.high.x}) + 1 + kSampleMargin &&
         p.y <= std::max({a.high.y, b.high.y, d.high.y}) + 1 + kSampleMargin;
}

std::vector<Reference> ReferencesOf(const PlacedCase& c) {
  std::vector<Reference> references;
  if (c.profile.contract != Contract::kSampleExact) return references;
  const auto add = [&](int width, int height) {
    if (!IsTargetSize(width, height, c.profile.pattern.samples())) return;
    Reference reference{c.With(ReferenceTriangle(width, height))};
    if (!reference.value.culled.empty()) {
      Scene turned = reference.value.scene;
      turned.triangles = {{0, 2, 1}};
      reference.value = c.With(std::move(turned));
    }
    const Scene& scene = reference.value.scene;
    if (!WithinLimits(scene, c.profile) || !IsUnwrapped(scene, c.profile)) return;
    reference.facing = LegalTriangle(reference.value, scene.triangles[0]).facing();
    if (reference.facing != 0) references.push_back(std::move(reference));
  };
  add(kReferenceSide, kReferenceSide);
  add(c.scene.width, c.scene.height);
  return references;
}

PlacedCase BehindItsReference(const PlacedCase& c, const std::vector<Reference>& references,
                              std::size_t count) {
  Scene scene = c.scene;
  scene.triangles.resize(count);
  if (references.empty()) return c.With(std::move(scene));
  const Scene& reference = references.back().value.scene;
  if (reference.width != scene.width || reference.height != scene.height) {
    return c.With(std::move(scene));
  }
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), reference.vertices.begin(), reference.vertices.end());
  scene.triangles.insert(scene.triangles.begin(), {first, first + 1, first + 2});
  return c.With(std::move(scene));
}

int ShownFacing(const CoverageCounts& counts) {
  const auto covered = [](std::uint32_t n) { return n != 0; };
  const bool front = std::ranges::any_of(counts.front, covered);
  const bool back = std::ranges::any_of(counts.back, covered);
  if (front == back) return 0;
  return front ? 1 : -1;
}

}  // namespace rasterproof::props
