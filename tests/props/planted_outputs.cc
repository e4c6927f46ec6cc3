#include <algorithm>
#include <array>
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
  sound.Draw(drawn, options, counts);
}

}  // namespace

std::vector<Plant> OutputPlants() {
  return {
      {"OneCallDrawsLikeItsTriangles",
       "the second triangle of a mesh is the first once more",
       "spans-exact",
       {.draw = RepeatTheFirst}},
      {"OneCallDrawsLikeItsTriangles", "winners of a mesh are numbered from its end", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob& job) {
         const auto last = static_cast<std::int32_t>(job.Triangles().size()) - 1;
         for (std::int32_t& winner : drawing.winners) {
           if (winner != kNoTriangle) winner = last - winner;
         }
       })},
      {"WinnerFollowsTheDeclaredOrder", "the triangle before the winner", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::int32_t& winner : drawing.winners) {
           if (winner != kNoTriangle) winner = std::max(winner - 1, 0);
         }
       })},
      {"FragmentWeightsSumToOne", "one weight is off by many ulps", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::array<double, 3>& weights : drawing.weights) weights[1] *= 1 + 0x1p-20;
       })},
      {"FragmentWeightsStayWithinTheirError", "weights of the next vertex", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (std::array<double, 3>& weights : drawing.weights) {
           std::ranges::rotate(weights, weights.begin() + 1);
         }
       })},
      {"FragmentDepthStaysInTheHull", "depths are counted from 1", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob&) {
         for (double& depth : drawing.depths) depth += 1;
       })},
      {"FragmentDepthFollowsItsWeights", "the depth of the provoking vertex", "spans-exact",
       Showing([](Drawing& drawing, const DrawJob& job) {
         for (std::size_t k = 0; k < drawing.depths.size(); ++k) {
           if (drawing.winners[k] == kNoTriangle) continue;
           const auto t = static_cast<std::size_t>(drawing.winners[k]);
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
