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
#include "core/case.h"
#include "core/profile.h"
#include "core/result.h"
#include "core/verdict.h"
#include "props/cause/cause.h"
#include "props/cause/evidence.h"
#include "report/certificate.h"

namespace rasterproof::tool {

/// The case that a property failed on, and how it is shown.
struct FailureShown {
  Case value;
  Verdict verdict;
  std::string text;           ///< in full: scene, picture, edge values, the command
  std::string brief;          ///< two lines: where it failed, and the command
  std::string replay;         ///< the command that runs this case again
  std::string drawn_as = {};  ///< name of the case before it was shrunk; "" if it has none
  std::optional<props::FailedProperty> failed = {};  ///< for its cause

  /// Says which drawn case it was shrunk from.
  void AddName(const std::string& name);
};

/// One property on one subject: over generated cases, or on one given scene.
struct Finding {
  PropertyResult result;
  std::string place = {};  ///< the given scene; "" of generated cases
  std::string line = {};   ///< its outcome; "" if it does not apply
  std::optional<FailureShown> failure = {};
  bool is_known = false;  ///< a known failure: it fails nothing
};

/// What was found of one subject.
struct Findings {
  std::string subject;
  FailOn fail_on = FailOn::kStated;
  Profile profile = {};
  std::vector<Finding> all = {};
  std::string notes = {};  ///< of the contract and of known failures
  /// What it shows or takes and no property was asked about, of a run over the whole catalogue.
  std::vector<report::Evidence> unasked = {};
  std::string cases = {};  ///< for --cases-json
  bool is_contract_untested = false;
  std::size_t not_asked = 0;  ///< properties left out after the first failure
  std::uint64_t expired = 0;  ///< entries of known failures: each of them fails the run
  props::Explanation explanation = {};
  std::vector<std::size_t> explained = {};  ///< the findings that it is about, by their places
  std::string stated_name = {};             ///< SubjectInfo::stated_name
};

/// Whether the run fails by it.
bool FailsTheRun(const Findings& found, const Finding& finding);

/// What explains the finding of that place; nullptr: nothing was looked for.
const props::Cause* CauseOf(const Findings& found, std::size_t finding);

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
