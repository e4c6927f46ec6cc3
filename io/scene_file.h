// Scene files: JSON, read and written without losing a bit.
#ifndef RASTERPROOF_IO_SCENE_FILE_H_
#define RASTERPROOF_IO_SCENE_FILE_H_

#include <string>
#include <string_view>

#include "core/scene.h"

namespace rasterproof::io {

/// Reads a scene file. "-" is standard input.
///
/// Error:      InputError with file, place ("vertices[3][1]"), reason and remedy.
Scene ReadScene(const std::string& path);

/// Parses the text of a scene file; `place` names it in errors.
Scene ParseScene(std::string_view text, const std::string& place);

/// The scene as JSON; coordinates are hex-float strings. ParseScene gives back the same bits (NaN
/// payloads apart).
std::string SceneToJson(const Scene& scene);

}  // namespace rasterproof::io

#endif  // RASTERPROOF_IO_SCENE_FILE_H_
