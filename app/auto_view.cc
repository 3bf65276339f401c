#include "app/auto_view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parti::app {
namespace {

// Chosen by looking at houses, towers, slabs and lots: mild perspective as in drawings of
// architects, and an eye that sees a roof but does not look down on the building.
constexpr double kFov_deg = 30;
constexpr double kMargin = 0.80;  ///< of the picture that the model may fill
constexpr double kTurn_deg = 32;  ///< from the broader side's front
constexpr double kLow_deg = 15, kHigh_deg = 38;

using Corners = std::array<Vec3, 8>;

Corners CornersOf(const render::Bounds& b) {
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? b.high.x : b.low.x, i & 2 ? b.high.y : b.low.y,
                  i & 4 ? b.high.z : b.low.z};
  }
  return corners;
}

/// Unit vector from the model to the eye.
Vec3 DirectionFor(const Vec3& size) {
  const double turn = size.x >= size.z ? kTurn_deg : 90 - kTurn_deg;
  const double slender = size.y / std::max({size.x, size.z, 1e-9});
  const double elevation = std::clamp(kHigh_deg - 25 * slender, kLow_deg, kHigh_deg);
  const double a = Angle::Degrees(turn).radians(), e = Angle::Degrees(elevation).radians();
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

/// Moves the eye along the view until all corners fit.
void Approach(const Corners& corners, const Vec3& direction, Camera* camera) {
  camera->eye = camera->target + direction;
  const View view(*camera);
  const double half_high = std::tan(camera->vertical_fov.radians() / 2) * kMargin;
  const double half_wide = half_high * camera->width_px / camera->height_px;
  double distance = 0;
  for (const Vec3& corner : corners) {
    const Vec3 d = corner - camera->target;
    const double wide = std::abs(glm::dot(d, view.right())) / half_wide;
    const double high = std::abs(glm::dot(d, view.up())) / half_high;
    distance = std::max(distance, std::max(wide, high) - glm::dot(d, view.forward()));
  }
  camera->eye = camera->target + direction * distance;
}

/// Moves the target so that the model lies in the middle of the picture.
void Centre(const Corners& corners, Camera* camera) {
  const View view(*camera);
  Vec2 low(INFINITY, INFINITY), high = -low;
  for (const Vec3& corner : corners) {
    const Vec2 p = view.Project(corner).value_or(Vec2(camera->width_px, camera->height_px) * 0.5);
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const Vec2 off = (low + high - Vec2(camera->width_px, camera->height_px)) * 0.5;
  const double metres_per_px = 1 / view.PixelsPerMetre(camera->target);
  camera->target += (view.right() * off.x - view.up() * off.y) * metres_per_px;
}

/// Never empty, and never thinner than a centimetre.
render::Bounds Seen(const render::Bounds& bounds) {
  render::Bounds seen = bounds;
  if (seen.empty()) {
    seen.Add({-5, 0, -5});
    seen.Add({5, 0, 5});
  }
  seen.Add(seen.low - Vec3(0.005));
  seen.Add(seen.high + Vec3(0.005));
  return seen;
}

/// All of the bounds from a direction: a unit vector from the model to the eye.
Camera ViewFrom(const Vec3& direction, const render::Bounds& seen, double width_px,
                double height_px) {
  const Corners corners = CornersOf(seen);
  Camera camera;
  camera.width_px = width_px;
  camera.height_px = height_px;
  camera.vertical_fov = Angle::Degrees(kFov_deg);
  camera.target = seen.middle();
  Approach(corners, direction, &camera);
  for (int i = 0; i < 4; ++i) {
    Centre(corners, &camera);
    Approach(corners, direction, &camera);
  }
  return camera;
}

/// From the model to the eye, for the presets in their order but the last.
const std::array<Vec3, kViewPresets.size() - 1> kPresetDirections{
    Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(-1, 0, 0), Vec3(1, 0, 0),
    glm::normalize(Vec3(0, 1, 0.035))};  // 88 degrees: straight down there is no up

}  // namespace

Camera AutoView(const render::Bounds& bounds, double width_px, double height_px) {
  const render::Bounds seen = Seen(bounds);
  return ViewFrom(DirectionFor(seen.high - seen.low), seen, width_px, height_px);
}

std::optional<Camera> PresetView(std::string_view name, const render::Bounds& bounds,
                                 double width_px, double height_px) {
  const auto preset = std::find(kViewPresets.begin(), kViewPresets.end(), name);
  if (preset == kViewPresets.end()) return std::nullopt;
  const auto index = static_cast<size_t>(preset - kViewPresets.begin());
  if (index == kPresetDirections.size()) return AutoView(bounds, width_px, height_px);
  return ViewFrom(kPresetDirections[index], Seen(bounds), width_px, height_px);
}

}  // namespace parti::app
