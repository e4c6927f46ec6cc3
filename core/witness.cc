#include "core/witness.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <variant>

namespace rasterproof {
namespace {

struct PartText {
  std::string operator()(const std::string& words) const { return words; }
  std::string operator()(FacingCounts counts) const {
    return "front " + std::to_string(counts.front) + ", back " + std::to_string(counts.back);
  }
  std::string operator()(CountSet counts) const {
    std::string text;
    for (int n = 0; n < 64; ++n) {
      if ((counts.bits >> n & 1U) != 0) text += (text.empty() ? "" : " or ") + std::to_string(n);
    }
    return text;
  }
  std::string operator()(std::int64_t integer) const { return std::to_string(integer); }
  std::string operator()(double number) const { return HexText(number); }
  std::string operator()(const RationalText& rational) const { return rational.text; }
};

}  // namespace

std::string HexText(double x) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  // A library in this process may have called setlocale(LC_ALL, "").
  std::ranges::replace(text, ',', '.');
  return text.data();
}

std::string TextOfValue(const WitnessValue& value) {
  std::string text;
  for (const WitnessPart& part : value) text += std::visit(PartText{}, part);
  return text;
}

}  // namespace rasterproof
