// Panels as triangles: what app's panels hand to the canvas, which draws them above the ink.
// Values only; render knows nothing of how panels are made.
#pragma once

#include <cstdint>
#include <vector>

#include "render/pixel_rect.h"
#include "render/scene.h"

namespace parti::render {

/// A corner of a triangle.
struct UiVertex {
  Vec2f px;           ///< in the view, from the top left, y down
  Vec2f uv;           ///< in the command's texture, [0, 1], from its top left
  uint32_t rgba = 0;  ///< sRGB, straight alpha; red in the lowest byte, alpha in the highest

  bool operator==(const UiVertex&) const = default;
};

/// Triangles with one texture and clip, drawn in order, each over those before.
struct UiCommand {
  PixelRect clip;            ///< nothing is drawn outside
  uint32_t texture = 0;      ///< an id that the canvas was told of; its colours are multiplied
  uint32_t first_index = 0;  ///< into UiMesh::indices
  uint32_t index_count = 0;  ///< a multiple of 3
  uint32_t part = 0;         ///< what it fades with: Canvas::SetPanelOpacities

  bool operator==(const UiCommand&) const = default;
};

/// All panels of one frame. Blended "over" with straight alpha; triangles wind either way.
struct UiMesh {
  std::vector<UiVertex> vertices;
  std::vector<uint32_t> indices;  ///< into vertices, three to a triangle
  std::vector<UiCommand> commands;

  bool operator==(const UiMesh&) const = default;
};

}  // namespace parti::render
