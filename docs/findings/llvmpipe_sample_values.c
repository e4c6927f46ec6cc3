/* Mesa's llvmpipe divides what it interpolates at a sample by the 1/w of the pixel's centre.
 *
 *   cc llvmpipe_sample_values.c -lEGL -lOpenGL && ./a.out
 *
 * One pixel of four samples, and a triangle over all of it, whose corners have w = 1, 4, 1 and the
 * values 0, 1, 0. Prints of each sample its x, the value of an input declared sample, the value of
 * one at that place, and the numerator there divided by the centre's 1/w. The first two should be
 * the same.
 */
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <stdio.h>
#include <stdlib.h>

static const char* kVertex =
    "#version 400 core\nsample out float value;\n"
    "void main() {\n"
    "  float w = gl_VertexID == 1 ? 4.0 : 1.0;\n"
    "  vec2 at = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);\n"
    "  gl_Position = vec4(at * w, 0.0, w);\n"
    "  value = gl_VertexID == 1 ? 1.0 : 0.0;\n"
    "}";
static const char* kFragment =
    "#version 400 core\nsample in float value;\nout vec4 color;\n"
    "void main() { color = vec4(value); }";

static void Attach(GLuint program, GLenum stage, const char* text) {
  GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, NULL);
  glCompileShader(shader);
  glAttachShader(program, shader);
}

/* A framebuffer of one pixel. */
static GLuint Framebuffer(int samples) {
  GLuint framebuffer, buffer;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA32F, 1, 1);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffer);
  return framebuffer;
}

int main(void) {
  const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION,
                           4,
                           EGL_CONTEXT_MINOR_VERSION,
                           0,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
  setenv("GALLIUM_DRIVER", "llvmpipe", 0);
  EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
  eglInitialize(display, NULL, NULL);
  eglBindAPI(EGL_OPENGL_API);
  EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  printf("%s\n", (const char*)glGetString(GL_RENDERER));

  GLuint program = glCreateProgram(), vertices;
  Attach(program, GL_VERTEX_SHADER, kVertex);
  Attach(program, GL_FRAGMENT_SHADER, kFragment);
  glLinkProgram(program);
  glUseProgram(program);
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  GLuint shown = Framebuffer(0), drawn = Framebuffer(4);
  glViewport(0, 0, 1, 1);
  glEnable(GL_SAMPLE_MASK);
  int off = 0;
  for (int s = 0; s < 4; ++s) {
    float at[2], mean[4];
    /* This sample alone: the mean of all is a quarter of it. */
    glBindFramebuffer(GL_FRAMEBUFFER, drawn);
    glGetMultisamplefv(GL_SAMPLE_POSITION, s, at);
    glSampleMaski(0, ~0u);
    glClear(GL_COLOR_BUFFER_BIT);
    glSampleMaski(0, 1u << s);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, shown);
    glBlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, shown);
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, mean);
    const double part = at[0] / 2, value = 4 * mean[0];
    const double right = (part / 4) / (1 - part + part / 4);
    const double by_centre = (part / 4) / (0.75 + 0.25 / 4);
    off += value - right > 1e-6 || right - value > 1e-6;
    printf("x %.4f: %.6f, %.6f is right; by the centre's 1/w %.6f\n", at[0], value, right,
           by_centre);
  }
  return off != 0;
}
