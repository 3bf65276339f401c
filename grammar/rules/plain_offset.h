// offset and innerRect as CGA writes them, without braces: which part of the shape the steps after
// them go on with.
// Only turns what is written around; what they make is operations/offset.cc's and
// operations/inner_rectangle.cc's.
#pragma once

#include <optional>
#include <vector>

#include "grammar/rules/rule_syntax.h"

namespace parti::grammar {

/// The steps of a body with offsets that have no braces given those that mean the same; nothing
/// where there are none. What follows it, up to the end of its brackets, goes into them:
///   offset(-1, inside) extrude(3) A               offset(-1) { inside: extrude(3) A }
///   offset(-1) A                                  offset(-1) { inside: A | border: A }
///   innerRect A                                   innerRectangle(scope) { shape: A }
///   offset(-1) comp(f) { inside: A | border: B }  offset(-1) { inside: A | border: B }
/// Where the outline vanishes nothing is left of the inside; CityEngine keeps the shape then.
std::optional<std::vector<WrittenStatement>> WithBracedOffsets(
    const std::vector<WrittenStatement>& steps);

}  // namespace parti::grammar
