// OpenGL as a plugin. The build makes one of each driver and submission: see subjects/real.cmake.
#include <exception>
#include <memory>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/counter.h"

namespace {

using rasterproof::subjects::GlCounter;
using rasterproof::subjects::GlSubmission;

// OpenGL leaves snapping and ties free; two triangles with a common edge share no sample and leave
// none out (OpenGL 4.6, 14.6.1). llvmpipe reports 8 subpixel bits and has them; softpipe reports 4
// and snaps nothing.
constexpr const char* kProfile = R"({"name": "gl", "subpixel_bits": )" RASTERPROOF_GL_BITS R"(,
  "snap_rule": "nearest-even", "contract": "watertight", "coordinate_limit": 8192})";

void* Open() {
  try {
    return std::make_unique<GlCounter>(RASTERPROOF_GL_DRIVER,
                                       GlSubmission::RASTERPROOF_GL_SUBMISSION)
        .release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  if (state == nullptr) return 1;
  return static_cast<GlCounter*>(state)->Draw(*scene, *target);
}

void Close(void* state) { delete static_cast<GlCounter*>(state); }

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin{
      .version = RASTERPROOF_PLUGIN_VERSION,
      .size = sizeof(rasterproof_plugin),
      .name = RASTERPROOF_GL_NAME,
      .summary = "OpenGL, additive blending, " RASTERPROOF_GL_NAME,
      .profile = kProfile,
      .input = RASTERPROOF_FLOAT32,
      .coverage = RASTERPROOF_FACING_COUNTS,
      .takes = 0,
      .draw = Draw,
      .open = Open,
      .reset = nullptr,
      .close = Close};
  return &plugin;
}
