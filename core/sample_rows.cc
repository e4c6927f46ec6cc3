#include "core/sample_rows.h"

#include <algorithm>

namespace rasterproof {
namespace {

constexpr std::string_view kHexDigits = "0123456789abcdef";

// -1: none.
int ValueOfHexDigit(char letter) {
  if (letter >= 'A' && letter <= 'F') letter = static_cast<char>(letter - 'A' + 'a');
  const std::size_t value = kHexDigits.find(letter);
  return value == std::string_view::npos ? -1 : static_cast<int>(value);
}

}  // namespace

std::string RowOf(const std::vector<std::size_t>& samples, std::size_t row,
                  std::size_t row_length) {
  std::vector<unsigned> digits((row_length + 3) / 4);
  for (auto s = std::ranges::lower_bound(samples, row * row_length);
       s != samples.end() && *s < (row + 1) * row_length; ++s) {
    const std::size_t bit = *s - row * row_length;
    digits[digits.size() - 1 - bit / 4] |= 1U << (bit % 4);
  }
  std::string text;
  for (const unsigned digit : digits) text += kHexDigits[digit];
  return text;
}

SampleRows RowsOf(const std::vector<std::size_t>& samples, std::size_t row_length) {
  SampleRows rows;
  if (samples.empty()) return rows;
  rows.top = samples.front() / row_length;
  for (std::size_t row = rows.top; row <= samples.back() / row_length; ++row)
    rows.rows.push_back(RowOf(samples, row, row_length));
  return rows;
}

std::string_view AddRow(std::string_view digits, std::size_t row, std::size_t row_length,
                        std::vector<std::size_t>& samples) {
  if (digits.empty()) return "is empty";
  for (std::size_t k = 0; k < digits.size(); ++k) {
    const int value = ValueOfHexDigit(digits[digits.size() - 1 - k]);
    if (value < 0) return "has a character that is not a hexadecimal digit";
    for (std::size_t bit = 0; bit < 4; ++bit) {
      if ((static_cast<unsigned>(value) >> bit & 1U) == 0) continue;
      if (4 * k + bit >= row_length) return "has a bit beyond the target's last column";
      samples.push_back(row * row_length + 4 * k + bit);
    }
  }
  return "";
}

}  // namespace rasterproof
