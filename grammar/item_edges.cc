#include "grammar/item_edges.h"

#include <map>
#include <unordered_map>
#include <utility>

namespace parti::grammar {
namespace {

using Loop = std::vector<uint32_t>;

/// Calls act(face, normal, loop) for every loop of every face that has an area.
template <typename Act>
void ForLoops(const Mesh& mesh, const Act& act) {
  for (const MeshFace& face : mesh.faces) {
    const Vec3 normal = Normal(mesh, face);
    if (normal == Vec3(0, 0, 0)) continue;
    act(normal, face.loop);
    for (const Loop& hole : face.holes) act(normal, hole);
  }
}

/// A planar shape as a mesh of one face.
Mesh FlatMesh(const Item& planar) {
  const Polygon polygon = PolygonOf(planar);
  Mesh mesh;
  mesh.closed = false;
  mesh.faces.emplace_back();
  const auto add = [&](const Ring& ring, Loop* loop) {
    for (const Vec2& p : ring) {
      loop->push_back(static_cast<uint32_t>(mesh.points.size()));
      mesh.points.emplace_back(p.x, p.y, 0);
    }
  };
  add(polygon.outer, &mesh.faces[0].loop);
  for (const Ring& hole : polygon.holes) add(hole, &mesh.faces[0].holes.emplace_back());
  return mesh;
}

Vec3 Turned(const Scope& scope, const Vec3& v) {
  return scope.x * v.x + scope.y * v.y + scope.z * v.z;
}

class EdgeCollector {
 public:
  explicit EdgeCollector(const Mesh& mesh) : mesh_(mesh) {}

  void Add(const Vec3& normal, const Loop& loop) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      if (glm::distance(mesh_.points[a], mesh_.points[b]) <= kLengthTolerance_m) continue;
      const uint64_t key = (uint64_t{std::min(a, b)} << 32) | std::max(a, b);
      const auto [place, is_new] = found_.try_emplace(key, edges_.size());
      if (is_new) {
        edges_.push_back({mesh_.points[a], mesh_.points[b], normal, Vec3(0, 0, 0), 1});
      } else {
        ItemEdge& edge = edges_[place->second];
        if (++edge.faces == 2) edge.other = normal;
      }
    }
  }
  std::vector<ItemEdge> Take() { return std::move(edges_); }

 private:
  const Mesh& mesh_;
  std::unordered_map<uint64_t, size_t> found_;
  std::vector<ItemEdge> edges_;
};

}  // namespace

std::vector<ItemEdge> ItemEdgesOf(const Item& item) {
  const Mesh mesh = item.type == ItemType::kVolume ? MeshOf(item) : FlatMesh(item);
  EdgeCollector collector(mesh);
  ForLoops(mesh, [&](const Vec3& normal, const Loop& loop) { collector.Add(normal, loop); });
  std::vector<ItemEdge> edges = collector.Take();
  for (ItemEdge& edge : edges) {
    edge.a = item.scope.ToWorld(edge.a);
    edge.b = item.scope.ToWorld(edge.b);
    edge.normal = Turned(item.scope, edge.normal);
    edge.other = Turned(item.scope, edge.other);
  }
  return edges;
}

Vec3 OutwardOf(const ItemEdge& edge) {
  return glm::normalize(glm::cross(edge.b - edge.a, edge.normal));
}

std::vector<ItemCorner> ItemCornersOf(const Item& item) {
  const bool is_body = item.type == ItemType::kVolume;
  const Mesh mesh = is_body ? MeshOf(item) : FlatMesh(item);
  std::vector<ItemCorner> corners;
  std::vector<size_t> number(mesh.points.size(), SIZE_MAX);
  std::map<std::pair<uint32_t, uint32_t>, int> uses;
  const auto add = [&](uint32_t point, const Vec3& direction) {
    if (number[point] == SIZE_MAX) {
      number[point] = corners.size();
      corners.push_back({item.scope.ToWorld(mesh.points[point])});
    }
    corners[number[point]].normal += Turned(item.scope, direction);
  };
  ForLoops(mesh, [&](const Vec3& normal, const Loop& loop) {
    for (size_t i = 0; i < loop.size(); ++i) {
      const uint32_t a = loop[i], b = loop[(i + 1) % loop.size()];
      ++uses[std::minmax(a, b)];
      const Vec3 edge = mesh.points[b] - mesh.points[a];
      const Vec3 outward = glm::cross(edge, normal) / std::max(glm::length(edge), 1e-300);
      add(a, is_body ? normal : outward);
      if (!is_body) add(b, outward);
    }
  });
  for (const auto& [edge, count] : uses) {
    if (count > 1) continue;
    corners[number[edge.first]].on_border = corners[number[edge.second]].on_border = true;
  }
  for (ItemCorner& corner : corners) {
    const double length = glm::length(corner.normal);
    corner.normal = length > 1e-9 ? corner.normal / length : Vec3(0, 0, 0);
  }
  return corners;
}

}  // namespace parti::grammar
