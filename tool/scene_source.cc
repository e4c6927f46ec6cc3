#include "tool/scene_source.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "core/error.h"
#include "core/target_size.h"
#include "fmt/format.h"
#include "io/mesh.h"
#include "io/scene_file.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {

bool IsMeshPath(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos) return false;
  std::string ending = path.substr(dot + 1);
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  constexpr std::array<std::string_view, 6> kMeshEndings{"obj", "ply", "off", "stl", "gltf", "glb"};
  return std::ranges::find(kMeshEndings, ending) != kMeshEndings.end();
}

Scene LoadScene(const SceneOptions& options) {
  if (!IsMeshPath(options.path)) {
    if (!options.camera.empty()) {
      throw InputError("--camera", options.path + " is a scene file, which has no camera",
                       "leave the option out, or give a mesh (obj, ply, off, stl, gltf, glb)");
    }
    return io::ReadScene(Located(options.path));
  }
  RequireTargetSize(fmt::format("--width {} --height {}", options.width, options.height),
                    options.width, options.height, 1);
  const io::Mesh mesh = io::ReadMesh(options.path);
  const std::string text = options.camera.empty() ? "front" : options.camera;
  const io::Camera camera = io::ParseCamera(text, mesh);
  const auto project = [&](io::ProjectTo to) {
    return io::ProjectMesh(mesh, camera, options.width, options.height, to);
  };
  if (options.project == "window") return project(io::ProjectTo::kWindow);
  Scene clip = project(io::ProjectTo::kClip);
  if (options.project == "clip") return clip;
  const bool in_front = std::ranges::all_of(clip.vertices, [](const Vertex& v) { return v.w > 0; });
  return in_front ? project(io::ProjectTo::kWindow) : clip;
}

}  // namespace rasterproof::tool
