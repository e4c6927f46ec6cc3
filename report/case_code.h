// Cases and arrays of numbers as code, to be pasted into somebody's own test.
#ifndef RASTERPROOF_REPORT_CASE_CODE_H_
#define RASTERPROOF_REPORT_CASE_CODE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/case.h"

namespace rasterproof::report {

enum class CodeLanguage : std::uint8_t { kCpp, kPython, kTypescript, kReadmemh };

/// The words that an option takes, in the order of the values.
inline constexpr std::array<std::string_view, 4> kCodeLanguages{"cpp", "python", "typescript",
                                                                "readmemh"};

/// Returns the language of this name; nothing if there is none.
std::optional<CodeLanguage> CodeLanguageNamed(std::string_view name);

/// What begins a line of comment: "// ".
std::string_view CommentOf(CodeLanguage language);

/// A row of numbers, as the language writes them.
using CodeRow = std::vector<std::string>;

/// Returns the definition of a constant array of rows: `constexpr TYPE kName[][COLUMNS]` in C++, a
/// list of tuples `name` in Python, `const name: number[][]` in TypeScript.
///
/// Domain:     not readmemh; a name in lower case; rows of `columns` numbers.
std::string ArrayAsCode(CodeLanguage language, std::string_view name, std::string_view type,
                        std::size_t columns, const std::vector<CodeRow>& rows);

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
