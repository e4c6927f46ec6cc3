#include "props/judging/precondition.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/profile.h"
#include "core/scene.h"
#include "model/snap_scene.h"

namespace rasterproof::props {
namespace {

Verdict NotExercised(const char* why) { return {Outcome::kNotExercised, 0, 0, why, std::nullopt}; }

// A snapped profile divides first and snaps then: what it says of w <= 0 depends on clipping.
bool IsInFrontOfTheEye(const Scene& scene) {
  return std::ranges::all_of(scene.vertices, [](const Vertex& v) { return v.w > 0; });
}

// The product may round; a position within an ulp of the limit is not worth judging.
bool ProjectsWithinLimits(const Scene& scene, const Profile& profile) {
  return std::ranges::all_of(scene.vertices, [&](const Vertex& v) {
    const double reach = profile.coordinate_limit * v.w;
    return std::fabs(v.x) <= reach && std::fabs(v.y) <= reach;
  });
}

std::optional<Verdict> OutsideLimits(const Case& c) {
  if (!WithinLimits(c.scene, c.profile)) {
    return NotExercised("a coordinate is not finite or beyond the profile's limit");
  }
  if (c.scene.clip_space && !c.profile.snap.IsNone() && !ProjectsWithinLimits(c.scene, c.profile)) {
    return NotExercised("snapped clip space: a vertex projects beyond the profile's limit");
  }
  return std::nullopt;
}

bool LeavesAChoice(const Profile& profile, const Need& need) {
  return !profile.freedom.IsNone() || (profile.overdraw && !need.judges_overdraw);
}

std::optional<Verdict> ContractDoesNotPromise(const Profile& profile, const Need& need) {
  if (need.any_contract_suffices && profile.contract != Contract::kNone) return std::nullopt;
  switch (profile.contract) {
    case Contract::kSampleExact:
      if (!LeavesAChoice(profile, need) || need.any_model_suffices || need.watertight_suffices) {
        return std::nullopt;
      }
      return Verdict::NotApplicable(
          profile.freedom.IsNone() ? "the profile leaves it open how often an edge is drawn"
                                   : "the profile leaves the grid points or the tie rule free");
    case Contract::kWatertight:
      if (need.watertight_suffices) return std::nullopt;
      return Verdict::NotApplicable("the profile's contract promises watertight meshes only");
    case Contract::kClosed:
      if (need.closed_suffices) return std::nullopt;
      return Verdict::NotApplicable("the profile's contract promises closed surfaces only");
    case Contract::kConservativeOver:
    case Contract::kConservativeUnder:
      return Verdict::NotApplicable("the profile's contract promises a bound on coverage only");
    case Contract::kNone:
      break;
  }
  return Verdict::NotApplicable("the profile's contract promises nothing about coverage");
}

}  // namespace

std::optional<Verdict> CannotDraw(const Subject& subject, const Case& c, Space space) {
  const SubjectInfo& info = subject.Info();
  if (space == Space::kWindow && !info.takes_window) {
    return Verdict::NotApplicable("the subject takes no window-space scenes");
  }
  if (space == Space::kClip && !info.takes_clip) {
    return Verdict::NotApplicable("the subject takes no clip-space scenes");
  }
  if (space == Space::kWindow && c.scene.clip_space) {
    return NotExercised("the case is in clip space");
  }
  if (space == Space::kClip && !c.scene.clip_space) {
    return NotExercised("the case is in window space");
  }
  if ((c.options.cull != Cull::kNone && !info.takes_culling) ||
      (c.options.scissor && !info.takes_scissor)) {
    return NotExercised("the case is culled or cut, and the subject does neither");
  }
  if (c.scene.clip_space && (!PlacesClipSpace(c.profile) || c.profile.no_clip)) {
    return NotExercised("the case is in clip space, the profile speaks of window space");
  }
  if (!Takes(info, c.scene)) {
    return Verdict::NotApplicable("the subject does not take scenes of this kind or precision");
  }
  if (c.scene.clip_space && !c.profile.snap.IsNone() && !IsInFrontOfTheEye(c.scene)) {
    return NotExercised("snapped clip space: a vertex is not in front of the eye");
  }
  return std::nullopt;
}

std::optional<Verdict> CannotJudgeCoverage(const Subject& subject, const Case& c,
                                           const Need& need) {
  if (std::optional<Verdict> refusal = ContractDoesNotPromise(c.profile, need)) return refusal;
  if (std::optional<Verdict> refusal = CannotDraw(subject, c, need.space)) return refusal;
  if (std::optional<Verdict> refusal = OutsideLimits(c)) return refusal;
  if (!need.judges_clipped && !c.scene.clip_space && !IsUnclipped(c.scene, c.profile)) {
    return NotExercised("a triangle leaves the profile's no-clip rectangle");
  }
  return std::nullopt;
}

std::optional<Verdict> CannotEvaluate(const Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotDraw(subject, c, Space::kWindow)) return refusal;
  if (!IsUnwrapped(c.scene, c.profile)) return NotExercised("a coordinate wraps");
  return OutsideLimits(c);
}

}  // namespace rasterproof::props
