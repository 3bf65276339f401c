// What may be meant by tapped shapes: a card for each query, in plain words, with its count. It is
// for the node in hand, where that is shown, else for the next sketch; the one in force is marked.
// Which queries there are is grammar/generalise.h's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Draws the cards beside the tap. Returns the query that the pointer or the keyboard is on.
std::optional<size_t> DrawQueries(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
