// How fingers, wheels and keys move the camera: pure functions from one camera to the next.
// Not responsible for gestures (input/gestures.h) or for choosing the point that is touched in a
// model (that is picking's); views that fit a model are auto_view's.
#pragma once

#include <optional>

#include "base/camera.h"

namespace parti::app {

/// How far and how near cameras go, and how fast they turn.
struct CameraLimits {
  double orbit_deg_per_view = 180;  ///< turned by a drag over the view's height, [45, 720]
  double steepest_deg = 88;         ///< of the view, up or down, [45, 89]: nothing tips over
  double lowest_m = 0.1;            ///< of the eye above the ground, [0, 10]
  double nearest_m = 0.2;           ///< from the eye to what is zoomed to, [0.01, 10]
  double farthest_m = 1e6;          ///< the same, and of every coordinate of the eye, [1e3, 1e9]
};

/// Turns the camera about a point, as if the finger rolled the scene: to the right, the scene turns
/// to the right; down, and more is seen from above.
///
/// camera, pivot  valid; the pivot within 1e6 m.  delta_px  how far the finger has gone.
/// returns  a valid camera with a level horizon: up is (0, 1, 0). It turns no further than the
///          limits: not over the top, and the eye not under the ground (or, where it was there,
///          no deeper). A number that is not finite leaves the camera as it was.
/// Properties  (1) distances of eye and target from the pivot stay (to 1e-9 of them);
///             (2) the pivot stays at its pixel, if the camera was level;
///             (3) the limits hold whatever the deltas, and the result is valid.
Camera OrbitAbout(const Camera& camera, const Vec3& pivot, const Vec2& delta_px,
                  const CameraLimits& limits = {});

/// Moves the camera, without turning it, so that a point comes to a pixel, `scale` times as large:
/// what was touched stays under the fingers.
///
/// camera  valid.  point  in front of the eye, as PointUnder gives it.  scale  > 0.
/// returns  a valid camera whose target lies as deep as the point. At the limits the point slips
///          from under the fingers: the eye gets no nearer to it, no farther away, no lower. A
///          number that is not finite, or a point behind the eye, leaves the camera as it was.
/// Properties  (1) Project(point) == to_px and pixels per metre there are `scale` times as many,
///                 within the limits;
///             (2) the view's direction stays;
///             (3) the limits hold, and the result is valid.
Camera PanZoom(const Camera& camera, const Vec3& point, const Vec2& to_px, double scale,
               const CameraLimits& limits = {});

/// Nearer to (factor > 1) or farther from the point under a pixel, which stays there: the wheel.
Camera ZoomTowards(const Camera& camera, const Vec2& pixel, double factor,
                   const CameraLimits& limits = {});

/// What is touched at a pixel: where its ray meets `surface` (the face that was hit), else the
/// ground, else (looking at the sky, or at the ground farther than kFarTouch times the eye's
/// distance to the target) the plane across the view through the target. Always in front of the
/// eye.
Vec3 PointUnder(const Camera& camera, const Vec2& pixel, const std::optional<Plane>& surface = {});

inline constexpr double kFarTouch = 20;

}  // namespace parti::app
