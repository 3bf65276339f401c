// What is seen of overlapping rectangles, computed without the engine: the measure for its answers.
#pragma once

#include <vector>

#include "tests/facades/annotated_facade.h"

namespace parti::tests {

/// For each element, its area [m^2] inside a wall that nothing covers: elements of later layers lie
/// over those of earlier ones, and within a layer what comes later in the file lies over what comes
/// before.
std::vector<double> VisibleAreas(const AnnotatedFacade& facade, const grammar::Box2& wall);

}  // namespace parti::tests
