// What a pen or mouse hovers over: the shape under it, and the corner, edge or face that is meant.
// What lies under a pixel is the picture's knowledge (model_picture.h); marks are overlay.h's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/model_picture.h"
#include "app/overlay.h"
#include "app/snap.h"

namespace parti::app {

/// A value. At and End return whether its marks look different now.
class Hovering {
 public:
  /// scale: of the display.
  bool At(const Vec2& px, const ModelPicture& picture, const Camera& camera, double scale);
  bool End();

  /// "corner of Facade"; "" where nothing is hovered over.
  std::string word() const { return snap_ ? snap_->word : ""; }

  /// Adds what is to be seen of it in a view.
  void AddMarks(const ModelPicture& picture, const View& view,
                std::vector<render::Mark>* marks) const;

  static constexpr double kReach_px = 8;  ///< how near a corner or an edge is meant, at scale 1

 private:
  std::optional<ShapeRef> shape_;
  std::optional<Snap> snap_;
};

}  // namespace parti::app
