#include "grammar/operations/edge_sides.h"

#include <cmath>
#include <utility>

#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;
constexpr double kLies = 0.70710678;  // normals that rise by 45 degrees
constexpr double kBias = 1e-9;        // rounding must not decide at 45 degrees

EdgeSide SideOnUpright(const Vec2& outward) {
  EdgeSide edge;
  if (std::abs(outward.y) >= std::abs(outward.x) - kBias) {
    (outward.y > 0 ? edge.top : edge.bottom) = true;
  } else {
    edge.side = outward.x > 0 ? StreetSide::kRight : StreetSide::kLeft;
  }
  return edge;
}

bool IsSide(const EdgeSide& edge, StreetSide side) { return edge.side == side; }

double DistanceAt(const SideDistances& distances, const EdgeSide& edge) {
  if (!edge.side) return 0;
  switch (*edge.side) {
    case StreetSide::kFront:
      return distances.front;
    case StreetSide::kRight:
      return distances.right;
    case StreetSide::kBack:
      return distances.back;
    case StreetSide::kLeft:
      return distances.left;
  }
  return 0;
}

}  // namespace

std::vector<EdgeSide> SidesOf(const Item& planar) {
  const Polygon polygon = PolygonOf(planar);
  const bool lies = std::abs(planar.scope.z.y) >= kLies;
  const Vec3 front = lies ? FrontOf(planar) : Vec3(0, 0, 0);
  std::vector<EdgeSide> sides;
  const auto add = [&](const Ring& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Vec2 along = glm::normalize(ring[(i + 1) % ring.size()] - ring[i]);
      const Vec2 outward(along.y, -along.x);
      const Vec3 world = planar.scope.x * outward.x + planar.scope.y * outward.y;
      sides.push_back(lies ? EdgeSide{StreetSideOf(front, planar.scope.z, world), false, false}
                           : SideOnUpright(outward));
    }
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return sides;
}

bool Selects(const Selector& selector, const EdgeSide& edge, size_t index) {
  switch (selector.kind) {
    case Kind::kAll:
      return true;
    case Kind::kFront:
    case Kind::kStreetFront:
      return IsSide(edge, StreetSide::kFront);
    case Kind::kBack:
    case Kind::kStreetBack:
      return IsSide(edge, StreetSide::kBack);
    case Kind::kLeft:
    case Kind::kStreetLeft:
      return IsSide(edge, StreetSide::kLeft);
    case Kind::kRight:
    case Kind::kStreetRight:
      return IsSide(edge, StreetSide::kRight);
    case Kind::kStreetSide:
      return IsSide(edge, StreetSide::kLeft) || IsSide(edge, StreetSide::kRight);
    case Kind::kSide:
      return edge.side.has_value();
    case Kind::kTop:
      return edge.top;
    case Kind::kBottom:
      return edge.bottom;
    case Kind::kIndex:
      return selector.index >= 0 && static_cast<size_t>(selector.index) == index;
    default:
      return false;
  }
}

std::vector<Product> ProductsOf(const Item& planar, SetbackParts parts,
                                const std::vector<int>& successors, int remainder) {
  std::vector<Product> products;
  const auto add = [&](std::vector<Polygon>& pieces, int successor) {
    if (successor < 0) return;
    for (Polygon& piece : pieces) {
      products.push_back({PlanarItem(planar.scope, std::move(piece), planar), successor});
    }
  };
  for (size_t k = 0; k < parts.strips.size(); ++k) add(parts.strips[k], successors[k]);
  add(parts.remainder, remainder);
  return products;
}

Result<std::vector<Product>> ShapeOf(const Item& planar, const Action& action,
                                     const SideDistances& distances) {
  std::vector<EdgeSetback> setbacks;
  for (const EdgeSide& edge : SidesOf(planar)) {
    setbacks.push_back({DistanceAt(distances, edge), 0});  // all of them one strip
  }
  auto parts = Setback(PolygonOf(planar), setbacks);
  if (!parts) return Fail(parts);
  return ProductsOf(planar, std::move(*parts), {SuccessorFor(action, Kind::kShape)},
                    SuccessorFor(action, Kind::kRemainder));
}

Parameter WingParameter(std::string_view name, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kLength,
          .low = 0,
          .high = 1e4,
          .default_value = 6.0,
          .doc = doc};
}

}  // namespace parti::grammar
