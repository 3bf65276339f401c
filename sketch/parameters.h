// Every number of the sketch pipeline, one struct per stage: meaning, range, unit, default, origin.
// "dev strokes" are the tasks that SketchBench makes of unistrokes-dev with seeds 2 to 9.
#pragma once

#include "sketch/segmentation.h"

namespace parti::sketch {

/// How far the ends of a line drawn by hand lie from where they were meant: a normal deviation in x
/// and in y of floor_px + relative * length. Origin: the scatter that SketchBench gives its lines.
struct PenNoise {
  double floor_px = 2.0;
  double relative = 0.006;

  double Deviation_px(double length_px) const { return floor_px + relative * length_px; }
};

/// Which parts of a segmented stroke are lines.
struct LineParameters {
  /// A segment that bows further from its chord than this share of it is a curve. Origin: a human
  /// line bows by up to 0.1, a half circle by 0.5.
  double greatest_bow = 0.25;
  /// Neighbours are one line where their joint bow is below this. Origin: dev strokes.
  double joint_bow = 0.05;
  /// A segment shorter than this share of its stroke's longest is a hook of the pen.
  double hook = 0.07;
  /// A stroke is closed, and its last corner its first, when its ends are nearer to each other than
  /// this share of the shorter of the segments that meet there.
  double closing_gap = 0.35;
};

/// Sampling the operation table (6.10, 6.11, errata 17, 17a).
struct CandidateParameters {
  /// Consecutive samples of an operation lie about this far apart on the screen. The thesis takes
  /// 10; lifting interpolates between samples, so twice as many lines would tell nothing more.
  double spacing_px = 16;
  /// Lengths reach to this many times sigma of (6.10), which is half the picture's height at the
  /// item's distance: a line may cross the whole picture.
  double reach = 2;
  /// Never more lengths than these, for items that come close to the eye.
  int most_lengths = 96;
};

/// From a drawn line to lines in the world (6.12, 6.13).
struct LiftParameters {
  /// r of (6.12), where the fitness of an end is 1/e, in px and in shares of the drawn length.
  /// Origin: five deviations of PenNoise (errata 20), so that no true line is lost.
  double radius_px = 10;
  double radius_relative = 0.03;
  /// Candidates fitting worse than this are none: both ends two radii off.
  double least_fitness = 3e-4;
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
  int most_starts = 3;             ///< values tried where readings of the lines disagree
  // Prices of rarer meanings, in nats (Hypothesis::price).
  double inward_extrude = 2;   ///< an extrusion into the item
  double outward_offset = 2;   ///< an offset out of the item
  double repeat_is_meant = 2;  ///< a split into three equal parts and more
  double repeat_of_two = 3;    ///< a repeat shown by a single line
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
  double sampled = 3;              ///< price of being found by sampling where heuristics have a say
  double equal_spacing = 0.01;     ///< equal parts are drawn equal to this share of the whole
  double hopeless_px = 60;         ///< a mean distance beyond which nothing is suggested, and
  double hopeless_relative = 0.3;  ///< the same in shares of the mean drawn length
};

/// All of them; the default is what the program uses.
struct SketchParameters {
  SegmentationParameters segmentation;
  PenNoise noise;
  LineParameters lines;
  CandidateParameters candidates;
  LiftParameters lift;
  HeuristicParameters heuristics;
  DescentParameters descent;
  RankingParameters ranking;
  int most_suggestions = 8;
};

}  // namespace parti::sketch
