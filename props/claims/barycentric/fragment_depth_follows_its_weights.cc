// The depth at a covered sample is what the subject's own weights give from the vertices' depths.
#include <algorithm>
#include <cmath>
#include <cstddef>
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
    double bound = f.depth_tolerance;
    exact::Rational by_weights;
    for (std::size_t i = 0; i < 3; ++i) bound += f.weight_tolerances[i] * std::fabs(f.z[i]);
    if (!Claims(bound)) continue;
    ++exercised;
    const std::string claim = "the depth of a fragment is not what its weights give";
    if (!AreFinite(f.weights)) {
      return FragmentViolation(f, -1, exercised, claim, WeightsText(f.weights), "finite weights");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      by_weights += exact::Rational(f.weights[i]) * exact::Rational(f.z[i]);
    }
    const Distance distance = CompareWithExact(f.depth, by_weights, bound);
    if (!distance.within) {
      return FragmentViolation(f, -1, exercised, claim, HexText(f.depth),
                               HexText(by_weights.ToDouble()) + " within " + HexText(bound));
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Asked Ask(const Case& c, const Description& subject) { return AskFragments(c, subject, Judge); }

}  // namespace

constinit const Property kFragmentDepthFollowsItsWeights{
    .name = "FragmentDepthFollowsItsWeights",
    .group = "barycentric",
    .clause =
        "z = a z_a + b z_b + c z_c (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon "
        "Rasterization).",
    .tolerance = "the depth's and the weights' tolerances, the latter times the vertices' depths",
    .domains = kWeights,
    .gate = {.shows = Shows::kFragments,
             .promise = Promise::kNone,
             .unwrapped = true,
             .where = kAreaNotZero},
    .ask = Ask,
};

}  // namespace rasterproof::props
