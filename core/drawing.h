// One call to a subject, as a value: what it is asked, and all that comes back.
#ifndef RASTERPROOF_CORE_DRAWING_H_
#define RASTERPROOF_CORE_DRAWING_H_

#include <array>
#include <cstdint>
#include <exception>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"

namespace rasterproof {

/// A scene to draw onto a target of its own.
struct DrawJob {
  Scene scene;
  DrawOptions options;
  int samples = 1;  ///< per pixel
};

/// No triangle won the sample.
inline constexpr std::int32_t kNoTriangle = -1;

/// What one call gives back, for every kind of coverage. Vectors that the kind lacks are empty.
///
/// Shape:      as the counts: row-major [height][width][sample], top row first.
struct Drawing {
  /// 1 in `front` where there is a winner, for subjects that show winners.
  CoverageCounts counts;
  /// Index in the scene's list of the triangle that won the sample, or kNoTriangle.
  std::vector<std::int32_t> winners;
  /// The winner's barycentric coordinates, entry i for its vertex i; anything where there is none.
  std::vector<std::array<double, 3>> weights;
  /// The winner's z, interpolated; anything where there is none.
  std::vector<double> depths;
};

/// How one of many calls went.
struct DrawOutcome {
  Drawing drawing;
  std::exception_ptr error;  ///< what the call threw, if it did

  /// Whether the subject broke down over it: it threw something that is no InputError.
  bool BrokeDown() const;
  /// Returns the drawing, or throws what the call threw.
  const Drawing& Get() const {
    if (error != nullptr) std::rethrow_exception(error);
    return drawing;
  }
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_DRAWING_H_
