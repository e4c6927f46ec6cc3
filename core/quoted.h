// Foreign text in messages: printable, of a bounded length, in quotes.
#ifndef RASTERPROOF_CORE_QUOTED_H_
#define RASTERPROOF_CORE_QUOTED_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace rasterproof {

/// Returns the text in printable ASCII, for messages that show foreign text: any other byte becomes
/// `\xNN`; text longer than `most` bytes is cut, and ends with `...`.
std::string Printable(std::string_view text, std::size_t most = 160);

/// Returns a foreign name as messages show it: unchanged, or Printable() if it has control
/// characters, so that no file can control the reader's terminal.
std::string ShownName(std::string_view name);

/// The text of Printable() in quotes.
std::string Quoted(std::string_view text, std::size_t most = 160);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_QUOTED_H_
