#include "props/run/facings.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"

namespace rasterproof::props {
namespace {

// +1 front, -1 back, 0 no area or not finite. Clip space: of the vertices as given, which is that
// of the projection before any snap.
int FacingOf(const Scene& snapped, const Triangle& t, YAxis y_axis) {
  const std::array<Vertex, 3> v = Corners(snapped, t);
  if (!std::ranges::all_of(v, IsFinite)) return 0;
  const int facing = snapped.clip_space
                         ? exact::HomogeneousFacing(v)
                         : exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
  return y_axis == YAxis::kUp ? -facing : facing;
}

class FacingSubject final : public Subject {
 public:
  explicit FacingSubject(std::unique_ptr<Subject> subject)
      : subject_(std::move(subject)), info_(subject_->Info()) {
    info_.coverage = CoverageKind::kFacingCounts;
  }
  const SubjectInfo& Info() const override { return info_; }
  const EdgeEvaluator* Edges() const override { return subject_->Edges(); }
  const WeightEvaluator* Weights() const override { return subject_->Weights(); }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const Scene snapped =
        IsHomogeneous(scene, info_.profile) ? scene : SnapScene(scene, info_.profile);
    std::vector<Triangle> front;
    std::vector<Triangle> back;
    for (const Triangle& t : scene.triangles) {
      (FacingOf(snapped, t, info_.profile.y_axis) < 0 ? back : front).push_back(t);
    }
    DrawSide(scene, front, options, counts, counts.front);
    DrawSide(scene, back, options, counts, counts.back);
  }

 private:
  void DrawSide(const Scene& scene, const std::vector<Triangle>& triangles,
                const DrawOptions& options, const CoverageCounts& shape,
                std::vector<std::uint32_t>& to) {
    if (subject_->Info().coverage == CoverageKind::kMask) {
      for (const Triangle& t : triangles) AddDrawn(scene, {t}, options, shape, to);
    } else if (!triangles.empty()) {
      AddDrawn(scene, triangles, options, shape, to);
    }
  }

  void AddDrawn(const Scene& scene, std::vector<Triangle> triangles, const DrawOptions& options,
                const CoverageCounts& shape, std::vector<std::uint32_t>& to) {
    Scene part = scene;
    part.triangles = std::move(triangles);
    CoverageCounts drawn(shape.width, shape.height, shape.samples);
    subject_->Draw(part, options, drawn);
    for (std::size_t k = 0; k < to.size(); ++k) to[k] += drawn.front[k] + drawn.back[k];
  }

  std::unique_ptr<Subject> subject_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> WithFacings(std::unique_ptr<Subject> subject) {
  if (subject->Info().coverage == CoverageKind::kFacingCounts) return subject;
  return std::make_unique<FacingSubject>(std::move(subject));
}

}  // namespace rasterproof::props
