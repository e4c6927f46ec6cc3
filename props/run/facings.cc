#include "props/run/facings.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"

namespace rasterproof::props {
namespace {

// +1 front, -1 back, 0 no area or not finite. Clip space: of the quotients on the grid; of the
// vertices as given if there is no grid, or a vertex has no place on it.
int FacingOf(const Scene& snapped, const Triangle& t, const Profile& profile) {
  const std::array<Vertex, 3> v = Corners(snapped, t);
  if (!std::ranges::all_of(v, IsFinite)) return 0;
  const auto homogeneous = [&] {
    const std::optional<int> on_grid = exact::SnappedClipFacing(v, profile.snap);
    return on_grid ? *on_grid : exact::HomogeneousFacing(v);
  };
  const int facing = snapped.clip_space
                         ? homogeneous()
                         : exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
  return profile.y_axis == YAxis::kUp ? -facing : facing;
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

  Subject& Whole() override { return subject_->Whole(); }
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override {
    subject_->SetDeadline(deadline);
  }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const DrawJob job{scene, options, counts.samples};
    counts += DrawMany({&job, 1}).front().Get().counts;
  }

  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    std::vector<Part> parts;
    std::vector<DrawJob> part_jobs;
    for (std::size_t k = 0; k < jobs.size(); ++k) AddParts(k, jobs[k], parts, part_jobs);
    const std::vector<DrawOutcome> drawn = subject_->DrawMany(part_jobs);
    std::vector<DrawOutcome> outcomes(jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      const Scene& scene = *jobs[k].scene;
      outcomes[k].drawing.counts = CoverageCounts(scene.width, scene.height, jobs[k].samples);
    }
    for (std::size_t n = 0; n < drawn.size(); ++n) {
      DrawOutcome& outcome = outcomes[parts[n].job];
      if (drawn[n].error == nullptr) {
        AddTo(parts[n].is_back, drawn[n].drawing.counts, outcome.drawing.counts);
      } else if (outcome.error == nullptr) {
        outcome.error = drawn[n].error;
      }
    }
    if (drawn.size() < parts.size()) outcomes.resize(parts[drawn.size() - 1].job + 1);
    return outcomes;
  }

 private:
  /// One call's share of a job.
  struct Part {
    std::size_t job = 0;
    bool is_back = false;
  };

  void AddParts(std::size_t k, const DrawJob& job, std::vector<Part>& parts,
                std::vector<DrawJob>& part_jobs) const {
    const Scene& scene = *job.scene;
    const Profile profile = ForTarget(info_.profile, scene.width, scene.height);
    const Scene snapped = IsHomogeneous(scene, profile) ? scene : SnapScene(scene, profile);
    std::array<std::vector<Triangle>, 2> sides;
    for (const Triangle& t : job.Triangles()) {
      sides[FacingOf(snapped, t, profile) < 0 ? 1 : 0].push_back(t);
    }
    for (const bool is_back : {false, true}) {
      const std::vector<Triangle>& side = sides[is_back ? 1 : 0];
      const std::size_t triangles_a_call = CountsTriangles(subject_->Info()) ? side.size() : 1;
      for (std::size_t t = 0; t < side.size(); t += triangles_a_call) {
        parts.push_back({k, is_back});
        const auto first = side.begin() + static_cast<std::ptrdiff_t>(t);
        DrawJob& part = part_jobs.emplace_back(job.scene, job.options, job.samples);
        part.triangles.emplace(first, first + static_cast<std::ptrdiff_t>(triangles_a_call));
        part.wants = kCoverageAndIds;  // that an id is of the scene is looked at, whoever asks
      }
    }
  }

  static bool CountsTriangles(const SubjectInfo& info) {
    return info.coverage == CoverageKind::kCounts;
  }

  static void AddTo(bool is_back, const CoverageCounts& drawn, CoverageCounts& counts) {
    std::vector<std::uint32_t>& side = is_back ? counts.back : counts.front;
    for (std::size_t k = 0; k < side.size(); ++k) side[k] += drawn.Count(k);
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
