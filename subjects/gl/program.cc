#include "subjects/gl/program.h"

#include <stdexcept>

namespace rasterproof::subjects {
namespace {

GLuint Compile(GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint done = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done != GL_TRUE) throw std::runtime_error("a shader does not compile");
  return shader;
}

}  // namespace

GLuint MakeProgram(const char* vertex_shader, const char* fragment_shader) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, Compile(GL_VERTEX_SHADER, vertex_shader));
  glAttachShader(program, Compile(GL_FRAGMENT_SHADER, fragment_shader));
  glLinkProgram(program);
  GLint done = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  if (done != GL_TRUE) throw std::runtime_error("the shaders do not link");
  return program;
}

}  // namespace rasterproof::subjects
