#include "exact/coverage.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/primitive_ids.h"

namespace rasterproof::exact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scene MakeScene(int width, int height, std::vector<Vertex> vertices,
                std::vector<Triangle> triangles) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.precision = Precision::kFloat64;
  scene.vertices = std::move(vertices);
  scene.triangles = std::move(triangles);
  return scene;
}

// One line of digits per row, front and back together.
std::vector<std::string> Rows(const CoverageCounts& counts) {
  std::vector<std::string> rows;
  for (int row = 0; row < counts.height; ++row) {
    std::string text;
    for (int i = 0; i < counts.width; ++i) {
      text += std::to_string(counts.Count(counts.Index(i, row)));
    }
    rows.push_back(text);
  }
  return rows;
}

std::vector<std::string> RowsOf(const Scene& scene, const Profile& profile = {}) {
  const CoverageCounts fast = Coverage(scene, profile);
  EXPECT_EQ(fast, Coverage(scene, profile, {}, Decider::kIntegers));
  EXPECT_EQ(fast, Coverage(scene, profile, {}, Decider::kCgal));
  return Rows(fast);
}

using Picture = std::vector<std::string>;

// A square from centre to centre: every rule keeps the two sides it names.
const Scene kSquareOfCentres =
    MakeScene(4, 4, {{0.5, 0.5}, {2.5, 0.5}, {2.5, 2.5}, {0.5, 2.5}}, {{0, 1, 2}, {0, 2, 3}});

TEST(Coverage, KeepsTheSidesThatTheRuleNames) {
  const auto rows_of = [](const char* rule) {
    Profile profile;
    profile.tie_rule = *TieRuleFromName(rule);
    return RowsOf(kSquareOfCentres, profile);
  };
  EXPECT_EQ(rows_of("top-left"), (Picture{"1100", "1100", "0000", "0000"}));
  EXPECT_EQ(rows_of("top-right"), (Picture{"0110", "0110", "0000", "0000"}));
  EXPECT_EQ(rows_of("bottom-left"), (Picture{"0000", "1100", "1100", "0000"}));
  EXPECT_EQ(rows_of("bottom-right"), (Picture{"0000", "0110", "0110", "0000"}));
  EXPECT_EQ(rows_of("top-left-y"), (Picture{"1100", "1100", "0000", "0000"}));
  EXPECT_EQ(rows_of("inclusive"), (Picture{"2110", "1210", "1120", "0000"}));
}

TEST(Coverage, TellsWhichAxisOfTheShiftGoesFirstOnADiagonal) {
  // The diagonal x + y = 3 through centres, between two triangles: right-first and down-first agree
  // that (+, +) lies below it; (+, -) does not.
  const Scene scene = MakeScene(3, 3, {{0, 3}, {3, 0}, {0, 0}}, {{0, 1, 2}});
  const auto rows_of = [&](const char* rule) {
    Profile profile;
    profile.tie_rule = *TieRuleFromName(rule);
    return RowsOf(scene, profile);
  };
  EXPECT_EQ(rows_of("top-left"), (Picture{"110", "100", "000"}));
  EXPECT_EQ(rows_of("bottom-left"), (Picture{"110", "100", "000"}));
  EXPECT_EQ(rows_of("bottom-left-y"), (Picture{"111", "110", "100"}));
  EXPECT_EQ(rows_of("top-right"), (Picture{"111", "110", "100"}));
  EXPECT_EQ(rows_of("top-right-y"), (Picture{"110", "100", "000"}));
}

TEST(Coverage, FollowsTheScreenWhenYPointsUp) {
  // With y up the right angle is at the lower left: its flat side is a bottom side and excluded.
  Scene scene = MakeScene(3, 3, {{0.5, 0.5}, {2.5, 0.5}, {0.5, 2.5}}, {{0, 1, 2}});
  Profile up;
  up.y_axis = YAxis::kUp;
  EXPECT_EQ(RowsOf(scene, up), (Picture{"000", "100", "000"}));
  EXPECT_EQ(RowsOf(scene), (Picture{"110", "100", "000"}));
  const CoverageCounts counts = Coverage(scene, up);
  EXPECT_EQ(counts.front[counts.Index(0, 1)], 1U) << "counter-clockwise on screen with y up";
  EXPECT_EQ(Coverage(scene, {}).back[counts.Index(0, 0)], 1U);
}

