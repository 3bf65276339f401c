// Prisms, boxes and the measures of meshes.
#include "grammar/mesh.h"

#include <cmath>
#include <utility>

#include "base/check.h"

namespace parti::grammar {
namespace {

uint32_t Index(size_t i) { return static_cast<uint32_t>(i); }

/// Corner numbers of a ring from `first` on; reversed with its first edge still first.
std::vector<uint32_t> Loop(size_t first, size_t count, bool reversed) {
  std::vector<uint32_t> loop(count);
  for (size_t i = 0; i < count; ++i) {
    loop[i] = Index(first + (reversed ? (count + 1 - i) % count : i));
  }
  return loop;
}

void AddSides(size_t first, size_t count, size_t layer, std::vector<MeshFace>* faces) {
  for (size_t i = 0; i < count; ++i) {
    const uint32_t a = Index(first + i), b = Index(first + (i + 1) % count);
    faces->push_back({{a, b, Index(b + layer), Index(a + layer)}, {}});
  }
}

Vec3 LoopNormal(const std::vector<Vec3>& points, const std::vector<uint32_t>& loop) {
  Vec3 sum(0, 0, 0);
  const Vec3& origin = points[loop[0]];
  for (size_t i = 2; i < loop.size(); ++i) {
    sum += glm::cross(points[loop[i - 1]] - origin, points[loop[i]] - origin);
  }
  return sum;
}

double ConeVolume(const std::vector<Vec3>& points, const std::vector<uint32_t>& loop,
                  const Vec3& apex) {
  return glm::dot(LoopNormal(points, loop), points[loop[0]] - apex) / 6;
}

}  // namespace

Mesh Prism(const Polygon& base, double height_m) {
  CHECK(height_m != 0 && base.outer.size() >= 3, "a prism has a base and a height");
  Mesh mesh;
  const auto add_layer = [&](double z) {
    for (const Vec2& p : base.outer) mesh.points.emplace_back(p.x, p.y, z);
    for (const Ring& hole : base.holes) {
      for (const Vec2& p : hole) mesh.points.emplace_back(p.x, p.y, z);
    }
  };
  add_layer(std::min(0.0, height_m));
  const size_t layer = mesh.points.size();
  add_layer(std::max(0.0, height_m));
  MeshFace bottom{Loop(0, base.outer.size(), true), {}};
  MeshFace top{Loop(layer, base.outer.size(), false), {}};
  size_t first = base.outer.size();
  for (const Ring& hole : base.holes) {
    bottom.holes.push_back(Loop(first, hole.size(), true));
    top.holes.push_back(Loop(layer + first, hole.size(), false));
    first += hole.size();
  }
  mesh.faces = {std::move(bottom), std::move(top)};
  AddSides(0, base.outer.size(), layer, &mesh.faces);
  first = base.outer.size();
  for (const Ring& hole : base.holes) {
    AddSides(first, hole.size(), layer, &mesh.faces);
    first += hole.size();
  }
  return mesh;
}

Mesh BoxMesh(const Vec3& size) {
  // y is up: a ring around the foot that starts with the front (+z) edge, and one above it.
  Mesh mesh;
  for (const double y : {0.0, size.y}) {
    mesh.points.emplace_back(0, y, size.z);
    mesh.points.emplace_back(size.x, y, size.z);
    mesh.points.emplace_back(size.x, y, 0);
    mesh.points.emplace_back(0, y, 0);
  }
  mesh.faces = {{Loop(0, 4, true), {}}, {Loop(4, 4, false), {}}};
  AddSides(0, 4, 4, &mesh.faces);
  return mesh;
}

Vec3 Normal(const Mesh& mesh, const MeshFace& face) {
  const Vec3 sum = LoopNormal(mesh.points, face.loop);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Vec3(0, 0, 0);
}

double Volume(const Mesh& mesh) {
  if (mesh.points.empty() || !mesh.closed) return 0;
  double volume = 0;
  for (const MeshFace& face : mesh.faces) {
    volume += ConeVolume(mesh.points, face.loop, mesh.points[0]);
    for (const auto& hole : face.holes) {
      volume += ConeVolume(mesh.points, hole, mesh.points[0]);
    }
  }
  return volume;
}

}  // namespace parti::grammar
