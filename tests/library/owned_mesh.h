// A mesh of the library's, and the target that it is drawn into, for its tests.
#ifndef RASTERPROOF_TESTS_LIBRARY_OWNED_MESH_H_
#define RASTERPROOF_TESTS_LIBRARY_OWNED_MESH_H_

#include <cstdint>
#include <string>
#include <vector>

#include "library/rasterize.h"

namespace rasterproof {

struct OwnedMesh {
  std::string name = {};
  std::vector<float> positions = {};
  std::vector<std::uint32_t> indices = {};
  int width = 1;
  int height = 1;

  RasterMesh Mesh() const { return {positions, indices}; }
  /// Returns the vertex's number.
  std::uint32_t Add(float x, float y, float z) {
    positions.insert(positions.end(), {x, y, z});
    return static_cast<std::uint32_t>(positions.size() / 3 - 1);
  }
  /// Adds a vertex, and an index of it: three make a triangle.
  void AddCorner(float x, float y, float z) { indices.push_back(Add(x, y, z)); }
};

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_LIBRARY_OWNED_MESH_H_
