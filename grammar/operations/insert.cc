// i(file): an asset in the scope of a shape.
// Reading the file is the library's (asset_library.h); the action brings what it read.
#include <fmt/format.h>

#include <array>
#include <utility>

#include "grammar/asset.h"
#include "grammar/item_place.h"
#include "grammar/operations/insertion.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kYUp = "yUp", kZUp = "zUp";
constexpr std::string_view kFit = "alignSizeAndPosition", kKeep = "keepSizeAndPosition",
                           kKeepSize = "keepSizeAlignPosition";

/// An asset whose z is up, turned so that its y is: (x, y, z) to (x, z, -y).
Insertion TurnedUp(const Insertion& in) {
  Insertion turned{Vec3(in.low.x, in.low.z, -in.low.y - in.size.y),
                   Vec3(in.size.x, in.size.z, in.size.y), nullptr};
  Mesh mesh = *in.mesh;
  const double depth = in.size.y > 0 ? 1 : 0;
  for (Vec3& p : mesh.points) p = Vec3(p.x, p.z, depth - p.y);
  for (Paint& paint : mesh.paints) {
    if (!paint.map) continue;
    for (Vec3* g : {&paint.map->u, &paint.map->v}) *g = Vec3(g->x, g->z, -g->y);
    paint.map->offset -= Vec2(paint.map->u.z, paint.map->v.z) * depth;
  }
  turned.mesh = std::make_shared<const Mesh>(std::move(mesh));
  return turned;
}

Result<std::vector<Product>> ApplyInsert(const Item& item, const Action& action) {
  const auto& file = std::get<std::string>(action.arguments[0]);
  if (file.empty()) return std::vector<Product>{{item, -1}};
  if (!action.asset) {
    return Fail(ErrorCode::kFile, fmt::format("'{}' was not read", file),
                "insert assets where files may be read");
  }
  if (!action.asset->mesh) {
    return Fail(ErrorCode::kFile, fmt::format("'{}' is an image, not a body", file),
                "i inserts .obj, .gltf and .glb; wear images with texture");
  }
  Insertion in{action.asset->low, action.asset->size, action.asset->mesh};
  if (std::get<std::string>(action.arguments[1]) == kZUp) in = TurnedUp(in);
  const auto& mode = std::get<std::string>(action.arguments[2]);
  Scope scope = NamedScope(item);
  if (mode == kKeepSize) {
    scope = StoodIn(scope, in.size);
  } else {
    if (mode == kKeep) scope.size = Vec3(0, 0, 0);
    scope = FittedTo(scope, in);
  }
  return std::vector<Product>{{Inserted(item, scope, std::move(in.mesh)), -1}};
}

constexpr std::array<std::string_view, 2> kUps = {kYUp, kZUp};
constexpr std::array<std::string_view, 3> kModes = {kFit, kKeep, kKeepSize};

const std::array<Parameter, 3> kParameters = {
    Parameter{.name = "file",
              .kind = ParameterKind::kText,
              .default_value = std::string("window.obj"),
              .doc =
                  "an .obj, .gltf or .glb beside the rules, or in a folder above; builtin:cube and "
                  "builtin:cube:notex are a cube"},
    Parameter{.name = "upAxisOfGeometry",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kYUp),
              .required = false,
              .doc = "which axis of the file is up",
              .words = kUps},
    Parameter{.name = "insertMode",
              .kind = ParameterKind::kWord,
              .default_value = std::string(kFit),
              .required = false,
              .doc = "fit to the scope, or as large as it is: where it is, or in the middle of the "
                     "scope's floor",
              .words = kModes}};

}  // namespace

constinit const Operation kInsert = {
    .name = "i",
    .word = "Insert",
    .doc =
        "Inserts an asset and fits it to the scope; sizes of 0 follow from the others in its own "
        "proportions.",
    .source = "CGA; Jesus 2018, 4.2",
    .parameters = kParameters,
    .takes = kMovable,
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .sampled = false,
    .file = 0,
    .apply = ApplyInsert,
};

}  // namespace parti::grammar
