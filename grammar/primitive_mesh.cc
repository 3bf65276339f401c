#include "grammar/primitive_mesh.h"

#include <algorithm>
#include <cmath>

namespace parti::grammar {
namespace {

/// Collects faces with the texture of the three corners that come first.
class Builder {
 public:
  Builder(Mesh* mesh, int sides) : mesh_(mesh), sides_(sides) {}

  /// A face of the mantle: corner numbers, their columns around and their heights in the image.
  void Add(std::vector<uint32_t> loop, const int (&columns)[3], const double (&heights)[3]) {
    Vec3 corners[3];
    Vec2 uvs[3];
    for (size_t i = 0; i < 3; ++i) {
      corners[i] = mesh_->points[loop[i]];
      uvs[i] = Vec2(static_cast<double>(columns[i]) / sides_, heights[i]);
    }
    const auto map = MapThrough(corners, uvs);
    mesh_->paints.push_back({nullptr, map, std::nullopt});
    mesh_->faces.push_back({std::move(loop), {}, static_cast<uint32_t>(mesh_->paints.size())});
  }

  /// A lid over corners that run counter-clockwise seen from outside; `up`: the top one.
  void AddLid(std::vector<uint32_t> loop, bool up) {
    const TextureMap map{Vec3(1, 0, 0), Vec3(0, 0, up ? -1 : 1), Vec2(0, up ? 1 : 0)};
    mesh_->paints.push_back({nullptr, map, std::nullopt});
    mesh_->faces.push_back({std::move(loop), {}, static_cast<uint32_t>(mesh_->paints.size())});
  }

 private:
  Mesh* mesh_;
  int sides_;
};

/// A ring of corners at a height, shrunk towards the axis: counter-clockwise seen from above, which
/// is towards -z on the right; the first edge is the front one.
void AddRing(int sides, double height, double scale, Mesh* mesh) {
  for (const Vec2& p : UnitPolygon(sides)) {
    const Vec2 q = Vec2(0.5) + (p - Vec2(0.5)) * scale;
    mesh->points.emplace_back(q.x, height, 1 - q.y);
  }
}

std::vector<uint32_t> RingLoop(int first, int sides, bool reversed) {
  std::vector<uint32_t> loop;
  for (int i = 0; i < sides; ++i) {
    loop.push_back(static_cast<uint32_t>(first + (reversed ? (sides + 1 - i) % sides : i)));
  }
  return loop;
}

uint32_t Number(int i) { return static_cast<uint32_t>(i); }

}  // namespace

Ring UnitPolygon(int sides) {
  Ring ring;
  for (int i = 0; i < sides; ++i) {
    const double angle = (2.0 * i - 1) * kPi / sides - kPi / 2;
    ring.emplace_back(std::cos(angle), std::sin(angle));
  }
  Vec2 low = ring[0], high = ring[0];
  for (const Vec2& p : ring) {
    low = Vec2(std::min(low.x, p.x), std::min(low.y, p.y));
    high = Vec2(std::max(high.x, p.x), std::max(high.y, p.y));
  }
  for (Vec2& p : ring) p = (p - low) / (high - low);
  return ring;
}

Mesh UnitCylinder(int sides) {
  Mesh mesh;
  AddRing(sides, 0, 1, &mesh);
  AddRing(sides, 1, 1, &mesh);
  Builder builder(&mesh, sides);
  builder.AddLid(RingLoop(0, sides, true), false);
  builder.AddLid(RingLoop(sides, sides, false), true);
  for (int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    builder.Add({Number(i), Number(next), Number(sides + next), Number(sides + i)},
                {i, i + 1, i + 1}, {0, 0, 1});
  }
  return mesh;
}

Mesh UnitCone(int sides) {
  Mesh mesh;
  AddRing(sides, 0, 1, &mesh);
  mesh.points.emplace_back(0.5, 1, 0.5);
  Builder builder(&mesh, sides);
  builder.AddLid(RingLoop(0, sides, true), false);
  for (int i = 0; i < sides; ++i) {
    builder.Add({Number(i), Number((i + 1) % sides), Number(sides)}, {i, i + 1, i}, {0, 0, 1});
  }
  return mesh;
}

Mesh UnitSphere(int sides, int rings) {
  Mesh mesh;
  for (int r = 1; r < rings; ++r) {
    const double angle = kPi * r / rings;
    AddRing(sides, (1 - std::cos(angle)) / 2, std::sin(angle), &mesh);
  }
  const int south = (rings - 1) * sides, north = south + 1;
  mesh.points.emplace_back(0.5, 0, 0.5);
  mesh.points.emplace_back(0.5, 1, 0.5);
  Builder builder(&mesh, sides);
  const auto at = [&](int r, int i) { return Number((r - 1) * sides + i % sides); };
  const auto height = [&](int r) { return static_cast<double>(r) / rings; };
  for (int i = 0; i < sides; ++i) {
    builder.Add({at(1, i), Number(south), at(1, i + 1)}, {i, i, i + 1}, {height(1), 0, height(1)});
    for (int r = 1; r + 1 < rings; ++r) {
      builder.Add({at(r, i), at(r, i + 1), at(r + 1, i + 1), at(r + 1, i)}, {i, i + 1, i + 1},
                  {height(r), height(r), height(r + 1)});
    }
    builder.Add({at(rings - 1, i), at(rings - 1, i + 1), Number(north)}, {i, i + 1, i},
                {height(rings - 1), height(rings - 1), 1});
  }
  // An even number of rings has its equator at full width; of others the bounds are drawn out.
  Vec3 low = mesh.points[0], high = low;
  for (const Vec3& p : mesh.points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return Rescaled(mesh, low, Vec3(1, 1, 1) / (high - low));
}

}  // namespace parti::grammar
