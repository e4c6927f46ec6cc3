// Shows what OpenGL's fragments hold.
#ifndef RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
#define RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/context.h"
#include "subjects/gl/sample_fetcher.h"
#include "subjects/shaded/shaded.h"

namespace rasterproof::subjects {

/// The triangle drawn last is visible. Of several samples the shader is run for each, and says by
/// interpolateAt...() where it evaluates. Depth is z / w, and clips nothing.
class GlInterpolator {
 public:
  /// Error:      throws std::runtime_error where there is no such driver, or where OpenGL 3.3 lacks
  ///             what is used of later versions: clip control and control over derivatives; for
  ///             several samples 4.0's shaders.
  GlInterpolator(const char* gallium_driver, int samples);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  void Resize(int width, int height);
  const float* Paint(const PassKinds& kinds);

  GlContext context_;
  int samples_;
  std::optional<SampleFetcher> fetcher_;  ///< of more samples than one
  GLuint program_ = 0;
  GLuint arrays_ = 0;
  GLuint framebuffer_ = 0;
  GLint kinds_ = -1;  ///< the uniform
  std::array<GLuint, kShaderOutputs> textures_{};
  int width_ = 0;
  int height_ = 0;
  std::vector<float> corners_;
  std::vector<float> texels_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
