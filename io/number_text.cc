#include "io/number_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "core/from_chars.h"

namespace rasterproof::io {
namespace {

constexpr std::string_view kWriteHex =
    "write a hex float such as \"0x1.8p+3\", or \"inf\", "
    "\"-inf\", \"nan\"";

// Exponents beyond this are all alike, and sums of two of them fit easily. Texts are shorter than
// 2^32 digits, so digits can't bring such an exponent back into range.
constexpr std::int64_t kHugeExponent = std::int64_t{1} << 40;

// The value of [+-]digits, kept within +-kHugeExponent; nothing if that is not what it is.
std::optional<std::int64_t> ExponentOf(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty()) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = std::min(value * 10 + (c - '0'), kHugeExponent);
  }
  return negative ? -value : value;
}

// Whether a non-zero decimal is at least 1. Enough to tell overflow from underflow.
bool IsLarge(std::string_view text) {
  const std::size_t e = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, e);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.find_first_of("123456789");
  // The leading digit has barycentric 10^order.
  const std::int64_t order = first < point ? static_cast<std::int64_t>(point - first) - 1
                                           : -static_cast<std::int64_t>(first - point);
  const std::int64_t exponent =
      e == std::string_view::npos ? 0 : ExponentOf(text.substr(e + 1)).value_or(0);
  return order + exponent >= 0;
}

template <class T>
NumberFromText Nearest(std::string_view text) {
  T value = 0;
  const auto [end, status] = FromChars(text.data(), text.data() + text.size(), value);
  if (status == std::errc::result_out_of_range) {
    if (IsLarge(text)) return {0, "rounds to infinity", "write \"inf\" if infinity is meant"};
    value = text.starts_with('-') ? T{-0.0} : T{0};
  } else if (status != std::errc{} || end != text.data() + text.size()) {
    return {0, "is not a number", "write a JSON number"};
  }
  return {static_cast<double>(value), {}, {}};
}

int HexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// A number mantissa * 2^exponent; `wide` if the mantissa needs more than 64 bits.
struct Binary {
  std::uint64_t mantissa = 0;
  std::int64_t exponent = 0;
  bool wide = false;

  void Append(int digit) {
    if (wide || (mantissa >> 60) != 0) {
      // Only zeros may follow a full mantissa without making it wider.
      wide = wide || digit != 0;
      exponent += 4;
      return;
    }
    mantissa = mantissa << 4 | static_cast<std::uint64_t>(digit);
  }
};

// Reads H.HpE without sign and prefix.
std::optional<Binary> HexMagnitude(std::string_view text) {
  const std::size_t p = text.find_first_of("pP");
  if (p == std::string_view::npos) return std::nullopt;
  const std::optional<std::int64_t> exponent = ExponentOf(text.substr(p + 1));
  if (!exponent) return std::nullopt;
  Binary number;
  bool fraction = false;
  bool any = false;
  for (const char c : text.substr(0, p)) {
    if (c == '.' && !fraction) {
      fraction = true;
      continue;
    }
    const int digit = HexDigit(c);
    if (digit < 0) return std::nullopt;
    any = true;
    number.Append(digit);
    if (fraction) number.exponent -= 4;
  }
  if (!any) return std::nullopt;
  number.exponent += *exponent;
  return number;
}

// The number as a T, if T holds it: its bits lie between T's smallest subnormal and 2^max_exponent,
// and at most `digits` of them are significant.
template <class T>
std::optional<double> Exactly(Binary number) {
  using Limits = std::numeric_limits<T>;
  if (number.wide) return std::nullopt;
  if (number.mantissa == 0) return 0.0;
  const int zeros = std::countr_zero(number.mantissa);
  number.mantissa >>= zeros;
  number.exponent += zeros;
  const int bits = 64 - std::countl_zero(number.mantissa);
  constexpr int kLeast = Limits::min_exponent - Limits::digits;
  if (bits > Limits::digits || number.exponent < kLeast ||
      number.exponent + bits > Limits::max_exponent) {
    return std::nullopt;
  }
  return std::ldexp(static_cast<double>(number.mantissa), static_cast<int>(number.exponent));
}

}  // namespace

NumberFromText DecimalNumber(std::string_view text, Precision precision) {
  return precision == Precision::kFloat32 ? Nearest<float>(text) : Nearest<double>(text);
}

NumberFromText ExactNumber(std::string_view text, Precision precision) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (text == "inf") return {kInfinity, {}, {}};
  if (text == "-inf") return {-kInfinity, {}, {}};
  if (text == "nan") return {std::numeric_limits<double>::quiet_NaN(), {}, {}};
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) {
    return {0, "is not a hex float", kWriteHex};
  }
  const std::optional<Binary> number = HexMagnitude(text.substr(2));
  if (!number) return {0, "is a malformed hex float", kWriteHex};
  const bool single = precision == Precision::kFloat32;
  const std::optional<double> value = single ? Exactly<float>(*number) : Exactly<double>(*number);
  if (!value) {
    return {0, single ? "is not exactly a float32" : "is not exactly a float64",
            single ? "write a hex float that float32 holds, or set \"precision\" to \"float64\""
                   : "write a hex float that float64 holds"};
  }
  return {negative ? -*value : *value, {}, {}};
}

std::string ExactText(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value < 0 ? "-inf" : "inf";
  std::array<char, 32> digits{};
  const auto [end, status] = std::to_chars(digits.data(), digits.data() + digits.size(),
                                           std::fabs(value), std::chars_format::hex);
  std::string text = std::signbit(value) ? "-0x" : "0x";
  text.append(digits.data(), end);
  return text;
}

}  // namespace rasterproof::io
