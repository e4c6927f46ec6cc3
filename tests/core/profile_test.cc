#include "core/profile.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/subject_info.h"

namespace rasterproof {
namespace {

constexpr FixedInput kSigned{12, 4, true, true};
constexpr FixedInput kUnsigned{10, 6, false, true};
constexpr double kStep = 0x1p-4;

TEST(FixedInput, HasARangeThatEndsAStepBeforeThePowerOfTwo) {
  EXPECT_EQ(kSigned.Least(), -2048);
  EXPECT_EQ(kSigned.Largest(), 2048 - kStep);
  EXPECT_EQ(kUnsigned.Least(), 0);
  EXPECT_EQ(kUnsigned.Largest(), 1024 - 0x1p-6);
}

TEST(FixedInput, IsReadInItsUnitsBeforeItWraps) {
  for (std::int64_t raw = -200000; raw < 200000; raw += 7) {
    EXPECT_EQ(kSigned.Raw(std::ldexp(static_cast<double>(raw), -4)), raw);
  }
}

TEST(FixedInput, IsGivenWhatItsIntegersHold) {
  EXPECT_TRUE(kSigned.IsGiven(1.0625));
  EXPECT_TRUE(kSigned.IsGiven(99999));
  EXPECT_FALSE(kSigned.IsGiven(1.03125));
  EXPECT_FALSE(kSigned.IsGiven(std::numeric_limits<double>::infinity()));
  const FixedInput still{12, 4, true, false};
  EXPECT_TRUE(still.IsGiven(-2048));
  EXPECT_FALSE(still.IsGiven(2048));
}

Scene OneTriangle(std::array<Point2, 3> v) {
  Scene scene;
  scene.precision = Precision::kFloat64;
  for (const Point2 p : v) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles = {{0, 1, 2}};
  return scene;
}

TEST(Limits, OfAFixedPointInputAreItsIntegers) {
  Profile profile;
  profile.fixed = FixedInput{12, 4, true, false};
  EXPECT_TRUE(WithinLimits(OneTriangle({{{-2048, 0}, {2047.9375, 3}, {0, 0}}}), profile));
  EXPECT_FALSE(WithinLimits(OneTriangle({{{-2049, 0}, {1, 3}, {0, 0}}}), profile));
  EXPECT_FALSE(WithinLimits(OneTriangle({{{0.03125, 0}, {1, 3}, {0, 0}}}), profile));
  profile.fixed->wraps = true;
  const Scene beyond = OneTriangle({{{-2049, 0}, {1, 3}, {0, 0}}});
  EXPECT_TRUE(WithinLimits(beyond, profile));
  EXPECT_FALSE(IsUnwrapped(beyond, profile));
  SubjectInfo info;
  info.profile = profile;
  EXPECT_TRUE(Takes(info, beyond));  // integers, whatever the scene's precision
  EXPECT_FALSE(Takes(info, OneTriangle({{{0.03125, 0}, {1, 3}, {0, 0}}})));
}

TEST(Limits, AreNamedWhereASceneExceedsThem) {
  const double infinity = std::numeric_limits<double>::infinity();
  Profile profile;
  profile.coordinate_limit = 8;
  profile.max_target = {4, 2};
  Scene scene = OneTriangle({{{-8, 0}, {8, 3}, {0, 0}}});
  scene.width = 4;
  scene.height = 2;
  EXPECT_EQ(WhyNotWithinLimits(scene, profile), std::nullopt);
  scene.vertices[2].x = infinity;  // which its own keys are about
  EXPECT_EQ(WhyBeyondLimits(scene, profile), std::nullopt);
  EXPECT_EQ(WhyNotWithinLimits(scene, profile), "a coordinate is not finite");
  scene.vertices[1].y = std::nextafter(8.0, infinity);
  EXPECT_EQ(WhyBeyondLimits(scene, profile),
            "a coordinate lies beyond the profile's coordinate_limit");
  scene.height = 3;
  EXPECT_EQ(WhyBeyondLimits(scene, profile), "the target is larger than the profile's max_target");
  profile = Profile{};
  profile.fixed = FixedInput{12, 4, true, false};
  EXPECT_EQ(WhyBeyondLimits(OneTriangle({{{0.03125, 0}, {1, 3}, {0, 0}}}), profile),
            "the profile's fixed-point input does not take a coordinate of the scene");
}

TEST(SameModel, LooksAtWhatCountsDependOn) {
  Profile a = *PresetProfile("gl-canonical");
  Profile b = a;
  b.name = "another";
  b.contract = Contract::kNone;
  b.coordinate_limit = 1;
  b.freedom.ties = TieOwnership::kAxisAligned;
  b.shares_edge_samples = true;
  EXPECT_TRUE(SameModel(a, b));
  b.scanline_rounding = {8, SnapRule::kFloor};
  EXPECT_FALSE(SameModel(a, b));
  a.scanline_rounding = b.scanline_rounding;
  a.transform = Transform{};
  EXPECT_FALSE(SameModel(a, b));
  b.transform = a.transform;
  EXPECT_TRUE(SameModel(a, b));
  b.max_primitive_extent = MaxPrimitiveExtent{1, 1};
  EXPECT_FALSE(SameModel(a, b));
}

}  // namespace
}  // namespace rasterproof
