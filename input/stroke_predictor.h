// Where the pen will be when the picture is seen: ink ahead of the last report, for a moment.
// Predicted ink is drawn and forgotten; strokes hold what the pen did. Figures: docs/input.md.
#pragma once

#include <array>
#include <optional>

#include "base/math.h"

namespace parti::input {

/// The numbers of prediction, fitted by descent to the mean error 8 and 16 ms ahead, over that of
/// no prediction, on half of the recorded people and drawings, and judged on the others.
struct StrokePredictorParams {
  /// How fast samples lose weight with age, s, [0.005, 0.1].
  double recency_s = 0.016;
  /// Curb on the acceleration, in samples' weights, [0.01, 10]: more makes it a straight line.
  double curb = 0.3;
  /// The part of the predicted way that is taken while nothing is known of the hand, [0, 1].
  double gain = 0.7;
  /// How fast what is known of the hand is forgotten, s, [0.01, 1].
  double memory_s = 0.06;
  /// How far (squared) the pen must go until its own gain counts as much as `gain`, mm2, [0.1,
  /// 100].
  double doubt_mm2 = 9;
  /// A pen that reports nothing for so long has rested: what it did before says nothing, s.
  double pause_s = 0.1;
};

/// Value-typed; one stroke at a time. A parabola through the last sample, fitted to those before
/// it with weights that fall with age; how far along it to go is corrected by how well it foretold
/// each sample that has come since (a regression of the way gone on the way foretold). Where the
/// parabola would turn back against the last step, the pen is predicted to stay. The window is
/// fixed: nothing is allocated, and a sample costs under a microsecond.
/// Properties  (1) moving or turning the stroke moves or turns the prediction;
///             (2) predictions are finite, and for the time of the last sample they are that
///                 sample;
///             (3) a pen that stands still, or has just come down, is predicted to stay.
class StrokePredictor {
 public:
  explicit StrokePredictor(const StrokePredictorParams& params = {}) : params_(params) {}

  /// A new stroke begins: everything is forgotten.
  void Begin();

  /// The next sample. Times that do not increase replace the last position; numbers that are not
  /// finite are skipped.
  void Add(const Vec2& position_mm, double t_s);

  /// Where the pen will be so long after its last sample; at most kFarthest_s is predicted.
  /// Nothing before the first sample.
  std::optional<Vec2> Predict(double ahead_s) const;

  static constexpr double kFarthest_s = 0.032;

 private:
  struct Sample {
    Vec2 position_mm{0, 0};
    double t_s = 0;
  };
  static constexpr size_t kWindow = 32;

  void Correct(const Sample& sample);
  void Fit();
  Vec2 WayAhead_mm(double ahead_s) const;
  const Sample& Back(size_t age) const { return samples_[(newest_ + kWindow - age) % kWindow]; }

  StrokePredictorParams params_;
  std::array<Sample, kWindow> samples_;  // a ring
  size_t newest_ = 0;
  size_t count_ = 0;
  Vec2 velocity_{0, 0};                       // of the fit, mm/s
  Vec2 bend_{0, 0};                           // half its acceleration, mm/s2
  double agreed_mm2_ = 0, foretold_mm2_ = 0;  // of the regression
};

}  // namespace parti::input
