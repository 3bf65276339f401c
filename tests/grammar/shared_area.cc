#include "tests/grammar/shared_area.h"

#include <algorithm>

namespace parti::grammar::tests {
namespace {

struct Edge {
  Vec2 low, high;  ///< by y
};

std::vector<Edge> EdgesOf(const Polygon& polygon) {
  std::vector<Edge> edges;
  const auto add = [&edges](const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if (a.y != b.y) edges.push_back(a.y < b.y ? Edge{a, b} : Edge{b, a});
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return edges;
}

double XAt(const Edge& edge, double y) {
  return edge.low.x + (edge.high.x - edge.low.x) * ((y - edge.low.y) / (edge.high.y - edge.low.y));
}

void AddHeights(const std::vector<Edge>& a, const std::vector<Edge>& b, std::vector<double>* ys) {
  for (const Edge& p : a) {
    ys->push_back(p.low.y);
    ys->push_back(p.high.y);
    for (const Edge& q : b) {
      const double low = std::max(p.low.y, q.low.y), high = std::min(p.high.y, q.high.y);
      if (!(low < high)) continue;
      const double at_low = XAt(p, low) - XAt(q, low), at_high = XAt(p, high) - XAt(q, high);
      if (at_low * at_high < 0) ys->push_back(low + (high - low) * at_low / (at_low - at_high));
    }
  }
}

/// Where a horizontal line enters and leaves the polygon.
std::vector<double> Crossings(const std::vector<Edge>& edges, double y) {
  std::vector<double> xs;
  for (const Edge& edge : edges) {
    if (edge.low.y <= y && y < edge.high.y) xs.push_back(XAt(edge, y));
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

double SharedLength(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (size_t i = 0; i + 1 < a.size(); i += 2) {
    for (size_t k = 0; k + 1 < b.size(); k += 2) {
      sum += std::max(0.0, std::min(a[i + 1], b[k + 1]) - std::max(a[i], b[k]));
    }
  }
  return sum;
}

}  // namespace

double SharedArea(const Polygon& a, const Polygon& b) {
  const std::vector<Edge> p = EdgesOf(a), q = EdgesOf(b);
  std::vector<double> ys;
  AddHeights(p, q, &ys);
  AddHeights(q, p, &ys);
  std::sort(ys.begin(), ys.end());
  double area = 0;
  for (size_t i = 0; i + 1 < ys.size(); ++i) {
    const double middle = 0.5 * (ys[i] + ys[i + 1]);
    area += (ys[i + 1] - ys[i]) * SharedLength(Crossings(p, middle), Crossings(q, middle));
  }
  return area;
}

}  // namespace parti::grammar::tests
