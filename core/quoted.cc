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

std::string Quoted(std::string_view text, std::size_t most) {
  return "\"" + Printable(text, most) + "\"";
}

}  // namespace rasterproof
