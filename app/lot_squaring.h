// Outlines as an architect means them: right angles, equal sides, circles, round numbers.
// Not responsible for finding the outline in strokes (lot_outline.h).
#pragma once

#include <vector>

#include "app/lot_outline.h"

namespace parti::app {

/// The corners of a lot: x and z of the world, m, to the millimetre. Not checked: the outline may
/// cross itself or have no area.
/// pieces   n >= 1, a closed chain.
std::vector<Vec2> SquaredOutline(const std::vector<OutlinePiece>& pieces,
                                 const LotParameters& parameters);

}  // namespace parti::app
