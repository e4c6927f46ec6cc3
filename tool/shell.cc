#include "tool/shell.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "report/text.h"

namespace rasterproof::tool {
namespace {

bool IsPlainInAShell(char c) {
  constexpr std::string_view kPlain = "_-+=:,./@%";
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlain.find(c) != kPlain.npos;
}

// Unicode's marks of direction, joiners, line separators and zero widths, by the first bytes that
// they have in common: a few harmless characters beside them are escaped as well.
bool HasUnseenMark(std::string_view word) {
  constexpr std::array<std::string_view, 5> kBegins{"\xE2\x80", "\xE2\x81", "\xEF\xBB\xBF",
                                                    "\xD8\x9C", "\xF3\xA0"};
  return std::ranges::any_of(kBegins,
                             [&](std::string_view begin) { return word.find(begin) != word.npos; });
}

bool ShowsWhatItIs(std::string_view word) {
  return word.find_first_of("\t\n\r") == word.npos && !HasUnseenMark(word) &&
         report::CleanText(word) == word;
}

}  // namespace

std::string ShellWord(std::string_view word) {
  if (!word.empty() && std::ranges::all_of(word, IsPlainInAShell)) return std::string(word);
  if (ShowsWhatItIs(word)) {
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
  }
  // Three octal digits end by themselves; how many digits follow \x is left to each shell.
  std::string quoted = "$'";
  for (const char c : word) {
    if (c == '\'' || c == '\\') {
      quoted += fmt::format("\\{}", c);
    } else if (c >= ' ' && c <= '~') {
      quoted += c;
    } else {
      quoted += fmt::format("\\{:03o}", static_cast<unsigned char>(c));
    }
  }
  return quoted + "'";
}

std::string CommandLine(int argc, char** argv) {
  std::string line = "rasterproof";
  for (int k = 1; k < argc; ++k) line += " " + ShellWord(argv[k]);
  return line;
}

}  // namespace rasterproof::tool
