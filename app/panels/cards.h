// Where cards come up beside what they are about, clear of the hand and of handles: pure functions.
// What is on them is suggestions.h's, queries.h's and element_bar.h's.
#pragma once

#include <optional>
#include <vector>

#include "app/panels/box.h"

namespace parti::app::panels {

/// What the place of cards depends on.
struct CardNeeds {
  Box stroke;  ///< or a tap, or an element: what they stand beside
  float width = 0, height = 0;
  Box room;
  std::optional<Vec2> pen_px = {};
  bool left_handed = false;
  double scale = 1;
  std::vector<Box> clear_of = {};  ///< what they leave clear where they can: handles, other cards
};

/// Outside the stroke and clear of the hand, which lies below the pen on the side of the drawing
/// hand; above or below it, or in a corner, where there's no room beside. Where nothing is clear of
/// all that it should be, of as many things as can be had; where not even of the hand, farthest
/// from the pen. Within the room where they fit at all.
Box CardsBeside(const CardNeeds& needs);

/// Cards that stay where they came up: they don't run away from the pen that is on its way to them.
struct StandingCards {
  CardNeeds needs;
  Box at;

  /// As CardsBeside; where it was before, as long as all but the pen is as it was, and while only
  /// clear_of is another, as long as nothing of that lies under it.
  Box Stand(const CardNeeds& now);
};

/// What a hand covers that holds a pen at a place.
Box HandAt(const Vec2& pen_px, bool left_handed, double scale);

}  // namespace parti::app::panels
