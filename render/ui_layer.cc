#include "render/ui_layer.h"

#include <utility>

#include "render/scissor.h"

namespace parti::render {

Result<UiLayer> UiLayer::Create(const Gl& gl) {
  Result<GlProgram> program = GlProgram::Create(gl, "ui", "ui");
  if (!program) return Fail(program);
  return UiLayer(gl, std::move(*program));
}

UiLayer::UiLayer(const Gl& gl, GlProgram program) : gl_(&gl), program_(std::move(program)) {
  gl.GenVertexArrays(1, &array_);
  gl.BindVertexArray(array_);
  gl.GenBuffers(1, &vertices_);
  gl.GenBuffers(1, &indices_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  const auto attribute = [&gl](GLuint location, GLint components, GLenum type, size_t offset) {
    gl.EnableVertexAttribArray(location);
    // A byte offset into the bound buffer, passed as GL wants it: as a pointer.
    gl.VertexAttribPointer(location, components, type, type == GL_FLOAT ? GL_FALSE : GL_TRUE,
                           sizeof(UiVertex), reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, GL_FLOAT, offsetof(UiVertex, px));
  attribute(1, 2, GL_FLOAT, offsetof(UiVertex, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, offsetof(UiVertex, rgba));
  gl.BindVertexArray(0);
}

UiLayer::UiLayer(UiLayer&& other) noexcept
    : gl_(other.gl_),
      program_(std::move(other.program_)),
      array_(std::exchange(other.array_, 0)),
      vertices_(std::exchange(other.vertices_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      textures_(std::exchange(other.textures_, {})),
      commands_(std::move(other.commands_)),
      pixels_(std::move(other.pixels_)) {}

UiLayer::~UiLayer() {
  for (const auto& [id, texture] : textures_) gl_->DeleteTextures(1, &texture);
  if (!array_) return;
  gl_->DeleteVertexArrays(1, &array_);
  gl_->DeleteBuffers(1, &vertices_);
  gl_->DeleteBuffers(1, &indices_);
}

Result<void> UiLayer::SetTexture(uint32_t id, const Image& image) {
  const size_t wanted = size_t{4} * static_cast<size_t>(image.width) * image.height;
  if (image.width < 1 || image.height < 1 || image.pixels.size() != wanted) {
    return Fail(ErrorCode::kBadNumber, "the texture's size and pixels don't agree");
  }
  GLuint& texture = textures_[id];
  if (!texture) gl_->GenTextures(1, &texture);
  gl_->BindTexture(GL_TEXTURE_2D, texture);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, image.pixels.data());
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return CheckGl(*gl_, "taking in a texture of panels");
}

void UiLayer::SetMesh(const UiMesh& mesh, const std::vector<UiShape>& shapes) {
  commands_ = mesh.commands;
  pixels_.clear();
  for (const UiShape& shape : shapes) pixels_.push_back(shape.pixels);
  gl_->BindVertexArray(array_);
  gl_->BindBuffer(GL_ARRAY_BUFFER, vertices_);
  gl_->BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.vertices.size() * sizeof(UiVertex)),
                  mesh.vertices.data(), GL_STREAM_DRAW);
  gl_->BufferData(GL_ELEMENT_ARRAY_BUFFER,
                  static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(uint32_t)),
                  mesh.indices.data(), GL_STREAM_DRAW);
}

void UiLayer::DrawCommand(const UiCommand& command, const PixelRect& rect, int height_px) const {
  const auto texture = textures_.find(command.texture);
  if (texture == textures_.end()) return;
  SetScissor(*gl_, rect, height_px);
  gl_->BindTexture(GL_TEXTURE_2D, texture->second);
  // A byte offset into the bound indices, passed as GL wants it: as a pointer.
  gl_->DrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.index_count), GL_UNSIGNED_INT,
                    reinterpret_cast<const void*>(command.first_index * sizeof(uint32_t)));
}

void UiLayer::Draw(const Damage& repair, std::span<const float> opacities) const {
  bool begun = false;
  for (size_t i = 0; i < commands_.size(); ++i) {
    const float opacity = OpacityOf(commands_[i].part, opacities);
    if (opacity <= 0 || !repair.Touches(pixels_[i])) continue;
    if (!begun) {
      gl_->BlendEquation(GL_FUNC_ADD);
      gl_->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
      program_.Use();
      program_.Set("picture", Vec2f(repair.size()));
      program_.Set("image", 0);
      gl_->ActiveTexture(GL_TEXTURE0);
      gl_->BindVertexArray(array_);
      begun = true;
    }
    program_.Set("opacity", opacity);
    for (const PixelRect& rect : repair.rects()) {
      const PixelRect drawn = Intersection(rect, pixels_[i]);
      if (!IsEmpty(drawn)) DrawCommand(commands_[i], drawn, repair.size().y);
    }
  }
}

}  // namespace parti::render
