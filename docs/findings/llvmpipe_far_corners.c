/* Mesa's llvmpipe loses a triangle whose corners lie far to the left and above the framebuffer.
 *
 *   cc llvmpipe_far_corners.c -lEGL -lOpenGL && ./a.out
 *
 * The triangle (-2048, 0) (0, -4096) (1, 1) covers the centre of pixel (0, 0), which lies half
 * a pixel inside. Prints the pixel as the triangle and as its mirror image at (y, x) draw it,
 * and as the same triangle with half as far a corner draws it: 1 is right.
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

static int Draw(const float corners[6]) {
  unsigned char pixel[4];
  glBufferData(GL_ARRAY_BUFFER, 24, corners, GL_STREAM_DRAW);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  return pixel[0] != 0;
}

int main(void) {
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  const float found[] = {-2048, 0, 0, -4096, 1, 1};
  const float mirrored[] = {0, -2048, -4096, 0, 1, 1};
  const float nearer[] = {-2048, 0, 0, -2048, 1, 1};
  GLuint name;
  setenv("GALLIUM_DRIVER", "llvmpipe", 0);
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

  printf("(-2048,0) (0,-4096) (1,1): %d\n", Draw(found));
  printf("(0,-2048) (-4096,0) (1,1): %d\n", Draw(mirrored));
  printf("(-2048,0) (0,-2048) (1,1): %d\n", Draw(nearer));
  return 0;
}
