#include "props/infer/model_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "model/snap.h"

namespace rasterproof::props {
namespace {

constexpr std::array<SnapRule, 5> kRules{SnapRule::kNearestEven, SnapRule::kNearestAway,
                                         SnapRule::kHalfUp, SnapRule::kFloor, SnapRule::kTruncate};

// The constants that differences are taken from: the pixel's centre, or a place of the samples.
std::vector<double> OriginsOf(const SamplePattern& pattern) {
  std::vector<double> origins{0.5};
  for (const double c : {pattern.locations.front().x, pattern.locations.front().y}) {
    if (c != 0 && std::ranges::find(origins, c) == origins.end()) origins.push_back(c);
  }
  return origins;
}

bool IsOnGrid(double x, int bits) {
  const double scaled = std::ldexp(x, bits);
  return scaled == std::floor(scaled);
}

// Every snap whose grid holds the integers, or, if `half_off`, only their neighbours half a pixel
// off. (Where c is no grid point and not 1/2, the samples' place would not be what it seems.)
std::vector<Snap> SnapsFor(const PatternCandidate& candidate) {
  std::vector<Snap> snaps;
  if (!candidate.half_off) snaps.push_back({});
  for (int bits = 0; bits <= kMaxSubpixelBits; ++bits) {
    for (const SnapRule rule : kRules) {
      if (!candidate.half_off) snaps.push_back({bits, rule});
      for (const double origin : OriginsOf(candidate.pattern)) {
        if (IsOnGrid(origin, bits) == candidate.half_off) continue;
        if (candidate.half_off && origin != 0.5) continue;
        snaps.push_back({bits, rule, SnapForm::kExactDifference, origin});
        snaps.push_back({bits, rule, SnapForm::kFloat32Difference, origin});
      }
    }
  }
  return snaps;
}

// Whether no count of a is greater than that of b.
bool IsAtMost(const CoverageCounts& a, const CoverageCounts& b) {
  return std::ranges::equal(a.front, b.front, std::less_equal<>()) &&
         std::ranges::equal(a.back, b.back, std::less_equal<>());
}

}  // namespace

TieRule RuleOf(std::uint8_t rule) {
  if (rule == kInclusiveRule) return {.inclusive = true};
  if (rule > kInclusiveRule) return {.exclusive = true};
  return kConsistentRules[rule];
}

bool MovesNothing(const Snap& snap, const Profile& profile) {
  if (snap.IsNone()) return true;
  if (!profile.fixed || snap.bits < profile.fixed->fraction_bits) return false;
  return snap.form == SnapForm::kCoordinate || IsOnGrid(snap.origin, snap.bits);
}

ModelSpace::ModelSpace(YAxis y_axis, Cull culls, std::vector<PatternCandidate> patterns,
                       const Profile& stated)
    : y_axis_(y_axis), culls_(culls), patterns_(std::move(patterns)), stated_(stated) {
  for (std::size_t l = 0; l < patterns_.size(); ++l) {
    for (const Snap& snap : SnapsFor(patterns_[l])) {
      if (!snap.IsNone() && MovesNothing(snap, stated)) continue;
      for (std::uint8_t rule = 0; rule < kRuleCount; ++rule) {
        models_.push_back({snap, rule, static_cast<std::uint8_t>(l)});
      }
    }
  }
}

Profile ModelSpace::ProfileOf(const Model& model) const {
  Profile profile = stated_;
  profile.name = "inferred";
  profile.snap = model.snap;
  profile.pattern = PatternOf(model);
  profile.y_axis = y_axis_;
  profile.culls = culls_;
  profile.tie_rule = RuleOf(model.rule);
  profile.contract = Contract::kSampleExact;
  profile.freedom = {};
  profile.by_target_size.clear();
  return profile;
}

CoverageCounts Prediction::Draw(const Scene& snapped, const Model& model, std::uint8_t rule) const {
  Profile profile;
  profile.pattern = space_.PatternOf(model);
  profile.y_axis = space_.y_axis();
  profile.culls = space_.culls();
  profile.tie_rule = RuleOf(rule);
  profile.max_primitive_extent = space_.stated().max_primitive_extent;
  CoverageCounts counts = exact::Coverage(snapped, profile);
  if (facing_ == FacingReport::kNotTold) JoinFacings(counts);
  return counts;
}

const CoverageCounts& Prediction::ByRule(Drawn& drawn, const Model& model,
                                         std::uint8_t rule) const {
  if (!drawn.known[rule]) drawn.by_rule[rule] = Draw(drawn.snapped, model, rule);
  drawn.known[rule] = true;
  return drawn.by_rule[rule];
}

Prediction::Drawn& Prediction::On(const Model& model) {
  Scene snapped = scene_;
  snapped.precision = Precision::kFloat64;
  Placed placed{{}, model.pattern};
  for (Vertex& v : snapped.vertices) {
    v.x = SnapCoordinate(v.x, model.snap);
    v.y = SnapCoordinate(v.y, model.snap);
    placed.coordinates.insert(placed.coordinates.end(), {v.x, v.y});
  }
  const auto [found, is_new] = drawn_.try_emplace(std::move(placed));
  Drawn& drawn = found->second;
  if (!is_new) return drawn;
  drawn.snapped = std::move(snapped);
  const CoverageCounts& top_left = ByRule(drawn, model, 0);
  // Rule 3 is top-left's opposite: see ModelSearch.
  drawn.has_ties =
      top_left != ByRule(drawn, model, kInclusiveRule) || top_left != ByRule(drawn, model, 3);
  drawn.is_flat = std::ranges::any_of(drawn.snapped.triangles, [&](const Triangle& t) {
    const std::array<Vertex, 3> v = Corners(drawn.snapped, t);
    return exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}) == 0;
  });
  return drawn;
}

const CoverageCounts& Prediction::Of(const Model& model) {
  Drawn& drawn = On(model);
  return ByRule(drawn, model, drawn.has_ties ? model.rule : std::uint8_t{0});
}

Prediction::Legal Prediction::LegalUnder(const Model& model) {
  Drawn& drawn = On(model);
  const Profile& stated = space_.stated();
  const CoverageCounts& least = Of(model);
  const bool edge_samples =
      stated.shares_edge_samples && drawn.has_ties && model.rule < kInclusiveRule;
  return {least, edge_samples ? ByRule(drawn, model, kInclusiveRule) : least,
          drawn.is_flat && stated.degenerate_triangles == DegenerateTriangles::kUnspecified};
}

bool Prediction::Explains(const Model& model, const CoverageCounts& seen) {
  const Legal legal = LegalUnder(model);
  return legal.is_open || (IsAtMost(legal.least, seen) && IsAtMost(seen, legal.most));
}

bool Prediction::Parts(const Model& a, const Model& b) {
  const Legal by_a = LegalUnder(a);
  const Legal by_b = LegalUnder(b);
  if (by_a.is_open || by_b.is_open) return false;
  return !IsAtMost(by_a.least, by_b.most) || !IsAtMost(by_b.least, by_a.most);
}

}  // namespace rasterproof::props
