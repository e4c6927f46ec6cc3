// One way of drawing against one subject: cases and time to the first violation.
#ifndef RASTERPROOF_TESTS_GENERATORS_RACE_H_
#define RASTERPROOF_TESTS_GENERATORS_RACE_H_

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/subject.h"
#include "props/property.h"
#include "tests/generators/case_streams.h"

namespace rasterproof::generators {

/// What judges every case, whoever drew it, as far as it applies to the subject.
std::span<const std::string_view> JudgingProperties();
/// Those of the names that apply to the subject.
///
/// Error:      InputError if there is no such property.
std::vector<const props::Property*> Applicable(Subject& subject,
                                               std::span<const std::string_view> names);

struct Race {
  std::uint64_t cases = 0;
  std::uint64_t violating = 0;  ///< cases that violate a property
  std::optional<std::uint64_t> cases_to_first;
  std::optional<double> seconds_to_first;
  double seconds = 0;
};

/// Draws and judges until one case is violated and `least` seconds have passed, or after `cap`.
///
/// Units:      seconds of this process on all cores, drawing, judging and the subject together.
Race RunRace(Subject& subject, const std::vector<const props::Property*>& properties,
             CaseStream& cases, double cap, double least);

/// Cases whose counts are not the oracle's.
struct Wrong {
  std::uint64_t cases = 0;  ///< that the profile's model speaks of
  std::uint64_t wrong = 0;
};

/// Compares so many of the cases, or as many as the time allows, with exact coverage.
Wrong CountWrong(Subject& subject, CaseStream& cases, std::uint64_t count, double cap);

}  // namespace rasterproof::generators

#endif  // RASTERPROOF_TESTS_GENERATORS_RACE_H_
