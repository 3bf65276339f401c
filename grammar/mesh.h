// Polygonal meshes: what volumes are made of.
// Offsets and triangles are the polygons' business (polygon.h), files the assets' (asset.h).
#pragma once

#include <cstdint>
#include <vector>

#include "base/error.h"
#include "grammar/material.h"
#include "grammar/polygon.h"

namespace parti::grammar {

/// One flat face: its loop counter-clockwise seen from outside, holes clockwise; indices of points.
/// The loop's first edge is the x axis of the face's scope: on upright faces it runs along the
/// bottom.
struct MeshFace {
  std::vector<uint32_t> loop;
  std::vector<std::vector<uint32_t>> holes;
  uint32_t paint = 0;  ///< 1: the first of Mesh::paints, …; 0: what the item wears

  bool operator==(const MeshFace&) const = default;
};

/// Coordinates in the scope of the item that holds it; m. What operations make is watertight;
/// assets may be open: they have faces and an area but no inside, and are cut without caps.
struct Mesh {
  std::vector<Vec3> points;
  std::vector<MeshFace> faces;
  std::vector<Paint> paints;  ///< of single faces, maps in the mesh's coordinates; usually none
  bool closed = true;         ///< every edge runs as often one way round as the other

  bool operator==(const Mesh&) const = default;
};

/// The polygon drawn out by height_m along +z: bottom, top, then one side per edge, ring by ring.
/// height_m may be negative; faces look outward all the same. height_m != 0.
Mesh Prism(const Polygon& base, double height_m);
Mesh BoxMesh(const Vec3& size);

/// Unit outward normal (Newell's method).
Vec3 Normal(const Mesh& mesh, const MeshFace& face);
/// Enclosed volume [m^3]; positive when the faces look outward; 0 for open meshes.
double Volume(const Mesh& mesh);
/// What Mesh::closed says, counted.
bool IsClosed(const Mesh& mesh);
/// Moved by -low, then scaled (parts of scale not negative), paints with it. Where a part of scale
/// is 0 the mesh lies flat.
Mesh Rescaled(const Mesh& mesh, const Vec3& low, const Vec3& scale);
/// Mirrored in [0, size] along the axes that are true; faces still look outward.
Mesh Mirrored(const Mesh& mesh, const Vec3& size, const bool (&flip)[3]);

/// The part with low <= coordinate <= high along axis, as one mesh (possibly of several bodies);
/// where a closed mesh was cut, caps close it, without paint. Empty (no faces) where nothing of
/// positive volume is left.
Mesh Slab(const Mesh& mesh, int axis, double low, double high);

}  // namespace parti::grammar
