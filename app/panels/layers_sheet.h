// The layers of the face in hand, or of all rules: each is switched on and off, moved up and down,
// and given a rule. Which layers there are is layer_rows.h's.
#pragma once

#include "app/panels/memory.h"
#include "app/panels/ui.h"

namespace parti::app::panels {

/// Whether the building's rules have layers at all.
bool HasLayers(const Ui& ui, Memory* memory);

/// Of all rows in a list of this width, px.
float LayersHeight(Ui* ui, Memory* memory, float width);

/// Draws them into a list.
void DrawLayers(Ui* ui, Memory* memory, const Box& list);

}  // namespace parti::app::panels
