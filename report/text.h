// Text that any document can hold, whatever bytes it came from.
#ifndef RASTERPROOF_REPORT_TEXT_H_
#define RASTERPROOF_REPORT_TEXT_H_

#include <cstdint>
#include <string>
#include <string_view>

namespace rasterproof::report {

/// The text as UTF-8 without the characters that XML 1.0 forbids; a byte that is not part of such a
/// character is shown as "\x1b".
std::string CleanText(std::string_view text);

/// CleanText, then & < > " ' as entities: safe as content and as attribute of HTML and XML.
std::string Escaped(std::string_view text);

/// Digits in groups of three, with narrow spaces that don't break: "12 345 678".
std::string Grouped(std::uint64_t number);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_TEXT_H_
