#include "app/timeline.h"

#include <algorithm>
#include <utility>

#include "base/check.h"

namespace parti::app {
namespace {

// What things take, within a factor of two: exact sums would cost more than they decide.
constexpr size_t kShapeBytes = sizeof(grammar::Shape) + 64;
constexpr size_t kNodeBytes = 600;
constexpr size_t kSuggestionBytes = 1000;

size_t NodesIn(const std::vector<grammar::SelectionActionNode>& nodes) {
  size_t count = nodes.size();
  for (const auto& node : nodes) count += NodesIn(node.children);
  return count;
}

size_t RulesBytes(const grammar::Trees& trees) {
  size_t count = 0;
  for (const auto& tree : trees) count += 1 + NodesIn(tree.nodes);
  return count * kNodeBytes;
}

using Strokes = std::vector<std::shared_ptr<const DrawnStroke>>;

size_t NewStrokeBytes(const Strokes& strokes, const Strokes* before) {
  size_t bytes = 0;
  for (const auto& drawn : strokes) {
    const bool known =
        before != nullptr && std::find(before->begin(), before->end(), drawn) != before->end();
    if (!known) bytes += sizeof(DrawnStroke) + drawn->stroke.size() * sizeof(StrokeSample);
  }
  return bytes;
}

size_t SourceBytes(const SessionRecord& record) {
  size_t bytes = 0;
  if (!record.ground->source) return bytes;
  for (const grammar::RuleFile& file : record.ground->source->files) bytes += file.text.size();
  return bytes;
}

/// What a record takes that `before` (may be null) does not have too.
size_t RecordBytes(const SessionRecord& record, const SessionRecord* before) {
  size_t bytes = sizeof(TimelineStep);
  bytes += (record.strokes.size() + record.unread.size()) * sizeof(record.strokes[0]);
  bytes += NewStrokeBytes(record.strokes, before ? &before->strokes : nullptr);
  bytes += NewStrokeBytes(record.unread, before ? &before->unread : nullptr);
  bytes += record.selection.size() * sizeof(ShapeRef) + record.views.size() * sizeof(NamedView);
  if (before == nullptr || before->ground != record.ground) bytes += SourceBytes(record);
  if (before == nullptr || before->rules != record.rules) bytes += RulesBytes(*record.rules);
  return bytes;
}

/// What a state takes that `before` (may be null) does not have too.
size_t StateBytes(const SessionState& state, const SessionState* before) {
  size_t bytes = sizeof(SessionState) + state.sketch.suggestions.size() * kSuggestionBytes;
  bytes += state.model.derived.size() * sizeof(void*) * 2;
  for (size_t i = 0; i < state.model.derived.size(); ++i) {
    const auto& derivation = state.model.derived[i];
    const bool shared = before != nullptr && i < before->model.derived.size() &&
                        before->model.derived[i] == derivation;
    if (!shared) bytes += derivation->tree.size() * kShapeBytes;
  }
  return bytes;
}

}  // namespace

Timeline::Timeline(SessionState present, const UndoLimits& limits) : limits_(limits) {
  steps_.push_back({RecordOf(present), std::move(present)});
}

Timeline::Timeline(std::vector<SessionRecord> records, uint64_t first, uint64_t now,
                   SessionState present, const UndoLimits& limits)
    : limits_(limits), span_{first, now, first + records.size() - 1} {
  CHECK(now >= first && now <= span_.last, "the present is one of the steps");
  for (SessionRecord& record : records) steps_.push_back({std::move(record), std::nullopt});
  At(now).state = std::move(present);
  Bound();
}

const TimelineStep& Timeline::At(uint64_t number) const {
  CHECK(number >= span_.first && number <= span_.last, "there is such a step");
  return steps_[number - span_.first];
}

TimelineStep& Timeline::At(uint64_t number) {
  return const_cast<TimelineStep&>(std::as_const(*this).At(number));
}

void Timeline::Change(SessionState next) {
  SessionRecord record = RecordOf(next);
  if (record == At(span_.now).record) {
    At(span_.now) = {std::move(record), std::move(next)};
    return;
  }
  steps_.resize(span_.now - span_.first + 1);
  steps_.push_back({std::move(record), std::move(next)});
  span_.last = ++span_.now;
  Bound();
}

void Timeline::Look(SessionState same) { At(span_.now) = {RecordOf(same), std::move(same)}; }

void Timeline::GoTo(uint64_t number, SessionState state) {
  At(number) = {RecordOf(state), std::move(state)};
  span_.now = number;
  Bound();
}

void Timeline::Bound() {
  DropStates();
  ForgetSteps();
}

/// Keeps the states nearest to the present, on either side as long as there is room.
void Timeline::DropStates() {
  size_t bytes = 0;
  bool room = true;
  const SessionState* neighbour = nullptr;
  const auto begin_side = [&] {
    bytes = 0;
    room = true;
    neighbour = &present();
  };
  const auto visit = [&](TimelineStep* step) {
    if (room && step->state) {
      bytes += StateBytes(*step->state, neighbour);
      room = bytes <= limits_.bytes / 4;
    }
    if (!room) step->state.reset();
    if (step->state) neighbour = &*step->state;
  };
  begin_side();
  for (uint64_t i = span_.now; i > span_.first; --i) visit(&At(i - 1));
  begin_side();
  for (uint64_t i = span_.now + 1; i <= span_.last; ++i) visit(&At(i));
}

/// Forgets the oldest steps, and where that is not enough the last ones.
void Timeline::ForgetSteps() {
  size_t bytes = 0;
  const SessionRecord* before = nullptr;
  std::vector<size_t> sizes;
  for (const TimelineStep& step : steps_) {
    sizes.push_back(RecordBytes(step.record, before));
    bytes += sizes.back();
    before = &step.record;
  }
  const auto too_much = [&] { return bytes > limits_.bytes / 2; };
  size_t oldest = 0;
  while (span_.first < span_.now && (span_.now - span_.first > limits_.steps || too_much())) {
    bytes -= sizes[oldest++];
    steps_.pop_front();
    ++span_.first;
  }
  while (span_.last > span_.now && too_much()) {
    bytes -= sizes.back();
    sizes.pop_back();
    steps_.pop_back();
    --span_.last;
  }
}

}  // namespace parti::app
