// The node taken in hand: what it acts on, its numbers, and the names of what it gives. All of it
// comes from the operation table; a row that is new there has its panel at once.
// Checking what is typed is the session's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"
#include "grammar/selection_action.h"

namespace parti::app::panels {

/// The node in hand; null where none is.
const grammar::SelectionActionNode* NodeInHand(const PanelView& view);

/// The same, null also while the rules are hidden: what nobody sees, nothing is to change.
const grammar::SelectionActionNode* NodeShown(const PanelView& view, const Memory& memory);

/// How high it would like to be, px.
float NodeHeight(Ui* ui, const grammar::SelectionActionNode& node, float width);

/// Draws it into `box`; it scrolls where that is lower.
void DrawNode(Ui* ui, const grammar::SelectionActionNode& node, const Box& box);

}  // namespace parti::app::panels
