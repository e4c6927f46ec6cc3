// The table of sizes up to which nothing rounds (docs/mathematics.md, 8): at the size every
// evaluation tried is exact, and one unit beyond it a given input is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "exact/edge.h"
#include "exact/rational.h"
#include "fmt/format.h"
#include "reference/exactness.h"
#include "reference/method.h"
#include "tests/reference/document_block.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference::witness {
namespace {

using exact::Rational;
using Inputs = std::array<std::int64_t, 6>;  // a, b, p in units of the grid

enum class Asked { kValue, kSign };

struct SizeRow {
  std::string_view evaluation;
  std::string_view method;  ///< empty: an integer of `bits` bits
  int bits;
  Asked asked;
  std::int64_t low;   ///< coordinates lie in [low, low + size]
  std::int64_t size;  ///< the largest box side proved
  Inputs beyond;      ///< an input in a box of side size + 1 that fails
};

constexpr std::int64_t kInt32Box = 46340;
constexpr std::int64_t kInt64Box = 3037000499;
constexpr std::int64_t kAffine32 = 2048;

constexpr Inputs Square(std::int64_t side) { return {0, 0, 0, side, side, 0}; }
constexpr Inputs SquareLessOne(std::int64_t side) { return {0, 0, 1, side, side, 1}; }
constexpr Inputs LongDifference(std::int64_t side) { return {-1, -1, 0, 0, side, side - 1}; }
// Found by a search: A p.x + B p.y is odd and beyond 2^24.
constexpr Inputs kBeyondAffine{2046, -2049, 2047, 2048, -2049, -2045};

constexpr std::array kRows{
    SizeRow{"float32 direct, value", "f32-direct", 0, Asked::kValue, 0, kFloat32Box,
            Square(kFloat32Box + 1)},
    SizeRow{"float32 incremental, value", "f32-incremental", 0, Asked::kValue, 0, kFloat32Box,
            Square(kFloat32Box + 1)},
    SizeRow{"float32 affine, value, \\|c\\| at most half", "f32-affine", 0, Asked::kValue,
            -kAffine32, 2 * kAffine32, kBeyondAffine},
    SizeRow{"float32 Kahan's, sign", "f32-kahan", 0, Asked::kSign, 0, kFloat32Differences,
            LongDifference(kFloat32Differences)},
    SizeRow{"float64 direct, value", "f64-direct", 0, Asked::kValue, 0, kFloat64Box,
            SquareLessOne(kFloat64Box + 1)},
    SizeRow{"float64 incremental, value", "f64-incremental", 0, Asked::kValue, 0, kFloat64Box,
            SquareLessOne(kFloat64Box + 1)},
    SizeRow{"float64 Kahan's, sign", "f64-kahan", 0, Asked::kSign, 0, kFloat64Differences,
            LongDifference(kFloat64Differences)},
    SizeRow{"int32 direct, value", "", 32, Asked::kValue, 0, kInt32Box, Square(kInt32Box + 1)},
    SizeRow{"int64 direct, value", "", 64, Asked::kValue, 0, kInt64Box, Square(kInt64Box + 1)},
};

/// Whether a product or E itself leaves the integers of so many bits; every row's differences fit.
bool FitsIntegers(const Inputs& c, int bits) {
  const auto product = [&](std::int64_t x, std::int64_t y) {
    return Rational(static_cast<double>(x)) * static_cast<double>(y);
  };
  const Rational l = product(c[4] - c[0], c[3] - c[1]);
  const Rational r = product(c[5] - c[1], c[2] - c[0]);
  const Rational limit = std::ldexp(1.0, bits - 1);
  for (const Rational& value : {l, r, l - r}) {
    if (!(value.Abs() < limit)) return false;
  }
  return true;
}

bool IsRight(const SizeRow& row, const Inputs& c) {
  if (row.method.empty()) return FitsIntegers(c, row.bits);
  const auto at = [&](std::size_t k) { return static_cast<double>(c[k]); };
  const Point2 a{at(0), at(1)};
  const Point2 b{at(2), at(3)};
  const Point2 p{at(4), at(5)};
  const Rational value = FindMethod(row.method)->edges->Value(a, b, p);
  const Rational exact = exact::EdgeValue(a, b, p);
  return row.asked == Asked::kSign ? value.Sign() == exact.Sign() : value == exact;
}

TEST(ExactnessTable, NothingFailsUpToTheSizeAndTheInputBeyondItDoes) {
  RandomValues random(51);
  for (const SizeRow& row : kRows) {
    for (int n = 0; n < Cases(20000); ++n) {
      Inputs c{};
      for (std::int64_t& x : c) {
        const auto near = static_cast<std::int64_t>(random.Bits(random.Integer(0, 12)));
        const bool is_low = random.Coin();
        x = row.low +
            (is_low ? std::min(near, row.size) : std::max<std::int64_t>(row.size - near, 0));
      }
      ASSERT_TRUE(IsRight(row, c)) << row.evaluation;
    }
    EXPECT_FALSE(IsRight(row, row.beyond)) << row.evaluation << ": the row is not sharp";
    const auto [least, most] = std::ranges::minmax(row.beyond);
    // |c| <= size / 2 grows on both sides.
    EXPECT_LE(most - least, row.size + (row.low < 0 ? 2 : 1)) << row.evaluation;
  }
}

std::string Table() {
  std::string table =
      "| evaluation | largest W 2^s, proved | a, b, p one unit beyond that fail |\n"
      "| --- | ---: | --- |\n";
  for (const SizeRow& row : kRows) {
    const Inputs& c = row.beyond;
    table += fmt::format("| {} | {} | ({}, {}), ({}, {}), ({}, {}) |\n", row.evaluation, row.size,
                         c[0], c[1], c[2], c[3], c[4], c[5]);
  }
  return table;
}

TEST(BoundTables, SizesAreThoseThatTheTestTries) {
  ExpectBlock("docs/mathematics.md", "sizes", Table());
}

}  // namespace
}  // namespace rasterproof::reference::witness
