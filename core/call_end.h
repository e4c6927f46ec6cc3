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
  kNone,         ///< it gave one
  kRefused,      ///< the subject does not draw this scene
  kNotDrawable,  ///< it can't be given to it: its own transform takes no vertex there; too large
  kBrokeDown,    ///< it crashed, threw or answered what is no answer: a finding
  kHung,         ///< it broke down by giving no answer at all
  kTooSlow,      ///< it took longer than it may: neither a finding nor a pass
  kDeadline      ///< the moment that SetDeadline named came first, which says nothing about it
};

/// Whether the subject broke down: a finding.
inline bool IsBreakdown(Stop stop) { return stop == Stop::kBrokeDown || stop == Stop::kHung; }
/// Whether jobs that follow in the same call are not drawn.
inline bool EndsTheCall(Stop stop) {
  return stop != Stop::kNone && stop != Stop::kRefused && stop != Stop::kNotDrawable;
}

struct CallEnd {
  Stop stop = Stop::kNone;
  std::string why;  ///< in words, if there was a stop
};

/// A call's end as an exception: inside of a subject, and of what returns an answer or nothing.
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

/// A program that ends by itself over whatever it is asked, before any answer: it does not run, and
/// nothing is found out about it. No case is judged by that: it ends the command.
class SubjectDoesNotRun : public InputError {
 public:
  using InputError::InputError;
};

/// Makes a subject's own call. Whatever it throws is how it ended: a SubjectStop says so itself, an
/// InputError is kNotDrawable, and all else is the subject's fault.
///
/// Error:      std::bad_alloc: memory that ran out is nobody's finding. SubjectDoesNotRun.
CallEnd EndOf(const std::function<void()>& call);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CALL_END_H_
