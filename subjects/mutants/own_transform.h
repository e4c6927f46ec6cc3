// The base of mutants that own the transform from clip space, or from a map, to the window.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_OWN_TRANSFORM_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_OWN_TRANSFORM_H_

#include <functional>
#include <memory>
#include <string>

#include "core/draw_options.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/transform.h"
#include "core/vertex.h"

namespace rasterproof::subjects::mutants {

/// What the subject states, and what it does with a vertex in front of the eye.
struct TransformStages {
  Transform stated;
  std::function<Point2(const Vertex& clip, const Scene& scene)> to_window;
  /// True if it shows fragments, of the vertices on the grid; else it tells facings.
  bool shows_fragments = false;
  /// What the interpolated depths are off.
  double depth_error = 0;
  /// Depths that differ by less are taken for one.
  double flat_depths = 0;
  /// Of a map: it draws what a scissor leaves as a target of its own, whose first pixel is the
  /// tile's; where a vertex lies on it. In place of `to_window`.
  std::function<Point2(const Vertex& vertex, const PixelRect& tile)> to_tile = {};
};

/// What the subject says of the fragments that it shows: barycentrics and depths in double, of
/// integers.
inline constexpr double kBarycentricError = 0x1p-46;
inline constexpr double kDepthError = 0x1p-44;

/// The fixed-point rasterizer behind a transform. A vertex that is not finite or not in front of
/// the eye has no place: its triangles are not drawn. Behind a map it takes float64.
std::unique_ptr<Subject> MakeOwnTransform(const std::string& name, const std::string& summary,
                                          TransformStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_OWN_TRANSFORM_H_
