#include "app/session_record.h"

#include <algorithm>
#include <tuple>

#include "app/sketch_reading.h"

namespace parti::app {
namespace {

bool IsThere(const Model& model, const ShapeRef& ref) {
  return ref.lot < model.derived.size() && ref.shape < model.derived[ref.lot]->tree.size();
}

}  // namespace

bool SessionRecord::operator==(const SessionRecord& other) const {
  const auto rest = [](const SessionRecord& r) {
    return std::tie(r.ground, r.strokes, r.unread, r.query, r.target, r.selection, r.views,
                    r.in_hand, r.just_made, r.camera);
  };
  return rest(*this) == rest(other) && (rules == other.rules || *rules == *other.rules);
}

SessionRecord RecordOf(const SessionState& state) {
  const auto& ground = state.model.ground;
  return {ground->underived ? ground->underived : ground,
          state.model.rules,
          state.sketch.strokes,
          state.sketch.unread,
          state.sketch.query,
          state.sketch.target,
          state.selection.shapes,
          state.views,
          state.in_hand,
          state.just_made,
          state.camera};
}

Result<SessionState> Restore(const SessionRecord& record, const SessionOptions& options,
                             const Model* nearby) {
  auto ground = WithRoots(record.ground, nearby);
  if (!ground) return Fail(ground);
  auto model = Derived(std::move(*ground), record.rules, nearby, grammar::Unfit::kSkip);
  if (!model) return Fail(model);
  SessionState state;
  state.camera = record.camera;
  state.model = std::move(*model);
  state.views = record.views;
  state.in_hand = record.in_hand;
  state.just_made = record.just_made;
  std::vector<ShapeRef> selected = record.selection;
  std::erase_if(selected, [&](const ShapeRef& ref) { return !IsThere(state.model, ref); });
  state.selection = SelectionOf(state.model, std::move(selected));
  state.sketch.strokes = record.strokes;
  state.sketch.unread = record.unread;
  state.sketch.query = record.query;
  if (record.target && IsThere(state.model, *record.target)) state.sketch.target = record.target;
  // What can't be read any more stays as ink.
  if (auto read = ReadSketch(state, options)) state.sketch = std::move(*read);
  return state;
}

}  // namespace parti::app
