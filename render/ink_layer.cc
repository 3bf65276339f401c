#include "render/ink_layer.h"

#include "render/scissor.h"

namespace parti::render {

InkLayer::InkLayer(const Gl& gl, const glm::ivec2& size, Programs programs, GlFramebuffer settled,
                   GlFramebuffer coverage, GlFramebuffer tail)
    : gl_(&gl),
      size_(size),
      programs_(std::move(programs)),
      full_screen_(gl),
      batch_(gl),
      settled_(std::move(settled)),
      coverage_(std::move(coverage)),
      tail_(std::move(tail)),
      extent_(size),
      group_extent_(size),
      tail_extent_(size) {}

Result<InkLayer> InkLayer::Create(const Gl& gl, const glm::ivec2& size) {
  Result<GlProgram> ink = GlProgram::Create(gl, "ink", "ink");
  if (!ink) return Fail(ink);
  Result<GlProgram> over = GlProgram::Create(gl, "full_screen", "ink_over");
  if (!over) return Fail(over);
  Result<GlFramebuffer> settled =
      GlFramebuffer::Create(gl, {size.x, size.y, GL_SRGB8_ALPHA8, 0, 0, true});
  if (!settled) return Fail(settled);
  Result<GlFramebuffer> coverage = GlFramebuffer::Create(gl, {size.x, size.y, GL_R8, 0, 0, true});
  if (!coverage) return Fail(coverage);
  Result<GlFramebuffer> tail = GlFramebuffer::Create(gl, {size.x, size.y, GL_R8, 0, 0, true});
  if (!tail) return Fail(tail);
  InkLayer layer(gl, size, {std::move(*ink), std::move(*over)}, std::move(*settled),
                 std::move(*coverage), std::move(*tail));
  gl.Enable(GL_SCISSOR_TEST);
  for (const GlFramebuffer* target : {&layer.settled_, &layer.coverage_, &layer.tail_}) {
    layer.Clear(*target, {0, 0, size.x, size.y});
  }
  gl.Disable(GL_SCISSOR_TEST);
  return layer;
}

void InkLayer::Update(const InkStrokes& strokes, const InkNews& news) {
  if (news.fresh.empty() && news.rebuild.empty() && !news.tail_changed) return;
  gl_->Viewport(0, 0, size_.x, size_.y);
  gl_->Disable(GL_DEPTH_TEST);
  gl_->Enable(GL_BLEND);
  gl_->Enable(GL_SCISSOR_TEST);
  for (const InkGroupPieces& fresh : news.fresh) DrawFresh(fresh);
  for (const PixelRect& rect : news.rebuild.rects()) Rebuild(strokes, rect);
  if (!news.rebuild.empty()) {
    group_extent_ = strokes.LastGroupExtent();
    extent_ = strokes.Extent();
    extent_.Add(tail_extent_);
  }
  if (news.tail_changed) UpdateTail(strokes.tail());
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_BLEND);
}

void InkLayer::DrawFresh(const InkGroupPieces& fresh) {
  if (fresh.color != color_) SettleGroup();
  color_ = fresh.color;
  for (const InkPiece& piece : fresh.pieces) group_extent_.Add(PixelsOf(piece, size_));
  extent_.Add(group_extent_);
  SetScissor(*gl_, {0, 0, size_.x, size_.y}, size_.y);
  DrawCoverage(coverage_, fresh.pieces);
}

/// The greatest coverage of what is there and the pieces.
void InkLayer::DrawCoverage(const GlFramebuffer& target, std::span<const InkPiece> pieces) const {
  if (pieces.empty()) return;
  target.Bind();
  gl_->BlendEquation(GL_MAX);
  programs_.ink.Use();
  programs_.ink.Set("picture", Vec2f(size_));
  batch_.Draw(pieces);
}

void InkLayer::Clear(const GlFramebuffer& target, const PixelRect& rect) const {
  target.Bind();
  SetScissor(*gl_, rect, size_.y);
  gl_->ClearColor(0, 0, 0, 0);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

/// Colours what the last group covers in a rectangle, and clears the coverage.
void InkLayer::Settle(const PixelRect& rect) const {
  if (!gl_->is_gles) gl_->Enable(GL_FRAMEBUFFER_SRGB);
  settled_.Bind();
  SetScissor(*gl_, rect, size_.y);
  gl_->BlendEquation(GL_FUNC_ADD);
  gl_->BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  programs_.over.Use();
  gl_->ActiveTexture(GL_TEXTURE0);
  gl_->BindTexture(GL_TEXTURE_2D, coverage());
  programs_.over.Set("coverage", 0);
  programs_.over.Set("color", color_);
  full_screen_.Draw();
  if (!gl_->is_gles) gl_->Disable(GL_FRAMEBUFFER_SRGB);
  Clear(coverage_, rect);
}

void InkLayer::SettleGroup() {
  for (const PixelRect& rect : group_extent_.rects()) Settle(rect);
  group_extent_.Clear();
}

void InkLayer::Rebuild(const InkStrokes& strokes, const PixelRect& rect) {
  Clear(settled_, rect);
  Clear(coverage_, rect);
  const std::vector<InkGroupPieces> groups = strokes.PiecesIn(rect);
  for (size_t i = 0; i < groups.size(); ++i) {
    if (i > 0) Settle(rect);
    color_ = groups[i].color;
    SetScissor(*gl_, rect, size_.y);
    DrawCoverage(coverage_, groups[i].pieces);
  }
}

void InkLayer::UpdateTail(const std::vector<InkPiece>& tail) {
  for (const PixelRect& rect : tail_extent_.rects()) Clear(tail_, rect);
  tail_extent_.Clear();
  for (const InkPiece& piece : tail) tail_extent_.Add(PixelsOf(piece, size_));
  extent_.Add(tail_extent_);
  SetScissor(*gl_, {0, 0, size_.x, size_.y}, size_.y);
  DrawCoverage(tail_, tail);
}

}  // namespace parti::render
