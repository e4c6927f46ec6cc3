// How a draw that took too long ended, where that is known.
#ifndef RASTERPROOF_CORE_SLOW_SUBJECT_H_
#define RASTERPROOF_CORE_SLOW_SUBJECT_H_

#include "core/subject.h"

namespace rasterproof {

/// A subject that was seen to give no answer at all: a finding.
class SubjectHang : public SubjectFault {
 public:
  using SubjectFault::SubjectFault;
};

/// The moment that SetDeadline named came before the answer. It says nothing about the subject.
class SubjectDeadline : public SubjectTooSlow {
 public:
  using SubjectTooSlow::SubjectTooSlow;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SLOW_SUBJECT_H_
