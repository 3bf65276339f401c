// Items from what people and files give: rings in the world, boxes in the world.
#include <fmt/format.h>

#include <utility>

#include "grammar/item.h"
#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

/// Corners this part of the diagonal off a rectangle's make a rectangle: below what the rounding of
/// files to 5 decimals does.
constexpr double kRectangle = 1e-5;
/// Corners may be this far off the plane: an absolute distance, or this part of the diagonal.
constexpr double kOffPlane_m = 1e-3;
constexpr double kOffPlane = 1e-3;
constexpr double kOrthonormal = 1e-6;

using Rings3 = std::vector<std::vector<Vec3>>;

/// Also false for what is not a number.
bool IsInRange(const Vec3& p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= kLargestCoordinate_m &&
         IsFinite(p);
}

Result<void> CheckRange(const Rings3& rings) {
  for (const auto& ring : rings) {
    for (const Vec3& p : ring) {
      if (IsInRange(p)) continue;
      return Fail(
          ErrorCode::kBadNumber,
          fmt::format("a polygon has a corner at ({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z),
          fmt::format("give finite coordinates in metres, up to {:.0g}", kLargestCoordinate_m));
    }
  }
  return {};
}

/// Newell's normal of the ring, its length twice the area.
Vec3 NewellNormal(const std::vector<Vec3>& ring) {
  Vec3 sum(0, 0, 0);
  for (size_t i = 2; i < ring.size(); ++i) {
    sum += glm::cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  }
  return sum;
}

/// The normal of three corners that lie well apart; 0 when all are on one line. For rings whose
/// area cancels: a bow-tie has a plane, too.
Vec3 WideNormal(const std::vector<Vec3>& ring) {
  const Vec3& a = ring[0];
  Vec3 along(0, 0, 0), normal(0, 0, 0);
  for (const Vec3& p : ring) {
    if (glm::length(p - a) > glm::length(along)) along = p - a;
  }
  for (const Vec3& p : ring) {
    const Vec3 n = glm::cross(along, p - a);
    if (glm::length(n) > glm::length(normal)) normal = n;
  }
  return normal;
}

double DiagonalOf(const std::vector<Vec3>& ring) {
  Vec3 low = ring[0], high = low;
  for (const Vec3& p : ring) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::length(high - low);
}

Result<Vec3> NormalOf(const std::vector<Vec3>& ring, const Vec3* up_hint) {
  const double diagonal = ring.empty() ? 0 : DiagonalOf(ring);
  Vec3 normal = ring.empty() ? Vec3(0, 0, 0) : NewellNormal(ring);
  if (glm::length(normal) <= 1e-9 * diagonal * diagonal && !ring.empty()) normal = WideNormal(ring);
  const double length = glm::length(normal);
  if (ring.size() < 3 || !(length > kAreaTolerance_m2)) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("a polygon of {} corners has no area", ring.size()),
                "give at least 3 corners that are not on one line");
  }
  normal /= length;
  return up_hint && glm::dot(normal, *up_hint) < 0 ? -normal : normal;
}

/// Origin on the plane through the middle of all corners, x along the first edge of some length.
Scope FrameOf(const Rings3& rings, const Vec3& normal) {
  Scope frame;
  frame.z = normal;
  const std::vector<Vec3>& ring = rings[0];
  double offset = 0;
  size_t count = 0;
  for (const auto& r : rings) {
    for (const Vec3& p : r) offset += glm::dot(p - ring[0], normal);
    count += r.size();
  }
  frame.origin = ring[0] + normal * (offset / static_cast<double>(count));
  Vec3 edge(0, 0, 0);
  for (size_t i = 0; i < ring.size() && glm::length(edge) <= kLengthTolerance_m; ++i) {
    edge = ring[(i + 1) % ring.size()] - ring[i];
    edge -= normal * glm::dot(edge, normal);
  }
  frame.x = glm::normalize(edge);
  frame.y = glm::cross(normal, frame.x);
  return frame;
}

