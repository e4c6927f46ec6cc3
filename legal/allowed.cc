#include "legal/allowed.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/primitive_ids.h"
#include "exact/sample_frame.h"
#include "exact/square_coverage.h"
#include "legal/decided.h"
#include "legal/flat_triangle.h"
#include "legal/joint.h"
#include "legal/owners.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"

namespace rasterproof::legal {
namespace {

using exact::PlacedScene;

// Whether the triangles that do not own a sample on a shared edge may have it too.
bool AddsSharedTies(const Profile& profile) {
  return SharesTies(profile) && profile.tie_rule.IsConsistent();
}

// Whether every vertex has one place, so that counts run from a least to a most one.
bool HasPlaces(const PlacedScene& placed, const Sight& sight) {
  const Freedom& freedom = placed.profile.freedom;
  if (placed.profile.contract == Contract::kSquares || freedom.IsNone()) return true;
  if (freedom.MovesVertices() || placed.scene.clip_space) return false;
  // One triangle's free owners are its edges, by facing too; those of many depend on each other.
  const bool is_one = placed.scene.triangles.size() == 1;
  return AddsSharedTies(placed.profile) ||
         (is_one && sight.coverage == CoverageKind::kFacingCounts);
}

std::string WhyNoRange(const PlacedScene& placed) {
  const TargetProfile& profile = placed.profile;
  const bool is_stated = profile.contract == Contract::kSampleExact ||
                         profile.contract == Contract::kSquares || StatesOneSide(profile);
  if (!is_stated) return "the contract does not state single samples";
  if (profile.sample_positions != SamplePositions::kStated)
    return "the profile does not state where samples lie";
  const auto why = exact::WhyNotDecided(placed);
  return why ? why->what() : "";
}

std::uint32_t Raised(std::uint32_t count, std::uint32_t by) {
  return count > Allowed::kUnbounded - by ? Allowed::kUnbounded : count + by;
}

// As one call shows it.
CoverageCounts AsSeen(CoverageCounts counts, CoverageKind kind) {
  if (kind == CoverageKind::kFacingCounts) return counts;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const std::uint32_t count = Raised(counts.front[k], counts.back[k]);
    counts.front[k] = kind == CoverageKind::kCounts ? count : std::min(count, 1U);
    counts.back[k] = 0;
  }
  return counts;
}

// Adds the triangles without area to those that may cover a sample. Returns how many of them lie in
// a plane with the eye: nothing is stated of those.
std::uint32_t AddFlat(const PlacedScene& placed, const DrawOptions& options,
                      CoverageCounts& loose) {
  const exact::SampleFrame frame(placed.scene, placed.profile, options);
  std::uint32_t unstated = 0;
  for (const std::size_t t : placed.flat) {
    const auto v = exact::ScreenTriangle(placed.placed, placed.placed.triangles[t], frame);
    if (!v || placed.placed.clip_space) {
      ++unstated;
      continue;
    }
    ForEachSampleOnFlat({WindowPoint((*v)[0]), WindowPoint((*v)[1]), WindowPoint((*v)[2])}, frame,
                        [&](int x, int row, std::size_t s) {
                          ++loose.front[loose.Index(x, row, static_cast<int>(s))];
                        });
  }
  return unstated;
}

CoverageCounts Under(PlacedScene placed, const TieRule& rule, const DrawOptions& options) {
  placed.profile.tie_rule = rule;
  return exact::Coverage(placed, options);
}

std::uint64_t BitsShown(std::uint64_t numbers, CoverageKind kind) {
  if (kind == CoverageKind::kFacingCounts || kind == CoverageKind::kCounts) return numbers;
  return (numbers & 1U) | ((numbers & ~std::uint64_t{1}) != 0 ? 2U : 0U);
}

std::uint64_t BitShown(std::uint32_t count, CoverageKind kind) {
  const std::uint32_t most = kMostCounted;
  return BitsShown(std::uint64_t{1} << std::min(count, most), kind);
}

}  // namespace

Allowed::Allowed(const PlacedScene& placed, const Sight& sight, const DrawOptions& options)
    : sight_(sight) {
  const bool has_front = placed.profile.front_face == FrontFace::kPositiveArea;
  if (!has_front && sight.coverage == CoverageKind::kFacingCounts)
    sight_.coverage = CoverageKind::kCounts;
  if (HasPlaces(placed, sight_)) {
    why_not_ = WhyNoRange(placed);
    if (why_not_.empty()) FindRange(placed, options);
    return;
  }
  why_not_ = WhyNotJoint(placed.scene, placed.profile).value_or("");
  if (why_not_.empty()) {
    numbers_ = std::make_shared<const std::vector<std::uint64_t>>(
        DecidedSamples(placed.scene, placed.profile).counts);
  }
}

