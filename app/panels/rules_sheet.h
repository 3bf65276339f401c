// The selection-action tree: one row for each node, what it selects and what it does; or, when that
// is asked for, the text of all rules (text_sheet.h) or their layers (layers_sheet.h). Which rows
// there are, and where they may be dropped, is tree_rows.h's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// How high it would like to be, px.
float RulesHeight(Ui* ui, Memory* memory, float width);

/// Draws it into `box`; it scrolls where that is lower.
void DrawRules(Ui* ui, Memory* memory, const Box& box);

}  // namespace parti::app::panels
