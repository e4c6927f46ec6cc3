// An OpenGL 3.3 context without a display, from the driver that a subject names.
#ifndef RASTERPROOF_SUBJECTS_GL_CONTEXT_H_
#define RASTERPROOF_SUBJECTS_GL_CONTEXT_H_

#include <EGL/egl.h>

namespace rasterproof::subjects {

/// Current on the thread that made it, as long as it lives.
class GlContext {
 public:
  /// `gallium_driver`: llvmpipe or softpipe; empty: any GPU, by its own driver.
  ///
  /// Properties: the first context of a process settles the driver for all later ones.
  /// Error:      throws std::runtime_error where EGL or the driver has none to give.
  explicit GlContext(const char* gallium_driver);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_CONTEXT_H_
