#include "render/window_icon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace parti::render {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr int kTaps = 4;  ///< a pixel, across and down

double DistanceToSegment(const dvec2& p, const dvec2& a, const dvec2& b) {
  const dvec2 ab = b - a;
  const double t = std::clamp(glm::dot(p - a, ab) / glm::dot(ab, ab), 0.0, 1.0);
  return glm::length(p - (a + t * ab));
}

/// Of a square with round corners; negative inside.
double DistanceToSheet(const dvec2& p) {
  constexpr double kHalf = 0.46, kRound = 0.12;
  const dvec2 d = glm::abs(p - dvec2(0.5)) - dvec2(kHalf - kRound);
  return glm::length(glm::max(d, dvec2(0))) + std::min(std::max(d.x, d.y), 0.0) - kRound;
}

/// Colour (sRGB) and cover of one point of the unit square, y down.
std::pair<dvec3, double> ColorAt(const dvec2& p) {
  // Walls and eaves overshoot their corners, as lines drawn by hand do.
  static constexpr std::array<std::array<double, 4>, 6> kInk = {{{0.27, 0.40, 0.27, 0.78},
                                                                 {0.73, 0.40, 0.73, 0.78},
                                                                 {0.20, 0.76, 0.80, 0.76},
                                                                 {0.17, 0.52, 0.53, 0.20},
                                                                 {0.47, 0.20, 0.83, 0.52},
                                                                 {0.27, 0.46, 0.73, 0.46}}};
  constexpr double kHalfWidth = 0.032;
  constexpr dvec3 kPaper{250, 247, 241}, kLine{42, 58, 84}, kRoof{214, 120, 82};
  if (DistanceToSheet(p) > 0) return {kPaper, 0};
  for (const auto& s : kInk) {
    if (DistanceToSegment(p, {s[0], s[1]}, {s[2], s[3]}) < kHalfWidth) return {kLine, 1};
  }
  const bool in_roof = p.y < 0.46 && p.y > 0.235 + std::abs(p.x - 0.5) * 0.889;
  return {in_roof ? kRoof : kPaper, 1};
}

}  // namespace

Image WindowIcon(int side) {
  Image image{side, side, std::vector<uint8_t>(size_t{4} * side * side)};
  for (int i = 0; i < side * side; ++i) {
    const int x = i % side, y = i / side;
    dvec3 sum{0};
    double cover = 0;
    for (int tap = 0; tap < kTaps * kTaps; ++tap) {
      const int row = tap / kTaps;
      const dvec2 within((tap % kTaps + 0.5) / kTaps, (row + 0.5) / kTaps);
      const auto [color, covers] = ColorAt((dvec2(x, y) + within) / double(side));
      sum += color * covers;
      cover += covers;
    }
    uint8_t* pixel = &image.pixels[size_t{4} * i];
    for (int c = 0; c < 3; ++c) {
      pixel[c] = static_cast<uint8_t>(std::lround(cover > 0 ? sum[c] / cover : 0));
    }
    pixel[3] = static_cast<uint8_t>(std::lround(cover * 255 / (kTaps * kTaps)));
  }
  return image;
}

}  // namespace parti::render
