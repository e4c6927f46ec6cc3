// Meshes and the camera that sees them.
#ifndef RASTERPROOF_IO_MESH_H_
#define RASTERPROOF_IO_MESH_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene.h"

namespace rasterproof::io {

/// A triangle mesh in model space, float32, vertices welded by bits only.
struct Mesh {
  std::string name;
  std::vector<std::array<float, 3>> vertices;
  std::vector<Triangle> triangles;
};

/// Reads OBJ, PLY, OFF, STL or glTF (.gltf, .glb) through assimp; glTF's nodes place their meshes.
///
/// Polygons become fans around their first corner: a closed mesh stays closed, a concave polygon
/// may fold. Degenerate triangles stay, points and lines go.
/// Error:      InputError with file, reason and remedy; vertices that aren't finite are refused,
///             and a file on which the library crashes, or takes more time or memory than a sound
///             mesh of its size: it is parsed in a child process (limited_child.h).
Mesh ReadMesh(const std::string& path);

/// A pin-hole camera: right-handed, looking from `eye` to `target`.
struct Camera {
  std::array<double, 3> eye{0, 0, 5};
  std::array<double, 3> target{0, 0, 0};
  std::array<double, 3> up{0, 1, 0};
  double vertical_fov_degrees = 45;
};

/// "front" (in front of the whole mesh), "inside" (eye at the mesh's centre), or
/// "eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES" (comma or space separated fields; missing ones
/// default).
Camera ParseCamera(const std::string& text, const Mesh& mesh);

enum class ProjectTo : std::uint8_t {
  kWindow,  ///< x/w, y/w computed in double, rounded once to float32. Every vertex must be in front
            ///< of the eye.
  kClip     ///< (x, y, z, w) rounded once to float32; w of any sign
};

/// Returns the mesh as the camera sees it in a target of the given size (y down). The rounded
/// vertices are the scene's exact ones: rounding in this transform is not the subject's.
Scene ProjectMesh(const Mesh& mesh, const Camera& camera, int width, int height, ProjectTo to);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_MESH_H_
