// One property on one case, and what the subject did beside answering.
#ifndef RASTERPROOF_PROPS_RUN_TRIAL_H_
#define RASTERPROOF_PROPS_RUN_TRIAL_H_

#include <cstdint>
#include <stdexcept>

#include "core/call_end.h"
#include "core/case.h"
#include "core/result.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/property.h"

namespace rasterproof::props {

/// What came of one case.
struct Trial {
  Verdict verdict;
  /// How a call to the subject ended, if that is what the verdict says.
  Stop stop = Stop::kNone;
  /// Of the checks that put the property to the test.
  DrawsJudged draws = {};
};

/// A fault of ours, met while a property was judged: the message says of which property and case.
/// What the subject's own calls throw is none.
class JudgingFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether a violation is traced to the triangle that causes it, which takes more draws.
enum class Blaming : std::uint8_t { kNobody, kWhoItWas };

/// Runs the property on the case.
///
/// Returns:    what the property says; kRefused if the subject refused a scene of it, kViolated if
///             it broke down over one, kInconclusive if it took longer than it may, and
///             kNotApplicable if the gate says so, or the scene can't be put to the subject.
/// Error:      JudgingFault; SubjectDoesNotRun.
Trial TryCase(Subject& subject, const Property& property, const Case& c,
              Blaming blaming = Blaming::kNobody);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_TRIAL_H_
