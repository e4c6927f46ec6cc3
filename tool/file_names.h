// Names of folders and files that are made from names of subjects, which may be any text.
#ifndef RASTERPROOF_TOOL_FILE_NAMES_H_
#define RASTERPROOF_TOOL_FILE_NAMES_H_

#include <string>
#include <string_view>

namespace rasterproof::tool {

/// The name of one entry of a folder, for a subject's results.
///
/// Domain:     any text: "f32-direct:canonical", "exec:python3 ./p.py", "plugin:../../p.so".
/// Returns:    letters, digits, '-', '_', '+' and '.', the first of them a letter or a digit, at
///             most 100 characters: never a path, never hidden, never an option. A name that is
///             such already stays as it is, with '+' for ':'; others end with 16 digits that stand
///             for all of the name.
/// Properties: different names give different results, chance (2^-64) apart.
std::string FileNameOf(std::string_view subject);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_FILE_NAMES_H_
