#include "tool/file_names.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/hash_text.h"

namespace rasterproof::tool {
namespace {

constexpr std::size_t kLongestReadable = 80;

// Not the locale's letters: these.
bool IsLetterOrDigit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool IsPlain(char c) { return IsLetterOrDigit(c) || c == '-' || c == '_' || c == '.'; }

// What a name that stays readable may not look like: one that was made.
bool EndsLikeMade(std::string_view name) {
  constexpr std::size_t kDigits = 16;
  if (name.size() <= kDigits || name[name.size() - kDigits - 1] != '-') return false;
  return std::ranges::all_of(name.substr(name.size() - kDigits), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
  });
}

}  // namespace

std::string FileNameOf(std::string_view subject) {
  std::string readable;
  bool is_plain = !subject.empty() && IsLetterOrDigit(subject.front());
  for (const char c : subject) {
    is_plain = is_plain && (IsPlain(c) || c == ':');
    const char shown = IsPlain(c) ? c : c == ':' ? '+' : '_';
    if (shown != '_' || !readable.ends_with('_')) readable += shown;
  }
  is_plain = is_plain && readable.size() == subject.size() && !EndsLikeMade(subject);
  if (is_plain && readable.size() <= kLongestReadable) return readable;
  // The end of a path or of a command tells more than its beginning.
  if (readable.size() > kLongestReadable) readable.erase(0, readable.size() - kLongestReadable);
  readable.erase(0, std::min(readable.size(), static_cast<std::size_t>(
                                                  std::ranges::find_if(readable, IsLetterOrDigit) -
                                                  readable.begin())));
  return readable + (readable.empty() ? "" : "-") + HashText(subject);
}

}  // namespace rasterproof::tool
