// Case files: a scene, the profile it is judged by, its options, and the property that failed.
#ifndef RASTERPROOF_IO_CASE_FILE_H_
#define RASTERPROOF_IO_CASE_FILE_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"

namespace rasterproof::io {

/// What the numbers of a CaseDrawing say of each sample.
enum class DrawingShows : std::uint8_t {
  kCounts,  ///< how many triangles cover it
  kMask,    ///< 1 where any does
  kIds      ///< 1 + the number of the triangle that is visible; 0: none
};

/// What some program drew of a case's scene.
///
/// Shape:      both as CoverageCounts::front.
struct CaseDrawing {
  DrawingShows shows = DrawingShows::kCounts;
  std::string visible = "any";  ///< of kIds: "any", "last" or "first" of those that cover a sample
  std::vector<std::uint32_t> numbers;
  std::vector<std::uint32_t> fronts;  ///< how many of these are front-facing; empty: not known

  friend bool operator==(const CaseDrawing&, const CaseDrawing&) = default;
};

/// A case and the property it is a counterexample to; `subject` and `property` may be empty.
struct CaseFile {
  Case value;
  std::string subject;
  std::string property;
  /// The scene that the property drew, for the reader: the property derives it from the case again.
  std::shared_ptr<const DrawnScene> drawn = nullptr;
  bool states_profile = false;  ///< else value.profile is "real"
  /// The drawing to judge instead of a subject's.
  std::optional<CaseDrawing> drawing = std::nullopt;
};

/// Reads {"rasterproof_case": 2, "scene": {...}, "profile": "real" | {...}, "options": {...},
/// "subject", "property", "origin", "drawn": {"scene", "options"}, "drawing": {"shows": "counts" |
/// "mask" | "ids", "visible", "numbers": [[...]], "fronts": [[...]]}}, or a bare scene file (then
/// the profile is "real" and the options are the defaults). "-": standard input.
///
/// Error:      InputError with the place. How many numbers a row of a drawing has is not checked,
///             but that all have as many.
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
