// Every barycentric lies within the subject's bound of lambda_i; unsigned ones only in the
// triangle.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/rational.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/estimate.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentrics_stay_within_their_bound {

Verdict Judge(const std::vector<BarycentricAnswer>& answers) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const auto& [q, forms] : answers) {
    const std::array<Estimate, 3> near = EstimatedBarycentrics(q.v, q.place.at);
    std::optional<std::array<exact::Rational, 3>> lambda;
    for (const auto& [form, barycentrics, bounds] : forms) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!IsStated(bounds[i])) continue;
        ++exercised;
        auto distance = CompareWithEstimate(barycentrics[i], near[i], bounds[i]);
        if (!distance) {
          if (!lambda) lambda = ExactBarycentrics(q);
          distance = CompareWithExact(barycentrics[i], (*lambda)[i], bounds[i]);
        }
        if (!distance->within) {
          return BarycentricViolation(
              q, static_cast<int>(i), exercised,
              "barycentric (" + std::string(FormName(form)) + ") outside its proven bound",
              {barycentrics[i]}, {Exactly((*lambda)[i]), " within ", bounds[i]});
        }
        worst = std::max(worst, distance->ratio);
      }
    }
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskBarycentrics(SomeBarycentricQueries(c), *subject.barycentrics, Judge);
}

}  // namespace barycentrics_stay_within_their_bound

extern constinit const Property kBarycentricsStayWithinTheirBound{
    .name = "BarycentricsStayWithinTheirBound",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1, the barycentrics a, b, c).",
    .tolerance = kBarycentricBounds,
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, "area not zero; unsigned areas: closed triangle only"),
    .ask = barycentrics_stay_within_their_bound::Ask,
};

}  // namespace rasterproof::props
