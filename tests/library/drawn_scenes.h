// Scenes for the tests of kernels.
#ifndef RASTERPROOF_TESTS_LIBRARY_DRAWN_SCENES_H_
#define RASTERPROOF_TESTS_LIBRARY_DRAWN_SCENES_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include "library/kernels/kernel.h"
#include "tests/reference/random_values.h"

namespace rasterproof::library::kernels {

using reference::RandomValues;

using KernelTriangle = std::array<KernelVertex, 3>;

/// A scene and what it owns.
struct OwnedScene {
  std::string name;
  std::vector<KernelVertex> vertices;
  std::vector<std::uint32_t> indices;
  int width = 1;
  int height = 1;

  KernelScene View() const { return {vertices, indices, width, height}; }
  void Add(const KernelTriangle& t) {
    for (const KernelVertex& v : t) {
      indices.push_back(static_cast<std::uint32_t>(vertices.size()));
      vertices.push_back(v);
    }
  }
};

inline float Half(RandomValues& random, int low, int high) {
  return static_cast<float>(random.Integer(2 * low, 2 * high)) * 0.5F;
}

// One coordinate of a target of this size: on centres, on borders, anywhere, beside it, far off.
inline float Coordinate(RandomValues& random, int size, int kind) {
  switch (kind) {
    case 0:
      return Half(random, 0, size);
    case 1:
      return static_cast<float>(random.Uniform(-0.2 * size, 1.2 * size));
    case 2:
      return static_cast<float>(random.Uniform(0, size));
    case 3:
      return static_cast<float>(random.Uniform(-40 * size, 40 * size));
    case 4:
      return static_cast<float>(random.Integer(-16 * 256, size * 256)) * 0x1p-8F;
    default:
      return random.LogUniform<float>(-140, 127);
  }
}

inline OwnedScene RandomScene(std::uint64_t seed, int width, int height, int triangles) {
  OwnedScene scene;
  scene.name =
      std::to_string(width) + "x" + std::to_string(height) + " seed " + std::to_string(seed);
  scene.width = width;
  scene.height = height;
  RandomValues random(seed);
  for (int i = 0; i < triangles; ++i) {
    KernelTriangle t;
    const int kind = random.Integer(0, 6);
    const float x = Coordinate(random, width, 2);
    const float y = Coordinate(random, height, 2);
    for (KernelVertex& v : t) {
      v.z = static_cast<float>(random.Uniform(-1, 1));
      if (kind == 6) {  // up to twelve pixels wide
        v.x = x + static_cast<float>(random.Uniform(-6, 6));
        v.y = y + static_cast<float>(random.Uniform(-6, 6));
      } else {
        v.x = Coordinate(random, width, kind);
        v.y = Coordinate(random, height, kind);
      }
    }
    if (random.Integer(0, 9) == 0) t[1].y = t[0].y;
    if (random.Integer(0, 9) == 0) t[2].x = t[1].x;
    if (random.Integer(0, 19) == 0) t[2] = t[0];
    scene.Add(t);
  }
  return scene;
}

inline OwnedScene ExtremeScene() {
  OwnedScene scene;
  scene.name = "extremes";
  scene.width = 75;
  scene.height = 13;
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kBig = std::numeric_limits<float>::max();
  constexpr std::array kValues{0.5F,     0.0F, -0.0F, 1e-45F, 12.5F, 16384.0F, -16384.0F,
                               16384.1F, 3e9F, kBig,  -kBig,  kInf,  -kInf,    NAN};
  RandomValues random(5);
  const auto value = [&] {
    return kValues[static_cast<std::size_t>(random.Integer(0, std::ssize(kValues) - 1))];
  };
  for (int i = 0; i < 500; ++i) {
    KernelTriangle t;
    for (KernelVertex& v : t) v = {value(), value(), value()};
    scene.Add(t);
  }
  return scene;
}

// More layers than a byte counts.
inline OwnedScene DeepScene() {
  OwnedScene scene;
  scene.name = "deep";
  scene.width = 70;
  scene.height = 20;
  for (int i = 0; i < 300; ++i) {
    scene.Add({{{1, 1, 0.5F}, {3, 6, 0.25F}, {6, 2, 0.75F}}});
    scene.Add({{{-9, -1, 0.5F}, {90, 10, 0.25F}, {-7, 19, 0.75F}}});
  }
  return scene;
}

/// Returns scenes of every size and kind of coordinate, with `percent` percent of their triangles.
inline std::vector<OwnedScene> DrawnScenes(int percent) {
  std::vector<OwnedScene> scenes;
  scenes.push_back(RandomScene(1, 1, 1, 200 * percent / 100));
  scenes.push_back(RandomScene(2, 67, 35, 400 * percent / 100));
  scenes.push_back(RandomScene(3, 200, 9, 300 * percent / 100));
  scenes.push_back(RandomScene(4, 131, 70, 301 * percent / 100));
  scenes.push_back(RandomScene(5, 2100, 8, 60 * percent / 100));
  scenes.push_back(ExtremeScene());
  scenes.push_back(DeepScene());
  OwnedScene empty;
  empty.name = "empty";
  empty.vertices.resize(1);
  scenes.push_back(empty);
  return scenes;
}

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_TESTS_LIBRARY_DRAWN_SCENES_H_
