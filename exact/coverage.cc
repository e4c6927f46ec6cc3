#include "exact/coverage.h"

#include <array>
#include <optional>
#include <string>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/target_size.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "exact/sample_frame.h"
#include "exact/sample_scan.h"
#include "exact/snap_clip.h"
#include "exact/spans.h"
#include "model/snap_scene.h"
#include "model/target_model.h"

namespace rasterproof::exact {
namespace {

std::array<Point2, 3> WindowPoints(const std::array<Vertex, 3>& v) {
  return {WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
}

bool IsCulled(int facing, Cull cull) {
  return facing == 0 || (facing > 0 && cull == Cull::kFront) || (facing < 0 && cull == Cull::kBack);
}

bool SnapsOn(const Scene& target, const Profile& profile) {
  return !ForTarget(profile, target.width, target.height).snap.IsNone();
}

Scene PlacedScene(const Scene& scene, const Profile& profile) {
  if (!IsHomogeneous(scene, profile)) return SnapScene(scene, profile);
  return SnapsOn(scene, profile) ? SnapClipScene(scene, profile) : scene;
}

// Where an edge crosses a row is worked out by the fast path alone: a second opinion that is the
// first one's would be none.
void RequireSecondOpinion(const Profile& profile, Decider decider) {
  if (decider == Decider::kFast || profile.crossing.IsNone()) return;
  throw InputError("profile \"" + profile.name + "\"",
                   "its rounded crossings are decided by the fast path alone, not by " +
                       std::string(DeciderName(decider)),
                   "use the fast path (the subject exact), or a profile without crossing");
}

}  // namespace

int Facing(const std::array<Point2, 3>& v, Decider decider) {
  return EdgeSign(v[0], v[1], v[2], decider);
}

bool Covers(const std::array<Point2, 3>& v, Point2 p, const FillRule& rule, Decider decider) {
  const int facing = Facing(v, decider);
  if (facing == 0) return false;
  for (unsigned k = 0; k < 3; ++k) {
    const int side = facing * ShiftedEdgeSign(v[k], v[(k + 1) % 3], p, rule, decider);
    if (side < 0 || (side == 0 && !rule.inclusive)) return false;
  }
  return true;
}

std::optional<InputError> WhyNotDecided(const Scene& scene, const Profile& profile) {
  const int samples = profile.lattice.samples();
  if (auto error = TargetSizeError("oracle", scene.width, scene.height, samples)) return error;
  if (IsHomogeneous(scene, profile) && !PlacesClipSpace(profile)) {
    return InputError(
        "profile \"" + profile.name + "\"",
        "its fixed-point input, largest extent or rounded crossings are of window space",
        "give vertices [x, y]");
  }
  if (IsHomogeneous(scene, profile) && SnapsOn(scene, profile)) {
    if (auto error = SnapClipError(scene, profile)) return error;
  }
  const bool is_one_model = profile.targets.empty();
  return LocationError(is_one_model ? profile : ForTarget(profile, scene.width, scene.height));
}

CoverageCounts Coverage(const Scene& scene, const Profile& profile, const DrawOptions& options,
                        Decider decider) {
  if (const auto why = WhyNotDecided(scene, profile)) throw InputError(*why);
  RequireSecondOpinion(profile, decider);
  const Scene snapped = PlacedScene(scene, profile);
  const SampleFrame frame(scene, profile, options);
  CoverageCounts counts(scene.width, scene.height, profile.lattice.samples());
  SpanTarget target(counts);
  if (frame.clip.x0 >= frame.clip.x1 || frame.clip.y0 >= frame.clip.y1) return counts;
  for (const Triangle& t : snapped.triangles) {
    const std::optional<std::array<Vertex, 3>> v = ScreenTriangle(snapped, t, frame);
    if (!v) continue;
    const int facing =
        snapped.clip_space ? HomogeneousFacing(*v, decider) : Facing(WindowPoints(*v), decider);
    if (IsCulled(facing, options.cull)) continue;
    if (decider != Decider::kFast) {
      ScanSamples(*v, snapped.clip_space, facing, frame, decider, counts);
    } else if (snapped.clip_space) {
      AddHomogeneousSpans(*v, facing, frame, target);
    } else {
      AddWindowSpans(WindowPoints(*v), facing, frame, target);
    }
  }
  if (decider == Decider::kFast) target.Sum();
  return counts;
}

}  // namespace rasterproof::exact
