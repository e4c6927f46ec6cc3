#include "exact/placed_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"

namespace rasterproof::exact {
namespace {

using Facings = std::vector<std::int8_t>;

// A front triangle, the same turned, a flat one, one that is not finite.
Scene FourTriangles() {
  Scene scene;
  scene.precision = Precision::kFloat64;
  scene.width = scene.height = 16;
  scene.vertices = {{0.26, 0, 0, 1}, {0, 8, 0, 1},    {8, 8, 0, 1},
                    {0.26, 4, 0, 1}, {0.26, 9, 0, 1}, {NAN, 0, 0, 1}};
  scene.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 3, 4}, {0, 1, 5}};
  return scene;
}

Profile Snapped(int bits) {
  Profile profile;
  profile.snap = {bits};
  return profile;
}

TEST(PlacedScene, KnowsEachFacingOnScreen) {
  const PlacedScene down(FourTriangles(), {});
  EXPECT_EQ(down.facings, (Facings{1, -1, 0, 0}));
  EXPECT_EQ(down.flat, (std::vector<std::size_t>{2})) << "what is not finite is not flat";
  Profile up;
  up.y_axis = YAxis::kUp;
  EXPECT_EQ(PlacedScene(FourTriangles(), up).facings, (Facings{-1, 1, 0, 0}));
}

TEST(PlacedScene, HasTheSceneAsGivenBesideThePlacedOne) {
  const PlacedScene scene(FourTriangles(), Snapped(1));
  EXPECT_EQ(scene.scene.vertices[0].x, 0.26);
  EXPECT_EQ(scene.placed.vertices[0].x, 0.5);
}

TEST(PlacedScene, UsesTheModelOfItsTarget) {
  Profile profile;
  profile.by_target_size = {{.max_width = 16, .max_height = 16, .snap = {0}}};
  Scene scene = FourTriangles();
  EXPECT_EQ(PlacedScene(scene, profile).placed.vertices[0].x, 0);
  EXPECT_TRUE(PlacedScene(scene, profile).profile.by_target_size.empty());
  scene.width = 17;
  EXPECT_EQ(PlacedScene(scene, profile).placed.vertices[0].x, 0.26);
}

TEST(PlacedScene, DropsWhatIsTooLargeAndDoesNotCallItFlat) {
  Profile profile;
  profile.max_primitive_extent = MaxPrimitiveExtent{4, 4};
  const PlacedScene scene(FourTriangles(), profile);
  EXPECT_EQ(scene.facings, (Facings{0, 0, 0, 0}));
  EXPECT_EQ(scene.placed.triangles[0], (Triangle{0, 0, 0}));
  EXPECT_EQ(scene.scene.triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(scene.flat, (std::vector<std::size_t>{2}));
}

TEST(PlacedScene, PutsClipSpaceOnTheGridWhereThatHasPlacesForIt) {
  Scene clip = FourTriangles();
  clip.clip_space = true;
  for (Vertex& v : clip.vertices) v = {2 * v.x, 2 * v.y, v.z, 2};
  const PlacedScene placed(clip, Snapped(1));
  EXPECT_FALSE(placed.why_not_placed);
  EXPECT_FALSE(placed.placed.clip_space);
  EXPECT_EQ(placed.placed.vertices[0].x, 0.5);
  EXPECT_EQ(placed.facings, (Facings{1, -1, 0, 0}));
  EXPECT_TRUE(PlacedScene(clip, {}).placed.clip_space) << "real geometry stays homogeneous";
  EXPECT_EQ(PlacedScene(clip, {}).facings, (Facings{1, -1, 0, 0}));
  clip.vertices[2].w = -1;
  const PlacedScene behind(clip, Snapped(1));
  EXPECT_TRUE(behind.why_not_placed);
  EXPECT_TRUE(behind.placed.clip_space);
}

}  // namespace
}  // namespace rasterproof::exact
