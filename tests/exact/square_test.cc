// The spans of squares against the decider that asks one square, and both against clipping.
#include "exact/square.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/square_rule.h"
#include "exact/edge.h"
#include "tests/exact/families.h"
#include "tests/exact/naive_square.h"
#include "tests/exact/one_square.h"
#include "tests/exact/square_shapes.h"
#include "tests/share.h"

namespace rasterproof::exact {
namespace {

constexpr int kSide = kSquareTargetSide;
using Mask = std::array<std::array<bool, kSide>, kSide>;

Mask BySpans(std::array<Point2, 3> v, const SquareRegion& region, const SquareFrame& frame) {
  for (Point2& p : v) p = frame.ToScreen(p);
  Mask mask{};
  ForEachSquareSpan(v, region, frame, [&](int row, Columns columns) {
    for (int i = columns.first; i < columns.last; ++i) {
      mask[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)] = true;
    }
  });
  return mask;
}

template <class Covers>
Mask OneByOne(const Covers& covers) {
  Mask mask{};
  for (int r = 0; r < kSide; ++r) {
    for (int i = 0; i < kSide; ++i) {
      mask[static_cast<std::size_t>(r)][static_cast<std::size_t>(i)] = covers(i, r);
    }
  }
  return mask;
}

Mask BySquares(std::array<Point2, 3> v, const SquareRegion& region, const SquareFrame& frame,
               Decider decider) {
  for (Point2& p : v) p = frame.ToScreen(p);
  return OneByOne([&](int i, int r) { return IsSquareCovered(v, region, frame, i, r, decider); });
}

Mask ByClipping(const std::array<Point2, 3>& v, const SquareRegion& region,
                const SquareFrame& frame) {
  return OneByOne([&](int i, int r) {
    return NaiveSquareCovers(v, region, i, frame.y_up ? kSide - 1 - r : r);
  });
}

std::string Show(const std::array<Point2, 3>& v, const SquareRegion& region,
                 const SquareFrame& frame, const Mask& got, const Mask& want) {
  char line[400];
  std::snprintf(line, sizeof line,
                "relation %d, square %d, shape %d, growth %d by %a, y up %d; (%a, %a) (%a, %a) "
                "(%a, %a)\n",
                static_cast<int>(region.relation), static_cast<int>(region.square),
                static_cast<int>(region.shape), static_cast<int>(region.growth), region.half_width,
                frame.y_up ? 1 : 0, v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y);
  std::string text = line;
  for (std::size_t r = 0; r < kSide; ++r) {
    for (const Mask* mask : {&got, &want}) {
      for (const bool covered : (*mask)[r]) text += covered ? '#' : '.';
      text += "  ";
    }
    text += "\n";
  }
  return text;
}

struct SquaresCompared {
  std::uint64_t triangles = 0;
  std::uint64_t covered = 0;
};

// RASTERPROOF_SQUARES: how many triangles to compare in place of `few`.
int HowMany(int few) {
  const char* more = std::getenv("RASTERPROOF_SQUARES");
  return more == nullptr ? Cases(few) : std::atoi(more);
}

template <class Other>
SquaresCompared Compare(int triangles, std::uint64_t seed, const Other& other) {
  SquaresCompared compared;
  SquareDraw draw(seed);
  for (int k = 0; k < triangles; ++k) {
    const std::array<Point2, 3> v = draw.Triangle();
    const SquareRegion region = draw.Region();
    const SquareFrame frame = draw.Frame();
    const Mask spans = BySpans(v, region, frame);
    const Mask truth = other(v, region, frame);
    EXPECT_EQ(spans, truth) << k << ": " << Show(v, region, frame, spans, truth);
    if (spans != truth) return compared;
    ++compared.triangles;
    for (const auto& row : truth) compared.covered += static_cast<std::uint64_t>(row[0] + row[1]);
  }
  return compared;
}

TEST(SquareSpans, EqualTheSquareBySquareDeciderOfIntegers) {
  const SquaresCompared compared = Compare(
      HowMany(20000), 7, [](const auto&... all) { return BySquares(all..., Decider::kIntegers); });
  EXPECT_GT(compared.covered, compared.triangles / 2);
}

TEST(SquareSpans, EqualTheSquareBySquareDeciderOfCgal) {
  const SquaresCompared compared = Compare(
      HowMany(20000), 8, [](const auto&... all) { return BySquares(all..., Decider::kCgal); });
  EXPECT_GT(compared.covered, compared.triangles / 2);
}

TEST(SquareSpans, EqualTheTriangleClippedByEverySquare) {
  const SquaresCompared compared =
      Compare(HowMany(5000), 9, [](const auto&... all) { return ByClipping(all...); });
  EXPECT_GT(compared.covered, compared.triangles / 2);
}

TEST(SquareSpans, EqualTheSquareBySquareDeciderForEveryFiniteDouble) {
  SquareDraw draw(10);
  Draw numbers(11);
  for (int k = 0; k < Cases(6000); ++k) {
    const auto family = static_cast<Family>(numbers.Below(kFamilies));
    std::array<Point2, 3> v = numbers.EdgeAndPoint(family);
    if (k % 2 == 0) v[static_cast<std::size_t>(draw.Below(3))] = draw.Triangle()[0];
    const SquareRegion region = draw.Region();
    const SquareFrame frame = draw.Frame();
    const Mask spans = BySpans(v, region, frame);
    const Mask truth = BySquares(v, region, frame, Decider::kIntegers);
    ASSERT_EQ(spans, truth) << FamilyName(family) << ": " << Show(v, region, frame, spans, truth);
  }
}

}  // namespace
}  // namespace rasterproof::exact
