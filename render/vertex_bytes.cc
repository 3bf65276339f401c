#include "render/vertex_bytes.h"

#include <algorithm>
#include <cmath>

namespace parti::render {
namespace {

uint8_t Byte(float channel) {
  if (!(channel > 0)) return 0;  // NaN too
  return static_cast<uint8_t>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255.0f));
}

}  // namespace

Bytes4 ColorBytes(const Vec4f& c) { return {Byte(c.r), Byte(c.g), Byte(c.b), Byte(c.a)}; }

std::array<int8_t, 4> DirectionBytes(const Vec3f& d) {
  const auto part = [](float v) {
    return static_cast<int8_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * 127.0f));
  };
  if (!std::isfinite(d.x + d.y + d.z)) return {};
  return {part(d.x), part(d.y), part(d.z), 0};
}

Bytes4 IdBytes(uint32_t id) {
  return {static_cast<uint8_t>(id), static_cast<uint8_t>(id >> 8), static_cast<uint8_t>(id >> 16),
          static_cast<uint8_t>(id >> 24)};
}

}  // namespace parti::render
