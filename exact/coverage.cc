#include "exact/coverage.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/target_size.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "exact/primitive_ids.h"
#include "exact/sample_frame.h"
#include "exact/sample_scan.h"
#include "exact/snap_clip.h"
#include "exact/spans.h"
#include "exact/square_coverage.h"
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

// Where an edge crosses a row is worked out by the fast path alone, and so are squares: a second
// opinion that is the first one's would be none.
void RequireSecondOpinion(const Profile& profile, Decider decider) {
  const bool squares = profile.squares.has_value();
  if (decider == Decider::kFast || (profile.scanline_rounding.IsNone() && !squares)) return;
  throw InputError("profile \"" + profile.name + "\"",
                   std::string(squares ? "its squares" : "its rounded crossings") +
                       " are decided by the fast path alone, not by " +
                       std::string(DeciderName(decider)),
                   std::string("use the fast path (the subject exact), or a profile without ") +
                       (squares ? "coverage" : "scanline_rounding"));
}

// A scene on the grid, and where its samples lie.
struct Drawable {
  Scene scene;
  SampleFrame frame;
  Cull cull;

  Drawable(const Scene& given, const Profile& profile, const DrawOptions& options)
      : scene(PlacedScene(given, profile)), frame(given, profile, options), cull(options.cull) {}

  // Adds one triangle: with kFast its spans, which are not summed up yet.
  void Draw(const Triangle& t, Decider decider, CoverageCounts& counts, SpanTarget& target) const {
    if (frame.clip.x0 >= frame.clip.x1 || frame.clip.y0 >= frame.clip.y1) return;
    const std::optional<std::array<Vertex, 3>> v = ScreenTriangle(scene, t, frame);
    if (!v) return;
    const int facing =
        scene.clip_space ? HomogeneousFacing(*v, decider) : Facing(WindowPoints(*v), decider);
    if (IsCulled(facing, cull)) return;
    if (decider != Decider::kFast) {
      ScanSamples(*v, scene.clip_space, facing, frame, decider, counts);
    } else if (scene.clip_space) {
      AddHomogeneousSpans(*v, facing, frame, target);
    } else {
      AddWindowSpans(WindowPoints(*v), facing, frame, target);
    }
  }
};

}  // namespace

int Facing(const std::array<Point2, 3>& v, Decider decider) {
  return EdgeSign(v[0], v[1], v[2], decider);
}

bool Covers(const std::array<Point2, 3>& v, Point2 p, const TieRule& rule, Decider decider) {
  const int facing = Facing(v, decider);
  if (facing == 0) return false;
  for (unsigned k = 0; k < 3; ++k) {
    const int side = facing * ShiftedEdgeSign(v[k], v[(k + 1) % 3], p, rule, decider);
    if (side < 0 || (side == 0 && !rule.inclusive)) return false;
  }
  return true;
}

std::optional<InputError> WhyNotDecided(const Scene& scene, const Profile& profile) {
  const int samples = profile.pattern.samples();
  if (auto error = TargetSizeError("oracle", scene.width, scene.height, samples)) return error;
  if (profile.squares && scene.clip_space) {
    return InputError("profile \"" + profile.name + "\"", "its squares are of window space",
                      "give vertices [x, y]");
  }
  if (IsHomogeneous(scene, profile) && !PlacesClipSpace(profile)) {
    return InputError(
        "profile \"" + profile.name + "\"",
        "its fixed-point input, largest extent or rounded crossings are of window space",
        "give vertices [x, y]");
  }
  if (IsHomogeneous(scene, profile) && SnapsOn(scene, profile)) {
    if (auto error = SnapClipError(scene, profile)) return error;
  }
  const bool is_one_model = profile.by_target_size.empty();
  return LocationError(is_one_model ? profile : ForTarget(profile, scene.width, scene.height));
}

CoverageCounts Coverage(const Scene& scene, const Profile& profile, const DrawOptions& options,
                        Decider decider) {
  if (const auto why = WhyNotDecided(scene, profile)) throw InputError(*why);
  RequireSecondOpinion(profile, decider);
  if (profile.squares) return SquareCoverage(scene, profile, options);
  const Drawable drawable(scene, profile, options);
  CoverageCounts counts(scene.width, scene.height, profile.pattern.samples());
  SpanTarget target(counts);
  for (const Triangle& t : drawable.scene.triangles) {
    drawable.Draw(t, decider, counts, target);
  }
  if (decider == Decider::kFast) target.Sum();
  return counts;
}

std::vector<std::int32_t> PrimitiveIds(const Scene& scene, const Profile& profile,
                                       const DrawOptions& options, Visible order) {
  if (const auto why = WhyNotDecided(scene, profile)) throw InputError(*why);
  const Drawable drawable(scene, profile, options);
  CoverageCounts alone(scene.width, scene.height, profile.pattern.samples());
  SpanTarget target(alone);
  std::vector<std::int32_t> primitive_ids(alone.size(), kNoPrimitive);
  for (std::size_t t = 0; t < drawable.scene.triangles.size(); ++t) {
    drawable.Draw(drawable.scene.triangles[t], Decider::kFast, alone, target);
    target.Take([&](std::size_t k) {
      const bool wins = order == Visible::kLastDrawn || primitive_ids[k] == kNoPrimitive;
      if (wins) primitive_ids[k] = static_cast<std::int32_t>(t);
    });
  }
  return primitive_ids;
}

}  // namespace rasterproof::exact
