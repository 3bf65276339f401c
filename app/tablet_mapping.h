// Where a pen on a tablet is in the view: millimetres to pixels with the tablet's aspect kept, so
// that a circle drawn is a circle seen. The view is covered whole; what is left of the longer side
// of the tablet lies outside, evenly on both edges.
#pragma once

#include "base/camera.h"
#include "base/event.h"
#include "base/stroke.h"
#include "input/strokes_from_events.h"

namespace parti::app {

/// One device in one view.
class TabletMapping {
 public:
  /// size_mm > 0. A device that does not say its size is taken for kUsualSize_mm.
  TabletMapping(const DeviceFacts& device, const Camera& camera);

  /// Each undoes the other.
  Vec2 ToView_px(const Vec2& tablet_mm) const;
  Vec2 ToTablet_mm(const Vec2& view_px) const;
  double px_per_mm() const { return px_per_mm_; }

  /// Samples in view pixels; times and pressures unchanged.
  Stroke ToView(const input::PenStroke& stroke) const;

  static constexpr Vec2 kUsualSize_mm{216, 135};  ///< a medium pen tablet, 16:10

 private:
  double px_per_mm_;
  Vec2 origin_px_;  ///< of the tablet's top left corner
};

}  // namespace parti::app
