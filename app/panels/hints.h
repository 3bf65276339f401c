// What to do next, in one line: it changes with the state of the session.
// Failures and their remedies are the session's own words.
#pragma once

#include <string>

#include "app/panels/panel_view.h"

namespace parti::app::panels {

/// Never empty. Never fails: without a session it is the first start's.
std::string HintOf(const PanelView& view);

}  // namespace parti::app::panels
