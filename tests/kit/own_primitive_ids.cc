// A type of one's own that shows primitive ids and draws several scenes in one call.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/profile.h"
#include "exact/coverage.h"
#include "kit/main.h"

using rasterproof::Drawing;
using rasterproof::DrawJob;

struct PrimitiveIds {
  static rasterproof::SubjectInfo Info() {
    rasterproof::SubjectInfo info;
    info.coverage = rasterproof::CoverageKind::kPrimitiveIds;
    info.takes_tiles = false;
    return info;
  }

  Drawing Show(const DrawJob& job) {
    Drawing drawing;
    const rasterproof::Scene& scene = *job.scene;
    drawing.counts = rasterproof::CoverageCounts(scene.width, scene.height, job.samples);
    drawing.primitive_ids.assign(drawing.counts.size(), rasterproof::kNoPrimitive);
    rasterproof::Scene alone = scene;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      alone.triangles = {scene.triangles[t]};
      const auto covered = rasterproof::exact::Coverage(alone, Info().profile, job.options);
      for (std::size_t k = 0; k < covered.size(); ++k) {
        if (covered.Count(k) != 0) drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
      }
    }
    return drawing;
  }

  std::vector<Drawing> ShowMany(std::span<const DrawJob> jobs) {
    std::vector<Drawing> drawings;
    for (const DrawJob& job : jobs) drawings.push_back(Show(job));
    return drawings;
  }
};

RASTERPROOF_MAIN(PrimitiveIds)
