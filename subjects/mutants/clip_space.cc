#include "subjects/mutants/clip_space.h"

#include <cstdint>
#include <memory>
#include <utility>

#include "core/coverage.h"
#include "core/scene.h"
#include "reference/homogeneous.h"

namespace rasterproof::subjects::mutants {
namespace {

Cull Opposite(Cull cull) {
  if (cull == Cull::kNone) return cull;
  return cull == Cull::kFront ? Cull::kBack : Cull::kFront;
}

class ClipSpace final : public Subject {
 public:
  ClipSpace(const std::string& name, const std::string& summary, ClipStages stages)
      : stages_(std::move(stages)) {
    info_.name = name;
    info_.summary = summary;
    info_.profile = stages_.profile;
    info_.takes_window = false;
    info_.takes_clip = true;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    for (const Triangle& t : scene.triangles) {
      const ClipTriangle v = Corners(scene, t);
      const std::vector<ClipTriangle> drawn =
          stages_.becomes ? stages_.becomes(v) : std::vector<ClipTriangle>{v};
      const bool over = stages_.turns_over && stages_.turns_over(v);
      for (const ClipTriangle& triangle : drawn) DrawOne(scene, triangle, over, options, counts);
    }
  }

 private:
  void DrawOne(const Scene& scene, const ClipTriangle& v, bool over, DrawOptions options,
               CoverageCounts& counts) const {
    Scene alone;
    alone.width = scene.width;
    alone.height = scene.height;
    alone.precision = Precision::kFloat64;
    alone.clip_space = true;
    alone.vertices.assign(v.begin(), v.end());
    alone.triangles = {{0, 1, 2}};
    if (over) {
      options.cull = Opposite(options.cull);
      std::swap(counts.front, counts.back);
    }
    reference::DrawHomogeneousExact(alone, stages_.profile, options, counts);
    if (over) std::swap(counts.front, counts.back);
  }

  ClipStages stages_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> MakeClipSpace(const std::string& name, const std::string& summary,
                                       ClipStages stages) {
  return std::make_unique<ClipSpace>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
