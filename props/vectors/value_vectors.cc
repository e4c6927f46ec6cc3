#include "props/vectors/value_vectors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/channel.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/ulp.h"
#include "exact/values.h"
#include "model/snap_scene.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_channels.h"
#include "props/judging/values/value_queries.h"

namespace rasterproof::props {
namespace {

// From 1 to 8; those of the corners of a triangle mostly differ.
double DrawnW(std::size_t vertex) { return static_cast<double>(1 + 3 * vertex % 8); }

bool IsStatedInVectors(const Channel& channel, const ValueRule& rule) {
  if (channel.at == EvaluatedAt::kCentroid) return false;
  const bool is_flat = channel.interpolation == Interpolation::kFlat;
  return !is_flat || rule.provoking != ProvokingVertex::kUnstated;
}

// The least float for which `holds`, which is monotone and changes between the two numbers.
template <class Holds>
float FirstFloat(double out, double in, const Holds& holds) {
  float x = MoveByUlps(static_cast<float>(out), -1);
  for (std::int64_t step = 1; step != 0;) {
    const float next = MoveByUlps(x, step);
    const bool is_beyond = static_cast<double>(next) >= in || holds(next);
    if (!is_beyond) x = next;
    step = is_beyond ? step / 2 : 2 * step;
  }
  return MoveByUlps(x, 1);
}

// The least float that is allowed about a number. The tolerance is that of `holds` but for a share
// of 2^-30; or for a factor of two, where the number and its estimate have different ulps.
template <class Holds>
float LeastAllowed(double about, double tolerance, const Holds& holds) {
  const double slack = 0x1p-30 * (std::fabs(about) + tolerance);
  const double out = about - tolerance - slack;
  const double in = about - tolerance + slack;
  const bool is_between = !holds(MoveByUlps(static_cast<float>(out), -1)) &&
                          holds(MoveByUlps(static_cast<float>(in), 1));
  return is_between ? FirstFloat(out, in, holds) : FirstFloat(out - tolerance, about, holds);
}

template <class Holds>
std::optional<NumberVector> NumberOf(const exact::Rational& number, double tolerance,
                                     const Holds& holds) {
  const double about = number.ToDouble();
  NumberVector stated{number.ToString(), number.ToFloat(), 0, 0};
  if (!std::isfinite(stated.nearest) || !holds(stated.nearest)) return std::nullopt;
  if (!(std::fabs(about) + 4 * tolerance < LargestNumber(Precision::kFloat32))) return std::nullopt;
  stated.low = LeastAllowed(about, tolerance, holds);
  stated.high = 0 - LeastAllowed(-about, tolerance, [&](float x) { return holds(-x); });
  return stated;
}

class StatedValues {
 public:
  StatedValues(const TargetProfile& profile, TestVector& vector)
      : vector_(vector),
        placed_(SnapVertices(vector.scene, profile)),
        rule_(profile.values),
        shown_{drawing_, vector.scene.channels, rule_, Precision::kFloat32,
               profile.y_axis == YAxis::kUp} {}

  void Add(std::size_t t, std::size_t sample) {
    const ValueFragment f = FragmentAt(t, sample);
    const ValueOwners& owners = f.readings.front();
    for (std::size_t k = 0; k < vector_.scene.channels.size(); ++k) {
      const Channel& channel = vector_.scene.channels[k];
      auto value = ValueOf(f, owners, channel);
      if (!value) continue;
      ValueVector stated{t, sample, k, *std::move(value)};
      auto dx = DerivativeOf(f, owners, channel, 0);
      auto dy = DerivativeOf(f, owners, channel, 1);
      if (dx && dy) stated.derivatives = {*std::move(dx), *std::move(dy)};
      vector_.values.push_back(std::move(stated));
    }
  }

