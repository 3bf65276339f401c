// The surface of an item by what it wears: for exports and pictures.
// Bare triangles without materials are TrianglesOf (item.h).
#pragma once

#include <memory>
#include <vector>

#include "grammar/item.h"

namespace parti::grammar {

/// The faces of an item that look alike.
struct SurfacePart {
  std::shared_ptr<const Material> material;  ///< null: plain
  uint32_t color_rgb = 0;                    ///< the item's, else the material's; 0: none given
  std::vector<Vec3> corners;  ///< triangles in the world, outward winding, three corners each
  std::vector<Vec2> uvs;      ///< one a corner; none where there are no texture coordinates
};

/// All triangles of the item, in parts in the order of their first faces; one part where nothing is
/// painted. A face that looks along its texture (the sides of an extruded picture) is mapped in its
/// own plane instead, as large.
std::vector<SurfacePart> SurfaceOf(const Item& item);

/// A body that is never seen from inside.
bool IsClosedBody(const Item& item);

}  // namespace parti::grammar
