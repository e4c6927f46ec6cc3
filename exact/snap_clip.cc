#include "exact/snap_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "exact/coverage.h"
#include "exact/signs.h"
#include "model/snap.h"
#include "model/target_profile.h"

namespace rasterproof::exact {
namespace {

// Grid steps beyond which the halves and quarters below would no longer be doubles.
constexpr double kMostSteps = 0x1p50;

bool HasGridPoint(double x, double w, const Snap& snap) {
  return std::fabs(std::ldexp(x / w, snap.bits)) < kMostSteps;
}

InputError QuotientError() {
  return {"vertex", "its snapped position x / w does not fit 51 bits",
          "clip the scene, or use a profile without snapping"};
}

bool IsDrawn(const std::array<Vertex, 3>& v) { return std::ranges::all_of(v, IsFinite); }

}  // namespace

double SnapQuotient(double x, double w, const Snap& snap) {
  if (!(w > 0)) {
    throw InputError("vertex", "with w <= 0 it has no position to snap",
                     "clip the scene in front of the eye");
  }
  const double steps = std::ldexp(x / w, snap.bits);
  if (!HasGridPoint(x, w, snap)) throw QuotientError();
  // Every rule changes its answer only at multiples of half a step. The quotient is off by at most
  // 2^-53 of itself: if no such multiple is that near, the truth lies on the same side of it.
  const double boundary = std::nearbyint(2 * steps) / 2;
  double representative = steps;
  if (std::fabs(steps - boundary) <= 0x1p-52 * std::fabs(steps)) {
    // x / w against boundary / 2^bits, w > 0: x 2^bits against boundary w. A quarter of a step
    // represents "between this multiple and the next".
    const int side = ProductDifferenceSign(x, std::ldexp(1.0, snap.bits), boundary, w);
    representative = boundary + 0.25 * side;
  }
  return SnapCoordinate(std::ldexp(representative, -snap.bits), snap);
}

std::optional<double> TrySnapQuotient(double x, double w, const Snap& snap) {
  const bool has_place = std::isfinite(x) && std::isfinite(w) && w > 0 && !snap.IsNone() &&
                         snap.form == SnapForm::kCoordinate && HasGridPoint(x, w, snap);
  return has_place ? std::optional(SnapQuotient(x, w, snap)) : std::nullopt;
}

std::optional<int> SnappedClipFacing(const std::array<Vertex, 3>& v, const Snap& snap) {
  std::array<Point2, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<double> x = TrySnapQuotient(v[k].x, v[k].w, snap);
    const std::optional<double> y = TrySnapQuotient(v[k].y, v[k].w, snap);
    if (!x || !y) return std::nullopt;
    at[k] = {*x, *y};
  }
  return Facing(at);
}

std::optional<InputError> SnapClipError(const Scene& scene, const TargetProfile& profile) {
  if (profile.snap.form != SnapForm::kCoordinate) {
    return InputError("profile \"" + profile.name + "\"",
                      "its snap form does not cover the quotient x / w",
                      "give window-space vertices, or a profile that snaps coordinates");
  }
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
    if (!IsDrawn(v)) continue;
    if (!std::ranges::all_of(v, [](const Vertex& corner) { return corner.w > 0; })) {
      return InputError("triangles[" + std::to_string(t) + "]",
                        "a vertex with w <= 0 has no position to snap",
                        "use a profile without snapping, or clip the scene in front of the eye");
    }
    for (const auto& [x, y, z, w] : v) {
      if (!HasGridPoint(x, w, profile.snap) || !HasGridPoint(y, w, profile.snap)) {
        return QuotientError();
      }
    }
  }
  return std::nullopt;
}

Scene SnapClipScene(const Scene& scene, const TargetProfile& profile) {
  if (const auto error = SnapClipError(scene, profile)) throw InputError(*error);
  Scene snapped = scene;
  snapped.precision = Precision::kFloat64;
  snapped.clip_space = false;
  std::vector<bool> used(scene.vertices.size(), false);
  for (const Triangle& t : scene.triangles) {
    if (!IsDrawn(Corners(scene, t))) continue;
    for (const std::int32_t index : t) used[static_cast<std::size_t>(index)] = true;
  }
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < scene.vertices.size(); ++k) {
    const Vertex& v = scene.vertices[k];
    // A vertex that only non-finite triangles use becomes NaN, so that they cover nothing.
    snapped.vertices[k] = used[k] ? Vertex{SnapQuotient(v.x, v.w, profile.snap),
                                           SnapQuotient(v.y, v.w, profile.snap), v.z, 1}
                                  : Vertex{kNowhere, kNowhere, v.z, 1};
  }
  return snapped;
}

}  // namespace rasterproof::exact
