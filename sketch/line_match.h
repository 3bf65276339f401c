// Drawn lines against the projected edges of an operation: the error function (Jesus 2018, 6.6.1).
// Measured on the screen, in each line's own view, where the pen's scatter is known and the same in
// every direction; along the view ray a lifted line may lie anywhere (docs/inference.md).
#pragma once

#include <vector>

#include "base/camera.h"
#include "sketch/configuration.h"
#include "sketch/parameters.h"

namespace parti::sketch {

class MadeEdges;

/// The lines of a configuration with their views and expected scatter worked out.
class SketchedLines {
 public:
  struct Line {
    Segment2 drawn;
    double deviation_px = 1;  ///< expected, per coordinate of an end
    int view = 0;
  };

  SketchedLines(const Configuration& configuration, const PenNoise& noise);
  /// Lines that may be parts of edges on made.item(), or left over, at the prices of `parts` where
  /// those are allowed. `made` must outlive this.
  SketchedLines(const Configuration& configuration, const PenNoise& noise,
                const PartParameters& parts, const MadeEdges& made);

  const std::vector<Line>& lines() const { return lines_; }
  const std::vector<View>& views() const { return views_; }
  const PartParameters& parts() const { return parts_; }
  /// Whether a line may stand for a part of the edge: where that is allowed, and it lies on the
  /// item.
  bool MayBeDrawnInPart(const Segment3& edge) const;

 private:
  std::vector<Line> lines_;
  std::vector<View> views_;
  PartParameters parts_;
  const MadeEdges* made_ = nullptr;
};

/// What a line's best edge leaves unexplained.
struct LineMatch {
  int edge = -1;     ///< index; -1 where no edge can be seen
  Vec2 off_a{0, 0};  ///< projected end less drawn end, px
  Vec2 off_b{0, 0};
  double error = 0;  ///< (6.14), with each end's share damped by Cauchy's loss, and the price twice
  double price = 0;  ///< of being a part of the edge, or left over [nat]
  bool left_over = false;  ///< the operation says nothing about the line; edge is -1
};

/// How well edges explain all lines of a sketch.
struct Match {
  std::vector<LineMatch> lines;
  size_t explained = 0;  ///< lines that are not left over
  double error = 0;      ///< (6.15): the sum over the lines; 0 for a perfect fit
};

/// Cauchy's loss of a squared distance in deviations: the distance itself while small, growing like
/// its logarithm beyond `outlier`; monotonic, as (6.14) has to be.
double DampedError(double squared_deviations, double outlier);

/// (6.14) for ends that are this far off [px].
double LineError(const Vec2& off_a, const Vec2& off_b, const SketchedLines::Line& line,
                 double outlier);

/// For every line the edge that minimises (6.14), over both orientations (errata 19).
Match MatchLines(const SketchedLines& lines, const std::vector<Segment3>& edges, double outlier);

/// Root of the mean squared distance of ends [px], of the lines that are not left over; infinite
/// where all are, or where one has no edge that can be seen.
double MeanEndDistance_px(const Match& match);

}  // namespace parti::sketch
