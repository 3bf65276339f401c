// comp(f) { selectors }: the faces of a volume as planar shapes.
#include <array>
#include <cmath>
#include <utility>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;

/// CGA's classes of elevation over the scope's xz plane, and the quadrants.
constexpr double kHorizontal_deg = 78.75;
constexpr double kVertical_deg = 11.25;
constexpr double kQuadrant_deg = 45;
/// Classes are half open; rounding of a normal must not decide on which side 45 deg falls.
constexpr double kBias_deg = 1e-6;

/// Direction of a face's normal in the scope of its volume.
struct Direction {
  double elevation_deg;  ///< over the scope's xz plane
  double azimuth_deg;    ///< from z (front) towards x (right), in [-180, 180]
};

Direction DirectionOf(const Vec3& normal, const Scope& scope) {
  const Vec3 n(glm::dot(normal, scope.x), glm::dot(normal, scope.y), glm::dot(normal, scope.z));
  return {Angle::Radians(std::atan2(n.y, std::hypot(n.x, n.z))).degrees(),
          Angle::Radians(std::atan2(n.x, n.z)).degrees()};
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

bool Matches(const Selector& selector, const Direction& d, int index) {
  const double rise = std::abs(d.elevation_deg);
  switch (selector.kind) {
    case Kind::kAll:
      return true;
    case Kind::kSide:
      return rise <= kHorizontal_deg + kBias_deg;
    case Kind::kHorizontal:
      return rise > kHorizontal_deg + kBias_deg;
    case Kind::kVertical:
      return d.elevation_deg > -kVertical_deg - kBias_deg &&
             d.elevation_deg <= kVertical_deg + kBias_deg;
    case Kind::kIndex:
      return selector.index == index;
    default:
      return selector.kind == QuadrantOf(d);
  }
}

/// The first successor that takes the face; -1: none, or NIL.
int SuccessorOf(const Action& action, const Direction& direction, int index) {
  for (size_t i = 0; i < action.successors.size(); ++i) {
    const Successor& s = action.successors[i];
    if (!Matches(std::get<Selector>(s.key), direction, index)) continue;
    return s.symbol == kNil ? -1 : static_cast<int>(i);
  }
  return -1;
}

Result<std::vector<Product>> ApplyComp(const Item& item, const Action& action) {
  std::vector<Item> faces = FacesOf(item);
  std::vector<Product> products;
  products.reserve(faces.size());
  for (size_t i = 0; i < faces.size(); ++i) {
    const Direction direction = DirectionOf(faces[i].facing, item.scope);
    const int successor = SuccessorOf(action, direction, static_cast<int>(i));
    if (successor >= 0) products.push_back({std::move(faces[i]), successor});
  }
  return products;
}

constexpr std::array<std::string_view, 1> kComponents = {"f"};
constexpr std::array<Kind, 11> kSelectors = {
    Kind::kAll,    Kind::kFront, Kind::kBack,     Kind::kLeft,       Kind::kRight, Kind::kTop,
    Kind::kBottom, Kind::kSide,  Kind::kVertical, Kind::kHorizontal, Kind::kIndex};

const std::array<Parameter, 1> kParameters = {{{
    .name = "component",
    .kind = ParameterKind::kWord,
    .default_value = std::string("f"),
    .doc = "what to split into: f, faces",
    .words = kComponents,
}}};

}  // namespace

constinit const Operation kComp = {
    .name = "comp",
    .word = "Comp",
    .doc =
        "Takes a volume apart into its faces; each goes to the first selector that fits it, in "
        "the volume's scope: front is z, right is x, top is y.",
    .source = "Müller et al. 2006; Jesus 2018, 6.5.4",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = Types(ItemType::kVolume),
    .gives = Types(ItemType::kPlanar),
    .in_place = false,
    .apply = ApplyComp,
};

}  // namespace parti::grammar
