#include "legal/alone.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "exact/placed_scene.h"
#include "legal/allowed.h"
#include "legal/joint.h"
#include "legal/owners.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "model/transform.h"

namespace rasterproof::legal {
namespace {

// Whether legal models differ, and joint.h decides what they agree on.
bool IsLegalSet(const Profile& profile) {
  return profile.contract == Contract::kSampleExact && !HasOneModel(profile);
}

// Whether the profile says what a triangle alone covers, by its places.
bool StatesSingles(const Profile& profile) {
  return profile.contract == Contract::kSquares || HasOneModel(profile) || StatesOneSide(profile);
}

// The only triangle of the scene.
TriangleDecided DecideOne(const exact::PlacedScene& placed) {
  TriangleDecided decided;
  const Allowed allowed(placed, {CoverageKind::kMask});
  decided.is_anything = allowed.Unstated() != 0;
  if (decided.is_anything) return decided;
  decided.facing = int{placed.facings.front()};
  const std::size_t samples = allowed.Canonical().size();
  for (std::size_t s = 0; s < samples; ++s) {
    if (allowed.Least(s) != 0) {
      decided.must.push_back(s);
    } else if (allowed.Most(s) != 0) {
      decided.may.push_back(s);
    }
  }
  return decided;
}

}  // namespace

std::optional<std::string> WhyNotAlone(const Scene& scene, const Profile& profile) {
  if (auto why = WhyBeyondLimits(scene, profile)) return why;
  if (profile.sample_positions != SamplePositions::kStated)
    return "the profile does not state where samples lie";
  const TargetProfile target(profile, scene);
  if (IsLegalSet(target)) return WhyNotJoint(scene, target);
  if (!StatesSingles(target)) return "the contract does not state single samples";
  const Scene seen = TakesToWindow(target, scene) ? ToWindow(scene, *target.transform) : scene;
  if (auto why = WhyBeyondLimits(seen, target)) return why;
  if (MayMoveEdgesAnyhow(seen, target)) return std::string(kClippedAnyhow);
  const auto why = exact::WhyNotDecided(exact::PlacedScene(scene, profile));
  return why ? std::optional<std::string>(why->what()) : std::nullopt;
}

std::vector<TriangleDecided> DecideAlone(const Scene& scene, const Profile& profile) {
  const TargetProfile target(profile, scene);
  if (IsLegalSet(target)) return DecidedSamples(scene, target).triangles;
  std::vector<TriangleDecided> decided;
  for (const Triangle& triangle : scene.triangles) {
    Scene alone = scene;
    alone.triangles = {triangle};
    decided.push_back(DecideOne(exact::PlacedScene(std::move(alone), profile)));
  }
  return decided;
}

}  // namespace rasterproof::legal
