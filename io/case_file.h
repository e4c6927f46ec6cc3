// Case files: a scene, the profile it is judged by, its options, and the property that failed.
#ifndef RASTERPROOF_IO_CASE_FILE_H_
#define RASTERPROOF_IO_CASE_FILE_H_

#include <memory>
#include <string>
#include <string_view>

#include "core/case.h"

namespace rasterproof::io {

/// A case and the property it is a counterexample to; `subject` and `property` may be empty.
struct CaseFile {
  Case value;
  std::string subject;
  std::string property;
  /// The scene that the property drew, for the reader: the property derives it from the case again.
  std::shared_ptr<const DrawnScene> drawn = nullptr;
  bool states_profile = false;  ///< else value.profile is "real"
};

/// Reads {"rasterproof_case": 2, "scene": {...}, "profile": "real" | {...}, "options": {...},
/// "subject", "property", "origin", "drawn": {"scene", "options"}}, or a bare scene file (then the
/// profile is "real" and the options are the defaults). "-": standard input.
CaseFile ReadCase(const std::string& path);
CaseFile ParseCase(std::string_view text, const std::string& place);
std::string CaseToJson(const CaseFile& file);

/// The profile's name, or another one ("gl, changed") if it has a preset's name but differs from
/// the preset.
std::string ProfileName(const Profile& profile);

/// The profile as CaseToJson writes it: the name of a preset, or an object with ProfileName.
std::string ProfileToJson(const Profile& profile);

/// The profile of a preset's name or of the text of a profile file; `place` names the text in
/// errors.
Profile ParseProfile(const std::string& text_or_preset, const std::string& place);

/// A profile file: a preset's name, or an object whose keys are those that CaseToJson writes under
/// "profile".
Profile ReadProfile(const std::string& path_or_preset);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_CASE_FILE_H_
