#include "render/gl_program.h"

#include <utility>

#include "render/shaders.h"

namespace parti::render {
namespace {

constexpr const char* kCoreHead = "#version 330 core\n";
constexpr const char* kGlesHead =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

Result<GLuint> Compile(const Gl& gl, GLenum kind, const std::string& file) {
  std::string text = gl.is_gles ? kGlesHead : kCoreHead;
  text += ShaderText("light.glsl");
  if (file == "face.vert" || file == "id.vert") text += ShaderText("place.glsl");
  if (file.starts_with("picture")) text += ShaderText("picture.glsl");
  if (file == "face.frag" || file == "face_image.frag") text += ShaderText("lit.glsl");
  text.append("#line 1\n").append(ShaderText(file));
  const char* source = text.c_str();
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint good = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::string log(2000, '\0');
  GLsizei length = 0;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<size_t>(length));
  gl.DeleteShader(shader);
  return Fail(ErrorCode::kGraphics, "the shader " + file + " does not compile: " + log,
              "update the Mesa drivers");
}

Result<void> Link(const Gl& gl, GLuint program, const std::string& name) {
  gl.LinkProgram(program);
  GLint good = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &good);
  if (good) return {};
  std::string log(2000, '\0');
  GLsizei length = 0;
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<size_t>(length));
  return Fail(ErrorCode::kGraphics, "the shaders " + name + " do not link: " + log);
}

}  // namespace

Result<GlProgram> GlProgram::Create(const Gl& gl, const std::string& vertex_name,
                                    const std::string& fragment_name) {
  const Result<GLuint> vertex = Compile(gl, GL_VERTEX_SHADER, vertex_name + ".vert");
  if (!vertex) return Fail(vertex);
  const Result<GLuint> fragment = Compile(gl, GL_FRAGMENT_SHADER, fragment_name + ".frag");
  if (!fragment) {
    gl.DeleteShader(*vertex);
    return Fail(fragment);
  }
  GlProgram program(gl, gl.CreateProgram());
  gl.AttachShader(program.program_, *vertex);
  gl.AttachShader(program.program_, *fragment);
  const Result<void> linked = Link(gl, program.program_, vertex_name + " and " + fragment_name);
  gl.DeleteShader(*vertex);
  gl.DeleteShader(*fragment);
  if (!linked) return Fail(linked);
  return program;
}

GlProgram::GlProgram(GlProgram&& other) noexcept
    : gl_(other.gl_), program_(std::exchange(other.program_, 0)) {}

GlProgram& GlProgram::operator=(GlProgram&& other) noexcept {
  std::swap(gl_, other.gl_);
  std::swap(program_, other.program_);
  return *this;
}

GlProgram::~GlProgram() {
  if (program_) gl_->DeleteProgram(program_);
}

void GlProgram::Set(const char* uniform, int value) const { gl_->Uniform1i(At(uniform), value); }
void GlProgram::Set(const char* uniform, float value) const { gl_->Uniform1f(At(uniform), value); }
void GlProgram::Set(const char* uniform, const Vec2f& v) const {
  gl_->Uniform2f(At(uniform), v.x, v.y);
}
void GlProgram::Set(const char* uniform, const Vec3f& v) const {
  gl_->Uniform3f(At(uniform), v.x, v.y, v.z);
}
void GlProgram::Set(const char* uniform, const Vec4f& v) const {
  gl_->Uniform4f(At(uniform), v.x, v.y, v.z, v.w);
}
void GlProgram::Set(const char* uniform, const glm::mat3& value) const {
  gl_->UniformMatrix3fv(At(uniform), 1, GL_FALSE, &value[0][0]);
}
void GlProgram::Set(const char* uniform, const glm::mat4& value) const {
  gl_->UniformMatrix4fv(At(uniform), 1, GL_FALSE, &value[0][0]);
}

}  // namespace parti::render
