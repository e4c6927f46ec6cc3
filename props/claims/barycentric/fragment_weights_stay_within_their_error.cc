// Every weight at a covered sample is near the exact one of the winner's vertices, as declared.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/fragment_queries.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : fragments) {
    const std::array<exact::Rational, 3> exact_weights = ExactWeights(f.query);
    for (std::size_t i = 0; i < 3; ++i) {
      const double bound = f.weight_tolerances[i];
      if (!Claims(bound)) continue;
      ++exercised;
      const Distance distance = CompareWithExact(f.weights[i], exact_weights[i], bound);
      if (!distance.within) {
        return FragmentViolation(f, static_cast<int>(i), exercised,
                                 "a weight of a fragment is off by more than its error",
                                 WeightsText(f.weights),
                                 exact_weights[i].ToString() + " within " + HexText(bound) +
                                     " for vertex " + std::to_string(i));
      }
      worst = std::max(worst, distance.ratio);
    }
  }
  return Verdict::Held(exercised, worst);
}

Asked Ask(const Case& c, const Description& subject) { return AskFragments(c, subject, Judge); }

}  // namespace

constinit const Property kFragmentWeightsStayWithinTheirError{
    .name = "FragmentWeightsStayWithinTheirError",
    .group = "barycentric",
    .clause =
        "lambda_i is the signed area of the part opposite vertex i over that of the whole "
        "(OpenGL 4.6 section 14.6.1), by the vertices that the subject names.",
    .tolerance =
        "the declared weight error; none declared: the forward bound of the "
        "five-operation quotient, which grows with the triangle's conditioning",
    .domains = kWeights,
    .gate = {.shows = Shows::kFragments,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = Ask,
};

}  // namespace rasterproof::props
