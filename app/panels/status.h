// The line at the foot of the window: what to do next, how the document is doing, what went wrong.
// The words of failures and remedies are those of the errors themselves.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// How high it has to be in a window of this width, px.
float StatusHeight(Ui* ui, const Memory& memory, float width);

/// Draws it into memory->layout.bottom.
void DrawStatus(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
