#include "app/panels/hints.h"

namespace parti::app::panels {
namespace {

bool HasNodes(const SessionState& state) {
  for (const auto& tree : state.model.trees()) {
    if (!tree.nodes.empty()) return true;
  }
  return false;
}

std::string HintOfMode(PointerMode mode) {
  switch (mode) {
    case PointerMode::kErase:
      return "Draw over strokes to erase them.";
    case PointerMode::kSelect:
      return "Tap the shapes that you mean.";
    case PointerMode::kOrbit:
      return "Drag to look from another side.";
    case PointerMode::kPan:
      return "Drag to move the view.";
    case PointerMode::kZoom:
      return "Drag up to come nearer, down to go farther.";
    case PointerMode::kDraw:
      return "";
  }
  return "";
}

}  // namespace

std::string HintOf(const PanelView& view) {
  const bool nothing = !view.session || view.session->state->model.lots().empty();
  if (nothing) return "Draw a closed outline on the ground: it becomes the lot.";
  const SessionState& state = *view.session->state;
  if (!view.elements.empty() && view.mode == PointerMode::kSelect) {
    return "Drag an element by its middle, an edge or a corner, or tap which shapes you mean.";
  }
  const bool chosen = state.sketch.query.has_value();
  const bool drawn = !state.sketch.strokes.empty() || !state.sketch.unread.empty();
  if (chosen && !drawn && view.mode == PointerMode::kDraw) {
    return "Draw on one of them: what you make is made on all of them.";
  }
  if (chosen && !drawn && view.mode == PointerMode::kSelect) {
    return "Draw (D) on one of them: what you make is made on all of them.";
  }
  if (!state.selection.shapes.empty()) return "Tap which shapes you mean, or tap more of them.";
  if (!state.sketch.suggestions.empty()) return "Tap what you meant, or draw on.";
  if (drawn) {
    return chosen ? "Nothing to suggest for these lines there: draw one more, or erase them."
                  : "Nothing to suggest for these lines: draw one more, or erase them.";
  }
  if (view.mode != PointerMode::kDraw) return HintOfMode(view.mode);
  if (!HasNodes(state)) return "Draw a line up from the lot: it becomes a building.";
  return "Draw lines on a face to divide it. The rules (R) hold every number.";
}

}  // namespace parti::app::panels
