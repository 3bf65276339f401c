// The volumes that queries name: sphere(x,y,z,r), box(x,y,z,w,h,d), cylinder(x,y,z,r,h).
// World coordinates in metres. A box's x,y,z is its minimum corner; w, h, d go along x, y, z. A
// cylinder stands on the middle of its base.
#pragma once

#include "grammar/query.h"
#include "grammar/triangle_distance.h"

namespace parti::grammar {

/// One volume, ready to be asked about many points.
class QueryVolume {
 public:
  /// A filter with a volume that passed CheckFilter.
  explicit QueryVolume(const Filter& filter);

  bool Contains(const Vec3& point) const;  ///< up to kRegionTolerance_m
  /// Whether some point of the triangle is in the volume. Exact.
  bool Meets(const Triangle& triangle) const;
  Vec3 middle() const;

 private:
  enum class Kind : uint8_t { kSphere, kBox, kCylinder };
  Kind kind_;
  Vec3 at_;    ///< centre, minimum corner, middle of the base
  Vec3 size_;  ///< box: its sizes; else (radius, height of a cylinder, 0)
};

}  // namespace parti::grammar
