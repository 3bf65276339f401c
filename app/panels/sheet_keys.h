// Keys that open and close sheets. Those that act on the drawing are app/shortcuts.h's; those of
// fields and of the focus are ui.h's.
#pragma once

#include <string_view>
#include <vector>

#include "app/panels/memory.h"
#include "base/event.h"

namespace parti::app::panels {

/// A key as people read it, for docs/application.md.
struct SheetKey {
  std::string_view keys;  ///< "Ctrl+O"
  std::string_view does;  ///< "open a drawing"
};

/// All that PressSheetKey knows.
std::vector<SheetKey> SheetKeys();

/// Whether the key was one of these, and did something. `control`: Ctrl is held.
bool PressSheetKey(const KeyEvent& key, bool control, Memory* memory);

}  // namespace parti::app::panels
