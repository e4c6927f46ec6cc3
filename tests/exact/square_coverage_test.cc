// What square profiles say of scenes: bounds, presets, and what a profile leaves open.
#include "exact/square_coverage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "core/square_presets.h"
#include "exact/coverage.h"
#include "tests/exact/square_shapes.h"
#include "tests/share.h"

namespace rasterproof::exact {
namespace {

Scene SceneOf(const std::vector<std::array<Point2, 3>>& triangles) {
  Scene scene;
  scene.width = kSquareTargetSide;
  scene.height = kSquareTargetSide;
  scene.precision = Precision::kFloat64;
  for (const auto& v : triangles) {
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    for (const Point2& p : v) scene.vertices.push_back({p.x, p.y});
    scene.triangles.push_back({first, first + 1, first + 2});
  }
  return scene;
}

std::string Picture(const CoverageCounts& counts) {
  std::string text;
  for (int row = 0; row < counts.height; ++row) {
    for (int i = 0; i < counts.width; ++i) {
      text += counts.Count(counts.Index(i, row)) != 0 ? '#' : '.';
    }
    text += '/';
  }
  return text;
}

std::string Must(std::string_view preset, const std::array<Point2, 3>& v) {
  return Picture(MustCover({SceneOf({v}), *PresetProfile(preset)}));
}

std::string May(std::string_view preset, const std::array<Point2, 3>& v) {
  return Picture(MayCover({SceneOf({v}), *PresetProfile(preset)}));
}

Profile Lenient(Profile profile) {
  profile.coordinate_limit = 0x1p127;
  return profile;
}

TEST(SquarePresets, MustCoverNothingThatTheyMayNot) {
  SquareDraw draw(21);
  std::uint64_t covered = 0;
  std::uint64_t between = 0;
  for (int k = 0; k < Cases(4000); ++k) {
    const Scene scene = SceneOf({draw.Triangle()});
    for (const SquarePresetInfo& preset : kSquarePresets) {
      const Profile profile = *PresetProfile(preset.name);
      if (!profile.squares->must || !profile.squares->may) continue;
      const CoverageCounts must = MustCover({scene, profile});
      const CoverageCounts may = MayCover({scene, profile});
      for (std::size_t i = 0; i < must.size(); ++i) {
        ASSERT_LE(must.Count(i), may.Count(i))
            << preset.name << " " << k << Picture(must) << " " << Picture(may);
        covered += must.Count(i);
        between += may.Count(i) - must.Count(i);
      }
    }
  }
  EXPECT_GT(covered, 1000U);
  EXPECT_GT(between, 1000U);
}

// A tolerance of a step: whatever place each vertex takes, the bounds keep to it.
TEST(SquareBounds, HoldForEveryLegalPlaceOfTheVertices) {
  SquareDraw draw(22);
  std::mt19937_64 bits(23);
  for (const std::string_view name :
       {"d3d12-conservative-2", "d3d12-inner", "vulkan-overestimate", "vulkan-underestimate"}) {
    const Profile profile = Lenient(*PresetProfile(name));
    Profile chosen = profile;
    chosen.freedom = {};
    const Freedom& freedom = profile.freedom;
    const double step = std::ldexp(1.0, -freedom.least_bits.value_or(profile.snap.bits));
    const double reach = (freedom.any_rounding ? 1 : freedom.snap_tolerance) * step;
    for (int k = 0; k < Cases(2000); ++k) {
      const std::array<Point2, 3> given = draw.Triangle();
      std::array<Point2, 3> placed;
      const auto place = [&](double x) {
        const double low = std::floor(x / step) * step;
        const double other = bits() % 2 == 0 ? low : low + step;
        return std::fabs(other - x) <= reach ? other : std::round(x / step) * step;
      };
      for (std::size_t c = 0; c < 3; ++c) placed[c] = {place(given[c].x), place(given[c].y)};
      const Scene scene = SceneOf({given});
      const Scene moved = SceneOf({placed});
      for (const bool must : {true, false}) {
        const auto& region = must ? profile.squares->must : profile.squares->may;
        if (!region || region->geometry == SquareGeometry::kGiven) continue;
        const CoverageCounts bound =
            must ? MustCover({scene, profile}) : MayCover({scene, profile});
        const CoverageCounts truth = must ? MustCover({moved, chosen}) : MayCover({moved, chosen});
        for (std::size_t i = 0; i < truth.size(); ++i) {
          const bool holds =
              must ? bound.Count(i) <= truth.Count(i) : bound.Count(i) >= truth.Count(i);
          ASSERT_TRUE(holds) << name << " " << k << (must ? " must" : " may");
        }
      }
    }
  }
}

TEST(SquarePresets, SayWhatTouchesAndWhatDoesNot) {
  // The square of pixel (1, 1), both halves' hypotenuse through (1, 2) and (2, 1).
  const std::array<Point2, 3> half{{{1, 1}, {2, 1}, {1, 2}}};
  EXPECT_EQ(Must("voxel", half), "###./###./##../..../") << "(2, 2) is the only neighbour apart";
  EXPECT_EQ(Must("gdal-all-touched", half), "..../.#../..../..../");
  EXPECT_EQ(May("gdal-all-touched", half), "###./###./##../..../") << "0.01 pixel more";
  EXPECT_EQ(Must("d3d12-conservative-2", half), "..../.#../..../..../");
  EXPECT_EQ(May("d3d12-conservative-2", half), "###./###./##../..../");
  EXPECT_EQ(Must("d3d12-inner", half), "..../..../..../..../");
}

TEST(SquarePresets, OfPdfTakeFloorSidesOnly) {
  // y up: pixel row j = 1 is the third of four from the top.
  const std::array<Point2, 3> half{{{1, 1}, {2, 1}, {1, 2}}};
  EXPECT_EQ(Must("pdf-fill", half), "..../..../.#../..../");
  EXPECT_EQ(May("pdf-fill", half), "..../.#../.##./..../")
      << "the boundary passes (2, 1) and (1, 2)";
  // "A zero-width or zero-height rectangle paints a line 1 pixel wide."
  const std::array<Point2, 3> line{{{0.5, 2}, {2.5, 2}, {1.5, 2}}};
  EXPECT_EQ(Must("pdf-fill", line), "..../###./..../..../");
  EXPECT_EQ(May("pdf-fill", line), "..../###./..../..../");
}

TEST(SquarePresets, DrawFlatTrianglesOrNot) {
  const std::array<Point2, 3> point{{{1.5, 1.5}, {1.5, 1.5}, {1.5, 1.5}}};
  EXPECT_EQ(Must("voxel", point), "..../.#../..../..../");
  EXPECT_EQ(Must("d3d12-conservative-1", point), "..../..../..../..../");
  EXPECT_EQ(May("d3d12-conservative-1", point), "###./###./###./..../") << "half a pixel more";
  EXPECT_EQ(Must("d3d12-conservative-2", point), "..../.#../..../..../");
  EXPECT_EQ(May("vulkan-underestimate", point), "..../..../..../..../");
  // On a crossing: four closed squares, no open one, one half-open one.
  const std::array<Point2, 3> crossing{{{2, 2}, {2, 2}, {2, 2}}};
  EXPECT_EQ(Must("voxel", crossing), "..../.##./.##./..../");
  EXPECT_EQ(Must("d3d12-conservative-2", crossing), "..../..../..../..../");
  EXPECT_EQ(Must("pdf-fill", crossing), "..../..#./..../..../");
  // Flat once snapped, not before: 1/1024 pixel high.
  const std::array<Point2, 3> thin{{{0.25, 1.5}, {3.75, 1.5}, {2, 1.5 + 0x1p-10}}};
  EXPECT_EQ(Must("d3d12-conservative-1", thin), "..../..../..../..../");
  EXPECT_EQ(Must("d3d12-conservative-2", thin), "..../####/..../..../");
}

TEST(SquarePresets, OfATriangleThatNamesAVertexTwiceMayDropIt) {
  Scene scene = SceneOf({{{{0.5, 0.5}, {2.5, 2.5}, {0, 0}}}});
  scene.triangles = {{0, 1, 1}};
  const Profile d3d = *PresetProfile("d3d12-conservative-2");
  EXPECT_EQ(Picture(MustCover({scene, d3d})), "..../..../..../..../");
  EXPECT_NE(Picture(MayCover({scene, d3d})), "..../..../..../..../");
}

TEST(SquareCoverage, IsCulledCutAndCountedForEverySample) {
  Profile profile = *PresetProfile("voxel");
  profile.name = "two samples";
  profile.pattern.locations = {{0.25, 0.25}, {0.75, 0.75}};
  const Scene scene = SceneOf({{{{0.5, 0.5}, {0.75, 0.5}, {0.5, 0.75}}}});
  DrawOptions options;
  EXPECT_EQ(Coverage(scene, profile, options).Count(0), 1U);
  EXPECT_EQ(Coverage(scene, profile, options).Count(1), 1U);
  options.scissor = PixelRect{1, 0, 4, 4};
  EXPECT_EQ(Coverage(scene, profile, options),
            CoverageCounts(kSquareTargetSide, kSquareTargetSide, 2));
  options.scissor.reset();
  const Cull other = Coverage(scene, profile, options).front[0] != 0 ? Cull::kFront : Cull::kBack;
  options.cull = other;
  EXPECT_EQ(Coverage(scene, profile, options),
            CoverageCounts(kSquareTargetSide, kSquareTargetSide, 2));
}

TEST(SquareCoverage, IsNotDecidedInClipSpaceNorByASecondOpinion) {
  Scene scene = SceneOf({{{{0, 0}, {1, 0}, {0, 1}}}});
  const Profile voxel = *PresetProfile("voxel");
  EXPECT_FALSE(WhyNotDecided({scene, voxel}));
  EXPECT_THROW(Coverage(scene, voxel, {}, Decider::kCgal), InputError);
  scene.clip_space = true;
  EXPECT_TRUE(WhyNotDecided({scene, voxel}));
}

}  // namespace
}  // namespace rasterproof::exact
