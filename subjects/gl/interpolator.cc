#include "subjects/gl/interpolator.h"

#include <cstddef>
#include <stdexcept>
#include <string>

#include "subjects/gl/counter.h"
#include "subjects/gl/program.h"

namespace rasterproof::subjects {
namespace {

// Every number in every way. The triangle's number comes with its corners: softpipe's
// gl_PrimitiveID is -1 in every fragment.
constexpr const char* kValueVertexShader = R"(#version 330 core
layout(location = 0) in vec4 clip;
layout(location = 1) in vec4 numbers;
smooth out vec4 perspective;
noperspective out vec4 linear;
flat out vec4 provoking;
smooth out vec3 barycentrics;
noperspective out float reciprocal;
flat out int primitive;
void main() {
  gl_Position = clip;
  reciprocal = 1.0 / clip.w;
  primitive = gl_VertexID / 3;
  perspective = linear = provoking = numbers;
  int corner = gl_VertexID % 3;
  barycentrics = vec3(corner == 0, corner == 1, corner == 2);
}
)";
// What is where the shader is run. Between the version and the rest.
constexpr const char* kOneSample = R"(
#define AT_SAMPLE(x) x
#define AT_CENTRE(x) x
#define AT_CENTROID(x) x
#define INVERSE_W(at) gl_FragCoord.w
)";
// gl_SampleID has it run for each sample. Where 1/w of the fragment is then, OpenGL does not say.
constexpr const char* kEachSample = R"(
#extension GL_ARB_gpu_shader5 : require
#extension GL_ARB_sample_shading : require
#define AT_SAMPLE(x) interpolateAtSample(x, gl_SampleID)
#define AT_CENTRE(x) interpolateAtOffset(x, vec2(0.0))
#define AT_CENTROID(x) interpolateAtCentroid(x)
#define INVERSE_W(at) at(reciprocal)
)";
constexpr const char* kValueFragmentShader = R"(
#extension GL_ARB_derivative_control : require
uniform ivec4 kinds;  // PassKinds
smooth in vec4 perspective;
noperspective in vec4 linear;
flat in vec4 provoking;
smooth in vec3 barycentrics;
noperspective in float reciprocal;
flat in int primitive;
layout(location = 0) out vec4 triangle;
layout(location = 1) out vec4 place;
layout(location = 2) out vec4 value;
layout(location = 3) out vec4 by_x;
layout(location = 4) out vec4 by_y;
void main() {
  triangle = vec4(primitive + 1);
  place = vec4(AT_SAMPLE(barycentrics), gl_FragCoord.z);
  vec4 of[12] = vec4[12](
      provoking, AT_SAMPLE(linear), AT_SAMPLE(perspective), vec4(INVERSE_W(AT_SAMPLE)),
      provoking, AT_CENTRE(linear), AT_CENTRE(perspective), vec4(INVERSE_W(AT_CENTRE)),
      provoking, AT_CENTROID(linear), AT_CENTROID(perspective), vec4(INVERSE_W(AT_CENTROID)));
  for (int c = 0; c < 4; ++c) value[c] = of[kinds[c]][c];
  by_x = dFdxFine(value);
  by_y = dFdyFine(value);
}
)";

constexpr GLsizei kStride = kCornerFloats * sizeof(float);

std::string FragmentShader(int samples) {
  return std::string("#version 330 core") + (samples > 1 ? kEachSample : kOneSample) +
         kValueFragmentShader;
}

}  // namespace

GlInterpolator::GlInterpolator(const char* gallium_driver, int samples)
    : context_(gallium_driver), samples_(samples) {
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  if (!renderer.starts_with(gallium_driver)) {
    throw std::runtime_error("the renderer is " + renderer);
  }
  if (samples_ > 1) fetcher_.emplace(samples_, GL_RGBA32F);
  program_ = MakeProgram(kValueVertexShader, FragmentShader(samples_).c_str());
  kinds_ = glGetUniformLocation(program_, "kinds");
  glGenVertexArrays(1, &arrays_);
  glBindVertexArray(arrays_);
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  for (GLuint k = 0; k < 2; ++k) {
    const std::size_t offset = 4 * k * sizeof(float);
    glEnableVertexAttribArray(k);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): so OpenGL takes an offset into its buffer
    glVertexAttribPointer(k, 4, GL_FLOAT, GL_FALSE, kStride, reinterpret_cast<const void*>(offset));
  }
  glGenFramebuffers(1, &framebuffer_);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_CLAMP);
  if (glGetError() != GL_NO_ERROR) throw std::runtime_error("no clip control");
}

void GlInterpolator::Resize(int width, int height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  glDeleteTextures(kShaderOutputs, textures_.data());
  glGenTextures(kShaderOutputs, textures_.data());
  const GLenum kind = samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  if (fetcher_) fetcher_->Resize(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  std::array<GLenum, kShaderOutputs> outputs{};
  for (GLenum k = 0; k < kShaderOutputs; ++k) {
    outputs[k] = GL_COLOR_ATTACHMENT0 + k;
    glBindTexture(kind, textures_[k]);
    if (samples_ > 1) {
      glTexImage2DMultisample(kind, samples_, GL_RGBA32F, width, height, GL_TRUE);
    } else {
      glTexImage2D(kind, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs[k], kind, textures_[k], 0);
  }
  glDrawBuffers(kShaderOutputs, outputs.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver cannot draw into RGBA32F");
  }
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  if (samples_ > 1 && samples != samples_) {
    throw std::runtime_error("the framebuffer has another number of samples than requested");
  }
  texels_.resize(std::size_t{4 * kShaderOutputs} * static_cast<std::size_t>(width * samples_) *
                 static_cast<std::size_t>(height));
}

const float* GlInterpolator::Paint(const PassKinds& kinds) {
  constexpr auto kSide = static_cast<GLsizei>(2 * kHalfViewport);
  glViewport(-kSide / 2, -kSide / 2, kSide, kSide);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glUseProgram(program_);
  glBindVertexArray(arrays_);
  glUniform4iv(kinds_, 1, kinds.data());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners_.size() * sizeof(float)),
               corners_.data(), GL_STREAM_DRAW);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners_.size() / kCornerFloats));
  for (GLenum k = 0; k < kShaderOutputs; ++k) {
    if (fetcher_) {
      fetcher_->Fetch(textures_[k]);
    } else {
      glReadBuffer(GL_COLOR_ATTACHMENT0 + k);
    }
    glReadPixels(0, 0, width_ * samples_, height_, GL_RGBA, GL_FLOAT,
                 &texels_[k * texels_.size() / kShaderOutputs]);
  }
  return texels_.data();
}

std::int32_t GlInterpolator::Draw(const rasterproof_scene& scene,
                                  const rasterproof_target& target) {
  const std::int32_t status =
      DrawInPasses(scene, target, kHalfViewport, samples_, corners_, [&](const PassKinds& kinds) {
        Resize(scene.width, scene.height);
        return Paint(kinds);
      });
  return glGetError() == GL_NO_ERROR ? status : 1;
}

}  // namespace rasterproof::subjects
