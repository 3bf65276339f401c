#include "app/session_snapshot.h"

namespace parti::app {
namespace {

bool IsView(const SessionRequest& request) {
  const auto* command = std::get_if<Command>(&request);
  return command != nullptr && std::holds_alternative<SetView>(*command);
}

}  // namespace

bool IsMoot(const SessionRequest& request, const SessionRequest& next) {
  return IsView(request) && IsView(next);
}

}  // namespace parti::app
