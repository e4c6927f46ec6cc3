#include "props/judging/values/compared_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/value_rule.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

// Pixels to each side; fewer where each number is one of many combinations of corners.
constexpr int kReach = 8;
constexpr int kReachOfUnknown = 4;

struct Expectation {
  double expected = 0;
  double allowed = 0;
};

std::string WordsOf(NumberKind kind, const Channel& channel) {
  std::string text = "channel \"" + channel.name + "\"";
  for (const auto& [interpolation, name] : kInterpolationNames) {
    if (interpolation == channel.interpolation) text += ", " + std::string(name);
  }
  if (kind == NumberKind::kDerivativeX) return "d/dx of " + text;
  if (kind == NumberKind::kDerivativeY) return "d/dy of " + text;
  return text;
}

std::optional<Expectation> Of(const ValueRange& range) {
  const double middle = range.low + (range.high - range.low) / 2;
  return Expectation{middle, range.tolerance + (range.high - range.low) / 2};
}

// One kind of number of a drawing.
class Numbers {
 public:
  Numbers(const ShownValues& shown, const ComparedNumbers& compared, const Witness& failing)
      : shown_(shown), compared_(compared), entry_(failing.edge < 0 ? 0 : failing.edge) {
    for (std::size_t k = 0; k < shown.channels.size(); ++k) {
      if (WordsOf(compared.kind, shown.channels[k]) == compared.what) channel_ = k;
    }
  }

  double Observed(const ValueFragment& f) const {
    switch (compared_.kind) {
      case NumberKind::kDepth:
        return shown_.drawing.depths[f.index];
      case NumberKind::kScreenBarycentric:
      case NumberKind::kBarycentric:
        return shown_.drawing.barycentrics[f.index][static_cast<std::size_t>(entry_)];
      case NumberKind::kDerivativeX:
        return shown_.DerivativesOf(f, channel_)[0];
      case NumberKind::kDerivativeY:
        return shown_.DerivativesOf(f, channel_)[1];
      case NumberKind::kValue:
      case NumberKind::kHeldValue:
        return shown_.Of(f, channel_);
    }
    return 0;
  }

  std::optional<Expectation> Expected(const ValueFragment& f) const {
    const ValueOwners& owners = f.readings.front();
    switch (compared_.kind) {
      case NumberKind::kDepth:
        return Depth(f, owners);
      case NumberKind::kScreenBarycentric:
        return Barycentric(f, owners, Interpolation::kLinear);
      case NumberKind::kBarycentric:
        return Barycentric(f, owners, Interpolation::kPerspective);
      case NumberKind::kDerivativeX:
      case NumberKind::kDerivativeY:
        return Derivative(f, owners);
      case NumberKind::kValue:
      case NumberKind::kHeldValue:
        return Value(f, owners);
    }
    return std::nullopt;
  }

  // In units of what is allowed, or in ulps.
  double Off(double observed, const Expectation& e) const {
    const double off = observed - e.expected;
    const double unit = compared_.is_in_ulps ? UlpOf(e.expected, shown_.precision) : e.allowed;
    return off == 0 ? 0 : off / unit;
  }

 private:
  std::optional<Expectation> Value(const ValueFragment& f, const ValueOwners& owners) const {
    const Channel& channel = shown_.channels[channel_];
    const std::array<double, 3> a = NumbersAt(f, channel);
    if (channel.interpolation == Interpolation::kFlat)
      return Expectation{a[shown_.rule.provoking == ProvokingVertex::kLast ? 2 : 0], 0};
    if (compared_.kind == NumberKind::kHeldValue) {
      const auto [low, high] = std::minmax({a[0], a[1], a[2]});
      return Expectation{std::clamp(shown_.Of(f, channel_), low, high), 0};
    }
    const auto range = RangeOf(shown_, f, owners, channel, a);
    return range ? Of(*range) : std::nullopt;
  }

  std::optional<Expectation> Derivative(const ValueFragment& f, const ValueOwners& owners) const {
    const int axis = compared_.kind == NumberKind::kDerivativeX ? 0 : 1;
    const DerivativeCheck check =
        CheckDerivative(shown_, f, owners, shown_.channels[channel_], axis, Observed(f));
    if (!check.is_judged) return std::nullopt;
    return Expectation{check.nearest, check.tolerance};
  }

