// What a hovering pen means on the shape under it: a corner, an edge, or the face.
// Which shape is under it is the picture's knowledge (picking.h); how it is shown is overlay.h's.
#pragma once

#include <optional>
#include <string>

#include "app/session_state.h"
#include "base/camera.h"

namespace parti::app {

/// The finest thing near a pixel.
struct Snap {
  enum class Kind : uint8_t { kFace, kEdge, kCorner };
  Kind kind = Kind::kFace;
  Vec3 point{0, 0, 0};  ///< of it, nearest to the pixel; m
  Segment3 edge;        ///< kEdge: all of it
  /// "corner of Facade", "edge of Facade", "Facade"; of a shape without a name that of the nearest
  /// above it.
  std::string word;
};

/// ref       the shape seen at px.
/// reach_px  corners this near come before edges, and edges this near before the face, [0, 100].
/// returns   what is meant on the face under the pixel; the edges of the shape's other faces are
///           not. Nothing where the shape is not at that pixel.
/// cost      linear in the triangles and edges of the one shape.
std::optional<Snap> SnapAt(const Model& model, const ShapeRef& ref, const Camera& camera,
                           const Vec2& px, double reach_px);

}  // namespace parti::app
