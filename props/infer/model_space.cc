#include "props/infer/model_space.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/fill_rule.h"
#include "exact/coverage.h"

namespace rasterproof::props {
namespace {

constexpr std::array<SnapRule, 5> kRules{SnapRule::kNearestEven, SnapRule::kNearestAway,
                                         SnapRule::kHalfUp, SnapRule::kFloor, SnapRule::kTruncate};

// The constants that differences are taken from: the pixel's centre, or a place of the samples.
std::vector<double> OriginsOf(const SampleLattice& lattice) {
  std::vector<double> origins{0.5};
  for (const double c : {lattice.locations.front().x, lattice.locations.front().y}) {
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
std::vector<Snap> SnapsFor(const LatticeCandidate& candidate) {
  std::vector<Snap> snaps;
  if (!candidate.half_off) snaps.push_back({});
  for (int bits = 0; bits <= kMaxSubpixelBits; ++bits) {
    for (const SnapRule rule : kRules) {
      if (!candidate.half_off) snaps.push_back({bits, rule});
      for (const double origin : OriginsOf(candidate.lattice)) {
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

FillRule RuleOf(std::uint8_t rule) {
  return rule == kInclusiveRule ? FillRule{.inclusive = true} : kConsistentRules[rule];
}

ModelSpace::ModelSpace(YAxis y_axis, std::vector<LatticeCandidate> lattices)
    : y_axis_(y_axis), lattices_(std::move(lattices)) {
  for (std::size_t l = 0; l < lattices_.size(); ++l) {
    for (const Snap& snap : SnapsFor(lattices_[l])) {
      for (std::uint8_t rule = 0; rule <= kInclusiveRule; ++rule) {
        models_.push_back({snap, rule, static_cast<std::uint8_t>(l)});
      }
    }
  }
}

Profile ModelSpace::ProfileOf(const Model& model) const {
  Profile profile;
  profile.name = "inferred";
  profile.snap = model.snap;
  profile.lattice = LatticeOf(model);
  profile.y_axis = y_axis_;
  profile.fill_rule = RuleOf(model.rule);
  return profile;
}

CoverageCounts Prediction::Draw(const Scene& snapped, const Model& model, std::uint8_t rule) const {
  Profile profile;
  profile.lattice = space_.LatticeOf(model);
  profile.y_axis = space_.y_axis();
  profile.fill_rule = RuleOf(rule);
  CoverageCounts counts = exact::Coverage(snapped, profile);
  if (facing_ == FacingReport::kNotTold) JoinFacings(counts);
  return counts;
}

const CoverageCounts& Prediction::Of(const Model& model) {
  Scene snapped = scene_;
  snapped.precision = Precision::kFloat64;
  Place place{{}, model.lattice};
  for (Vertex& v : snapped.vertices) {
    v.x = SnapCoordinate(v.x, model.snap);
    v.y = SnapCoordinate(v.y, model.snap);
    place.coordinates.insert(place.coordinates.end(), {v.x, v.y});
  }
  const auto [found, is_new] = drawn_.try_emplace(std::move(place));
  Drawn& drawn = found->second;
  const auto counts = [&](std::uint8_t rule) -> const CoverageCounts& {
    if (!drawn.known[rule]) drawn.by_rule[rule] = Draw(snapped, model, rule);
    drawn.known[rule] = true;
    return drawn.by_rule[rule];
  };
  // Rule 3 is top-left's opposite: see ModelSearch.
  if (is_new) drawn.has_ties = counts(0) != counts(kInclusiveRule) || counts(0) != counts(3);
  return counts(drawn.has_ties ? model.rule : std::uint8_t{0});
}

}  // namespace rasterproof::props
