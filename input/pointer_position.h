// Where the mouse pointer is in the view: motions added up, kept within the view's edges.
// Not responsible for drawing it, or for acceleration (libinput's).
#pragma once

#include "base/math.h"

namespace parti::input {

/// Value-typed; all mice of a seat move one pointer. Positions are in the millimetres of PenEvents,
/// at kViewPxPerMm, which is what mice say in DeviceFacts::view_px_per_mm.
class PointerPosition {
 public:
  /// CSS's pixel: 96 to the inch. Any number would do; this one reads as lengths on a screen.
  static constexpr double kViewPxPerMm = 96 / 25.4;

  /// The view's size, > 0, and how many of its pixels one of libinput's is (2 on screens of twice
  /// the usual density). The pointer keeps its place in proportion. Sizes that are not finite or
  /// not > 0 change nothing.
  void SetView(const Vec2& size_px, double scale);

  /// A mouse moved by so many of libinput's pixels.
  void MoveBy(const Vec2& delta);

  /// A device that points at places: a part of the view, [0, 1].
  void MoveTo(const Vec2& part);

  Vec2 position_mm() const { return position_px_ / kViewPxPerMm; }
  const Vec2& size_px() const { return size_px_; }

  bool operator==(const PointerPosition&) const = default;

 private:
  void Place(const Vec2& position_px);

  Vec2 size_px_{1600, 1000};
  double scale_ = 1;
  Vec2 position_px_{800, 500};
};

}  // namespace parti::input
