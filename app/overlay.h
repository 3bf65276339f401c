// What lies over the picture of the model in pixels: lines that the sketch means, the wire frame of
// a suggestion, shapes that are selected or hovered over. Made once for a state, projected for each
// view, so that it follows the camera while the picture is still being painted.
// Not responsible for ink (ink_book.h) or for drawing (render/marks.h).
#pragma once

#include <optional>
#include <vector>

#include "app/scene_from_model.h"
#include "app/session_state.h"
#include "app/snap.h"
#include "render/marks.h"

namespace parti::app {

/// Lines in the world that look alike.
struct WorldMarks {
  std::vector<Segment3> segments;
  render::Vec4f color;
  float width_px = 1;
  float dash_px = 0;
};

/// What the sketch of a state means, with suggestion `preview` (from 0; nothing: the first, more
/// quietly), and the outlines of selected shapes.
/// cost  that of applying the suggestion's operation once.
std::vector<WorldMarks> OverlayOf(const SessionState& state, std::optional<size_t> preview,
                                  const DrawingStyle& style = {});

/// The outline of a shape that the pen is over.
WorldMarks HoverOf(const Model& model, const ShapeRef& ref, const DrawingStyle& style = {});

/// Adds the corner or the edge that a hovering pen means; for a face, its outline is enough.
void AddSnap(const Snap& snap, const View& view, std::vector<render::Mark>* marks,
             const DrawingStyle& style = {});

/// In pixels; what lies behind the eye is left out.
void Project(const std::vector<WorldMarks>& lines, const View& view,
             std::vector<render::Mark>* marks);

}  // namespace parti::app
