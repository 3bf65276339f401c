#include "app/overlay.h"

#include <algorithm>

#include "app/meaning.h"

namespace parti::app {
namespace {

constexpr float kQuiet = 0.45f;  ///< opacity of a wire frame that nobody has asked for

WorldMarks SelectedOf(const SessionState& state, const DrawingStyle& style) {
  WorldMarks marks{{}, style.selected, style.selected_px};
  for (const ShapeRef& ref : state.selection.shapes) {
    const std::vector<Segment3> outline = OutlineOf(state.model, ref);
    marks.segments.insert(marks.segments.end(), outline.begin(), outline.end());
  }
  return marks;
}

}  // namespace

std::vector<WorldMarks> OverlayOf(const SessionState& state, std::optional<size_t> preview,
                                  const DrawingStyle& style) {
  std::vector<WorldMarks> overlay;
  overlay.emplace_back(SelectedOf(state, style));
  // A suggestion that its shape can't take after all is only left out of the picture.
  if (auto meaning = MeaningOf(state, preview.value_or(0))) {
    render::Vec4f wire = style.suggestion;
    if (!preview) wire.a *= kQuiet;
    overlay.push_back(
        {std::move(meaning->edges), wire, style.suggestion_px, style.suggestion_dash_px});
    overlay.push_back({std::move(meaning->lines), style.lifted, style.lifted_px});
  }
  return overlay;
}

WorldMarks HoverOf(const Model& model, const ShapeRef& ref, const DrawingStyle& style) {
  return {OutlineOf(model, ref), style.hovered, style.hovered_px};
}

void AddSnap(const Snap& snap, const View& view, std::vector<render::Mark>* marks,
             const DrawingStyle& style) {
  render::Vec4f color = style.hovered;
  color.a = 1;
  if (snap.kind == Snap::Kind::kEdge) {
    Project({WorldMarks{{snap.edge}, color, style.snap_px / 3}}, view, marks);
  } else if (snap.kind == Snap::Kind::kCorner) {
    if (const auto px = view.Project(snap.point)) {
      marks->push_back({{render::Vec2f(*px)}, color, style.snap_px});
    }
  }
}

void Project(const std::vector<WorldMarks>& lines, const View& view,
             std::vector<render::Mark>* marks) {
  for (const WorldMarks& group : lines) {
    for (const Segment3& segment : group.segments) {
      const auto seen = view.Project(segment);
      if (!seen) continue;
      marks->push_back({{render::Vec2f(seen->a), render::Vec2f(seen->b)},
                        group.color,
                        group.width_px,
                        group.dash_px});
    }
  }
}

}  // namespace parti::app
