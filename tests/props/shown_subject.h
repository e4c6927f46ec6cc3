// Subjects that show what a function draws as counts, as a mask or as primitive ids.
#ifndef RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_
#define RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::props::testing {

/// Which triangles of a call are drawn: the sound subject's answer is all of them.
using Takes = std::function<bool(std::span<const Triangle> call, std::size_t number)>;

/// Draws each triangle that it takes by the exact model, and shows the call as its kind does.
class ShownSubject final : public Subject {
 public:
  using DrawFunction = PlantedSubject::DrawFunction;

  ShownSubject(CoverageKind kind, Takes takes, DrawFunction draw)
      : info_(RealInfo()), takes_(std::move(takes)), draw_(std::move(draw)) {
    info_.coverage = kind;
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  Drawing Show(const DrawJob& job) override {
    ++calls;
    Scene scene = SceneOf(job);
    const std::vector<Triangle> call = std::exchange(scene.triangles, {});
    for (std::size_t t = 0; t < call.size(); ++t) {
      if (takes_(call, t)) scene.triangles.push_back(call[t]);
    }
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    draw_(scene, job.options, drawing.counts);
    if (info_.coverage == CoverageKind::kFacingCounts) return drawing;
    for (std::size_t k = 0; k < drawing.counts.size(); ++k) {
      std::uint32_t& count = drawing.counts.front[k];
      count += std::exchange(drawing.counts.back[k], 0);
      if (info_.coverage != CoverageKind::kCounts) count = std::min(count, 1U);
    }
    if (info_.coverage != CoverageKind::kPrimitiveIds) return drawing;
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    for (std::size_t k = 0; k < drawing.counts.size(); ++k) {
      if (drawing.counts.front[k] != 0) drawing.primitive_ids[k] = 0;
    }
    return drawing;
  }

  std::size_t calls = 0;

 private:
  SubjectInfo info_;
  Takes takes_;
  DrawFunction draw_;
};

}  // namespace rasterproof::props::testing

#endif  // RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_
