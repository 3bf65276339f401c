// What the strokes of a session's sketch mean on its model: sequences sketch's stages for one
// state. Not responsible for when a sketch is read, or for what becomes of it (session_commands.h).
#pragma once

#include "app/session_options.h"
#include "app/session_state.h"

namespace parti::app {

/// The sketch of `state`, read again: its strokes in the view of the last one, on the shapes that
/// its query selects, or on all that are visible. Lines drawn in several views belong to the shape
/// that the first view's were drawn on. No strokes give a sketch that means nothing.
/// errors  those of sketch::RankTargets, sketch::LiftStroke and sketch::Suggest;  kNothingMade  no
///         lot, or nothing visible to draw on.
Result<Sketch> ReadSketch(const SessionState& state, const SessionOptions& options);

/// The state with its sketch read anew as one about `query`; nothing: about what it is drawn on.
/// Strokes that mean nothing there stay, for the lines to come.
SessionState WithSketchAbout(SessionState state, std::optional<grammar::Query> query,
                             const SessionOptions& options);

/// The visible shapes that a sketch with this query may be drawn on.
std::vector<ShapeRef> TargetsOf(const Model& model, const std::optional<grammar::Query>& query);

}  // namespace parti::app
