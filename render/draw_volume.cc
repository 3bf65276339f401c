#include "render/draw_volume.h"

#include <array>

namespace parti::render {

bool DrawVolume::Touches(const Bounds& box) const {
  if (box.empty()) return true;
  // A box is outside when all its corners lie beyond one and the same side.
  std::array<int, 5> beyond{};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec4f p = clip_from_world * Vec4f(corner & 1 ? box.high.x : box.low.x,
                                            corner & 2 ? box.high.y : box.low.y,
                                            corner & 4 ? box.high.z : box.low.z, 1);
    beyond[0] += p.x < low.x * p.w ? 1 : 0;
    beyond[1] += p.x > high.x * p.w ? 1 : 0;
    beyond[2] += p.y < low.y * p.w ? 1 : 0;
    beyond[3] += p.y > high.y * p.w ? 1 : 0;
    beyond[4] += p.w <= 0 ? 1 : 0;
  }
  for (const int corners : beyond) {
    if (corners == 8) return false;
  }
  return true;
}

double DrawVolume::DistanceTo(const Bounds& box) const {
  if (box.empty()) return 0;
  return glm::distance(eye, glm::clamp(eye, box.low, box.high));
}

}  // namespace parti::render
