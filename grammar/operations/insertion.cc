#include "grammar/operations/insertion.h"

#include <algorithm>
#include <utility>

#include "grammar/item_make.h"

namespace parti::grammar {
namespace {

bool HasMaterials(const Mesh& mesh) {
  return std::any_of(mesh.paints.begin(), mesh.paints.end(),
                     [](const Paint& paint) { return paint.material != nullptr; });
}

}  // namespace

Scope FittedTo(const Scope& named, const Insertion& in) {
  double sum = 0;
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    if (named.size[i] <= kLengthTolerance_m || in.size[i] <= kLengthTolerance_m) continue;
    sum += named.size[i] / in.size[i];
    ++count;
  }
  const double scale = count > 0 ? sum / count : 1;
  Scope scope = named;
  for (int i = 0; i < 3; ++i) {
    if (named.size[i] > kLengthTolerance_m) continue;
    scope.size[i] = in.size[i] * scale;
    scope.origin += named.axis(i) * (in.low[i] * scale);
  }
  return scope;
}

Scope StoodIn(const Scope& named, const Vec3& size) {
  Scope scope = named;
  scope.size = size;
  scope.origin += named.x * ((named.size.x - size.x) / 2) + named.z * ((named.size.z - size.z) / 2);
  return scope;
}

Item Inserted(const Item& item, const Scope& scope, std::shared_ptr<const Mesh> mesh) {
  Item volume;
  volume.type = ItemType::kVolume;
  volume.scope = scope;
  volume.facing = item.facing;
  volume.anchor = item.anchor;
  Inherit(item, &volume);
  const bool has_materials = mesh && HasMaterials(*mesh);
  if (has_materials) volume.color_rgb = 0;
  if (item.paint) {
    Paint paint{has_materials ? nullptr : item.paint->material, std::nullopt,
                item.paint->projection};
    volume.paint = std::make_shared<const Paint>(std::move(paint));
  }
  volume.mesh_is_unit = mesh != nullptr;
  volume.mesh = std::move(mesh);
  return volume;
}

}  // namespace parti::grammar
