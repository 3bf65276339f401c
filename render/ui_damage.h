// Where two meshes of panels look different.
// Values only; drawing meshes is UiLayer's.
#pragma once

#include <span>

#include "render/damage.h"
#include "render/ui_mesh.h"

namespace parti::render {

/// A command's triangles without its place in the mesh: equal ones look the same.
struct UiShape {
  UiCommand command;     ///< first_index is 0
  uint64_t content = 0;  ///< a hash of its corners
  PixelRect pixels;      ///< within clip and picture; empty: nothing is seen

  bool operator==(const UiShape&) const = default;
};

/// Of a part of the panels; 1 where there is no number for it.
inline float OpacityOf(uint32_t part, std::span<const float> opacities) {
  return part < opacities.size() ? opacities[part] : 1;
}

/// One for each command. A command with indices or corners that the mesh doesn't have, or with
/// corners that are not finite, shows nothing. O(indices).
std::vector<UiShape> ShapesOf(const UiMesh& mesh, const glm::ivec2& size);

/// The pixels of the commands that are in one alone or have changed their order.
Damage ChangeBetween(const std::vector<UiShape>& before, const std::vector<UiShape>& after,
                     const glm::ivec2& size);

}  // namespace parti::render
