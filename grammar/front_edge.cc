#include "grammar/front_edge.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace parti::grammar {
namespace {

constexpr double kAsLong = 1e-6;
/// Directions whose coordinates differ by less look the same way.
constexpr double kSameWay = 1e-6;
/// Rounding must not decide on which side 45 deg falls.
constexpr double kBias_deg = 1e-6;
/// Faces that look down more than sideways are bottoms.
constexpr double kDown = -0.7;

/// A side of an outline: a chord's length and the direction out of it, in the world.
struct Side {
  double length = 0;
  Vec3 outward{0, 0, 0};
};

Vec3 ToWorldDirection(const Scope& scope, const Vec2& v) { return scope.x * v.x + scope.y * v.y; }

Side SideFrom(const Scope& scope, const Vec2& from, const Vec2& to) {
  const Vec2 chord = to - from;
  const double length = glm::length(chord);
  if (!(length > 0)) return {};
  return {length, ToWorldDirection(scope, Vec2(chord.y, -chord.x) / length)};
}

double TurnAt(const Ring& ring, size_t i) {
  const size_t n = ring.size();
  const Vec2 in = ring[i] - ring[(i + n - 1) % n];
  const Vec2 out = ring[(i + 1) % n] - ring[i];
  return std::abs(std::atan2(Cross(in, out), glm::dot(in, out)));
}

/// -1, 0, 1 for less, the same within kSameWay, more.
int Compare(double a, double b) { return a > b + kSameWay ? 1 : a < b - kSameWay ? -1 : 0; }

bool IsBefore(const Side& a, const Side& b) {
  const double margin = kAsLong * std::max(a.length, b.length);
  if (std::abs(a.length - b.length) > margin) return a.length > b.length;
  // The low side first, for what stands upright; then south (+z), then east.
  if (const int low = Compare(-a.outward.y, -b.outward.y)) return low > 0;
  if (const int south = Compare(a.outward.z, b.outward.z)) return south > 0;
  return Compare(a.outward.x, b.outward.x) > 0;
}

/// The side that begins at corner `first`: as many edges as stay within the turn of its first.
Side SideAt(const Scope& scope, const Ring& ring, size_t first) {
  const size_t n = ring.size();
  const Vec2 along = ring[(first + 1) % n] - ring[first];
  const double most = Angle::Degrees(kSideTurn_deg).radians();
  size_t count = 1;
  for (; count < n; ++count) {
    const Vec2 next = ring[(first + count + 1) % n] - ring[(first + count) % n];
    if (std::abs(std::atan2(Cross(along, next), glm::dot(along, next))) > most) break;
  }
  return SideFrom(scope, ring[first], ring[(first + count) % n]);
}

/// Sides begin at corners; a round outline has none, and then anywhere.
Vec3 OutOfLongestSide(const Scope& scope, const Ring& ring) {
  const double most = Angle::Degrees(kSideTurn_deg).radians();
  Side longest;
  for (const bool anywhere : {false, true}) {
    for (size_t i = 0; i < ring.size(); ++i) {
      if (!anywhere && TurnAt(ring, i) <= most) continue;
      const Side side = SideAt(scope, ring, i);
      if (side.length > 0 && IsBefore(side, longest)) longest = side;
    }
    if (longest.length > 0) break;
  }
  return longest.outward;
}

/// Towards the street, in the plane of `normal`; 0 where the street lies along the normal.
Vec3 TowardsStreet(float street_deg, const Vec3& normal) {
  const double heading = Angle::Degrees(street_deg).radians();
  Vec3 way(std::sin(heading), 0, -std::cos(heading));
  way -= normal * glm::dot(way, normal);
  const double length = glm::length(way);
  return length > kSameWay ? way / length : Vec3(0, 0, 0);
}

Vec3 FrontOfPlanar(const Item& planar) {
  if (planar.street_deg) {
    const Vec3 way = TowardsStreet(*planar.street_deg, planar.scope.z);
    if (way != Vec3(0, 0, 0)) return way;
  }
  return OutOfLongestSide(planar.scope, PolygonOf(planar).outer);
}

Vec3 FrontOfVolume(const Item& volume) {
  if (volume.street_deg) return TowardsStreet(*volume.street_deg, Vec3(0, 1, 0));
  const std::vector<Item> faces = FacesOf(volume);
  const Item* bottom = nullptr;
  for (const Item& face : faces) {
    if (face.facing.y > kDown) continue;
    if (bottom == nullptr || AreaOf(face) > AreaOf(*bottom)) bottom = &face;
  }
  return bottom ? FrontOfPlanar(*bottom) : volume.scope.z;
}

}  // namespace

Vec3 FrontOf(const Item& item) {
  return item.type == ItemType::kPlanar ? FrontOfPlanar(item) : FrontOfVolume(item);
}

size_t FrontEdge(const Item& planar) {
  CHECK(planar.type == ItemType::kPlanar, "only a planar item has an outline");
  const Ring ring = PolygonOf(planar).outer;
  const Vec3 front = FrontOfPlanar(planar);
  const double within = std::cos(Angle::Degrees(kSideTurn_deg).radians());
  size_t best = 0;
  double best_along = -2;
  Side best_side;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Side side = SideFrom(planar.scope, ring[i], ring[(i + 1) % ring.size()]);
    const double along = std::min(within, glm::dot(side.outward, front));
    if (along < best_along || (along == best_along && !IsBefore(side, best_side))) continue;
    best = i;
    best_along = along;
    best_side = side;
  }
  return best;
}

StreetSide StreetSideOf(const Vec3& front, const Vec3& up, const Vec3& outward) {
  const double turn =
      std::atan2(glm::dot(glm::cross(front, outward), up), glm::dot(front, outward));
  const double turned = Angle::Radians(turn).degrees() + 45 + kBias_deg;
  if (turned >= 0 && turned < 90) return StreetSide::kFront;
  if (turned >= 90 && turned < 180) return StreetSide::kRight;
  if (turned >= -90 && turned < 0) return StreetSide::kLeft;
  return StreetSide::kBack;
}

}  // namespace parti::grammar
