#include "exact/winding.h"

#include <gtest/gtest.h>

#include <cmath>
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

TEST(BoundaryWinding, WeldsByPositionAndTakesBothZerosForOne) {
  const Scene scene =
      Window(2, 2, {{0, 0}, {0, 2}, {2, 2}, {-0.0, -0.0}, {2, 2}, {2, 0}}, {{0, 1, 2}, {3, 4, 5}});
  EXPECT_EQ(ShapeOf({scene, {}}).boundary_edges, 4U);
  EXPECT_FALSE(ShapeOf({scene, {}}).closed);
  EXPECT_TRUE(ShapeOf({scene, {}}).balanced);
}

TEST(BoundaryWinding, RefusesClipSpace) {
  Scene scene = Window(1, 1, {{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}});
  scene.clip_space = true;
  EXPECT_THROW(BoundaryWinding({scene, {}}), InputError);
}

TEST(ShapeOf, TellsClosedFoldedBalancedAndDegenerate) {
  const std::vector<Vertex> v{{0, 0}, {4, 0}, {0, 4}, {1, 1}, {2, 2}, {std::nan(""), 0}};
  const MeshShape both_sides = ShapeOf({Window(4, 4, v, {{0, 1, 2}, {0, 2, 1}}), {}});
  EXPECT_TRUE(both_sides.closed);
  EXPECT_TRUE(both_sides.folded);
  EXPECT_TRUE(both_sides.balanced);
  const MeshShape twice = ShapeOf({Window(4, 4, v, {{0, 1, 2}, {0, 1, 2}}), {}});
  EXPECT_FALSE(twice.balanced);
  EXPECT_FALSE(twice.folded);
  EXPECT_EQ(twice.boundary_edges, 3U);
  const MeshShape flat = ShapeOf({Window(4, 4, v, {{0, 3, 4}, {0, 0, 1}, {0, 1, 5}}), {}});
  EXPECT_EQ(flat.degenerate, 2U) << "the triangle with a NaN is left out";
}

TEST(ShapeOf, LooksAtTheSnappedMesh) {
  // The third vertex snaps onto the others' line.
  const Scene scene = Window(4, 4, {{0, 0}, {4, 0}, {1, 0x1p-12}}, {{0, 1, 2}});
  EXPECT_EQ(ShapeOf({scene, {}}).degenerate, 0U);
  EXPECT_EQ(ShapeOf({scene, *PresetProfile("gl-canonical")}).degenerate, 1U);
}

}  // namespace
}  // namespace rasterproof::exact
