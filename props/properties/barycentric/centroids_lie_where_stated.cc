// Attributes asked for at a fragment's centroid are evaluated where the profile says.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/centroid_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace centroids_lie_where_stated {

Verdict Judge(const std::vector<CentroidFragment>& fragments) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const CentroidFragment& f : fragments) {
    if (!std::ranges::all_of(f.tolerances, IsStated)) continue;
    const Distance distance = DistanceFromRegion(f);
    if (!distance.within && !HasAPoint(f.region)) continue;
    ++exercised;
    if (!distance.within) {
      const std::array<double, 3>& l = f.barycentrics;
      return BarycentricViolation(
          f.query, -1, exercised, "the centroid of a fragment lies elsewhere than stated",
          {"barycentrics ", l[0], ", ", l[1], ", ", l[2]}, {"those of " + f.region.words});
    }
    worst = std::max(worst, distance.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskCentroids(c, subject, Judge);
}

constexpr std::array kRules{kStatesCentroids};

}  // namespace centroids_lie_where_stated

extern constinit const Property kCentroidsLieWhereStated{
    .name = "CentroidsLieWhereStated",
    .group = "barycentric",
    .clause =
        "Centroid is the pixel's centre or the first covered sample (Direct3D 11.3 section 3.5.5), "
        "or any point of pixel and primitive (OpenGL 4.6 section 15.2; Vulkan 1.3, Interpolation "
        "Decorations); with one sample the centre.",
    .required_by = kCentroidClauses,
    .tolerance =
        "a legal point's barycentrics are within those of FragmentBarycentricsStayWithinTheirError "
        "of the shown ones; none stated: and the point rounded to the subject's format",
    .domains = kCentroids,
    .gate = {.shows = Shows::kCentroids,
             .contract = ContractNeeded::kNone,
             .unwrapped = true,
             .rules = centroids_lie_where_stated::kRules,
             .where = "area not zero; no legal model clips the triangle"},
    .ask = centroids_lie_where_stated::Ask,
};

}  // namespace rasterproof::props
