// deleteHoles(): faces without their holes.
#include <utility>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

/// The walls of what went through a volume stay inside it, which is no longer closed then.
void FillMesh(Item* item) {
  Mesh mesh = *item->mesh;
  bool has_changed = false;
  for (MeshFace& face : mesh.faces) {
    has_changed = has_changed || !face.holes.empty();
    face.holes.clear();
  }
  if (!has_changed) return;
  mesh.closed = IsClosed(mesh);
  item->mesh = std::make_shared<const Mesh>(std::move(mesh));
}

Result<std::vector<Product>> ApplyDeleteHoles(const Item& item, const Action&) {
  Item filled = item;
  if (item.polygon && !item.polygon->holes.empty()) {
    filled.polygon = std::make_shared<const Polygon>(Polygon{item.polygon->outer, {}});
  }
  if (item.mesh) FillMesh(&filled);
  return std::vector<Product>{{std::move(filled), -1}};
}

}  // namespace

constinit const Operation kDeleteHoles = {
    .name = "deleteHoles",
    .word = "DeleteHoles",
    .doc =
        "Closes the holes in the faces of a shape. Before an extrusion a courtyard is filled by "
        "it; after one the courtyard's walls stay, inside.",
    .source = "CGA",
    .parameters = {},
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyDeleteHoles,
};

}  // namespace parti::grammar
