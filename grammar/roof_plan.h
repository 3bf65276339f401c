// A roof while it is built: faces over shared points, one per edge of the outline.
// Shared by the sources of roof.h; not for others.
#pragma once

#include <vector>

#include "grammar/polygon_skeleton.h"
#include "grammar/roof.h"

namespace parti::grammar {

/// Rise over run. `furthest_m`: how far the highest point lies from its edges.
/// errors  kBadNumber.
Result<double> SlopeOf(const RoofPitch& pitch, double furthest_m);
double Furthest(const Skeleton& skeleton);

/// Faces[i] rises from edge i of the polygon: loops counter-clockwise from above, edge first. The
/// first points are the polygon's corners, ring by ring.
struct RoofPlan {
  Polygon polygon;
  std::vector<Vec3> points;
  std::vector<std::vector<uint32_t>> faces;
};

/// The skeleton lifted: z = slope * (distance - lowered_m).
RoofPlan Lifted(Skeleton skeleton, double slope, double lowered_m);

/// The mesh of a plan: bottom, then the faces; those in one plane that touch become one, and points
/// that nothing needs are left out.
Mesh MeshOf(const RoofPlan& plan);

/// Bottom: the polygon's rings seen from below, in the numbers of RoofPlan; first edge first.
MeshFace BottomOf(const Polygon& polygon);

}  // namespace parti::grammar
