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
  /// True if it shows fragments, of the vertices on the grid; else it reports facings.
  bool shows_fragments = false;
  /// The error of the interpolated depths.
  double depth_error = 0;
  /// Depths that differ by less are taken for one.
  double flat_depths = 0;
  /// Returns where a vertex lies on the tile, for a map that draws what a scissor leaves as a
  /// separate target, whose first pixel is the tile's. Replaces `to_window`.
  std::function<Point2(const Vertex& vertex, const PixelRect& tile)> to_tile = {};
};

/// The stated errors of the fragments: barycentrics and depths are computed in double from
/// integers.
inline constexpr double kBarycentricError = 0x1p-46;
inline constexpr double kDepthError = 0x1p-44;

/// Returns the fixed-point rasterizer after a transform. A vertex that is not finite or not in
/// front of the eye has no place: its triangles are not drawn. After a map the rasterizer takes
/// float64.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const TransformStages& stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_OWN_TRANSFORM_H_
