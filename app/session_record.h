// What a state of a session is, without anything that can be worked out from it: what undo keeps
// of distant steps, and what a document keeps of every step.
// Not responsible for its form in a file (document.h), or for which steps there are (timeline.h).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/session_options.h"
#include "app/session_state.h"

namespace parti::app {

/// Small: a few numbers, and two shared parts that most steps have in common with the step before
/// (equal pointers mean equal values).
struct SessionRecord {
  std::shared_ptr<const Ground> ground;         ///< not null; without roots where rules make them
  std::shared_ptr<const grammar::Trees> rules;  ///< not null
  /// Sketch::strokes and Sketch::unread; files keep their numbers.
  std::vector<std::shared_ptr<const DrawnStroke>> strokes, unread;
  std::optional<grammar::Query> query;  ///< Sketch::query
  std::optional<ShapeRef> target;       ///< Sketch::target
  std::vector<ShapeRef> selection;
  std::vector<NamedView> views;
  std::vector<int> in_hand;
  bool just_made = false;
  Camera camera;

  /// Rules that are alike are equal, shared or not; other ground is another one.
  bool operator==(const SessionRecord& other) const;
};

/// Cost: that of copying the record.
SessionRecord RecordOf(const SessionState& state);

/// The state again: derives, reads the sketch and generalises the selection as the session did.
/// What no longer fits (a shape that another version of the program does not make) is left out.
/// Nodes that are as in `nearby` (may be null) are not run again, if it stands on the same ground.
/// errors  none but those of a derivation that skips what is unfit: a record of a state has one;
///         those of WithRoots, where an asset is gone or time is short.
/// Property: (1) Restore(RecordOf(s)) is s in everything but `steps`.
Result<SessionState> Restore(const SessionRecord& record, const SessionOptions& options,
                             const Model* nearby = nullptr);

}  // namespace parti::app
