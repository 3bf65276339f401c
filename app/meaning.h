// What a sketch means, as lines in the world: the lines lifted from strokes, and the edges that a
// suggestion would make. For pictures and for the marks of the application alike.
#pragma once

#include <vector>

#include "app/session_state.h"

namespace parti::app {

/// Lines in the world [m].
struct Meaning {
  std::vector<Segment3> lines;  ///< the sketch's, as the suggestion understands them
  std::vector<Segment3> edges;  ///< of what it would make, each once
};

/// What suggestion `number` (from 0) of the state's sketch would make.
/// errors  kUnknownName  there is no such suggestion;  those of grammar::Apply.
Result<Meaning> MeaningOf(const SessionState& state, size_t number);

/// The edges of one visible shape.
std::vector<Segment3> OutlineOf(const Model& model, const ShapeRef& ref);

}  // namespace parti::app
