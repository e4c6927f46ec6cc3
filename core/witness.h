// Where a property failed, with observed and expected values as numbers; printing comes last.
#ifndef RASTERPROOF_CORE_WITNESS_H_
#define RASTERPROOF_CORE_WITNESS_H_

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace rasterproof {

/// How often a sample is covered, by facing: "front 1, back 0".
struct FacingCounts {
  std::uint32_t front = 0;
  std::uint32_t back = 0;

  friend bool operator==(const FacingCounts&, const FacingCounts&) = default;
};

/// The counts that a sample may have, bit n for the count n: "0 or 2".
struct CountSet {
  std::uint64_t bits = 0;

  friend bool operator==(const CountSet&, const CountSet&) = default;
};

/// A rational number, in decimal: "-3/4", "2".
struct RationalText {
  std::string text;

  friend bool operator==(const RationalText&, const RationalText&) = default;
};

/// Words or a number; an integer is mostly a count.
using WitnessPart =
    std::variant<std::string, FacingCounts, CountSet, std::int64_t, double, RationalText>;

/// What was seen, or what should have been: its first number, and around it in the order of a
/// sentence words, its tolerance and what is listed beside it. {"covered ", 2, " times"}.
using WitnessValue = std::vector<WitnessPart>;

/// The value as a reader sees it: "covered 2 times", "0x1p+0 within 0x1p-20", "front 1, back 0".
std::string TextOfValue(const WitnessValue& value);

/// A double as a C99 hex float: "0x1.8p+1", "nan", "-inf".
std::string HexText(double x);

/// Where a property failed. Entries that do not apply are -1 or empty.
struct Witness {
  int triangle = -1;
  int edge = -1;  ///< edge i is opposite vertex i
  int x = -1;     ///< pixel column
  int y = -1;     ///< pixel row from the top
  int sample = 0;
  WitnessValue observed = {};
  WitnessValue expected = {};
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_WITNESS_H_
