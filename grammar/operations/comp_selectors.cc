#include "grammar/operations/comp_selectors.h"

#include <cmath>

#include "grammar/front_edge.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;

/// CGA's classes of elevation over the scope's xz plane, and the quadrants.
constexpr double kHorizontal_deg = 78.75;
constexpr double kVertical_deg = 11.25;
constexpr double kQuadrant_deg = 45;
/// Classes are half open; rounding of a normal must not decide on which side 45 deg falls.
constexpr double kBias_deg = 1e-6;
/// Edges that rise by less than this are level.
constexpr double kLevel_deg = 5;

/// A direction in a frame of axes.
struct Direction {
  double elevation_deg;  ///< over the xz plane
  double azimuth_deg;    ///< from z (front) towards x (right), in [-180, 180]
};

Direction DirectionOf(const Vec3& n) {
  return {Angle::Radians(std::atan2(n.y, std::hypot(n.x, n.z))).degrees(),
          Angle::Radians(std::atan2(n.x, n.z)).degrees()};
}

Direction In(const Scope& s, const Vec3& v) {
  return DirectionOf(Vec3(glm::dot(v, s.x), glm::dot(v, s.y), glm::dot(v, s.z)));
}

/// The one of the six sides that the direction points to.
Kind QuadrantOf(const Direction& d) {
  if (d.elevation_deg >= kQuadrant_deg - kBias_deg) return Kind::kTop;
  if (d.elevation_deg <= -kQuadrant_deg + kBias_deg) return Kind::kBottom;
  const double turned = d.azimuth_deg + kQuadrant_deg + kBias_deg;
  if (turned >= 0 && turned < 90) return Kind::kFront;
  if (turned >= 90 && turned < 180) return Kind::kRight;
  if (turned >= -90 && turned < 0) return Kind::kLeft;
  return Kind::kBack;
}

bool IsHorizontal(const Direction& d) {
  return std::abs(d.elevation_deg) > kHorizontal_deg + kBias_deg;
}
bool IsVertical(const Direction& d) {
  return d.elevation_deg > -kVertical_deg - kBias_deg &&
         d.elevation_deg <= kVertical_deg + kBias_deg;
}

/// The world's sides by the scope's names: south is its front.
Kind SideFor(Kind world) {
  switch (world) {
    case Kind::kWorldSouth:
      return Kind::kFront;
    case Kind::kWorldNorth:
      return Kind::kBack;
    case Kind::kWorldWest:
      return Kind::kLeft;
    case Kind::kWorldEast:
      return Kind::kRight;
    case Kind::kWorldUp:
      return Kind::kTop;
    default:
      return Kind::kBottom;
  }
}

/// eave, hip, valley or ridge; kAll where it is none of them.
Kind RoofEdgeOf(const ItemEdge& edge) {
  const auto slopes = [](const Vec3& n) {
    const Direction d = DirectionOf(n);
    return n != Vec3(0, 0, 0) && d.elevation_deg > kLevel_deg && d.elevation_deg < 90 - kLevel_deg;
  };
  const Vec3 along = glm::normalize(edge.b - edge.a);
  const bool level = std::abs(DirectionOf(along).elevation_deg) < kLevel_deg;
  const bool first = slopes(edge.normal), second = slopes(edge.other);
  const bool convex = glm::dot(glm::cross(edge.normal, edge.other), along) > 0;
  if (first && second) return !convex ? Kind::kValley : level ? Kind::kRidge : Kind::kHip;
  if (!level || (!first && !second)) return Kind::kAll;
  // A roof's lower edge: where the face that slopes goes down over it.
  const Vec3 outward = glm::cross(first ? along : -along, first ? edge.normal : edge.other);
  return outward.y < 0 ? Kind::kEave : Kind::kAll;
}

bool MatchesStreet(Kind kind, const Component& component, const CompFrame& frame) {
  const Vec3 up = frame.scope.y;
  const Vec3 flat = component.direction - up * glm::dot(component.direction, up);
  if (IsHorizontal(In(frame.scope, component.direction))) return false;
  if (kind == Kind::kStreetSide) return true;
  const StreetSide side = StreetSideOf(frame.street_front, up, glm::normalize(flat));
  return (kind == Kind::kStreetFront && side == StreetSide::kFront) ||
         (kind == Kind::kStreetBack && side == StreetSide::kBack) ||
         (kind == Kind::kStreetLeft && side == StreetSide::kLeft) ||
         (kind == Kind::kStreetRight && side == StreetSide::kRight);
}

}  // namespace

bool Matches(const Selector& selector, const Component& component, const CompFrame& frame) {
  const Direction d = In(frame.scope, component.direction);
  switch (selector.kind) {
    case Kind::kAll:
      return true;
    case Kind::kIndex:
      return selector.index == component.index;
    case Kind::kSide:
      return !IsHorizontal(d);
    case Kind::kHorizontal:
      return IsHorizontal(d);
    case Kind::kVertical:
      return IsVertical(d);
    case Kind::kAslant:
      return !IsHorizontal(d) && !IsVertical(d) && d.elevation_deg > 0;
    case Kind::kNutant:
      return !IsHorizontal(d) && !IsVertical(d) && d.elevation_deg < 0;
    case Kind::kBorder:
      return component.on_border;
    case Kind::kInside:
      return !component.on_border;
    case Kind::kEave:
    case Kind::kHip:
    case Kind::kValley:
    case Kind::kRidge:
      return component.edge != nullptr && RoofEdgeOf(*component.edge) == selector.kind;
    case Kind::kStreetFront:
    case Kind::kStreetBack:
    case Kind::kStreetLeft:
    case Kind::kStreetRight:
    case Kind::kStreetSide:
      return MatchesStreet(selector.kind, component, frame);
    case Kind::kWorldSouth:
    case Kind::kWorldNorth:
    case Kind::kWorldWest:
    case Kind::kWorldEast:
    case Kind::kWorldUp:
    case Kind::kWorldDown:
      return SideFor(selector.kind) == QuadrantOf(DirectionOf(component.direction));
    case Kind::kWorldSide:
      return !IsHorizontal(DirectionOf(component.direction));
    default:
      return selector.kind == QuadrantOf(d);
  }
}

int SuccessorOf(const Action& action, const Component& component, const CompFrame& frame) {
  for (size_t i = 0; i < action.successors.size(); ++i) {
    const Successor& s = action.successors[i];
    if (!Matches(std::get<Selector>(s.key), component, frame)) continue;
    return s.symbol == kNil ? -1 : static_cast<int>(i);
  }
  return -1;
}

}  // namespace parti::grammar
