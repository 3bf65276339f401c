// Rectangles of a layout, and cutting them up: how every panel places what it shows.
// Pixels of the view as floats; damage and clips are render::PixelRect.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/math.h"

namespace parti::app::panels {

/// [x0, x1] by [y0, y1], px, y down. A cut takes what it can where there is less than asked for.
struct Box {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool operator==(const Box&) const = default;
  float width() const { return x1 - x0; }
  float height() const { return y1 - y0; }
  float middle_x() const { return (x0 + x1) / 2; }
  float middle_y() const { return (y0 + y1) / 2; }

  /// The strip cut off at a side; this keeps the rest, less a gap.
  Box CutTop(float size, float gap = 0) {
    const Box cut{x0, y0, x1, std::min(y1, y0 + size)};
    y0 = std::min(y1, cut.y1 + gap);
    return cut;
  }
  /// As CutTop, at the other sides.
  Box CutBottom(float size, float gap = 0) {
    const Box cut{x0, std::max(y0, y1 - size), x1, y1};
    y1 = std::max(y0, cut.y0 - gap);
    return cut;
  }
  /// From the left.
  Box CutLeft(float size, float gap = 0) {
    const Box cut{x0, y0, std::min(x1, x0 + size), y1};
    x0 = std::min(x1, cut.x1 + gap);
    return cut;
  }
  /// From the right.
  Box CutRight(float size, float gap = 0) {
    const Box cut{std::max(x0, x1 - size), y0, x1, y1};
    x1 = std::max(x0, cut.x0 - gap);
    return cut;
  }

  Box Inset(float x, float y) const { return {x0 + x, y0 + y, x1 - x, y1 - y}; }
  Box Inset(float d) const { return Inset(d, d); }
  Box Moved(float x, float y) const { return {x0 + x, y0 + y, x1 + x, y1 + y}; }
  bool Contains(const Vec2& p) const { return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1; }
  /// Edges that only touch don't count.
  bool Overlaps(const Box& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
  /// 0 inside.
  float DistanceTo(const Vec2& p) const {
    const double dx = std::max({x0 - p.x, 0.0, p.x - x1});
    const double dy = std::max({y0 - p.y, 0.0, p.y - y1});
    return static_cast<float>(std::hypot(dx, dy));
  }
};

/// A box of this size at a corner.
inline Box BoxAt(float x, float y, float width, float height) {
  return {x, y, x + width, y + height};
}

/// The box moved, by no more than it needs, to lie within `room`; at its top left where it is
/// larger.
inline Box Within(const Box& box, const Box& room) {
  const float x = std::max(room.x0, std::min(box.x0, room.x1 - box.width()));
  const float y = std::max(room.y0, std::min(box.y0, room.y1 - box.height()));
  return BoxAt(x, y, box.width(), box.height());
}

}  // namespace parti::app::panels
