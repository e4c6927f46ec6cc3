// OpenGL as a plugin. The build makes one of each driver and submission: see subjects/real.cmake.
#include <exception>
#include <memory>
#include <string>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/counter.h"
#include "subjects/gl/interpolator.h"

namespace {

using rasterproof::subjects::GlCounter;
using rasterproof::subjects::GlInterpolator;
using rasterproof::subjects::GlSubmission;

#if defined(RASTERPROOF_GL_SHOWS_VALUES)
using Drawer = GlInterpolator;
#else
using Drawer = GlCounter;
#endif

#if defined(RASTERPROOF_GL_SHOWS_VALUES)
// Of values OpenGL states no error (14.6.1): what is asked of them is quality. Coverage is judged
// elsewhere. llvmpipe interpolates between vertices as given; a GPU may do so between snapped ones.
constexpr std::uint32_t kTakes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_WANTS |
                                 RASTERPROOF_SHOWS_VALUES | RASTERPROOF_SHOWS_DERIVATIVES;
// Where several samples lie OpenGL does not say: here, where the standard patterns have them.
std::string SampleLocations() {
  if (RASTERPROOF_GL_SAMPLES == 1) return R"("centroid": "inside", )";
  return R"("sample_locations": "standard-)" RASTERPROOF_GL_SAMPLES_TEXT
         R"(", "centroid": "inside", )";
}
std::string States() {
  constexpr bool kIsGpu = *RASTERPROOF_GL_DRIVER == '\0';
  return std::string(kIsGpu ? R"("subpixel_bits": 8, )" : "") + SampleLocations() +
         R"("contract": "none", "coordinate_limit": 1024,
            "values": {"weights": "perspective", "provoking": "last", "derivatives": "fine",
                       "flat": true, "linear": true, "inverse_w": true, "centres": true,
                       "centroids": true, "flushes": true})";
}
#elif defined(RASTERPROOF_GL_CLIP_SPACE)
// In clip space the division is the driver's as well: held to it, to every sample. Within 1024 none
// of its triangles is lost (docs/findings.md, 1).
constexpr std::uint32_t kTakes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_NO_WINDOW_SPACE;
std::string States() {
  return R"("subpixel_bits": 8, "snap_rule": "nearest-even", "snap_form": "float32-difference",
            "snap_origin": 0.5, "coordinate_limit": 1024,
            "transform": {"precision": "float32", "division": "reciprocal"})";
}
#elif defined(RASTERPROOF_GL_SNAPS_NOTHING)
// It reports 4 subpixel bits and snaps nothing, which no grid explains: two triangles with a common
// edge share no sample and leave none out (OpenGL 4.6, 14.6.1).
constexpr std::uint32_t kTakes = 0;
std::string States() { return R"("contract": "watertight", "coordinate_limit": 8192)"; }
#else
// All that OpenGL allows, with the subpixel bits that the driver reports: an estimate (table
// 23.53), so there may be more. Where several samples lie OpenGL does not say.
constexpr std::uint32_t kTakes = 0;
constexpr const char* kSet =
    RASTERPROOF_GL_SAMPLES == 1 ? "gl" : "gl-" RASTERPROOF_GL_SAMPLES_TEXT "x";
std::string States() {
  const int bits = rasterproof::subjects::ReportedSubpixelBits(RASTERPROOF_GL_DRIVER).value_or(4);
  return R"("specification": ")" + std::string(kSet) +
         R"(", "coordinate_limit": 8192, "least_subpixel_bits": )" + std::to_string(bits);
}
#endif

const std::string& Profile() {
  static const std::string profile = R"({"name": ")" RASTERPROOF_GL_NAME R"(", )" + States() + "}";
  return profile;
}

void* Open() {
  try {
#if defined(RASTERPROOF_GL_SHOWS_VALUES)
    return std::make_unique<GlInterpolator>(RASTERPROOF_GL_DRIVER, RASTERPROOF_GL_SAMPLES)
        .release();
#else
    return std::make_unique<GlCounter>(RASTERPROOF_GL_DRIVER,
                                       GlSubmission::RASTERPROOF_GL_SUBMISSION,
                                       RASTERPROOF_GL_SAMPLES)
        .release();
#endif
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  if (state == nullptr) return 1;
  return static_cast<Drawer*>(state)->Draw(*scene, *target);
}

void Close(void* state) { delete static_cast<Drawer*>(state); }

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin described{};
    described.version = RASTERPROOF_PLUGIN_VERSION;
    described.size = sizeof(rasterproof_plugin);
    described.name = RASTERPROOF_GL_NAME;
    described.summary = "OpenGL, " RASTERPROOF_GL_NAME;
    described.profile = Profile().c_str();
    described.input = RASTERPROOF_FLOAT32;
    const bool shows_values = (kTakes & RASTERPROOF_SHOWS_VALUES) != 0;
    described.coverage = shows_values ? RASTERPROOF_FRAGMENTS : RASTERPROOF_FACING_COUNTS;
    described.takes = kTakes;
    described.draw = Draw;
    described.open = Open;
    described.close = Close;
    return described;
  }();
  return &plugin;
}
