#include "subjects/gl/interpolator.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "subjects/gl/clip.h"
#include "subjects/gl/program.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kChannels = 4;  // in a pass

// Every number in every way. Corners are not shared: each knows its place in its triangle.
constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 numbers;
smooth out vec4 perspective;
noperspective out vec4 linear;
flat out vec4 provoking;
smooth out vec3 barycentrics;
void main() {
  gl_Position = clip;
  perspective = linear = provoking = numbers;
  int corner = gl_VertexID % 3;
  barycentrics = vec3(corner == 0, corner == 1, corner == 2);
}
)";
constexpr const char* kFragmentShader = R"(#version 330 core
#extension GL_ARB_derivative_control : require
uniform ivec4 kinds;  // enum rasterproof_interpolation
smooth in vec4 perspective;
noperspective in vec4 linear;
flat in vec4 provoking;
smooth in vec3 barycentrics;
layout(location = 0) out int primitive;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 value;
layout(location = 3) out vec4 by_x;
layout(location = 4) out vec4 by_y;
void main() {
  primitive = gl_PrimitiveID;
  place = vec4(barycentrics, gl_FragCoord.z);
  vec4 of[4] = vec4[4](provoking, linear, perspective, vec4(gl_FragCoord.w));
  for (int c = 0; c < 4; ++c) value[c] = of[kinds[c]][c];
  by_x = dFdxFine(value);
  by_y = dFdyFine(value);
}
)";

}  // namespace

GlInterpolator::GlInterpolator(const char* gallium_driver) : context_(gallium_driver) {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!renderer.starts_with(gallium_driver)) {
    throw std::runtime_error("the renderer is " + renderer);
  }
  program_ = MakeProgram(kVertexShader, kFragmentShader);
  GLuint attributes = 0;
  glGenVertexArrays(1, &attributes);
  glBindVertexArray(attributes);
  glGenBuffers(2, buffers_.data());
  for (GLuint k = 0; k < 2; ++k) {
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[k]);
    glEnableVertexAttribArray(k);
    glVertexAttribPointer(k, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  constexpr auto kSide = static_cast<GLsizei>(2 * kHalfViewport);
  glViewport(-kSide / 2, -kSide / 2, kSide, kSide);
  // Depth is z / w itself, and no triangle is clipped by it.
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_CLAMP);
  glUseProgram(program_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

void GlInterpolator::Resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  glDeleteTextures(kOutputs, textures_.data());
  glGenTextures(kOutputs, textures_.data());
  std::array<GLenum, kOutputs> outputs{};
  for (std::size_t k = 0; k < kOutputs; ++k) {
    outputs[k] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(k);
    glBindTexture(GL_TEXTURE_2D, textures_[k]);
    if (k == kPrimitive) {
      glTexImage2D(GL_TEXTURE_2D, 0, GL_R32I, width, height, 0, GL_RED_INTEGER, GL_INT, nullptr);
    } else {
      glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs[k], GL_TEXTURE_2D, textures_[k], 0);
  }
  glDrawBuffers(kOutputs, outputs.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver cannot draw into RGBA32F");
  }
  primitives_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  texels_.resize(4 * primitives_.size());
}

bool GlInterpolator::UploadVertices(const rasterproof_scene& scene) {
  corners_.clear();
  for (std::size_t k = 0; k < 3 * scene.triangle_count; ++k) {
    const double* const vertex = scene.vertices + 4 * scene.triangles[k];
    const auto place = ClipPlace(vertex);
    if (!place) return false;
    corners_.insert(corners_.end(), {(*place)[0], (*place)[1], static_cast<float>(vertex[2]),
                                     static_cast<float>(vertex[3])});
  }
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(float)),
               corners_.data(), GL_STREAM_DRAW);
  return true;
}

void GlInterpolator::UploadChannels(const rasterproof_scene& scene, std::size_t first) {
  const std::size_t count = std::min(kChannels, scene.channel_count - first);
  std::array<GLint, kChannels> kinds{};
  std::ranges::fill(corners_, 0.0F);
  for (std::size_t c = 0; c < count; ++c) {
    const rasterproof_channel& channel = scene.channels[first + c];
    kinds[c] = channel.interpolation;
    if (channel.values == nullptr) continue;
    for (std::size_t k = 0; k < 3 * scene.triangle_count; ++k)
      corners_[4 * k + c] = static_cast<float>(channel.values[scene.triangles[k]]);
  }
  glUniform4iv(glGetUniformLocation(program_, "kinds"), 1, kinds.data());
  glBindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(float)),
               corners_.data(), GL_STREAM_DRAW);
}

void GlInterpolator::Pass(const rasterproof_scene& scene) const {
  constexpr std::array<GLint, 4> kNone{-1, -1, -1, -1};
  constexpr std::array<GLfloat, 4> kZero{};
  glClearBufferiv(GL_COLOR, kPrimitive, kNone.data());
  for (GLint k = kPlace; k <= kByY; ++k) glClearBufferfv(GL_COLOR, k, kZero.data());
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * scene.triangle_count));
}

void GlInterpolator::Read(Output output) {
  glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum{output});
  if (output == kPrimitive) {
    glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_INT, primitives_.data());
  } else {
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, texels_.data());
  }
}

void GlInterpolator::ReadPlaces(const rasterproof_target& target) {
  Read(kPrimitive);
  Read(kPlace);
  const auto columns = static_cast<std::size_t>(width_);
  for (std::size_t n = 0; n < primitives_.size(); ++n) {
    const std::size_t at = n / columns * target.stride + n % columns;
    target.primitive_ids[at] = primitives_[n];
    if (target.barycentrics != nullptr)
      std::copy_n(&texels_[4 * n], 3, target.barycentrics + 3 * at);
    if (target.depths != nullptr) target.depths[at] = double{texels_[4 * n + 3]};
  }
}

void GlInterpolator::ReadValues(const rasterproof_scene& scene, const rasterproof_target& target,
                                std::size_t first) {
  const std::size_t count = std::min(kChannels, scene.channel_count - first);
  const auto columns = static_cast<std::size_t>(width_);
  const auto read = [&](Output output, double* into, std::size_t entries) {
    Read(output);
    for (std::size_t n = 0; n < primitives_.size(); ++n) {
      const std::size_t at = n / columns * target.stride + n % columns;
      for (std::size_t c = 0; c < count; ++c)
        into[entries * (scene.channel_count * at + first + c)] = double{texels_[4 * n + c]};
    }
  };
  if (target.values != nullptr) read(kValue, target.values, 1);
  if (target.derivatives == nullptr) return;
  read(kByX, target.derivatives, 2);
  read(kByY, target.derivatives + 1, 2);
}

std::int32_t GlInterpolator::Draw(const rasterproof_scene& scene,
                                  const rasterproof_target& target) {
  if (target.samples != 1 || scene.width > kHalfViewport || scene.height > kHalfViewport) return 1;
  Resize(scene.width, scene.height);
  if (!UploadVertices(scene)) return 1;
  const bool wants = target.values != nullptr || target.derivatives != nullptr;
  for (std::size_t first = 0; first == 0 || (wants && first < scene.channel_count);
       first += kChannels) {
    UploadChannels(scene, first);
    Pass(scene);
    if (first == 0) ReadPlaces(target);
    ReadValues(scene, target, first);
  }
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}

}  // namespace rasterproof::subjects
