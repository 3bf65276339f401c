// What becomes of a planar shape's layers and 2D shapes: all of them derived, normalised, and what
// waited for that set going (Jesus 2018, 4.4, Listing 4.9; errata 1, 9a).
// Which pieces the normalisation leaves is layers/normalise.h's.
#pragma once

#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_runner.h"

namespace parti::grammar {

/// Runs a task, and where it makes a scene, that scene to its end; the tasks that come of it, all
/// of shapes that are visible, are added to *next. errors  those of RuleRunner::Run;  those of the
/// normalisation, naming the planar shape.
Result<void> RunWithScene(RuleTask task, RuleRunner* runner, std::vector<RuleTask>* next);

}  // namespace parti::grammar
