// The ways in which a call to a subject fails: a fault, a hang, a deadline, a refusal.
#ifndef RASTERPROOF_CORE_SUBJECT_ERRORS_H_
#define RASTERPROOF_CORE_SUBJECT_ERRORS_H_

#include <stdexcept>

#include "core/error.h"

namespace rasterproof {

/// A subject that died, hung, wrote where it must not, or answered what is no answer. A finding.
class SubjectFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A subject that was seen to give no answer at all: a finding.
class SubjectHang : public SubjectFault {
 public:
  using SubjectFault::SubjectFault;
};

/// A subject that took longer over a draw than it may: neither a finding nor a pass.
class SubjectTooSlow : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The moment that SetDeadline named came before the answer. It says nothing about the subject.
class SubjectDeadline : public SubjectTooSlow {
 public:
  using SubjectTooSlow::SubjectTooSlow;
};

/// A program that ends by itself over whatever it is asked, before any answer: it does not run, and
/// nothing is found out about it. No case is judged by that: it ends the command.
class SubjectDoesNotRun : public InputError {
 public:
  using InputError::InputError;
};

/// A subject that says that it does not draw this scene.
class SubjectRefusal : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_ERRORS_H_
