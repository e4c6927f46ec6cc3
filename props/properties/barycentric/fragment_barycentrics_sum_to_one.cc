// The barycentrics at a covered sample sum to one.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace fragment_barycentrics_sum_to_one {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : fragments) {
    const std::array<double, 3>& barycentrics = *f.barycentrics;
    const auto& [a, b, d] = f.barycentric_tolerances;
    const double bound = a + b + d;
    if (!IsStated(bound)) continue;
    ++exercised;
    const std::string property = "the barycentrics of a fragment do not sum to one";
    if (!AreFinite(barycentrics)) {
      return FragmentViolation(f, -1, exercised, property, Listed(barycentrics),
                               {"finite barycentrics"});
    }
    const Distance distance = DistanceFromSumOne(barycentrics, bound);
    if (!distance.within) {
      return FragmentViolation(f, -1, exercised, property, Listed(barycentrics),
                               {"a sum of 1 within ", bound});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragments(c, subject, kBarycentricsAlone, Judge);
}

}  // namespace fragment_barycentrics_sum_to_one

extern constinit const Property kFragmentBarycentricsSumToOne{
    .name = "FragmentBarycentricsSumToOne",
    .group = "barycentric",
    .clause =
        "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .required_with_error = kBarycentricErrorClauses,
    .tolerance = "the sum of the three tolerances of FragmentBarycentricsStayWithinTheirError",
    .domains = kFragments,
    .gate = Where(kAsksFragments, kAreaNotZero),
    .ask = fragment_barycentrics_sum_to_one::Ask,
};

}  // namespace rasterproof::props
