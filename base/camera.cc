#include "base/camera.h"

#include <cmath>

namespace parti {

Result<void> Validate(const Camera& c) {
  if (!IsFinite(c.eye) || !IsFinite(c.target) || !IsFinite(c.up)) {
    return Fail(ErrorCode::kBadNumber, "the camera has a number that is not finite");
  }
  const Vec3 forward = c.target - c.eye;
  if (glm::length(forward) < 1e-9) {
    return Fail(ErrorCode::kBadNumber, "the camera's eye lies on its target");
  }
  if (glm::length(glm::cross(forward, c.up)) < 1e-9 * glm::length(forward)) {
    return Fail(ErrorCode::kBadNumber, "the camera's up points along its view");
  }
  const double fov = c.vertical_fov.degrees();
  if (!(fov > 0 && fov < 180)) {
    return Fail(ErrorCode::kBadNumber, "the camera's field of view is outside 0 to 180 degrees");
  }
  if (!(c.width_px >= 1 && c.height_px >= 1 && c.width_px <= 1e5 && c.height_px <= 1e5)) {
    return Fail(ErrorCode::kBadNumber, "the camera's picture is outside 1 to 100000 pixels");
  }
  return {};
}

View::View(const Camera& camera) : camera_(camera) {
  forward_ = glm::normalize(camera.target - camera.eye);
  right_ = glm::normalize(glm::cross(forward_, camera.up));
  up_ = glm::cross(right_, forward_);
  focal_px_ = camera.height_px * 0.5 / std::tan(camera.vertical_fov.radians() * 0.5);
}

std::optional<Vec2> View::Project(const Vec3& p) const {
  const Vec3 d = p - camera_.eye;
  const double depth = glm::dot(d, forward_);
  if (!(depth >= kNear)) return std::nullopt;
  return Vec2(camera_.width_px * 0.5 + glm::dot(d, right_) / depth * focal_px_,
              camera_.height_px * 0.5 - glm::dot(d, up_) / depth * focal_px_);
}

Ray View::RayThrough(const Vec2& pixel) const {
  const double x = (pixel.x - camera_.width_px * 0.5) / focal_px_;
  const double y = (camera_.height_px * 0.5 - pixel.y) / focal_px_;
  return {camera_.eye, glm::normalize(forward_ + right_ * x + up_ * y)};
}

std::optional<Segment2> View::Project(const Segment3& segment) const {
  Vec3 a = segment.a, b = segment.b;
  const double da = Depth(a), db = Depth(b);
  if (da < kNear && db < kNear) return std::nullopt;
  // The cut end keeps a margin of one part in 10^9, so that rounding can't put it behind again.
  const double cut = kNear * (1 + 1e-9);
  if (da < kNear) a = a + (b - a) * ((cut - da) / (db - da));
  if (db < kNear) b = b + (a - b) * ((cut - db) / (da - db));
  const auto pa = Project(a), pb = Project(b);
  if (!pa || !pb) return std::nullopt;
  return Segment2{*pa, *pb};
}

double View::PixelsPerMetre(const Vec3& p) const {
  const double depth = Depth(p);
  return depth < kNear ? 0.0 : focal_px_ / depth;
}

Result<Vec3> Intersect(const Ray& ray, const Plane& plane) {
  constexpr double kGrazing = 1.745e-4;  // sin 0.01 deg
  const double slope = glm::dot(ray.direction, plane.normal);
  if (std::abs(slope) < kGrazing) return Fail(ErrorCode::kGrazingView, "the plane is seen edge on");
  const double t = (plane.offset - glm::dot(ray.origin, plane.normal)) / slope;
  if (t <= 0) return Fail(ErrorCode::kBehindEye, "the plane is met behind the eye");
  return ray.origin + ray.direction * t;
}

}  // namespace parti
