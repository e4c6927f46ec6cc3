// When a mesh is closed.
#include "props/judging/mesh/mesh_neighbours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene.h"

namespace rasterproof::props {
namespace {

TEST(IsClosed, TakesVerticesOfEqualPlacesForOne) {
  Scene scene;
  scene.vertices = {{0, 0}, {0, 2}, {2, 2}, {-0.0, -0.0}, {2, 2}, {0, 2}};
  scene.triangles = {{0, 1, 2}};
  EXPECT_FALSE(IsClosed(scene));
  scene.triangles = {{0, 1, 2}, {3, 4, 5}};
  EXPECT_TRUE(IsClosed(scene));
  scene.triangles = {{0, 1, 2}, {4, 3, 5}};
  EXPECT_FALSE(IsClosed(scene)) << "the same side twice";
}

TEST(IsClosed, LooksAtWhatCanCover) {
  Scene scene;
  scene.vertices = {{0, 0}, {4, 0}, {0, 4}, {std::nan(""), 0}};
  scene.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 1, 3}, {0, 0, 0}};
  EXPECT_TRUE(IsClosed(scene));
}

}  // namespace
}  // namespace rasterproof::props
