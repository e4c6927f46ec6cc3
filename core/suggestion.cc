#include "core/suggestion.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>

namespace rasterproof {
namespace {

constexpr std::size_t kLongestName = 80;  // far more than any name has
constexpr std::size_t kColumns = 80;
constexpr std::size_t kShort = 48;  // fits on the line of the introducing words

// The number of letters to insert, delete or exchange (Levenshtein), ignoring case.
std::size_t Distance(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t k = 1; k < row.size(); ++k) {
      const std::size_t exchanged = diagonal + (lower(letter) == lower(b[k - 1]) ? 0 : 1);
      diagonal = row[k];
      row[k] = std::min({exchanged, row[k] + 1, row[k - 1] + 1});
    }
  }
  return row.back();
}

std::vector<std::string_view> ViewsOf(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

}  // namespace

std::string Suggestion(std::string_view wrong, const std::vector<std::string_view>& names) {
  if (wrong.size() > kLongestName) return "";
  const auto distance = [&](std::string_view name) { return Distance(wrong, name); };
  const auto nearest = std::ranges::min_element(names, {}, distance);
  if (nearest == names.end()) return "";
  const std::size_t off = distance(*nearest);
  // If every letter must be exchanged, it is not a misspelling.
  if (off > std::max<std::size_t>(wrong.size() / 3, 2) || off >= wrong.size()) return "";
  return "did you mean " + std::string(*nearest) + "? ";
}

std::string Suggestion(std::string_view wrong, const std::vector<std::string>& names) {
  return Suggestion(wrong, ViewsOf(names));
}

std::string ListedNames(const std::vector<std::string_view>& names) {
  std::string line;
  for (const std::string_view name : names) {
    line += line.empty() ? " " : ", ";
    line += name;
  }
  if (line.size() <= kShort) return line;
  std::string text;
  line.clear();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string word = std::string(names[k]) + (k + 1 < names.size() ? "," : "");
    if (!line.empty() && line.size() + 1 + word.size() > kColumns) {
      text += "\n" + line;
      line.clear();
    }
    line += (line.empty() ? "  " : " ") + word;
  }
  return text + "\n" + line;
}

std::string ListedNames(const std::vector<std::string>& names) {
  return ListedNames(ViewsOf(names));
}

}  // namespace rasterproof
