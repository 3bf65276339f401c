// All borders cut the wall into cells; each cell belongs to the topmost rectangle over it.
#include "tests/facades/visible_area.h"

#include <algorithm>

#include "tests/facades/facade_rules.h"

namespace parti::tests {
namespace {

using grammar::Box2;

/// Every border along an axis within the wall, in order.
std::vector<double> Cuts(const AnnotatedFacade& facade, const Box2& wall, int axis) {
  std::vector<double> cuts{wall.low[axis], wall.high[axis]};
  for (const Annotation& element : facade.elements) {
    for (const double at : {element.box.low[axis], element.box.high[axis]}) {
      if (at > wall.low[axis] && at < wall.high[axis]) cuts.push_back(at);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}

bool Covers(const Box2& box, const Vec2& point) {
  return point.x > box.low.x && point.x < box.high.x && point.y > box.low.y && point.y < box.high.y;
}

/// The index of the element that is seen at a point; -1: the wall.
int TopmostAt(const AnnotatedFacade& facade, const Vec2& point) {
  int top = -1;
  size_t top_layer = 0;
  for (size_t i = 0; i < facade.elements.size(); ++i) {
    if (!Covers(facade.elements[i].box, point)) continue;
    const size_t layer = LayerOf(facade.elements[i].label);
    if (top < 0 || layer >= top_layer) {
      top = static_cast<int>(i);
      top_layer = layer;
    }
  }
  return top;
}

}  // namespace

std::vector<double> VisibleAreas(const AnnotatedFacade& facade, const Box2& wall) {
  const auto xs = Cuts(facade, wall, 0), ys = Cuts(facade, wall, 1);
  std::vector<double> areas(facade.elements.size(), 0);
  for (size_t i = 0; i + 1 < xs.size(); ++i) {
    for (size_t j = 0; j + 1 < ys.size(); ++j) {
      const Vec2 middle((xs[i] + xs[i + 1]) / 2, (ys[j] + ys[j + 1]) / 2);
      const int top = TopmostAt(facade, middle);
      if (top >= 0) areas[top] += (xs[i + 1] - xs[i]) * (ys[j + 1] - ys[j]);
    }
  }
  return areas;
}

}  // namespace parti::tests
