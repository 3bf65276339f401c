// Adjusting an operation's numbers to the drawn lines by gradient descent (Jesus 2018, 6.6.2,
// Listing 6.2; errata 18). Knows operations only through their dials and the edges that they make.
#pragma once

#include "base/error.h"
#include "sketch/hypothesis.h"
#include "sketch/line_match.h"
#include "sketch/made_edges.h"

namespace parti::sketch {

/// A hypothesis after descent, and how well it fits.
struct Adjusted {
  Hypothesis hypothesis;
  Match match;             ///< of the adjusted action
  double first_error = 0;  ///< (6.15) before
  /// Half the log determinant of 1 + the error's curvature over each dial's whole range [nat]: how
  /// sharply the lines fix the numbers, which is what free numbers cost in ranking.
  double sharpness = 0;
};

/// Central differences over every dial (6.17), the gradient scaled by the inverse of the
/// Gauss-Newton matrix because dials have different units and sizes of a split pull on each other,
/// and a search along that direction. Dials stay within their ranges.
/// errors  those of grammar::Apply for the hypothesis as it comes.
/// Properties: (1) the error never grows;  (2) dials that are tied stay equal;
///             (3) adjusting again changes next to nothing.
/// Cost: 2 x dials + a few applications of the operation for each step, a dozen steps at most.
Result<Adjusted> Adjust(const Hypothesis& hypothesis, const MadeEdges& made,
                        const SketchedLines& lines, const SketchParameters& parameters);

}  // namespace parti::sketch
