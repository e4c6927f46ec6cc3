// Failures that somebody has taken on, until a day: only new ones fail a run.
#ifndef RASTERPROOF_TOOL_KNOWN_FAILURES_H_
#define RASTERPROOF_TOOL_KNOWN_FAILURES_H_

#include <chrono>
#include <string>
#include <vector>

#include "io/json_document.h"
#include "tool/check/findings.h"

namespace rasterproof::tool {

/// One property that is known to be violated.
struct KnownFailure {
  std::string place;  ///< "known.json: failures[2]"
  std::string property;
  std::string subject;  ///< "": of any
  std::string cause;    ///< of this cause alone (docs/causes.md); "": of any
  std::string owner;
  std::chrono::year_month_day until = {};  ///< the last day on which it counts
};

/// Reads {"rasterproof_known_failures": 1, "failures": [{"property", "owner", "until":
/// "2027-01-31", "subject", "cause"}]}; subject and cause may be left out.
///
/// Error:      InputError with the place: an unknown key, property or cause, a missing key, no
///             date.
std::vector<KnownFailure> ReadKnownFailures(const std::string& path);

/// Whether an entry that is not past its day covers every violation of the property, whatever its
/// cause.
bool IsKnown(const std::vector<KnownFailure>& known, std::chrono::year_month_day today,
             const std::string& subject, const std::string& property);

/// Marks the violations that an entry covers, and adds to the notes what became of the entries:
/// whose violations were met, which passed unexpectedly, and which are past their day. The
/// last fail the run, if their property is one of those found.
///
/// Domain:     `found` has its explanation. An entry with a cause covers nothing of a failure whose
///             cause was not searched.
void ApplyKnownFailures(const std::vector<KnownFailure>& known, std::chrono::year_month_day today,
                        Findings& found);

/// "2027-01-31" as a day.
///
/// Error:      InputError with the value's place.
std::chrono::year_month_day ReadDay(const io::JsonValue& value);
std::string DayText(std::chrono::year_month_day day);
/// The day at Greenwich.
std::chrono::year_month_day Today();

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_KNOWN_FAILURES_H_
