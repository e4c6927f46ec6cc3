#include "subjects/gl/counter.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "subjects/gl/program.h"
#include "subjects/shaded/shaded.h"

namespace rasterproof::subjects {
namespace {

constexpr const char* kCountVertexShader = R"(#version 330 core
layout(location = 0) in vec3 clip;
void main() { gl_Position = vec4(clip.xy, 0.0, clip.z); }
)";
constexpr const char* kCountFragmentShader = R"(#version 330 core
out vec2 counts;
void main() { counts = gl_FrontFacing ? vec2(1.0, 0.0) : vec2(0.0, 1.0); }
)";

}  // namespace

std::optional<int> ReportedSubpixelBits(const char* gallium_driver) {
  try {
    const GlContext context(gallium_driver);
    GLint bits = 0;
    glGetIntegerv(GL_SUBPIXEL_BITS, &bits);
    return bits;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

GlCounter::GlCounter(const char* gallium_driver, GlSubmission submission, int samples)
    : context_(gallium_driver), submission_(submission), samples_(samples) {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!renderer.starts_with(gallium_driver)) {
    throw std::runtime_error("the renderer is " + renderer);
  }
  if (samples_ > 1) reader_.emplace(samples_, GL_RG32F);
  program_ = MakeProgram(kCountVertexShader, kCountFragmentShader);
  glGenVertexArrays(1, &attributes_);
  glBindVertexArray(attributes_);
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glGenBuffers(1, &name);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
  glGenFramebuffers(1, &framebuffer_);
  glBlendFunc(GL_ONE, GL_ONE);
  // With y down, counter-clockwise on screen is clockwise in OpenGL's axes.
  glFrontFace(GL_CW);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void GlCounter::Resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  if (texture_ != 0) glDeleteTextures(1, &texture_);
  glGenTextures(1, &texture_);
  const GLenum kind = samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  glBindTexture(kind, texture_);
  if (reader_) {
    glTexImage2DMultisample(kind, samples_, GL_RG32F, width, height, GL_TRUE);
    reader_->Resize(width, height);
  } else {
    glTexImage2D(kind, 0, GL_RG32F, width, height, 0, GL_RG, GL_FLOAT, nullptr);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind, texture_, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver cannot draw into RG32F");
  }
  RequireSamples();
  texels_.resize(2 * static_cast<std::size_t>(width * samples_) * static_cast<std::size_t>(height));
}

// A driver may give more than it is asked for.
void GlCounter::RequireSamples() const {
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples_ > 1 && samples != samples_) {
    throw std::runtime_error("the framebuffer has another number of samples than requested");
  }
}

void GlCounter::Bind() const {
  constexpr GLsizei kSide = 2 * static_cast<GLsizei>(kHalfViewport);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(-kSide / 2, -kSide / 2, kSide, kSide);
  glEnable(GL_BLEND);
  glUseProgram(program_);
  glBindVertexArray(attributes_);
}

bool GlCounter::Upload(const rasterproof_scene& scene) {
  clip_.clear();
  for (std::size_t v = 0; v < scene.vertex_count; ++v) {
    const double* const vertex = scene.vertices + 4 * v;
    if (!AddClipPlace(vertex, kHalfViewport, clip_)) return false;
    clip_.push_back(static_cast<float>(vertex[3]));
  }
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(clip_.size() * sizeof(float)), clip_.data(),
               GL_STREAM_DRAW);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER,
               static_cast<GLsizeiptr>(3 * scene.triangle_count * sizeof(std::int32_t)),
               scene.triangles, GL_STREAM_DRAW);
  return true;
}

void GlCounter::Submit(const rasterproof_scene& scene) const {
  const auto count = static_cast<GLsizei>(3 * scene.triangle_count);
  if (submission_ == GlSubmission::kBatch) {
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
    return;
  }
  for (GLsizei first = 0; first < count; first += 3) {
    const auto offset = static_cast<std::size_t>(first) * sizeof(std::int32_t);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so OpenGL takes an offset into its buffer
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
    glFinish();
  }
}

std::int32_t GlCounter::Draw(const rasterproof_scene& scene, const rasterproof_target& target) {
  if (target.samples != samples_) return 1;
  // The samples of a row are read side by side, in a texture of at most 16384 columns.
  if (scene.width > kHalfViewport || scene.height > kHalfViewport ||
      scene.width * samples_ > 2 * kHalfViewport) {
    return 1;
  }
  Resize(scene.width, scene.height);
  Bind();
  if (!Upload(scene)) return 1;
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  Submit(scene);
  if (reader_) reader_->Fetch(texture_);
  glReadPixels(0, 0, width_ * samples_, height_, GL_RG, GL_FLOAT, texels_.data());
  if (glGetError() != GL_NO_ERROR) return 1;
  const std::size_t columns = static_cast<std::size_t>(width_) * static_cast<std::size_t>(samples_);
  const float* texel = texels_.data();
  for (int y = 0; y < height_; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * target.stride;
    for (std::size_t x = 0; x < columns; ++x, texel += 2) {
      target.front[row + x] += static_cast<std::uint32_t>(texel[0]);
      target.back[row + x] += static_cast<std::uint32_t>(texel[1]);
    }
  }
  return 0;
}

}  // namespace rasterproof::subjects
