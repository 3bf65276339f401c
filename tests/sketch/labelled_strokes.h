// The collection of gesture strokes as tests use it, and the all-or-nothing score of an answer.
#pragma once

#include <string>
#include <vector>

#include "base/stroke.h"
#include "sketch/segmentation.h"

namespace parti::sketch {

struct LabelledStroke {
  std::string id;
  std::string gesture;  ///< its class: "arrow", "circle" …
  std::string subject;  ///< who drew it
  int segments = 0;     ///< as its class has; 0 for classes that are curved
  Stroke stroke;
};

/// Reads strokes as JSON lines; a bad line fails the test.
std::vector<LabelledStroke> ReadLabelledStrokes(const std::string& path);

/// Rates over a set of strokes, each in [0, 1].
struct SegmentationScore {
  int straight = 0, right = 0, false_curves = 0;  ///< strokes of straight classes
  int curved = 0, found_curves = 0;               ///< strokes of curved classes

  void Add(const LabelledStroke& truth, const Segmentation& answer);
  double RightRate() const { return static_cast<double>(right) / straight; }
  double FalseCurveRate() const { return static_cast<double>(false_curves) / straight; }
  double FoundCurveRate() const { return static_cast<double>(found_curves) / curved; }
};

/// Inner corners of the polyline through `segments` + 1 points of the stroke that is nearest to it:
/// least sum of squared distances of evenly spaced points from their own chord, a segment with two
/// ends. (An infinite line would not see the tip of an arrow head that is drawn there and back.)
std::vector<Vec2> BestCorners(const Stroke& stroke, int segments);

}  // namespace parti::sketch