TEST(Coverage, TakesAsymmetricSampleLocationsFromThePixelsOwnCorner) {
  // Only y in [0, 1/4] is covered: location (1/2, 1/8) of row 0, wherever y points.
  const Scene scene =
      MakeScene(2, 2, {{0, 0}, {2, 0}, {2, 0.25}, {0, 0.25}}, {{0, 1, 2}, {0, 2, 3}});
  Profile profile;
  profile.pattern.locations = {{0.5, 0.125}, {0.5, 0.875}};
  CoverageCounts counts = Coverage(scene, profile);
  EXPECT_EQ(counts.Count(counts.Index(0, 0, 0)), 1U);
  EXPECT_EQ(counts.Count(counts.Index(0, 0, 1)), 0U);
  EXPECT_EQ(counts.Count(counts.Index(1, 1, 0)), 0U);
  profile.y_axis = YAxis::kUp;
  counts = Coverage(scene, profile);
  EXPECT_EQ(counts.Count(counts.Index(0, 1, 0)), 1U) << "pixel row 0 is the bottom row";
  EXPECT_EQ(counts.Count(counts.Index(0, 1, 1)), 0U);
  EXPECT_EQ(counts.Count(counts.Index(0, 0, 0)), 0U);
}

TEST(Coverage, CullsAndScissors) {
  const Scene scene =
      MakeScene(3, 1, {{0, 0}, {3, 0}, {0, 9}, {3, 9}}, {{0, 2, 1}, {1, 2, 3}, {0, 1, 2}});
  DrawOptions options;
  options.cull = Cull::kFront;
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"111"});
  options.cull = Cull::kBack;
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"111"});
  options.cull = Cull::kNone;
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"222"});
  options.scissor = PixelRect{1, -5, 2, 100};
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"020"});
  options.scissor = PixelRect{2, 0, 1, 1};
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"000"}) << "an empty scissor";
  options.scissor = PixelRect{7, 7, 9, 9};
  EXPECT_EQ(Rows(Coverage(scene, {}, options)), Picture{"000"}) << "off the target";
}

TEST(Coverage, CoversNothingWithoutAreaOrWithoutFiniteCorners) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Scene scene = MakeScene(
      2, 2,
      {{0, 0}, {2, 2}, {4, 4}, {-3, 8}, {nan, 0}, {0, kInfinity}, {9, 0, nan}, {0, 0, 0, nan}},
      {{0, 1, 2}, {0, 0, 3}, {0, 3, 4}, {0, 3, 5}, {3, 1, 1}, {3, 2, 7}});
  EXPECT_EQ(RowsOf(scene), (Picture{"00", "00"}));
  scene.triangles = {{0, 3, 6}};
  EXPECT_EQ(RowsOf(scene), (Picture{"11", "11"})) << "z is nobody's business";
}

