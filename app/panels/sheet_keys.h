// Keys that open and close sheets. Those that act on the drawing are app/shortcuts.h's; those of
// fields and of the focus are ui.h's.
#pragma once

#include "app/panels/memory.h"
#include "base/event.h"

namespace parti::app::panels {

/// Ctrl+O opens, Ctrl+S saves as, Ctrl+E exports, R shows the rules, Escape closes. Whether the key
/// was one of these, and did something.
bool PressSheetKey(const KeyEvent& key, bool control, Memory* memory);

}  // namespace parti::app::panels
