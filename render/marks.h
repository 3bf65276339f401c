// Marks on a canvas: the cursor, what the pen hovers over, previews; polylines in pixels that come
// and go. Values; drawing them is MarkLayer's. Ink that stays is InkStrokes'.
#pragma once

#include <vector>

#include "render/damage.h"
#include "render/ink_pieces.h"

namespace parti::render {

/// A polyline; a lone point is a dot. Blended as sRGB, so that it looks as panels do.
struct Mark {
  std::vector<Vec2f> points;  ///< px
  Vec4f color{0, 0, 0, 1};    ///< sRGB, straight alpha
  float width_px = 1.5f;
  float dash_px = 0;  ///< length of dashes and of gaps; 0: solid; at least 0.5, else solid

  bool operator==(const Mark&) const = default;
};

/// What of a mark is drawn in a picture of `size`: its dashes, or all; nothing outside the picture.
std::vector<InkPiece> PiecesOf(const Mark& mark, const glm::ivec2& size);

/// Pieces of consecutive marks of one colour are drawn as one.
struct MarkGroup {
  Vec4f color;
  std::vector<InkPiece> pieces;
  Damage pixels;
};

/// In order; marks without pieces left out.
std::vector<MarkGroup> GroupsOf(const std::vector<Mark>& marks, const glm::ivec2& size);

/// Where two sets of marks look different: the pixels of marks that are in one alone, and of those
/// whose neighbours in order changed.
Damage ChangeBetween(const std::vector<Mark>& before, const std::vector<Mark>& after,
                     const glm::ivec2& size);

}  // namespace parti::render
