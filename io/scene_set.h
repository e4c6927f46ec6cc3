// A scene set: which scenes a certificate measures, as a file.
#ifndef RASTERPROOF_IO_SCENE_SET_H_
#define RASTERPROOF_IO_SCENE_SET_H_

#include <string>
#include <vector>

namespace rasterproof::io {

/// One entry: a scene file, or a mesh and how it is seen.
struct SceneEntry {
  std::string name;
  std::string summary;  ///< a sentence that describes it; may be empty
  bool real = false;    ///< from the world, not made to be hard
  std::string path;     ///< scene file or mesh, as it can be opened from the working folder
  std::string camera;   ///< meshes only
  std::string project = "auto";
  int width = 512;
  int height = 512;
};

/// Reads {"rasterproof_scene_set": 1, "scenes": [{"name", "summary", "path", "kind": "real" |
/// "hard", "camera", "project", "width", "height"}]}; name and path are required. Relative paths
/// are relative to the file's folder.
///
/// Error:      InputError with file, place, reason and remedy; unknown keys are errors.
std::vector<SceneEntry> ReadSceneSet(const std::string& path);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SCENE_SET_H_
