// Whether a roof, or an offset, is right: closed, upright, flat faces, over all of its outline.
#pragma once

#include <string>
#include <vector>

#include "grammar/mesh.h"
#include "grammar/polygon_crossing.h"
#include "tests/grammar/geometry_support.h"
#include "tests/grammar/polygon_generators.h"

namespace parti::grammar::tests {

/// Faces may leave their planes by this, and areas differ by this share (0.1 %).
inline constexpr double kFlatWithin_m = 1e-4;
inline constexpr double kAreaWithin = 1e-3;

inline Ring ProjectedLoop(const Mesh& mesh, const std::vector<uint32_t>& loop) {
  Ring ring;
  for (const uint32_t i : loop) ring.emplace_back(mesh.points[i].x, mesh.points[i].y);
  return ring;
}

inline double ProjectedArea(const Mesh& mesh, const MeshFace& face) {
  double area = SignedArea(ProjectedLoop(mesh, face.loop));
  for (const auto& hole : face.holes) area += SignedArea(ProjectedLoop(mesh, hole));
  return area;
}

inline double OffPlane(const Mesh& mesh, const MeshFace& face) {
  const Vec3 normal = Normal(mesh, face);
  double furthest = 0;
  for (const uint32_t i : face.loop) {
    const Vec3 d = mesh.points[i] - mesh.points[face.loop[0]];
    furthest = std::max(furthest, std::abs(glm::dot(normal, d)));
  }
  return furthest;
}

/// "" when the mesh is a roof over the whole polygon, else what is wrong. z is up; face 0 is the
/// bottom.
inline std::string WrongWithRoof(const Polygon& polygon, const Mesh& mesh) {
  if (mesh.faces.size() < 3) return "too few faces";
  if (const int open = OpenEdges(mesh)) return std::to_string(open) + " open edges";
  const double whole = Area(polygon), tiny = 1e-6 * whole;
  const double bottom = -ProjectedArea(mesh, mesh.faces[0]);
  if (std::abs(bottom - whole) > kAreaWithin * whole) return "the bottom is another polygon";
  double above = 0;
  for (size_t f = 1; f < mesh.faces.size(); ++f) {
    const double area = ProjectedArea(mesh, mesh.faces[f]);
    if (area < -tiny) return "face " + std::to_string(f) + " hangs over";
    above += std::abs(area);
    const double off = OffPlane(mesh, mesh.faces[f]);
    if (off > kFlatWithin_m)
      return "face " + std::to_string(f) + " bends by " + std::to_string(off);
  }
  if (std::abs(above - whole) > kAreaWithin * whole) return "the projected area differs";
  for (const Vec3& p : mesh.points) {
    if (!IsFinite(p) || p.z < -1e-6) return "a point lies below the eaves";
  }
  return Volume(mesh) > 0 ? "" : "no volume";
}

/// "" when the pieces are the polygon moved inward by distance > 0.
inline std::string WrongWithInset(const Polygon& polygon, const std::vector<Polygon>& pieces,
                                  double distance) {
  double sum = 0;
  for (const Polygon& piece : pieces) {
    if (!(Area(piece) > 0)) return "a piece without area";
    sum += Area(piece);
    for (const Vec2& p : piece.outer) {
      if (!Contains(polygon, p)) return "a corner lies outside";
      if (DistanceToBorder(polygon, p) < distance - kFlatWithin_m) return "a corner is too near";
    }
    std::vector<Ring> rings = piece.holes;
    rings.insert(rings.begin(), piece.outer);
    const auto contact = FindContact(rings, 0);
    if (contact && contact->crosses) return "a piece crosses itself";
  }
  return sum < Area(polygon) ? "" : "the pieces are too large";
}

}  // namespace parti::grammar::tests
