// Counts triangles in OpenGL: additive blending into floats, one channel for each facing.
#ifndef RASTERPROOF_SUBJECTS_GL_COUNTER_H_
#define RASTERPROOF_SUBJECTS_GL_COUNTER_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

#include <cstdint>
#include <optional>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/gl/context.h"
#include "subjects/gl/sample_fetcher.h"

namespace rasterproof::subjects {

/// Half the side of the viewport: nothing within is clipped.
inline constexpr double kHalfViewport = 8192;

/// How the triangles of a scene reach the driver.
enum class GlSubmission : std::uint8_t {
  kBatch,  ///< all in one draw call
  kAlone   ///< each in a draw call that is finished before the next
};

/// The subpixel bits that the driver reports (GL_SUBPIXEL_BITS); nothing if there is no driver.
std::optional<int> ReportedSubpixelBits(const char* gallium_driver);

/// Window coordinates arrive exactly (AddClipPlace). The target is the positive quadrant. Row j of
/// the framebuffer is row j of the target: window y is taken as it is, and only its name ("up")
/// differs.
class GlCounter {
 public:
  /// Error:      throws std::runtime_error where there is no such driver.
  GlCounter(const char* gallium_driver, GlSubmission submission, int samples);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  void RequireSamples() const;
  void Bind() const;
  void Resize(int width, int height);
  bool Upload(const rasterproof_scene& scene);
  void Submit(const rasterproof_scene& scene) const;

  GlContext context_;
  GlSubmission submission_;
  int samples_;
  std::optional<SampleFetcher> reader_;  ///< of more samples than one
  GLuint program_ = 0;
  GLuint attributes_ = 0;
  GLuint texture_ = 0;
  GLuint framebuffer_ = 0;
  int width_ = 0;
  int height_ = 0;
  std::vector<float> clip_;    ///< x, y, w of each vertex
  std::vector<float> texels_;  ///< front and back
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_COUNTER_H_
