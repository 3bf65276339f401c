// Suggested numbers as a person would write them: 19 instead of 19.01023337599759. The pen's
// scatter leaves the last digits unknown; what it does say is kept.
#pragma once

#include "grammar/action.h"
#include "sketch/line_match.h"
#include "sketch/made_edges.h"

namespace parti::sketch {

/// Rounds every length of an action to the coarsest of 5, 2, 1, 0.5 … 0.001 m at which the lines
/// still fit nearly as well. Lengths that are equal stay equal; lengths that no line fixes, and
/// shares of a rest (~1), move by readable_share of themselves at most.
/// Properties: (1) the log evidence of the lines falls by at most readable_loss for each number;
/// (2) an action whose edges can't be made comes back as it was.
grammar::Action Readable(const grammar::Action& action, const MadeEdges& made,
                         const SketchedLines& lines, const SketchParameters& parameters);

}  // namespace parti::sketch
