#include "model/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/profile.h"
#include "core/scene.h"
#include "core/transform.h"
#include "model/snap_scene.h"

namespace rasterproof {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double WindowX(const Vertex& clip, const Transform& transform, int width = 2) {
  return ToWindow(clip, transform, width, 2).x;
}

TEST(TransformTest, AReciprocalIsRoundedOnItsWay) {
  const Vertex v{41, 0, 0, 41};
  EXPECT_EQ(WindowX(v, {.division = Division::kQuotient}), 1);
  // 1/41 in float32 is a little too small, and 41 times that less than one by half an ulp of one.
  EXPECT_EQ(WindowX(v, {.division = Division::kReciprocal}), 0x1.fffffep-1);
  const Vertex in_double{49, 0, 0, 49};
  EXPECT_EQ(WindowX(in_double, {Precision::kFloat64, Division::kReciprocal}), 0x1.fffffffffffffp-1);
}

TEST(TransformTest, EachViewportRoundsInItsOwnWay) {
  const auto placed = [](double q, ViewportForm form, int width) {
    return WindowX({q, 0, 0, 1}, {.viewport = form}, width);
  };
  // q 11/2 = -11/2 + 0x1.70eep-8: the product alone is rounded to 2^-21.
  constexpr double kNearMinusOne = -0x1.ff79d8p-1;
  EXPECT_EQ(placed(kNearMinusOne, ViewportForm::kMultiplyAdd, 11), 0x1.70fp-8);
  EXPECT_EQ(placed(kNearMinusOne, ViewportForm::kFused, 11), 0x1.70eep-8);
  EXPECT_EQ(placed(kNearMinusOne, ViewportForm::kNone, 11), kNearMinusOne);
  // One and 7/8 of half an ulp is one; 3/2 times that much is more than half an ulp of 3/2.
  constexpr double kTiny = 0x1.cp-25;
  EXPECT_EQ(placed(kTiny, ViewportForm::kAddMultiply, 3), 1.5);
  EXPECT_EQ(placed(kTiny, ViewportForm::kFused, 3), 1.5 + 0x1p-23);
}

TEST(TransformTest, YIsFlippedBeforeTheViewport) {
  const Transform flipped{.viewport = ViewportForm::kMultiplyAdd, .flips_y = true};
  const Vertex top = ToWindow({-2, 2, 7, 2}, flipped, 8, 6);
  EXPECT_EQ(top, (Vertex{0, 0, 7, 1}));
  EXPECT_EQ(ToWindow({-2, 2, 7, 2}, {.viewport = ViewportForm::kMultiplyAdd}, 8, 6).y, 6);
}

TEST(TransformTest, WhatIsNotInFrontOfTheEyeHasNoPlace) {
  for (const Vertex& v : {Vertex{1, 1, 0, 0}, Vertex{1, 1, 0, -1}, Vertex{1, 1, 0, kInfinity},
                          Vertex{kInfinity, 1, 0, 1}, Vertex{1, NAN, 0, 1}}) {
    EXPECT_FALSE(IsFinite(ToWindow(v, {}, 8, 8))) << v.x << " " << v.y << " " << v.w;
  }
}

TEST(TransformTest, ToClipComesBackWhereNothingIsRounded) {
  const Vertex v{2.5, 1.25, 3, 1};
  for (const ViewportForm form : {ViewportForm::kNone, ViewportForm::kMultiplyAdd,
                                  ViewportForm::kFused, ViewportForm::kAddMultiply}) {
    const Transform transform{.viewport = form, .flips_y = true};
    EXPECT_EQ(ToWindow(ToClip(v, 4, transform, 8, 16), transform, 8, 16), v)
        << static_cast<int>(form);
  }
}

TEST(TransformTest, SnappingAProfileWithATransformFollowsIt) {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.transform = Transform{.division = Division::kReciprocal};
  Scene scene;
  scene.clip_space = true;
  scene.vertices = {{41, 41 * 0x1p-9, 0, 41}};
  const Scene snapped = SnapScene(scene, {profile, scene});
  EXPECT_FALSE(snapped.clip_space);
  // 0x1.fffffep-1 is snapped to one; the same half a step up, a tie as a quotient, is below it.
  EXPECT_EQ(snapped.vertices[0], (Vertex{1, 0, 0, 1}));
}

TEST(TransformTest, AMapTakesItsCoordinatesAndNoClipSpace) {
  Profile profile = *PresetProfile("d3d11-canonical");
  profile.transform =
      Transform{.precision = Precision::kFloat64, .map = MapGrid{872512, 6114970, 0.25, -0.25}};
  Scene scene;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{872513, 6114968.875, 7, 1}};
  EXPECT_TRUE(TakesToWindow(profile, scene));
  EXPECT_EQ(SnapScene(scene, {profile, scene}).vertices[0], (Vertex{4, 4.5, 7, 1}));
  scene.clip_space = true;
  EXPECT_FALSE(TakesToWindow(profile, scene));
  EXPECT_TRUE(IsHomogeneous(scene, profile));
  const Vertex there{4, 4.5, 7, 1};
  EXPECT_EQ(ToWindow(ToClip(there, 3, *profile.transform, 8, 8), *profile.transform, 8, 8), there);
}

}  // namespace
}  // namespace rasterproof
