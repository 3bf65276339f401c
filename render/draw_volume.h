// The part of the world that a tile of a picture shows, for leaving out what lies beside it.
// Exact visibility is the depth buffer's.
#pragma once

#include "render/bounds.h"

namespace parti::render {

/// What projects between `low` and `high` in clip coordinates divided by w.
struct DrawVolume {
  glm::mat4 clip_from_world{1};
  Vec2f low{-1, -1};
  Vec2f high{1, 1};
  Vec3 eye{0, 0, 0};

  /// False only where no point of the box can be seen; empty boxes count as everywhere.
  bool Touches(const Bounds& box) const;
  /// From the eye to the nearest point of the box; 0 inside and for empty ones. [m]
  double DistanceTo(const Bounds& box) const;
};

}  // namespace parti::render
