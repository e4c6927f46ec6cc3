// Wrapping, the model of a target, dropping, and all stages in their order.
#include "model/snap_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "model/drop.h"
#include "model/target_profile.h"
#include "model/wrap.h"

namespace rasterproof {
namespace {

constexpr FixedInput kSigned{12, 4, true, true};
constexpr FixedInput kUnsigned{10, 6, false, true};
constexpr double kStep = 0x1p-4;

TEST(Wrapped, GoesToTheOtherEnd) {
  EXPECT_EQ(Wrapped(2048, kSigned), -2048);
  EXPECT_EQ(Wrapped(2048 - kStep, kSigned), 2048 - kStep);
  EXPECT_EQ(Wrapped(-2048, kSigned), -2048);
  EXPECT_EQ(Wrapped(-2048 - kStep, kSigned), 2048 - kStep);
  EXPECT_EQ(Wrapped(3 * 4096.0 + 5.25, kSigned), 5.25);
  EXPECT_EQ(Wrapped(-0x1p-6, kUnsigned), 1024 - 0x1p-6);
  EXPECT_EQ(Wrapped(1024, kUnsigned), 0);
  EXPECT_TRUE(std::isnan(Wrapped(std::numeric_limits<double>::quiet_NaN(), kSigned)));
  const FixedInput still{12, 4, true, false};
  EXPECT_EQ(Wrapped(5000, still), 5000);
}

// By integers, as the hardware does it: the low bits, the highest of them read as the sign.
TEST(Wrapped, IsWhatIntegersDo) {
  for (std::int64_t raw = -200000; raw < 200000; raw += 7) {
    const double x = std::ldexp(static_cast<double>(raw), -4);
    EXPECT_EQ(Wrapped(x, kSigned), std::ldexp(static_cast<std::int16_t>(raw), -4)) << raw;
    const double y = std::ldexp(static_cast<double>(raw), -6);
    EXPECT_EQ(Wrapped(y, kUnsigned), std::ldexp(static_cast<std::uint16_t>(raw), -6)) << raw;
  }
}

Profile WithTargets() {
  Profile profile;
  profile.snap = {4};
  profile.by_target_size = {{.max_width = 2048, .max_height = 1024, .snap = {8}},
                            {.max_width = 4096, .max_height = 4096, .snap = {6}}};
  return profile;
}

TEST(TargetProfile, TakesTheFirstModelThatFitsBothSides) {
  const auto bits = [](int width, int height) {
    return TargetProfile(WithTargets(), width, height).snap.bits;
  };
  EXPECT_EQ(bits(1, 1), 8);
  EXPECT_EQ(bits(2048, 1024), 8);
  EXPECT_EQ(bits(2049, 1), 6);
  EXPECT_EQ(bits(1, 1025), 6);
  EXPECT_EQ(bits(4096, 4096), 6);
  EXPECT_EQ(bits(4097, 1), 4);
}

TEST(TargetProfile, HasOneModel) {
  EXPECT_TRUE(TargetProfile(WithTargets(), 16, 16).by_target_size.empty());
  EXPECT_EQ(TargetProfile(Profile{}, 16, 16), Profile{});
}

Scene OneTriangle(std::array<Point2, 3> v) {
  Scene scene;
  scene.precision = Precision::kFloat64;
  for (const Point2 p : v) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles = {{0, 1, 2}};
  return scene;
}

TEST(SnapScene, WrapsFirstAndSnapsThen) {
  Profile profile;
  profile.fixed = kSigned;
  profile.snap = {0, SnapRule::kFloor};
  const Scene scene = OneTriangle({{{4096 + 1.75, -2049}, {2047.5, 3}, {0, 0}}});
  const Scene placed = SnapScene(scene, {profile, scene});
  EXPECT_EQ(WindowPoint(placed.vertices[0]), (Point2{1, 2047}));
  EXPECT_EQ(WindowPoint(placed.vertices[1]), (Point2{2047, 3}));
}

TEST(SnapScene, UsesTheModelOfTheTarget) {
  Scene scene = OneTriangle({{{0x1p-7, 0}, {4, 0}, {0, 4}}});
  EXPECT_EQ(SnapScene(scene, {WithTargets(), scene}).vertices[0].x, 0x1p-7);
  scene.width = 4097;
  EXPECT_EQ(SnapScene(scene, {WithTargets(), scene}).vertices[0].x, 0);
}

TEST(SnapScene, PutsWhatIsTooLargeIntoOnePlace) {
  Profile profile;
  profile.snap = {4};
  profile.max_primitive_extent = MaxPrimitiveExtent{1024, 512};
  const auto is_kept = [&](Point2 far) {
    const Scene scene = OneTriangle({{{0, 0}, far, {0, 3}}});
    return SnapScene(scene, {profile, scene}).triangles[0] == Triangle{0, 1, 2};
  };
  EXPECT_TRUE(is_kept({1024, 2}));
  EXPECT_TRUE(is_kept({1024 + 0x1p-6, 2}));  // snaps to the largest extent
  EXPECT_FALSE(is_kept({1024 + kStep, 2}));
  EXPECT_TRUE(is_kept({-1024, -509}));
  EXPECT_FALSE(is_kept({5, 512 + kStep}));
  EXPECT_FALSE(is_kept({5, -509 - kStep}));
}

TEST(Exceeds, DoesNotRound) {
  const auto exceeds = [](double low, double high) {
    return Exceeds({{{low, 0}, {high, 0}, {0, 1}}}, {1, 8});
  };
  EXPECT_FALSE(exceeds(0, 1));
  EXPECT_TRUE(exceeds(-0x1p-80, 1));
  EXPECT_FALSE(exceeds(0x1p-80, 1));
  EXPECT_TRUE(exceeds(0, 1 + 0x1p-52));
  EXPECT_TRUE(exceeds(-1e308, 1e308));
}

TEST(FinitenessOf, DecidesByZThenByNanThenByInfinity) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const auto said = [](const Vertex& a, const Vertex& b, const Profile& profile) {
    return FinitenessOf({a, b, Vertex{1, 2, 0, 1}}, profile);
  };
  const Vertex finite{3, 4, 0.5, 1}, of_nan{nan, 4, 0.5, 1}, infinite{3, infinity, 0.5, 1},
      of_nan_z{3, 4, nan, 1};
  Profile profile;  // NaNs and infinities cover nothing, z is ignored
  EXPECT_EQ(said(finite, of_nan_z, profile), Finiteness::kPlaced);
  EXPECT_EQ(said(finite, of_nan, profile), Finiteness::kCoversNothing);
  profile.infinite_vertex = InfiniteVertex::kUnspecified;
  EXPECT_EQ(said(finite, infinite, profile), Finiteness::kUnstated);
  EXPECT_EQ(said(of_nan, infinite, profile), Finiteness::kCoversNothing);
  profile.nan_vertex = NanVertex::kUnspecified;
  EXPECT_EQ(said(of_nan, infinite, profile), Finiteness::kUnstated);
  profile.nan_z = NanZ::kUnspecified;
  EXPECT_EQ(said(finite, of_nan_z, profile), Finiteness::kUnstated);
  profile.nan_z = NanZ::kNothing;
  EXPECT_EQ(said(of_nan_z, of_nan, profile), Finiteness::kCoversNothing);
}

TEST(IsUnclipped, AsksForEveryCornerBeforeAndAfterSnapping) {
  Profile profile;
  profile.snap = {0};
  profile.guard_band = WindowBox{-8, -8, 8, 8};
  const auto holds = [&](double x) {
    const Scene scene = OneTriangle({{{0, 0}, {x, 0}, {0, 4}}});
    return IsUnclipped(scene, {profile, scene});
  };
  EXPECT_TRUE(holds(8));
  EXPECT_TRUE(holds(-8));
  EXPECT_FALSE(holds(8.25));  // snaps inside
  EXPECT_FALSE(holds(9));
  profile.guard_band = WindowBox{-8, -8, 7.5, 8};
  EXPECT_FALSE(holds(7.5));  // snaps outside
}

}  // namespace
}  // namespace rasterproof
