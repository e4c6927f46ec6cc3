#include "subjects/gl/sample_fetcher.h"

#include <stdexcept>

#include "subjects/gl/program.h"

namespace rasterproof::subjects {
namespace {

// One triangle over everything.
constexpr const char* kFetchVertexShader = R"(#version 330 core
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
constexpr const char* kFetchFragmentShader = R"(#version 330 core
uniform sampler2DMS drawn;
uniform int samples;
out vec4 texel;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  texel = texelFetch(drawn, ivec2(at.x / samples, at.y), at.x % samples);
}
)";

}  // namespace

SampleFetcher::SampleFetcher(int samples, GLenum format)
    : samples_(samples),
      format_(format),
      program_(MakeProgram(kFetchVertexShader, kFetchFragmentShader)) {
  glUseProgram(program_);
  glUniform1i(glGetUniformLocation(program_, "drawn"), 0);
  glUniform1i(glGetUniformLocation(program_, "samples"), samples);
  glGenVertexArrays(1, &vertices_);
  glGenFramebuffers(1, &framebuffer_);
}

void SampleFetcher::Resize(int width, int height) {
  columns_ = samples_ * width;
  rows_ = height;
  if (texture_ != 0) glDeleteTextures(1, &texture_);
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format_), columns_, rows_, 0, GL_RGBA, GL_FLOAT,
               nullptr);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("the driver cannot draw into floats");
  }
}

void SampleFetcher::Fetch(GLuint texture) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, columns_, rows_);
  glDisable(GL_BLEND);
  glUseProgram(program_);
  glBindVertexArray(vertices_);
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace rasterproof::subjects
