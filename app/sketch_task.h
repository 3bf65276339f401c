// Sketching tasks and their answers as JSON (docs/interfaces.md, Sketch tasks and answers): the
// border between files and the sketch pipeline. Knows nothing of how sketches are read.
#pragma once

#include <vector>

#include "app/batch.h"
#include "base/camera.h"
#include "base/error.h"
#include "base/json.h"
#include "grammar/item.h"
#include "sketch/suggestion.h"

namespace parti::app {

/// One sketch: the item drawn on, the view, the strokes.
struct SketchTask {
  grammar::Item item;
  Camera camera;
  std::vector<Stroke> strokes;  ///< n >= 1
};

/// {"shape": {"polygon": [[x,y,z]…]} | {"box": {origin, x, y, z, size}}, "camera": {eye, target,
/// up, vfov_deg, width, height}, "strokes": [[[x,y,t]…]…]}. Other keys, "truth" among them, are not
/// looked at.
/// errors  kBadText  a part is missing or of another kind;  kBadNumber  a number that is not
///         finite, or a camera that can't see;  kDegenerateGeometry, kSelfIntersecting, kNotPlanar
///         the shape.
Result<SketchTask> SketchTaskFrom(const Json& task);

/// {"op", "params"} as the tasks' authors want them: distances inward positive for offset, split
/// sizes in metres along the scope's axis, repeat's count and size. Operations beyond those give
/// their dials by name.
BatchAnswer AnswerOf(const sketch::Suggestion& suggestion, const grammar::Item& item);

}  // namespace parti::app
