// How elements that are placed by hand look over the picture: their rectangles with handles, and
// the lines that one which is dragged has in common with others.
// Which there are and what is dragged is layer_drag.h's.
#pragma once

#include <optional>
#include <vector>

#include "app/overlay.h"
#include "app/placing/layer_drag.h"

namespace parti::app {

/// Which of the layers stand out.
struct LayersMeant {
  std::optional<LayerGrip> grip = {};                ///< what a pen would take hold of, or holds
  std::optional<size_t> held = {};                   ///< the layer in hand
  std::optional<grammar::InteractiveLayer> by = {};  ///< what that is arranged by
};

/// Adds the layers of a face as they are.
void AddLayerMarks(const PlacedLayers& placed, const LayersMeant& meant, const View& view,
                   std::vector<render::Mark>* marks, const DrawingStyle& style = {});

/// The same while one is dragged: where they would be, and what it snapped to.
void AddLayerMarks(const LayerDrag& drag, const View& view, std::vector<render::Mark>* marks,
                   const DrawingStyle& style = {});

}  // namespace parti::app
