#include "render/mark_layer.h"

#include "render/scissor.h"

namespace parti::render {

MarkLayer::MarkLayer(const Gl& gl, const glm::ivec2& size, Programs programs,
                     GlFramebuffer coverage)
    : gl_(&gl),
      size_(size),
      programs_(std::move(programs)),
      full_screen_(gl),
      batch_(gl),
      coverage_(std::move(coverage)) {}

Result<MarkLayer> MarkLayer::Create(const Gl& gl, const glm::ivec2& size) {
  Result<GlProgram> ink = GlProgram::Create(gl, "ink", "ink");
  if (!ink) return Fail(ink);
  Result<GlProgram> over = GlProgram::Create(gl, "full_screen", "mark_over");
  if (!over) return Fail(over);
  Result<GlFramebuffer> coverage = GlFramebuffer::Create(gl, {size.x, size.y, GL_R8, 0, 0, true});
  if (!coverage) return Fail(coverage);
  return MarkLayer(gl, size, {std::move(*ink), std::move(*over)}, std::move(*coverage));
}

void MarkLayer::DrawCoverage(const MarkGroup& group, const Damage& where) const {
  coverage_.Bind();
  gl_->ClearColor(0, 0, 0, 0);
  gl_->BlendEquation(GL_MAX);
  programs_.ink.Use();
  programs_.ink.Set("picture", Vec2f(size_));
  for (const PixelRect& rect : where.rects()) {
    SetScissor(*gl_, rect, size_.y);
    gl_->Clear(GL_COLOR_BUFFER_BIT);
    batch_.Draw(group.pieces);
  }
}

void MarkLayer::Draw(const std::vector<MarkGroup>& groups, const Damage& repair,
                     GLuint framebuffer) const {
  for (const MarkGroup& group : groups) {
    const Damage where = Common(group.pixels, repair);
    if (where.empty()) continue;
    DrawCoverage(group, where);
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl_->BlendEquation(GL_FUNC_ADD);
    gl_->BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    programs_.over.Use();
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, coverage_.color_texture());
    programs_.over.Set("coverage", 0);
    programs_.over.Set("color", group.color);
    for (const PixelRect& rect : where.rects()) {
      SetScissor(*gl_, rect, size_.y);
      full_screen_.Draw();
    }
  }
}

}  // namespace parti::render
