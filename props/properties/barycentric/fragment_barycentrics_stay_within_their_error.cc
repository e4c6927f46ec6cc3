// Every barycentric at a covered sample is near the exact one of the visible triangle's vertices,
// as stated.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/exact_comparison.h"
#include "props/judging/fragment_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace fragment_barycentrics_stay_within_their_error {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : fragments) {
    if (!f.owners_are_known) continue;
    const std::array<double, 3>& barycentrics = *f.barycentrics;
    const std::array<exact::Rational, 3> exact_barycentrics = ExactBarycentrics(f.query);
    for (std::size_t i = 0; i < 3; ++i) {
      const double bound = f.barycentric_tolerances[i];
      if (!IsStated(bound)) continue;
      ++exercised;
      const Distance distance = CompareWithExact(barycentrics[i], exact_barycentrics[i], bound);
      if (!distance.within) {
        return FragmentViolation(f, static_cast<int>(i), exercised,
                                 "a barycentric of a fragment is off by more than its error",
                                 BarycentricsText(barycentrics),
                                 exact_barycentrics[i].ToString() + " within " + HexText(bound) +
                                     " for vertex " + std::to_string(i));
      }
      worst = std::max(worst, distance.ratio);
    }
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragments(c, subject, kBarycentricsAlone, Judge);
}

}  // namespace fragment_barycentrics_stay_within_their_error

extern constinit const Property kFragmentBarycentricsStayWithinTheirError{
    .name = "FragmentBarycentricsStayWithinTheirError",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1), by the vertices that the subject names.",
    .tolerance =
        "the stated barycentric error; none stated: the forward bound of the "
        "five-operation quotient, which grows with the triangle's conditioning",
    .domains = kFragments,
    .gate = {.shows = Shows::kFragments,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = fragment_barycentrics_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
