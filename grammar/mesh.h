// Closed polygonal meshes: what volumes are made of.
// Offsets and triangles are the polygons' business (polygon.h).
#pragma once

#include <cstdint>
#include <vector>

#include "base/error.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// One flat face: its loop counter-clockwise seen from outside, holes clockwise; indices of points.
/// The loop's first edge is the x axis of the face's scope: on upright faces it runs along the
/// bottom.
struct MeshFace {
  std::vector<uint32_t> loop;
  std::vector<std::vector<uint32_t>> holes;

  bool operator==(const MeshFace&) const = default;
};

/// Watertight; coordinates in the scope of the item that holds it; m.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<MeshFace> faces;

  bool operator==(const Mesh&) const = default;
};

/// The polygon drawn out by height_m along +z: bottom, top, then one side per edge, ring by ring.
/// height_m may be negative; faces look outward all the same. height_m != 0.
Mesh Prism(const Polygon& base, double height_m);
Mesh BoxMesh(const Vec3& size);

/// Unit outward normal (Newell's method).
Vec3 Normal(const Mesh& mesh, const MeshFace& face);
/// Enclosed volume [m^3]; positive when the faces look outward.
double Volume(const Mesh& mesh);

/// The part with low <= coordinate <= high along axis, cut faces closed with caps, as one mesh
/// (possibly of several bodies). Empty (no faces) where nothing of positive volume is left.
Mesh Slab(const Mesh& mesh, int axis, double low, double high);

}  // namespace parti::grammar
