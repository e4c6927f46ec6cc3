// Words of files, options and interfaces that were replaced before the first release.
#ifndef RASTERPROOF_IO_RENAMED_H_
#define RASTERPROOF_IO_RENAMED_H_

#include <string>
#include <string_view>

namespace rasterproof::io {

/// Returns the text that follows an unknown word in an error message: ", which is NEW now" for a
/// word that was replaced, else nothing.
std::string RenamedText(std::string_view word);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_RENAMED_H_
