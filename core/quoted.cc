#include "core/quoted.h"

namespace rasterproof {

std::string Printable(std::string_view text, std::size_t most) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string printable;
  for (const char c : text.substr(0, most)) {
    if (c >= ' ' && c <= '~') {
      printable += c;
      continue;
    }
    const auto byte = static_cast<unsigned char>(c);
    printable += "\\x";
    printable += kHexDigits[byte >> 4U];
    printable += kHexDigits[byte & 15U];
  }
  return printable + (text.size() > most ? "..." : "");
}

std::string ShownName(std::string_view name) {
  bool has_control = false;
  for (std::size_t k = 0; k < name.size(); ++k) {
    const auto byte = static_cast<unsigned char>(name[k]);
    // U+0080 to U+009F, which are two bytes, begin sequences, too.
    const bool after_c2 = k > 0 && static_cast<unsigned char>(name[k - 1]) == 0xC2;
    has_control |= byte < 0x20 || byte == 0x7F || (after_c2 && byte < 0xA0);
  }
  return has_control ? Printable(name) : std::string(name);
}

std::string Quoted(std::string_view text, std::size_t most) {
  return "\"" + Printable(text, most) + "\"";
}

}  // namespace rasterproof
