// Where a pen on a tablet is in the view: millimetres to pixels with the tablet's aspect kept, so
// that a circle drawn is a circle seen. The view is covered whole; what is left of the longer side
// of the tablet lies outside, evenly on both edges. On screens what is touched is under the tip.
#pragma once

#include <optional>
#include <span>

#include "base/camera.h"
#include "base/event.h"
#include "base/stroke.h"
#include "input/strokes_from_events.h"

namespace parti::app {

/// Part of the view [px], from its top left corner.
struct ViewRect {
  Vec2 origin_px{0, 0};
  Vec2 size_px{0, 0};  ///< > 0 in both

  bool operator==(const ViewRect&) const = default;
};

/// How one user and one desk want a tablet.
struct MappingOptions {
  /// The tablet lies turned by 180 degrees, its buttons under the other hand. Says nothing for
  /// display tablets and for devices that point into the view, whose picture does not turn.
  bool left_handed = false;
  /// Where the pictures of display tablets and touch screens lie in the view: their surface is that
  /// rectangle, corner to corner, so that ink is under the tip. Absent: the whole view, where it
  /// has nearly their shape. Says nothing for opaque tablets.
  std::optional<ViewRect> own_output = {};

  bool operator==(const MappingOptions&) const = default;
};

/// A screen that is plugged in.
struct OutputPlace {
  std::optional<Vec2> size_mm = {};      ///< of its picture, where it says so
  std::optional<ViewRect> in_view = {};  ///< where it shows the view; absent: it shows none of it

  bool operator==(const OutputPlace&) const = default;
};

/// Where in the view a device's own screen lies: MappingOptions::own_output.
///
/// A device that is no screen has none. The output of its size is its own (to kSamePart, since
/// screens count centimetres; of two alike the nearer, then the first that shows the view); where
/// sizes are not known, an only one is. Nothing where that is not shown, or not known: then the
/// device is mapped by its shape.
std::optional<ViewRect> OwnOutput(const DeviceFacts& device, std::span<const OutputPlace> outputs);
inline constexpr double kSamePart = 0.06;

/// One device in one view.
class TabletMapping {
 public:
  /// A device that does not say its size (or says none > 0) is taken for kUsualSize_mm. One with
  /// `view_px_per_mm` points into the view: that is its mapping, whatever its size and the options.
  TabletMapping(const DeviceFacts& device, const Camera& camera,
                const MappingOptions& options = {});

  /// Each undoes the other.
  Vec2 ToView_px(const Vec2& tablet_mm) const;
  Vec2 ToTablet_mm(const Vec2& view_px) const;

  /// Of a display tablet the mean of both directions, which are equal but for rounding.
  double px_per_mm() const;

  /// Samples in view pixels; times and pressures unchanged.
  Stroke ToView(const input::PenStroke& stroke) const;

  /// How much a screen's shape may differ from that of the view that it is taken to show, as a
  /// ratio: panels and modes differ by a few pixels, 16:10 and 16:9 by 1.11.
  static constexpr double kSameShape = 1.05;

 private:
  Vec2 px_per_mm_;  ///< to the right and down; negative: turned
  Vec2 origin_px_;  ///< of the tablet's top left corner
};

}  // namespace parti::app
