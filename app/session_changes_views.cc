// Cameras, and those that are kept by name.
#include <fmt/format.h>

#include "app/edit_nodes.h"
#include "app/session_changes.h"

namespace parti::app {
namespace {

/// errors  kUnknownName  with the names that there are.
Result<size_t> FindView(const std::vector<NamedView>& views, const std::string& name) {
  std::vector<std::string> names;
  for (size_t i = 0; i < views.size(); ++i) {
    if (views[i].name == name) return i;
    names.push_back(views[i].name);
  }
  const auto meant = DidYouMean(name, names);
  return Fail(ErrorCode::kUnknownName, fmt::format("there is no view '{}'", name),
              meant           ? fmt::format("did you mean '{}'?", *meant)
              : names.empty() ? "keep one first: keep-view street"
                              : fmt::format("views are {}", fmt::join(names, ", ")));
}

}  // namespace

Result<SessionState> Do(const SetView& command, SessionState state, const SessionOptions&) {
  state.camera = command.camera;
  return state;
}

Result<SessionState> Do(const KeepView& command, SessionState state, const SessionOptions&) {
  if (const auto fit = CheckName(command.name); !fit) return Fail(fit);
  if (const auto at = FindView(state.views, command.name)) {
    state.views[*at].camera = state.camera;
  } else {
    state.views.push_back({command.name, state.camera});
  }
  return state;
}

Result<SessionState> Do(const GoView& command, SessionState state, const SessionOptions&) {
  const auto at = FindView(state.views, command.name);
  if (!at) return Fail(at);
  const double width_px = state.camera.width_px, height_px = state.camera.height_px;
  state.camera = state.views[*at].camera;
  state.camera.width_px = width_px;
  state.camera.height_px = height_px;
  return state;
}

Result<SessionState> Do(const DropView& command, SessionState state, const SessionOptions&) {
  const auto at = FindView(state.views, command.name);
  if (!at) return Fail(at);
  state.views.erase(state.views.begin() + static_cast<ptrdiff_t>(*at));
  return state;
}

}  // namespace parti::app
