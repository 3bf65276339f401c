// The column of tools: what the pen does, ways to look, undo and redo.
// Every gesture has its button here; what the gestures do is the application's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

inline constexpr int kToolCount = 10;
inline constexpr int kMenuCount = 4;

/// Draws them where memory.layout says.
void DrawTools(Ui* ui, const Memory& memory);

/// The document's name, and the buttons that open the other sheets.
void DrawHead(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