 private:
  ValueFragment FragmentAt(std::size_t t, std::size_t sample) const {
    const auto samples = static_cast<std::size_t>(vector_.pattern.samples());
    const auto width = static_cast<std::size_t>(vector_.scene.width);
    const std::size_t pixel = sample / samples;
    const auto row = static_cast<int>(pixel / width);
    ValueFragment f;
    f.triangle = static_cast<int>(t);
    f.vertices = vector_.scene.triangles[t];
    const bool is_y_up = vector_.y_axis == YAxis::kUp;
    const Point2 low{static_cast<double>(pixel % width),
                     static_cast<double>(is_y_up ? vector_.scene.height - 1 - row : row)};
    const Point2 location = vector_.pattern.locations[sample % samples];
    f.place = {static_cast<int>(pixel % width),
               row,
               static_cast<int>(sample % samples),
               {low.x + location.x, low.y + location.y}};
    f.centre = {low.x + 0.5, low.y + 0.5};
    ValueOwners owners;
    RayCorners& corners = owners.corners.emplace_back();
    std::array<Point2, 3> at{};
    std::array<double, 3> w{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(f.vertices[i]);
      at[i] = WindowPoint(placed_.vertices[v]);
      w[i] = vector_.w[v];
      corners[i] = {at[i].x * w[i], at[i].y * w[i], w[i]};
    }
    owners.known = exact::WindowTriangle(at, w);
    f.readings = {std::move(owners)};
    return f;
  }

  std::optional<NumberVector> ValueOf(const ValueFragment& f, const ValueOwners& owners,
                                      const Channel& channel) const {
    const std::array<double, 3> numbers = NumbersAt(f, channel);
    if (channel.interpolation == Interpolation::kFlat) {
      const double x = numbers[rule_.provoking == ProvokingVertex::kLast ? 2 : 0];
      const auto number = static_cast<float>(x);
      return NumberVector{exact::Rational(x).ToString(), number, number, number};
    }
    const auto range = RangeOf(shown_, f, owners, channel, numbers);
    if (!range) return std::nullopt;
    const auto value = exact::Interpolant(*owners.known, PlaceOfValue(f, channel))
                           .Value(channel.interpolation, exact::ToAttribute(numbers));
    if (!value) return std::nullopt;
    return NumberOf(*value, range->tolerance, [&](float x) {
      return CheckValue(shown_, f, owners, channel, numbers, static_cast<double>(x)).holds;
    });
  }

  std::optional<NumberVector> DerivativeOf(const ValueFragment& f, const ValueOwners& owners,
                                           const Channel& channel, int axis) const {
    if (rule_.derivatives != DerivativesBy::kAnalytic) return std::nullopt;
    if (channel.interpolation == Interpolation::kFlat) return std::nullopt;
    const Point2 p = PlaceOfValue(f, channel);
    const auto beside =
        DerivativeTolerance(shown_, f, owners.corners.front(), channel, axis, {p, p});
    const auto plane =
        exact::Interpolant(*owners.known, p)
            .Derivatives(channel.interpolation, exact::ToAttribute(NumbersAt(f, channel)));
    if (!beside || !plane) return std::nullopt;
    const exact::Rational& number = axis == 0 ? plane->dx : plane->dy;
    const ValueError error{.ulps = rule_.derivative_error.ulps, .absolute = *beside};
    const double tolerance = *beside + error.ulps * UlpOf(number.ToDouble(), Precision::kFloat32);
    return NumberOf(number, tolerance, [&](float x) {
      return exact::IsWithin(static_cast<double>(x), number, 0, error, Precision::kFloat32);
    });
  }

  TestVector& vector_;
  Scene placed_;
  ValueRule rule_;
  Drawing drawing_;
  ShownValues shown_;
};

}  // namespace

void RequireStatesValues(const Profile& profile) {
  if (HasOneModel(profile)) return;
  throw InputError("--values", "profile \"" + profile.name + "\" leaves open where vertices lie",
                   "give a profile of one model, as d3d11-canonical");
}

void StateValues(const TargetProfile& profile, TestVector& vector) {
  std::vector<Channel> channels = ChannelsFor(vector.scene, profile.values);
  std::erase_if(channels, [&](const Channel& channel) {
    return !IsStatedInVectors(channel, profile.values);
  });
  vector.scene.channels = std::move(channels);
  for (std::size_t v = 0; v < vector.scene.vertices.size(); ++v) vector.w.push_back(DrawnW(v));
  StatedValues values(profile, vector);
  for (std::size_t t = 0; t < vector.triangles.size(); ++t) {
    const std::vector<std::size_t>& covered = vector.triangles[t].must;
    const std::size_t stride = covered.size() / kMostValueSamples + 1;
    for (std::size_t k = 0; k < covered.size(); k += stride) values.Add(t, covered[k]);
  }
}

}  // namespace rasterproof::props
