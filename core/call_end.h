// How a call to a subject ends.
#ifndef RASTERPROOF_CORE_CALL_END_H_
#define RASTERPROOF_CORE_CALL_END_H_

#include <functional>
#include <string>

#include "core/question.h"

namespace rasterproof {

struct CallEnd {
  Stop stop = Stop::kNone;
  std::string why;  ///< in words, if there was a stop
};

/// Makes a subject's own call. Whatever it throws is how it ended: a type of somebody else's may
/// throw anything, and what is no word of Subject's is its fault.
///
/// Error:      std::bad_alloc: memory that ran out is nobody's finding. SubjectDoesNotRun.
CallEnd EndOf(const std::function<void()>& call);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_CALL_END_H_
