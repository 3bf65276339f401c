// What an element placed by hand is taken by, and what pulling there does to its four numbers
// (Jesus 2018, 8.2.1, made of the drag and resize of interactive_layer.h).
// Where handles are on a screen is app/placing's; snapping to other elements is layer_snap.h's.
#pragma once

#include "grammar/layers/interactive_layer.h"

namespace parti::grammar {

/// A place on the rectangle of an element: -1 is its left or lower edge, 1 its right or upper one;
/// both together are a corner, and 0, 0 is the whole of it.
struct LayerHandle {
  int across = 0;
  int up = 0;
  bool operator==(const LayerHandle&) const = default;
  bool whole() const { return across == 0 && up == 0; }
};

/// Pulled by so much: the whole is dragged, an edge or a corner follows the pull while those
/// opposite stay. Borders and the least size stop it as they stop Drag and Resize.
/// Properties: (1) edges that the handle does not hold stay, to the last bits of a sum; (2) pulled
/// by nothing, a layer that is not smaller than the least size stays as it is.
InteractiveLayer Pulled(const InteractiveLayer& layer, LayerHandle handle, double up_m,
                        double right_m);

}  // namespace parti::grammar
