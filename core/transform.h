// From clip space to window space as a rasterizer computes it, operation by operation.
#ifndef RASTERPROOF_CORE_TRANSFORM_H_
#define RASTERPROOF_CORE_TRANSFORM_H_

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/scene.h"

namespace rasterproof {

/// How a clip-space coordinate is divided by w.
enum class Division : std::uint8_t {
  kQuotient,   ///< x / w
  kReciprocal  ///< x * (1 / w)
};

/// How the quotient q becomes a place on the target, half of whose size is h.
enum class ViewportForm : std::uint8_t {
  kNone,         ///< q: clip space is scaled to the viewport already
  kMultiplyAdd,  ///< q * h + h
  kFused,        ///< fma(q, h, h)
  kAddMultiply   ///< (q + 1) * h
};

/// The transform that a rasterizer owns: every operation rounds to nearest in `precision`.
///
/// A rasterizer that owns none takes window space, or is held to the exact quotients.
struct Transform {
  Precision precision = Precision::kFloat32;
  Division division = Division::kQuotient;
  ViewportForm viewport = ViewportForm::kNone;
  /// Clip space has y up where the target has it down: -q takes the place of q along y.
  bool flips_y = false;

  friend bool operator==(const Transform&, const Transform&) = default;
};

/// Returns the window-space vertex that the transform makes of a clip-space one.
///
/// Domain:     any vertex; the target's size within a scene's limits.
/// Returns:    x and y bit for bit as the operations give them, infinities and NaN included; NaN if
///             the vertex is not finite or w is not positive: what clipping makes of it is not the
///             transform's to say. z is that of the vertex, w is 1.
Vertex ToWindow(const Vertex& clip, const Transform& transform, int width, int height);

/// Returns a clip-space vertex with the given w that the transform takes to (x, y), or to a place a
/// few roundings beside it.
///
/// Domain:     w positive and finite.
/// Returns:    doubles: a taker of float32 is to round them.
Vertex ToClip(const Vertex& window, double w, const Transform& transform, int width, int height);

/// Returns the scene with every vertex taken through the transform; in the transform's precision.
///
/// Domain:     a clip-space scene.
Scene ToWindow(const Scene& scene, const Transform& transform);

/// Names: "quotient", "reciprocal".
std::string_view DivisionName(Division division);
std::optional<Division> DivisionFromName(std::string_view name);

/// Names: "none", "multiply-add", "fused", "add-multiply".
std::string_view ViewportFormName(ViewportForm form);
std::optional<ViewportForm> ViewportFormFromName(std::string_view name);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_TRANSFORM_H_
