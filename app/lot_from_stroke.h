// The first line of a building: a closed outline drawn on the ground becomes the lot (feature A0).
// Sequences its stages: outline (lot_outline.h), squaring (lot_squaring.h), checks.
// Not responsible for lots that are typed or read from files (lot.h).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/session_state.h"
#include "base/error.h"

namespace parti::app {

/// The numbers of reading a lot. Lengths of strokes are fractions of the diagonal of all strokes on
/// the screen; fitted to the outlines among the development strokes, drawn in perspective.
struct LotParameters {
  // Outline.

  /// Ends of one stroke nearer than this meet, [0, 0.5]; whoever lifts the pen there means to be
  /// done. 99 % of the rectangles, triangles and circles close within it, no caret or check does.
  double closing_gap = 0.32;
  /// Ends of different strokes nearer than this meet: the last side may be a short one.
  double meeting_gap = 0.15;
  /// What may be cut off at the ends where they overlap, of the path, [0, 0.3]; an X loses more
  /// before it looks closed.
  double overlap = 0.25;
  /// Pieces at the ends shorter than this share of the longest are hooks, [0, 0.3].
  double hook = 0.14;
  /// Loops shorter than this share of the outline are overshot corners, [0, 0.5]; others make it
  /// one that crosses itself.
  double small_loop = 0.15;
  /// Straight neighbours that turn by less than this are one side [degrees], [0, 45].
  double joint_deg = 24;
  /// The ground must be seen from at least this far above, along every line of sight [degrees].
  double least_angle_deg = 2;

  // Squaring.

  /// Sides within this of the outline's main directions follow them [degrees], [0, 30].
  double square_deg = 20;
  /// The same for triangles: right angles in them are rarer [degrees].
  double square_triangle_deg = 7;
  /// Main directions within this of north and east follow those; others go to a multiple of
  /// angle_step_deg [degrees].
  double north_deg = 12;
  double angle_step_deg = 5;
  /// Sides of a rectangle or triangle within this share of each other are equal, [0, 0.3].
  double equal_share = 0.12;
  /// Lengths are rounded to the coarsest of 5, 2, 1, 0.5 … m that is at most this share of the
  /// shortest side, [0, 0.2]: what perspective leaves of a hand's precision.
  double rounding_share = 0.06;
  /// Curved outlines whose distance from their centre scatters by less than this share of it are
  /// circles, [0, 0.2].
  double circle_share = 0.10;
  /// A curve has a corner for each such turn [degrees], and a circle this many corners.
  double facet_deg = 15;
  int circle_corners = 32;
  /// Most corners, [8, 512].
  int most_corners = 96;

  // Checks.

  double smallest_m = 1;    ///< narrower outlines are refused
  double largest_m = 2000;  ///< wider ones are: they run towards the horizon
  double smallest_px = 24;  ///< smaller ones on the screen are taps and ticks
  /// What is drawn lies this near to its outline, of the outline's diagonal, [0, 0.5]: an X has
  /// arms.
  double farthest_off = 0.13;
  double thinnest = 0.04;  ///< area by squared extent: scribbles to and fro have less
};

/// The lot that strokes on the ground outline, as ParseLots reads it: "poly(x,z x,z …)". Near-right
/// angles are right, near-equal sides equal, lengths rounded to what a hand can mean; circles are
/// regular polygons, other curves have a corner every few degrees. It begins with its south side.
///
/// strokes  all strokes of the sketch, each in its own view: one closed line, or several that meet.
/// errors   kTooShort, kBadNumber, kGrazingView as ClosedOutline;  kNoFit  it is not closed yet;
///          kSelfIntersecting  it crosses itself;  kDegenerateGeometry  smaller, larger or thinner
///          than a lot can be, or too unlike what was drawn. Each hint says what to do.
/// Properties: (1) the direction and the place where a stroke begins don't matter, up to what
/// segmentation sees; (2) the result is a lot that ParseLots takes.
Result<std::string> LotFromStrokes(std::span<const std::shared_ptr<const DrawnStroke>> strokes,
                                   const LotParameters& parameters = {});

}  // namespace parti::app
