// How a subject differs from one model, domain by domain: four yardsticks. Judges nothing.
#ifndef RASTERPROOF_PROPS_COMPARE_SURVEY_H_
#define RASTERPROOF_PROPS_COMPARE_SURVEY_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "core/profile.h"
#include "core/subject.h"
#include "props/compare/compare.h"

namespace rasterproof::props {

/// What can be wrong with a drawing.
enum class Fault : std::uint8_t {
  kWrong,    ///< a sample that the model counts otherwise
  kGap,      ///< a sample of a covering mesh that no triangle covers
  kOverlap,  ///< a sample of a covering mesh that several triangles cover
  kBatch,    ///< one call with all triangles is not what calls with each alone add up to
  kEnd       ///< the subject crashed or hung
};
inline constexpr std::array<std::string_view, 5> kFaultNames{"wrong", "gap", "overlap", "batch",
                                                             "end"};

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
  Limits limits = {};          ///< of each domain without its shrinking
  std::uint64_t shrink_budget = 400;
  double shrink_seconds = 20;  ///< at most, for each finding
};

/// The first case of a domain that shows a fault, shrunk.
struct FaultyCase {
  Fault fault = Fault::kWrong;
  std::string name;  ///< of the drawn case: "covering-fans:17@1"
  Case minimal;      ///< its profile is the model
  std::string end;   ///< how the subject ended, for kEnd
};

struct DomainSurvey {
  std::string_view domain;
  std::uint64_t cases = 0;     ///< drawn by the subject, and compared
  std::uint64_t refused = 0;   ///< by the subject
  std::uint64_t unjudged = 0;  ///< the profile says nothing of them, or the subject was too slow
  std::uint64_t meshes = 0;    ///< cases that are covering meshes
  std::uint64_t triangles = 0;
  std::uint64_t samples = 0;
  std::uint64_t wrong = 0;                                 ///< samples
  std::uint64_t gaps = 0;                                  ///< samples of covering meshes
  std::uint64_t overlaps = 0;                              ///< samples of covering meshes
  std::array<std::uint64_t, kFaultNames.size()> faulty{};  ///< cases, by fault
  std::vector<FaultyCase> findings;                        ///< at most one of each fault
  double subject_seconds = 0;                              ///< each case in one call
  double alone_seconds = 0;  ///< the same triangles again, each in its own call
  double seconds = 0;        ///< of all but shrinking

  std::uint64_t Faulty(Fault fault) const { return faulty[static_cast<std::size_t>(fault)]; }
};

/// Draws the first cases of the domain, as DOMAIN:INDEX@SEED names them for this subject, and
/// compares each with the model.
///
/// A covering mesh is a case of several triangles that cover every sample exactly once under the
/// model with the top-left rule: its gaps and overlaps are no matter of the tie rule.
///
/// Domain:     the name of a domain; a model of contract sample-exact, with the stated coordinate
///             limit.
/// Returns:    no cases if the subject takes none of the domain's scenes.
DomainSurvey SurveyDomain(Subject& subject, std::string_view domain, const SurveyPlan& options);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_SURVEY_H_