Result<std::vector<Ring>> Flatten(const Rings3& rings, const Scope& frame) {
  const double allowed = std::max(kOffPlane_m, kOffPlane * DiagonalOf(rings[0]));
  std::vector<Ring> flat;
  for (const auto& ring : rings) {
    flat.emplace_back();
    for (const Vec3& p : ring) {
      const Vec3 local = frame.ToLocal(p);
      if (std::abs(local.z) > allowed) {
        return Fail(ErrorCode::kNotPlanar,
                    fmt::format("a corner at ({:.3f}, {:.3f}, {:.3f}) lies {:.3g} m off the plane "
                                "of its polygon; {:.3g} m are allowed",
                                p.x, p.y, p.z, std::abs(local.z), allowed),
                    "split the polygon into triangles, or move the corner");
      }
      flat.back().emplace_back(local.x, local.y);
    }
  }
  return flat;
}

/// Turns frame and polygon so that x runs along the first edge that is left after cleaning.
void TurnToFirstEdge(Scope* frame, Polygon* polygon) {
  const Vec2 edge = glm::normalize(polygon->outer[1] - polygon->outer[0]);
  if (std::abs(edge.y) < 1e-12 && edge.x > 0) return;
  const auto turn = [&](Vec2& p) { p = Vec2(glm::dot(edge, p), Cross(edge, p)); };
  std::for_each(polygon->outer.begin(), polygon->outer.end(), turn);
  for (Ring& hole : polygon->holes) std::for_each(hole.begin(), hole.end(), turn);
  const Vec3 x = frame->x * edge.x + frame->y * edge.y;
  frame->x = glm::normalize(x);
  frame->y = glm::cross(frame->z, frame->x);
}

bool IsNearlyRectangle(const Polygon& polygon) {
  if (polygon.outer.size() != 4 || !polygon.holes.empty()) return false;
  const Box2 box = Bounds(polygon);
  const Ring corners = Rectangle(box.high - box.low).outer;
  const double allowed = kRectangle * glm::length(box.high - box.low);
  for (size_t i = 0; i < 4; ++i) {
    if (glm::distance(polygon.outer[i] - box.low, corners[i]) > allowed) return false;
  }
  return true;
}

}  // namespace

Result<Item> PlanarFrom(const Rings3& rings, const Vec3* up_hint) {
  if (const auto range = CheckRange(rings); !range) return Fail(range);
  const auto normal = NormalOf(rings.empty() ? std::vector<Vec3>{} : rings[0], up_hint);
  if (!normal) return Fail(normal);
  Scope frame = FrameOf(rings, *normal);
  const auto flat = Flatten(rings, frame);
  if (!flat) return Fail(flat);
  auto polygon = PolygonFrom(*flat);
  if (!polygon) return Fail(polygon);
  TurnToFirstEdge(&frame, &*polygon);
  if (IsNearlyRectangle(*polygon)) {
    const Box2 box = Bounds(*polygon);
    polygon->outer = {box.low, Vec2(box.high.x, box.low.y), box.high, Vec2(box.low.x, box.high.y)};
  }
  return PlanarItem(frame, std::move(*polygon), Item());
}

Result<Item> BoxFrom(const Scope& scope) {
  const Vec3 &x = scope.x, &y = scope.y, &z = scope.z;
  if (!IsInRange(scope.origin) || !IsFinite(x) || !IsFinite(y) || !IsFinite(z) ||
      !IsInRange(scope.size)) {
    return Fail(
        ErrorCode::kBadNumber, "a box has a number that is not finite, or too large",
        fmt::format("give origin, axes and size in metres, up to {:.0g}", kLargestCoordinate_m));
  }
  const double unit = std::max({std::abs(glm::length(x) - 1), std::abs(glm::length(y) - 1),
                                std::abs(glm::dot(x, y)), glm::length(glm::cross(x, y) - z)});
  if (unit > kOrthonormal) {
    return Fail(ErrorCode::kBadNumber,
                "the axes of a box are not unit vectors at right angles, right-handed",
                "give x, y and z = x cross y of length 1");
  }
  if (std::min({scope.size.x, scope.size.y, scope.size.z}) <= kLengthTolerance_m) {
    return Fail(ErrorCode::kDegenerateGeometry,
                fmt::format("a box of {:.4g} x {:.4g} x {:.4g} m has no volume", scope.size.x,
                            scope.size.y, scope.size.z),
                "give three sizes greater than 0");
  }
  Item box;
  box.type = ItemType::kVolume;
  box.scope = StandUp(scope, StandingOf(scope));
  return box;
}

}  // namespace parti::grammar
