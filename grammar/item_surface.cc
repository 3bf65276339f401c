#include "grammar/item_surface.h"

#include <algorithm>
#include <cmath>

namespace parti::grammar {
namespace {

/// A map that shrinks areas of a face below this part of what it does to faces across it smears.
constexpr double kSmeared = 1e-3;

/// Metres of the face's own plane, as large as `map` draws its image.
TextureMap OwnMap(const Item& face, const TextureMap& map) {
  const double u = glm::length(map.u), v = glm::length(map.v);
  TextureMap own;
  own.u = face.scope.x * (u > 0 ? u : 1.0);
  own.v = face.scope.y * (v > 0 ? v : 1.0);
  own.offset = -Vec2(glm::dot(own.u, face.scope.origin), glm::dot(own.v, face.scope.origin));
  return own;
}

TextureMap MapOf(const Item& face) {
  if (!face.paint->map) return OwnMap(face, {});
  const TextureMap& map = *face.paint->map;
  const double whole = glm::length(map.u) * glm::length(map.v);
  const double seen = std::abs(glm::dot(glm::cross(map.u, map.v), face.scope.z));
  return seen > kSmeared * whole ? map : OwnMap(face, map);
}

bool HasTexture(const Item& face) {
  return face.paint && (face.paint->map || (face.paint->material && face.paint->material->image));
}

SurfacePart& PartFor(const Item& face, std::vector<SurfacePart>* parts) {
  const auto material = face.paint ? face.paint->material : nullptr;
  const bool textured = HasTexture(face);
  const auto found = std::find_if(parts->begin(), parts->end(), [&](const SurfacePart& part) {
    return part.material == material && part.uvs.empty() != textured;
  });
  if (found != parts->end()) return *found;
  SurfacePart& part = parts->emplace_back();
  part.material = material;
  part.color_rgb = face.color_rgb || !material ? face.color_rgb : material->color_rgb;
  return part;
}

}  // namespace

std::vector<SurfacePart> SurfaceOf(const Item& item) {
  std::vector<SurfacePart> parts;
  if (!item.paint && (!item.mesh || item.mesh->paints.empty())) {
    parts.emplace_back().color_rgb = item.color_rgb;
    TrianglesOf(item, &parts[0].corners);
    return parts;
  }
  for (const Item& face : FacesOf(item)) {
    SurfacePart& part = PartFor(face, &parts);
    const size_t first = part.corners.size();
    TrianglesOf(face, &part.corners);
    if (!HasTexture(face)) continue;
    const TextureMap map = MapOf(face);
    for (size_t i = first; i < part.corners.size(); ++i) {
      part.uvs.push_back(map.At(part.corners[i]));
    }
  }
  return parts;
}

bool IsClosedBody(const Item& item) {
  return item.type == ItemType::kVolume && (!item.mesh || item.mesh->closed);
}

}  // namespace parti::grammar
