// A covered sample holds numbers: neither NaN nor infinities, where what it should hold is one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_estimates.h"
#include "props/judging/values/value_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace covered_samples_hold_numbers {

constexpr Outputs kAllButCentroids{.primitive_ids = true,
                                   .barycentrics = true,
                                   .depths = true,
                                   .centroids = false,
                                   .values = true};
// As for the usual error: products of the usual forms then stay in float32.
constexpr double kUsualW = 0x1p30;

struct Question {
  Interpolation interpolation;
  std::array<double, 3> numbers;
  Point2 p;
};

bool IsUsual(const RayCorner& corner) { return corner.w >= 1 / kUsualW && corner.w <= kUsualW; }

// Whether the exact number is one of the format, and the products that it is made of are, too. It
// need not be known to any bit: a sliver's value exists like any other.
bool IsOfTheFormat(const ShownValues& shown, const ValueOwners& owners, const Question& q) {
  const double most = shown.precision == Precision::kFloat32 ? 0x1p126 : 0x1p1022;
  std::optional<bool> is_negative;
  for (const RayCorners& v : owners.corners) {
    if (!std::ranges::all_of(v, IsUsual)) return false;
    const ValueEstimate e = EstimateValue(v, q.interpolation, q.numbers, q.p);
    if (!(e.condition * std::max(std::fabs(e.denominator), 1.0) < most)) return false;
    if (!(std::fabs(e.value) < most)) return false;
    if (!owners.known && !(kEstimateError * e.denominator_condition < 0.5)) return false;
    if (is_negative && *is_negative != std::signbit(e.denominator)) return false;
    is_negative = std::signbit(e.denominator);
  }
  if (!owners.known) return true;
  const auto value =
      exact::Interpolant(*owners.known, q.p).Value(q.interpolation, exact::ToAttribute(q.numbers));
  return value && value->Abs() <= exact::Rational(LargestNumber(shown.precision));
}

bool AreNumbers(const std::array<double, 3>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return std::isfinite(x); });
}

Verdict NoNumber(const ValueFragment& f, const char* what, double x) {
  return Verdict::Violated(1, std::string(what) + " of a covered sample is no number",
                           WitnessAt(f.triangle, -1, f.place, {x}, {"a number"}));
}

// Barycentrics and depth of the sample, beside its values.
std::optional<Verdict> OfFragment(const ShownValues& shown, const ValueFragment& f,
                                  const ValueOwners& owners) {
  const std::array<double, 3> ones{1, 1, 1};
  const auto exists = [&](Interpolation interpolation, const std::array<double, 3>& numbers) {
    return IsOfTheFormat(shown, owners, {interpolation, numbers, f.place.at});
  };
  if (f.index < shown.drawing.barycentrics.size() && exists(Interpolation::kLinear, ones) &&
      exists(Interpolation::kPerspective, ones)) {
    for (const double x : shown.drawing.barycentrics[f.index])
      if (!std::isfinite(x)) return NoNumber(f, "a barycentric", x);
  }
  const std::array<double, 3> z = shown.DepthsOf(f);
  const Interpolation of_z =
      shown.is_clip_space ? Interpolation::kInverseW : Interpolation::kLinear;
  if (f.index < shown.drawing.depths.size() && AreNumbers(z) && exists(of_z, z)) {
    const double x = shown.drawing.depths[f.index];
    if (!std::isfinite(x)) return NoNumber(f, "the depth", x);
  }
  return std::nullopt;
}

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  if (std::optional<Verdict> violated = OfFragment(shown, f, owners)) return *std::move(violated);
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (channel.at == EvaluatedAt::kCentroid) continue;
    const std::array<double, 3> numbers = NumbersAt(f, channel);
    const bool is_flat = channel.interpolation == Interpolation::kFlat;
    if (!AreNumbers(numbers)) continue;
    const Question q{channel.interpolation, numbers, PlaceOfValue(f, channel)};
    if (!is_flat && !IsOfTheFormat(shown, owners, q)) continue;
    ++exercised;
    const double x = shown.Of(f, k);
    if (!std::isfinite(x)) return ValueViolation(f, channel, "is no number", {x}, {"a number"});
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kAllButCentroids, Judge);
}

}  // namespace covered_samples_hold_numbers

extern constinit const Property kCoveredSamplesHoldNumbers{
    .name = "CoveredSamplesHoldNumbers",
    .group = "values",
    .clause =
        "What is interpolated at a covered sample is a quotient of finite sums, and its "
        "denominator "
        "is not zero.",
    .tolerance = kExact,
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, {},
                   "area not zero; every w is 2^-30 to 2^30, and no product leaves the format"),
    .ask = covered_samples_hold_numbers::Ask,
};

}  // namespace rasterproof::props
