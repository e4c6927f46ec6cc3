// How far what builds draw is from the model of the profile that their sources state.
#ifndef RASTERPROOF_TOOL_SWEEP_SWEEP_MODEL_H_
#define RASTERPROOF_TOOL_SWEEP_SWEEP_MODEL_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/drawing.h"
#include "core/subject_info.h"
#include "legal/allowed.h"
#include "props/placed_case.h"
#include "tool/sweep/sweep_runner.h"

namespace rasterproof::tool {

/// What a profile lets one call with all of a case show, sample by sample (legal/allowed.h). It
/// convicts less than `check`, which asks one model to explain all samples.
class ModelOfCase {
 public:
  /// Culling and scissor are off, as they are when builds are swept.
  ModelOfCase(const SubjectInfo& info, const Case& given);

  /// Empty: the case is judged.
  const std::string& why_not() const { return why_not_; }
  /// How many samples the drawing has as the profile does not let them be.
  ///
  /// Domain:     a case that is judged, drawn in one call.
  std::uint64_t Away(const Drawing& drawn) const;

 private:
  std::string why_not_;
  std::optional<legal::Allowed> allowed_;
};

struct DistanceFromModel {
  std::uint64_t samples = 0;  ///< of the cases that are judged
  std::uint64_t cases = 0;
  std::uint64_t samples_away = 0;
  std::uint64_t cases_away = 0;
  std::uint64_t cases_not_judged = 0;
  std::string why_not;  ///< of the first case that is not judged
};

/// The distance of a case's drawing, given by what it changes of the base's, or nothing of a case
/// that this build or the base refuses; added to `sum`.
void AddDistance(const SweepRunner& runner, std::size_t number, const ModelOfCase& model,
                 const SweepOutcome& outcome, DistanceFromModel& sum);

/// "0 of 51200 samples away from the model, in 0 of 200 cases", and what is not judged.
std::string DistanceText(const DistanceFromModel& distance);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SWEEP_SWEEP_MODEL_H_
