// Numbers as vertices hold them: bytes for colours and ids.
// What lies where in a vertex is its stream's owner's.
#pragma once

#include <array>
#include <cstdint>

#include "render/scene.h"

namespace parti::render {

using Bytes4 = std::array<uint8_t, 4>;

/// Channels from [0, 1], rounded; what lies outside is clamped, NaN is 0.
Bytes4 ColorBytes(const Vec4f& color);
/// A unit vector or 0; what isn't finite is 0.
std::array<int8_t, 4> DirectionBytes(const Vec3f& direction);
/// Lowest byte first.
Bytes4 IdBytes(uint32_t id);

}  // namespace parti::render
