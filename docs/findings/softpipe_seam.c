/* Mesa's softpipe leaves a gap between two triangles with a common edge, or covers pixels twice.
 *
 *   cc softpipe_seam.c -lEGL -lOpenGL && ./a.out
 *
 * Prints how often each pixel of a 3 x 3 framebuffer is covered by two triangles on either side of
 * an edge: 1 is right. OpenGL 4.6, 14.6.1: of two polygons on either side of a common edge, exactly
 * one covers a sample on it.
 */
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <stdio.h>
#include <stdlib.h>

static const char* kVertex =
    "#version 330 core\nlayout(location = 0) in vec2 at;\n"
    "void main() { gl_Position = vec4(at / 8192.0, 0.0, 1.0); }";
static const char* kFragment =
    "#version 330 core\nout vec4 color;\nvoid main() { color = vec4(1.0); }";

static void Attach(GLuint program, GLenum stage, const char* text) {
  GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

static void Draw(const char* title, const float (*corners)[6]) {
  static const float kClear[4] = {0, 0, 0, 0};
  unsigned char pixels[3][3][4];
  int counts[3][3] = {{0}};
  for (int t = 0; t < 2; ++t) {
    glBufferData(GL_ARRAY_BUFFER, 24, corners[t], GL_STREAM_DRAW);
    glClearBufferfv(GL_COLOR, 0, kClear);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glReadPixels(0, 0, 3, 3, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int k = 0; k < 9; ++k) counts[k / 3][k % 3] += pixels[k / 3][k % 3][0] != 0;
  }
  printf("%s:", title);
  for (int y = 0; y < 3; ++y) printf(" %d%d%d", counts[y][0], counts[y][1], counts[y][2]);
  printf("\n");
}

int main(void) {
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  const float gap[2][6] = {{0, 8, -2, 4, 26, -16}, {26, -16, -2, 4, 0, 0}};
  const float overlap[2][6] = {{5.875f, -4.625f, 0, -2, -6, 12}, {6, 0, -6, 12, 5.875f, -4.625f}};
  GLuint name;
  setenv("GALLIUM_DRIVER", "softpipe", 0);
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
  eglInitialize(display, NULL, NULL);
  eglBindAPI(EGL_OPENGL_API);
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  printf("%s\n", (const char*)glGetString(GL_RENDERER));

  GLuint program = glCreateProgram();
  Attach(program, GL_VERTEX_SHADER, kVertex);
  Attach(program, GL_FRAGMENT_SHADER, kFragment);
  glLinkProgram(program);
  glUseProgram(program);
  glGenVertexArrays(1, &name);
  glBindVertexArray(name);
  glGenBuffers(1, &name);
  glBindBuffer(GL_ARRAY_BUFFER, name);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 16, 16, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
  GLuint target = name;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  glViewport(-8192, -8192, 16384, 16384);

  Draw("gap", gap);
  Draw("overlap", overlap);
  return 0;
}
