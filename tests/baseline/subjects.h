// Every subject that the baseline of verdicts is taken of.
#ifndef RASTERPROOF_TESTS_BASELINE_SUBJECTS_H_
#define RASTERPROOF_TESTS_BASELINE_SUBJECTS_H_

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/subject.h"

namespace rasterproof::baseline {

struct NamedSubject {
  std::string name;
  /// It has a bug: one of hundreds, and fewer cases show it.
  bool is_bug = false;
  /// Makes it afresh, without what wraps it.
  std::function<std::unique_ptr<Subject>()> make;
  /// The one property that it is asked about. Empty: all are.
  std::string_view property = {};
};

/// Built-in methods, models of every output kind, mutants, legal variants, and what the tests of
/// the engines hold. Names are unique.
std::vector<NamedSubject> AllSubjects();

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_SUBJECTS_H_
