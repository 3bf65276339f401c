// The bar beside an element that is placed by hand: how large it is and where, and buttons that
// give it the size of another or put it in line with that. What they do is
// placing/layer_arranging.h's.
#pragma once

#include <vector>

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Elements with handles, and the handles themselves: where cards should not lie.
std::vector<Box> HandlesOf(const Ui& ui);

/// Draws it beside the element in hand, if there is one; after the queries, which it leaves clear.
void DrawElementBar(Ui* ui, Memory* memory);

}  // namespace parti::app::panels
