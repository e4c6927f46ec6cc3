// The specifications' own figures and tables, worked out by hand, against the oracle.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "model/snap.h"

namespace rasterproof::exact {
namespace {

using Drawn = std::vector<std::string>;

Scene SceneOf(int width, int height, std::vector<Vertex> vertices,
              std::vector<Triangle> triangles) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.precision = Precision::kFloat64;
  scene.vertices = std::move(vertices);
  scene.triangles = std::move(triangles);
  return scene;
}

// One digit per pixel, the same by three deciders.
Drawn DrawnBy(const Scene& scene, const Profile& profile = {}) {
  const CoverageCounts counts = Coverage(scene, profile);
  EXPECT_EQ(counts, Coverage(scene, profile, {}, Decider::kIntegers));
  EXPECT_EQ(counts, Coverage(scene, profile, {}, Decider::kCgal));
  Drawn rows;
  for (int row = 0; row < counts.height; ++row) {
    std::string text;
    for (int i = 0; i < counts.width; ++i) {
      text += std::to_string(counts.Count(counts.Index(i, row)));
    }
    rows.push_back(text);
  }
  return rows;
}

Profile WithRule(const TieRule& rule) {
  Profile profile;
  profile.tie_rule = rule;
  return profile;
}

// Direct3D 11.3, 3.4.2, "Triangle Rasterization Example (Single Sample Per Pixel)": the vertices as
// drawn, on quarters of pixels, and the pixels that the figure fills.
TEST(SpecificationFigures, TrianglesOfDirect3D11Section342) {
  const Scene scene = SceneOf(
      16, 8, {{1, 1},       {6, 2},       {2, 4},        // a large one
              {5.25, 1.25}, {6.25, 0.25}, {6.25, 1.25},  // between centres: nothing
              {6.5, 1.5},   {7.5, 0.5},   {7.5, 1.5},    // from centre to centre: nothing
              {7.75, 2.5},  {9.75, 0.75}, {11.75, 2.5}, {9.5, 5.25},  // two on a flat edge
              {15, 0},      {13.5, 1.5},  {14.5, 2.5},  {14.5, 4.5},  // two on a sloping edge
              {1, 6},       {7, 4},       {5, 6},       {8, 7},      {9.5, 5.5},  // a fan of three
              {11.5, 4.5},  {11.5, 6.5},  {12.5, 5.5},                 // left edge through centres
              {9.5, 7.5},   {10.5, 7.5},  {9.5, 9.5},                  // leaves the target
              {13.5, 5.5},  {15.5, 5.5},  {15.5, 7.5},  {13.5, 7.5}},  // a square, cut in two
      {{0, 1, 2},
       {3, 4, 5},
       {6, 7, 8},
       {9, 10, 11},
       {9, 11, 12},
       {13, 14, 15},
       {14, 15, 16},
       {17, 18, 19},
       {19, 18, 20},
       {20, 18, 21},
       {22, 23, 24},
       {25, 26, 27},
       {28, 29, 31},
       {29, 30, 31}});
  EXPECT_EQ(DrawnBy(scene), (Drawn{"0000000000000010",  //
                                   "0110000001100110",  //
                                   "0111100011110000",  //
                                   "0010000011100000",  //
                                   "0000011101000000",  //
                                   "0011111110010110",  //
                                   "0000001100000110",  //
                                   "0000000001000000"}));
}

// Direct3D 11.3, 3.2.4.1, "float32 -> Fixed Point Conversion": 0xc5fffd0c lies half way between two
// grid points, and the even one is taken: -8192 + 94/256.
TEST(SpecificationFigures, ConversionOfDirect3D11Section3241) {
  constexpr double kNumber = -8191.630859375;
  ASSERT_EQ(kNumber, static_cast<double>(-0x1.fffa18p12F)) << "0xc5fffd0c";
  EXPECT_EQ(SnapCoordinate(kNumber, {8, SnapRule::kNearestEven}), -8192 + 94.0 / 256);
  EXPECT_NE(SnapCoordinate(kNumber, {8, SnapRule::kFloor}),
            SnapCoordinate(kNumber, {8, SnapRule::kTruncate}));
  EXPECT_EQ(GridPointsWithin(kNumber, {8, SnapRule::kNearestEven}, 0.6).size(), 2U)
      << "half a step from both, 0.6 are allowed";
}

// The diagonal of a square from centre to centre, the two halves apart.
const Scene kUpperHalf = SceneOf(4, 4, {{0.5, 0.5}, {3.5, 0.5}, {0.5, 3.5}}, {{0, 1, 2}});
const Scene kLowerHalf = SceneOf(4, 4, {{3.5, 0.5}, {3.5, 3.5}, {0.5, 3.5}}, {{0, 1, 2}});

// OpenGL 14.6.1, Vulkan: exactly one of two polygons on either side of a common edge.
TEST(SpecificationTies, OneOfTwoSidesOwnsACommonEdge) {
  for (const TieRule& rule : kConsistentRules) {
    const Drawn upper = DrawnBy(kUpperHalf, WithRule(rule));
    const Drawn lower = DrawnBy(kLowerHalf, WithRule(rule));
    for (const auto& [row, column] : {std::pair{1U, 2U}, std::pair{2U, 1U}}) {
      EXPECT_NE(upper[row][column], lower[row][column])
          << TieRuleName(rule) << ": centres strictly within the common edge";
    }
  }
  EXPECT_EQ(DrawnBy(kUpperHalf), (Drawn{"1110", "1100", "1000", "0000"}));
  EXPECT_EQ(DrawnBy(kLowerHalf), (Drawn{"0000", "0010", "0110", "0000"}));
}

// WebGPU 23.2.5.4: included or not is not defined, so both of these are legal, and the strictly
// enclosed centre is counted in all.
TEST(SpecificationTies, WebGpuLeavesEveryEdgeOpen) {
  const TieRule inclusive = *TieRuleFromName("inclusive");
  const TieRule exclusive = *TieRuleFromName("exclusive");
  EXPECT_EQ(DrawnBy(kUpperHalf, WithRule(inclusive)), (Drawn{"1111", "1110", "1100", "1000"}));
  EXPECT_EQ(DrawnBy(kUpperHalf, WithRule(exclusive)), (Drawn{"0000", "0100", "0000", "0000"}));
  for (const TieRule& rule : kConsistentRules) {
    EXPECT_EQ(DrawnBy(kUpperHalf, WithRule(rule))[1][1], '1');
  }
}

TEST(SpecificationTies, SamplesOffEveryEdgeAreDecidedByEveryRule) {
  const Scene scene = SceneOf(4, 3, {{0.25, 0.25}, {3.75, 0.75}, {1.25, 2.75}}, {{0, 1, 2}});
  const Drawn by_hand{"1100", "0110", "0100"};
  std::vector<TieRule> rules(kConsistentRules.begin(), kConsistentRules.end());
  rules.push_back(*TieRuleFromName("inclusive"));
  rules.push_back(*TieRuleFromName("exclusive"));
  for (const TieRule& rule : rules) EXPECT_EQ(DrawnBy(scene, WithRule(rule)), by_hand);
}

// OpenGL 14.2: a primitive moved by (2, 1) covers the moved centres, ties included.
TEST(SpecificationTies, AMovedTriangleCoversTheMovedSamples) {
  for (const TieRule& rule : kConsistentRules) {
    Scene scene = kUpperHalf;
    scene.width = 6;
    scene.height = 5;
    const Drawn before = DrawnBy(scene, WithRule(rule));
    for (Vertex& v : scene.vertices) {
      v.x += 2;
      v.y += 1;
    }
    const Drawn after = DrawnBy(scene, WithRule(rule));
    for (std::size_t row = 0; row < 4; ++row) {
      EXPECT_EQ(after[row + 1].substr(2), before[row].substr(0, 4)) << TieRuleName(rule);
    }
  }
}

// X11, CreateGC; java.awt.Shape: on the boundary, inside if the interior is immediately to the
// right; on a horizontal edge, if it is immediately below.
TEST(SpecificationTies, InteriorToTheRightIsTopLeft) {
  const Scene diamond =
      SceneOf(3, 3, {{1.5, 0.5}, {2.5, 1.5}, {1.5, 2.5}, {0.5, 1.5}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(DrawnBy(diamond), (Drawn{"000", "110", "000"}))
      << "the left corner has the interior to its right; above and below the others it ends";
  const Scene square =
      SceneOf(4, 4, {{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(DrawnBy(square), (Drawn{"1100", "1100", "0000", "0000"}));
}

// Sixteenths of a pixel from its centre.
struct Sixteenths {
  int x;
  int y;
};

// Direct3D 11.3, 19.2.4, figures "Standard 2, 4, 8 and 16 Sample Pattern", in the order of the
// lists beside them.
const std::array<std::vector<Sixteenths>, 4> kFigures{
    {{{4, 4}, {-4, -4}},
     {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}},
     {{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}},
     {{1, 1},
      {-1, -3},
      {-3, 2},
      {4, -1},
      {-5, -2},
      {2, 5},
      {5, 3},
      {3, -5},
      {-2, 6},
      {0, -7},
      {-4, -6},
      {-6, 4},
      {-8, 0},
      {7, -4},
      {6, 7},
      {-7, -8}}}};

SamplePattern PatternOf(const std::vector<Sixteenths>& figure) {
  SamplePattern pattern;
  pattern.locations.clear();
  for (const auto [x, y] : figure) pattern.locations.push_back({0.5 + x / 16.0, 0.5 + y / 16.0});
  return pattern;
}

// The bits of the pixel's samples that a triangle covers, sample 0 first.
std::string Covered(const std::vector<Vertex>& triangle, const SamplePattern& pattern) {
  const Scene scene = SceneOf(1, 1, triangle, {{0, 1, 2}});
  Profile profile;
  profile.pattern = pattern;
  const CoverageCounts counts = Coverage(scene, profile);
  EXPECT_EQ(counts, Coverage(scene, profile, {}, Decider::kIntegers));
  std::string bits;
  for (int s = 0; s < counts.samples; ++s) {
    bits += std::to_string(counts.Count(counts.Index(0, 0, s)));
  }
  return bits;
}

// Half of the pixel: read off the figures, point for point.
TEST(SpecificationPatterns, PatternsOfDirect3D11Section1924) {
  const std::vector<Vertex> right{{0.5, -8}, {0.5, 9}, {9, 0.5}};
  const std::vector<Vertex> below{{-8, 0.5}, {9, 0.5}, {0.5, 9}};
  const auto covered = [](const std::vector<Vertex>& half, std::size_t k) {
    return Covered(half, PatternOf(kFigures[k]));
  };
  EXPECT_EQ(covered(right, 0), "10");
  EXPECT_EQ(covered(right, 1), "0101");
  EXPECT_EQ(covered(right, 2), "10100011");
  EXPECT_EQ(covered(right, 3), "1001011101000110") << "(0, -7) lies on the left edge: in";
  EXPECT_EQ(covered(below, 0), "10");
  EXPECT_EQ(covered(below, 1), "0011");
  EXPECT_EQ(covered(below, 2), "01101010");
  EXPECT_EQ(covered(below, 3), "1010011010011010") << "(-8, 0) lies on the top edge: in";
}

// Vulkan, Standard Sample Locations: fractions from the upper left corner.
TEST(SpecificationPatterns, StandardLocationsOfVulkanAreThoseOfDirect3D) {
  const std::array<std::vector<Point2>, 4> table{
      {{{0.75, 0.75}, {0.25, 0.25}},
       {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}},
       {{0.5625, 0.3125},
        {0.4375, 0.6875},
        {0.8125, 0.5625},
        {0.3125, 0.1875},
        {0.1875, 0.8125},
        {0.0625, 0.4375},
        {0.6875, 0.9375},
        {0.9375, 0.0625}},
       {{0.5625, 0.5625},
        {0.4375, 0.3125},
        {0.3125, 0.625},
        {0.75, 0.4375},
        {0.1875, 0.375},
        {0.625, 0.8125},
        {0.8125, 0.6875},
        {0.6875, 0.1875},
        {0.375, 0.875},
        {0.5, 0.0625},
        {0.25, 0.125},
        {0.125, 0.75},
        {0.0, 0.5},
        {0.9375, 0.25},
        {0.875, 0.9375},
        {0.0625, 0.0}}}};
  for (std::size_t k = 0; k < table.size(); ++k) {
    EXPECT_EQ(PatternOf(kFigures[k]).locations, table[k]) << k;
    EXPECT_EQ(StandardPattern(2 << k)->locations, table[k]) << k;
  }
}

TEST(SpecificationPatterns, OneSampleIsTheCentreAndOddNumbersHaveNoStandard) {
  EXPECT_EQ(StandardPattern(1), SamplePattern());
  EXPECT_FALSE(StandardPattern(0) || StandardPattern(3) || StandardPattern(32));
}

// WebGPU 23.2.5: a table for 1 and 4 samples.
TEST(SpecificationPatterns, WebGpuHasOneAndFourSamples) {
  EXPECT_EQ(SamplePattern().locations, (std::vector<Point2>{{0.5, 0.5}}));
  EXPECT_EQ(PatternOf(kFigures[1]).locations,
            (std::vector<Point2>{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}));
}

}  // namespace
}  // namespace rasterproof::exact
