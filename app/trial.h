// What a number that is being dragged would come to: derived beside the pen, shown, and forgotten.
// The number that counts is set by a command when it is let go (panel_output.h).
#pragma once

#include <memory>
#include <optional>

#include "app/command.h"
#include "app/latest_worker.h"
#include "app/session_state.h"

namespace parti::app {

/// A number for the node in hand of a state.
struct Trial {
  std::shared_ptr<const SessionState> state;
  SetNumber number;
};

/// The state with it; the state itself where it can't be.
std::shared_ptr<const SessionState> TriedOut(const Trial& trial);

/// Used by the thread that draws; owns one that derives.
class Trials {
 public:
  /// Whether the number tried (or that none is) is another one now.
  bool Set(const std::optional<SetNumber>& number, const std::shared_ptr<const SessionState>& on);

  bool going_on() const { return number_.has_value(); }
  /// A state that has been derived since last asked; null for none, and when nothing is tried.
  std::shared_ptr<const SessionState> TakeNewest();
  bool busy() const { return worker_.busy(); }
  const WakeFd& ready() const { return worker_.ready(); }  ///< woken by each state

 private:
  std::optional<SetNumber> number_;
  LatestWorker<Trial, std::shared_ptr<const SessionState>> worker_{TriedOut};
};

}  // namespace parti::app
