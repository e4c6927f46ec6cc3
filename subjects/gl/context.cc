#include "subjects/gl/context.h"

#include <EGL/eglext.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace rasterproof::subjects {

namespace {

EGLDisplay SoftwareDisplay(const char* gallium_driver) {
  setenv("GALLIUM_DRIVER", gallium_driver, 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

// Of the first device that is no software.
EGLDisplay GpuDisplay() {
  const auto query =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto text_of = reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(
      eglGetProcAddress("eglQueryDeviceStringEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query == nullptr || text_of == nullptr ||
      query(static_cast<EGLint>(devices.size()), devices.data(), &count) != EGL_TRUE) {
    return EGL_NO_DISPLAY;
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    const char* const extensions = text_of(devices[k], EGL_EXTENSIONS);
    if (extensions == nullptr || std::strstr(extensions, "EGL_MESA_device_software") != nullptr) {
      continue;
    }
    return eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[k], nullptr);
  }
  return EGL_NO_DISPLAY;
}

}  // namespace

GlContext::GlContext(const char* gallium_driver) {
  display_ = *gallium_driver == '\0' ? GpuDisplay() : SoftwareDisplay(gallium_driver);
  if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE ||
      eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
    throw std::runtime_error("no EGL display without a surface");
  }
  constexpr std::array<EGLint, 7> kWanted{EGL_CONTEXT_MAJOR_VERSION,
                                          3,
                                          EGL_CONTEXT_MINOR_VERSION,
                                          3,
                                          EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                          EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                          EGL_NONE};
  context_ = eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kWanted.data());
  if (context_ == EGL_NO_CONTEXT ||
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
    throw std::runtime_error("no OpenGL 3.3 context");
  }
}

GlContext::~GlContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace rasterproof::subjects
