#include "report/text.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fmt/format.h"

namespace rasterproof::report {
namespace {

std::uint32_t Byte(std::string_view text, std::size_t k) {
  return static_cast<unsigned char>(text[k]);
}

// Number of bytes of the well-formed UTF-8 character that `text` begins with, its code in `code`; 0
// if it begins with none. Overlong forms and surrogates are not well formed (RFC 3629).
std::size_t DecodeCharacter(std::string_view text, std::uint32_t& code) {
  constexpr std::uint32_t kLeast[5] = {0, 0, 0x80, 0x800, 0x10000};
  const std::uint32_t lead = Byte(text, 0);
  const std::size_t length = lead < 0x80       ? 1
                             : lead >> 5 == 6  ? 2
                             : lead >> 4 == 14 ? 3
                             : lead >> 3 == 30 ? 4
                                               : 0;
  if (length == 0 || length > text.size()) return 0;
  code = length == 1 ? lead : lead & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if (Byte(text, k) >> 6 != 2) return 0;
    code = code << 6 | (Byte(text, k) & 0x3F);
  }
  const bool surrogate = code >= 0xD800 && code < 0xE000;
  return code < kLeast[length] || code > 0x10FFFF || surrogate ? 0 : length;
}

// Char of XML 1.0, less the C1 controls and DEL, which are allowed there but show nothing.
bool IsShown(std::uint32_t code) {
  if (code < 0x20) return code == '\t' || code == '\n' || code == '\r';
  return (code < 0x7F || code >= 0xA0) && code != 0xFFFE && code != 0xFFFF;
}

}  // namespace

std::string CleanText(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  while (!text.empty()) {
    std::uint32_t code = 0;
    std::size_t length = DecodeCharacter(text, code);
    if (length != 0 && IsShown(code)) {
      clean += text.substr(0, length);
    } else {
      if (length == 0) length = 1;
      for (std::size_t k = 0; k < length; ++k) clean += fmt::format("\\x{:02x}", Byte(text, k));
    }
    text.remove_prefix(length);
  }
  return clean;
}

std::string Escaped(std::string_view text) {
  std::string escaped;
  for (const char c : CleanText(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string Grouped(std::uint64_t number) {
  const std::string digits = fmt::format("{}", number);
  std::string grouped;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k != 0 && (digits.size() - k) % 3 == 0) grouped += "\u202f";
    grouped += digits[k];
  }
  return grouped;
}

}  // namespace rasterproof::report
