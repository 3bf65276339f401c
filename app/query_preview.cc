#include "app/query_preview.h"

#include "app/meaning.h"
#include "app/scene_preparer.h"
#include "grammar/query.h"

namespace parti::app {

bool QueryPreview::operator==(const QueryPreview& other) const {
  return query == other.query && SameModel(*state, *other.state);
}

WorldMarks OutlinesOf(const QueryPreview& preview, const DrawingStyle& style) {
  WorldMarks marks{{}, style.selected, style.selected_px};
  const SessionState& state = *preview.state;
  size_t outlined = 0;
  for (size_t lot = 0; lot < state.model.derived.size(); ++lot) {
    const auto selected = grammar::ProductOf(preview.query, state.model.derived[lot]->tree);
    if (!selected) continue;
    for (const grammar::ShapeIndex shape : *selected) {
      if (++outlined > kMostOutlined) return marks;
      const auto outline = OutlineOf(state.model, {lot, shape});
      marks.segments.insert(marks.segments.end(), outline.begin(), outline.end());
    }
  }
  return marks;
}

bool QueryPreviews::Set(std::optional<grammar::Query> query,
                        const std::shared_ptr<const SessionState>& state) {
  std::optional<QueryPreview> wanted;
  if (query) wanted = {state, std::move(*query)};
  if (wanted == shown_) return false;
  shown_ = std::move(wanted);
  if (shown_) worker_.Ask(*shown_);
  return true;
}

const WorldMarks* QueryPreviews::marks() {
  if (!shown_) return nullptr;
  found_ = worker_.newest().value_or(nullptr);
  return found_ && found_->preview == *shown_ ? &found_->marks : nullptr;
}

}  // namespace parti::app
