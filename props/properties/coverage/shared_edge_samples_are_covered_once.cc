// Two triangles that share an edge, drawn alone, cover each sample beside it exactly once.
#include "props/properties/coverage/shared_edge_samples_are_covered_once.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "props/judging/as_shown.h"
#include "props/judging/mesh/neighbour_pairs.h"
#include "props/judging/mesh/planar_mesh.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace shared_edge_samples_are_covered_once {

// The counts of the pair drawn alone: beside the edge that they share, neither a gap nor an
// overlap.
Verdict CoveredOnce(const NeighbourPair& pair, const CoverageCounts& counts, Clipped clipped) {
  Verdict verdict;
  for (const SamplePlace& sample : pair.SamplesBesideTheEdge()) {
    const bool is_left_out = clipped == Clipped::kMayDiffer && pair.ClippingMayDecide(sample);
    if (is_left_out || pair.CanTurnAt(sample)) {
      ++verdict.not_judged;
      continue;
    }
    ++verdict.exercised;
    const std::size_t index = counts.Index(sample.x, sample.row, sample.sample);
    const std::uint32_t count = counts.Count(index);
    if (count == 1 || pair.MayShare(sample, index, count)) continue;
    return pair.CoveredTimes(count, sample, verdict);
  }
  verdict.outcome = verdict.exercised != 0 ? Outcome::kHolds : Outcome::kNotExercised;
  return verdict;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CoverSharedEdgesOnce(c, subject, Clipped::kMayDiffer,
                              [](const Neighbours&) { return true; });
}

}  // namespace shared_edge_samples_are_covered_once

Checks CoverSharedEdgesOnce(const PlacedCase& c, const Description& subject, Clipped clipped,
                            const std::function<bool(const Neighbours&)>& takes) {
  Checks asked;
  for (const Neighbours& neighbours : NeighbourPair::Some(c)) {
    if (!takes(neighbours)) continue;
    const auto pair = std::make_shared<const NeighbourPair>(c, neighbours);
    if (pair->IsOpen()) continue;
    const PlacedCase& alone = pair->Alone();
    Questions questions;
    questions.draws.push_back(CountsOf(alone.scene, alone.profile, WholeTarget(alone)));
    const bool as_shown = IsJudgedAsShown(subject.info, alone.scene);
    asked.checks.push_back(
        {std::move(questions), [pair, as_shown, clipped](const Answers& answers) {
           const Verdict verdict = shared_edge_samples_are_covered_once::CoveredOnce(
               *pair, answers.draws[0]->counts, clipped);
           return as_shown ? NeverHolds(verdict) : verdict;
         }});
  }
  return asked;
}

extern constinit const Property kSharedEdgeSamplesAreCoveredOnce{
    .name = "SharedEdgeSamplesAreCoveredOnce",
    .group = "coverage",
    .clause =
        "Exactly one of two polygons on either side of a common edge with identical "
        "endpoints owns a sample on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic "
        "Polygon Rasterization).",
    .required_by = kOneOwnerClauses,
    .tolerance = kExact,
    .domains = kMeshesAnySpace,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kWatertight,
             .judges_clipped = true,
             .rules = kPlanarMeshRules,
             .asks_oracle = true,
             .where = "shared ties: at least once; two triangles of one facing with an edge in "
                      "opposite directions; samples nearer to it than to any other edge of theirs"},
    .ask = shared_edge_samples_are_covered_once::Ask,
};

}  // namespace rasterproof::props
