#include "tool/scene_options.h"

namespace rasterproof::tool {

void AddScene(CLI::App* app, SceneOptions& scene) {
  app->add_option("scene", scene.path,
                  "Scene file (JSON; - for standard input) or mesh (obj, ply, off, stl, gltf, glb)")
      ->required();
  app->add_option("--camera", scene.camera,
                  "For meshes: front, inside, or \"eye=X,Y,Z target=X,Y,Z up=X,Y,Z fov=DEGREES\"");
  app->add_option("--project", scene.project, "For meshes: window, clip or auto")
      ->check(CLI::IsMember({"window", "clip", "auto"}))
      ->capture_default_str();
  app->add_option("--width", scene.width, "For meshes: width of the target")->capture_default_str();
  app->add_option("--height", scene.height, "For meshes: height of the target")
      ->capture_default_str();
}

}  // namespace rasterproof::tool
