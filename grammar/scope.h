// A scope: the oriented box in which an item stands and along whose axes it is split.
// Jesus 2018, 4.2. Knows nothing of the geometry in it.
#pragma once

#include "base/math.h"

namespace parti::grammar {

/// Origin at the minimum corner. Axes are orthonormal and right-handed. Sizes >= 0; m.
/// Planar: x along the first edge, z the outward normal, y = z cross x; size.z == 0 unless s() gave
/// it a depth.
/// Volume: the axis nearest to the world's up is y; x keeps its direction (language.md, Scopes);
/// r() turns the axes with the geometry, and what is cut from it keeps them. Edge: x along it, y
/// the mean normal of its faces; sizes 0 but along x. Point: sizes 0.
struct Scope {
  Vec3 origin{0, 0, 0};
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};
  Vec3 size{0, 0, 0};

  /// From the scope's coordinates to the world's, and back; both in metres.
  Vec3 ToWorld(const Vec3& local) const { return origin + x * local.x + y * local.y + z * local.z; }
  Vec3 ToLocal(const Vec3& world) const {
    const Vec3 d = world - origin;
    return Vec3(glm::dot(d, x), glm::dot(d, y), glm::dot(d, z));
  }
  const Vec3& axis(int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

}  // namespace parti::grammar
