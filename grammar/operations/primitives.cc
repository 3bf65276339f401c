// primitiveCube, Sphere, Cylinder, Cone, Disk, Quad: bodies without a file, fitted as i's are.
#include <array>
#include <cmath>
#include <utility>

#include "grammar/asset.h"
#include "grammar/item_make.h"
#include "grammar/item_place.h"
#include "grammar/operations/insertion.h"
#include "grammar/operations/rows.h"
#include "grammar/primitive_body.h"
#include "grammar/primitive_mesh.h"

namespace parti::grammar {
namespace {

using Products = Result<std::vector<Product>>;
constexpr int kUsualSides = 16;

double Number(const Action& action, size_t i) { return std::get<double>(action.arguments[i]); }
int Count(const Action& action, size_t i) {
  return static_cast<int>(std::lround(Number(action, i)));
}

/// In the scope, or of its own size in the middle of the scope's floor where it has one. Without a
/// mesh it is a box.
Products Made(const Item& item, const Vec3& own_size, std::shared_ptr<const Mesh> mesh) {
  Scope scope = NamedScope(item);
  const Insertion in{Vec3(0, 0, 0), Vec3(1, 1, 1), std::move(mesh)};
  const bool sized = own_size != Vec3(0, 0, 0);
  scope = sized ? StoodIn(scope, own_size) : FittedTo(scope, in);
  return std::vector<Product>{{Inserted(item, scope, in.mesh), -1}};
}

/// What the library keeps of this body; made anew where nobody asked it.
std::shared_ptr<const Mesh> Body(const Action& action) {
  if (action.asset) return action.asset->mesh;
  const auto body = PrimitiveBodyOf(action);
  return body ? MeshOf(*body) : nullptr;
}

Products ApplyCube(const Item& item, const Action& action) {
  return Made(item, Vec3(Number(action, 0), Number(action, 1), Number(action, 2)), nullptr);
}

Products ApplySphere(const Item& item, const Action& action) {
  return Made(item, Vec3(2 * Number(action, 2)), Body(action));
}

Products ApplyRound(const Item& item, const Action& action) {
  const double width = 2 * Number(action, 1);
  return Made(item, Vec3(width, Number(action, 2), width), Body(action));
}

/// The two axes in which something flat lies: the floor, unless the scope stands upright without
/// depth or width.
Scope FlatFrame(const Scope& named, bool sized) {
  Scope flat = named;
  const bool upright = !sized && named.size.y > kLengthTolerance_m;
  if (upright && named.size.z <= kLengthTolerance_m) return flat;
  if (upright && named.size.x <= kLengthTolerance_m) {
    flat.x = -named.z;
    flat.z = named.x;
    flat.origin += named.z * named.size.z;
    flat.size = Vec3(named.size.z, named.size.y, 0);
    return flat;
  }
  flat.y = -named.z;
  flat.z = named.y;
  flat.origin += named.z * named.size.z;
  flat.size = Vec3(named.size.x, named.size.z, 0);
  return flat;
}

/// `outline` in the unit square, stretched to the scope or to its own size.
Products MadeFlat(const Item& item, const Vec2& own_size, Polygon outline) {
  const bool sized = own_size != Vec2(0, 0);
  Scope named = NamedScope(item);
  if (sized) named = StoodIn(named, Vec3(own_size.x, 0, own_size.y));
  Scope flat = FlatFrame(named, sized);
  for (int i = 0; i < 2; ++i) {
    if (flat.size[i] <= kLengthTolerance_m) flat.size[i] = std::max(flat.size[1 - i], 0.0);
    if (flat.size[i] <= kLengthTolerance_m) flat.size[i] = 1;
  }
  for (Vec2& p : outline.outer) p *= Vec2(flat.size.x, flat.size.y);
  Item made = PlanarItem(flat, std::move(outline), item);
  made.anchor = item.anchor;
  return std::vector<Product>{{std::move(made), -1}};
}

Products ApplyQuad(const Item& item, const Action& action) {
  return MadeFlat(item, Vec2(Number(action, 0), Number(action, 1)), Rectangle(Vec2(1, 1)));
}

Products ApplyDisk(const Item& item, const Action& action) {
  return MadeFlat(item, Vec2(2 * Number(action, 1)), {UnitPolygon(Count(action, 0)), {}});
}

constexpr std::string_view kLengthDoc = "in metres; 0: as the scope has it";

Parameter Length(std::string_view name) {
  return {.name = name,
          .kind = ParameterKind::kLength,
          .low = 0,
          .high = 1e6,
          .default_value = 0.0,
          .required = false,
          .doc = kLengthDoc};
}

Parameter Sides(std::string_view name, double least, std::string_view doc) {
  return {.name = name,
          .kind = ParameterKind::kFactor,
          .low = least,
          .high = kMostSides,
          .default_value = double{kUsualSides},
          .required = false,
          .doc = doc};
}

const std::array<Parameter, 3> kCubeParameters = {Length("width"), Length("height"),
                                                  Length("depth")};
const std::array<Parameter, 3> kSphereParameters = {Sides("sides", 3, "how many faces run around"),
                                                    Sides("rings", 2, "how many from pole to pole"),
                                                    Length("radius")};
const std::array<Parameter, 3> kRoundParameters = {Sides("sides", 3, "how many faces run around"),
                                                   Length("radius"), Length("height")};
const std::array<Parameter, 2> kQuadParameters = {Length("width"), Length("length")};
const std::array<Parameter, 2> kDiskParameters = {Sides("nVertices", 3, "how many corners it has"),
                                                  Length("radius")};

constexpr Operation Row(std::string_view name, std::string_view word, std::string_view doc,
                        std::span<const Parameter> parameters, ItemType gives,
                        Products (*apply)(const Item&, const Action&)) {
  return {.name = name,
          .word = word,
          .doc = doc,
          .source = "CGA",
          .parameters = parameters,
          .takes = kMovable,
          .gives = Types(gives),
          .in_place = false,
          .sampled = false,
          .file = -1,
          .apply = apply};
}

}  // namespace

constinit const Operation kCube = Row(
    "primitiveCube", "Cube", "A box in the scope, or of its own size in the middle of its floor.",
    kCubeParameters, ItemType::kVolume, ApplyCube);
constinit const Operation kSphere =
    Row("primitiveSphere", "Sphere", "A sphere, or what the scope's proportions make of it.",
        kSphereParameters, ItemType::kVolume, ApplySphere);
constinit const Operation kCylinder =
    Row("primitiveCylinder", "Cylinder", "An upright cylinder, or a prism of few sides.",
        kRoundParameters, ItemType::kVolume, ApplyRound);
constinit const Operation kCone =
    Row("primitiveCone", "Cone", "An upright cone, or a pyramid of few sides.", kRoundParameters,
        ItemType::kVolume, ApplyRound);
constinit const Operation kQuad =
    Row("primitiveQuad", "Quad", "A rectangle on the floor of the scope, facing up.",
        kQuadParameters, ItemType::kPlanar, ApplyQuad);
constinit const Operation kDisk =
    Row("primitiveDisk", "Disk", "A disk on the floor of the scope, facing up.", kDiskParameters,
        ItemType::kPlanar, ApplyDisk);

std::optional<PrimitiveBody> PrimitiveBodyOf(const Action& action) {
  using Kind = PrimitiveBody::Kind;
  const std::string_view name = action.operation->name;  // the table has rows of its own
  if (name == kSphere.name) {
    return PrimitiveBody{Kind::kSpherical, Count(action, 0), Count(action, 1)};
  }
  if (name == kCylinder.name) return PrimitiveBody{Kind::kCylindrical, Count(action, 0), 0};
  if (name == kCone.name) return PrimitiveBody{Kind::kConical, Count(action, 0), 0};
  return std::nullopt;
}

std::shared_ptr<const Mesh> MeshOf(const PrimitiveBody& body) {
  using Kind = PrimitiveBody::Kind;
  return std::make_shared<const Mesh>(body.kind == Kind::kSpherical
                                          ? UnitSphere(body.sides, body.rings)
                                      : body.kind == Kind::kCylindrical ? UnitCylinder(body.sides)
                                                                        : UnitCone(body.sides));
}

}  // namespace parti::grammar
