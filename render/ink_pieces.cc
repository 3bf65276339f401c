#include "render/ink_pieces.h"

#include <algorithm>
#include <cmath>

#include "render/bounds.h"
#include "render/damage.h"

namespace parti::render {
namespace {

float Radius(const Ink& ink, size_t i) {
  const float width = i < ink.widths_px.size() ? ink.widths_px[i] : 1.0f;
  return std::isfinite(width) ? 0.5f * std::clamp(width, 0.0f, kWidestInk_px) : 0.5f;
}

bool Drawable(const Ink& ink, size_t i) {
  return i < ink.points.size() && IsDrawable(Vec3f(ink.points[i], 0));
}

bool IsDot(const Ink& ink, size_t i) {
  return Drawable(ink, i) && !Drawable(ink, i + 1) && (i == 0 || !Drawable(ink, i - 1));
}

InkPiece Piece(const Ink& ink, size_t i, size_t next) {
  return {ink.points[i], ink.points[next], {Radius(ink, i), Radius(ink, next)}};
}

}  // namespace

const std::vector<VertexAttribute>& InkLayout() {
  static const std::vector<VertexAttribute> layout = {
      {0, 2, GL_FLOAT, false, offsetof(InkPiece, a)},
      {1, 2, GL_FLOAT, false, offsetof(InkPiece, b)},
      {2, 2, GL_FLOAT, false, offsetof(InkPiece, radii)}};
  return layout;
}

void AppendPieces(const Ink& ink, size_t from, std::vector<InkPiece>* pieces) {
  for (size_t i = from > 0 ? from - 1 : 0; i < ink.points.size(); ++i) {
    const bool joined = Drawable(ink, i) && Drawable(ink, i + 1);
    if (joined && i + 1 >= from) pieces->push_back(Piece(ink, i, i + 1));
    // A dot just before `from` was not known to be one until the sample at `from` left a gap.
    if (IsDot(ink, i) && (i >= from || i + 1 == from)) pieces->push_back(Piece(ink, i, i));
  }
}

bool EndsInDot(const Ink& ink) { return !ink.points.empty() && IsDot(ink, ink.points.size() - 1); }

PixelRect PixelsOf(const InkPiece& piece, const glm::ivec2& size) {
  const float margin = std::max({piece.radii.x, piece.radii.y, 0.5f}) + 1;
  return PixelsAround(glm::min(piece.a, piece.b), glm::max(piece.a, piece.b), margin, size);
}

}  // namespace parti::render
