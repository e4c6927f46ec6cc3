// Scenes from files: scene files, and meshes with a camera.
#ifndef RASTERPROOF_TOOL_SCENE_SOURCE_H_
#define RASTERPROOF_TOOL_SCENE_SOURCE_H_

#include <string>

#include "core/scene.h"

namespace rasterproof::tool {

/// A scene file, or a mesh and how it is seen.
struct SceneOptions {
  std::string path;
  std::string camera;  ///< for meshes; empty: "front"
  std::string project =
      "auto";  ///< "window", "clip", "auto": window unless a vertex lies behind the eye
  int width = 512;
  int height = 512;
};

/// Whether LoadScene takes the file for a mesh: by its ending.
bool IsMeshPath(const std::string& path);

/// Reads a scene file or projects a mesh, by the file's ending.
Scene LoadScene(const SceneOptions& options);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SCENE_SOURCE_H_
