// Coverage of every method, against pictures drawn by hand and against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "model/snap_scene.h"
#include "tests/reference/brute_force.h"
#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(CoverageTest, ARightTriangleCoversItsPictureByEveryMethod) {
  const Scene scene = WindowScene(5, 4, {{0, 0}, {4, 0}, {0, 4}});
  for (const std::string& name : WindowMethods()) {
    // The diagonal runs through centres and is a right edge: only the textbook counts them.
    const std::string expected =
        name == "textbook" ? "11110\n11100\n11000\n10000\n" : "11100\n11000\n10000\n00000\n";
    EXPECT_EQ(Picture(Draw(scene, name)), expected) << name;
  }
}

TEST(CoverageTest, PositiveAreaIsFrontAndCounterClockwiseOnScreen) {
  const Scene counter_clockwise = WindowScene(3, 3, {{0, 0}, {0, 3}, {3, 0}});
  const Scene clockwise = WindowScene(3, 3, {{0, 0}, {3, 0}, {0, 3}});
  for (const std::string& name : WindowMethods()) {
    EXPECT_EQ(Draw(counter_clockwise, name).front[0], 1U) << name;
    EXPECT_EQ(Draw(counter_clockwise, name).back[0], 0U) << name;
    EXPECT_EQ(Draw(clockwise, name).front[0], 0U) << name;
    EXPECT_EQ(Draw(clockwise, name).back[0], 1U) << name;
  }
}

// All 5^6 triangles on a half-pixel lattice: vertices on centres, edges through centres, every
// degenerate, both windings, all rotations. Arithmetic is exact there for every method.
TEST(CoverageTest, EveryTriangleOfAHalfPixelLatticeIsOwnedTopLeftByEveryMethod) {
  Scene scene = WindowScene(2, 2, {{}, {}, {}});
  std::vector<Scene> scenes;
  for (int n = 0; n < 15625; n += kOneCaseIn > 1 ? 17 : 1) {
    int digits = n;
    for (Vertex& v : scene.vertices) {
      v.x = digits % 5 * 0.5;
      v.y = digits / 5 % 5 * 0.5;
      digits /= 25;
    }
    scenes.push_back(scene);
  }
  std::vector<CoverageCounts> expected;
  for (const Scene& s : scenes) expected.push_back(BruteForceCounts(s));
  for (const std::string& name : WindowMethods()) {
    if (name == "textbook") continue;
    int wrong = 0;
    for (std::size_t n = 0; n < scenes.size(); ++n) {
      if (Draw(scenes[n], name) != expected[n]) ++wrong;
    }
    EXPECT_EQ(wrong, 0) << name;
  }
}

TEST(CoverageTest, TextbookCoversSamplesOnASharedEdgeTwice) {
  const Scene square = WindowScene(3, 3, {{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(Picture(Draw(square, "textbook")), "211\n121\n112\n");
  EXPECT_EQ(Picture(Draw(square, "f32-direct")), "111\n111\n111\n");
}

TEST(CoverageTest, ZeroAreaAndNonFiniteTrianglesCoverNothing) {
  const std::vector<std::vector<Point2>> nothing{
      {{1, 1}, {1, 1}, {1, 1}},           {{0, 0}, {4, 4}, {2, 2}},
      {{0.5, 0.5}, {3.5, 0.5}, {2, 0.5}}, {{0, 0}, {kNaN, 0}, {0, 4}},
      {{0, 0}, {4, kNaN}, {0, 4}},        {{0, 0}, {kInfinity, 0}, {0, 4}},
      {{0, 0}, {4, 0}, {0, -kInfinity}},  {{0, 0}, {0, 0}, {4, 4}},
  };
  for (const auto& points : nothing) {
    const Scene scene = WindowScene(4, 4, points);
    for (const std::string& name : WindowMethods()) {
      EXPECT_EQ(Draw(scene, name), CoverageCounts(4, 4)) << name;
    }
  }
}

TEST(CoverageTest, DepthNeverAffectsCoverage) {
  Scene scene = WindowScene(4, 4, {{0, 0}, {4, 0}, {0, 4}});
  const Scene flat = scene;
  scene.vertices[0].z = kNaN;
  scene.vertices[1].z = -kInfinity;
  for (const std::string& name : WindowMethods()) EXPECT_EQ(Draw(scene, name), Draw(flat, name));
}

TEST(CoverageTest, CullingDropsOneFacingOnly) {
  const Scene scene = WindowScene(6, 6, {{0, 0}, {6, 0}, {0, 6}, {1, 1}, {1, 6}, {6, 1}});
  for (const std::string& name : WindowMethods()) {
    const CoverageCounts all = Draw(scene, name);
    RasterOptions options;
    options.cull = Cull::kFront;
    const CoverageCounts back = Draw(scene, name, options);
    options.cull = Cull::kBack;
    const CoverageCounts front = Draw(scene, name, options);
    const std::vector<std::uint32_t> none(all.size(), 0);
    EXPECT_EQ(back.front, none) << name;
    EXPECT_EQ(back.back, all.back) << name;
    EXPECT_EQ(front.front, all.front) << name;
    EXPECT_EQ(front.back, none) << name;
    EXPECT_NE(all.front, none) << name;
    EXPECT_NE(all.back, none) << name;
  }
}

TEST(CoverageTest, IntegerMethodsDrawTheSnappedScene) {
  RandomValues random(3);
  for (const std::string name : {"i64-snap8", "i32-snap4"}) {
    const Profile& profile = FindMethod(name)->info.profile;
    const double step = std::ldexp(1.0, -profile.snap.bits);
    std::uint64_t covered = 0;
    for (int n = 0; n < std::max(Cases(300), 60); ++n) {
      std::vector<Point2> points;
      for (int k = 0; k < 6; ++k) {
        // A quarter step off the grid, or exactly between two grid points: ties go to even.
        const auto coordinate = [&] {
          return (random.Integer(-40, 200) + random.Integer(0, 3) * 0.25) * step +
                 random.Integer(0, 7);
        };
        points.push_back({coordinate(), coordinate()});
      }
      const Scene scene = WindowScene(8, 8, points);
      const CoverageCounts expected = BruteForceCounts(SnapScene(scene, {profile, scene}));
      const CoverageDifference d = Compare(Draw(scene, name), expected);
      EXPECT_EQ(d.wrong, 0U) << name << " scene " << n;
      covered += d.covered;
    }
    EXPECT_GT(covered, 300U);
  }
}

TEST(CoverageTest, ScenesThatAMethodDoesNotTakeAreRefusedWithARemedy) {
  Scene clip = WindowScene(4, 4, {{0, 0}, {4, 0}, {0, 4}});
  clip.clip_space = true;
  for (const std::string& name : WindowMethods()) {
    if (FindMethod(name)->info.takes_clip) continue;
    try {
      Draw(clip, name);
      ADD_FAILURE() << name << " drew a clip-space scene";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("hom-"), std::string::npos);
    }
  }
  Scene wide = WindowScene(4, 4, {{0, 0}, {4, 0}, {0, 4}});
  wide.precision = Precision::kFloat64;
  EXPECT_THROW(Draw(wide, "f32-direct"), InputError);
  EXPECT_NO_THROW(Draw(wide, "f64-direct"));
  CoverageCounts small(3, 4);
  EXPECT_THROW(Rasterize(wide, *FindMethod("f64-direct"), {}, small), InputError);
}

}  // namespace
}  // namespace rasterproof::reference
