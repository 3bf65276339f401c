#include "render/gl.h"

#include <fmt/format.h>

namespace parti::render {

Result<Gl> LoadGl(const GlLookup& lookup, bool is_gles) {
  Gl gl;
  gl.is_gles = is_gles;
#define PARTI_GL_LOAD(UPPER, Name)                                                 \
  gl.Name = reinterpret_cast<PFNGL##UPPER##PROC>(lookup("gl" #Name));              \
  if (!gl.Name) {                                                                  \
    return Fail(ErrorCode::kGraphics, "this OpenGL has no gl" #Name,               \
                "OpenGL 3.3 or OpenGL ES 3.0 is needed; update the Mesa drivers"); \
  }
  PARTI_GL_FUNCTIONS(PARTI_GL_LOAD)
#undef PARTI_GL_LOAD
  return gl;
}

Result<void> CheckGl(const Gl& gl, const std::string& doing) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return {};
  while (gl.GetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY) {
    return Fail(ErrorCode::kGraphics, doing + ": out of graphics memory",
                "make the picture or the scene smaller");
  }
  return Fail(ErrorCode::kGraphics, fmt::format("{}: OpenGL error {:#x}", doing, error));
}

}  // namespace parti::render
