// Arranging an element that is placed by hand by another one on its face, or by the face (Jesus
// 2018, 8.2.1: same size, align, center), and the command that says so.
// What pulling does is layer_drag.h's.
#pragma once

#include <optional>
#include <vector>

#include "app/command.h"
#include "app/placing/element_in_hand.h"
#include "app/placing/placed_layers.h"

namespace parti::app {

/// What a layer can fall in with: the others in its frame that share no numbers with it, the
/// uppermost first, and last the face, without a name.
std::vector<grammar::InteractiveLayer> LayersBeside(const PlacedLayers& placed, size_t layer);

/// The layer as one of the first kArrangements commands makes it; itself for the others.
grammar::InteractiveLayer Arranged(const grammar::InteractiveLayer& layer, ElementCommand how,
                                   const grammar::InteractiveLayer& by);

/// The command that makes one of the other: the numbers that differ by a millimetre, in whole ones;
/// nothing where none does.
std::optional<PlaceElement> ChangeBetween(const grammar::InteractiveLayer& before,
                                          const grammar::InteractiveLayer& after);

/// Which of the arrangements would change it.
std::array<bool, kArrangements> ChangesOf(const PlacedLayers& placed, size_t layer,
                                          const grammar::InteractiveLayer& by);

}  // namespace parti::app
