// extrude(distance): a planar shape drawn out along its normal to a volume.
#include <array>
#include <cmath>
#include <utility>

#include "grammar/item_make.h"
#include "grammar/mesh_edges.h"
#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// The box over the planar scope from its plane to `distance` along z.
Scope DrawnOut(const Scope& base, double distance) {
  Scope scope = base;
  scope.size.z = std::abs(distance);
  if (distance < 0) scope.origin += base.z * distance;
  return scope;
}

Item Extruded(const Item& base, double distance) {
  const Scope drawn = DrawnOut(base.scope, distance);
  const Standing standing = StandingOf(drawn);
  const Scope scope = StandUp(drawn, standing);
  if (base.polygon) {
    Mesh mesh = Prism(*base.polygon, std::abs(distance));
    for (Vec3& p : mesh.points) p = StandUp(p, drawn.size, standing);
    StartAtBottom(&mesh);
    Item volume = VolumeItem(scope, std::move(mesh), base);
    volume.hollow = distance < 0;
    return volume;
  }
  Item box;
  box.type = ItemType::kVolume;
  box.scope = scope;
  box.facing = base.facing;
  Inherit(base, &box);
  box.hollow = distance < 0;
  return box;
}

Result<std::vector<Product>> ApplyExtrude(const Item& item, const Action& action) {
  const double distance = std::get<double>(action.arguments[0]);
  if (std::abs(distance) <= kLengthTolerance_m) {
    return Fail(ErrorCode::kDegenerateGeometry, "extrude by 0 makes no volume",
                "give a distance other than 0; negative goes inward");
  }
  std::vector<Product> products;
  products.reserve(1);
  products.push_back({Extruded(item, distance), -1});
  return products;
}

const std::array<Parameter, 1> kParameters = {{{
    .name = "distance",
    .kind = ParameterKind::kLength,
    .low = -1e4,
    .high = 1e4,
    .default_value = 3.0,
    .doc = "along the outward normal; negative goes inward and leaves a niche",
}}};

}  // namespace

constinit const Operation kExtrude = {
    .name = "extrude",
    .word = "Extrude",
    .doc = "Draws a planar shape out along its normal to a volume.",
    .source = "Jesus 2018, 4.2",
    .parameters = kParameters,
    .takes = Types(ItemType::kPlanar),
    .gives = Types(ItemType::kVolume),
    .in_place = false,
    .apply = ApplyExtrude,
};

}  // namespace parti::grammar
