#include "grammar/polygon_setback.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/check.h"
#include "grammar/polygon_cut.h"

namespace parti::grammar {
namespace {

/// Neighbours that move alike and turn by less have no mitre to speak of.
constexpr double kNoTurn_deg = 1e-3;

/// An edge with what moves it, and its line: dot(inward, p) == offset.
struct Moved {
  Vec2 a, b;
  Vec2 along, inward;
  double offset;
  EdgeSetback setback;
  size_t before = 0, after = 0;  ///< neighbours in the ring
};

std::vector<Moved> MovedEdges(const Polygon& polygon, const std::vector<EdgeSetback>& setbacks) {
  std::vector<Moved> edges;
  const auto add = [&](const Ring& ring) {
    const size_t first = edges.size(), n = ring.size();
    for (size_t i = 0; i < n; ++i) {
      Moved edge{ring[i], ring[(i + 1) % n], {}, {}, 0, setbacks[first + i], 0, 0};
      edge.along = glm::normalize(edge.b - edge.a);
      edge.inward = Vec2(-edge.along.y, edge.along.x);
      edge.offset = glm::dot(edge.inward, edge.a);
      edge.before = first + (i + n - 1) % n;
      edge.after = first + (i + 1) % n;
      edges.push_back(edge);
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return edges;
}

/// Where the moved `edge` ends at `corner`, which it shares with `neighbour`.
Vec2 EndOf(const Moved& edge, const Moved& neighbour, const Vec2& corner) {
  const double distance = edge.setback.distance_m;
  const bool alike = neighbour.setback.distance_m == distance;
  const double turn = std::atan2(std::abs(Cross(edge.along, neighbour.along)),
                                 glm::dot(edge.along, neighbour.along));
  const double least = Angle::Degrees(alike ? kNoTurn_deg : kStraightOn_deg).radians();
  if (turn <= least) return corner + edge.inward * distance;
  const double u = edge.offset + distance;
  const double v = neighbour.offset + neighbour.setback.distance_m;
  const double det = Cross(edge.inward, neighbour.inward);
  if (std::abs(det) < 1e-9) return corner + edge.inward * distance;
  return Vec2(u * neighbour.inward.y - v * edge.inward.y,
              v * edge.inward.x - u * neighbour.inward.x) /
         det;
}

/// What the edge sweeps if nothing stands in its way: a quadrangle, or a triangle where it shrinks
/// to nothing before it has gone its way.
Ring SweepOf(const Moved& edge, const Moved& before, const Moved& after) {
  const Vec2 end = EndOf(edge, after, edge.b), start = EndOf(edge, before, edge.a);
  if (glm::dot(end - start, edge.along) > 0) return {edge.a, edge.b, end, start};
  const Vec2 left = start - edge.a, right = end - edge.b;
  const double det = Cross(left, right);
  if (!(std::abs(det) > 0)) return {edge.a, edge.b, (start + end) * 0.5};
  return {edge.a, edge.b, edge.a + left * (Cross(edge.b - edge.a, right) / det)};
}

double DistanceToRing(const Ring& ring, const Vec2& p) {
  double nearest = glm::distance(ring[0], p);
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 &a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double t = std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, a + d * t));
  }
  return nearest;
}

/// The part of the sweep in the polygon that hangs together with the edge.
Result<std::vector<Polygon>> SweptBy(const Moved& edge, const Ring& sweep, const Polygon& polygon,
                                     double grid) {
  if (std::abs(SignedArea(sweep)) < kAreaTolerance_m2) return std::vector<Polygon>();
  auto pieces = Intersection(polygon, {sweep, {}}, grid);
  if (!pieces || pieces->size() < 2) return pieces;
  const Vec2 middle = (edge.a + edge.b) * 0.5;
  const auto nearest =
      std::min_element(pieces->begin(), pieces->end(), [&](const Polygon& p, const Polygon& q) {
        return DistanceToRing(p.outer, middle) < DistanceToRing(q.outer, middle);
      });
  return std::vector<Polygon>{std::move(*nearest)};
}

void Append(std::vector<Polygon> pieces, std::vector<Polygon>* all) {
  for (Polygon& piece : pieces) all->push_back(std::move(piece));
}

/// The pieces less what is taken already.
Result<std::vector<Polygon>> LeftOf(const std::vector<Polygon>& pieces,
                                    const std::vector<Polygon>& taken, double grid) {
  if (taken.empty()) return pieces;
  std::vector<Polygon> left;
  for (const Polygon& piece : pieces) {
    auto parts = Without(piece, taken, grid);
    if (!parts) return parts;
    Append(std::move(*parts), &left);
  }
  return left;
}

/// A polygon moved so that its middle is the origin, where doubles are finest.
void Move(Polygon* polygon, const Vec2& by) {
  for (Vec2& p : polygon->outer) p += by;
  for (Ring& hole : polygon->holes) {
    for (Vec2& p : hole) p += by;
  }
}

/// What each strip's edges sweep, overlaps included.
Result<std::vector<std::vector<Polygon>>> SweepsOf(const Polygon& polygon,
                                                   const std::vector<Moved>& edges, double grid) {
  // The strip of edges that none keeps is the last, and dropped in the end.
  int last = 0;
  for (const Moved& edge : edges) last = std::max(last, edge.setback.strip + 1);
  std::vector<std::vector<Polygon>> sweeps(static_cast<size_t>(last) + 1);
  for (const Moved& edge : edges) {
    if (!(edge.setback.distance_m > 0)) continue;
    const Ring sweep = SweepOf(edge, edges[edge.before], edges[edge.after]);
    auto pieces = SweptBy(edge, sweep, polygon, grid);
    if (!pieces) return Fail(pieces);
    const int strip = edge.setback.strip < 0 ? last : edge.setback.strip;
    Append(std::move(*pieces), &sweeps[static_cast<size_t>(strip)]);
  }
  return sweeps;
}

/// The common distance of all edges, if they have one.
std::optional<double> CommonDistance(const std::vector<EdgeSetback>& setbacks) {
  const double distance = setbacks.front().distance_m;
  const bool alike = std::all_of(setbacks.begin(), setbacks.end(), [&](const EdgeSetback& edge) {
    return edge.distance_m == distance;
  });
  return alike && distance > 0 ? std::optional(distance) : std::nullopt;
}

Result<SetbackParts> SetbackHere(const Polygon& polygon, const std::vector<EdgeSetback>& setbacks) {
  const double grid = CutGrid(polygon);
  const auto sweeps = SweepsOf(polygon, MovedEdges(polygon, setbacks), grid);
  if (!sweeps) return Fail(sweeps);
  SetbackParts parts;
  std::vector<Polygon> taken;
  const auto common = CommonDistance(setbacks);
  if (common) {
    auto inside = Offset(polygon, *common);
    if (!inside) return Fail(inside);
    parts.remainder = std::move(*inside);
    taken = parts.remainder;
  }
  for (const std::vector<Polygon>& swept : *sweeps) {
    // Where all edges move alike, the last strip that sweeps anything takes all that is left.
    const bool is_last = std::all_of(&swept + 1, sweeps->data() + sweeps->size(),
                                     [](const auto& later) { return later.empty(); });
    auto joined = common && is_last && !swept.empty() ? Result<std::vector<Polygon>>({polygon})
                                                      : Union(swept, grid);
    if (!joined) return Fail(joined);
    auto strip = LeftOf(*joined, taken, grid);
    if (!strip) return Fail(strip);
    Append(*strip, &taken);
    parts.strips.push_back(std::move(*strip));
  }
  parts.strips.pop_back();
  if (common) return parts;
  auto remainder = Without(polygon, taken, grid);
  if (!remainder) return Fail(remainder);
  parts.remainder = std::move(*remainder);
  return parts;
}

}  // namespace

Result<SetbackParts> Setback(const Polygon& polygon, const std::vector<EdgeSetback>& edges) {
  size_t count = polygon.outer.size();
  for (const Ring& hole : polygon.holes) count += hole.size();
  CHECK(edges.size() == count, "one setback per edge");
  const Box2 box = Bounds(polygon);
  const Vec2 middle = (box.low + box.high) * 0.5;
  Polygon here = polygon;
  Move(&here, -middle);
  auto parts = SetbackHere(here, edges);
  if (!parts) return parts;
  for (auto& strip : parts->strips) {
    for (Polygon& piece : strip) Move(&piece, middle);
  }
  for (Polygon& piece : parts->remainder) Move(&piece, middle);
  return parts;
}

}  // namespace parti::grammar
