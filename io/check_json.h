// What was found of properties, as the data that `check` writes: docs/programs.md says what the
// keys mean.
#ifndef RASTERPROOF_IO_CHECK_JSON_H_
#define RASTERPROOF_IO_CHECK_JSON_H_

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/subject_info.h"
#include "core/verdict.h"
#include "io/json_writer.h"

namespace rasterproof::io {

/// A property on one subject. Texts are shown as they are.
struct CheckedProperty {
  const PropertyResult& result;
  std::string message;          ///< of the result
  std::string failure_message;  ///< of its counterexample, if there is one
  std::string scene = {};       ///< the given scene; empty: generated cases
  bool fails = false;           ///< the run fails by it
  bool is_known = false;
  std::string cause = {};  ///< empty: none was found
  std::string next = {};   ///< what runs the failing case again
};

/// Writes an item of `failures`, with the members that `more` adds to it.
///
/// Domain:     a result with a counterexample.
void WriteFailure(JsonWriter& json, const std::string& subject, const SubjectInfo& info,
                  const CheckedProperty& checked, const std::function<void()>& more = {});
/// An item of `causes`.
struct CheckedCause {
  std::string name;
  std::string text;
  std::size_t wrong_scenes = 0;
  bool is_too_few = false;
  std::vector<std::string> properties;
};
void WriteCause(JsonWriter& json, const CheckedCause& cause);
/// Writes an item of `properties`.
void WriteProperty(JsonWriter& json, const CheckedProperty& checked);

/// The verdict with the witness's counts as the subject gave them: without facings if it shows none
/// and the suite added them. Unchanged where only the facing is wrong.
Verdict WithCountsAsGiven(Verdict verdict, const SubjectInfo& info);

/// JSON of several lines as one.
std::string InOneLine(const std::string& json);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_CHECK_JSON_H_
