#include "props/judging/values/centroid_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact/half_planes.h"
#include "exact/values.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/gate.h"
#include "props/judging/values/value_estimates.h"

namespace rasterproof::props {
namespace {

using exact::HalfPlane;
using exact::Rational;

// In double, of corners in front of the eye: a point of clip space, and what its division may miss.
std::optional<std::array<LegalPlaces, 3>> QuotientsOf(const std::array<Vertex, 3>& v) {
  std::array<LegalPlaces, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(v[i].w > 0)) return std::nullopt;
    const Point2 at{v[i].x / v[i].w, v[i].y / v[i].w};
    const double x = std::fabs(at.x) * 0x1p-52, y = std::fabs(at.y) * 0x1p-52;
    places[i] = {{at.x - x, at.y - y}, {at.x + x, at.y + y}};
  }
  return places;
}

std::optional<std::array<LegalPlaces, 3>> PlacesOfPrimitive(const PlacedCase& c,
                                                            const Triangle& t) {
  if (!c.scene.clip_space) return LegalPlacesOf(c, t);
  const bool is_on_grid = !c.profile.snap.IsNone() || LeavesGridPointsOpen(c.profile);
  return is_on_grid ? std::nullopt : QuotientsOf(Corners(c.scene, t));
}

bool HasArea(const std::array<LegalPlaces, 3>& places) {
  const auto& [a, b, c] = places;
  return (b.low.x - a.low.x) * (c.low.y - a.low.y) != (b.low.y - a.low.y) * (c.low.x - a.low.x);
}

// sum f_i beta_i as a x + b y + c.
HalfPlane SumOfBetas(const exact::HomogeneousTriangle& v, const std::array<Rational, 3>& f) {
  HalfPlane sum{0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const exact::HomogeneousPoint& a = v[(i + 1) % 3];
    const exact::HomogeneousPoint& b = v[(i + 2) % 3];
    sum.a += f[i] * (a.y * b.w - a.w * b.y);
    sum.b += f[i] * (a.w * b.x - a.x * b.w);
    sum.c += f[i] * (a.x * b.y - a.y * b.x);
  }
  return sum;
}

// Where the channel's value is not below `bound` (sign +1), or not above it (-1).
HalfPlane WhereValueIs(const exact::HomogeneousTriangle& v, Interpolation interpolation,
                       const std::array<double, 3>& numbers, const Rational& bound, int sign) {
  const int facing = SumOfBetas(v, {v[0].w, v[1].w, v[2].w}).c.Sign();  // of D, a constant
  std::array<Rational, 3> factors;
  for (std::size_t i = 0; i < 3; ++i) {
    factors[i] = (Rational(numbers[i]) - bound) * Rational(facing * sign);
    if (interpolation == Interpolation::kLinear) factors[i] *= v[i].w;
  }
  return SumOfBetas(v, factors);
}

// The values at the pixel's corners, which those in it lie between, and the largest tolerance.
std::optional<ValueRange> RangeInPixel(const ShownValues& shown, const ValueFragment& f,
                                       const ValueOwners& owners, const Channel& channel) {
  const std::array<double, 3> numbers = NumbersAt(f, channel);
  const auto& [low, high] = std::pair(f.centroid->low, f.centroid->high);
  ValueFragment at_corner = f;
  at_corner.reach = 0;
  std::optional<ValueRange> range;
  std::optional<bool> is_negative;
  double most = std::max({std::fabs(numbers[0]), std::fabs(numbers[1]), std::fabs(numbers[2])});
  const auto corners = std::to_array<Point2>({low, {high.x, low.y}, {low.x, high.y}, high});
  for (const Point2 corner : corners) {
    const double denominator =
        EstimateValue(owners.corners.front(), channel.interpolation, numbers, corner).denominator;
    if (is_negative && *is_negative != std::signbit(denominator)) return std::nullopt;
    is_negative = std::signbit(denominator);
    at_corner.centroid->at = corner;
    const auto here = RangeOf(shown, at_corner, owners, channel, numbers);
    if (!here) return std::nullopt;
    if (!range) range = here;
    range->low = std::min(range->low, here->low);
    range->high = std::max(range->high, here->high);
    range->margin = std::max(range->margin, here->margin);
    most = std::max({most, std::fabs(range->low), std::fabs(range->high)});
  }
  for (const Point2 corner : corners) {
    at_corner.centroid->at = corner;
    const auto here = RangeOf(shown, at_corner, owners, channel, {most, most, most});
    if (!here) return std::nullopt;
    range->tolerance = std::max(range->tolerance, here->tolerance);
  }
  return range;
}

