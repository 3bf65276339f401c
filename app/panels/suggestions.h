// Suggestions beside the pen: a card for each operation that the sketch may mean.
// Which there are, and in what order, is sketch/'s.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Draws the cards, clear of the stroke and the hand. Returns the suggestion that the pointer or
/// the keyboard is on.
std::optional<size_t> DrawSuggestions(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
