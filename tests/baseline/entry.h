// All that the baseline asks of the suite: properties by name, cases, verdicts. What changes
// beneath changes this one file and recording.cc.
#ifndef RASTERPROOF_TESTS_BASELINE_ENTRY_H_
#define RASTERPROOF_TESTS_BASELINE_ENTRY_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "tests/baseline/recording.h"

namespace rasterproof::baseline {

/// The names of all properties, in the catalogue's order.
std::vector<std::string> PropertyNames();

/// What came of one case.
struct Tried {
  Verdict verdict;
  /// Not empty: no verdict, but a fault of the suite's own.
  std::string fault;
  Record record;  ///< what reached the subject on the way
};

/// One property about one subject, which is made as the command makes it.
class Trials {
 public:
  /// Domain:     a name of PropertyNames(); a subject that nothing wraps.
  Trials(std::unique_ptr<Subject> raw, const std::string& property);
  ~Trials();

  /// The case that a campaign of this seed runs as number `index`.
  ///
  /// Error:      InputError if the subject takes scenes of none of the property's domains.
  Case Draw(std::uint64_t seed, std::uint64_t index) const;
  Tried Try(const Case& c);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace rasterproof::baseline

#endif  // RASTERPROOF_TESTS_BASELINE_ENTRY_H_
