// The demo drawing: task I of Jesus 2018 (appendix D), begun from an empty lot, as a person with
// the synthetic hand of pen_model.h would draw it.
#pragma once

#include "base/error.h"
#include "input/drawing.h"
#include "tests/pen/pen_model.h"

namespace parti::tests {

/// The same bytes for the same seed. assets/drawings/house.pen is WriteDrawing(HouseDrawing(1)).
input::Drawing HouseDrawing(uint64_t seed, const PenModelParameters& parameters = {});

}  // namespace parti::tests
