#include "app/trial.h"

#include <utility>

#include "app/session_commands.h"

namespace parti::app {

std::shared_ptr<const SessionState> TriedOut(const Trial& trial) {
  auto tried = After(*trial.state, trial.number, {});
  return tried ? std::make_shared<const SessionState>(std::move(*tried)) : trial.state;
}

bool Trials::Set(const std::optional<SetNumber>& number,
                 const std::shared_ptr<const SessionState>& on) {
  if (number == number_) return false;
  number_ = number;
  if (number_) worker_.Ask({on, *number_});
  return true;
}

std::shared_ptr<const SessionState> Trials::TakeNewest() {
  if (!worker_.ready().Clear() || !number_) return nullptr;
  return worker_.newest().value_or(nullptr);
}

}  // namespace parti::app
