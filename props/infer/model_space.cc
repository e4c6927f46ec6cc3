#include "props/infer/model_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "core/tie_rule.h"
#include "exact/placed_scene.h"
#include "legal/allowed.h"
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

legal::Allowed Prediction::AllowedBy(const Scene& snapped, const Model& model,
                                     std::uint8_t rule) const {
  const Profile& stated = space_.stated();
  Profile profile;
  profile.pattern = space_.PatternOf(model);
  profile.y_axis = space_.y_axis();
  profile.culls = space_.culls();
  profile.tie_rule = RuleOf(rule);
  profile.max_primitive_extent = stated.max_primitive_extent;
  profile.shares_edge_samples = stated.shares_edge_samples;
  profile.degenerate_triangles = stated.degenerate_triangles;
  const bool told = facing_ != FacingReport::kNotTold;
  return legal::Allowed(exact::PlacedScene(snapped, profile),
                        {told ? CoverageKind::kFacingCounts : CoverageKind::kCounts});
}

const legal::Allowed& Prediction::ByRule(Drawn& drawn, const Model& model,
                                         std::uint8_t rule) const {
  std::optional<legal::Allowed>& allowed = drawn.by_rule[rule];
  if (!allowed) allowed = AllowedBy(drawn.snapped, model, rule);
  return *allowed;
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
  const auto drawn_by = [&](std::uint8_t rule) -> const CoverageCounts& {
    return ByRule(drawn, model, rule).Canonical();
  };
  // Rule 3 is top-left's opposite: see ModelSearch.
  drawn.has_ties = drawn_by(0) != drawn_by(kInclusiveRule) || drawn_by(0) != drawn_by(3);
  return drawn;
}

const legal::Allowed& Prediction::Under(const Model& model) {
  Drawn& drawn = On(model);
  return ByRule(drawn, model, drawn.has_ties ? model.rule : std::uint8_t{0});
}

bool Prediction::Explains(const Model& model, const CoverageCounts& seen) {
  return Under(model).AllowsAll(seen);
}

bool Prediction::Parts(const Model& a, const Model& b) { return Under(a).Apart(Under(b)) != 0; }

}  // namespace rasterproof::props
