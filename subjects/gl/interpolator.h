// Shows what OpenGL's fragments hold: into floats, four channels in a pass.
#ifndef RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
#define RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/context.h"

namespace rasterproof::subjects {

/// Vertices arrive as in GlCounter, z as it is. The triangle drawn last is visible. With one sample
/// a pixel, so that sample, centre and centroid are one place.
class GlInterpolator {
 public:
  /// Error:      throws std::runtime_error where there is no such driver.
  explicit GlInterpolator(const char* gallium_driver);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  // What the shader writes.
  static constexpr std::size_t kOutputs = 5;
  enum Output : std::uint8_t { kPrimitive, kPlace, kValue, kByX, kByY };

  void Resize(int width, int height);
  bool UploadVertices(const rasterproof_scene& scene);
  void UploadChannels(const rasterproof_scene& scene, std::size_t first);
  void Pass(const rasterproof_scene& scene) const;
  void ReadPlaces(const rasterproof_target& target);
  void ReadValues(const rasterproof_scene& scene, const rasterproof_target& target,
                  std::size_t first);
  void Read(Output output);

  GlContext context_;
  GLuint program_ = 0;
  std::array<GLuint, 2> buffers_{};  ///< of vertices, of numbers
  std::array<GLuint, kOutputs> textures_{};
  GLuint framebuffer_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> corners_;
  std::vector<float> texels_;  ///< four a pixel
  std::vector<std::int32_t> primitives_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_INTERPOLATOR_H_
