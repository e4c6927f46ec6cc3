#include "report/explanation_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/witness.h"
#include "fmt/format.h"

namespace rasterproof::report {
namespace {

// Stops of cividis. Source: Nunez, Anderton and Renslow, PLoS ONE 13(7), 2018.
constexpr std::array<Colour, 5> kSequence{
    {{0, 34, 78}, {65, 77, 107}, {124, 123, 120}, {188, 174, 108}, {254, 232, 56}}};
constexpr Colour kWithin{232, 235, 239};  // as a sample that is right
// Beyond this many units every difference is as loud as can be.
constexpr double kLoudest = 1e4;

// -1 below the scale, 2 above it, else the part of it.
double PartOf(const NumberScale& scale, double number) {
  const double slack = 1e-6 * (scale.high - scale.low);
  if (number < scale.low - slack) return -1;
  if (number > scale.high + slack) return 2;
  return std::clamp((number - scale.low) / (scale.high - scale.low), 0.0, 1.0);
}

}  // namespace

const ComparedNumber* NumberAt(const Explanation& explanation, int x, int y, int sample) {
  if (!explanation.numbers) return nullptr;
  for (const ComparedNumber& n : explanation.numbers->list) {
    if (n.x == x && n.y == y && n.sample == sample) return &n;
  }
  return nullptr;
}

const ComparedNumber* NumberAt(const Explanation& explanation, int x, int y) {
  const ComparedNumber* worst = nullptr;
  if (!explanation.numbers) return nullptr;
  for (const ComparedNumber& n : explanation.numbers->list) {
    if (n.x != x || n.y != y) continue;
    // What is no number is farther than all.
    if (worst == nullptr || !(std::fabs(n.off) <= std::fabs(worst->off))) worst = &n;
  }
  return worst;
}

NumberScale ScaleOf(const ComparedNumbers& numbers) {
  NumberScale scale{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (const ComparedNumber& n : numbers.list) {
    if (!std::isfinite(n.expected)) continue;
    scale.low = std::min(scale.low, n.expected);
    scale.high = std::max(scale.high, n.expected);
  }
  if (!(scale.low <= scale.high)) return {};
  // One number, or equal ones: what is shown of them lies on one side or the other.
  const double least = 1e-6 * std::max(std::fabs(scale.low), std::fabs(scale.high));
  if (!(scale.high - scale.low > least)) {
    const double middle = scale.low + (scale.high - scale.low) / 2;
    const double half = least > 0 ? least : 1;
    scale = {middle - half, middle + half};
  }
  return scale;
}

Colour NumberColour(const NumberScale& scale, double number) {
  if (std::isnan(number)) return kPurple;
  const double part = PartOf(scale, number);
  if (part < 0) return kInk;
  if (part > 1) return kVermilion;
  const double at = part * static_cast<double>(kSequence.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(at), kSequence.size() - 2);
  return Mix(kSequence[stop], kSequence[stop + 1], at - static_cast<double>(stop));
}

Colour OffColour(double off) {
  if (std::isnan(off)) return kPurple;
  const double size = std::fabs(off);
  if (size <= 1) return kWithin;
  const double part = std::min(std::log(size) / std::log(kLoudest), 1.0);
  return Mix(kWithin, off < 0 ? kBlue : kVermilion, 0.35 + 0.65 * part);
}

char NumberCharacter(const NumberScale& scale, double number) {
  if (std::isnan(number)) return '?';
  const double part = PartOf(scale, number);
  if (part < 0) return '<';
  if (part > 1) return '>';
  return static_cast<char>('0' + std::min(static_cast<int>(part * 10), 9));
}

char OffCharacter(double off) {
  if (std::isnan(off)) return '?';
  return std::fabs(off) <= 1 ? '.' : off < 0 ? '-' : '+';
}

std::string OffText(double off) {
  const double size = std::fabs(off);
  if (std::isnan(off)) return "?";
  if (std::isinf(off)) return "inf";
  if (size < 9.95) return fmt::format("{:.1f}", off);
  if (size < 999.5) return fmt::format("{:.0f}", off);
  const int power = static_cast<int>(std::floor(std::log10(size)));
  return fmt::format("{}1e{}", off < 0 ? "-" : "", power);
}

std::string ShortNumber(double number) { return fmt::format("{:.6g}", number); }

std::string UnitsText(const ComparedNumbers& numbers, double off) {
  const std::string size = fmt::format("{:.3g}", std::fabs(off));
  if (!std::isfinite(off)) return "beyond all that is allowed";
  return size + (numbers.is_in_ulps
                     ? size == "1" ? " ulp, where none is allowed" : " ulps, where none is allowed"
                     : " times what is allowed");
}

std::vector<std::string> NumberLines(const ComparedNumbers& numbers) {
  const ComparedNumber& n = numbers.list.front();
  std::vector<std::string> lines;
  lines.push_back(
      fmt::format("{}: shown {} ({}), exact {} ({}){}", numbers.what, ShortNumber(n.observed),
                  HexText(n.observed), ShortNumber(n.expected), HexText(n.expected),
                  numbers.is_in_ulps ? ", to the bit" : ", allowed " + ShortNumber(n.allowed)));
  lines.push_back(fmt::format("off by {}, at pixel ({}, {}), sample {}", UnitsText(numbers, n.off),
                              n.x, n.y, n.sample));
  const auto wrong = std::ranges::count_if(
      numbers.list, [](const ComparedNumber& one) { return !(std::fabs(one.off) <= 1); });
  if (!numbers.is_in_ulps && numbers.list.size() > 1) {
    lines.push_back(fmt::format("of {} samples of the triangle around it {} are off by more",
                                numbers.list.size(), wrong));
  }
  return lines;
}

}  // namespace rasterproof::report
