// The camera in hand: fingers, drags and the wheel move it at once, on the thread that draws; the
// session is told where it came to rest.
// Not responsible for how it moves (camera_moves.h) or for what lies under a finger (picking.h).
#pragma once

#include <functional>

#include "app/camera_moves.h"
#include "app/hands.h"

namespace parti::app {

/// The point of the model, or else of the ground, that is seen at a pixel.
using TouchedPoint = std::function<Vec3(const Camera& camera, const Vec2& px)>;

/// A value with a function to ask. One gesture at a time moves the camera: others that begin
/// meanwhile say nothing.
class Looking {
 public:
  explicit Looking(const Camera& camera = {}) : camera_(camera) {}

  const Camera& camera() const { return camera_; }
  /// Another view, as from a bookmark, or of another size; ends the gesture that goes on.
  void Set(const Camera& camera);

  /// Each returns whether the camera is another one now. A cancelled gesture takes back what it
  /// did.
  bool Take(const input::OrbitGesture& gesture, const TouchedPoint& touched);
  bool Take(const input::PanZoomGesture& gesture, const TouchedPoint& touched);
  /// Of the acts kOrbit, kPan and kZoom.
  bool Take(const DragAct& drag, const TouchedPoint& touched);
  bool Take(const WheelAct& wheel, const TouchedPoint& touched);

  /// While something is drawn or dragged over the picture, the camera stands still: gestures and
  /// the wheel say nothing, and a gesture that goes on is over.
  void Hold(bool held);
  bool held() const { return held_; }

  /// Whether a gesture or drag goes on: the picture may be coarse.
  bool moving() const { return how_ != How::kNot; }

  /// One notch of a wheel makes things this much larger.
  static constexpr double kWheelFactor = 1.15;
  /// A zooming drag doubles the size over so many pixels.
  static constexpr double kDoubling_px = 200;

 private:
  enum class How : uint8_t { kNot, kOrbit, kPanZoom, kDrag };
  bool Begin(How how, const Vec2& px, const TouchedPoint& touched);
  /// Ends or goes on with the gesture whose camera is now `moved`.
  bool Follow(input::DragPhase phase, const Camera& moved);

  Camera camera_;
  How how_ = How::kNot;
  bool held_ = false;
  Camera from_;  // when the gesture began
  Vec2 from_px_{0, 0};
  Vec3 touched_{0, 0, 0};
};

}  // namespace parti::app
