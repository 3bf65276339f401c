// scatter as CGA writes it, with what stands on its points in braces. Only turns what is written
// around; where the points are is operations/scatter.cc's.
#pragma once

#include <optional>
#include <vector>

#include "grammar/rules/rule_syntax.h"

namespace parti::grammar {

/// The seed of a scatter that has braces is drawn from 0 to this.
inline constexpr double kScatterSeeds = 999999999;

/// The steps of a body with every scatter that has braces as one in brackets, its seed drawn for
/// each shape anew; nothing where there is none:
///   scatter(surface, 9, uniform) { Tree }
///   [ scatter(surface, 9, uniform, center, '0.5, rand(999999999)) Tree ]
/// Braces that hold a case or a chance are left as they are.
std::optional<std::vector<WrittenStatement>> WithScatterInBrackets(
    const std::vector<WrittenStatement>& steps);

}  // namespace parti::grammar
