// A case as code or memory words, to be pasted into somebody's own test.
#ifndef RASTERPROOF_REPORT_CASE_CODE_H_
#define RASTERPROOF_REPORT_CASE_CODE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/case.h"

namespace rasterproof::report {

enum class CodeLanguage : std::uint8_t { kCpp, kPython, kTypescript, kReadmemh };

/// The words that an option takes, in the order of the values.
inline constexpr std::array<std::string_view, 4> kCodeLanguages{"cpp", "python", "typescript",
                                                                "readmemh"};

/// Returns the language of this name; nothing if there is none.
std::optional<CodeLanguage> CodeLanguageNamed(std::string_view name);

/// Returns the case's target, vertices and triangles in the language, behind comments: each line of
/// `notes`, then how coordinates are written. Numbers are read back as the same bits. Coordinates
/// that a fixed-point input takes are integers, in units of the input.
///
/// Shape:      of readmemh: 32-bit words (64 where a coordinate takes more) in hexadecimal: width,
///             height, the number of vertices, the number of triangles, the coordinates, the
///             indices.
std::string CaseCode(CodeLanguage language, const Case& c, std::string_view notes);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_CASE_CODE_H_
