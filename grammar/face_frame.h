// The plane of a mesh's face: how a face in space becomes a polygon, and back.
// Corners off the plane are projected onto it.
#pragma once

#include "grammar/mesh.h"

namespace parti::grammar {

/// In the coordinates of the mesh: origin at the first corner, x along the first edge that has a
/// length, y = normal cross x.
struct FaceFrame {
  Vec3 origin{0, 0, 0};
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 normal{0, 0, 1};

  FaceFrame(const Mesh& mesh, const MeshFace& face);
  /// The face in x and y.
  Polygon PolygonOf(const Mesh& mesh, const MeshFace& face) const;
};

/// False for faces without area: they have no frame.
bool HasFrame(const Mesh& mesh, const MeshFace& face);

}  // namespace parti::grammar
