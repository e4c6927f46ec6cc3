// One call to a subject, as a value: what it is asked, and all that comes back.
#ifndef RASTERPROOF_CORE_DRAWING_H_
#define RASTERPROOF_CORE_DRAWING_H_

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"

namespace rasterproof {

/// What a call is to give back beside its coverage, which always comes. A subject gives what it
/// shows of it, and may give more.
struct Outputs {
  bool primitive_ids = true;  ///< Drawing::primitive_ids
  bool barycentrics = true;
  bool depths = true;
  /// Drawing::centroids, which subjects work out only where they are asked for.
  bool centroids = false;

  friend bool operator==(const Outputs&, const Outputs&) = default;
};
/// All that a call shows of its samples.
inline constexpr Outputs kEverything{};
inline constexpr Outputs kCoverageAndPrimitiveIds{
    .primitive_ids = true, .barycentrics = false, .depths = false};
inline constexpr Outputs kCoverageAlone{
    .primitive_ids = false, .barycentrics = false, .depths = false};

/// Triangles of a scene to draw onto a target of their own. Jobs that draw parts or orders of one
/// scene share it.
struct DrawJob {
  DrawJob() = default;
  DrawJob(std::shared_ptr<const Scene> shared, const DrawOptions& how, int samples_per_pixel)
      : scene(std::move(shared)), options(how), samples(samples_per_pixel) {}
  DrawJob(Scene whole, const DrawOptions& how, int samples_per_pixel)
      : DrawJob(std::make_shared<const Scene>(std::move(whole)), how, samples_per_pixel) {}

  /// The target and the vertices. Never null.
  std::shared_ptr<const Scene> scene = std::make_shared<const Scene>();
  /// Those to draw, in this order, any of them more than once; nothing: the scene's own.
  std::optional<std::vector<Triangle>> triangles;
  DrawOptions options;
  int samples = 1;  ///< per pixel
  Outputs wants;
  /// What the target holds before the draw, which adds to it: of a job alone in its call. Null:
  /// zeros.
  std::shared_ptr<const CoverageCounts> onto;
  /// It is drawn so many times, and what comes back is of once: for clocks alone.
  int repeats = 1;

  /// Those that are drawn.
  std::span<const Triangle> Triangles() const { return triangles ? *triangles : scene->triangles; }
};

/// What a job draws, as a scene of its own.
Scene SceneOf(const DrawJob& job);

/// No triangle won the sample.
inline constexpr std::int32_t kNoPrimitive = -1;

/// What one call gives back, for every kind of coverage. Vectors that the kind lacks are empty.
///
/// Shape:      as the counts: row-major [height][width][sample], top row first.
struct Drawing {
  /// 1 in `front` where a triangle is visible, for subjects that show primitive ids.
  CoverageCounts counts;
  /// Index in the scene's list of the triangle that won the sample, or kNoPrimitive.
  std::vector<std::int32_t> primitive_ids;
  /// The visible triangle's barycentric coordinates, entry i for its vertex i; anything where none
  /// is visible.
  std::vector<std::array<double, 3>> barycentrics;
  /// The visible triangle's z, interpolated; anything where none is visible.
  std::vector<double> depths;
  /// The visible triangle's barycentric coordinates where attributes asked for at the centroid of
  /// its fragment in this pixel are evaluated; anything where none is visible.
  std::vector<std::array<double, 3>> centroids;
};

/// What came of one job.
struct DrawOutcome {
  Drawing drawing;
  CallEnd end;

  /// Returns the drawing.
  ///
  /// Error:      SubjectStop if there is none.
  const Drawing& Get() const {
    if (end.stop != Stop::kNone) throw SubjectStop(end);
    return drawing;
  }
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_DRAWING_H_
