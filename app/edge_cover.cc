#include "app/edge_cover.h"

#include <algorithm>
#include <cmath>

#include "grammar/item_edges.h"

namespace parti::app {
namespace {

using grammar::Item;
using grammar::ItemType;

constexpr double kTouch_m = 1e-3;  ///< edges this near to a face's plane lie in it
constexpr double kBehind = 0.02;   ///< of a unit vector, how far it goes to the back

bool LooksUp(const Item& face) { return face.scope.z.y > kLeastUp; }

double DistanceTo(const grammar::Ring& ring, const Vec2& p) {
  double nearest = INFINITY;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double t = std::clamp(glm::dot(p - a, d) / std::max(glm::dot(d, d), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(p, a + d * t));
  }
  return nearest;
}

bool IsWellInside(const grammar::Polygon& polygon, const Vec2& p) {
  if (!Contains(polygon, p) || DistanceTo(polygon.outer, p) < kCoverInset_m) return false;
  return std::none_of(polygon.holes.begin(), polygon.holes.end(), [&](const grammar::Ring& hole) {
    return DistanceTo(hole, p) < kCoverInset_m;
  });
}

/// Adds where a -> b crosses the ring's edges, in parts of its length.
void AddCrossings(const grammar::Ring& ring, const Vec2& a, const Vec2& b,
                  std::vector<double>* at) {
  const auto cross = [](const Vec2& p, const Vec2& q) { return p.x * q.y - p.y * q.x; };
  for (size_t i = 0; i < ring.size(); ++i) {
    const Vec2 d = ring[(i + 1) % ring.size()] - ring[i];
    const double turn = cross(b - a, d);
    if (std::abs(turn) <= 1e-12) continue;
    const double t = cross(ring[i] - a, d) / turn, along = cross(ring[i] - a, b - a) / turn;
    if (t > 0 && t < 1 && along >= 0 && along <= 1) at->push_back(t);
  }
}

/// The end of an edge that comes from behind and ends well inside the face: from -> to, in the
/// face's coordinates.
std::vector<EdgeSpan> EndInside(const EdgeCover& cover, const Vec3& from, const Vec3& to) {
  const double length = glm::distance(from, to), part = std::min(1.0, kCoveredEnd_m / length);
  const auto ends = [&](const Vec3& end, const Vec3& other) {
    return std::abs(end.z) <= kTouch_m && other.z < -kBehind * length &&
           IsWellInside(cover.outline, Vec2(end.x, end.y));
  };
  if (ends(from, to)) return {{0, part}};
  if (ends(to, from)) return {{1 - part, 1}};
  return {};
}

/// The parts of a -> b, in the face's plane, that lie well inside it.
std::vector<EdgeSpan> SpansInside(const EdgeCover& cover, const Vec2& a, const Vec2& b) {
  std::vector<double> at = {0, 1};
  AddCrossings(cover.outline.outer, a, b, &at);
  for (const grammar::Ring& hole : cover.outline.holes) AddCrossings(hole, a, b, &at);
  std::sort(at.begin(), at.end());
  std::vector<EdgeSpan> spans;
  for (size_t i = 0; i + 1 < at.size(); ++i) {
    if (!IsWellInside(cover.outline, glm::mix(a, b, 0.5 * (at[i] + at[i + 1])))) continue;
    if (!spans.empty() && spans.back().to == at[i]) {
      spans.back().to = at[i + 1];
    } else {
      spans.push_back({at[i], at[i + 1]});
    }
  }
  return spans;
}

/// Into a face of the item from one of its edges: unit vectors, at right angles to the edge.
std::vector<Vec3> InwardAt(const Item& item, const Segment3& edge) {
  std::vector<Vec3> inward;
  const Vec3 middle = (edge.a + edge.b) * 0.5, along = glm::normalize(edge.b - edge.a);
  for (const grammar::ItemEdge& other : grammar::ItemEdgesOf(item)) {
    const Vec3 direction = glm::normalize(other.b - other.a), d = middle - other.a;
    if (std::abs(glm::dot(direction, along)) < 1 - 1e-9) continue;
    if (glm::length(d - direction * glm::dot(d, direction)) > kTouch_m) continue;
    inward.push_back(-grammar::OutwardOf(other));
    if (other.faces > 1) inward.push_back(glm::cross(direction, other.other));
  }
  return inward;
}

/// Whether the item goes to the back of the cover from its edge, and nowhere else.
bool IsBehind(const EdgeCover& cover, const Item& item, const Segment3& edge) {
  const std::vector<Vec3> inward = InwardAt(item, edge);
  return !inward.empty() && std::all_of(inward.begin(), inward.end(), [&](const Vec3& v) {
    return glm::dot(v, cover.face.scope.z) < -kBehind;
  });
}

}  // namespace

void AddCovers(const Item& item, grammar::ShapeIndex owner, std::vector<EdgeCover>* covers) {
  const auto add = [&](const Item& face) {
    if (LooksUp(face)) covers->push_back({face, owner, PolygonOf(face)});
  };
  if (item.type == ItemType::kPlanar) add(item);
  if (item.type != ItemType::kVolume || !item.mesh || item.mesh_is_unit) return;
  for (const Item& face : grammar::FacesOf(item)) add(face);
}

bool MayCover(const EdgeCover& cover, const Item& item) {
  const grammar::Scope& box = item.scope;
  const Vec3 &normal = cover.face.scope.z, half = box.size * 0.5;
  const double middle = glm::dot(box.ToWorld(half) - cover.face.scope.origin, normal);
  double reach = 0;
  for (int i = 0; i < 3; ++i) reach += half[i] * std::abs(glm::dot(box.axis(i), normal));
  return middle - reach < -kTouch_m && middle + reach >= -kTouch_m;
}

std::vector<EdgeSpan> CoveredSpans(const EdgeCover& cover, const Item& item, const Segment3& edge) {
  const Vec3 from = cover.face.scope.ToLocal(edge.a), to = cover.face.scope.ToLocal(edge.b);
  if (std::abs(from.z) > kTouch_m || std::abs(to.z) > kTouch_m) return EndInside(cover, from, to);
  std::vector<EdgeSpan> spans = SpansInside(cover, Vec2(from.x, from.y), Vec2(to.x, to.y));
  if (!spans.empty() && !IsBehind(cover, item, edge)) spans.clear();
  return spans;
}

}  // namespace parti::app
