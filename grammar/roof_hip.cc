// Hip roofs, and the overhang of their eaves.
#include <cmath>
#include <utility>

#include "grammar/roof_plan.h"

namespace parti::grammar {

Result<Mesh> HipRoof(const Polygon& polygon, const RoofPitch& pitch, double overhang_m) {
  auto skeleton = StraightSkeleton(polygon);
  if (!skeleton) return Fail(skeleton);
  const auto slope = SlopeOf(pitch, Furthest(*skeleton));
  if (!slope) return Fail(slope);
  if (!(overhang_m > 0)) return MeshOf(Lifted(std::move(*skeleton), *slope, 0));
  // The planes go on outward: they are those of the larger outline, let down.
  const double outward = overhang_m / std::sqrt(1 + *slope * *slope);
  const auto grown = Offset(polygon, -outward);
  if (!grown) return Fail(grown);
  skeleton = StraightSkeleton(grown->front());
  if (!skeleton) return Fail(skeleton);
  return MeshOf(Lifted(std::move(*skeleton), *slope, outward));
}

}  // namespace parti::grammar
