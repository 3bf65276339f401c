// Façades as people annotate them: rectangles with labels on a rectified photograph.
// What rules they become is facade_rules.h's.
#pragma once

#include <string>
#include <vector>

#include "grammar/polygon.h"

namespace parti::tests {

/// One rectangle of a photograph, in metres from its lower left corner; it may overlap others, and
/// reach over the façade's borders.
struct Annotation {
  std::string label;  ///< "window", "door", "balcony" …
  grammar::Box2 box;
};

/// One photograph.
struct AnnotatedFacade {
  std::string id;
  Vec2 size_m;                       ///< of the whole photograph
  std::vector<grammar::Box2> walls;  ///< labelled "facade": one, or several houses
  std::vector<Annotation> elements;  ///< all else, in the file's order
};

/// How high a photograph is taken to be: five storeys.
inline constexpr double kPhotographHeight_m = 18;

/// Reads JSON lines of {"id", "elements": [{"label","x0","x1","y0","y1"}, …]}, coordinates in [0,
/// 1] of the photograph's width and height, y up. Its proportions are those of the coarsest pixel
/// grid on which all coordinates lie. errors  kFile, kBadText  naming the line.
Result<std::vector<AnnotatedFacade>> ReadAnnotatedFacades(const std::string& path);

}  // namespace parti::tests
