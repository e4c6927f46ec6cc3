// Foreign text in messages: printable, of a bounded length, in quotes.
#ifndef RASTERPROOF_CORE_QUOTED_H_
#define RASTERPROOF_CORE_QUOTED_H_

#include <cstddef>
#include <string>
#include <string_view>

namespace rasterproof {

/// The text in printable ASCII, for a message that shows what somebody else wrote: another byte is
/// written `\xNN`; behind `most` bytes it is cut, and `...` says so.
std::string Printable(std::string_view text, std::size_t most = 160);

/// A name that somebody else gave, as it is shown: unchanged, or Printable() if it has control
/// characters, so that no file speaks to the reader's terminal.
std::string ShownName(std::string_view name);

/// The text of Printable() in quotes.
std::string Quoted(std::string_view text, std::size_t most = 160);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_QUOTED_H_
