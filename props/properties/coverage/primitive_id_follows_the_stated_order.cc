// The primitive id of a sample is that of the last or the first triangle that covers it, as the
// subject states.
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "exact/primitive_ids.h"
#include "props/judging/primitive_ids.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace primitive_id_follows_the_stated_order {

// The mesh is repeated until it has at least this many triangles: more than a byte can number.
constexpr std::size_t kFewestDrawn = 300;

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.scene.triangles.empty()) return NotExercised("the scene has no triangles");
  DrawQuestion question = WholeCallOf(c.scene, c.profile, c.options);
  std::vector<Triangle>& repeated = question.job.triangles.emplace(c.scene.triangles);
  while (repeated.size() < kFewestDrawn) {
    repeated.insert(repeated.end(), c.scene.triangles.begin(), c.scene.triangles.end());
  }
  Scene drawn = c.scene;
  drawn.triangles = repeated;
  Questions questions;
  questions.draws.push_back(std::move(question));
  return OneCheck(
      std::move(questions), [&c, &subject, drawn = std::move(drawn)](const Answers& answers) {
        Verdict verdict = SamePrimitiveIds(
            *answers.draws[0],
            exact::PrimitiveIds({drawn, c.profile}, c.options, subject.info.fragments.visible),
            c.scene.triangles.size(), DecisionsOf(c), "that cover it by the model");
        if (verdict.outcome == Outcome::kViolated) {
          verdict.message += " (the scene drawn over itself, " +
                             std::to_string(drawn.triangles.size()) + " triangles)";
        }
        return verdict;
      });
}

}  // namespace primitive_id_follows_the_stated_order

extern constinit const Property kPrimitiveIdFollowsTheStatedOrder{
    .name = "PrimitiveIdFollowsTheStatedOrder",
    .group = "coverage",
    .clause =
        "Primitives are drawn in order (OpenGL 4.6 section 2.1; Vulkan 1.3, Rasterization "
        "Order): without a depth test the last one on a sample stays.",
    .required_by = kOrderClauses,
    .tolerance = kExact,
    .domains = kAnyMesh,
    .gate = {.space = Space::kEither, .shows = Shows::kPrimitiveIds, .asks_oracle = true},
    .ask = primitive_id_follows_the_stated_order::Ask,
};

}  // namespace rasterproof::props
