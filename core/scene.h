// A scene: vertices, triangles and the size of the target. Start of the main path:
// core/scene.h -> reference/rasterize.cc -> exact/coverage.cc ->
// props/properties/coverage/shared_edge_samples_are_covered_once.cc.
#ifndef RASTERPROOF_CORE_SCENE_H_
#define RASTERPROOF_CORE_SCENE_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/channel.h"
#include "core/vertex.h"

namespace rasterproof {

/// The number format that every coordinate of a scene is exactly representable in.
enum class Precision : std::uint8_t { kFloat32, kFloat64 };

/// Largest width and height of a target, and largest number of samples in one.
inline constexpr int kMaxTargetSide = 65536;
inline constexpr std::int64_t kMaxTargetSamples = std::int64_t{1} << 28;

/// Triangles and the target that they are drawn into.
///
/// Domain:     1 <= width, height <= kMaxTargetSide; every index within `vertices`.
/// Units:      window pixels, or clip space already scaled to the viewport (window = x/w, y/w).
struct Scene {
  std::string name;
  int width = 1;
  int height = 1;
  Precision precision = Precision::kFloat32;
  /// True if the vertices are clip space (written with four coordinates). Otherwise every w is 1.
  bool clip_space = false;
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
  /// What is interpolated, for subjects that show values. A draw that does not ask for values may
  /// have lists of another length than `vertices`.
  std::vector<Channel> channels = {};

  friend bool operator==(const Scene&, const Scene&) = default;
};

/// The three vertices of a triangle.
inline std::array<Vertex, 3> Corners(const Scene& scene, const Triangle& t) {
  return {scene.vertices[static_cast<std::size_t>(t[0])],
          scene.vertices[static_cast<std::size_t>(t[1])],
          scene.vertices[static_cast<std::size_t>(t[2])]};
}

/// x and y of a window-space vertex.
inline Point2 WindowPoint(const Vertex& v) { return {v.x, v.y}; }

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SCENE_H_