void Allowed::FindRange(const PlacedScene& placed, const DrawOptions& options) {
  const TargetProfile& profile = placed.profile;
  const auto shown = [&](CoverageCounts counts) {
    return std::make_shared<const CoverageCounts>(AsSeen(std::move(counts), sight_.coverage));
  };
  CoverageCounts loose(placed.scene.width, placed.scene.height, profile.pattern.samples());
  if (profile.contract != Contract::kSquares &&
      profile.degenerate_triangles == DegenerateTriangles::kUnspecified)
    unstated_ += AddFlat(placed, options, loose);
  for (const Triangle& t : placed.scene.triangles) {
    const auto said = FinitenessOf(Corners(placed.scene, t), placed.profile);
    unstated_ += said == Finiteness::kUnstated ? 1 : 0;
  }
  for (std::uint32_t& n : loose.front) n += unstated_;
  const bool is_loose = std::ranges::any_of(loose.front, [](std::uint32_t n) { return n != 0; });
  if (is_loose) loose_ = std::make_shared<const CoverageCounts>(std::move(loose));
  if (profile.contract == Contract::kSquares) {
    canonical_ = least_ = shown(exact::MustCover(placed, options));
    most_ = shown(exact::MayCover(placed, options));
    return;
  }
  CoverageCounts model = exact::Coverage(placed, options);
  canonical_ = least_ = most_ = shown(model);
  const bool is_free = profile.freedom.ties != TieOwnership::kStated;
  if (is_free) least_ = shown(Under(placed, {.exclusive = true}, options));
  if (is_free || AddsSharedTies(profile))
    most_ = shown(Under(placed, {.inclusive = true}, options));
  if (profile.contract == Contract::kAtMostModel)
    least_ = shown(CoverageCounts(model.width, model.height, model.samples));
  // One triangle that is culled is not drawn with a margin either.
  const bool is_culled = placed.culled.size() == placed.scene.triangles.size();
  if (profile.contract == Contract::kAtLeastModel && !is_culled) {
    std::ranges::fill(model.front, kUnbounded);
    std::ranges::fill(model.back, kUnbounded);
    most_ = shown(std::move(model));
  }
  if (sight_.ids && !is_loose && (least_ == most_ || *least_ == *most_)) {
    ids_ = std::make_shared<const std::vector<std::int32_t>>(
        exact::PrimitiveIds(placed, options, *sight_.ids));
  }
}

bool Allowed::IsAtMost(std::uint32_t front, std::uint32_t back, std::size_t k) const {
  const auto above = [](std::uint32_t count, std::uint32_t most) {
    return std::uint64_t{count > most ? count - most : 0};
  };
  return above(front, most_->front[k]) + above(back, most_->back[k]) <= Loose(k);
}

bool Allowed::Allows(const CoverageCounts& drawn, std::size_t k) const {
  const CoverageKind kind = sight_.coverage;
  if (!IsByPlaces()) return (BitsShown((*numbers_)[k], kind) & BitShown(drawn.Count(k), kind)) != 0;
  if (kind == CoverageKind::kFacingCounts) {
    return drawn.front[k] >= least_->front[k] && drawn.back[k] >= least_->back[k] &&
           IsAtMost(drawn.front[k], drawn.back[k], k);
  }
  const std::uint32_t count = drawn.Count(k);
  const std::uint32_t shown = kind == CoverageKind::kCounts ? count : std::min(count, 1U);
  return shown >= least_->front[k] && IsAtMost(shown, 0, k);
}

bool Allowed::AllowsAll(const CoverageCounts& drawn) const {
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (!Allows(drawn, k)) return false;
  }
  return true;
}

std::vector<std::size_t> Allowed::Wrong(const CoverageCounts& drawn) const {
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (!Allows(drawn, k)) wrong.push_back(k);
  }
  return wrong;
}

std::vector<std::size_t> Allowed::Wrong(const Drawing& drawn) const {
  if (ids_ == nullptr) return Wrong(drawn.counts);
  std::vector<std::size_t> wrong;
  for (std::size_t k = 0; k < ids_->size(); ++k) {
    if (drawn.primitive_ids[k] != (*ids_)[k]) wrong.push_back(k);
  }
  return wrong;
}

std::uint64_t Allowed::Apart(const Allowed& other) const {
  std::uint64_t apart = 0;
  if (!IsByPlaces()) {
    for (std::size_t k = 0; k < numbers_->size(); ++k) {
      if (((*numbers_)[k] & (*other.numbers_)[k]) == 0) ++apart;
    }
    return apart;
  }
  for (std::size_t k = 0; k < least_->size(); ++k) {
    if (!IsAtMost(other.least_->front[k], other.least_->back[k], k) ||
        !other.IsAtMost(least_->front[k], least_->back[k], k))
      ++apart;
  }
  return apart;
}

std::uint32_t Allowed::Least(std::size_t k) const {
  if (IsByPlaces()) return least_->Count(k);
  return static_cast<std::uint32_t>(std::countr_zero((*numbers_)[k]));
}

std::uint32_t Allowed::Most(std::size_t k) const {
  if (IsByPlaces()) {
    const std::uint32_t most = Raised(Raised(most_->front[k], most_->back[k]), Loose(k));
    const bool counts =
        sight_.coverage == CoverageKind::kFacingCounts || sight_.coverage == CoverageKind::kCounts;
    return counts ? most : std::min(most, 1U);
  }
  return static_cast<std::uint32_t>(63 - std::countl_zero((*numbers_)[k]));
}

std::array<std::uint32_t, 2> Allowed::NearestAt(const CoverageCounts& drawn, std::size_t k) const {
  std::uint32_t loose = Loose(k);
  const auto near = [&loose](std::uint32_t count, std::uint32_t least, std::uint32_t most) {
    const std::uint32_t above = std::min(count > most ? count - most : 0, loose);
    loose -= above;
    return std::clamp(count, least, Raised(most, above));
  };
  const std::uint32_t front = near(drawn.front[k], least_->front[k], most_->front[k]);
  return {front, near(drawn.back[k], least_->back[k], most_->back[k])};
}

CoverageCounts Allowed::Nearest(const CoverageCounts& drawn) const {
  CoverageCounts nearest = *canonical_;
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    const auto [front, back] = NearestAt(drawn, k);
    nearest.front[k] = front;
    nearest.back[k] = back;
  }
  return nearest;
}

}  // namespace rasterproof::legal
