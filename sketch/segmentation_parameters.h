// Every number of stroke segmentation, for all of its stages (Jesus 2018, 6.3; errata 16, 20).
// Later stages have theirs in parameters.h.
#pragma once

namespace parti::sketch {

/// Lengths are fractions of the stroke's diagonal and speeds fractions of its median speed, so that
/// a stroke drawn at another scale, or on another device, segments alike. Costs are in nats, as if
/// from log-likelihoods; only their differences matter. "Fitted" numbers minimise the logistic loss
/// of the right answer's margin on the development strokes, rounded; docs/segmentation.md has the
/// figures, those for people left out of the fit, and how little hangs on the numbers.
struct SegmentationParameters {
  // Filter: the stroke as evenly spaced points.

  /// Points per diagonal, [20, 400]. The pixels of a small screen stay visible at 80; 64 to 100 do
  /// equally well.
  double steps_per_diagonal = 80;
  /// Most points of a path, [16, 4096]: long scribbles get wider steps. Bounds time and memory.
  int most_steps = 512;

  // Speed and curvature.

  /// Half widths of the two windows that the turning angle is measured in and averaged over
  /// (diagonals, (0, 0.3]): the near one finds small corners, the far one rounded ones. Chosen:
  /// neighbours (0.04 and 0.08, 0.05 and 0.125) do as well within 4 % of the loss.
  double near_span = 0.05;
  double far_span = 0.10;
  /// Half width of the window of the speed (diagonals, (0, 0.3]). Chosen likewise.
  double speed_span = 0.025;
  /// Bounds of ln(median speed / speed): a rest of the pen is no better evidence than a pen at
  /// exp(-2) = 14 % of its usual speed.
  double least_slowness = -1;
  double most_slowness = 2;
  /// A stroke whose slowest inner point stays under this ln(slowness) says little by its speed: a
  /// program drew it, or the device sent no times. 99 % of the development strokes with corners
  /// exceed it.
  double telling_slowness = 0.84;
  /// What is expected instead: slowness_per_turn * (turn - free_turn), 0 to usual_slowness.
  /// Regression of slowness on turn over all candidates of the development strokes.
  double free_turn = 0.5;          ///< rad
  double slowness_per_turn = 1.3;  ///< 1/rad
  double usual_slowness = 1.5;

  // Candidates for corners.

  /// A candidate is the best point within this distance on either side (diagonals, (0, 0.2]).
  double candidate_span = 0.025;
  /// Least turning angle in the near window (rad, [0, 1]): about what pixels alone do to a line.
  double least_turn = 0.12;
  /// No corner is nearer to an end than this (diagonals, [0, 0.3]): what turns there is the hook
  /// that a pen leaves where it is put down or lifted. Chosen; 0.05 to 0.13 do equally well.
  double hook_length = 0.12;
  /// Most candidates, [2, 256], the best ones; the search takes the square of it.
  int most_candidates = 48;

  // Costs of a segmentation (nats).

  /// A corner costs corner_price - turn_weight * angle [rad] - slowness_weight * ln(slowness).
  double corner_price = 6.0;     ///< fitted
  double turn_weight = 1.7;      ///< per radian; fitted
  double slowness_weight = 4.0;  ///< fitted
  /// A line costs bow_weight * ln(1 + (bow / usual_bow)^2), where bow is the root mean square of
  /// the orthogonal distances (6.9) in diagonals: squared like a Gaussian's while small, forgiving
  /// like a Student's when large.
  double bow_weight = 4.7;   ///< fitted
  double usual_bow = 0.031;  ///< diagonals; fitted
  /// A curve costs this much if it is the stroke's first, and further_curve_price if not: who draws
  /// one part round draws others round.
  double curve_price = 6.4;  ///< fitted
  /// Chosen: in a stroke with curves a part of less than 1.6 % bow still counts as a line.
  double further_curve_price = 1;
  /// A segment shorter than short_length costs short_weight * ln(short_length / length) more: it
  /// is more often a hook or a tremor than meant.
  double short_weight = 6.5;   ///< fitted
  double short_length = 0.25;  ///< diagonals; chosen
};

}  // namespace parti::sketch
