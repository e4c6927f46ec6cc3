#include "props/judging/values/derivative_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/value_rule.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

// One number that the derivative may be: of the plane at a point, or a difference of two values.
struct Candidate {
  double number = 0;
  double beside_ulps = 0;  // of the tolerance
  double tolerance = 0;
  double margin = 0;
  std::array<Point2, 2> ends{};  // equal: of the plane
};

bool Lets(DerivativesBy stated, DerivativesBy by) {
  return stated == by || stated == DerivativesBy::kUnstated ||
         (stated == DerivativesBy::kCoarse && by == DerivativesBy::kFine);
}

// How far from a pixel the other one of its quad may lie.
std::vector<int> OthersOfQuad(QuadOrigin quads, double place) {
  if (quads == QuadOrigin::kUnstated) return {1, -1};
  const bool is_even = std::fmod(std::floor(place), 2) == 0;
  return {is_even == (quads == QuadOrigin::kEven) ? 1 : -1};
}

std::optional<Candidate> CandidateOf(const ShownValues& shown, const ValueFragment& f,
                                     const RayCorners& v, const Channel& channel,
                                     const std::array<Point2, 2>& ends, int axis) {
  const std::array<double, 3> a = NumbersAt(f, channel);
  const auto k = static_cast<std::size_t>(axis);
  Candidate candidate;
  candidate.ends = ends;
  double condition = 0;
  if (ends[0] == ends[1]) {
    const ValueEstimate e = EstimateValue(v, channel.interpolation, a, ends[0]);
    candidate.number = e.derivatives[k];
    condition = e.derivative_conditions[k];
  } else {
    const ValueEstimate from = EstimateValue(v, channel.interpolation, a, ends[0]);
    const ValueEstimate to = EstimateValue(v, channel.interpolation, a, ends[1]);
    // The horizon lies between.
    if (std::signbit(from.denominator) != std::signbit(to.denominator)) return std::nullopt;
    candidate.number = to.value - from.value;
    condition = from.condition + to.condition;
  }
  if (!std::isfinite(candidate.number)) return std::nullopt;
  const std::optional<double> tolerance = DerivativeTolerance(shown, f, v, channel, axis, ends);
  if (!tolerance) return std::nullopt;
  candidate.beside_ulps = *tolerance;
  candidate.tolerance =
      *tolerance + shown.rule.derivative_error.ulps * UlpOf(candidate.number, shown.precision);
  candidate.margin = kEstimateError * condition;
  return candidate;
}

std::optional<exact::Rational> ExactOf(const Candidate& candidate, const ValueFragment& f,
                                       const ValueOwners& owners, const Channel& channel,
                                       int axis) {
  const exact::Attribute a = exact::ToAttribute(NumbersAt(f, channel));
  const auto& [from, to] = candidate.ends;
  const exact::Interpolant here(*owners.known, from);
  if (from == to) {
    const auto plane = here.Derivatives(channel.interpolation, a);
    if (!plane) return std::nullopt;
    return axis == 0 ? plane->dx : plane->dy;
  }
  const auto first = here.Value(channel.interpolation, a);
  const auto last = exact::Interpolant(*owners.known, to).Value(channel.interpolation, a);
  if (!first || !last) return std::nullopt;
  return *last - *first;
}

}  // namespace

std::vector<std::array<Point2, 2>> DerivativeEnds(const ValueRule& rule, Point2 p, int axis) {
  const DerivativesBy stated = rule.derivatives;
  std::vector<std::array<Point2, 2>> ends;
  if (Lets(stated, DerivativesBy::kAnalytic)) ends.push_back({p, p});
  std::vector<int> rows{0};
  if (Lets(stated, DerivativesBy::kCoarse)) {
    for (const int across : OthersOfQuad(rule.quads, axis == 0 ? p.y : p.x)) rows.push_back(across);
  }
  if (!Lets(stated, DerivativesBy::kFine)) return ends;
  for (const int across : rows) {
    const Point2 from = Moved(p, 1 - axis, across);
    for (const int along : OthersOfQuad(rule.quads, axis == 0 ? p.x : p.y)) {
      const Point2 to = Moved(from, axis, along);
      if (along > 0) {
        ends.push_back({from, to});
      } else {
        ends.push_back({to, from});
      }
    }
  }
  return ends;
}

DerivativeCheck CheckDerivative(const ShownValues& shown, const ValueFragment& f,
                                const ValueOwners& owners, const Channel& channel, int axis,
                                double x) {
  DerivativeCheck check;
  if (!owners.known || f.reach != 0) return check;
  const RayCorners& v = owners.corners.front();
  std::vector<Candidate> candidates;
  for (const auto& ends : DerivativeEnds(shown.rule, PlaceOfValue(f, channel), axis)) {
    const auto candidate = CandidateOf(shown, f, v, channel, ends, axis);
    if (!candidate) return check;  // what it may be is not known
    candidates.push_back(*candidate);
  }
  const auto may_be = [&](double number, double sign) {
    return std::ranges::any_of(candidates, [&](const Candidate& c) {
      return std::fabs(number - c.number) <= c.tolerance + sign * c.margin;
    });
  };
  check.is_judged = true;
  const Candidate& first = candidates.front();
  check.tells = !may_be(-first.number, 1) && !may_be(2 * first.number, 1);
  const Candidate& nearest = *std::ranges::min_element(
      candidates, {}, [&](const Candidate& c) { return std::fabs(x - c.number); });
  check.nearest = nearest.number;
  check.tolerance = nearest.tolerance;
  const double off = std::fabs(x - nearest.number);
  check.ratio = nearest.tolerance > 0 ? off / nearest.tolerance : 0;
  check.expected = {first.number, " within ", first.tolerance};
  if (may_be(x, -1)) return check;
  // An estimate acquits; only the exact number convicts.
  check.holds = false;
  check.ratio = std::numeric_limits<double>::infinity();
  const ValueError beside{.ulps = shown.rule.derivative_error.ulps};
  for (const Candidate& candidate : candidates) {
    const auto number = ExactOf(candidate, f, owners, channel, axis);
    if (!number) return {};
    ValueError error = beside;
    error.absolute = candidate.beside_ulps;
    const exact::Rational allowed = exact::Allowed(*number, 0, error, shown.precision);
    const Distance distance = CompareWithExact(x, *number, allowed);
    check.holds = check.holds || distance.within;
    check.ratio = std::min(check.ratio, distance.ratio);
  }
  return check;
}

}  // namespace rasterproof::props
