#include "grammar/asset_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace parti::grammar {
namespace {

using Corner = AssetMesh::Corner;

/// Corners nearer than this part of the asset's size are one.
constexpr double kWeld = 1e-6;
/// A polygon this part of its size off its plane is none.
constexpr double kFlatness = 1e-4;
/// Texture coordinates this near to a map's are its.
constexpr double kSameUv = 1e-4;

Vec3 NewellNormal(std::span<const Corner> face) {
  Vec3 sum(0, 0, 0);
  for (size_t i = 2; i < face.size(); ++i) {
    sum += glm::cross(face[i - 1].point - face[0].point, face[i].point - face[0].point);
  }
  return sum;
}

double SizeOf(std::span<const Corner> face) {
  double size = 0;
  for (const Corner& c : face) size = std::max(size, glm::distance(c.point, face[0].point));
  return size;
}

/// Every corner turns left: what a fan covers.
bool IsConvex(std::span<const Corner> face, const Vec3& normal) {
  for (size_t i = 0; i < face.size(); ++i) {
    const Vec3 &a = face[i].point, &b = face[(i + 1) % face.size()].point,
               &c = face[(i + 2) % face.size()].point;
    if (glm::dot(glm::cross(b - a, c - b), normal) < 0) return false;
  }
  return true;
}

/// The map of the largest of the triangles at the first corner.
std::optional<TextureMap> MapOf(std::span<const Corner> face) {
  size_t best = 2;
  double largest = -1;
  for (size_t i = 2; i < face.size(); ++i) {
    const double area =
        glm::length(glm::cross(face[i - 1].point - face[0].point, face[i].point - face[0].point));
    if (area <= largest) continue;
    largest = area;
    best = i;
  }
  const Vec3 points[3] = {face[0].point, face[best - 1].point, face[best].point};
  const Vec2 uvs[3] = {face[0].uv, face[best - 1].uv, face[best].uv};
  return MapThrough(points, uvs);
}

bool IsFlat(std::span<const Corner> face, const Vec3& normal) {
  const double size = SizeOf(face);
  return std::all_of(face.begin(), face.end(), [&](const Corner& c) {
    return std::abs(glm::dot(c.point - face[0].point, normal)) <= kFlatness * size;
  });
}

bool HasOneMap(std::span<const Corner> face) {
  const auto map = MapOf(face);
  return map && std::all_of(face.begin(), face.end(), [&](const Corner& c) {
           return glm::distance(map->At(c.point), c.uv) <= kSameUv;
         });
}

/// Seen along its normal; nothing where it crosses itself.
std::optional<Polygon> Outline(std::span<const Corner> face, const Vec3& normal) {
  const Vec3 helper = std::abs(normal.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::normalize(glm::cross(helper, normal)), v = glm::cross(normal, u);
  Ring ring;
  for (const Corner& c : face) ring.emplace_back(glm::dot(c.point, u), glm::dot(c.point, v));
  auto polygon = PolygonFrom({ring});
  if (!polygon || polygon->outer.size() != face.size()) return std::nullopt;
  return Polygon{std::move(ring), {}};
}

/// Triangles of a polygon, three corner numbers each; empty where it may stay whole.
std::vector<uint32_t> Divided(std::span<const Corner> face, bool has_uv) {
  const Vec3 sum = NewellNormal(face);
  const double length = glm::length(sum);
  const Vec3 normal = length > 0 ? sum / length : Vec3(0, 1, 0);
  const bool flat = length > 0 && IsFlat(face, normal);
  const bool convex = flat && IsConvex(face, normal);
  const auto outline = flat && !convex ? Outline(face, normal) : std::nullopt;
  if ((convex || outline) && (!has_uv || HasOneMap(face))) return {};
  if (outline) return Triangulate(*outline);
  std::vector<uint32_t> fan;
  for (uint32_t i = 2; i < face.size(); ++i) fan.insert(fan.end(), {0u, i - 1, i});
  return fan;
}

/// Points that lie together become one.
void WeldPoints(double tolerance, Mesh* mesh) {
  std::map<std::tuple<int64_t, int64_t, int64_t>, uint32_t> found;
  std::vector<Vec3> points;
  std::vector<uint32_t> number(mesh->points.size());
  for (size_t i = 0; i < mesh->points.size(); ++i) {
    const Vec3& p = mesh->points[i];
    const auto cell = [&](double v) { return static_cast<int64_t>(std::llround(v / tolerance)); };
    const auto [at, is_new] =
        found.try_emplace({cell(p.x), cell(p.y), cell(p.z)}, static_cast<uint32_t>(points.size()));
    if (is_new) points.push_back(p);
    number[i] = at->second;
  }
  mesh->points = std::move(points);
  for (MeshFace& face : mesh->faces) {
    for (uint32_t& i : face.loop) i = number[i];
    face.loop.erase(std::unique(face.loop.begin(), face.loop.end()), face.loop.end());
    while (face.loop.size() > 1 && face.loop.front() == face.loop.back()) face.loop.pop_back();
  }
  std::erase_if(mesh->faces, [&](const MeshFace& face) {
    return face.loop.size() < 3 || Normal(*mesh, face) == Vec3(0, 0, 0);
  });
}

}  // namespace

void AssetMesh::Add(const std::vector<Corner>& face,
                    const std::shared_ptr<const Material>& material, bool has_uv) {
  if (face.size() < 3) return;
  const auto triangles = face.size() == 3 ? std::vector<uint32_t>() : Divided(face, has_uv);
  if (triangles.empty()) return AddFace(face, material, has_uv);
  for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
    const std::array corners = {face[triangles[i]], face[triangles[i + 1]], face[triangles[i + 2]]};
    AddFace(corners, material, has_uv);
  }
}

