// Reordering the vertices reorders the barycentrics, up to the bounds stated for both orders.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentrics_follow_their_vertices {

using CornerOrder = std::array<std::size_t, 3>;
constexpr std::array<CornerOrder, 5> kOrders{
    {{1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};

using Triple = std::array<double, 3>;

// A query in one form, in the given order and in every other order.
struct InEveryOrder {
  BarycentricQuery query;
  BarycentricForm form = BarycentricForm::kVertexArea;
  Triple bounds{};
  std::array<Triple, kOrders.size()> reordered_bounds{};
};
constexpr std::size_t kQuestions = 1 + kOrders.size();

Verdict Judge(const std::vector<InEveryOrder>& queries, const Answers& answers) {
  std::uint64_t exercised = 0;
  for (std::size_t n = 0; n < queries.size(); ++n) {
    const auto& [q, form, bounds, reordered_bounds] = queries[n];
    const Triple& barycentrics = answers.barycentrics[n * kQuestions];
    for (std::size_t order = 0; order < kOrders.size(); ++order) {
      const Triple& reordered = answers.barycentrics[n * kQuestions + 1 + order];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = kOrders[order][k];
        const double bound = reordered_bounds[order][k];
        if (!IsStated(bounds[i]) || !IsStated(bound)) continue;
        ++exercised;
        if (AgreeWithin(reordered[k], barycentrics[i], -1, bound, bounds[i])) continue;
        return BarycentricViolation(
            q, static_cast<int>(i), exercised,
            "barycentric (" + std::string(FormName(form)) + ") does not follow its vertex",
            {reordered[k], " as entry " + std::to_string(k)},
            {barycentrics[i], " within ", bounds[i] + bound});
      }
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  std::vector<InEveryOrder> queries;
  Questions questions;
  for (const BarycentricQuery& q : SomeBarycentricQueries(c)) {
    const Point2 p = q.place.at;
    for (const BarycentricForm form : FormsFor(q)) {
      InEveryOrder at{q, form, subject.barycentrics->BarycentricErrorBounds(form, q.v, p)};
      questions.barycentrics.push_back({form, q.v, p});
      for (std::size_t order = 0; order < kOrders.size(); ++order) {
        const auto& [i, j, k] = kOrders[order];
        const std::array<Point2, 3> v{q.v[i], q.v[j], q.v[k]};
        at.reordered_bounds[order] = subject.barycentrics->BarycentricErrorBounds(form, v, p);
        questions.barycentrics.push_back({form, v, p});
      }
      queries.push_back(at);
    }
  }
  return OneCheck(std::move(questions), [queries = std::move(queries)](const Answers& answers) {
    return Judge(queries, answers);
  });
}

}  // namespace barycentrics_follow_their_vertices

extern constinit const Property kBarycentricsFollowTheirVertices{
    .name = "BarycentricsFollowTheirVertices",
    .group = "barycentric",
    .clause = "A barycentric belongs to its vertex, in whatever order the vertices are listed.",
    .tolerance = "the sum of both proven BarycentricErrorBounds",
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask = barycentrics_follow_their_vertices::Ask,
};

}  // namespace rasterproof::props
