// Shows what OpenGL's fragments hold.
#ifndef RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
#define RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <array>
#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/context.h"
#include "subjects/shaded/shaded.h"

namespace rasterproof::subjects {

/// The triangle drawn last is visible. With one sample a pixel, so that sample, centre and centroid
/// are one place. Depth is z / w, and clips nothing.
class GlInterpolator {
 public:
  /// Error:      throws std::runtime_error where there is no such driver, or no OpenGL 4.5.
  explicit GlInterpolator(const char* gallium_driver);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  void Resize(int width, int height);
  const float* Paint(const PassKinds& kinds);

  GlContext context_;
  GLint kinds_ = -1;  ///< the uniform
  std::array<GLuint, kShaderOutputs> textures_{};
  int width_ = 0;
  int height_ = 0;
  std::vector<float> corners_;
  std::vector<float> texels_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
