// Lengths as architects type them: "3.5", "350 cm", "12ft 6in", "12'6\"".
// What a number is for, and what it may be, is the dial's that it is typed for.
#pragma once

#include <string_view>

#include "base/error.h"

namespace parti::app {

/// A number of metres, or of the unit after it: m, cm, mm, ft or ', in or "; feet and inches may
/// follow each other. A comma may stand for the decimal point. Blanks between are free.
/// returns  m; of numbers that are not lengths, the number itself.
/// errors   kBadNumber  not a number, not finite, or a unit that is none of these.
Result<double> ParseLength(std::string_view text);

}  // namespace parti::app
