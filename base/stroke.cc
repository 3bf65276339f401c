#include "base/stroke.h"

#include <sstream>

#include "base/check.h"

namespace parti {

double PathLength(const Stroke& stroke) {
  double length = 0;
  for (size_t i = 1; i < stroke.size(); ++i) {
    length += glm::distance(stroke[i - 1].position, stroke[i].position);
  }
  return length;
}

double Diagonal(const Stroke& stroke) {
  if (stroke.empty()) return 0;
  Vec2 low = stroke[0].position, high = low;
  for (const StrokeSample& s : stroke) {
    low = glm::min(low, s.position);
    high = glm::max(high, s.position);
  }
  return glm::distance(low, high);
}

Stroke StrokeFrom(std::string_view text) {
  std::istringstream in{std::string(text)};
  Stroke stroke;
  for (double x, y; in >> x;) {
    char comma = 0;
    CHECK(in >> comma >> y && comma == ',', "StrokeFrom wants \"x,y x,y …\"");
    stroke.push_back({Vec2(x, y), 0.01 * static_cast<double>(stroke.size())});
  }
  CHECK(in.eof(), "StrokeFrom wants numbers");
  return stroke;
}

}  // namespace parti
