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