bool MeetsRegion(const ValueFragment& f, const std::vector<exact::HalfPlane>& planes) {
  const CentroidRegion& region = *f.centroid;
  std::vector<exact::HalfPlane> all = planes;
  if (region.primitive) all.insert(all.end(), region.primitive->begin(), region.primitive->end());
  return exact::RectangleMeets(region.low, region.high, all);
}

// What the value may be in a region; nothing: it is not judged.
std::optional<ValueRange> RangeInRegion(const ShownValues& shown, const ValueFragment& f,
                                        const ValueOwners& owners, const Channel& channel) {
  const auto is_in_front = [](const RayCorners& v) {
    return std::ranges::all_of(v, [](const RayCorner& corner) { return corner.w > 0; });
  };
  if (channel.interpolation == Interpolation::kInverseW) return std::nullopt;
  if (!std::ranges::all_of(owners.corners, is_in_front)) return std::nullopt;
  return RangeInPixel(shown, f, owners, channel);
}

// The points where the value may be the number that is shown.
std::vector<exact::HalfPlane> WhereItMayBe(const ValueFragment& f, const ValueOwners& owners,
                                           const Channel& channel, const ValueRange& range,
                                           double x) {
  const auto where = [&](int sign) {
    const Rational bound = Rational(x) - Rational(range.tolerance) * Rational(sign);
    return WhereValueIs(*owners.known, channel.interpolation, NumbersAt(f, channel), bound, sign);
  };
  return {where(1), where(-1)};
}

}  // namespace

CentroidRegion CentroidOf(const PlacedCase& c, const SubjectInfo& info, const Drawing& drawing,
                          const ValueFragment& f) {
  const auto places = PlacesOfPrimitive(c, f.vertices);
  const PrimitivePlanes primitive =
      places && HasArea(*places) ? PrimitiveOf(info, c.scene, *places) : nullptr;
  return RegionOf(c, primitive, f.place, CoveredInPixel(drawing, f.index));
}

ValueCheck CheckCentroidValue(const ShownValues& shown, const ValueFragment& f,
                              const ValueOwners& owners, const Channel& channel, double x) {
  if (f.centroid->at) return CheckValue(shown, f, owners, channel, NumbersAt(f, channel), x);
  ValueCheck check;
  const auto range = RangeInRegion(shown, f, owners, channel);
  if (!range) return check;
  check.is_judged = true;
  check.tells = range->high - range->low > range->tolerance;
  check.holds = !range->SurelyExcludes(x);
  check.expected = {"between ", range->low, " and ", range->high, " within ", range->tolerance};
  if (!check.holds || !owners.known) return check;
  if (MeetsRegion(f, WhereItMayBe(f, owners, channel, *range, x))) return check;
  if (!MeetsRegion(f, {})) return {};  // it is not covered by any legal model
  check.holds = false;
  check.expected = {"that of " + f.centroid->words + ", within ", range->tolerance};
  return check;
}

bool AreOfOnePoint(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  if (f.centroid->at || !owners.known) return true;
  std::vector<exact::HalfPlane> planes;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    const bool is_interpolated = channel.interpolation != Interpolation::kFlat;
    if (channel.at != EvaluatedAt::kCentroid || !is_interpolated) continue;
    const auto range = RangeInRegion(shown, f, owners, channel);
    if (!range) continue;
    const auto own = WhereItMayBe(f, owners, channel, *range, shown.Of(f, k));
    planes.insert(planes.end(), own.begin(), own.end());
  }
  return MeetsRegion(f, planes) || !MeetsRegion(f, {});
}

}  // namespace rasterproof::props
