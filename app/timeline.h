// The steps of a session in a line: what undo goes back to, the present, what redo goes on to.
// Bounded in number and in memory. Knows nothing of commands.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "app/session_record.h"

namespace parti::app {

/// A step: its record, and its state as far as memory allows.
struct TimelineStep {
  SessionRecord record;
  std::optional<SessionState> state;
};

/// A value; the present step always has its state.
class Timeline {
 public:
  /// Numbers of the steps that there are; a step keeps its number, and forgotten ones are not used
  /// again, but those after `now` are when a change takes their place.
  struct Span {
    uint64_t first = 0;
    uint64_t now = 0;
    uint64_t last = 0;
    bool operator==(const Span&) const = default;
  };

  Timeline(SessionState present, const UndoLimits& limits);
  /// Goes on where a document left: `records` are the steps from number `first` on; the step
  /// `now` has `present` as its state. first <= now < first + records.size().
  Timeline(std::vector<SessionRecord> records, uint64_t first, uint64_t now, SessionState present,
           const UndoLimits& limits);

  const SessionState& present() const { return *At(span_.now).state; }
  Span span() const { return span_; }
  /// step in [span().first, span().last].
  const TimelineStep& step(uint64_t number) const { return At(number); }

  /// A new step after the present one; what could be redone is gone. A state that differs from the
  /// present one in nothing that is kept of it (SessionRecord) is no step.
  void Change(SessionState next);
  /// The present step, looked at in another way.
  void Look(SessionState same);
  /// Makes another step the present one; `state` is that step's.
  void GoTo(uint64_t number, SessionState state);

 private:
  const TimelineStep& At(uint64_t number) const;
  TimelineStep& At(uint64_t number);
  void Bound();
  void DropStates();
  void ForgetSteps();

  UndoLimits limits_;
  Span span_;
  std::deque<TimelineStep> steps_;
};

}  // namespace parti::app
