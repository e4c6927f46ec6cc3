// Options of the verbs that take one scene. Beside tool/verb_options.h.
#ifndef RASTERPROOF_TOOL_SCENE_OPTIONS_H_
#define RASTERPROOF_TOOL_SCENE_OPTIONS_H_

#include "CLI/CLI.hpp"
#include "tool/scene_source.h"

namespace rasterproof::tool {

/// Adds a scene, and how a mesh is seen.
void AddScene(CLI::App* app, SceneOptions& scene);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SCENE_OPTIONS_H_
