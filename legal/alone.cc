#include "legal/alone.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/placed_scene.h"
#include "exact/square_coverage.h"
#include "legal/joint.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "model/transform.h"

namespace rasterproof::legal {
namespace {

// By what the samples of a triangle are decided.
enum class Way : std::uint8_t {
  kOneModel,   // the canonical model
  kLegalSet,   // all legal models
  kSquares,    // bounds of whole pixels
  kAtLeast,    // the canonical model's samples, and perhaps more
  kAtMost,     // those, or fewer
  kNotDecided  // nothing is stated of single samples
};

Way WayFor(const Profile& profile) {
  if (profile.contract == Contract::kSquares) return Way::kSquares;
  if (HasOneModel(profile)) return Way::kOneModel;
  if (profile.contract == Contract::kSampleExact) return Way::kLegalSet;
  if (!profile.freedom.IsNone() || profile.shares_edge_samples) return Way::kNotDecided;
  if (profile.contract == Contract::kAtLeastModel) return Way::kAtLeast;
  return profile.contract == Contract::kAtMostModel ? Way::kAtMost : Way::kNotDecided;
}

bool IsBeyond(const Scene& scene, double limit) {
  return std::ranges::any_of(scene.vertices, [&](const Vertex& v) {
    return IsFinite(v) && std::max(std::fabs(v.x), std::fabs(v.y)) > limit;
  });
}

// Whether the profile states nothing of the scene's only triangle: it may cover anything.
bool IsUnstated(const exact::PlacedScene& placed) {
  const Profile& profile = placed.profile;
  const auto corners = Corners(placed.scene, placed.scene.triangles.front());
  const auto any = [&](auto is) { return std::ranges::any_of(corners, is); };
  const bool has_nan_z = any([](const Vertex& v) { return std::isnan(v.z); });
  if (has_nan_z && profile.nan_z == NanZ::kNothing) return false;  // it covers nothing
  if (any([](const Vertex& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.w); }))
    return profile.nan_vertex == NanVertex::kUnspecified;
  if (!std::ranges::all_of(corners, IsFinite))
    return profile.infinite_vertex == InfiniteVertex::kUnspecified;
  if (has_nan_z && profile.nan_z == NanZ::kUnspecified) return true;
  return profile.degenerate_triangles == DegenerateTriangles::kUnspecified && !placed.flat.empty();
}

// Samples that `least` has, and those that only `most` has.
void SetBounds(const CoverageCounts& least, const CoverageCounts& most, TriangleDecided& decided) {
  for (std::size_t s = 0; s < least.size(); ++s) {
    if (least.Count(s) != 0) {
      decided.must.push_back(s);
    } else if (most.Count(s) != 0) {
      decided.may.push_back(s);
    }
  }
}

// The only triangle of the scene.
TriangleDecided DecideOne(const exact::PlacedScene& placed, Way way) {
  TriangleDecided decided;
  decided.is_anything = IsUnstated(placed);
  if (decided.is_anything) return decided;
  decided.facing = placed.facings.front();
  if (way == Way::kSquares) {
    SetBounds(exact::MustCover(placed), exact::MayCover(placed), decided);
    return decided;
  }
  const CoverageCounts model = exact::Coverage(placed);
  CoverageCounts least = model;
  CoverageCounts most = model;
  if (way == Way::kAtMost) std::ranges::fill(least.front, 0);
  if (way == Way::kAtMost) std::ranges::fill(least.back, 0);
  if (way == Way::kAtLeast && placed.culled.empty()) std::ranges::fill(most.front, 1);
  SetBounds(least, most, decided);
  return decided;
}

}  // namespace

std::optional<std::string> WhyNotAlone(const Scene& scene, const Profile& profile) {
  if (!CanBeGiven(scene, profile))
    return "the profile's fixed-point input does not take a coordinate of the scene";
  if (profile.sample_positions != SamplePositions::kStated)
    return "the profile leaves the places of samples open";
  const TargetProfile target(profile, scene);
  const Way way = WayFor(target);
  if (way == Way::kNotDecided) return "the contract does not state single samples";
  if (way == Way::kLegalSet) return WhyNotJoint(scene, target);
  const Scene seen = TakesToWindow(target, scene) ? ToWindow(scene, *target.transform) : scene;
  if (IsBeyond(scene, target.coordinate_limit) || IsBeyond(seen, target.coordinate_limit))
    return "a coordinate lies beyond the profile's coordinate_limit";
  if (MayMoveEdgesAnyhow(seen, target)) return std::string(kClippedAnyhow);
  const auto why = exact::WhyNotDecided(exact::PlacedScene(scene, profile));
  return why ? std::optional<std::string>(why->what()) : std::nullopt;
}

std::vector<TriangleDecided> DecideAlone(const Scene& scene, const Profile& profile) {
  const TargetProfile target(profile, scene);
  const Way way = WayFor(target);
  if (way == Way::kLegalSet) return DecidedSamples(scene, target).triangles;
  std::vector<TriangleDecided> decided;
  for (const Triangle& triangle : scene.triangles) {
    Scene alone = scene;
    alone.triangles = {triangle};
    decided.push_back(DecideOne(exact::PlacedScene(std::move(alone), profile), way));
  }
  return decided;
}

}  // namespace rasterproof::legal
