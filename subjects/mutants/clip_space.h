// The sound base of clip-space mutants: the reference's exact homogeneous coverage.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_CLIP_SPACE_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_CLIP_SPACE_H_

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/subject.h"
#include "core/vertex.h"
#include "subjects/mutants/real_geometry.h"

namespace rasterproof::subjects::mutants {

using ClipTriangle = std::array<Vertex, 3>;

/// What happens to a triangle on its way to homogeneous set-up.
struct ClipStages {
  Profile profile = Float32Profile();
  /// The triangles that are drawn in its place: none, itself, pieces. Empty: itself.
  std::function<std::vector<ClipTriangle>(const ClipTriangle&)> becomes = {};
  /// Whether front and back are exchanged.
  std::function<bool(const ClipTriangle&)> turns_over = {};
};

/// Domain:     float32 scenes in clip space.
std::unique_ptr<Subject> MakeClipSpace(const std::string& name, const std::string& summary,
                                       ClipStages stages);

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_CLIP_SPACE_H_
