#include "subjects/gl/interpolator.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "subjects/gl/counter.h"
#include "subjects/gl/program.h"

namespace rasterproof::subjects {
namespace {

// Every number in every way.
constexpr const char* kValueVertexShader = R"(#version 330 core
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
constexpr const char* kValueFragmentShader = R"(#version 330 core
#extension GL_ARB_derivative_control : require
uniform ivec4 kinds;  // enum rasterproof_interpolation
smooth in vec4 perspective;
noperspective in vec4 linear;
flat in vec4 provoking;
smooth in vec3 barycentrics;
layout(location = 0) out vec4 triangle;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 value;
layout(location = 3) out vec4 by_x;
layout(location = 4) out vec4 by_y;
void main() {
  triangle = vec4(gl_PrimitiveID + 1);
  place = vec4(barycentrics, gl_FragCoord.z);
  vec4 of[4] = vec4[4](provoking, linear, perspective, vec4(gl_FragCoord.w));
  for (int c = 0; c < 4; ++c) value[c] = of[kinds[c]][c];
  by_x = dFdxFine(value);
  by_y = dFdyFine(value);
}
)";

constexpr GLsizei kStride = kCornerFloats * sizeof(float);

}  // namespace

GlInterpolator::GlInterpolator(const char* gallium_driver) : context_(gallium_driver) {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!renderer.starts_with(gallium_driver)) {
    throw std::runtime_error("the renderer is " + renderer);
  }
  const GLuint program = MakeProgram(kValueVertexShader, kValueFragmentShader);
  glUseProgram(program);
  kinds_ = glGetUniformLocation(program, "kinds");
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  glBindVertexArray(name);
  glGenBuffers(1, &name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  for (GLuint k = 0; k < 2; ++k) {
    const std::size_t offset = 4 * k * sizeof(float);
    glEnableVertexAttribArray(k);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so OpenGL takes an offset into its buffer
    glVertexAttribPointer(k, 4, GL_FLOAT, GL_FALSE, kStride, reinterpret_cast<const void*>(offset));
  }
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  constexpr auto kSide = static_cast<GLsizei>(2 * kHalfViewport);
  glViewport(-kSide / 2, -kSide / 2, kSide, kSide);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_CLAMP);
  if (glGetError() != GL_NO_ERROR) throw std::runtime_error("no OpenGL 4.5");
}

void GlInterpolator::Resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  glDeleteTextures(kShaderOutputs, textures_.data());
  glGenTextures(kShaderOutputs, textures_.data());
  std::array<GLenum, kShaderOutputs> outputs{};
  for (GLenum k = 0; k < kShaderOutputs; ++k) {
    outputs[k] = GL_COLOR_ATTACHMENT0 + k;
    glBindTexture(GL_TEXTURE_2D, textures_[k]);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs[k], GL_TEXTURE_2D, textures_[k], 0);
  }
  glDrawBuffers(kShaderOutputs, outputs.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver cannot draw into RGBA32F");
  }
  texels_.resize(std::size_t{4 * kShaderOutputs} * static_cast<std::size_t>(width) *
                 static_cast<std::size_t>(height));
}

const float* GlInterpolator::Paint(const PassKinds& kinds) {
  glUniform4iv(kinds_, 1, kinds.data());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(float)),
               corners_.data(), GL_STREAM_DRAW);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size() / kCornerFloats));
  for (GLenum k = 0; k < kShaderOutputs; ++k) {
    glReadBuffer(GL_COLOR_ATTACHMENT0 + k);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT,
                 &texels_[k * texels_.size() / kShaderOutputs]);
  }
  return texels_.data();
}

std::int32_t GlInterpolator::Draw(const rasterproof_scene& scene,
                                  const rasterproof_target& target) {
  const std::int32_t status =
      DrawInPasses(scene, target, kHalfViewport, corners_, [&](const PassKinds& kinds) {
        Resize(scene.width, scene.height);
        return Paint(kinds);
      });
  return glGetError() == GL_NO_ERROR ? status : 1;
}

}  // namespace rasterproof::subjects
