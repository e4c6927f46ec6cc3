// Words of files, options and interfaces that were replaced before the first release.
#ifndef RASTERPROOF_CORE_RENAMED_H_
#define RASTERPROOF_CORE_RENAMED_H_

#include <string>
#include <string_view>

namespace rasterproof {

/// Returns the text that follows an unknown word in an error message: ", which is NEW now" for a
/// word that was replaced, else nothing.
std::string RenamedText(std::string_view word);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_RENAMED_H_
