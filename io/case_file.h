// Case files: a scene, the profile it is judged by, how it is drawn, and what was said of it.
#ifndef RASTERPROOF_IO_CASE_FILE_H_
#define RASTERPROOF_IO_CASE_FILE_H_

#include <memory>
#include <string>
#include <string_view>

#include "core/case.h"

namespace rasterproof::io {

/// A case and what it is a counterexample to; `subject` and `property` may be empty.
struct CaseFile {
  Case value;
  std::string subject;
  std::string property;
  /// What the property drew of it, for the reader: the property makes it again of the case.
  std::shared_ptr<const DrawnScene> drawn = nullptr;
  bool states_profile = false;  ///< else value.profile is "real"
};

/// Reads {"rasterproof_case": 2, "scene": {...}, "profile": "real" | {...}, "options": {...},
/// "subject", "property", "origin", "drawn": {"scene", "options"}}, or a bare scene file (then the
/// profile is "real" and the options are the defaults). "-": standard input.
CaseFile ReadCase(const std::string& path);
CaseFile ParseCase(std::string_view text, const std::string& place);
std::string CaseToJson(const CaseFile& file);

/// The profile's name, or one of its own ("gl, changed") where it has a preset's name and another
/// content.
std::string ProfileName(const Profile& profile);

/// The profile as CaseToJson writes it: the name of a preset, or an object with ProfileName.
std::string ProfileToJson(const Profile& profile);

/// The profile that a preset's name or the text of a profile file stands for; `place` names the
/// text in errors.
Profile ParseProfile(const std::string& text_or_preset, const std::string& place);

/// A profile file: a preset's name, or an object whose keys are those that CaseToJson writes under
/// "profile".
Profile ReadProfile(const std::string& path_or_preset);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_CASE_FILE_H_
