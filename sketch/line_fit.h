// How straight any part of a path is, at constant cost per part (Jesus 2018, 6.9).
// Not responsible for where parts begin and end (corner_search.h).
#pragma once

#include <vector>

#include "sketch/stroke_path.h"

namespace parti::sketch {

/// Sums over the points of a path, from which the best line through any part follows.
class LineFits {
 public:
  explicit LineFits(const StrokePath& path);

  /// Root mean square of the orthogonal distances of points from..to (both included) from their
  /// least-squares line, in diagonals of the stroke, [0, 0.5]. The thesis takes the line through
  /// the part's ends, which a hook or a rounded corner turns. 0 <= from < to < path.size().
  double Bow(int from, int to) const;

 private:
  struct Sums {
    double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  };
  std::vector<Sums> before_;  // before_[i] sums points 0..i-1, from the first point, in diagonals
};

}  // namespace parti::sketch
