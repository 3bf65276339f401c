// A linked pair of shaders and its uniforms.
// Vertex attributes have their places in the shader text, and so need no names here.
#pragma once

#include <string>
#include <string_view>

#include "render/gl.h"
#include "render/scene.h"

namespace parti::render {

/// Used and destroyed while its context is current.
class GlProgram {
 public:
  /// assets/shaders/VERTEX.vert and FRAGMENT.frag, behind light.glsl, the faces' also place.glsl or
  /// lit.glsl, and the version line of the context: one source for GL 3.3 and GLES 3.0. errors
  /// kGraphics with the compiler's words.
  static Result<GlProgram> Create(const Gl& gl, const std::string& vertex_name,
                                  const std::string& fragment_name);
  GlProgram(GlProgram&& other) noexcept;
  GlProgram& operator=(GlProgram&& other) noexcept;
  ~GlProgram();

  void Use() const { gl_->UseProgram(program_); }
  /// Of the program in use; a uniform that the compiler found unused is skipped.
  void Set(const char* uniform, int value) const;
  void Set(const char* uniform, float value) const;
  void Set(const char* uniform, const Vec2f& value) const;
  void Set(const char* uniform, const Vec3f& value) const;
  void Set(const char* uniform, const Vec4f& value) const;
  void Set(const char* uniform, const glm::mat3& value) const;
  void Set(const char* uniform, const glm::mat4& value) const;

 private:
  GlProgram(const Gl& gl, GLuint program) : gl_(&gl), program_(program) {}
  GLint At(const char* uniform) const { return gl_->GetUniformLocation(program_, uniform); }

  const Gl* gl_;
  GLuint program_;
};

}  // namespace parti::render
