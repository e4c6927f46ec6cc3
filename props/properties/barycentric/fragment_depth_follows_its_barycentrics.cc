// The depth at a covered sample is what the subject's own barycentrics give from the vertices'
// depths, whether both are asked for or it alone.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace fragment_depth_follows_its_barycentrics {

Verdict Judge(const std::vector<Fragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const Fragment& f : fragments) {
    if (!f.barycentrics) continue;
    double bound = f.depth_tolerance;
    exact::Rational by_barycentrics;
    for (std::size_t i = 0; i < 3; ++i) bound += f.barycentric_tolerances[i] * std::fabs(f.z[i]);
    if (!IsStated(bound)) continue;
    ++exercised;
    const std::string property = "the depth of a fragment is not what its barycentrics give";
    if (!AreFinite(*f.barycentrics)) {
      return FragmentViolation(f, -1, exercised, property, Listed(*f.barycentrics),
                               {"finite barycentrics"});
    }
    for (std::size_t i = 0; i < 3; ++i) {
      by_barycentrics += exact::Rational((*f.barycentrics)[i]) * exact::Rational(f.z[i]);
    }
    const Distance distance = CompareWithExact(f.depth, by_barycentrics, bound);
    if (!distance.within) {
      return FragmentViolation(f, -1, exercised, property, {f.depth},
                               {by_barycentrics.ToDouble(), " within ", bound});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragments(c, subject, kDepthsAlone, Judge);
}

}  // namespace fragment_depth_follows_its_barycentrics

extern constinit const Property kFragmentDepthFollowsItsBarycentrics{
    .name = "FragmentDepthFollowsItsBarycentrics",
    .group = "barycentric",
    .clause =
        "z = a z_a + b z_b + c z_c (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon "
        "Rasterization).",
    .tolerance =
        "the depth's and the barycentrics' tolerances, the latter times the vertices' depths",
    .domains = kFragments,
    .gate = Where(kAsksDepths, kAreaNotZero),
    .ask = fragment_depth_follows_its_barycentrics::Ask,
};

}  // namespace rasterproof::props
