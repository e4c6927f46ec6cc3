// The depth at a sample in the closed triangle lies between its vertices' least and greatest.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace fragment_depth_stays_in_the_hull {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  for (const Fragment& f : fragments) {
    if (!f.query.inside || !IsStated(f.depth_tolerance)) continue;
    ++exercised;
    const auto [low, high] = std::minmax({f.z[0], f.z[1], f.z[2]});
    // The nearest depth of the hull; NaN has none, and is within of nothing.
    const double nearest = std::isfinite(f.depth) ? std::clamp(f.depth, low, high) : low;
    if (CompareWithExact(f.depth, exact::Rational(nearest), f.depth_tolerance).within) continue;
    return FragmentViolation(f, -1, exercised, "the depth of a fragment leaves the hull", {f.depth},
                             {"a depth of [", low, ", ", high, "] within ", f.depth_tolerance});
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragments(c, subject, kDepthsAlone, Judge);
}

}  // namespace fragment_depth_stays_in_the_hull

extern constinit const Property kFragmentDepthStaysInTheHull{
    .name = "FragmentDepthStaysInTheHull",
    .group = "barycentric",
    .clause = "Inside, a depth is a convex combination of the vertices' depths.",
    .required_with_error = kDepthErrorClauses,
    .tolerance = kDepthTolerance,
    .domains = kFragments,
    .gate = Where(kAsksDepths, "samples in the closed triangle of the vertices that it names"),
    .ask = fragment_depth_stays_in_the_hull::Ask,
};

}  // namespace rasterproof::props
