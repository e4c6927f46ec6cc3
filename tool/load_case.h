// Reads the case that a verb is about, and makes its subject.
#ifndef RASTERPROOF_TOOL_LOAD_CASE_H_
#define RASTERPROOF_TOOL_LOAD_CASE_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/case.h"
#include "core/subject.h"
#include "io/case_file.h"
#include "props/property.h"
#include "tool/case_choice.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {

/// A saved or generated case with the subject and the property it is about.
struct LoadedCase {
  Case value;
  std::unique_ptr<Subject> subject;
  const props::Property* property = nullptr;  ///< nullptr: none was named
  std::string replay;                         ///< the command that loads it again
  /// The file, if it holds a drawing that no subject drew, and no subject is to draw its scene:
  /// then nothing else is set.
  std::optional<io::CaseFile> drawing = std::nullopt;
};
/// A subject that only the file names is one of this program's own: the built-in ones, the oracle,
/// planted bugs and legal variants, the type of kit/main.h. Any other is for the user to name.
///
/// Returns:    the case. `make` makes its subject, if given, in place of the one of the choice's
///             name.
/// Error:      InputError if the choice is of no case or of two, or lacks what its case needs; with
///             the command to type where the file names a subject outside.
LoadedCase LoadCaseOrDrawing(const CaseChoice& choice, std::string_view verb,
                             const SubjectMaker& make = {});
/// The same, of a case that a subject draws.
LoadedCase LoadCase(const CaseChoice& choice, std::string_view verb, const SubjectMaker& make = {});

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_LOAD_CASE_H_
