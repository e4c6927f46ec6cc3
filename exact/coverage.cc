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
#include "exact/placed_scene.h"
#include "exact/primitive_ids.h"
#include "exact/sample_frame.h"
#include "exact/sample_scan.h"
#include "exact/spans.h"
#include "exact/square_coverage.h"

namespace rasterproof::exact {
namespace {

std::array<Point2, 3> WindowPoints(const std::array<Vertex, 3>& v) {
  return {WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
}

bool IsCulled(int facing, Cull cull) {
  return facing == 0 || (facing > 0 && cull == Cull::kFront) || (facing < 0 && cull == Cull::kBack);
}

// Only the fast path computes where an edge crosses a row, and squares: calling it from the other
// deciders would be no second opinion.
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

// A placed scene, and where the samples of its target lie.
struct Drawable {
  const PlacedScene& scene;
  SampleFrame frame;
  Cull cull;

  Drawable(const PlacedScene& placed, const DrawOptions& options)
      : scene(placed), frame(placed.scene, placed.profile, options), cull(options.cull) {}

  // Adds one triangle: with kFast its spans, which are not summed up yet.
  void Draw(std::size_t t, Decider decider, CoverageCounts& counts, SpanTarget& target) const {
    if (frame.clip.x0 >= frame.clip.x1 || frame.clip.y0 >= frame.clip.y1) return;
    const bool clip_space = scene.placed.clip_space;
    const std::optional<std::array<Vertex, 3>> v =
        ScreenTriangle(scene.placed, scene.placed.triangles[t], frame);
    if (!v) return;
    const int facing = decider == Decider::kFast ? scene.facings[t]
                       : clip_space              ? HomogeneousFacing(*v, decider)
                                                 : Facing(WindowPoints(*v), decider);
    if (IsCulled(facing, cull)) return;
    if (decider != Decider::kFast) {
      ScanSamples(*v, clip_space, facing, frame, decider, counts);
    } else if (clip_space) {
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

std::optional<InputError> WhyNotDecided(const PlacedScene& scene) {
  const Profile& profile = scene.profile;
  if (auto error = TargetSizeError("oracle", scene.scene.width, scene.scene.height,
                                   profile.pattern.samples())) {
    return error;
  }
  if (profile.squares && scene.scene.clip_space) {
    return InputError("profile \"" + profile.name + "\"", "its squares need window space",
                      "give vertices [x, y]");
  }
  return scene.why_not_placed ? scene.why_not_placed : LocationError(profile);
}

CoverageCounts Coverage(const PlacedScene& scene, const DrawOptions& options, Decider decider) {
  if (const auto why = WhyNotDecided(scene)) throw InputError(*why);
  RequireSecondOpinion(scene.profile, decider);
  if (scene.profile.squares) return SquareCoverage(scene, options);
  const Drawable drawable(scene, options);
  CoverageCounts counts(scene.scene.width, scene.scene.height, scene.profile.pattern.samples());
  SpanTarget target(counts);
  for (std::size_t t = 0; t < scene.placed.triangles.size(); ++t) {
    drawable.Draw(t, decider, counts, target);
  }
  if (decider == Decider::kFast) target.Sum();
  return counts;
}

std::vector<std::int32_t> PrimitiveIds(const PlacedScene& scene, const DrawOptions& options,
                                       Visible order) {
  if (const auto why = WhyNotDecided(scene)) throw InputError(*why);
  const Drawable drawable(scene, options);
  CoverageCounts alone(scene.scene.width, scene.scene.height, scene.profile.pattern.samples());
  SpanTarget target(alone);
  std::vector<std::int32_t> primitive_ids(alone.size(), kNoPrimitive);
  for (std::size_t t = 0; t < scene.placed.triangles.size(); ++t) {
    drawable.Draw(t, Decider::kFast, alone, target);
    target.Take([&](std::size_t k) {
      const bool wins = order == Visible::kLastDrawn || primitive_ids[k] == kNoPrimitive;
      if (wins) primitive_ids[k] = static_cast<std::int32_t>(t);
    });
  }
  return primitive_ids;
}

}  // namespace rasterproof::exact
