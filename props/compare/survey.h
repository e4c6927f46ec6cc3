// How a subject differs from one model, domain by domain: four yardsticks. Judges nothing.
#ifndef RASTERPROOF_PROPS_COMPARE_SURVEY_H_
#define RASTERPROOF_PROPS_COMPARE_SURVEY_H_

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/comparison.h"
#include "core/profile.h"
#include "core/subject.h"
#include "props/compare/compare.h"

namespace rasterproof::props {

/// What a drawing is compared with: the counts of the model; of a covering mesh, samples that no
/// triangle covers, and those that several do; the sum of calls with each triangle alone.
inline constexpr std::array<std::string_view, 4> kSurveyYardsticks{"nearest model", "gaps",
                                                                   "overlaps", "batch"};

/// A domain that surveys draw from.
struct SurveyedDomain {
  std::string_view name;
  bool near_limits = false;  ///< its vertices reach out to the profile's coordinate limit
};
std::span<const SurveyedDomain> SurveyedDomains();

struct SurveyPlan {
  Profile model;  ///< what the drawings are compared with
  std::uint64_t seed = 1;
  std::uint64_t cases = 2000;  ///< of each domain
  Limits limits = {};          ///< of each domain
};

/// Draws the first cases of the domain, as DOMAIN:INDEX@SEED names them for this subject, and
/// compares each with the model. A cell for each of kSurveyYardsticks.
///
/// A covering mesh is a case of several triangles that cover every sample exactly once under the
/// model with the top-left rule: its gaps and overlaps are no matter of the tie rule. Other cases
/// are excused.
///
/// Domain:     the name of a domain; a model of contract sample-exact, with the stated coordinate
///             limit.
/// Returns:    no cases if the subject takes none of the domain's scenes.
std::vector<Cell> SurveyDomain(Subject& subject, std::string_view domain, const SurveyPlan& plan);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_SURVEY_H_
