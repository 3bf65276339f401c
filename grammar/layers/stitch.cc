#include "grammar/layers/stitch.h"

#include <cmath>
#include <utility>

#include "grammar/layers/stitch_edges.h"

namespace parti::grammar {
namespace {

constexpr uint32_t kNone = UINT32_MAX;
constexpr double kWholeTurn = 6.283185307179586;

/// Follows the edges of a graph around what lies on their left.
class Tracer {
 public:
  explicit Tracer(const StitchGraph& graph)
      : graph_(graph),
        starts_(graph.vertices.size() + 1, 0),
        used_(graph.edges.size(), false),
        place_(graph.vertices.size(), kNone) {
    for (const StitchEdge& edge : graph.edges) ++starts_[edge.from + 1];
    for (size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
  }

  /// Loops of vertices, each vertex once per loop.
  std::vector<std::vector<uint32_t>> Loops() {
    for (uint32_t first = 0; first < graph_.edges.size(); ++first) {
      if (!used_[first]) Follow(first);
    }
    return std::move(loops_);
  }

 private:
  /// Walks until no edge goes on; whenever a vertex is met again, what was walked since is a loop.
  void Follow(uint32_t edge) {
    std::vector<uint32_t> path = {graph_.edges[edge].from};
    place_[path[0]] = 0;
    for (; edge != kNone; edge = Next(edge)) {
      used_[edge] = true;
      const uint32_t vertex = graph_.edges[edge].to;
      if (place_[vertex] == kNone) {
        place_[vertex] = static_cast<uint32_t>(path.size());
        path.push_back(vertex);
        continue;
      }
      const auto from = path.begin() + place_[vertex] + 1;
      loops_.emplace_back(from - 1, path.end());
      for (auto left = from; left != path.end(); ++left) place_[*left] = kNone;
      path.erase(from, path.end());
    }
    for (const uint32_t vertex : path) place_[vertex] = kNone;
  }

  /// The unused edge on from where this one ends that keeps what it borders apart from what else
  /// meets in the vertex: the first one clockwise from where the edge came.
  uint32_t Next(uint32_t edge) const {
    const auto [from, vertex] = graph_.edges[edge];
    uint32_t best = kNone;
    double least = 0;
    for (uint32_t i = starts_[vertex]; i < starts_[vertex + 1]; ++i) {
      if (used_[i]) continue;
      const double turn = Clockwise(vertex, from, graph_.edges[i].to);
      if (best != kNone && turn >= least) continue;
      best = i;
      least = turn;
    }
    return best;
  }

  /// The clockwise angle at `vertex` from one vertex to another; a whole turn where they are one.
  double Clockwise(uint32_t vertex, uint32_t from, uint32_t to) const {
    if (from == to) return kWholeTurn;
    const Vec2 a = graph_.vertices[from] - graph_.vertices[vertex];
    const Vec2 b = graph_.vertices[to] - graph_.vertices[vertex];
    const double angle = std::atan2(Cross(b, a), glm::dot(a, b));
    return angle > 0 ? angle : angle + kWholeTurn;
  }

  const StitchGraph& graph_;
  std::vector<uint32_t> starts_;  ///< of each vertex's edges
  std::vector<bool> used_;
  std::vector<uint32_t> place_;  ///< of each vertex on the path being walked
  std::vector<std::vector<uint32_t>> loops_;
};

/// Without the corners on lines along an axis that do not turn there.
Ring RingOf(const std::vector<uint32_t>& loop, std::span<const Vec2> vertices) {
  Ring ring;
  const size_t n = loop.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2& before = vertices[loop[(i + n - 1) % n]];
    const Vec2& here = vertices[loop[i]];
    const Vec2& after = vertices[loop[(i + 1) % n]];
    const bool upright = before.x == here.x && here.x == after.x;
    const bool level = before.y == here.y && here.y == after.y;
    if (!upright && !level) ring.push_back(here);
  }
  return ring;
}

double LengthOf(const Ring& ring) {
  double length = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    length += glm::distance(ring[i], ring[(i + 1) % ring.size()]);
  }
  return length;
}

bool IsNegligible(const Ring& ring, double area, const Negligible& negligible) {
  return ring.size() < 3 || area < negligible.area_m2 ||
         2 * area < negligible.length_m * LengthOf(ring);
}

struct Outline {
  double area;
  Box2 bounds;
  size_t polygon;
};

/// Each hole to the smallest outline around the middle of its first edge: loops share corners, but
/// no edges.
void AddHoles(std::vector<Ring> holes, std::vector<Polygon>* polygons) {
  std::vector<Outline> outlines;
  for (size_t i = 0; i < polygons->size(); ++i) {
    const Polygon& polygon = (*polygons)[i];
    outlines.push_back({SignedArea(polygon.outer), Bounds(polygon), i});
  }
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const Outline& a, const Outline& b) { return a.area < b.area; });
  for (Ring& hole : holes) {
    const Vec2 middle = (hole[0] + hole[1]) * 0.5;
    for (const Outline& outline : outlines) {
      const Box2& box = outline.bounds;
      Polygon& polygon = (*polygons)[outline.polygon];
      if (middle.x < box.low.x || middle.y < box.low.y || middle.x > box.high.x ||
          middle.y > box.high.y) {
        continue;
      }
      const bool around = outlines.size() == 1 || Contains({polygon.outer, {}}, middle);
      if (!around) continue;
      polygon.holes.push_back(std::move(hole));
      break;
    }
  }
}

}  // namespace

std::vector<Polygon> Stitch(std::span<const Polygon> plus, std::span<const Polygon> minus,
                            const Negligible& negligible) {
  const StitchGraph graph = StitchGraphOf(plus, minus, negligible.length_m);
  std::vector<Polygon> polygons;
  std::vector<Ring> holes;
  for (const std::vector<uint32_t>& loop : Tracer(graph).Loops()) {
    Ring ring = RingOf(loop, graph.vertices);
    const double area = SignedArea(ring);
    if (IsNegligible(ring, std::abs(area), negligible)) continue;
    if (area > 0) {
      polygons.push_back({std::move(ring), {}});
    } else {
      holes.push_back(std::move(ring));
    }
  }
  AddHoles(std::move(holes), &polygons);
  return polygons;
}

}  // namespace parti::grammar
