// The perspective view through which strokes are drawn and scenes are seen.
// Moving the camera (orbit, zoom, named views) is the app's; matrices for the GPU are render's.
#pragma once

#include <optional>

#include "base/error.h"
#include "base/math.h"

namespace parti {

/// A right-handed look-at with a perspective (as glm::lookAtRH and glm::perspectiveRH).
struct Camera {
  Vec3 eye{0, 1.6, 10};                     ///< m, as target: every coordinate within 1e12
  Vec3 target{0, 0, 0};                     ///< m, not equal to eye
  Vec3 up{0, 1, 0};                         ///< not parallel to target - eye
  Angle vertical_fov = Angle::Degrees(45);  ///< whole angle, in [0.001, 179.9] degrees
  double width_px = 1600;
  double height_px = 1000;

  bool operator==(const Camera&) const = default;
};

/// errors  kBadNumber  what the field comments forbid: non-finite numbers, eye on target, up along
///         the view, field of view or size out of range.
Result<void> Validate(const Camera& camera);

/// A Camera with its axes worked out: what projecting many points needs. The camera must be valid.
class View {
 public:
  explicit View(const Camera& camera);

  const Camera& camera() const { return camera_; }

  /// The pixel of world point p; nothing for points less than kNear in front of the eye.
  std::optional<Vec2> Project(const Vec3& p) const;

  /// Distance of p from the eye's plane along the view direction [m]; negative behind.
  double Depth(const Vec3& p) const { return glm::dot(p - camera_.eye, forward_); }

  /// The ray from the eye through a pixel (which may lie outside the picture).
  Ray RayThrough(const Vec2& pixel) const;

  /// The part of a segment at least kNear in front of the eye, projected; nothing if there is none.
  std::optional<Segment2> Project(const Segment3& segment) const;

  /// Pixels per metre across the view direction at world point p; 0 behind the eye.
  double PixelsPerMetre(const Vec3& p) const;

  const Vec3& forward() const { return forward_; }
  const Vec3& right() const { return right_; }
  const Vec3& up() const { return up_; }

  static constexpr double kNear = 1e-3;  ///< m

 private:
  /// p from the eye: to the right, up, and depth [m].
  Vec3 FromEye(const Vec3& p) const;
  /// The pixel of such a point; its depth is not 0.
  Vec2 PixelOf(const Vec3& from_eye) const;

  Camera camera_;
  Vec3 forward_, right_, up_;
  double focal_px_;  ///< pixels per unit of slope
};

/// Where a ray meets a plane.
/// errors  kGrazingView  the ray lies within 0.01 deg of the plane;  kBehindEye  they meet behind
///         the ray's origin, or at it.
Result<Vec3> Intersect(const Ray& ray, const Plane& plane);

}  // namespace parti
