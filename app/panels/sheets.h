// The sheets that open under the buttons of the head: document, views, export, settings.
// They ask; files, views and settings are the application's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Draws the one that is open, if any.
void DrawOpenSheet(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
