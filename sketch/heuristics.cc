#include "sketch/heuristics.h"

namespace parti::sketch {

std::span<const Heuristic> Heuristics() {
  static const std::vector<Heuristic> kRows = {{{"extrude"}, ExtrudeHeuristic},
                                               {{"offset"}, OffsetHeuristic},
                                               {{"split", "repeat"}, SplitHeuristic},
                                               {{"comp"}, CompHeuristic}};
  return kRows;
}

bool HasHeuristic(std::string_view operation) {
  for (const Heuristic& heuristic : Heuristics()) {
    for (const std::string_view name : heuristic.operations) {
      if (name == operation) return true;
    }
  }
  return false;
}

}  // namespace parti::sketch
