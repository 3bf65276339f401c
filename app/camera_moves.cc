#include "app/camera_moves.h"

#include <algorithm>
#include <cmath>

namespace parti::app {
namespace {

const Vec3 kUp(0, 1, 0);

Vec3 Turned(const Vec3& v, const Vec3& axis, double angle) {  // Rodrigues
  return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
         axis * glm::dot(axis, v) * (1 - std::cos(angle));
}

/// The part of `angle`, about the horizontal axis `right`, by which the view may be raised.
double AllowedTilt(const Camera& camera, const Vec3& pivot, const Vec3& right, double angle,
                   const CameraLimits& limits) {
  const double steepest = Angle::Degrees(limits.steepest_deg).radians();
  const Vec3 forward = glm::normalize(camera.target - camera.eye);
  const double pitch = std::asin(std::clamp(forward.y, -1.0, 1.0));
  angle = std::clamp(pitch + angle, -steepest, steepest) - pitch;
  const double lowest_m = std::min(limits.lowest_m, camera.eye.y);
  const auto fits = [&](double turned) {
    return pivot.y + Turned(camera.eye - pivot, right, turned).y >= lowest_m;
  };
  if (fits(angle)) return angle;
  double good = 0, bad = angle;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (good + bad) * 0.5;
    (fits(middle) ? good : bad) = middle;
  }
  return good;
}

/// Horizontal, to the right of the view; also where it looks straight down.
Vec3 LevelRight(const Camera& camera) {
  const Vec3 forward = glm::normalize(camera.target - camera.eye);
  Vec3 right = glm::cross(forward, kUp);
  if (glm::length(right) < 1e-6) right = View(camera).right() * Vec3(1, 0, 1);
  return glm::length(right) < 1e-9 ? Vec3(1, 0, 0) : glm::normalize(right);
}

bool WithinReach(const Vec3& p, const CameraLimits& limits) {
  return IsFinite(p) &&
         std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) <= limits.farthest_m;
}

/// From the eye through a pixel, as far as depth 1.
Vec3 AtDepthOne(const View& view, const Vec2& pixel) {
  const Vec3 direction = view.RayThrough(pixel).direction;
  return direction / glm::dot(direction, view.forward());
}

}  // namespace

Camera OrbitAbout(const Camera& camera, const Vec3& pivot, const Vec2& delta_px,
                  const CameraLimits& limits) {
  if (!IsFinite(delta_px) || !WithinReach(pivot, limits)) return camera;
  const double per_px = Angle::Degrees(limits.orbit_deg_per_view).radians() / camera.height_px;
  const Vec2 angles = delta_px * -per_px;
  Camera moved = camera;
  moved.up = kUp;
  const Vec3 right = LevelRight(camera);
  const double tilt = AllowedTilt(camera, pivot, right, angles.y, limits);
  const double turn = std::remainder(angles.x, 2 * kPi);
  for (Vec3* p : {&moved.eye, &moved.target}) {
    *p = pivot + Turned(Turned(*p - pivot, right, tilt), kUp, turn);
  }
  return WithinReach(moved.eye, limits) && Validate(moved) ? moved : camera;
}

Camera PanZoom(const Camera& camera, const Vec3& point, const Vec2& to_px, double scale,
               const CameraLimits& limits) {
  const View view(camera);
  const double depth = view.Depth(point);
  if (!IsFinite(point) || !IsFinite(to_px) || !std::isfinite(scale) || !(scale > 0)) return camera;
  if (!(depth > View::kNear)) return camera;
  const double new_depth = std::clamp(depth / scale, std::min(depth, limits.nearest_m),
                                      std::max(depth, limits.farthest_m));
  const double lowest_m = std::min(limits.lowest_m, camera.eye.y);
  Camera moved = camera;
  moved.eye = glm::clamp(point - AtDepthOne(view, to_px) * new_depth, Vec3(-limits.farthest_m),
                         Vec3(limits.farthest_m));
  moved.eye.y = std::max(moved.eye.y, lowest_m);
  moved.target = moved.eye + view.forward() * new_depth;
  return Validate(moved) ? moved : camera;
}

Camera ZoomTowards(const Camera& camera, const Vec2& pixel, double factor,
                   const CameraLimits& limits) {
  if (!IsFinite(pixel)) return camera;
  return PanZoom(camera, PointUnder(camera, pixel), pixel, factor, limits);
}

Vec3 PointUnder(const Camera& camera, const Vec2& pixel, const std::optional<Plane>& surface) {
  const View view(camera);
  const Ray ray = view.RayThrough(pixel);
  const double usual_m = glm::length(camera.target - camera.eye);
  if (surface) {
    if (const auto hit = Intersect(ray, *surface)) return *hit;
  }
  if (const auto hit = Intersect(ray, Plane{})) {
    if (glm::distance(*hit, camera.eye) <= kFarTouch * usual_m) return *hit;
  }
  return camera.eye + AtDepthOne(view, pixel) * usual_m;
}

}  // namespace parti::app
