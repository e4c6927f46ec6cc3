#include "kit/oracle/decisions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/placed_scene.h"
#include "exact/square_coverage.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "model/target_profile.h"
#include "model/transform.h"

namespace rasterproof::kit {
namespace {

// How samples are decided.
enum class Way : std::uint8_t {
  kLegalSet,  // by the legal models of points
  kSquares,   // by the bounds of whole pixels
  kOneModel,  // by the canonical model alone
  kAtLeast,   // that model's samples, and perhaps more
  kAtMost     // that model's samples, or fewer
};

std::optional<Way> WayFor(const Scene& scene, const TargetProfile& profile) {
  if (profile.contract == Contract::kSquares) return Way::kSquares;
  if (profile.contract == Contract::kSampleExact && !legal::WhyNotJoint(scene, profile))
    return Way::kLegalSet;
  if (!profile.freedom.IsNone() || profile.shares_edge_samples || profile.guard_band)
    return std::nullopt;
  switch (profile.contract) {
    case Contract::kSampleExact:
      return Way::kOneModel;
    case Contract::kAtLeastModel:
      return Way::kAtLeast;
    case Contract::kAtMostModel:
      return Way::kAtMost;
    case Contract::kWatertight:
    case Contract::kClosed:
    case Contract::kSquares:
    case Contract::kNone:
      break;
  }
  return std::nullopt;
}

// Whether the profile states nothing of a triangle: what it may cover is not limited.
bool IsUnstated(const exact::PlacedScene& placed) {
  const Profile& profile = placed.profile;
  const Scene& scene = placed.scene;
  const auto any = [&](auto predicate) {
    const auto corners = Corners(scene, scene.triangles.front());
    return std::ranges::any_of(corners, predicate);
  };
  const bool is_nan =
      any([](const Vertex& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.w); });
  if (is_nan) return profile.nan_vertex == NanVertex::kUnspecified;
  if (any([](const Vertex& v) { return !IsFinite(v); }))
    return profile.infinite_vertex == InfiniteVertex::kUnspecified;
  if (profile.nan_z == NanZ::kUnspecified && any([](const Vertex& v) { return std::isnan(v.z); }))
    return true;
  return profile.degenerate_triangles == DegenerateTriangles::kUnspecified && !placed.flat.empty();
}

bool HasNanZThatDrawsNothing(const exact::PlacedScene& placed) {
  const auto corners = Corners(placed.scene, placed.scene.triangles.front());
  return placed.profile.nan_z == NanZ::kNothing &&
         std::ranges::any_of(corners, [](const Vertex& v) { return std::isnan(v.z); });
}

Scene Alone(const Scene& scene, const Triangle& triangle) {
  Scene alone = scene;
  alone.triangles = {triangle};
  return alone;
}

void SetSamples(std::span<Decision> decisions, const std::vector<std::size_t>& samples,
                Decision to) {
  for (const std::size_t s : samples) decisions[s] = to;
}

// Of the triangle that is the scene's only one, by bounds of its counts.
void Bound(const CoverageCounts& least, const CoverageCounts& most, std::span<Decision> decisions) {
  for (std::size_t s = 0; s < decisions.size(); ++s) {
    if (least.Count(s) != 0) {
      decisions[s] = Decision::kMust;
    } else if (most.Count(s) != 0) {
      decisions[s] = Decision::kMay;
    }
  }
}

void DecideAlone(const exact::PlacedScene& placed, Way way, std::span<Decision> decisions) {
  const bool draws_nothing = HasNanZThatDrawsNothing(placed);
  if (!draws_nothing && IsUnstated(placed)) {
    std::ranges::fill(decisions, Decision::kMay);
    return;
  }
  if (way == Way::kSquares) {
    Bound(exact::MustCover(placed), exact::MayCover(placed), decisions);
    return;
  }
  const CoverageCounts model = draws_nothing
                                   ? CoverageCounts(placed.scene.width, placed.scene.height,
                                                    placed.profile.pattern.samples())
                                   : exact::Coverage(placed);
  const Decision in = way == Way::kAtMost ? Decision::kMay : Decision::kMust;
  const Decision out = way == Way::kAtLeast ? Decision::kMay : Decision::kMustNot;
  for (std::size_t s = 0; s < decisions.size(); ++s) decisions[s] = model.Count(s) != 0 ? in : out;
}

}  // namespace

std::optional<std::string> WhyNoDecisions(const Scene& scene, const Profile& profile) {
  if (profile.sample_positions != SamplePositions::kStated)
    return "the profile leaves the places of samples open";
  if (!CanBeGiven(scene, profile))
    return "the profile's fixed-point input does not take a coordinate of the scene";
  const TargetProfile target(profile, scene);
  const std::optional<Way> way = WayFor(scene, target);
  if (!way) {
    const auto why = legal::WhyNotJoint(scene, target);
    return why ? *why : "the profile does not state single samples";
  }
  if (*way == Way::kLegalSet) return std::nullopt;
  const auto is_beyond = [&](const Vertex& v) {
    return IsFinite(v) && std::max(std::fabs(v.x), std::fabs(v.y)) > profile.coordinate_limit;
  };
  const Scene seen = TakesToWindow(profile, scene) ? ToWindow(scene, *profile.transform) : scene;
  if (std::ranges::any_of(scene.vertices, is_beyond) ||
      std::ranges::any_of(seen.vertices, is_beyond)) {
    return "a coordinate lies beyond the profile's coordinate_limit";
  }
  if (*way == Way::kSquares && scene.clip_space)
    return "the contract states whole pixels of window space, and the scene is in clip space";
  const auto why = exact::WhyNotDecided(exact::PlacedScene(scene, profile));
  return why ? std::optional<std::string>(why->what()) : std::nullopt;
}

std::vector<Decision> DecisionsOf(const Scene& scene, const Profile& profile) {
  const TargetProfile target(profile, scene);
  const Way way = WayFor(scene, target).value();
  const std::size_t samples =
      CoverageCounts::Size(scene.width, scene.height, target.pattern.samples());
  std::vector<Decision> decisions(scene.triangles.size() * samples, Decision::kMustNot);
  const auto of = [&](std::size_t t) { return std::span(decisions).subspan(t * samples, samples); };
  if (way != Way::kLegalSet) {
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      DecideAlone(exact::PlacedScene(Alone(scene, scene.triangles[t]), profile), way, of(t));
    }
    return decisions;
  }
  const legal::Decided decided = legal::DecidedSamples(scene, target);
  for (std::size_t t = 0; t < decided.triangles.size(); ++t) {
    const legal::TriangleDecided& triangle = decided.triangles[t];
    if (triangle.is_anything) {
      std::ranges::fill(of(t), Decision::kMay);
    } else {
      SetSamples(of(t), triangle.must, Decision::kMust);
      SetSamples(of(t), triangle.may, Decision::kMay);
    }
  }
  return decisions;
}

}  // namespace rasterproof::kit
