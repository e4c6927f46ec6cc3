// The weights at a covered sample sum to one.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/fragment_queries.h"
#include "props/judging/weight_queries.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : fragments) {
    const auto& [a, b, d] = f.weight_tolerances;
    const double bound = a + b + d;
    if (!Claims(bound)) continue;
    ++exercised;
    const std::string claim = "the weights of a fragment do not sum to one";
    if (!AreFinite(f.weights)) {
      return FragmentViolation(f, -1, exercised, claim, WeightsText(f.weights), "finite weights");
    }
    const Distance distance = DistanceFromSumOne(f.weights, bound);
    if (!distance.within) {
      return FragmentViolation(f, -1, exercised, claim, WeightsText(f.weights),
                               "a sum of 1 within " + HexText(bound));
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Asked Ask(const Case& c, const Description& subject) { return AskFragments(c, subject, Judge); }

}  // namespace

constinit const Property kFragmentWeightsSumToOne{
    .name = "FragmentWeightsSumToOne",
    .group = "barycentric",
    .clause =
        "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
    .tolerance = "the sum of the three tolerances of FragmentWeightsStayWithinTheirError",
    .domains = kWeights,
    .gate = {.shows = Shows::kFragments,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = Ask,
};

}  // namespace rasterproof::props
