#include "exact/winding.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "core/coverage.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "tests/exact/families.h"

namespace rasterproof::exact {
namespace {

Scene Window(int width, int height, std::vector<Vertex> vertices, std::vector<Triangle> triangles) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.vertices = std::move(vertices);
  scene.triangles = std::move(triangles);
  return scene;
}

TEST(BoundaryWinding, IsPlusOneInsideWhatTurnsCounterClockwiseOnScreen) {
  // Down, right, up: counter-clockwise with y down.
  const Scene scene = Window(3, 2, {{0, 0}, {0, 2}, {2, 2}, {2, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(BoundaryWinding({scene, {}}), (std::vector<std::int64_t>{1, 1, 0, 1, 1, 0}));
  Profile up;
  up.y_axis = YAxis::kUp;
  EXPECT_EQ(BoundaryWinding({scene, up}), (std::vector<std::int64_t>{-1, -1, 0, -1, -1, 0}));
}

TEST(BoundaryWinding, CountsALoopThatIsRunTwiceTwice) {
  const Scene scene = Window(1, 1, {{-9, -9}, {0, 9}, {9, -9}}, {{0, 1, 2}, {0, 1, 2}});
  EXPECT_EQ(BoundaryWinding({scene, {}}), (std::vector<std::int64_t>{2}));
}

TEST(BoundaryWinding, EqualsSignedCoverageOfAnyTrianglesUnderEveryRule) {
  std::uint64_t nonzero = 0;
  for (int k = 0; k < 800; ++k) {
    Draw draw(500 + static_cast<unsigned>(k));
    const Scene scene = draw.SmallScene(static_cast<Family>(k % kFamilies), false);
    Profile profile = draw.AnyProfile();
    profile.tie_rule.inclusive = false;
    if (k % 3 == 0) profile.snap = {4, SnapRule::kNearestEven};
    const CoverageCounts counts = Coverage(scene, profile);
    const std::vector<std::int64_t> winding = BoundaryWinding({scene, profile});
    ASSERT_EQ(winding.size(), counts.size());
    for (std::size_t i = 0; i < winding.size(); ++i) {
      ASSERT_EQ(winding[i], counts.Signed(i)) << scene.name << " " << k;
      if (winding[i] != 0) ++nonzero;
    }
  }
  EXPECT_GT(nonzero, 1000U);
}

TEST(BoundaryWinding, RefusesClipSpace) {
  Scene scene = Window(1, 1, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  scene.clip_space = true;
  EXPECT_THROW(BoundaryWinding({scene, {}}), InputError);
}

}  // namespace
}  // namespace rasterproof::exact
