#include "app/session_commands.h"

#include "app/session_changes.h"
#include "base/check.h"

namespace parti::app {
namespace {

template <typename UndoOrRedo>
Result<SessionState> Do(const UndoOrRedo&, const SessionState& state, const SessionOptions&) {
  static_assert(std::is_same_v<UndoOrRedo, Undo> || std::is_same_v<UndoOrRedo, Redo>);
  CHECK(false, "undo and redo are the session's");
  return state;
}

}  // namespace

Result<SessionState> After(const SessionState& state, const Command& command,
                           const SessionOptions& options) {
  return std::visit([&](const auto& c) { return Do(c, state, options); }, command);
}

}  // namespace parti::app
