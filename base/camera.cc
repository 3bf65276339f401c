#include "base/camera.h"

#include <cmath>

namespace parti {

namespace {

constexpr double kFarthest_m = 1e12;  // keeps squares and differences far from overflow

bool IsNear(const Vec3& v) {
  return IsFinite(v) && std::abs(v.x) <= kFarthest_m && std::abs(v.y) <= kFarthest_m &&
         std::abs(v.z) <= kFarthest_m;
}

}  // namespace

Result<void> Validate(const Camera& c) {
  if (!IsNear(c.eye) || !IsNear(c.target) || !IsNear(c.up)) {
    return Fail(ErrorCode::kBadNumber, "the camera has a number that is not finite or beyond 1e12");
  }
  const Vec3 forward = c.target - c.eye;
  if (glm::length(forward) < 1e-9) {
    return Fail(ErrorCode::kBadNumber, "the camera's eye lies on its target");
  }
  const double lengths = glm::length(forward) * glm::length(c.up);
  if (!(glm::length(glm::cross(forward, c.up)) > 1e-9 * lengths)) {
    return Fail(ErrorCode::kBadNumber, "the camera's up is zero or points along its view");
  }
  const double fov = c.vertical_fov.degrees();
  if (!(fov >= 0.001 && fov <= 179.9)) {
    return Fail(ErrorCode::kBadNumber,
                "the camera's field of view is outside 0.001 to 179.9 degrees");
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

Vec3 View::FromEye(const Vec3& p) const {
  const Vec3 d = p - camera_.eye;
  return Vec3(glm::dot(d, right_), glm::dot(d, up_), glm::dot(d, forward_));
}

Vec2 View::PixelOf(const Vec3& from_eye) const {
  return Vec2(camera_.width_px * 0.5 + from_eye.x / from_eye.z * focal_px_,
              camera_.height_px * 0.5 - from_eye.y / from_eye.z * focal_px_);
}

std::optional<Vec2> View::Project(const Vec3& p) const {
  const Vec3 from_eye = FromEye(p);
  if (!(from_eye.z >= kNear)) return std::nullopt;
  return PixelOf(from_eye);
}

Ray View::RayThrough(const Vec2& pixel) const {
  const double x = (pixel.x - camera_.width_px * 0.5) / focal_px_;
  const double y = (camera_.height_px * 0.5 - pixel.y) / focal_px_;
  return {camera_.eye, glm::normalize(forward_ + right_ * x + up_ * y)};
}

std::optional<Segment2> View::Project(const Segment3& segment) const {
  Vec3 a = FromEye(segment.a), b = FromEye(segment.b);
  if (!(a.z >= kNear || b.z >= kNear)) return std::nullopt;
  // Cut where the depth is kNear; set it so, as rounding may leave it a little less.
  const double t = (kNear - a.z) / (b.z - a.z);
  Vec3& behind = a.z < b.z ? a : b;
  if (behind.z < kNear) {
    behind = a + (b - a) * t;
    behind.z = kNear;
  }
  return Segment2{PixelOf(a), PixelOf(b)};
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
