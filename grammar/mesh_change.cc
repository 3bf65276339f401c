// Meshes as a whole: whether they close, moved and scaled, mirrored.
#include <algorithm>
#include <cstdint>
#include <utility>

#include "grammar/mesh.h"

namespace parti::grammar {
namespace {

using Loop = std::vector<uint32_t>;
using DirectedEdge = std::pair<uint32_t, uint32_t>;

void AddEdges(const Loop& loop, std::vector<DirectedEdge>* edges) {
  for (size_t i = 0; i < loop.size(); ++i) {
    edges->emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  }
}

/// Runs the loop the other way round, its first edge still first.
void Reverse(Loop* loop) {
  std::reverse(loop->begin(), loop->end());
  std::rotate(loop->begin(), loop->end() - 2, loop->end());
}

}  // namespace

bool IsClosed(const Mesh& mesh) {
  std::vector<DirectedEdge> edges;
  for (const MeshFace& face : mesh.faces) {
    AddEdges(face.loop, &edges);
    for (const Loop& hole : face.holes) AddEdges(hole, &edges);
  }
  std::sort(edges.begin(), edges.end());
  const auto count = [&](const DirectedEdge& edge) {
    const auto [first, last] = std::equal_range(edges.begin(), edges.end(), edge);
    return last - first;
  };
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&](const DirectedEdge& edge) {
    return count(edge) == count({edge.second, edge.first});
  });
}

Mesh Rescaled(const Mesh& mesh, const Vec3& low, const Vec3& scale) {
  Mesh result = mesh;
  for (Vec3& p : result.points) p = (p - low) * scale;
  for (Paint& paint : result.paints) {
    if (paint.map) paint.map = Rescaled(*paint.map, low, scale);
  }
  return result;
}

Mesh Mirrored(const Mesh& mesh, const Vec3& size, const bool (&flip)[3]) {
  Mesh result = mesh;
  for (Vec3& p : result.points) {
    for (int i = 0; i < 3; ++i) {
      if (flip[i]) p[i] = size[i] - p[i];
    }
  }
  for (Paint& paint : result.paints) {
    if (paint.map) paint.map = Mirrored(*paint.map, size, flip);
  }
  const bool turns_inside_out = (flip[0] != flip[1]) != flip[2];
  if (!turns_inside_out) return result;
  for (MeshFace& face : result.faces) {
    Reverse(&face.loop);
    for (Loop& hole : face.holes) Reverse(&hole);
  }
  return result;
}

}  // namespace parti::grammar
