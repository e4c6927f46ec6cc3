// How a call to a subject ends, as a value.
#ifndef RASTERPROOF_CORE_CALL_END_H_
#define RASTERPROOF_CORE_CALL_END_H_

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "core/error.h"

namespace rasterproof {

/// Why a call gave no answer.
enum class Stop : std::uint8_t {
  kNone,         ///< it gave an answer
  kRefused,      ///< the subject does not draw this scene
  kNotDrawable,  ///< the scene can't be given to it: too large, or not reached by its transform
  kBrokeDown,    ///< it crashed, threw or gave a malformed answer: a finding
  kHung,         ///< it broke down by giving no answer at all: a finding too
  kTooSlow,      ///< it exceeded its time limit: neither a finding nor a pass
  kOutOfMemory,  ///< it exceeded its memory limit: neither a finding nor a pass
  kDeadline      ///< the deadline of SetDeadline passed first: no finding about the subject
};

/// Whether the subject broke down: a finding.
inline bool IsBreakdown(Stop stop) { return stop == Stop::kBrokeDown || stop == Stop::kHung; }
/// Whether a limit ended the call: nothing is known about the draw.
inline bool IsALimit(Stop stop) {
  return stop == Stop::kTooSlow || stop == Stop::kOutOfMemory || stop == Stop::kDeadline;
}
/// Whether jobs that follow in the same call are not drawn.
inline bool EndsTheCall(Stop stop) {
  return stop != Stop::kNone && stop != Stop::kRefused && stop != Stop::kNotDrawable;
}

struct CallEnd {
  Stop stop = Stop::kNone;
  std::string why;  ///< in words, if there was a stop
};

/// A call's end as an exception, for code in a subject and for functions that return an answer.
class SubjectStop : public std::runtime_error {
 public:
  SubjectStop(Stop stop, const std::string& why) : std::runtime_error(why), stop_(stop) {}
  explicit SubjectStop(const CallEnd& end) : SubjectStop(end.stop, end.why) {}
  Stop stop() const { return stop_; }

 private:
  Stop stop_;
};

/// Ends a call with a finding.
[[noreturn]] inline void BreakDown(const std::string& how) {
  throw SubjectStop(Stop::kBrokeDown, how);
}

/// A program exits before its first answer, whatever the request: it does not run here, so there is
/// nothing to judge. The error ends the command; a breakdown in one case is a SubjectStop.
class SubjectDoesNotRun : public InputError {
 public:
  using InputError::InputError;
};

/// Makes a subject's own call and returns how it ended: a SubjectStop names its stop, an InputError
/// is kNotDrawable, and every other exception is the subject's fault.
///
/// Error:      std::bad_alloc, because running out of memory is not a finding. SubjectDoesNotRun.
CallEnd EndOf(const std::function<void()>& call);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CALL_END_H_
