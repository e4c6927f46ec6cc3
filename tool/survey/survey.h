// Tells how a rasterizer of somebody else behaves: the model that fits it, and what each
// family of scenes shows of it.
#ifndef RASTERPROOF_TOOL_SURVEY_SURVEY_H_
#define RASTERPROOF_TOOL_SURVEY_SURVEY_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"
#include "tool/survey/families.h"
#include "tool/survey/fit.h"

namespace rasterproof::tool {

struct SurveyOptions {
  std::string path;            ///< a plugin, or the description of a program on a pipe
  std::uint64_t cases = 2000;  ///< scenes of each family
  double seconds = 20;         ///< at most, for each family
  std::uint64_t fitting_triangles = 600;
  std::uint64_t shrink_budget = 400;
};

/// What can be wrong with a drawing.
enum class Fault : std::uint8_t {
  kWrong,  ///< a sample that the fitted model counts otherwise
  kGap,    ///< a sample of a covering mesh that no triangle covers
  kTwice,  ///< a sample of a covering mesh that several triangles cover
  kBatch,  ///< the triangles drawn at once are not the sum of each drawn alone
  kEnd     ///< the process died or hung
};
inline constexpr std::size_t kFaults = 5;

/// Seconds of the subject alone: of a program on a pipe, with the pipe.
struct SubjectTimes {
  double at_once = 0;  ///< each scene as it is
  double alone = 0;    ///< the same triangles once more, one after the other
};

struct FamilyTally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t triangles = 0;
  std::uint64_t samples = 0;
  std::uint64_t wrong = 0;                      ///< samples
  std::uint64_t gaps = 0;                       ///< samples of covering meshes
  std::uint64_t overlaps = 0;                   ///< samples of covering meshes
  std::array<std::uint64_t, kFaults> faulty{};  ///< scenes
  std::array<std::int64_t, kFaults> first{-1, -1, -1, -1, -1};
  SubjectTimes subject_seconds;
  double seconds = 0;  ///< of all
};

struct Counterexample {
  Fault fault = Fault::kWrong;
  Case minimal;
  std::string end;  ///< of the process, for kEnd
};

struct FamilySurvey {
  const Family* family = nullptr;
  FamilyTally tally;
  std::vector<Counterexample> counterexamples;
};

struct Survey {
  std::string subject;
  std::string summary;
  Profile declared;
  std::vector<Fit> fits;  ///< best first; empty if it did not survive the fitting
  std::string trouble;    ///< why there is no survey
  std::vector<FamilySurvey> families;
};

/// Every call of the subject is made in a child process.
///
/// Error:      InputError if the plugin is none.
Survey RunSurvey(const SurveyOptions& options);

std::string SurveyToJson(const Survey& survey);
std::string_view FaultName(Fault fault);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SURVEY_SURVEY_H_
