#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/ulp.h"
#include "gtest/gtest.h"
#include "io/mesh.h"

namespace rasterproof::io {
namespace {

Mesh Cube() {
  Mesh mesh;
  mesh.name = "cube";
  for (const float z : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      for (const float x : {-1.0F, 1.0F}) mesh.vertices.push_back({x, y, z});
    }
  }
  mesh.triangles = {{0, 1, 2}, {4, 6, 5}};
  return mesh;
}

std::string CameraMessageFor(const std::string& text) {
  try {
    ProjectMesh(Cube(), ParseCamera(text, Cube()), 64, 64, ProjectTo::kWindow);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(CameraTest, RightIsRightUpIsUpAndYPointsDown) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  // 90 degrees at distance 4: 4 model units are half the height of 64 pixels.
  const Camera camera = ParseCamera("eye=0,0,4 fov=90", mesh);
  const Scene scene = ProjectMesh(mesh, camera, 128, 64, ProjectTo::kWindow);
  EXPECT_FALSE(scene.clip_space);
  EXPECT_EQ(scene.precision, Precision::kFloat32);
  EXPECT_NEAR(scene.vertices[0].x, 64, 1e-4);
  EXPECT_NEAR(scene.vertices[0].y, 32, 1e-4);
  EXPECT_NEAR(scene.vertices[1].x, 72, 1e-4);
  EXPECT_NEAR(scene.vertices[2].y, 24, 1e-4);
  EXPECT_LT(scene.vertices[3].z, scene.vertices[0].z);
  EXPECT_EQ(scene.triangles, mesh.triangles);
}

TEST(CameraTest, FrontSeesTheWholeMesh) {
  const Mesh mesh = Cube();
  const Scene scene = ProjectMesh(mesh, ParseCamera("front", mesh), 200, 200, ProjectTo::kWindow);
  for (const Vertex& v : scene.vertices) {
    EXPECT_TRUE(v.x > 0 && v.x < 200 && v.y > 0 && v.y < 200);
    EXPECT_TRUE(v.z >= 0 && v.z <= 1);
    EXPECT_TRUE(IsFloat32(v.x) && IsFloat32(v.y) && IsFloat32(v.z));
  }
}

TEST(CameraTest, InsideHasVerticesBehindTheEye) {
  const Mesh mesh = Cube();
  const Camera camera = ParseCamera("inside", mesh);
  const Scene scene = ProjectMesh(mesh, camera, 64, 64, ProjectTo::kClip);
  EXPECT_TRUE(scene.clip_space);
  EXPECT_GT(scene.vertices[0].w, 0);
  EXPECT_LT(scene.vertices[7].w, 0);
  for (const Vertex& v : scene.vertices) EXPECT_TRUE(IsFloat32(v.x) && IsFloat32(v.w));
  EXPECT_THROW(ProjectMesh(mesh, camera, 64, 64, ProjectTo::kWindow), InputError);
}

TEST(CameraTest, ClipAndWindowAgree) {
  const Mesh mesh = Cube();
  const Camera camera = ParseCamera("eye=3,2,5 target=0.25,0,0 up=0,1,0.1 fov=30", mesh);
  const Scene window = ProjectMesh(mesh, camera, 320, 200, ProjectTo::kWindow);
  const Scene clip = ProjectMesh(mesh, camera, 320, 200, ProjectTo::kClip);
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    const Vertex& c = clip.vertices[k];
    EXPECT_NEAR(c.x / c.w, window.vertices[k].x, 1e-4);
    EXPECT_NEAR(c.y / c.w, window.vertices[k].y, 1e-4);
    EXPECT_NEAR(c.z / c.w, window.vertices[k].z, 1e-5);
  }
}

TEST(CameraTest, FieldsAreSeparatedByCommasOrBlanks) {
  const Camera camera = ParseCamera("eye=1 2 3, target=-1,0.5,1e1 fov=60", Cube());
  EXPECT_EQ(camera.eye, (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(camera.target, (std::array{-1.0, 0.5, 10.0}));
  EXPECT_EQ(camera.up, (std::array{0.0, 1.0, 0.0}));
  EXPECT_EQ(camera.vertical_fov_degrees, 60);
}

TEST(CameraTest, BadCamerasAreRefused) {
  const auto expect = [](const std::string& camera, const std::string& part) {
    const std::string message = CameraMessageFor(camera);
    EXPECT_NE(message.find(part), std::string::npos) << camera << " gave " << message;
  };
  expect("eye=0,0,9", "(accepted)");
  expect("behind", "camera \"behind\": \"behind\" is no field");
  expect("eye=0,0", "\"\" is not a finite number");
  expect("eye=0,0,x", "\"x\" is not a finite number");
  expect("eye=0,0,nan", "\"nan\" is not a finite number");
  expect("eye=0,0,1e400", "is not a finite number");
  expect("roll=3", "\"roll\" is unknown");
  expect("fov=0", "field of view");
  expect("fov=180", "field of view");
  expect("eye=1,1,1 target=1,1,1", "the eye is at the target");
  expect("eye=0,5,0", "up points along the line of sight");
  expect("eye=0,0,0.5", "cube: vertex 4: is not in front of the eye; draw in clip space");
}

TEST(CameraTest, WhatFloat32CannotHoldIsNamed) {
  Mesh mesh = Cube();
  mesh.vertices[3] = {std::numeric_limits<float>::max(), 0, 0};
  EXPECT_THROW(ProjectMesh(mesh, ParseCamera("eye=0,0,5", Cube()), 64, 64, ProjectTo::kWindow),
               InputError);
}

}  // namespace
}  // namespace rasterproof::io
