// What check found of one subject, and what is printed of it: the worst first, one screen.
#ifndef RASTERPROOF_TOOL_CHECK_FINDINGS_H_
#define RASTERPROOF_TOOL_CHECK_FINDINGS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/authority.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "props/cause/cause.h"
#include "report/certificate.h"

namespace rasterproof::tool {

/// One property on one subject: over generated cases, or on one given scene. All outputs read it.
struct Finding {
  PropertyResult result;    ///< with the case that failed, what was seen of it and its old name
  std::string place = {};   ///< the given scene; "" of generated cases
  std::string line = {};    ///< its outcome; "" if it does not apply
  std::string replay = {};  ///< the command that runs the case that failed again
  std::optional<std::size_t> cause = {};  ///< its place in Findings::causes
  bool is_known = false;                  ///< a known failure: it fails nothing
  std::string cases = {};                 ///< those drawn, as lines of JSON, for --cases-json
};

/// What was found of one subject.
struct Findings {
  std::string subject;
  FailOn fail_on = FailOn::kStated;
  SubjectInfo info = {};
  std::vector<Finding> all = {};
  std::string notes = {};  ///< of the contract and of known failures
  /// What it shows or takes and no property was asked about, of a run over the whole catalogue.
  std::vector<report::Evidence> unasked = {};
  bool is_contract_untested = false;
  std::size_t not_asked = 0;  ///< properties left out after the first failure
  std::uint64_t expired = 0;  ///< entries of known failures: each of them fails the run
  props::Causes causes = {};  ///< their properties are places in `all`
};

/// Whether the run fails by it.
bool FailsTheRun(const Findings& found, const Finding& finding);

/// The exit status: one violation outweighs all, then what could not be judged. Nothing exercised
/// is no pass.
int StatusOf(const Findings& found);

/// "1 cause", "3 causes".
std::string Counted(std::size_t n, std::string_view one, std::string_view many);

/// "textbook: 38 hold, 7 violated, ...; 1234 cases".
std::string LastLine(const Findings& found);

/// The line of a result. `counts` says over what: "30 cases, exercised 12 times in 9".
std::string OutcomeLine(const PropertyResult& result, FailOn fail_on, const std::string& counts);

/// The violations that fail the run, the first in full and the others in three lines each; then
/// what could not be judged, what lacks quality, and the rest. Of more than a few properties those
/// that hold, are not exercised or do not apply are counted. All in full if `verbose`.
std::string FindingsText(const Findings& found, bool verbose);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_CHECK_FINDINGS_H_
