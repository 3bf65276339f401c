// comp(f) { selectors }: the faces, edges or corners of a shape as shapes of their own.
// Which selector takes which is comp_selectors.h's.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "grammar/front_edge.h"
#include "grammar/item_make.h"
#include "grammar/item_place.h"
#include "grammar/operations/comp_selectors.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

using Kind = Selector::Kind;

/// The street's front costs a look at the whole shape, so only where it is asked for.
CompFrame FrameOf(const Item& item, const Action& action) {
  const auto asks = [](const Successor& s) {
    const Kind kind = std::get<Selector>(s.key).kind;
    return kind >= Kind::kStreetFront && kind <= Kind::kStreetSide;
  };
  const bool street = std::any_of(action.successors.begin(), action.successors.end(), asks);
  return {NamedScope(item), street ? FrontOf(item) : Vec3(0, 0, 0)};
}

/// Collects what the selectors take.
class Parts {
 public:
  Parts(const Item& item, const Action& action) : action_(action), frame_(FrameOf(item, action)) {}

  void Add(const Component& component, Item part) {
    const int successor = SuccessorOf(action_, component, frame_);
    if (successor >= 0) products_.push_back({std::move(part), successor});
  }
  void Reserve(size_t count) { products_.reserve(count); }
  std::vector<Product> Take() { return std::move(products_); }

 private:
  const Action& action_;
  CompFrame frame_;
  std::vector<Product> products_;
};

void AddFaces(const Item& item, Parts* parts) {
  std::vector<Item> faces = FacesOf(item);
  parts->Reserve(faces.size());
  int index = 0;
  for (Item& face : faces) {
    const bool is_flat = std::min(face.scope.size.x, face.scope.size.y) <= kLengthTolerance_m;
    if (is_flat) continue;  // of a box without a depth
    face.scope.size.z = 0;
    face.anchor.reset();
    const Component component{face.facing, index++, item.type == ItemType::kPlanar, nullptr};
    parts->Add(component, std::move(face));
  }
}

/// An edge with x along it and y the given direction, as far as it is at right angles to x.
Item EdgeItem(const Item& whole, const ItemEdge& edge, const Vec3& up) {
  Item item;
  item.type = ItemType::kEdge;
  Scope& s = item.scope;
  s.origin = edge.a;
  s.size = Vec3(glm::distance(edge.a, edge.b), 0, 0);
  s.x = (edge.b - edge.a) / s.size.x;
  const Vec3 upright = up - s.x * glm::dot(up, s.x);
  s.y = glm::length(upright) > 1e-9 ? glm::normalize(upright) : edge.normal;
  s.z = glm::cross(s.x, s.y);
  Inherit(whole, &item);
  return item;
}

/// Of a body: each edge once, facing as its faces do on average. Of a planar shape: its outline's,
/// facing outward. y is the mean normal, so z looks outward from a planar shape's edge.
void AddEdges(const Item& item, Parts* parts) {
  const std::vector<ItemEdge> edges = ItemEdgesOf(item);
  int index = 0;
  for (const ItemEdge& edge : edges) {
    const Vec3 mean = edge.normal + edge.other;
    Item part = EdgeItem(item, edge, mean);
    const bool is_flat = item.type == ItemType::kPlanar;
    part.facing = is_flat ? OutwardOf(edge) : part.scope.y;
    const Component component{part.facing, index++, edge.faces == 1, &edge};
    parts->Add(component, std::move(part));
  }
}

/// Every face's edges, those between two faces once for each.
void AddFaceEdges(const Item& item, Parts* parts) {
  int index = 0;
  for (const Item& face : FacesOf(item)) {
    for (const ItemEdge& edge : ItemEdgesOf(face)) {
      Item part = EdgeItem(item, edge, edge.normal);
      part.facing = OutwardOf(edge);
      const Component component{part.facing, index++, false, &edge};
      parts->Add(component, std::move(part));
    }
  }
}

void AddCorners(const Item& item, Parts* parts) {
  const Scope named = NamedScope(item);
  int index = 0;
  for (const ItemCorner& corner : ItemCornersOf(item)) {
    Item part;
    part.type = ItemType::kPoint;
    part.scope = {corner.point, named.x, named.y, named.z, Vec3(0, 0, 0)};
    part.facing = corner.normal;
    Inherit(item, &part);
    const bool known = corner.normal != Vec3(0, 0, 0);
    const Component component{known ? corner.normal : named.y, index++, corner.on_border, nullptr};
    parts->Add(component, std::move(part));
  }
}

constexpr std::string_view kFaces = "f", kEdges = "e", kFaceEdges = "fe", kCorners = "v";

Result<std::vector<Product>> ApplyComp(const Item& item, const Action& action) {
  const auto& component = std::get<std::string>(action.arguments[0]);
  Parts parts(item, action);
  if (component == kFaces) AddFaces(item, &parts);
  if (component == kEdges) AddEdges(item, &parts);
  if (component == kFaceEdges) AddFaceEdges(item, &parts);
  if (component == kCorners) AddCorners(item, &parts);
  return parts.Take();
}

constexpr std::array<std::string_view, 4> kComponents = {kFaces, kEdges, kFaceEdges, kCorners};
constexpr std::array<Kind, 31> kSelectors = {
    Kind::kAll,        Kind::kFront,      Kind::kBack,        Kind::kLeft,       Kind::kRight,
    Kind::kTop,        Kind::kBottom,     Kind::kSide,        Kind::kVertical,   Kind::kHorizontal,
    Kind::kAslant,     Kind::kNutant,     Kind::kIndex,       Kind::kBorder,     Kind::kInside,
    Kind::kEave,       Kind::kHip,        Kind::kValley,      Kind::kRidge,      Kind::kStreetFront,
    Kind::kStreetBack, Kind::kStreetLeft, Kind::kStreetRight, Kind::kStreetSide, Kind::kWorldSouth,
    Kind::kWorldNorth, Kind::kWorldWest,  Kind::kWorldEast,   Kind::kWorldUp,    Kind::kWorldDown,
    Kind::kWorldSide};

const std::array<Parameter, 1> kParameters = {{{
    .name = "component",
    .kind = ParameterKind::kWord,
    .default_value = std::string("f"),
    .doc = "what to split into: faces, edges, the edges of each face, vertices",
    .words = kComponents,
}}};

}  // namespace

constinit const Operation kComp = {
    .name = "comp",
    .word = "Comp",
    .doc =
        "Takes a shape apart into its faces, edges or vertices; each goes to the first selector "
        "that fits it, in the shape's scope: front is z, right is x, top is y.",
    .source = "CGA; Müller et al. 2006; Jesus 2018, 6.5.4",
    .parameters = kParameters,
    .braces = Braces::kSelectors,
    .selectors = kSelectors,
    .takes = kSurfaced,
    .gives = Types(ItemType::kPlanar, ItemType::kEdge, ItemType::kPoint),
    .in_place = false,
    .apply = ApplyComp,
};

}  // namespace parti::grammar
