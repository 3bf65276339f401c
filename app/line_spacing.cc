#include "app/line_spacing.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parti::app {
namespace {

struct Width {
  float width_m = 0, length_m = 0;  ///< of faces; of the sides of their triangles
};

/// Four times the area over the length of all sides: 0.6 a for a square of a, 1 a for a band.
Width WidthOf(const render::Faces& faces) {
  float area_m2 = 0, length_m = 0;
  for (size_t i = 0; i + 2 < faces.corners.size(); i += 3) {
    const render::Vec3f &a = faces.corners[i], &b = faces.corners[i + 1], &c = faces.corners[i + 2];
    area_m2 += 0.5f * glm::length(glm::cross(b - a, c - a));
    length_m += glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, a);
  }
  const float width_m = 4 * area_m2 / length_m;
  return std::isfinite(width_m) && std::isfinite(length_m) ? Width{width_m, length_m} : Width{};
}

}  // namespace

float LineSpacing_m(std::span<const render::Faces> faces) {
  std::vector<Width> widths;
  double all_m = 0, up_to_m = 0;
  for (const render::Faces& group : faces) {
    widths.push_back(WidthOf(group));
    all_m += widths.back().length_m;
  }
  std::sort(widths.begin(), widths.end(),
            [](const Width& a, const Width& b) { return a.width_m < b.width_m; });
  for (const Width& width : widths) {
    up_to_m += width.length_m;
    if (up_to_m >= 0.5 * all_m) return width.width_m;
  }
  return 0;
}

}  // namespace parti::app
