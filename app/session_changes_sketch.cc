// Strokes drawn, read and erased; shapes selected.
#include <fmt/format.h>

#include <algorithm>

#include "app/lot_from_stroke.h"
#include "app/session_changes.h"
#include "app/session_commands.h"
#include "app/sketch_reading.h"

namespace parti::app {
namespace {

using Strokes = std::vector<std::shared_ptr<const DrawnStroke>>;

bool EraseFrom(Strokes* strokes, uint32_t number) {
  return std::erase_if(*strokes, [&](const auto& drawn) { return drawn->number == number; }) > 0;
}

/// All strokes of the sketch as one outline, or the newest alone: earlier ones may have failed.
Result<std::string> LotOutlined(const Strokes& strokes, const LotParameters& parameters) {
  auto lot = LotFromStrokes(strokes, parameters);
  if (lot || strokes.size() == 1) return lot;
  auto alone = LotFromStrokes(std::span(strokes).last(1), parameters);
  return alone ? alone : lot;
}

StrokeOutcome AfterOutline(SessionState state, std::shared_ptr<const DrawnStroke> stroke,
                           const SessionOptions& options) {
  state.sketch.strokes.push_back(stroke);
  const auto lot = LotOutlined(state.sketch.strokes, options.lot);
  if (lot) {
    const SetLot begun{*lot};
    auto next = Do(begun, state, options);
    if (next) return {std::move(*next), {}, begun};
    return {std::move(state), Fail(next), {}};
  }
  if (lot.error().code != ErrorCode::kNoFit) {
    state.sketch.strokes.pop_back();
    state.sketch.unread.push_back(std::move(stroke));
  }
  return {std::move(state), Fail(lot), {}};
}

/// No shape selected, and nothing chosen for what was.
SessionState WithoutShapes(SessionState state, const SessionOptions& options) {
  state.selection = {};
  return state.sketch.query ? WithSketchAbout(std::move(state), std::nullopt, options) : state;
}

}  // namespace

Result<SessionState> Do(const Erase& command, SessionState state, const SessionOptions& options) {
  std::vector<uint32_t> numbers;
  for (const Strokes* strokes : {&state.sketch.strokes, &state.sketch.unread}) {
    for (const auto& drawn : *strokes) numbers.push_back(drawn->number);
  }
  for (const uint32_t number : command.strokes) {
    if (std::find(numbers.begin(), numbers.end(), number) != numbers.end()) continue;
    return Fail(ErrorCode::kUnknownName, fmt::format("stroke {} is not in the sketch", number),
                numbers.empty() ? "the sketch has no strokes"
                                : fmt::format("it has {}", fmt::join(numbers, ", ")));
  }
  bool changed = false;
  for (const uint32_t number : command.strokes) {
    EraseFrom(&state.sketch.unread, number);
    changed |= EraseFrom(&state.sketch.strokes, number);
  }
  if (!changed) return state;
  state.sketch.suggestions.clear();
  state.sketch.lines = {};
  // What is left may mean nothing alone; it stays, for the lines to come.
  if (auto read = ReadSketch(state, options)) {
    state.sketch = std::move(*read);
  } else {
    state.sketch.target.reset();
  }
  return state;
}

Result<SessionState> Do(const Select& command, SessionState state, const SessionOptions& options) {
  if (command.shapes.empty()) return WithoutShapes(std::move(state), options);
  std::vector<ShapeRef> shapes = state.selection.shapes;
  for (const std::string& id : command.shapes) {
    const auto ref = RefAt(state.model, id);
    if (!ref) return Fail(ref);
    if (std::erase(shapes, *ref) == 0) shapes.push_back(*ref);
  }
  state.selection = SelectionOf(state.model, std::move(shapes));
  if (state.just_made) {
    state.in_hand.clear();
    state.just_made = false;
  }
  if (state.selection.shapes.empty()) return WithoutShapes(std::move(state), options);
  return state;
}

Result<SessionState> Do(const ClearSketch&, SessionState state, const SessionOptions&) {
  state.sketch = {};
  return state;
}

StrokeOutcome AfterStroke(SessionState state, std::shared_ptr<const DrawnStroke> stroke,
                          const SessionOptions& options) {
  if (state.model.lots().empty()) {
    return AfterOutline(std::move(state), std::move(stroke), options);
  }
  state.sketch.strokes.push_back(stroke);
  auto read = ReadSketch(state, options);
  if (read) {
    state.sketch = std::move(*read);
    return {std::move(state), {}, {}};
  }
  state.sketch.strokes.pop_back();
  state.sketch.unread.push_back(std::move(stroke));
  return {std::move(state), Fail(read), {}};
}

}  // namespace parti::app
