// The figures of conservative rasterization, worked out by hand: a first reading of the sentences,
// by separating axes over integers, which knows nothing of the project's own. The second is the
// project's: its spans and the decider that asks each square alone give the same pixels, and its
// presets say what the figures show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/square_rule.h"
#include "exact/edge.h"
#include "exact/square.h"
#include "exact/square_coverage.h"
#include "tests/exact/one_square.h"

namespace rasterproof {
namespace {

// Coordinates in 1/4096 pixel: every figure's are whole numbers of them.
constexpr std::int64_t kPixel = 4096;

struct Place {
  std::int64_t x;
  std::int64_t y;
};
using Shape = std::array<Place, 3>;

// A figure's coordinates, in pixels.
Place At(double x, double y) {
  return {static_cast<std::int64_t>(x * kPixel), static_cast<std::int64_t>(y * kPixel)};
}

// The square of a pixel, grown on all sides.
std::array<Place, 4> SquareOf(std::int64_t i, std::int64_t row, std::int64_t grown) {
  const std::int64_t x0 = i * kPixel - grown;
  const std::int64_t y0 = row * kPixel - grown;
  const std::int64_t x1 = (i + 1) * kPixel + grown;
  const std::int64_t y1 = (row + 1) * kPixel + grown;
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

struct Interval {
  std::int64_t least;
  std::int64_t most;
};

template <typename Points>
Interval Along(const Points& points, Place axis) {
  Interval interval{INT64_MAX, INT64_MIN};
  for (const Place p : points) {
    const std::int64_t at = p.x * axis.x + p.y * axis.y;
    interval.least = std::min(interval.least, at);
    interval.most = std::max(interval.most, at);
  }
  return interval;
}

enum class Touch : std::uint8_t { kCounts, kDoesNot };

// Whether triangle and square meet. Sweeping the triangle by a square of half width u is growing
// the pixel's square by u.
bool Meet(const Shape& shape, std::int64_t i, std::int64_t row, std::int64_t grown, Touch touch) {
  const auto square = SquareOf(i, row, grown);
  std::vector<Place> axes{{1, 0}, {0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Place a = shape[k];
    const Place b = shape[(k + 1) % 3];
    axes.push_back({b.y - a.y, a.x - b.x});
  }
  return std::ranges::all_of(axes, [&](Place axis) {
    const Interval s = Along(square, axis);
    const Interval t = Along(shape, axis);
    if (touch == Touch::kCounts) return s.least <= t.most && t.least <= s.most;
    return s.least < t.most && t.least < s.most;
  });
}

// Whether the square, grown, lies in the triangle.
bool Holds(const Shape& shape, std::int64_t i, std::int64_t row, std::int64_t grown, Touch touch) {
  std::int64_t facing = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place a = shape[k];
    const Place b = shape[(k + 1) % 3];
    const Place c = shape[(k + 2) % 3];
    facing = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0 ? 1 : -1;
    for (const Place p : SquareOf(i, row, grown)) {
      const std::int64_t side = facing * ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
      if (side < 0 || (side == 0 && touch == Touch::kDoesNot)) return false;
    }
  }
  return true;
}

using Drawn = std::vector<std::string>;

template <typename Covers>
Drawn Draw(int width, int height, const Covers& covers) {
  Drawn rows;
  for (int row = 0; row < height; ++row) {
    std::string text;
    for (int i = 0; i < width; ++i) text += covers(i, row) ? '1' : '0';
    rows.push_back(text);
  }
  return rows;
}

double Pixels(std::int64_t units) {
  return static_cast<double>(units) / static_cast<double>(kPixel);
}

// The second reading: spans, and each square asked alone, must say what was read by hand.
void ReadAgain(const Drawn& first, const Shape& shape, SquareRelation relation, std::int64_t grown,
               Touch touch) {
  const int height = static_cast<int>(first.size());
  const int width = static_cast<int>(first[0].size());
  const bool counts = touch == Touch::kCounts;
  SquareRegion region;
  region.relation = relation;
  region.half_width = Pixels(grown);
  region.shape = counts ? Closure::kClosed : Closure::kOpen;
  // Within a triangle squares are closed: what differs is whether its boundary is the triangle's.
  region.square = relation == SquareRelation::kContains ? Closure::kClosed : region.shape;
  std::array<Point2, 3> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = {Pixels(shape[k].x), Pixels(shape[k].y)};
  const exact::SquareFrame frame{{0, 0, width, height}};
  EXPECT_EQ(Draw(width, height,
                 [&](int i, int row) {
                   return exact::IsSquareCovered(v, region, frame, i, row,
                                                 exact::Decider::kIntegers);
                 }),
            first);
  Drawn spans(first.size(), std::string(first[0].size(), '0'));
  exact::ForEachSquareSpan(v, region, frame, [&](int row, exact::Columns columns) {
    for (int i = columns.first; i < columns.last; ++i) {
      spans[static_cast<std::size_t>(row)][static_cast<std::size_t>(i)] = '1';
    }
  });
  EXPECT_EQ(spans, first);
}

Drawn Meeting(int width, int height, const Shape& shape, std::int64_t grown, Touch touch) {
  Drawn drawn =
      Draw(width, height, [&](int i, int row) { return Meet(shape, i, row, grown, touch); });
  ReadAgain(drawn, shape, SquareRelation::kIntersects, grown, touch);
  return drawn;
}

Drawn Inner(int width, int height, const Shape& shape, std::int64_t grown, Touch touch) {
  Drawn drawn =
      Draw(width, height, [&](int i, int row) { return Holds(shape, i, row, grown, touch); });
  ReadAgain(drawn, shape, SquareRelation::kContains, grown, touch);
  return drawn;
}

enum class Bound : std::uint8_t { kMust, kMay };

// What a preset says of the shape, its vertices placed without freedom: figures show grid points.
Drawn ByPreset(const char* preset, Bound bound, int width, int height, const Shape& shape) {
  Profile profile = *PresetProfile(preset);
  profile.freedom = {};
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.precision = Precision::kFloat64;
  for (const Place p : shape) scene.vertices.push_back({Pixels(p.x), Pixels(p.y)});
  scene.triangles = {{0, 1, 2}};
  const CoverageCounts counts = bound == Bound::kMust ? exact::MustCover({scene, profile})
                                                      : exact::MayCover({scene, profile});
  return Draw(width, height,
              [&](int i, int row) { return counts.Count(counts.Index(i, row)) != 0; });
}

// Direct3D, figure consras3, d = 1/128: at half a pixel of uncertainty only the four middle pixels
// may be covered; three of them the triangle overlaps, the fourth it touches at a corner.
TEST(SpecificationSquares, OnlyTheFourMiddlePixels) {
  constexpr double kD = 1.0 / 64;  // 2 d: two pixels are one unit of normalized coordinates
  const Shape shape{At(1.5 + kD, 1.5 + kD), At(1.5 + kD, 2.5 - kD), At(2.5 - kD, 1.5 + kD)};
  EXPECT_EQ(Meeting(4, 4, shape, 0, Touch::kDoesNot), (Drawn{"0000", "0110", "0100", "0000"}));
  EXPECT_EQ(Meeting(4, 4, shape, kPixel / 2, Touch::kDoesNot),
            (Drawn{"0000", "0110", "0110", "0000"}));
}

TEST(SpecificationSquares, PresetsShowWhatTheFiguresShow) {
  constexpr double kD = 1.0 / 64;
  const Shape consras3{At(1.5 + kD, 1.5 + kD), At(1.5 + kD, 2.5 - kD), At(2.5 - kD, 1.5 + kD)};
  EXPECT_EQ(ByPreset("d3d12-conservative-1", Bound::kMust, 4, 4, consras3),
            (Drawn{"0000", "0110", "0100", "0000"}));
  EXPECT_EQ(ByPreset("d3d12-conservative-1", Bound::kMay, 4, 4, consras3),
            (Drawn{"0000", "0110", "0110", "0000"}));
  constexpr double kIn = 1.0 / 128;
  const Shape consras4{At(1 + kIn, 1 + kIn), At(1 + kIn, 2 - kIn), At(2 - kIn, 1 + kIn)};
  for (const char* preset : {"d3d12-conservative-2", "d3d12-conservative-3"}) {
    EXPECT_EQ(ByPreset(preset, Bound::kMay, 3, 3, consras4), (Drawn{"000", "010", "000"}));
  }
  constexpr double kOut = 1.0 / 32;
  const Shape consras7{At(-kOut, 3), At(3 + kOut, 3), At(1.5, -2 * kOut)};
  EXPECT_EQ(ByPreset("d3d12-inner", Bound::kMay, 3, 3, consras7), (Drawn{"000", "010", "000"}))
      << "a pixel that a side touches from within is not inner";
  EXPECT_EQ(ByPreset("d3d12-inner", Bound::kMust, 3, 3, consras7), (Drawn{"000", "010", "000"}));
  EXPECT_EQ(ByPreset("vulkan-underestimate", Bound::kMay, 3, 3, consras7),
            (Drawn{"000", "010", "010"}));
  const Shape low{At(0, 0), At(3, 1.0 / 4096), At(3, 0)};
  EXPECT_EQ(ByPreset("d3d12-conservative-2", Bound::kMust, 3, 1, low), Drawn{"111"});
  EXPECT_EQ(ByPreset("d3d12-conservative-1", Bound::kMust, 3, 1, low), Drawn{"000"});
  const Shape half{At(1, 1), At(2, 1), At(1, 2)};
  EXPECT_EQ(ByPreset("vulkan-overestimate", Bound::kMust, 3, 3, half),
            (Drawn{"111", "111", "110"}));
}

// Figure consras4, with vertices 1/128 within the middle pixel: at 1/256 of a pixel it is the only
// one that may be covered; with vertices 1/512 within, the region reaches its neighbours.
TEST(SpecificationSquares, OnlyTheMiddlePixel) {
  const auto within = [](double d) {
    return Shape{At(1 + d, 1 + d), At(1 + d, 2 - d), At(2 - d, 1 + d)};
  };
  EXPECT_EQ(Meeting(3, 3, within(1.0 / 128), kPixel / 256, Touch::kDoesNot),
            (Drawn{"000", "010", "000"}));
  EXPECT_EQ(Meeting(3, 3, within(1.0 / 512), kPixel / 256, Touch::kDoesNot),
            (Drawn{"111", "111", "110"}));
}

// Figure consras5: the left edge of the smallest region runs through two pixels' lower right
// corners. By the top-left rule it covers them: 13 pixels, 11 without.
TEST(SpecificationSquares, ThirteenPixelsByTheTopLeftRule) {
  constexpr double kStep = 1.0 / 256;
  const Shape shape{At(kStep, 3), At(2 + kStep, 1), At(3, 3)};
  EXPECT_EQ(Meeting(4, 4, shape, kPixel / 512, Touch::kDoesNot),
            (Drawn{"0010", "0110", "1111", "1111"}));
  EXPECT_EQ(Meeting(4, 4, shape, kPixel / 512, Touch::kCounts),
            (Drawn{"0110", "1110", "1111", "1111"}))
      << "nothing but the left edge touches a pixel's border here";
}

// Figure consras7, d = 1/48: only the middle pixel is inner. The pixel below it lies within the
// triangle as well, but its side is the triangle's, within the region that may be left out.
TEST(SpecificationSquares, InnerCoverageIsTheMiddlePixel) {
  constexpr double kD = 1.0 / 32;  // 1.5 d: a pixel and a half are one unit
  const Shape shape{At(-kD, 3), At(3 + kD, 3), At(1.5, -2 * kD)};
  EXPECT_EQ(Inner(3, 3, shape, kPixel / 256, Touch::kCounts), (Drawn{"000", "010", "000"}))
      << "what must be set";
  EXPECT_EQ(Inner(3, 3, shape, 0, Touch::kDoesNot), (Drawn{"000", "010", "000"}));
  EXPECT_EQ(Inner(3, 3, shape, 0, Touch::kCounts), (Drawn{"000", "010", "010"}))
      << "Vulkan's underestimate: the whole pixel, edges and corners included";
}

// Direct3D, Conformance Tests, post-snap degenerate culling: 1/4096 pixel high, and 1/1024 wide at
// a border. Flat once snapped, and pixels all the same.
TEST(SpecificationSquares, AFlatTriangleStillMeetsPixels) {
  const Shape low{At(0, 0), At(3, 1.0 / 4096), At(3, 0)};
  EXPECT_EQ(Meeting(3, 1, low, 0, Touch::kDoesNot), Drawn{"111"});
  const Shape at_a_border{At(1, 1), At(1, 0), At(1 - 1.0 / 1024, 0)};
  EXPECT_EQ(Meeting(2, 1, at_a_border, 0, Touch::kDoesNot), Drawn{"10"})
      << "at least one pixel must be drawn: the one that it overlaps";
}

// Vulkan: any portion of the pixel, including its edges and corners. A half of one pixel touches
// all of its neighbours but the one that its long side turns away from.
TEST(SpecificationSquares, ClosedSquaresCountATouch) {
  const Shape half{At(1, 1), At(2, 1), At(1, 2)};
  EXPECT_EQ(Meeting(3, 3, half, 0, Touch::kCounts), (Drawn{"111", "111", "110"}));
}

// GDAL, ALL_TOUCHED as it is meant: interiors meet, contact with a border is not burned.
TEST(SpecificationSquares, OpenSquaresNeedInteriors) {
  const Shape half{At(1, 1), At(2, 1), At(1, 2)};
  EXPECT_EQ(Meeting(3, 3, half, 0, Touch::kDoesNot), (Drawn{"000", "010", "000"}));
}

// PDF: squares and shapes have their floor sides and lack their ceiling sides, so the pixel at a
// ceiling that lies on a grid line is not painted. For a shape that has an interior that is to say
// that interiors meet.
TEST(SpecificationSquares, HalfOpenSquaresLeaveTheCeilingOut) {
  const Shape shape{At(0.5, 0.5), At(2, 0.5), At(0.5, 2)};
  EXPECT_EQ(Meeting(3, 3, shape, 0, Touch::kDoesNot), (Drawn{"110", "110", "000"}));
  EXPECT_EQ(Meeting(3, 3, shape, 0, Touch::kCounts), (Drawn{"111", "110", "100"}))
      << "a closed reading paints the ceiling's neighbours";
}

}  // namespace
}  // namespace rasterproof
