// The sound base of mutants without a subpixel grid: exact signs on float32 vertices.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_

#include <array>
#include <limits>
#include <memory>
#include <string>

#include "core/profile.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "core/vertex.h"
#include "variants/stages.h"

namespace rasterproof::subjects::mutants {

using variants::ClipTriangle;
using Points = std::array<Point2, 3>;
using PointStages = variants::Stages<Point2>;

/// The "real" profile as a float32 subject states it: every finite coordinate.
inline Profile Float32Profile() {
  Profile profile;
  profile.coordinate_limit = std::numeric_limits<float>::max();
  return profile;
}

/// The stages of the rasterizer.
struct RealStages : PointStages {
  Profile profile = Float32Profile();
};

/// What happens to a triangle on its way to homogeneous set-up.
struct ClipStages : PointStages {
  Profile profile = Float32Profile();
};

/// Stages whose signs of E(a, b; p), the area's too, are those of the function.
RealStages Signing(int (*sign)(Point2 a, Point2 b, Point2 p));

/// The rasterizer with the given stages: every sample of the box, three signs each.
///
/// Domain:     float32 scenes in window space.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const RealStages& stages);

/// What such a subject states.
SubjectInfo RealGeometryInfo(const std::string& name, const std::string& summary,
                             const Profile& profile);
/// The same, under other statements.
std::unique_ptr<Subject> Make(const SubjectInfo& info, const RealStages& stages);

/// The rasterizer of clip space: nothing is clipped, signs are exact.
///
/// Domain:     float32 scenes in clip space.
std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              const ClipStages& stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_REAL_GEOMETRY_H_
