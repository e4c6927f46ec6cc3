// The table of sizes up to which nothing rounds (docs/mathematics.md, 8): at the size every
// evaluation tried is exact, and one unit beyond it a given input is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "fmt/format.h"
#include "reference/exactness.h"
#include "reference/homogeneous_edges.h"
#include "reference/method.h"
#include "tests/reference/document_block.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference::witness {
namespace {

using exact::Rational;
/// a, b, p in units of the grid; then w of a and of b, which the homogeneous form alone reads.
using Inputs = std::array<std::int64_t, 8>;

enum class Asked { kValue, kSign, kHomogeneous };

struct SizeRow {
  std::string_view evaluation;
  std::string_view method;  ///< empty: an integer of `bits` bits, or homogeneous of so many
  int bits;
  Asked asked;
  std::int64_t low;   ///< coordinates lie in [low, low + size]
  std::int64_t size;  ///< the largest box side proved
  Inputs beyond;      ///< an input in a box of side size + 1 that fails
};

constexpr std::int64_t kInt32Box = 46340;
constexpr std::int64_t kInt64Box = 3037000499;
constexpr std::int64_t kAffine32 = 2048;

constexpr Inputs Square(std::int64_t side) { return {0, 0, 0, side, side, 0, 1, 1}; }
constexpr Inputs SquareLessOne(std::int64_t side) { return {0, 0, 1, side, side, 1, 1, 1}; }
constexpr Inputs LongDifference(std::int64_t side) { return {-1, -1, 0, 0, side, side - 1, 1, 1}; }
// Found by a search: A p.x + B p.y is odd and beyond 2^24.
constexpr Inputs kBeyondAffine{2046, -2049, 2047, 2048, -2049, -2045, 1, 1};
// Nearly the largest determinants, 4 N^3, and odd: 16875215 and N (2N - 1)^2.
constexpr Inputs kBeyondHomogeneous32{162, 161, 162, 162, 161, -162, 162, -161};
constexpr Inputs BeyondHomogeneous64(std::int64_t n) { return {n, n, n, n, n, 1 - n, n, 1 - n}; }

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
    SizeRow{"float32 homogeneous, value, \\|c\\| at most half", "", 24, Asked::kHomogeneous,
            -kFloat32Homogeneous, 2 * kFloat32Homogeneous, kBeyondHomogeneous32},
    SizeRow{"float64 homogeneous, value, \\|c\\| at most half", "", 53, Asked::kHomogeneous,
            -kFloat64Homogeneous, 2 * kFloat64Homogeneous,
            BeyondHomogeneous64(kFloat64Homogeneous + 1)},
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

/// Whether the edge value, and the determinant of the two vertices and (p, p.x) as a third, are
/// exact.
template <class T>
bool IsHomogeneousRight(const Inputs& c) {
  const auto at = [&](std::size_t k) { return static_cast<double>(c[k]); };
  const Vertex vi{at(0), at(1), 0, at(6)};
  const Vertex vj{at(2), at(3), 0, at(7)};
  const HomogeneousNormal<T> normal(vi, vj);
  const auto dot = [&](double w) {
    return double{normal.Dot(static_cast<T>(at(4)), static_cast<T>(at(5)), static_cast<T>(w))};
  };
  const Rational edge = exact::HomogeneousEdgeValue(vi, vj, {at(4), at(5)});
  const Rational normal_w = Rational(vj.x) * vi.y - Rational(vj.y) * vi.x;
  return Rational(dot(1)) == edge && Rational(dot(at(4))) == edge + normal_w * Rational(at(4) - 1);
}

bool IsRight(const SizeRow& row, const Inputs& c) {
  if (row.asked == Asked::kHomogeneous) {
    return row.bits == 24 ? IsHomogeneousRight<float>(c) : IsHomogeneousRight<double>(c);
  }
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
    const bool has_w = row.asked == Asked::kHomogeneous;
    const auto [least, most] = std::ranges::minmax(std::span(row.beyond).first(has_w ? 8 : 6));
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
    const bool has_w = row.asked == Asked::kHomogeneous;
    const auto w = [&](std::size_t k) { return has_w ? fmt::format(", {}", c[k]) : ""; };
    table += fmt::format("| {} | {} | ({}, {}{}), ({}, {}{}), ({}, {}) |\n", row.evaluation,
                         row.size, c[0], c[1], w(6), c[2], c[3], w(7), c[4], c[5]);
  }
  return table;
}

TEST(BoundTables, SizesAreThoseThatTheTestTries) {
  ExpectBlock("docs/mathematics.md", "sizes", Table());
}

}  // namespace
}  // namespace rasterproof::reference::witness
