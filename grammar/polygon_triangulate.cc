// Triangles of polygons with holes: a fan where the polygon is strictly convex, else CGAL's
// constrained Delaunay triangulation.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <deque>
#include <utility>

#include "grammar/polygon.h"

namespace parti::grammar {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr uint32_t kNone = UINT32_MAX;

struct Corner {
  uint32_t index = kNone;  ///< kNone: made by CGAL, where constraints cross
};
struct Depth {
  int crossed = -1;  ///< constraints between the face and infinity; -1: not seen yet
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<Depth, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;

/// All corners turn left by more than rounding could undo.
bool IsStrictlyConvex(const Ring& ring) {
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = ring[(i + 1) % n] - ring[i];
    const Vec2 out = ring[(i + 2) % n] - ring[(i + 1) % n];
    if (Cross(in, out) <= 1e-9 * glm::length(in) * glm::length(out)) return false;
  }
  return true;
}

std::vector<uint32_t> Fan(size_t corners) {
  std::vector<uint32_t> triangles;
  triangles.reserve(3 * (corners - 2));
  for (uint32_t i = 2; i < corners; ++i) triangles.insert(triangles.end(), {0, i - 1, i});
  return triangles;
}

void InsertRing(const Ring& ring, uint32_t first, Triangulation* triangulation) {
  std::vector<Triangulation::Vertex_handle> handles;
  for (size_t i = 0; i < ring.size(); ++i) {
    auto handle = triangulation->insert({ring[i].x, ring[i].y});
    if (handle->info().index == kNone) handle->info().index = first + static_cast<uint32_t>(i);
    handles.push_back(handle);
  }
  for (size_t i = 0; i < handles.size(); ++i) {
    const auto a = handles[i], b = handles[(i + 1) % handles.size()];
    if (a != b) triangulation->insert_constraint(a, b);
  }
}

/// Counts for every face how many constraints lie between it and infinity: odd is inside.
void MarkDepths(Triangulation* triangulation) {
  std::deque<std::pair<Triangulation::Face_handle, int>> open = {
      {triangulation->infinite_face(), 0}};
  while (!open.empty()) {
    const auto [face, crossed] = open.front();
    open.pop_front();
    if (face->info().crossed >= 0) continue;
    face->info().crossed = crossed;
    for (int i = 0; i < 3; ++i) {
      const auto next = face->neighbor(i);
      if (next->info().crossed >= 0) continue;
      // Faces on this side of the constraints first, so that each gets its smallest count.
      if (face->is_constrained(i)) {
        open.emplace_back(next, crossed + 1);
      } else {
        open.emplace_front(next, crossed);
      }
    }
  }
}

/// The corner that a vertex stands for. A vertex that CGAL made where constraints cross (rings that
/// touch, off by rounding) stands for its nearest corner.
uint32_t CornerOf(const Triangulation& triangulation, Triangulation::Vertex_handle vertex) {
  if (vertex->info().index != kNone) return vertex->info().index;
  uint32_t nearest = kNone;
  double distance = 0;
  for (const auto& other : triangulation.finite_vertex_handles()) {
    if (other->info().index == kNone) continue;
    const double d = CGAL::squared_distance(vertex->point(), other->point());
    if (nearest != kNone && d >= distance) continue;
    nearest = other->info().index;
    distance = d;
  }
  return nearest;
}

}  // namespace

std::vector<uint32_t> Triangulate(const Polygon& polygon) {
  if (polygon.outer.size() < 3) return {};
  if (polygon.holes.empty() && IsStrictlyConvex(polygon.outer)) return Fan(polygon.outer.size());
  Triangulation triangulation;
  uint32_t first = 0;
  InsertRing(polygon.outer, first, &triangulation);
  first += static_cast<uint32_t>(polygon.outer.size());
  for (const Ring& hole : polygon.holes) {
    InsertRing(hole, first, &triangulation);
    first += static_cast<uint32_t>(hole.size());
  }
  MarkDepths(&triangulation);
  std::vector<uint32_t> triangles;
  for (const auto face : triangulation.finite_face_handles()) {
    if (face->info().crossed % 2 == 0) continue;
    const uint32_t corners[3] = {CornerOf(triangulation, face->vertex(0)),
                                 CornerOf(triangulation, face->vertex(1)),
                                 CornerOf(triangulation, face->vertex(2))};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    triangles.insert(triangles.end(), corners, corners + 3);
  }
  return triangles;
}

}  // namespace parti::grammar
