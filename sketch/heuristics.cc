#include "sketch/heuristics.h"

namespace parti::sketch {

std::span<const Heuristic> Heuristics() {
  static const std::vector<Heuristic> kRows = {
      {{"extrude"}, ExtrudeHeuristic},
      {{"offset"}, OffsetHeuristic},
      {{"split", "repeat"}, SplitHeuristic},
      {{"comp"}, CompHeuristic},
      {{"roofHip", "roofGable", "roofPyramid", "roofShed"}, RoofHeuristic, /*rarer=*/true},
      {{"shapeL", "shapeU", "shapeO"}, ShapeHeuristic, /*rarer=*/true}};
  return kRows;
}

const Heuristic* HeuristicFor(std::string_view operation) {
  for (const Heuristic& heuristic : Heuristics()) {
    for (const std::string_view name : heuristic.operations) {
      if (name == operation) return &heuristic;
    }
  }
  return nullptr;
}

}  // namespace parti::sketch
