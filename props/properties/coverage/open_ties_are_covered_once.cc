// A sample inside a mesh is covered once even where the profile leaves open who owns it.
//
// Specifications speak of an edge and its two sides, or not even of that. At vertices, and where no
// owner is stated at all, nobody has to cover a sample once; whoever draws a mesh wants it.
#include <array>
#include <memory>
#include <utility>

#include "props/judging/mesh/planar_mesh.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace open_ties_are_covered_once {

// The mesh, judged as under a profile that is the case's but for its owners.
Checks AskForOnce(const PlacedCase& c, const Description& subject) {
  Freedom freedom = c.profile.freedom;
  freedom.ties = TieOwnership::kStated;
  const auto owned = std::make_shared<PlacedCase>(c.Under(freedom));
  Checks asked = CompareWithItsWinding(*owned, subject);
  for (Check& check : asked.checks) {
    check.judge = [owned, judge = std::move(check.judge)](const Answers& answers) {
      return judge(answers);
    };
  }
  return asked;
}

constexpr std::array kRulesForOnce{
    ProfileRule{[](const Profile& p) {
                  return p.freedom.ties == TieOwnership::kPerEdge ||
                         p.freedom.ties == TieOwnership::kOpen;
                },
                "tie_ownership per-edge or open",
                "the profile states an owner for every sample, so other properties judge them"},
    kCountsTies, kOwnsEdges};

}  // namespace open_ties_are_covered_once

extern constinit const Property kOpenTiesAreCoveredOnce{
    .name = "OpenTiesAreCoveredOnce",
    .group = "coverage",
    .clause =
        "A sample inside a mesh is covered once, at its vertices and on its edges too, whoever "
        "owns it: no specification but Direct3D's says so of vertices.",
    .stated_by = [](const Profile&) { return false; },
    .tolerance = kExact,
    .domains = kMeshesAnySpace,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kWatertight,
             .judges_clipped = true,
             .rules = open_ties_are_covered_once::kRulesForOnce,
             .asks_oracle = true,
             .where = "as EmbeddedMeshSamplesAreCoveredOnce"},
    .ask = open_ties_are_covered_once::AskForOnce,
};

}  // namespace rasterproof::props
