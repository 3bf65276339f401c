// The rules as text, those of files and those drawn: lines that are typed over where they are
// tapped, with what is wrong in place. Which lines there are is file_text.h's and rules_text.h's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Of all lines in a list of this width, px.
float RulesTextHeight(Ui* ui, Memory* memory, float width);

/// Draws them into a list.
void DrawRulesText(Ui* ui, Memory* memory, const Box& list);

}  // namespace parti::app::panels
