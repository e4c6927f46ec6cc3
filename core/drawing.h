// One call to a subject, as values: the job and its outcome.
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

/// The outputs that a call should return in addition to its coverage, which it always returns. A
/// subject returns those that it can show, and may return more.
struct Outputs {
  bool primitive_ids = true;  ///< Drawing::primitive_ids
  bool barycentrics = true;
  bool depths = true;
  /// Drawing::centroids, which subjects compute only on request.
  bool centroids = false;
  bool values = false;       ///< Drawing::values of the scene's channels
  bool derivatives = false;  ///< Drawing::derivatives of these values

  friend bool operator==(const Outputs&, const Outputs&) = default;
};
/// All outputs but centroids, values and derivatives, which cost what nobody looks at.
inline constexpr Outputs kEverything{};
inline constexpr Outputs kCoverageAndPrimitiveIds{
    .primitive_ids = true, .barycentrics = false, .depths = false};
inline constexpr Outputs kCoverageAlone{
    .primitive_ids = false, .barycentrics = false, .depths = false};

/// Triangles of a scene to draw onto their own target. Jobs that draw parts or orders of one scene
/// share it.
struct DrawJob {
  DrawJob() = default;
  DrawJob(std::shared_ptr<const Scene> shared, const DrawOptions& how, int samples_per_pixel)
      : scene(std::move(shared)), options(how), samples(samples_per_pixel) {}
  DrawJob(Scene whole, const DrawOptions& how, int samples_per_pixel)
      : DrawJob(std::make_shared<const Scene>(std::move(whole)), how, samples_per_pixel) {}

  /// The target and the vertices. Never null.
  std::shared_ptr<const Scene> scene = std::make_shared<const Scene>();
  /// The triangles to draw, in this order, with repetitions if need be; nothing: the scene's own.
  std::optional<std::vector<Triangle>> triangles;
  DrawOptions options;
  int samples = 1;  ///< per pixel
  Outputs wants;
  /// The target's counts before the draw, which adds to them. Only for a job that is alone in its
  /// call. Null: zeros.
  std::shared_ptr<const CoverageCounts> onto;
  /// The number of times it is drawn, to be timed; the drawing that comes back is that of one draw.
  int repeats = 1;

  /// The triangles that are drawn.
  std::span<const Triangle> Triangles() const { return triangles ? *triangles : scene->triangles; }
};

/// Returns the scene that holds exactly the triangles that the job draws.
Scene SceneOf(const DrawJob& job);

/// Returns whether no job asks for another floating-point mode. Only then can one call draw them
/// all: a call has one mode.
bool AreInTheUsualMode(std::span<const DrawJob> jobs);

/// The primitive id of a sample that no triangle won.
inline constexpr std::int32_t kNoPrimitive = -1;

/// The answer of one call, for every kind of coverage. Vectors that the kind lacks are empty.
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
  /// The visible triangle's values: of each sample one for each channel of the scene, in their
  /// order; anything where none is visible.
  std::vector<double> values;
  /// Of each of these values its derivatives by x and by y, per pixel, y growing as the profile
  /// says.
  std::vector<std::array<double, 2>> derivatives;
};

/// The drawing of one job, or the reason that there is none.
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
