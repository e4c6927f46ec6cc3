// A barycentric has the sign of its exact lambda wherever |lambda| exceeds the bound stated.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentric_signs_agree_with_the_edges {

Verdict Judge(const std::vector<BarycentricAnswer>& answers) {
  std::uint64_t exercised = 0;
  for (const auto& [q, forms] : answers) {
    const int facing = exact::Facing(q.v);
    for (const auto& [form, barycentrics, bounds] : forms) {
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (!IsStated(bounds[k])) continue;
        // lambda_i = E_i / area: its sign is the product of theirs.
        const int sign = exact::EdgeSign(EdgeStart(q.v, i), EdgeEnd(q.v, i), q.place.at) * facing;
        if (HasSign(barycentrics[k], sign)) {
          ++exercised;
          continue;
        }
        const exact::Rational lambda = ExactBarycentrics(q)[k];
        if (bounds[k] > 0 && lambda.Abs() <= exact::Rational(bounds[k])) continue;
        ++exercised;
        return BarycentricViolation(
            q, i, exercised,
            "barycentric (" + std::string(FormName(form)) + ") of the wrong sign outside its band",
            {barycentrics[k]}, {Exactly(lambda), ", band ", bounds[k]});
      }
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskBarycentrics(SomeBarycentricQueries(c), *subject.barycentrics, Judge);
}

}  // namespace barycentric_signs_agree_with_the_edges

extern constinit const Property kBarycentricSignsAgreeWithTheEdges{
    .name = "BarycentricSignsAgreeWithTheEdges",
    .group = "barycentric",
    .clause =
        "a, b, c lie in [0, 1] inside the triangle (OpenGL 4.6 section 14.6.1 and Vulkan "
        "1.3, Basic Polygon Rasterization), and one of them is negative outside.",
    .tolerance = "the subject's proven BarycentricErrorBounds; where they are 0, none: exact",
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask = barycentric_signs_agree_with_the_edges::Ask,
};

}  // namespace rasterproof::props
