// From a sketch on one item to the operations that may be meant, best first (Jesus 2018, 6.4-6.6).
// The stages have a file each; docs/inference.md tells their story. Inserting the chosen operation
// into a tree is the app's.
#pragma once

#include <vector>

#include "base/camera.h"
#include "base/error.h"
#include "base/stroke.h"
#include "grammar/action.h"
#include "grammar/item.h"
#include "sketch/configuration.h"
#include "sketch/parameters.h"
#include "sketch/stroke_reading.h"

namespace parti::sketch {

/// An operation that may be meant.
struct Suggestion {
  grammar::Action action;    ///< symbols filled in with defaults that a person may change
  double error = 0;          ///< distance of drawn and projected line ends, per end [px], rms
  double score = 0;          ///< log evidence [nat]: what the list is ordered by, larger first
  bool by_heuristic = true;  ///< false: found by sampling
  double worst_line = 0;     ///< what the line that it explains worst costs [nat]
};

/// Segments a stroke and lifts its lines: for each, the best of the candidate lines that the
/// operations of the table make of `item` (Listing 6.1, 6.10-6.13).
/// errors  kTooShort  a tap;  kNoFit  no candidate near any of its lines;  kBadNumber  a sample or
///         the camera;  kBehindEye  the item can't be seen.
Result<std::vector<WorldLine>> LiftStroke(const Stroke& stroke, const grammar::Item& item,
                                          const Camera& camera,
                                          const SketchParameters& parameters = {});

/// Operations that may be meant by a configuration, best first: the heuristics' (6.5), adjusted by
/// descent (6.6); sampled ones for operations without a heuristic, and for all where no heuristic
/// fits. An operation comes more than once only where its words differ (axis, selectors).
/// errors  kNoFit  nothing in the table makes lines near these;  kTooShort  no line at all.
Result<std::vector<Suggestion>> Suggest(const Configuration& configuration,
                                        const grammar::Item& item,
                                        const SketchParameters& parameters = {});

/// Both of the above for a whole sketch in one view: what `parti suggest` answers. Strokes in which
/// no line is found (taps, scribbles) are passed over as long as one has a line.
/// errors  those of LiftStroke and Suggest.
Result<std::vector<Suggestion>> SuggestFromStrokes(const std::vector<Stroke>& strokes,
                                                   const grammar::Item& item, const Camera& camera,
                                                   const SketchParameters& parameters = {});

/// Parameters for a second reading, where whole edges leave a line unexplained: lines on the item
/// may be parts of edges, and lines may be left over for a later operation. At a price, so that
/// what whole edges explain is read as before.
SketchParameters Generous(SketchParameters parameters);

/// What a sketch in one view reads as on one item.
struct SketchReading {
  Configuration configuration;          ///< the lines that could be lifted
  int lost_lines = 0;                   ///< drawn lines near which nothing can be made
  double lost_px = 0;                   ///< their length
  double worth = 0;                     ///< log evidence of the best against no meaning [nat]
  std::vector<Suggestion> suggestions;  ///< n >= 1, best first
};

/// Whether the best suggestion explains every line but for hooks and other slips of the pen.
bool ExplainsAll(const SketchReading& reading, const PartParameters& parameters = {});

/// As SuggestFromStrokes, for strokes that ReadStrokes has read, with all that is known, and
/// with these parameters only: for choosing between items.
/// errors  those of LiftStroke and Suggest;  kLimitReached  more than most_strokes strokes.
Result<SketchReading> ReadSketch(const std::vector<std::vector<StrokeReading>>& strokes,
                                 const grammar::Item& item, const Camera& camera,
                                 const SketchParameters& parameters = {});

/// The configuration with every line moved onto the edge of `action` that it stands for, so that
/// all of them agree: what to show once a suggestion is preferred. Lines that no edge is near keep
/// their place.
Configuration Settled(const Configuration& configuration, const grammar::Item& item,
                      const grammar::Action& action);

}  // namespace parti::sketch
