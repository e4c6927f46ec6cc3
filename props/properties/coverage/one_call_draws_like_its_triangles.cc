// A call with a mesh gives what the calls with each of its triangles alone add up to.
//
// The sum of counts, the union of masks, the visible triangle by the stated order. Where the owners
// of samples on edges are open they may be others in every call: samples are compared that all
// legal models decide alike.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/freedom.h"
#include "core/subject_info.h"
#include "props/judging/open_by_call.h"
#include "props/judging/primitive_ids.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace one_call_draws_like_its_triangles {

// A larger mesh is judged by this many first triangles: among them a rasterizer shows how it treats
// neighbours in the list.
constexpr std::size_t kMostTriangles = 32;
// The number of copies of the first triangle before the others: a byte can't number those any more.
constexpr std::size_t kBefore = 256;

// The triangles of one call, by their place in the case.
using CallOrder = std::vector<std::size_t>;

// The mesh repeated `times` times, and the same after kBefore copies of its first triangle.
std::array<CallOrder, 2> OrdersOf(std::size_t count, std::size_t times) {
  CallOrder plain;
  for (std::size_t n = 0; n < times * count; ++n) plain.push_back(n % count);
  CallOrder late(kBefore, 0);
  late.insert(late.end(), plain.begin(), plain.end());
  return {plain, late};
}

// A call for each order, and then one for each triangle.
Questions WholesAndSingles(const PlacedCase& c, std::span<const CallOrder> orders,
                           std::size_t count) {
  const DrawQuestion question = WholeCallOf(c.scene, c.profile, c.options);
  Questions questions;
  const auto ask = [&](const CallOrder& order) {
    questions.draws.push_back(question);
    std::vector<Triangle>& triangles = questions.draws.back().job.triangles.emplace();
    for (const std::size_t t : order) triangles.push_back(c.scene.triangles[t]);
  };
  for (const CallOrder& order : orders) ask(order);
  for (std::size_t t = 0; t < count; ++t) ask({t});
  return questions;
}

void AddAlone(const CoverageCounts& alone, bool is_mask, CoverageCounts& sum) {
  sum += alone;
  if (!is_mask) return;
  for (std::uint32_t& count : sum.front) count = std::min(count, 1U);
}

// Whether a drawing in one call is what its triangles' own add up to.
Verdict LikeItsTriangles(const SubjectInfo& info, const Drawing& mesh, const CallOrder& order,
                         std::span<const std::shared_ptr<const Drawing>> alone,
                         const OpenByCall& open, std::uint64_t decisions) {
  if (ShowsPrimitiveIds(info)) {
    std::vector<std::vector<bool>> covered;
    for (const std::size_t t : order) covered.push_back(CoveredSamples(alone[t]->counts));
    return SamePrimitiveIds(
        mesh, open.Expected(mesh.primitive_ids, PrimitiveIdsOf(covered, info.fragments.visible)),
        alone.size(), decisions, "drawn alone");
  }
  CoverageCounts sum(mesh.counts.width, mesh.counts.height, mesh.counts.samples);
  for (const std::size_t t : order) {
    AddAlone(alone[t]->counts, info.coverage == CoverageKind::kMask, sum);
  }
  return SameCounts(mesh.counts, open.Expected(mesh.counts, std::move(sum)), decisions,
                    "that of its triangles drawn alone");
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.scene.triangles.size() < 2) return NotExercised("a mesh of one triangle");
  const auto open = WhereCallsMayDiffer(c, c.profile.freedom.ties == TieOwnership::kOpen);
  if (!open) return NotExercised(kPlacesNotKnown);
  // PrimitiveIds: twice, so that something always lies on top.
  const std::size_t times = ShowsPrimitiveIds(subject.info) ? 2 : 1;
  const auto count = std::min(c.scene.triangles.size(), kMostTriangles);
  std::array<CallOrder, 2> orders = OrdersOf(count, times);
  Questions questions = WholesAndSingles(c, orders, count);
  return OneCheck(std::move(questions), [&c, &subject, open = *open,
                                         orders = std::move(orders)](const Answers& answers) {
    const auto alone = std::span(answers.draws).subspan(orders.size());
    const std::uint64_t decisions = open.Judged(DecisionsOf(c));
    for (std::size_t k = 0; k < orders.size(); ++k) {
      Verdict verdict =
          LikeItsTriangles(subject.info, *answers.draws[k], orders[k], alone, open, decisions);
      if (verdict.outcome != Outcome::kViolated) continue;
      if (k == 1) {
        verdict.message += " (behind " + std::to_string(kBefore) + " repetitions of the first)";
      }
      return OfDraw(k, std::move(verdict));
    }
    return Verdict::Held(2 * decisions);
  });
}

}  // namespace one_call_draws_like_its_triangles

extern constinit const Property kOneCallDrawsLikeItsTriangles{
    .name = "OneCallDrawsLikeItsTriangles",
    .group = "coverage",
    .clause =
        "A mesh is its triangles: what one call with all of them gives, also behind 256 "
        "others, is what calls with each alone add up to.",
    .required_by = kIndependentClauses,
    .tolerance = kExact,
    .domains = kCalls,
    .takes_long = true,
    .gate = {.space = Space::kEither,
             .any_model = true,
             .judges_clipped = true,
             .where = kTwoTriangles},
    .ask = one_call_draws_like_its_triangles::Ask,
};

}  // namespace rasterproof::props
