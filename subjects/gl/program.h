// A program of two shaders.
#ifndef RASTERPROOF_SUBJECTS_GL_PROGRAM_H_
#define RASTERPROOF_SUBJECTS_GL_PROGRAM_H_

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace rasterproof::subjects {

/// Domain:     a current context.
/// Error:      throws std::runtime_error if they do not compile or link.
GLuint MakeProgram(const char* vertex_shader, const char* fragment_shader);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_GL_PROGRAM_H_
