// Reads every sample of a multisampled texture, by drawing them beside each other.
#ifndef RASTERPROOF_SUBJECTS_GL_SAMPLE_FETCHER_H_
#define RASTERPROOF_SUBJECTS_GL_SAMPLE_FETCHER_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace rasterproof::subjects {

/// Domain:     the context that it was made in is current.
class SampleFetcher {
 public:
  /// `format`: of two or four floats, that of its framebuffer.
  SampleFetcher(int samples, GLenum format);

  void Resize(int width, int height);
  /// Fetches all samples of the texture into the columns [samples x + s] of a framebuffer of one
  /// sample, and leaves that bound for reading and drawing. The viewport, the program and the
  /// vertex array are other ones after it; blending is off.
  void Fetch(GLuint texture) const;

 private:
  int samples_;
  GLenum format_;
  GLuint program_;
  GLuint vertices_ = 0;  ///< none
  GLuint framebuffer_ = 0;
  GLuint texture_ = 0;
  int columns_ = 0;
  int rows_ = 0;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_SAMPLE_FETCHER_H_