void AssetMesh::AddFace(std::span<const Corner> face,
                        const std::shared_ptr<const Material>& material, bool has_uv) {
  MeshFace made;
  for (const Corner& corner : face) {
    made.loop.push_back(static_cast<uint32_t>(mesh_.points.size()));
    mesh_.points.push_back(corner.point);
  }
  Paint paint{material, has_uv ? MapOf(face) : std::nullopt, std::nullopt};
  if (paint.material || paint.map) made.paint = PaintNumber(paint);
  mesh_.faces.push_back(std::move(made));
}

uint32_t AssetMesh::PaintNumber(const Paint& paint) {
  // Neighbours mostly wear the same.
  if (mesh_.paints.empty() || !(mesh_.paints.back() == paint)) mesh_.paints.push_back(paint);
  return static_cast<uint32_t>(mesh_.paints.size());
}

Result<Asset> AssetMesh::Finish(std::string_view name) {
  const auto nothing = [&] {
    return Fail(ErrorCode::kDamagedFile, fmt::format("{} has no face with an area", name),
                "export the model's meshes, too");
  };
  if (mesh_.points.empty()) return nothing();
  Vec3 low = mesh_.points[0], high = low;
  for (const Vec3& p : mesh_.points) {
    if (!IsFinite(p) || glm::length(p) > kLargestCoordinate_m) {
      return Fail(ErrorCode::kBadNumber,
                  fmt::format("{} has a corner at ({:.6g}, {:.6g}, {:.6g})", name, p.x, p.y, p.z),
                  fmt::format("coordinates are finite, up to {:.0g} m", kLargestCoordinate_m));
    }
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  Asset asset;
  asset.low = low;
  asset.size = high - low;
  const double largest = std::max({asset.size.x, asset.size.y, asset.size.z});
  if (!(largest > 0)) return nothing();
  Vec3 scale(0, 0, 0);
  for (int i = 0; i < 3; ++i) {
    if (asset.size[i] > kWeld * largest) scale[i] = 1 / asset.size[i];
    if (scale[i] == 0) asset.size[i] = 0;
  }
  for (Vec3& p : mesh_.points) p -= low;
  WeldPoints(kWeld * largest, &mesh_);
  if (mesh_.faces.empty()) return nothing();
  for (Paint& paint : mesh_.paints) {
    if (paint.map) paint.map = Rescaled(*paint.map, low, Vec3(1, 1, 1));
  }
  Mesh unit = Rescaled(mesh_, Vec3(0, 0, 0), scale);
  unit.closed = IsClosed(unit);
  asset.mesh = std::make_shared<const Mesh>(std::move(unit));
  return asset;
}

}  // namespace parti::grammar
