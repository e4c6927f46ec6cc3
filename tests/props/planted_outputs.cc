#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/props/planted_bugs.h"

namespace rasterproof::props {
namespace {

Bug Showing(ShowBug show) {
  Bug bug;
  bug.show = std::move(show);
  return bug;
}

Bug Batching(BatchBug batch) {
  Bug bug;
  bug.batch = std::move(batch);
  return bug;
}

// Neighbours in the list get mixed up.
void RepeatTheFirst(Subject& sound, const Scene& scene, const DrawOptions& options,
                    CoverageCounts& counts) {
  Scene drawn = scene;
  if (scene.triangles.size() >= 2) drawn.triangles[1] = drawn.triangles[0];
  DrawOnto(sound, drawn, options, counts);
}

void LoseTheFirstColumn(Subject& sound, const Scene& scene, const DrawOptions& options,
                        CoverageCounts& counts) {
  DrawOptions narrow = options;
  if (narrow.scissor && narrow.scissor->x0 > 0) ++narrow.scissor->x0;
  DrawOnto(sound, scene, narrow, counts);
}

bool HaveTheSameFloors(const Scene& a, const Scene& b) {
  return std::ranges::equal(a.vertices, b.vertices, [](const Vertex& v, const Vertex& w) {
    return std::floor(v.x) == std::floor(w.x) && std::floor(v.y) == std::floor(w.y);
  });
}

// The scene before is drawn again where target, indices and the pixels of the vertices agree.
DrawBug KeepTheLastByItsPixels() {
  return [kept = Scene{}](Subject& sound, const Scene& scene, const DrawOptions& options,
                          CoverageCounts& counts) mutable {
    const bool agrees = kept.width == scene.width && kept.height == scene.height &&
                        kept.clip_space == scene.clip_space && kept.triangles == scene.triangles &&
                        HaveTheSameFloors(kept, scene);
    if (!agrees) kept = scene;
    DrawOnto(sound, kept, options, counts);
  };
}

}  // namespace

std::vector<PlantedBug> OutputPlantedBugs() {
  return {
      {"NewVerticesGiveNewCoverage",
       "a scene is kept by the pixels of its vertices",
       "spans-exact",
       {.draw = KeepTheLastByItsPixels()}},
      {"EarlierScenesLeaveNoTrace",
       "a scene is kept by the pixels of its vertices",
       "spans-exact",
       {.draw = KeepTheLastByItsPixels(), .has_twin = true}},
      {"TilesDrawnApartEqualTheWhole",
       "a tile beside the first loses its first column",
       "spans-exact",
       {.draw = LoseTheFirstColumn}},
      {"OneCallDrawsLikeItsTriangles",
       "the second triangle of a mesh is the first once more",
       "spans-exact",
       {.draw = RepeatTheFirst}},
      {"OneCallDrawsLikeItsTriangles", "primitive ids of a mesh are numbered from its end",
       "spans-exact", Showing([](Drawing& drawing, const DrawJob& job) {
         const auto last = static_cast<std::int32_t>(job.Triangles().size()) - 1;
         for (std::int32_t& id : drawing.primitive_ids) {
           if (id != kNoPrimitive) id = last - id;
         }
       })},
      {"PrimitiveIdFollowsTheStatedOrder", "the triangle before the visible one", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::int32_t& id : drawing.primitive_ids) {
           if (id != kNoPrimitive) id = std::max(id - 1, 0);
         }
       })},
      {"FragmentBarycentricsSumToOne", "one barycentric is off by many ulps", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::array<double, 3>& barycentrics : drawing.barycentrics)
           barycentrics[1] *= 1 + 0x1p-20;
       })},
      {"FragmentBarycentricsStayWithinTheirError", "barycentrics of the next vertex", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::array<double, 3>& barycentrics : drawing.barycentrics) {
           std::ranges::rotate(barycentrics, barycentrics.begin() + 1);
         }
       })},
      {"CentroidsLieWhereStated",
       "the centroid is a 16th of the triangle off",
       "spans-exact",
       {.show =
            [](Drawing& drawing, const DrawJob&) {
              for (std::array<double, 3>& barycentrics : drawing.centroids) {
                barycentrics[0] += 0.0625;
                barycentrics[1] -= 0.0625;
              }
            },
        .states = [](Profile& profile) { profile.centroid = Centroid::kInside; }}},
      {"FragmentDepthStaysInTheHull", "depths are counted from 1", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (double& depth : drawing.depths) depth += 1;
       })},
      {"FragmentDepthFollowsItsBarycentrics", "the depth of the provoking vertex", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob& job) {
         for (std::size_t k = 0; k < drawing.depths.size(); ++k) {
           if (drawing.primitive_ids[k] == kNoPrimitive) continue;
           const auto t = static_cast<std::size_t>(drawing.primitive_ids[k]);
           drawing.depths[k] = Corners(*job.scene, job.Triangles()[t])[0].z;
         }
       })},
      {"BatchDrawsLikeSingleCalls", "the last scene of a batch is dropped", "spans-exact",
       Batching([](std::vector<DrawOutcome>& outcomes) {
         std::ranges::fill(outcomes.back().drawing.counts.front, 0U);
         std::ranges::fill(outcomes.back().drawing.counts.back, 0U);
       })},
      {"BatchDrawsLikeSingleCalls", "what a scene covers is left in the next", "spans-exact",
       Batching([](std::vector<DrawOutcome>& outcomes) {
         for (std::size_t k = 1; k < outcomes.size(); ++k) {
           const CoverageCounts& before = outcomes[k - 1].drawing.counts;
           CoverageCounts& counts = outcomes[k].drawing.counts;
           if (before.size() == counts.size()) counts += before;
         }
       })},
  };
}

}  // namespace rasterproof::props
