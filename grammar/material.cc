#include "grammar/material.h"

namespace parti::grammar {

TextureMap InFrame(const TextureMap& map, const Vec3& origin, const Vec3& x, const Vec3& y,
                   const Vec3& z) {
  TextureMap moved;
  moved.u = x * map.u.x + y * map.u.y + z * map.u.z;
  moved.v = x * map.v.x + y * map.v.y + z * map.v.z;
  moved.offset = map.offset - Vec2(glm::dot(moved.u, origin), glm::dot(moved.v, origin));
  return moved;
}

TextureMap LocalIn(const TextureMap& map, const Vec3& origin, const Vec3& x, const Vec3& y,
                   const Vec3& z) {
  TextureMap local;
  local.u = Vec3(glm::dot(map.u, x), glm::dot(map.u, y), glm::dot(map.u, z));
  local.v = Vec3(glm::dot(map.v, x), glm::dot(map.v, y), glm::dot(map.v, z));
  local.offset = map.At(origin);
  return local;
}

TextureMap Mirrored(const TextureMap& map, const Vec3& size, const bool (&flip)[3]) {
  TextureMap mirrored = map;
  for (int i = 0; i < 3; ++i) {
    if (!flip[i]) continue;
    mirrored.offset += Vec2(map.u[i], map.v[i]) * size[i];
    mirrored.u[i] = -map.u[i];
    mirrored.v[i] = -map.v[i];
  }
  return mirrored;
}

std::optional<TextureMap> MapThrough(const Vec3 (&corners)[3], const Vec2 (&uvs)[3]) {
  // Gradients in the triangle's plane: of those that fit its edges, the ones along it.
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
  const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b);
  const double area = aa * bb - ab * ab;
  if (!(area > 1e-24 * aa * bb)) return std::nullopt;
  const Vec2 d = uvs[1] - uvs[0], e = uvs[2] - uvs[0];
  const auto gradient = [&](double along_a, double along_b) {
    return a * ((along_a * bb - along_b * ab) / area) + b * ((along_b * aa - along_a * ab) / area);
  };
  TextureMap map{gradient(d.x, e.x), gradient(d.y, e.y), Vec2(0, 0)};
  map.offset = uvs[0] - map.At(corners[0]);
  return map;
}

TextureMap Rescaled(const TextureMap& map, const Vec3& low, const Vec3& scale) {
  TextureMap result;
  result.offset = map.At(low);
  for (int i = 0; i < 3; ++i) {
    result.u[i] = scale[i] == 0 ? 0 : map.u[i] / scale[i];
    result.v[i] = scale[i] == 0 ? 0 : map.v[i] / scale[i];
  }
  return result;
}

}  // namespace parti::grammar
