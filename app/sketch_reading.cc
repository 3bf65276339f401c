#include "app/sketch_reading.h"

#include <algorithm>

#include "sketch/target.h"

namespace parti::app {
namespace {

Result<Sketch> ReadOnTargetWith(const SessionState& state,
                                const sketch::SketchParameters& parameters) {
  Sketch sketch = state.sketch;
  sketch.lines = {};
  const grammar::Item& item = ShapeAt(state.model, *sketch.target).item;
  for (const auto& drawn : sketch.strokes) {
    auto lines = sketch::LiftStroke(drawn->stroke, item, drawn->camera, parameters);
    if (!lines) return Fail(lines);
    sketch.lines.lines.insert(sketch.lines.lines.end(), lines->begin(), lines->end());
  }
  auto suggestions = sketch::Suggest(sketch.lines, item, parameters);
  if (!suggestions) return Fail(suggestions);
  sketch.suggestions = std::move(*suggestions);
  return sketch;
}

/// Lines of several views: whole edges first, parts of edges where those fail.
Result<Sketch> ReadOnTarget(const SessionState& state, const sketch::SketchParameters& parameters) {
  auto read = ReadOnTargetWith(state, parameters);
  if (read || read.error().code != ErrorCode::kNoFit) return read;
  auto generous = ReadOnTargetWith(state, sketch::Generous(parameters));
  return generous ? generous : read;
}

/// The best reading of strokes in one view over all shapes that may be meant.
Result<Sketch> ReadInOneView(const SessionState& state,
                             const sketch::SketchParameters& parameters) {
  const std::vector<ShapeRef> targets = TargetsOf(state.model, state.sketch.query);
  if (targets.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to draw on",
                state.model.lots().empty() ? "draw the outline of the lot on the ground"
                                           : "let the sketch act on anything again: query none");
  }
  std::vector<grammar::Item> items;
  items.reserve(targets.size());
  for (const ShapeRef& ref : targets) items.push_back(ShapeAt(state.model, ref).item);
  std::vector<Stroke> strokes;
  for (const auto& drawn : state.sketch.strokes) strokes.push_back(drawn->stroke);

  const Camera& camera = state.sketch.strokes.back()->camera;
  auto ranked = sketch::RankTargets(strokes, camera, items, parameters);
  if (!ranked) return Fail(ranked);
  sketch::RankedTarget& best = ranked->front();
  Sketch sketch = state.sketch;
  sketch.target = targets[best.item];
  sketch.lines = std::move(best.reading.configuration);
  sketch.suggestions = std::move(best.reading.suggestions);
  return sketch;
}

}  // namespace

std::vector<ShapeRef> TargetsOf(const Model& model, const std::optional<grammar::Query>& query) {
  std::vector<ShapeRef> visible = VisibleShapes(model);
  if (!query) return visible;
  std::vector<std::vector<grammar::ShapeIndex>> meant;
  for (const auto& derivation : model.derived) {
    auto product = grammar::ProductOf(*query, derivation->tree);
    meant.push_back(product ? std::move(*product) : std::vector<grammar::ShapeIndex>());
  }
  std::erase_if(visible, [&](const ShapeRef& ref) {
    return !std::binary_search(meant[ref.lot].begin(), meant[ref.lot].end(), ref.shape);
  });
  return visible;
}

Result<Sketch> ReadSketch(const SessionState& state, const SessionOptions& options) {
  const auto& strokes = state.sketch.strokes;
  if (strokes.empty()) return Sketch{{}, state.sketch.unread, state.sketch.query, {}, {}, {}};
  const bool one_view = std::all_of(strokes.begin(), strokes.end(), [&](const auto& drawn) {
    return drawn->camera == strokes.back()->camera;
  });
  return one_view || !state.sketch.target ? ReadInOneView(state, options.sketch)
                                          : ReadOnTarget(state, options.sketch);
}

SessionState WithSketchAbout(SessionState state, std::optional<grammar::Query> query,
                             const SessionOptions& options) {
  state.sketch.query = std::move(query);
  state.sketch.target.reset();
  state.sketch.suggestions.clear();
  state.sketch.lines = {};
  if (auto read = ReadSketch(state, options)) state.sketch = std::move(*read);
  return state;
}

}  // namespace parti::app
