// Every number of the sketch pipeline, one struct per stage: meaning, range, unit, default, origin.
// "dev strokes" are the tasks that SketchBench makes of unistrokes-dev with seeds 2 to 9.
#pragma once

#include <array>

#include "sketch/segmentation.h"

namespace parti::sketch {

/// How far the ends of a line drawn by hand lie from where they were meant: a normal deviation in x
/// and in y of floor_px + relative * length. Origin: the scatter that SketchBench gives its lines.
struct PenNoise {
  double floor_px = 2.0;
  double relative = 0.006;

  double Deviation_px(double length_px) const { return floor_px + relative * length_px; }
};

/// Which parts of a stroke are lines, and in how many ways it may be read.
struct LineParameters {
  /// A part that bows further from its chord than this share of it is a curve; a half circle bows
  /// by 0.5.
  double greatest_bow = 0.3;
  /// The whole stroke may be one line up to this bow. Origin: dev strokes, where hooks at the ends
  /// of straight strokes make 0.2 and more.
  double greatest_bow_of_line = 0.45;
  /// Neighbours are one line where their joint bow is below this. Origin: dev strokes.
  double joint_bow = 0.05;
  /// A part shorter than this share of its stroke's longest is a hook of the pen.
  double hook = 0.07;
  /// A stroke is closed, and its last corner its first, when its ends are nearer to each other than
  /// this share of the shorter of the parts that meet there.
  double closing_gap = 0.35;
  /// Taking the whole stroke as one line costs this for each share that it bows [nat].
  double bow_price = 20;
  /// Tolerances of the polygons, in diagonals of the stroke. Origin: Douglas and Peucker's method
  /// finds most corners of real strokes at 0.07 to 0.12 (segmentation benchmark).
  std::array<double, 2> polygon_tolerances = {0.11, 0.07};
  double polygon_price = 4;     ///< of such a polygon against the segmentation [nat]
  int most_polygon_lines = 12;  ///< more lines than that are a scribble
};

/// Lines that are only a part of an edge, and lines that an operation leaves to a later one.
/// Allowed where whole edges leave a line unexplained (suggestion.h, Generous).
struct PartParameters {
  bool allowed = false;
  /// Price of an end that lies along an edge and not at its end [nat]: the log of the number of
  /// places, a few deviations long, where it could lie on an edge of some hundred pixels.
  double free_end = 4;
  /// Price of a line that the operation leaves over [nat]: as TargetParameters::lost_line.
  double left_over = 20;
  /// A line that the best suggestion explains worse than this is not explained [nat]: both its ends
  /// six deviations off.
  double unexplained = 14;
  /// Lost lines shorter than this share of those that were found are slips of the pen.
  double slip = 0.2;
  /// By how much a reading with parts must be worth more than one without [nat]: more than one line
  /// is worth (LiftParameters::line_worth), so that careless lines are read as whole edges.
  double least_gain = 12;
};

/// Sampling the operation table (6.10, 6.11, errata 17, 17a).
struct CandidateParameters {
  /// Consecutive samples of an operation lie about this far apart on the screen. The thesis takes
  /// 10; lifting interpolates between samples, so twice as many lines would tell nothing more.
  double spacing_px = 16;
  /// Lengths reach to this many times sigma of (6.10), which is half the picture's height at the
  /// item's distance: a line may cross the whole picture.
  double reach = 2;
  /// Never more lengths than these, for items that come close to the eye, and none shorter than
  /// this share of the item's diagonal, which would repeat it finer than anyone draws.
  int most_lengths = 96;
  double finest = 0.005;
  /// Rarer operations are sampled too, and which edges lie on the item is found out: those may be
  /// drawn in part.
  bool generous = false;
  int most_rarer_lengths = 24;  ///< their edges move evenly with the length, and cost more
};

/// From a drawn line to lines in the world (6.12, 6.13).
struct LiftParameters {
  /// r of (6.12), where the fitness of an end is 1/e, in px and in shares of the drawn length.
  /// Origin: five deviations of PenNoise (errata 20), so that no true line is lost.
  double radius_px = 10;
  double radius_relative = 0.03;
  /// Candidates fitting worse than this are none: both ends two radii off.
  double least_fitness = 3e-4;
  /// What a line near a candidate is worth against no line at all [nat]: the log of how unlikely
  /// two random points are to come as near as a pen to one of some hundred candidates.
  double line_worth = 12;
  /// Strokes of which a second reading is worth nearly as much are tried with both [nat], and
  double near_reading = 12;
  int most_sketch_readings = 5;  ///< at most this many readings of the whole sketch are judged.
  /// Readings kept for each operation: the same line may be a riser or a parallel, at either depth.
  int most_per_operation = 6;
};

/// The heuristics' thresholds (6.5). All are relative; the line errors of descent decide the rest.
struct HeuristicParameters {
  double angle_deg = 10;           ///< parallel and orthogonal mean: up to this far off
  double near_relative = 0.08;     ///< "at a vertex": within this share of the item's diagonal
  double plane_relative = 0.02;    ///< lines this near along the axis are one split plane
  double equal_relative = 0.05;    ///< sizes this alike may be meant equal; of the whole (6.5.3)
  double repeat_deviation = 0.35;  ///< deviation / mean of sizes that may be a repeat (errata 21)
  bool partly = false;             ///< lines that say nothing about the operation are left over
  int most_starts = 4;             ///< values tried where readings of the lines disagree
  // Prices of rarer meanings, in nats (Hypothesis::price).
  double inward_extrude = 2;   ///< an extrusion into the item
  double outward_offset = 2;   ///< an offset out of the item
  double tie = 1;              ///< each size that is kept equal to another
  double repeat_is_meant = 2;  ///< a split into three equal parts and more
  double repeat_of_two = 6;    ///< a repeat shown by a single line
  double roof = 12;            ///< a roof at once: as much as one line is worth, so one says none
  double wings = 6;            ///< a shape in L, U or O
  double alike_faces = 0.1;    ///< comp with all faces alike against side and top
};

/// Gradient descent (6.6.2, errata 18).
struct DescentParameters {
  int most_iterations = 12;
  int most_halvings = 6;          ///< of a step that does not pay
  double negligible = 1e-3;       ///< relative improvement below which descent stops
  double step_relative = 1e-3;    ///< delta of (6.17), of the item's diagonal or the dial's range
  double outlier_deviations = 3;  ///< ends further off than this pull less and less (Cauchy's loss)
};

/// Weighing operations against each other (docs/inference.md, Ranking). In nats.
struct RankingParameters {
  double sampled = 3;            ///< price of being found by sampling where heuristics have a say
  double equal_spacing = 0.007;  ///< equal parts are drawn equal to this share of the whole
  /// Lines that fit the item's own edges as well as this trace them, and mean nothing new.
  double tracing = 4;
  /// Another value of the same operation is offered too when it differs by this share of the item,
  double distinct_relative = 0.1;
  double distinct_nats = 25;  ///< and its evidence by no more than this.
  /// Numbers are rounded while that costs no more evidence than this each, and never by more than
  /// this share of themselves (readable.h). A tenth of a nat is 0.45 deviations.
  double readable_loss = 0.1;
  double readable_share = 0.02;
  double hopeless_px = 60;         ///< a mean distance beyond which nothing is suggested, and
  double hopeless_relative = 0.3;  ///< the same in shares of the mean drawn length
};

/// All of them; the default is what the program uses.
struct SketchParameters {
  SegmentationParameters segmentation;
  PenNoise noise;
  LineParameters lines;
  CandidateParameters candidates;
  PartParameters parts;
  LiftParameters lift;
  HeuristicParameters heuristics;
  DescentParameters descent;
  RankingParameters ranking;
  int most_suggestions = 8;
  int most_strokes = 64;  ///< in one sketch; bounds time
};

}  // namespace parti::sketch
