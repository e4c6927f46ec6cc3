// The spans against deciders that ask every sample, and both against the naive implementation.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "exact/homogeneous.h"
#include "tests/exact/families.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {
namespace {

struct Compared {
  std::uint64_t scenes = 0;
  std::uint64_t covered = 0;
};

Compared CompareOnScenes(bool clip_space, int scenes_per_family, bool against_naive) {
  Compared compared;
  for (int f = 0; f < kFamilies; ++f) {
    const auto family = static_cast<Family>(f);
    Draw draw(1000 + static_cast<unsigned>(f));
    for (int k = 0; k < scenes_per_family; ++k) {
      Scene scene = draw.SmallScene(family, clip_space);
      if (against_naive) scene.width = scene.height = 3;
      const Profile profile = draw.AnyProfile();
      const DrawOptions options = draw.AnyOptions();
      const CoverageCounts spans = Coverage(scene, profile, options);
      const CoverageCounts truth =
          against_naive
              ? NaiveCoverage(scene, profile, options)
              : Coverage(scene, profile, options, k % 2 == 0 ? Decider::kIntegers : Decider::kCgal);
      EXPECT_EQ(spans, truth) << FamilyName(family) << " " << k << " under "
                              << TieRuleName(profile.tie_rule)
                              << (profile.y_axis == YAxis::kUp ? ", y up" : ", y down");
      if (spans != truth) return compared;
      ++compared.scenes;
      for (std::size_t i = 0; i < truth.size(); ++i) compared.covered += truth.Count(i);
    }
  }
  return compared;
}

TEST(Spans, EqualTheNaiveCoverageInWindowSpace) {
  EXPECT_GT(CompareOnScenes(false, 12, true).covered, 200U);
}

TEST(Spans, EqualTheNaiveCoverageInClipSpace) {
  EXPECT_GT(CompareOnScenes(true, 12, true).covered, 200U);
}

TEST(Spans, EqualTheSampleBySampleDecidersInWindowSpace) {
  EXPECT_GT(CompareOnScenes(false, 30, false).covered, 1000U);
}

TEST(Spans, EqualTheSampleBySampleDecidersInClipSpace) {
  EXPECT_GT(CompareOnScenes(true, 25, false).covered, 1000U);
}

TEST(Spans, AskExactlyOnlyWhereTheGuessCannotTell) {
  Scene scene;
  scene.width = 256;
  scene.height = 256;
  Draw draw(31);
  for (int t = 0; t < 50; ++t) {
    for (int k = 0; k < 3; ++k)
      scene.vertices.push_back({draw.Unit() * 256, draw.Unit() * 256, 0, 1});
    scene.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  const TierScope scope;
  Coverage(scene, {});
  EXPECT_GT(scope.Counts().filter, 5000U);
  EXPECT_LT(scope.Counts().stable + scope.Counts().exact + scope.Counts().symbolic, 10U);
  const TierScope tie_scope;
  scene.vertices = {{0, 0, 0, 1}, {256, 256, 0, 1}, {0, 256, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  Coverage(scene, {});
  EXPECT_EQ(tie_scope.Counts().symbolic, 256U)
      << "the diagonal passes through a centre in every row";
}

TEST(Spans, OfAProjectedMeshEqualThoseOfItsClipSpace) {
  // w a power of two: x / w is exact, and so the window-space scene is the same scene.
  Draw draw(32);
  for (int k = 0; k < 300; ++k) {
    const Family family = k % 2 == 0 ? Family::kHalfPixels : Family::kUniform;
    const Scene window = draw.SmallScene(family, false);
    Scene clip = window;
    clip.clip_space = true;
    for (Vertex& v : clip.vertices) {
      // Now and then so small that products of two coordinates underflow.
      v.w = std::ldexp(1.0, draw.Below(3) == 0 ? -530 - draw.Below(10) : draw.Below(40) - 20);
      v.x *= v.w;
      v.y *= v.w;
    }
    const Profile profile = draw.AnyProfile();
    const DrawOptions options = draw.AnyOptions();
    ASSERT_EQ(Coverage(clip, profile, options), Coverage(window, profile, options));
  }
}

}  // namespace
}  // namespace rasterproof::exact
