// Subjects that show what a function draws as counts, as a mask or as primitive ids.
#ifndef RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_
#define RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props::testing {

/// Which triangles of a call are drawn: the sound subject's answer is all of them.
using Takes = std::function<bool(std::span<const Triangle> call, std::size_t number)>;

/// A subject that draws the triangles it takes by a function and shows the call as its kind does.
inline FakeSubject ShownSubject(CoverageKind kind, Takes takes, FakeSubject::DrawFunction draw) {
  SubjectInfo info = RealInfo();
  info.coverage = kind;
  return FakeSubject::Showing(info, [kind, takes, draw](const DrawJob& job) {
    Scene scene = SceneOf(job);
    const std::vector<Triangle> call = std::exchange(scene.triangles, {});
    for (std::size_t t = 0; t < call.size(); ++t) {
      if (takes(call, t)) scene.triangles.push_back(call[t]);
    }
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    draw(scene, job.options, drawing.counts);
    HideFacings(kind, drawing.counts);
    if (kind != CoverageKind::kPrimitiveIds) return drawing;
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    for (std::size_t k = 0; k < drawing.counts.size(); ++k) {
      if (drawing.counts.front[k] != 0) drawing.primitive_ids[k] = 0;
    }
    return drawing;
  });
}

}  // namespace rasterproof::props::testing

#endif  // RASTERPROOF_TESTS_PROPS_SHOWN_SUBJECT_H_