  std::optional<Expectation> Depth(const ValueFragment& f, const ValueOwners& owners) const {
    const Channel channel{"depth",
                          shown_.is_clip_space ? Interpolation::kInverseW : Interpolation::kLinear};
    const auto range = RangeOf(shown_, f, owners, channel, shown_.DepthsOf(f));
    if (!range) return std::nullopt;
    std::optional<Expectation> e = Of(*range);
    if (DepthStep(shown_.rule.depth) != 0) e->expected = std::clamp(e->expected, 0.0, 1.0);
    if (shown_.rule.depth != DepthFormat::kUnstated)
      e->allowed += DepthRoundingOf(shown_.rule, e->expected);
    return e;
  }

  std::optional<Expectation> Barycentric(const ValueFragment& f, const ValueOwners& owners,
                                         Interpolation plane) const {
    std::array<double, 3> unit{};
    unit[static_cast<std::size_t>(entry_)] = 1;
    const auto range = RangeOf(shown_, f, owners, {"barycentric", plane}, unit);
    return range ? Of(*range) : std::nullopt;
  }

  const ShownValues& shown_;
  const ComparedNumbers& compared_;
  int entry_;  // of barycentrics
  std::size_t channel_ = 0;
};

}  // namespace

void AddNumbersAround(const PlacedCase& c, const SubjectInfo& info, const ShownValues& shown,
                      Verdict& verdict) {
  if (verdict.outcome != Outcome::kViolated || !verdict.numbers || !verdict.witness) return;
  auto compared = std::make_shared<ComparedNumbers>(*verdict.numbers);
  const Witness& w = *verdict.witness;
  const Numbers numbers(shown, *compared, w);
  const CoverageCounts& counts = shown.drawing.counts;
  const std::size_t failing = counts.Index(w.x, w.y, w.sample);
  const std::vector<ValueOwners> readings = FragmentAt(c, info, shown.drawing, failing).readings;
  if (readings.empty()) return;
  const int reach = readings.front().known ? kReach : kReachOfUnknown;
  const auto add = [&](int x, int y, int sample) {
    const std::size_t index = counts.Index(x, y, sample);
    if (shown.drawing.primitive_ids[index] != w.triangle) return;
    const ValueFragment f = FragmentAt(c, info, shown.drawing, index, &readings);
    const double observed = numbers.Observed(f);
    const auto e = numbers.Expected(f);
    if (!e) return;
    compared->list.push_back(
        {x, y, sample, observed, e->expected, e->allowed, numbers.Off(observed, *e)});
  };
  add(w.x, w.y, w.sample);
  if (compared->list.empty()) return;
  for (int y = std::max(w.y - reach, 0); y < std::min(w.y + reach, counts.height); ++y) {
    for (int x = std::max(w.x - reach, 0); x < std::min(w.x + reach, counts.width); ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        if (x != w.x || y != w.y || s != w.sample) add(x, y, s);
      }
    }
  }
  verdict.numbers = std::move(compared);
}

Verdict ValueViolation(const ValueFragment& f, const Channel& channel, const std::string& what,
                       WitnessValue observed, WitnessValue expected, NumberKind kind,
                       bool to_the_bit) {
  const std::array<double, 3> a = NumbersAt(f, channel);
  Verdict verdict = Verdict::Violated(
      1,
      "the value of channel \"" + channel.name + "\" " + what + ": vertices hold " + HexText(a[0]) +
          ", " + HexText(a[1]) + ", " + HexText(a[2]) + ", the sample is at " + HexText(f.place.at),
      WitnessAt(f.triangle, -1, f.place, std::move(observed), std::move(expected)));
  verdict.numbers = std::make_shared<const ComparedNumbers>(
      ComparedNumbers{kind, WordsOf(kind, channel), to_the_bit, {}});
  return verdict;
}

Verdict NumberViolation(NumberKind kind, const std::string& what, Witness witness) {
  std::string words = "depth";
  if (kind != NumberKind::kDepth) {
    words = "barycentric of vertex " + std::to_string(witness.edge) +
            (kind == NumberKind::kBarycentric ? ", perspective" : ", linear");
  }
  Verdict verdict = Verdict::Violated(1, what, std::move(witness));
  verdict.numbers =
      std::make_shared<const ComparedNumbers>(ComparedNumbers{kind, std::move(words), false, {}});
  return verdict;
}

}  // namespace rasterproof::props
