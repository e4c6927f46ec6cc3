// The sound base of mutants without a subpixel grid: exact signs on float32 vertices.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_

#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>

#include "core/profile.h"
#include "core/subject.h"
#include "core/vertex.h"

namespace rasterproof::subjects::mutants {

using Points = std::array<Point2, 3>;

/// The "real" profile as a float32 subject states it: every finite coordinate.
inline Profile Float32Profile() {
  Profile profile;
  profile.coordinate_limit = std::numeric_limits<float>::max();
  return profile;
}

/// The stages of the rasterizer. An empty function leaves its stage sound.
struct RealStages {
  Profile profile = Float32Profile();

  std::function<bool(const Points&)> drops = {};
  std::function<void(Points&)> vertices = {};
  /// Sign of E(a, b; p).
  std::function<int(Point2 a, Point2 b, Point2 p)> sign = {};
  /// Sign of the area; empty: sign(v0, v1; v2).
  std::function<int(const Points&)> facing = {};
  /// Whether an edge of a triangle of positive area owns its samples.
  std::function<bool(Point2 a, Point2 b)> owns = {};
};

/// The rasterizer with the given stages: every sample of the box, three signs each.
///
/// Domain:     float32 scenes in window space, one sample at the centre of each pixel, y down.
std::unique_ptr<Subject> MakeRealGeometry(const std::string& name, const std::string& summary,
                                          RealStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_