TEST(Coverage, IsRightForCoordinatesOfBothEndsAtOnce) {
  const double max = std::numeric_limits<double>::max();
  // The half planes on either side of x + y = 0, made of huge corners; then the origin as a sample.
  const Scene above =
      MakeScene(2, 1, {{-1e30, -1e30}, {0x1p99, -0x1p99}, {-0x1p99, 0x1p99}}, {{0, 1, 2}});
  const Scene below =
      MakeScene(2, 1, {{1e30, 1e30}, {0x1p99, -0x1p99}, {-0x1p99, 0x1p99}}, {{0, 1, 2}});
  Profile corner;
  corner.pattern.locations = {{0, 0}};
  EXPECT_EQ(RowsOf(above), (Picture{"00"}));
  EXPECT_EQ(RowsOf(below), (Picture{"11"}));
  EXPECT_EQ(RowsOf(above, corner), (Picture{"00"}));
  EXPECT_EQ(RowsOf(below, corner), (Picture{"11"})) << "its left side passes through the origin";
  const Scene all = MakeScene(2, 2, {{-max, -max}, {max, -max}, {0, max}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(all), (Picture{"11", "11"}));
  // A sliver 1e-30 wide along the left side of the centres x = 1/2, and one along their right side.
  const Scene slivers = MakeScene(2, 2, {{0.5, -1}, {0.5, 5}, {0.5 + 1e-16, 2}, {0.5 - 1e-16, 2}},
                                  {{0, 1, 2}, {0, 1, 3}});
  EXPECT_EQ(RowsOf(slivers), (Picture{"10", "10"})) << "x = 1/2 is the left side of the first only";
  const Scene subnormal =
      MakeScene(1, 1, {{0.5, 0.5}, {0.5, 0.5 + 0x1p-53}, {0.5 - 0x1p-54, 0.5}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(subnormal), (Picture{"0"}));
  const Scene least = MakeScene(1, 1, {{0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(least, corner), (Picture{"1"})) << "its top left corner is a sample";
}

TEST(Coverage, IsInstantFarOffAndOnTheLargestTargets) {
  Scene scene =
      MakeScene(kMaxTargetSide, 16, {{-1e30, -1e30}, {1e30, -1e30}, {7, 1e30}, {3e38, 3e38}},
                {{0, 1, 2}, {0, 1, 3}});
  const TierScope scope;
  const CoverageCounts counts = Coverage(scene, {});
  EXPECT_EQ(counts.Count(0), 2U) << "the second one's left side y = x passes through the centre";
  EXPECT_EQ(counts.Count(counts.Index(0, 1)), 1U);
  EXPECT_LT(scope.Counts().filter + scope.Counts().stable + scope.Counts().exact +
                scope.Counts().symbolic,
            16U * 4 * 20)
      << "a row takes two crossings, a crossing at most log2(65536) signs more";
  scene.width = 16;
  scene.height = kMaxTargetSide;
  EXPECT_EQ(Coverage(scene, {}).Count(0), 2U);
}

TEST(Coverage, CountsSamplesAndNotPixelsAgainstTheLargestTarget) {
  Scene scene = MakeScene(16384, 16384, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  Profile four = *PresetProfile("real");
  four.pattern.locations.assign(4, {0.5, 0.5});
  EXPECT_THROW(Coverage(scene, four), InputError);
}

TEST(Coverage, SnapsBeforeItDecides) {
  const Profile d3d11 = *PresetProfile("d3d11-canonical");
  // 1/2 + 1/1024 snaps to the centre: top-left keeps the left side.
  const Scene scene =
      MakeScene(2, 1, {{0.5 + 0x1p-10, -4}, {9, 0.5}, {0.5 + 0x1p-10, 5}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(scene), (Picture{"01"}));
  EXPECT_EQ(RowsOf(scene, d3d11), (Picture{"11"}));
  const Scene sliver = MakeScene(2, 1, {{0.5, -4}, {0.5 + 0x1p-10, 0.5}, {0.5, 5}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(sliver), (Picture{"10"}));
  EXPECT_EQ(RowsOf(sliver, d3d11), (Picture{"00"})) << "no area is left";
}

TEST(Coverage, SnapsInTheProfilesOwnAxes) {
  // Floor moves -1/512 down by a step in its own axis, not up in the screen's.
  Profile up;
  up.y_axis = YAxis::kUp;
  up.snap = {8, SnapRule::kFloor};
  const Scene scene =
      MakeScene(1, 1, {{-9, 0.5 + 0x1p-10}, {9, 0.5 + 0x1p-10}, {0, -9}}, {{0, 1, 2}});
  EXPECT_EQ(RowsOf(scene, up), (Picture{"1"})) << "the top side snaps onto the centre from above";
  up.tie_rule = *TieRuleFromName("bottom-left");
  EXPECT_EQ(RowsOf(scene, up), (Picture{"0"}));
}

TEST(Coverage, SnapsTheRationalQuotientOfClipSpace) {
  const Profile d3d11 = *PresetProfile("d3d11-canonical");
  Scene scene = MakeScene(3, 1, {{1.5, -12, 0, 3}, {27, 1.5, 0, 3}, {1.5, 15, 0, 3}}, {{0, 1, 2}});
  scene.clip_space = true;
  EXPECT_EQ(RowsOf(scene, d3d11), (Picture{"111"})) << "x / w = 1/2, a left side";
  scene.vertices[0].w = 0;
  EXPECT_THROW(Coverage(scene, d3d11), InputError);
  scene.vertices[0] = {1e300, 0, 0, 1e-300};
  EXPECT_THROW(Coverage(scene, d3d11), InputError);
  scene.vertices[0].x = kInfinity;
  EXPECT_EQ(RowsOf(scene, d3d11), (Picture{"000"}))
      << "a triangle that is not finite covers nothing";
}

TEST(Coverage, RefusesSampleLocationsThatCouldRound) {
  Profile profile;
  profile.pattern.locations = {{1.0 / 3, 0.5}};
  EXPECT_THROW(Coverage(kSquareOfCentres, profile), InputError);
  profile.pattern.locations = {{0.5, 1}};
  EXPECT_THROW(Coverage(kSquareOfCentres, profile), InputError);
}

// What Coverage throws, or nothing.
std::string ThrownBy(const Scene& scene, const Profile& profile) {
  try {
    Coverage(scene, profile);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(WhyNotDecided, SaysBeforehandWhatCoverageThrows) {
  const Profile d3d11 = *PresetProfile("d3d11-canonical");
  Scene scene = MakeScene(3, 1, {{1.5, -12, 0, 3}, {27, 1.5, 0, 3}, {1.5, 15, 0, 3}}, {{0, 1, 2}});
  scene.clip_space = true;
  std::vector<std::pair<Scene, Profile>> undecided{{scene, d3d11}, {scene, d3d11}, {scene, d3d11},
                                                   {scene, d3d11}, {scene, d3d11}, {scene, d3d11}};
  undecided[0].first.vertices[0].w = 0;
  undecided[1].first.vertices[0] = {1e300, 0, 0, 1e-300};
  undecided[2].second.snap.form = SnapForm::kExactDifference;
  undecided[3].second.max_primitive_extent = MaxPrimitiveExtent{4, 4};
  undecided[4].second.pattern.locations = {{1.0 / 3, 0.5}};
  undecided[5].first.width = 0;
  std::set<std::string> reasons;
  for (const auto& [c, profile] : undecided) {
    const std::optional<InputError> why = WhyNotDecided({c, profile});
    ASSERT_TRUE(why.has_value());
    EXPECT_EQ(why->what(), ThrownBy(c, profile));
    EXPECT_THROW(PrimitiveIds({c, profile}, {}, Visible::kLastDrawn), InputError) << why->what();
    reasons.insert(why->what());
  }
  EXPECT_EQ(reasons.size(), undecided.size());
  EXPECT_FALSE(WhyNotDecided({scene, d3d11}).has_value());
  EXPECT_EQ(ThrownBy(scene, d3d11), "");
}

TEST(Covers, AsksOnePointUnderTheRule) {
  const std::array<Point2, 3> v{{{0, 0}, {4, 0}, {0, 4}}};
  const std::array<Point2, 3> reversed{v[2], v[1], v[0]};
  for (const auto& t : {v, reversed}) {
    EXPECT_TRUE(Covers(t, {1, 1}, kTopLeft));
    EXPECT_TRUE(Covers(t, {0, 0}, kTopLeft));
    EXPECT_FALSE(Covers(t, {2, 2}, kTopLeft));
    EXPECT_TRUE(Covers(t, {2, 2}, {.inclusive = true}));
    EXPECT_FALSE(Covers(t, {2.5, 2}, {.inclusive = true}));
  }
  EXPECT_EQ(Facing(v), -Facing(reversed));
  EXPECT_EQ(Facing(v), -1) << "right, then down: clockwise on screen";
  EXPECT_FALSE(Covers({{{0, 0}, {1, 1}, {2, 2}}}, {1, 1}, {.inclusive = true}));
}

// The last or first triangle that covers a sample, by the coverage of each alone.
std::vector<std::int32_t> PrimitiveIdsOneByOne(const Scene& scene, const Profile& profile,
                                               const DrawOptions& options, Visible order) {
  std::vector<std::int32_t> primitive_ids;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    Scene one = scene;
    one.triangles = {scene.triangles[t]};
    const CoverageCounts alone = Coverage(one, profile, options);
    primitive_ids.resize(alone.size(), kNoPrimitive);
    for (std::size_t k = 0; k < alone.size(); ++k) {
      const bool wins = order == Visible::kLastDrawn || primitive_ids[k] == kNoPrimitive;
      if (alone.Count(k) != 0 && wins) primitive_ids[k] = static_cast<std::int32_t>(t);
    }
  }
  return primitive_ids;
}

TEST(PrimitiveIds, AreTheLastOrTheFirstOfTheTrianglesThatCoverASample) {
  Scene scene = MakeScene(9, 7, {}, {});
  std::mt19937_64 bits(7);
  for (int k = 0; k < 60; ++k) {
    const auto coordinate = [&] { return static_cast<double>(bits() % 40) / 4; };
    scene.vertices.push_back({coordinate(), coordinate(), 0, 1 + static_cast<double>(k % 3)});
  }
  for (std::int32_t t = 0; t < 20; ++t) scene.triangles.push_back({t, t + 20, t + 40});
  Profile four;
  four.pattern.locations = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  four.y_axis = YAxis::kUp;
  for (const bool clip_space : {false, true}) {
    scene.clip_space = clip_space;
    for (const Visible order : {Visible::kLastDrawn, Visible::kFirstDrawn}) {
      for (const Cull cull : {Cull::kNone, Cull::kBack}) {
        for (const Profile& profile : {Profile{}, four}) {
          DrawOptions options;
          options.cull = cull;
          options.scissor = PixelRect{1, 1, 8, 7};
          EXPECT_EQ(PrimitiveIds({scene, profile}, options, order),
                    PrimitiveIdsOneByOne(scene, profile, options, order));
        }
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof::exact
